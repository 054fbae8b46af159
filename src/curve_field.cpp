// SPDX-License-Identifier: GPL-3.0-or-later
#include "curve_field.h"

#include "front_step.h"
#include "run_fronts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <utility>

namespace cgal_blend {

namespace {

// Fronts that bend by less over one edge are straight: the rounding of a circle's distances would be larger than this.
constexpr double straight = 1e-7;

/// A front that is a straight line.
Arrival straight_on(const Edge_view& view, double at_i, double at_j, double bound) {
  const double e = view.edge.norm(), rise = at_j - at_i;
  if (!(std::abs(rise) <= e)) return around_end(view, at_i, at_j, bound);
  const double along = view.edge.dot(view.way) / e, across = view.edge.cross(view.way).norm() / e;
  const double slope = rise / e, steep = std::sqrt((e - rise) * (e + rise)) / e;  // the unit normal of the front
  const double left = along * steep - across * slope, right = (e - along) * steep + across * slope;
  if (left < 0 || right < 0) return around_end(view, at_i, at_j, bound);
  const double distance = at_i + slope * along + steep * across;
  return {distance<bound, distance, left + right> 0 ? left / (left + right) : 0.5};
}

/// Distance by a straight front, which may start at an end only.
double straight_distance(const Edge_view& view, double at_i, double at_j) {
  const Arrival arrival = straight_on(view, at_i, at_j, Geodesic_field::infinite);
  return arrival.distance;
}

/// A front that contracts to a point on the left of the edge.
/// \param to_i, to_j distances of the ends from that point
Arrival towards_point(const Edge_view& view, double to_i, double to_j, double at_i, double at_j, double bound) {
  const double e = view.edge.norm();
  if (!(std::abs(to_i - to_j) <= e && to_i + to_j >= e)) return around_end(view, at_i, at_j, bound);
  const double along = view.edge.dot(view.way) / e, across = view.edge.cross(view.way).norm() / e;
  const double x = 0.5 * ((to_i - to_j) * (to_i + to_j) / e + e), y = height_over(e, to_i, to_j);
  const double left = y * along - x * across, right = y * (e - along) - (e - x) * across;
  if (across >= y || left < 0 || right < 0) return around_end(view, at_i, at_j, bound);
  const double distance = at_i + to_i - std::hypot(along - x, across - y);
  const double over = y * (y - across);
  const double from_i = std::atan2(left, over - x * (along - x));
  const double whole = from_i + std::atan2(right, over + (e - x) * (along - x));
  return {distance<bound, distance, whole> 0 ? from_i / whole : 0.5};
}

/// Steps of fronts from a curve; each vertex knows how the curve is curved where its geodesic starts.
class Curve_front {
 public:
  Curve_front(const Region_mesh& region, Geodesic_field& field, std::vector<double>& curvature)
      : region_(region), field_(field), curvature_(curvature) {}

  bool operator()(std::int32_t i, std::int32_t j, std::int32_t k) const {
    auto& at = field_.at;
    const Edge_view view{region_.points()[j] - region_.points()[i], region_.points()[k] - region_.points()[i]};
    const Arrival arrival = arrive(view, i, j, at[k].distance * (1 - least_gain));
    if (!arrival.improves) return false;
    at[k] = {arrival.distance, between(at[i].angle, at[j].angle, arrival.share)};
    curvature_[k] = arrival.share == 0   ? curvature_[i]
                    : arrival.share == 1 ? curvature_[j]
                                         : (1 - arrival.share) * curvature_[i] + arrival.share * curvature_[j];
    return true;
  }

 private:
  [[nodiscard]] Arrival arrive(const Edge_view& view, std::int32_t i, std::int32_t j, double bound) const {
    const double at_i = field_.at[i].distance, at_j = field_.at[j].distance;
    if (!std::isfinite(at_i + at_j)) return around_end(view, at_i, at_j, bound);
    const double e = view.edge.norm(), least = std::min(at_i, at_j);
    const double mean = 0.5 * (curvature_[i] + curvature_[j]);
    if (std::abs(mean) * (e + least) < straight) return straight_on(view, at_i, at_j, bound);
    // The curve's edges are straight, and the circle through their ends lies off them: there only its rays count.
    const bool on_curve = at_i == 0 && at_j == 0;
    Arrival arrival = curved(view, 1 / mean, at_i, at_j, on_curve ? Geodesic_field::infinite : bound);
    const bool inside = arrival.share > 0 && arrival.share < 1;
    if (inside && (on_curve || arrival.distance < least)) arrival.distance = straight_distance(view, at_i, at_j);
    arrival.improves = arrival.improves && arrival.distance < bound;
    return arrival;
  }

  /// \param radius of the circle that the front comes from, negative if it contracts
  static Arrival curved(const Edge_view& view, double radius, double at_i, double at_j, double bound) {
    if (radius < 0 && (at_i + radius >= 0 || at_j + radius >= 0)) return around_end(view, at_i, at_j, bound);
    if (radius < 0) return towards_point(view, -radius - at_i, -radius - at_j, at_i, at_j, bound);
    Arrival arrival = around_point(view, at_i + radius, at_j + radius, bound + radius);
    arrival.distance -= radius;
    return arrival;
  }

  const Region_mesh& region_;
  Geodesic_field& field_;
  std::vector<double>& curvature_;
};

/// Angle on the left of a curve at one of its vertices.
double left_angle(const Region_mesh& region, std::int32_t vertex) {
  double sum = 0;
  const Vec& origin = region.points()[vertex];
  region.for_star(vertex, [&](std::int32_t t, int slot) {
    const auto& corner = region.triangles()[t].corner;
    sum += angle_between(region.points()[corner[(slot + 1) % 3]] - origin,
                         region.points()[corner[(slot + 2) % 3]] - origin);
  });
  return sum;
}

/// Geodesic curvature at the vertices of a curve, positive where fronts to the left widen: the turns over stretches of a
/// certain length on both sides, because single ones are as uneven as the steps.
std::vector<double> curvatures(const Region_mesh& region, const std::vector<std::int32_t>& curve,
                               const std::vector<double>& start, double stretch) {
  const std::size_t n = curve.size();
  std::vector<double> turns(n), lengths(n), curvature(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double before = i == 0 ? start[n] - start[n - 1] : start[i] - start[i - 1];
    lengths[i] = 0.5 * (before + start[i + 1] - start[i]);
    turns[i] = left_angle(region, curve[i]) - pi;
  }
  for (std::size_t i = 0; i < n; ++i) {
    double sum = turns[i], length = lengths[i];
    for (std::size_t k = 1; 2 * k < n && length < 2 * stretch; ++k) {
      const std::size_t before = (i + n - k) % n, after = (i + k) % n;
      sum += turns[before] + turns[after];
      length += lengths[before] + lengths[after];
    }
    curvature[i] = sum / length;
  }
  return curvature;
}

/// The edges of a curve by the faces on their left, which are flat: what is in such a face sees them straight.
class Faces_of_curve {
 public:
  Faces_of_curve(const Region_mesh& region, const std::vector<std::int32_t>& curve, Geodesic_field& field,
                 std::vector<double>& curvature)
      : region_(region), field_(field), curvature_(curvature) {
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const std::int32_t from = curve[i], to = curve[(i + 1) % curve.size()];
      edges_[region.face(region.edge(from, to).first)].push_back({from, to});
    }
    edges_.erase(Blend_mesh::null_face());
  }

  /// Gives all vertices in those faces the distance from the nearest point on them, if they are to the left of it.
  void seed() {
    for (std::int32_t t = 0; t < static_cast<std::int32_t>(region_.triangles().size()); ++t) {
      const auto found = edges_.find(region_.face(t));
      if (found == edges_.end()) continue;
      const auto c = region_.corners(t);
      const Vec normal = (c[1] - c[0]).cross(c[2] - c[0]);
      for (const std::int32_t v : region_.triangles()[t].corner) seed(v, found->second, normal);
    }
  }

 private:
  using Ends = std::pair<std::int32_t, std::int32_t>;

  void seed(std::int32_t v, const std::vector<Ends>& edges, const Vec& normal) {
    if (field_.at[v].distance == 0) return;
    const Vec& point = region_.points()[v];
    double nearest = field_.at[v].distance, share = 0;
    const Ends* of = nullptr;
    for (const Ends& ends : edges) {
      const Vec& origin = region_.points()[ends.first];
      const Vec edge = region_.points()[ends.second] - origin;
      const double part = std::clamp((point - origin).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
      const double distance = (point - origin - part * edge).norm();
      if (distance >= nearest) continue;
      nearest = distance;
      share = part;
      of = edge.cross(point - origin).dot(normal) > 0 ? &ends : nullptr;
    }
    if (!of) return;
    field_.at[v] = {nearest, between(field_.at[of->first].angle, field_.at[of->second].angle, share)};
    curvature_[v] = (1 - share) * curvature_[of->first] + share * curvature_[of->second];
    field_.seeds.push_back(v);
  }

  const Region_mesh& region_;
  Geodesic_field& field_;
  std::vector<double>& curvature_;
  std::unordered_map<Face, std::vector<Ends>> edges_;
};

}  // namespace

Geodesic_field curve_field(const Region_mesh& region, const std::vector<std::int32_t>& curve, double stretch,
                           double limit) {
  const std::size_t n = curve.size();
  std::vector<double> start(n + 1, 0), curvature(region.points().size(), 0);
  for (std::size_t i = 0; i < n; ++i)
    start[i + 1] = start[i] + (region.points()[curve[(i + 1) % n]] - region.points()[curve[i]]).norm();
  const std::vector<double> of_curve = curvatures(region, curve, start, stretch);
  Geodesic_field field(region.points().size());
  field.fixed = curve;
  for (std::size_t i = 0; i < n; ++i) {
    field.at[curve[i]] = {0, 2 * pi * start[i] / start[n]};
    curvature[curve[i]] = of_curve[i];
  }
  field.seeds = curve;
  Faces_of_curve(region, curve, field, curvature).seed();
  run_fronts(region, limit, field, Curve_front(region, field, curvature));
  return field;
}

}  // namespace cgal_blend
