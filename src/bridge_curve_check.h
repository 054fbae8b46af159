// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_BRIDGE_CURVE_CHECK_H
#define CGAL_BLEND_SRC_BRIDGE_CURVE_CHECK_H

#include <cgal_blend/polar_curve.h>
#include <cgal_blend/status.h>

namespace cgal_blend {

/// A contact curve as far as its parameter space tells.
struct Curve_check {
  Diagnosis diagnosis;  ///< `invalid_parameter`, or `curve_crosses_itself`; by exact predicates on a fine polygon
  double largest = 0;   ///< distance from the source, length units
};

/// Checks that a curve is finite, does not touch its source, crosses itself nowhere and runs counter-clockwise round it.
/// \param round_point the source is a point; else a closed curve, with the parameter space a ring around it
[[nodiscard]] Curve_check check_curve(const Polar_curve& curve, bool round_point);

}  // namespace cgal_blend

#endif
