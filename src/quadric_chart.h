// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_QUADRIC_CHART_H
#define CGAL_BLEND_SRC_QUADRIC_CHART_H

#include <cgal_blend/quadric.h>

#include "base_surface.h"

#include <optional>

namespace cgal_blend {

/// Map of one component of a quadric to the plane, nearly true to angles; every component is at most a sphere without a
/// point, so that one map will do. Doubles, to rounding.
class Quadric_chart {
 public:
  using Point_2 = Kernel::Point_2;

  /// What the origin of the plane stands for.
  enum class Origin { a_point, apex, infinity };

  /// \param on_it a point of the component
  /// \param away ellipsoids: a direction from the centre to a point that the map may leave out
  /// Returns nothing for pairs of planes and what is no surface.
  [[nodiscard]] static std::optional<Quadric_chart> make(const Quadric_3& quadric, const Point_3& on_it,
                                                         const Vector_3& away);

  /// Returns the place of a point on or near the surface.
  [[nodiscard]] Point_2 to_plane(const Point_3& p) const;
  [[nodiscard]] Point_3 to_surface(const Point_2& p) const;
  /// Returns true for points of the quadric on the same component.
  [[nodiscard]] bool is_on_component(const Point_3& p) const;
  [[nodiscard]] Origin origin() const { return origin_; }
  /// Returns the centre or apex, or any point where there is none.
  [[nodiscard]] Point_3 centre() const { return to_point(centre_); }

 private:
  // In the frame, scaled: sphere and cylinder of radius 1, cone x^2 + y^2 = z^2, hyperboloid x^2 + y^2 - z^2 = 1;
  // square: z = a x^2 + b y^2; root: z = side * sqrt(1 + a x^2 + b y^2).
  enum class Shape { sphere, cylinder, cone, one_sheet, square, root };

  struct Form;  // eigenvalues and vectors
  void set_central(const Form& form, Quadric_type type);
  void set_cylinder(const Form& form, Quadric_type type);
  void set_parabolic(const Form& form);

  [[nodiscard]] Vec local(const Point_3& p) const;

  Shape shape_ = Shape::square;
  Origin origin_ = Origin::a_point;
  Vec centre_ = Vec::Zero();
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();  // columns
  Vec scale_ = Vec::Ones();
  double a_ = 0, b_ = 0, side_ = 1, exponent_ = 1, middle_ = 0;
};

}  // namespace cgal_blend

#endif
