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

using Polygon = std::vector<Kernel::Point_2>;

Curve_check refused(Status status, const std::string& detail) { return {Diagnosis{status, detail, {}, {}}, 0}; }

std::vector<Polar_point> sampled(const Polar_curve& curve) {
  std::vector<Polar_point> points;
  for (int i = 0; i < corners; ++i) points.push_back(curve(static_cast<double>(i) / corners));
  return points;
}

}  // namespace

Curve_check check_curve(const Polar_curve& curve, bool round_point) {
  if (!curve) return refused(Status::invalid_parameter, "there is no contact curve");
  const std::vector<Polar_point> points = sampled(curve);
  Curve_check result;
  for (const Polar_point& p : points) {
    if (!(p.distance > 0) || !std::isfinite(p.distance) || !std::isfinite(p.angle))
      return refused(Status::invalid_parameter, "the contact curve must be finite and keep away from the spot");
    result.largest = std::max(result.largest, p.distance);
  }
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
