// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge_curve_check.h"

#include <cgal_blend/blend_mesh.h>

#include <CGAL/Polygon_2_algorithms.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace cgal_blend {

namespace {

constexpr int corners = 720;  // of the polygon that stands for the curve
constexpr int closer = 32;    // parts of its sides, near the largest distances

using Polygon = std::vector<Kernel::Point_2>;

Curve_check refused(Status status, const std::string& detail) { return {Diagnosis{status, detail, {}, {}}, 0}; }

std::vector<Polar_point> sampled(const Polar_curve& curve) {
  std::vector<Polar_point> points;
  for (int i = 0; i < corners; ++i) points.push_back(curve(static_cast<double>(i) / corners));
  return points;
}

/// The largest distance may lie between the corners of the polygon: looks closer where these are farthest.
double largest_distance(const Polar_curve& curve, const std::vector<Polar_point>& points) {
  double largest = 0;
  for (int i = 0; i < corners; ++i) {
    const double at = points[static_cast<std::size_t>(i)].distance;
    largest = std::max(largest, at);
    if (at < points[static_cast<std::size_t>((i + 1) % corners)].distance ||
        at < points[static_cast<std::size_t>((i + corners - 1) % corners)].distance)
      continue;
    for (int k = 1; k < 2 * closer; ++k)
      largest = std::max(largest, curve((i + static_cast<double>(k) / closer - 1) / corners).distance);
  }
  return largest;
}

}  // namespace

Curve_check check_curve(const Polar_curve& curve, bool round_point) {
  if (!curve) return refused(Status::invalid_parameter, "there is no contact curve");
  const std::vector<Polar_point> points = sampled(curve);
  Curve_check result;
  for (const Polar_point& p : points) {
    if (!(p.distance > 0) || !std::isfinite(p.distance) || !std::isfinite(p.angle))
      return refused(Status::invalid_parameter, "the contact curve must be finite and keep away from the spot");
  }
  result.largest = largest_distance(curve, points);
  // A ring becomes plane with a hole of its own size.
  const double hole = round_point ? 0 : result.largest;
  Polygon polygon;
  for (const Polar_point& p : points)
    polygon.emplace_back((hole + p.distance) * std::cos(p.angle), (hole + p.distance) * std::sin(p.angle));
  if (!CGAL::is_simple_2(polygon.begin(), polygon.end(), Kernel())) return refused(Status::curve_crosses_itself, "");
  if (CGAL::orientation_2(polygon.begin(), polygon.end(), Kernel()) != CGAL::COUNTERCLOCKWISE ||
      CGAL::bounded_side_2(polygon.begin(), polygon.end(), Kernel::Point_2(0, 0), Kernel()) != CGAL::ON_BOUNDED_SIDE)
    return refused(Status::invalid_parameter, "the contact curve must run counter-clockwise around the spot");
  return result;
}

}  // namespace cgal_blend
