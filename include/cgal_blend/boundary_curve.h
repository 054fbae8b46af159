// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_BOUNDARY_CURVE_H
#define CGAL_BLEND_BOUNDARY_CURVE_H

#include <cgal_blend/blend_mesh.h>

#include <functional>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace cgal_blend {

/// What a blend has to know of a surface at one point of its boundary curve.
struct Boundary_point {
  Point_3 point;
  Vector_3 derivative;  ///< d point / d s, length units; not 0 on a regular curve
  Vector_3 normal;      ///< unit normal of the surface; 0 where it has none
  Vector_3
      transversal;  ///< vector of the tangent plane, not along the derivative, of any length; 0: normal x derivative
};

// A surface that can be blended is a model of this concept:
//   Boundary_point at(double s) const     s in [0, 1], once differentiable; not called from several threads at once
//   bool is_closed() const                the point at 1 is that at 0, with the same tangent
// Optional:
//   double second_form(double s, const Vector_3& t) const    second fundamental form II(t, t) with respect to the
//       normal at s, for a vector t of the tangent plane: (normal curvature along t) |t|^2; needed for G2 blends
//   std::vector<double> fixed_parameters() const             ascending, from 0, below 1 if closed: the vertices of a
//       curve that is a chain of edges of a mesh

/// Boundary curve of a surface to be blended, by value.
/// Source: Cheng, Gao, Constructing blending surfaces for two arbitrary surfaces, MM Research Preprints 22 (2003),
/// section 3.2: whatever surface it is, no more is asked of it.
class Boundary_curve {
 public:
  template <class Model, class = std::enable_if_t<!std::is_same_v<std::decay_t<Model>, Boundary_curve>>>
  Boundary_curve(Model model) : closed_(model.is_closed()), fixed_(fixed_of(model, 0)) {
    bind_second_form(model, 0);
    at_ = [held = std::move(model)](double s) { return held.at(s); };
  }

  [[nodiscard]] Boundary_point at(double s) const { return at_(s); }
  [[nodiscard]] bool is_closed() const noexcept { return closed_; }
  [[nodiscard]] bool has_second_form() const noexcept { return static_cast<bool>(second_form_); }
  /// Returns II(t, t) at s; only if the surface knows it.
  [[nodiscard]] double second_form(double s, const Vector_3& t) const { return second_form_(s, t); }
  /// Empty if the curve may be sampled anywhere.
  [[nodiscard]] const std::vector<double>& fixed_parameters() const noexcept { return fixed_; }

 private:
  template <class Model>
  static auto fixed_of(const Model& model, int) -> decltype(model.fixed_parameters()) {
    return model.fixed_parameters();
  }
  template <class Model>
  static std::vector<double> fixed_of(const Model&, long) {
    return {};
  }
  template <class Model>
  auto bind_second_form(const Model& model, int) -> decltype(model.second_form(0.0, Vector_3()), void()) {
    second_form_ = [held = model](double s, const Vector_3& t) { return held.second_form(s, t); };
  }
  template <class Model>
  void bind_second_form(const Model&, long) {}

  bool closed_;
  std::vector<double> fixed_;
  std::function<Boundary_point(double)> at_;
  std::function<double(double, const Vector_3&)> second_form_;
};

}  // namespace cgal_blend

#endif
