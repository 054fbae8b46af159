// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SURFACE_BLEND_H
#define CGAL_BLEND_SURFACE_BLEND_H

#include <cgal_blend/adjusting_function.h>
#include <cgal_blend/boundary_curve.h>
#include <cgal_blend/correspondence.h>
#include <cgal_blend/status.h>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace cgal_blend {

/// What happens to a blend that folds over or cuts through itself.
enum class Fold_policy {
  refuse,  ///< `blend_folds`, with the largest factor of the distances that works; automatic distances are shrunk
  shrink,  ///< the distances d are multiplied by the largest factor that works
  ignore   ///< nothing is checked
};

/// One side of a blend.
struct Blend_side_options {
  /// Distance d(s) of the inner control point, length units, s being the blend's parameter; none: 0.4 times the mean
  /// distance of paired points, constant.
  std::optional<Adjusting_function> distance;
  double direction = 0;  ///< lambda in (-1, 1): leans the control point along the boundary curve
  std::optional<bool>
      flip;  ///< leave against the transversal, or normal x derivative of the curve; none: towards the other curve
};

struct Surface_blend_options {
  std::array<Blend_side_options, 2> sides;
  Correspondence_options correspondence;
  bool g2 = false;  ///< also match the normal curvature; both surfaces must know their second fundamental form
  /// Middle control point C_0(s), once differentiable; closed if the curves are: bends the blend round an obstacle.
  /// `between` is the point halfway between the inner control points, which leaves it about as it is.
  std::function<Point_3(double s, const Point_3& between)> middle;
  Fold_policy on_fold = Fold_policy::refuse;
};

/// Control points of one Bezier curve t -> P(s, t) of a blend.
struct Blend_column {
  std::array<Point_3, 7> control;
  int degree = 3;  ///< control points 0 to `degree` count

  [[nodiscard]] Point_3 at(double t) const;
  [[nodiscard]] Vector_3 derivative(double t) const;  ///< dP/dt
};

/// Parametric surface P(s, t) over the unit square, tangent to one surface along t = 0 and to the other along t = 1;
/// by value. Of degree 3 in t, 4 with a middle control point, and 5 or 6 if it continues the curvature too.
/// Source: Cheng, Gao, Constructing blending surfaces for two arbitrary surfaces, MM Research Preprints 22 (2003),
/// equations 2 to 5 and 9.
class Surface_blend {
 public:
  Surface_blend(Boundary_curve first, Boundary_curve second, Correspondence correspondence,
                Surface_blend_options options);

  [[nodiscard]] Blend_column column(double s) const;
  [[nodiscard]] Point_3 at(double s, double t) const { return column(s).at(t); }
  /// Returns dP/ds x dP/dt; exact to rounding at t = 0 and t = 1, by differences of 1e-5 in s between them.
  [[nodiscard]] Vector_3 normal(double s, double t) const;
  /// Returns `rows` x `columns` points, row by row, t in equal steps from 0 to 1, s in equal steps from 0 to 1 (below 1
  /// if closed).
  [[nodiscard]] std::vector<Point_3> sample(std::size_t columns, std::size_t rows) const;

  [[nodiscard]] bool is_closed() const noexcept { return correspondence_.closed; }
  [[nodiscard]] int degree() const noexcept;
  [[nodiscard]] const Boundary_curve& curve(int side) const { return curves_[static_cast<std::size_t>(side)]; }
  [[nodiscard]] const Parameter_map& parameter_map(int side) const {
    return correspondence_.maps[static_cast<std::size_t>(side)];
  }
  [[nodiscard]] const Correspondence& correspondence() const noexcept { return correspondence_; }
  /// Returns the boundary point at the blend's parameter s, the derivative being by s.
  [[nodiscard]] Boundary_point boundary_point(int side, double s) const;
  /// Returns the vector T of the tangent plane into which the blend leaves the surface; of length 1 unless it leans along
  /// the curve and the transversal is not normal to it.
  [[nodiscard]] Vector_3 direction(int side, double s) const;
  /// Returns the same blend with both distances multiplied by a factor.
  [[nodiscard]] Surface_blend scaled(double factor) const;

 private:
  struct End {
    Boundary_point at;
    Vector_3 towards;  // T
    double distance;
  };
  [[nodiscard]] End end(std::size_t side, double s) const;
  [[nodiscard]] Vector_3 direction_at(std::size_t side, const Boundary_point& p) const;
  void choose_sign(std::size_t side);
  void match_curvature(std::size_t side, double s, const End& end, Blend_column& column) const;

  std::array<Boundary_curve, 2> curves_;
  Correspondence correspondence_;
  Surface_blend_options options_;
  std::array<double, 2> sign_{1, 1};
};

struct Surface_blend_result {
  Diagnosis diagnosis;
  std::optional<Surface_blend> blend;  ///< if `ok`
  /// 0.97 times the largest one found to work if the blend folds, 0 if none does; under `Fold_policy::shrink` distances
  /// have been multiplied by it.
  double factor = 1;

  [[nodiscard]] bool ok() const noexcept { return diagnosis.ok(); }
};

/// Blends two surfaces along a boundary curve of each. Refuses by name: `singular_boundary`, `curves_do_not_correspond`,
/// `blend_folds`, `invalid_parameter`, `not_supported` (curvature of a surface that does not know it).
[[nodiscard]] Surface_blend_result blend_surfaces(const Boundary_curve& first, const Boundary_curve& second,
                                                  const Surface_blend_options& options = {});

/// Returns a place where the blend folds over itself, or its facets cut each other, by exact predicates; nothing if there
/// is none. Looks at a grid of so many columns, more where curves bend, and rows.
[[nodiscard]] std::optional<Point_3> find_fold(const Surface_blend& blend, std::size_t least_columns = 96,
                                               std::size_t rows = 20);

/// Returns the largest factor in (0, limit] of both distances, within 1 %, with which the blend does not fold; 0 if not
/// even a hundredth of `limit` works.
[[nodiscard]] double largest_safe_factor(const Surface_blend& blend, double limit = 1);

}  // namespace cgal_blend

#endif
