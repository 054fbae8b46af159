// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_POLAR_CURVE_H
#define CGAL_BLEND_POLAR_CURVE_H

#include <functional>
#include <vector>

namespace cgal_blend {

/// A point in geodesic polar coordinates.
struct Polar_point {
  double distance = 0;  ///< from the source, length units
  double angle = 0;     ///< radians, any real number; angles that differ by 2 pi are the same
};

/// A closed curve around the source in polar coordinates: s in [0, 1], the angle of s = 1 is that of s = 0 plus 2 pi.
using Polar_curve = std::function<Polar_point(double s)>;

// All sizes are length units and > 0; curves are centred on the source, and run counter-clockwise from angle 0.

[[nodiscard]] Polar_curve circle_curve(double radius);
/// \param a, b half axes, `a` along angle 0
[[nodiscard]] Polar_curve ellipse_curve(double a, double b);
/// \param a, b half sides, `a` along angle 0; corners are rounded by `corner` in (0, min(a, b)]
[[nodiscard]] Polar_curve rectangle_curve(double a, double b, double corner);
/// A smooth star: distance = radius (1 + depth cos(arms angle)), depth in [0, 1).
[[nodiscard]] Polar_curve star_curve(double radius, double depth, int arms);
/// A cross of two bars of half length `a` and half width `b` < a, corners rounded by `corner` in (0, min(b, (a - b) / 2)].
[[nodiscard]] Polar_curve cross_curve(double a, double b, double corner);
/// A periodic cubic spline through points of strictly ascending angles, at least three, over less than a full turn.
[[nodiscard]] Polar_curve spline_curve(const std::vector<Polar_point>& points);
/// Any function of the angle.
[[nodiscard]] Polar_curve function_curve(std::function<double(double angle)> distance);

/// Scales the distances: the inner curve of a bridge.
[[nodiscard]] Polar_curve scaled(Polar_curve curve, double factor);

}  // namespace cgal_blend

#endif
