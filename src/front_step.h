// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_FRONT_STEP_H
#define CGAL_BLEND_SRC_FRONT_STEP_H

#include "base_surface.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cgal_blend {

/// How a front that is known at both ends of an edge comes to a point on the left of it, all in one plane.
struct Arrival {
  bool improves = false;
  double distance = 0;
  double share = 0;  ///< of the way from one end to the other along the front, where the geodesic to the point starts
};

/// An edge from i to j and a point k, seen from i.
struct Edge_view {
  Vec edge, way;
};

inline double square(double x) { return x * x; }

/// Height over its base of a triangle with given sides; zero if there is no such triangle.
/// Source: Kahan, Miscalculating area and angles of a needle-like triangle (2014), section 2.
inline double height_over(double base, double p, double q) {
  double a = base, b = p, c = q;
  if (a < b) std::swap(a, b);
  if (b < c) std::swap(b, c);
  if (a < b) std::swap(a, b);
  const double product = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
  return product > 0 ? 0.5 * std::sqrt(product) / base : 0;
}

/// The straight way to k leaves the edge, or there is none: the shortest way bends at an end, and keeps its angle.
inline Arrival around_end(const Edge_view& view, double at_i, double at_j, double bound) {
  const double over_i = at_i + view.way.norm(), over_j = at_j + (view.way - view.edge).norm();
  const double distance = std::min(over_i, over_j);
  return {distance < bound, distance, over_i <= over_j ? 0.0 : 1.0};
}

/// A front around a point, which is unfolded into the plane of the edge and k, on the right of the edge.
/// \param at_i, at_j distances of the ends from the point
/// \param bound distances that are not less are of no interest
inline Arrival around_point(const Edge_view& view, double at_i, double at_j, double bound) {
  const double difference = at_i - at_j, sum = at_i + at_j;
  const double squared_edge = view.edge.squaredNorm(), dot = view.edge.dot(view.way);
  if (!(square(difference) <= squared_edge && square(sum) >= squared_edge)) return around_end(view, at_i, at_j, bound);
  // By the law of cosines, without the part that is never negative: most steps lead back and end here.
  if (square(at_i) + view.way.squaredNorm() - dot * (difference * sum / squared_edge + 1) >= square(bound)) return {};
  const double e = std::sqrt(squared_edge), along = dot / e, across = view.edge.cross(view.way).norm() / e;
  const double x = 0.5 * (difference * sum / e + e), y = height_over(e, at_i, at_j);
  const double left = x * across + y * along, right = (e - x) * across + y * (e - along);
  if (left < 0 || right < 0) return around_end(view, at_i, at_j, bound);
  const double distance = std::sqrt(square(along - x) + square(across + y));
  if (!(distance < bound)) return {};
  const double over = y * (across + y);
  const double from_i = std::atan2(left, over - x * (along - x));
  const double whole = from_i + std::atan2(right, over + (e - x) * (along - x));
  return {true, distance, whole > 0 ? from_i / whole : 0.5};
}

}  // namespace cgal_blend

#endif
