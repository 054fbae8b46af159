// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_BOUNDARY_MODELS_H
#define CGAL_BLEND_BOUNDARY_MODELS_H

#include <cgal_blend/boundary_curve.h>
#include <cgal_blend/implicit_function.h>
#include <cgal_blend/parametric_patch.h>

#include <array>
#include <cmath>
#include <functional>
#include <utility>

namespace cgal_blend {

/// Point of a curve in space with its derivative.
struct Space_curve_point {
  Point_3 point;
  Vector_3 derivative;
};

/// Curve in space over [0, 1]; by value.
struct Space_curve {
  std::function<Space_curve_point(double s)> at;
  bool closed = false;
};

/// Makes a curve of a formula; the derivative is exact to rounding.
/// \tparam Function callable as std::array<T, 3> f(T s) for double and `Dual<1>`
template <class Function>
[[nodiscard]] Space_curve space_curve(Function f, bool closed) {
  return {[f](double s) {
            const std::array<Dual<1>, 3> p = f(Dual<1>::variable(s, 0));
            return Space_curve_point{Point_3(p[0].value, p[1].value, p[2].value),
                                     Vector_3(p[0].slope[0], p[1].slope[0], p[2].slope[0])};
          },
          closed};
}

namespace internal {

/// The vector at length 1; 0 if it is 0 or not finite.
inline Vector_3 unit_or_zero(const Vector_3& v) {
  const double length = std::sqrt(v.squared_length());
  return length > 0 && std::isfinite(length) ? v / length : Vector_3(0, 0, 0);
}

}  // namespace internal

/// Curve on an implicit surface: a general function, or a quadric.
/// Source: Cheng, Gao (2003), section 3.2, case 1.
class Implicit_boundary {
 public:
  /// \param curve lies on the zero set
  Implicit_boundary(Implicit_function surface, Space_curve curve)
      : surface_(std::move(surface)), curve_(std::move(curve)) {}

  [[nodiscard]] Boundary_point at(double s) const {
    const Space_curve_point c = curve_.at(s);
    return {c.point, c.derivative, internal::unit_or_zero(surface_.gradient(c.point)), Vector_3(0, 0, 0)};
  }
  [[nodiscard]] bool is_closed() const { return curve_.closed; }
  [[nodiscard]] double second_form(double s, const Vector_3& t) const {
    const Point_3 p = curve_.at(s).point;
    // Of a curve in the surface with c' = t: gradient . c'' + t . H t = 0.
    return -surface_.second_derivative(p, t) / std::sqrt(surface_.gradient(p).squared_length());
  }

 private:
  Implicit_function surface_;
  Space_curve curve_;
};

/// Makes the curve of a component of an intersection, with `at(s)` giving point and derivative, such as
/// `Intersection_curve`.
template <class Component>
[[nodiscard]] Space_curve space_curve_of(Component component) {
  const bool closed = component.is_closed();
  const auto at = [held = std::move(component)](double s) {
    const auto p = held.at(s);
    return Space_curve_point{p.point, p.derivative};
  };
  return {at, closed};
}

/// Iso-curve v = constant of a parametric surface, u running with s; the transversal is dP/dv.
/// Source: Cheng, Gao (2003), sections 3.2, case 2, and 5.2.
class Iso_curve_boundary {
 public:
  /// \param v in [patch.v0, patch.v1]
  Iso_curve_boundary(Parametric_patch patch, double v) : patch_(std::move(patch)), v_(v) {}

  [[nodiscard]] Boundary_point at(double s) const {
    const Patch_point p = patch_.at(u_at(s), v_);
    return {p.point, (patch_.u1 - patch_.u0) * p.du, internal::unit_or_zero(CGAL::cross_product(p.du, p.dv)), p.dv};
  }
  [[nodiscard]] bool is_closed() const { return patch_.closed_u; }
  [[nodiscard]] double second_form(double s, const Vector_3& t) const {
    const Patch_point p = patch_.at(u_at(s), v_);
    const Vector_3 cross = CGAL::cross_product(p.du, p.dv);
    const double area = cross.squared_length();
    // t = a du + b dv.
    const double a = CGAL::cross_product(t, p.dv) * cross / area, b = CGAL::cross_product(p.du, t) * cross / area;
    return patch_.second_derivative(u_at(s), v_, a, b) * cross / std::sqrt(area);
  }

 private:
  [[nodiscard]] double u_at(double s) const { return patch_.u0 + s * (patch_.u1 - patch_.u0); }

  Parametric_patch patch_;
  double v_;
};

}  // namespace cgal_blend

#endif
