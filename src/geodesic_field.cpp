// SPDX-License-Identifier: GPL-3.0-or-later
#include "geodesic_field.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

namespace cgal_blend {

namespace {

using Value = Geodesic_field::Value;

// A distance must fall by this share for its vertex to be visited again; of the order of the rounding errors of one step.
constexpr double least_gain = 4e-16;

/// Twice the area of a triangle by its sides over the first of them: its height; zero if there is no such triangle.
/// Source: Kahan, Miscalculating area and angles of a needle-like triangle (2014), section 2.
double height_over(double base, double p, double q) {
  double a = base, b = p, c = q;
  if (a < b) std::swap(a, b);
  if (b < c) std::swap(b, c);
  if (a < b) std::swap(a, b);
  const double product = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
  return product > 0 ? 0.5 * std::sqrt(product) / base : 0;
}

/// An edge from vertex i to j with their coordinates, and vertex k to its left.
struct Step {
  Value i, j;
  Vec edge, way;  ///< from i to j, from i to k
};

double square(double x) { return x * x; }

/// The straight way to k leaves the edge, or there is none: the shortest way bends at a vertex, and keeps its angle.
bool bend(const Step& s, double bound, Value& k) {
  const double over_i = s.i.distance + s.way.norm();
  const double over_j = s.j.distance + (s.way - s.edge).norm();
  if (!(std::min(over_i, over_j) < bound)) return false;
  k = over_i <= over_j ? Value{over_i, s.i.angle} : Value{over_j, s.j.angle};
  return true;
}

/// Coordinates at k seen from the virtual source over the edge, if they are less than a bound.
bool advance(const Step& s, double bound, Value& k) {
  const double difference = s.i.distance - s.j.distance, sum = s.i.distance + s.j.distance;
  const double squared_edge = s.edge.squaredNorm(), dot = s.edge.dot(s.way);
  if (!(square(difference) <= squared_edge && square(sum) >= squared_edge)) return bend(s, bound, k);
  // By the law of cosines, without the part that is never negative: most steps lead back and end here.
  if (square(s.i.distance) + s.way.squaredNorm() - dot * (difference * sum / squared_edge + 1) >= square(bound))
    return false;
  const double e = std::sqrt(squared_edge), along = dot / e, across = s.edge.cross(s.way).norm() / e;
  const double x = 0.5 * (difference * sum / e + e), y = height_over(e, s.i.distance, s.j.distance);
  const double left = x * across + y * along, right = (e - x) * across + y * (e - along);
  if (left < 0 || right < 0) return bend(s, bound, k);
  const double distance = std::sqrt(square(along - x) + square(across + y));
  if (!(distance < bound)) return false;
  const double over = y * (across + y);
  const double from_i = std::atan2(left, over - x * (along - x));
  const double whole = from_i + std::atan2(right, over + (e - x) * (along - x));
  const double share = whole > 0 ? from_i / whole : 0.5;
  k = {distance, wrapped(s.i.angle + share * turn(s.i.angle, s.j.angle))};
  return true;
}

class Propagation {
 public:
  Propagation(const Region_mesh& region, double limit, Geodesic_field& field)
      : region_(region), limit_(limit), field_(field) {
    for (const std::int32_t v : field.fixed) queue_.emplace(field.at[v].distance, v);
  }

  void run() {
    while (!queue_.empty() && queue_.top().first <= limit_) {
      const auto [distance, vertex] = queue_.top();
      queue_.pop();
      if (distance != field_.at[vertex].distance) continue;  // found shorter since
      const std::int32_t v = vertex;
      region_.for_star(v, [&](std::int32_t t, int slot) { visit(t, slot); });
    }
  }

 private:
  /// The edges from the corner in a slot to its two neighbours.
  void visit(std::int32_t t, int slot) {
    const auto& corner = region_.triangles()[t].corner;
    const std::int32_t v = corner[slot], next = corner[(slot + 1) % 3], last = corner[(slot + 2) % 3];
    update(v, next, last);
    update(last, v, next);
  }

  void update(std::int32_t i, std::int32_t j, std::int32_t k) {
    Value& value = field_.at[k];
    if (field_.at[i].distance == 0 || field_.at[j].distance == 0) return;  // k has its value from the start
    const Vec& origin = region_.points()[i];
    const Step step{field_.at[i], field_.at[j], region_.points()[j] - origin, region_.points()[k] - origin};
    if (!advance(step, value.distance * (1 - least_gain), value)) return;
    queue_.emplace(value.distance, k);
  }

  using Entry = std::pair<double, std::int32_t>;

  const Region_mesh& region_;
  double limit_;
  Geodesic_field& field_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
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
  return field;
}

void propagate(const Region_mesh& region, double limit, Geodesic_field& field) {
  Propagation(region, limit, field).run();
}

}  // namespace cgal_blend
