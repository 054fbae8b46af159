// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_CURVE_ARC_H
#define CGAL_BLEND_CURVE_ARC_H

#include "projective_curve.h"

#include <cgal_blend/quadric_intersection.h>

#include <array>
#include <memory>

namespace cgal_blend::internal {

/// A surface's coefficients, as in `Quadric_3`, the largest about 1.
using Surface_coefficients = std::array<long double, 10>;

/// Part of a projective curve between two parameters; what an `Intersection_curve` stands for.
struct Curve_arc {
  Quadric_3 a, b;
  Surface_coefficients coefficients_a, coefficients_b;

  std::shared_ptr<const Projective_curve> curve;  // none: an isolated point
  std::array<Direction, 3> through;               // unit vectors at the begin, the middle and the end
  long double half_angle = 0;                     // between neighbours of these
  Quadric_3::Point_3 isolated_point;
  bool is_closed = false;
  std::array<bool, 2> has_cusp{false, false};  // at the begin, at the end
  int degree = 0, multiplicity = 1;

  Curve_arc(const Quadric_3& a, const Quadric_3& b);

  /// Makes this the part from one angle to another, at most pi larger.
  void set_range(const Real& begin, const Real& end);

  /// Evaluates point and derivative.
  [[nodiscard]] Curve_point at(double s) const;
};

}  // namespace cgal_blend::internal

#endif
