// SPDX-License-Identifier: GPL-3.0-or-later
#include "geodesic_field.h"

#include "front_step.h"
#include "run_fronts.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cgal_blend {

namespace {

using Value = Geodesic_field::Value;

/// Steps of fronts around a point.
struct Point_front {
  const Region_mesh& region;
  Geodesic_field& field;

  /// Improves the coordinates of vertex k from those of i and j, which see it to the left of their edge.
  bool operator()(std::int32_t i, std::int32_t j, std::int32_t k) const {
    const Value &at_i = field.at[i], &at_j = field.at[j];
    if (at_i.distance == 0 || at_j.distance == 0) return false;  // k has its value from the start
    const Edge_view view{region.points()[j] - region.points()[i], region.points()[k] - region.points()[i]};
    const Arrival arrival = around_point(view, at_i.distance, at_j.distance, field.at[k].distance * (1 - least_gain));
    if (!arrival.improves) return false;
    field.at[k] = {arrival.distance, between(at_i.angle, at_j.angle, arrival.share)};
    return true;
  }
};

/// The angle of a direction at a vertex, as one_ring counts them before scaling: in the triangle of its star that the
/// direction points into when seen along the normal.
double angle_of(const Region_mesh& region, std::int32_t source, const std::vector<std::int32_t>& star,
                const Vec& direction) {
  Vec normal = Vec::Zero();
  const auto edges = [&](std::int32_t t) -> std::pair<Vec, Vec> {
    const auto& corner = region.triangles()[t].corner;
    const int slot = Region_mesh::slot_of(region.triangles()[t], source);
    const Vec& origin = region.points()[source];
    return {region.points()[corner[(slot + 1) % 3]] - origin, region.points()[corner[(slot + 2) % 3]] - origin};
  };
  for (const std::int32_t t : star) {
    const auto [p, q] = edges(t);
    normal += angle_between(p, q) * p.cross(q).stableNormalized();
  }
  double running = 0, found = 0, best = -Geodesic_field::infinite;
  for (const std::int32_t t : star) {
    const auto [p, q] = edges(t);
    const double sign = normal.dot(p.cross(q)) < 0 ? -1 : 1;
    const double along_p = sign * normal.dot(direction.cross(q)) * p.norm(),
                 along_q = sign * normal.dot(p.cross(direction)) * q.norm();
    const double inside = std::min(along_p, along_q) / (std::abs(along_p) + std::abs(along_q));
    if (inside > best) {
      best = inside;
      const Vec in_plane = std::max(0.0, along_p) * p.normalized() + std::max(0.0, along_q) * q.normalized();
      found = running + angle_between(p, in_plane);
    }
    running += angle_between(p, q);
  }
  return found;
}

}  // namespace

double wrapped(double angle) {
  if (angle >= 0 && angle < 2 * pi) return angle;
  const double rest = angle - 2 * pi * std::floor(angle / (2 * pi));
  return rest < 2 * pi ? rest : 0;
}

double turn(double from, double to) {
  double way = to - from;
  if (way > pi) way -= 2 * pi;
  if (way <= -pi) way += 2 * pi;
  return way;
}

double between(double from, double to, double share) {
  if (share == 0 || share == 1) return share == 0 ? from : to;
  return wrapped(from + share * turn(from, to));
}

Geodesic_field one_ring(const Region_mesh& region, std::int32_t source, const Vec& zero_direction) {
  Geodesic_field field(region.points().size());
  const std::vector<std::int32_t> star = region.star(source);
  std::vector<double> angles{0};
  for (const std::int32_t t : star) {
    const auto& corner = region.triangles()[t].corner;
    const int slot = Region_mesh::slot_of(region.triangles()[t], source);
    const Vec& origin = region.points()[source];
    const Vec &p = region.points()[corner[(slot + 1) % 3]], &q = region.points()[corner[(slot + 2) % 3]];
    field.at[corner[(slot + 1) % 3]].distance = (p - origin).norm();
    field.fixed.push_back(corner[(slot + 1) % 3]);
    angles.push_back(angles.back() + angle_between(p - origin, q - origin));
  }
  const double scale = 2 * pi / angles.back();
  const double zero = zero_direction.isZero(0) ? 0 : angle_of(region, source, star, zero_direction);
  for (std::size_t i = 0; i < star.size(); ++i) field.at[field.fixed[i]].angle = wrapped(scale * (angles[i] - zero));
  field.at[source].distance = 0;
  field.seeds = field.fixed;
  return field;
}

void propagate(const Region_mesh& region, double limit, Geodesic_field& field) {
  run_fronts(region, limit, field, Point_front{region, field});
}

}  // namespace cgal_blend
