// SPDX-License-Identifier: GPL-3.0-or-later
#include "corner_patch.h"

#include "fill_loop.h"

#include <CGAL/Polygon_2_algorithms.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

// All work is done on the unit sphere around the centre, in its stereographic projection from the point opposite the
// patch: circles stay circles there, so that Delaunay in the plane is Delaunay on the sphere.

namespace cgal_blend {

namespace {

constexpr double growth = 0.3;            // of the spacing, per distance from the loop
constexpr double widest = 0.75;           // circumradius, in spacings, that calls for no further vertex
constexpr int smoothing_passes = 10;      // further ones change little
constexpr double least_turning = 1e-9;    // below, a loop lies on a great circle as far as can be told
constexpr double farthest_cosine = -0.5;  // from the axis to the loop: beyond, the projection stretches too much

/// A loop as seen from the centre, counterclockwise around the axis from outside.
struct Corner {
  std::vector<Vec> directions;    // unit
  std::vector<double> distances;  // from the centre
  std::vector<double> steps;      // per corner, mean length of its two steps between directions
  Vec axis;                       // unit, towards the middle of the inside
  bool reversed = false;          // with respect to the loop as given
};

bool see_from(const Vec& center, const std::vector<Vec>& points, Corner& corner) {
  for (const Vec& p : points) {
    const double distance = (p - center).norm();
    if (!(distance > 0) || !std::isfinite(distance)) return false;
    corner.distances.push_back(distance);
    corner.directions.push_back((p - center) / distance);
  }
  return true;
}

/// Finds the smaller side and its middle; false if there is none.
bool orient(Corner& corner) {
  const std::vector<Vec>& d = corner.directions;
  const std::size_t n = d.size();
  const auto tangent = [](const Vec& from, const Vec& to) { return Vec((to - from) - from * from.dot(to - from)); };
  Vec middle = Vec::Zero();
  double turning = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec &before = d[(i + n - 1) % n], &at = d[i], &next = d[(i + 1) % n];
    const Vec normal = at.cross(next - at);
    if (!(normal.norm() > 0)) return false;
    // The integral of the outward normal over what is left of the loop; see Stokes' theorem.
    middle += angle_between(at, next) / normal.norm() * normal;
    const Vec in = -tangent(at, before), out = tangent(at, next);
    turning += std::atan2(at.dot(in.cross(out)), in.dot(out));
  }
  // Gauss and Bonnet: the area to the left is 2 pi - turning.
  if (!(std::abs(turning) > least_turning)) return false;
  corner.reversed = turning < 0;
  corner.axis = (corner.reversed ? -middle : middle).stableNormalized();
  if (corner.reversed) {
    std::reverse(corner.directions.begin(), corner.directions.end());
    std::reverse(corner.distances.begin(), corner.distances.end());
  }
  return std::all_of(d.begin(), d.end(), [&](const Vec& v) { return v.dot(corner.axis) > farthest_cosine; });
}

void measure_steps(Corner& corner) {
  const std::vector<Vec>& d = corner.directions;
  const std::size_t n = d.size();
  for (std::size_t i = 0; i < n; ++i)
    corner.steps.push_back(((d[i] - d[(i + n - 1) % n]).norm() + (d[(i + 1) % n] - d[i]).norm()) / 2);
}

class Stereographic {
 public:
  explicit Stereographic(const Vec& axis) : axis_(axis), first_(axis.unitOrthogonal()), second_(axis.cross(first_)) {}
  [[nodiscard]] Kernel::Point_2 operator()(const Vec& direction) const {
    const double scale = 2 / (1 + direction.dot(axis_));
    return {scale * direction.dot(first_), scale * direction.dot(second_)};
  }

 private:
  Vec axis_, first_, second_;
};

/// Points in the cells of a grid, to find those near a place.
class Point_grid {
 public:
  explicit Point_grid(double cell) : cell_(cell) {}
  void insert(const Vec& p) { points_[key(p)].push_back(p); }
  /// \param distance at most the size of a cell
  [[nodiscard]] bool has_within(const Vec& p, double distance) const {
    const Key k = key(p);
    for (std::int64_t x = k[0] - 1; x <= k[0] + 1; ++x)
      for (std::int64_t y = k[1] - 1; y <= k[1] + 1; ++y)
        for (std::int64_t z = k[2] - 1; z <= k[2] + 1; ++z) {
          const auto found = points_.find({x, y, z});
          if (found == points_.end()) continue;
          for (const Vec& q : found->second)
            if ((p - q).squaredNorm() < distance * distance) return true;
        }
    return false;
  }

 private:
  using Key = std::array<std::int64_t, 3>;
  [[nodiscard]] Key key(const Vec& p) const {
    return {static_cast<std::int64_t>(std::floor(p[0] / cell_)), static_cast<std::int64_t>(std::floor(p[1] / cell_)),
            static_cast<std::int64_t>(std::floor(p[2] / cell_))};
  }

  double cell_;
  std::map<Key, std::vector<Vec>> points_;
};

/// Spreads vertices over the inside.
class Inside {
 public:
  Inside(const Corner& corner, double spacing) : corner_(corner), spacing_(spacing), project_(corner.axis) {
    for (const Vec& d : corner.directions) polygon_.push_back(project_(d));
  }

  /// False if the loop is not simple.
  bool spread() {
    if (!triangulate(inner_)) return false;
    refine();
    for (int pass = 0; pass < smoothing_passes && !inner_.empty(); ++pass)
      if (!smooth()) break;
    return true;
  }

  [[nodiscard]] const std::vector<Vec>& inner() const { return inner_; }
  [[nodiscard]] const std::vector<Index_triangle>& triangles() const { return triangles_; }

  /// Interpolates the loop's distances from the centre by mean value coordinates. Source: Hormann and Floater (2006).
  [[nodiscard]] double distance(const Vec& direction) const {
    const Kernel::Point_2 at = project_(direction);
    const std::size_t n = polygon_.size();
    const double reference = corner_.distances.front();
    double total = 0, sum = 0;
    const auto half_tangent = [](const Kernel::Vector_2& a, const Kernel::Vector_2& b) {
      return (a.x() * b.y() - a.y() * b.x()) / (std::sqrt(a.squared_length() * b.squared_length()) + a * b);
    };
    for (std::size_t i = 0; i < n; ++i) {
      const Kernel::Vector_2 before = polygon_[(i + n - 1) % n] - at, here = polygon_[i] - at,
                             next = polygon_[(i + 1) % n] - at;
      const double weight = (half_tangent(before, here) + half_tangent(here, next)) / std::sqrt(here.squared_length());
      total += weight;
      sum += weight * (corner_.distances[i] - reference);
    }
    return reference + sum / total;
  }

 private:
  struct Candidate {
    double ratio;  // circumradius to spacing
    double spacing;
    Vec center;
  };

  [[nodiscard]] const Vec& direction(std::size_t i) const {
    return i < polygon_.size() ? corner_.directions[i] : inner_[i - polygon_.size()];
  }

  /// The spacing that is asked for, as far as it can be had with neighbours of similar size everywhere.
  [[nodiscard]] double spacing_at(const Vec& d) const {
    double least = 0, most = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < polygon_.size(); ++i) {
      const double change = growth * (d - corner_.directions[i]).norm();
      least = std::max(least, corner_.steps[i] - change);
      most = std::min(most, corner_.steps[i] + change);
    }
    return std::min(most, std::max(least, spacing_));
  }

  bool triangulate(const std::vector<Vec>& inner) {
    std::vector<Kernel::Point_2> points;
    for (const Vec& d : inner) points.push_back(project_(d));
    auto triangles = triangulate_inside(polygon_, points);
    if (!triangles) return false;
    triangles_ = std::move(*triangles);
    return true;
  }

  [[nodiscard]] bool contains(const Vec& d) const {
    return CGAL::bounded_side_2(polygon_.begin(), polygon_.end(), project_(d), Kernel()) == CGAL::ON_BOUNDED_SIDE;
  }

  /// Circumcentres of triangles that are too wide, the widest first.
  [[nodiscard]] std::vector<Candidate> candidates() const {
    std::vector<Candidate> found;
    for (const auto& [a, b, c] : triangles_) {
      const Vec center = (direction(b) - direction(a)).cross(direction(c) - direction(a)).stableNormalized();
      if (center.dot(corner_.axis) <= farthest_cosine) continue;
      const double spacing = spacing_at(center), ratio = (center - direction(a)).norm() / spacing;
      if (ratio > widest && contains(center)) found.push_back({ratio, spacing, center});
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Candidate& a, const Candidate& b) { return a.ratio > b.ratio; });
    return found;
  }

  /// Delaunay refinement in batches; the distances kept bound the number of vertices.
  void refine() {
    const double most = std::max(spacing_, *std::max_element(corner_.steps.begin(), corner_.steps.end()));
    Point_grid grid(most);
    for (std::size_t i = 0; i < polygon_.size() + inner_.size(); ++i) grid.insert(direction(i));
    for (;;) {
      std::vector<Vec> inner = inner_;
      for (const Candidate& c : candidates()) {
        if (grid.has_within(c.center, widest * c.spacing)) continue;
        grid.insert(c.center);
        inner.push_back(c.center);
      }
      if (inner.size() == inner_.size() || !triangulate(inner)) return;
      inner_ = std::move(inner);
    }
  }

  /// Moves every vertex to the mean of the centroids around it, weighted by area over what is asked for there.
  bool smooth() {
    std::vector<Vec> sums(inner_.size(), Vec::Zero());
    for (const auto& triangle : triangles_) {
      const Vec &a = direction(triangle[0]), &b = direction(triangle[1]), &c = direction(triangle[2]);
      const Vec centroid = (a + b + c) / 3;
      const double spacing = spacing_at(centroid);
      const double weight = (b - a).cross(c - a).norm() / (spacing * spacing);
      for (const std::size_t v : triangle)
        if (v >= polygon_.size()) sums[v - polygon_.size()] += weight * centroid;
    }
    for (Vec& sum : sums) sum.normalize();
    if (!triangulate(sums)) return false;
    inner_ = std::move(sums);
    return true;
  }

  const Corner& corner_;
  double spacing_;
  Stereographic project_;
  std::vector<Kernel::Point_2> polygon_;
  std::vector<Vec> inner_;
  std::vector<Index_triangle> triangles_;
};

}  // namespace

std::vector<Triangle> tessellate_corner(Blend_mesh& mesh, const Vec& center, const std::vector<Vertex>& loop,
                                        double spacing) {
  CGAL_precondition(spacing > 0);
  Corner corner;
  std::vector<Vec> points;
  for (const Vertex v : loop) points.push_back(to_vec(mesh.point(v)));
  if (loop.size() < 3 || !see_from(center, points, corner) || !orient(corner)) return {};
  measure_steps(corner);
  const double mean_distance =
      std::accumulate(corner.distances.begin(), corner.distances.end(), 0.0) / static_cast<double>(loop.size());
  Inside inside(corner, spacing / mean_distance);
  if (!inside.spread()) return {};

  if (corner.reversed) std::reverse(points.begin(), points.end());
  for (const Vec& d : inside.inner()) points.push_back(center + inside.distance(d) * d);
  // Seen from the centre no triangle covers another: a loop that is simple, and triangles that face one way.
  for (const auto& [a, b, c] : inside.triangles())
    if (CGAL::orientation(to_point(center), to_point(points[a]), to_point(points[b]), to_point(points[c])) !=
        CGAL::POSITIVE)
      return {};

  std::vector<Vertex> vertices = loop;
  if (corner.reversed) std::reverse(vertices.begin(), vertices.end());
  for (std::size_t i = loop.size(); i < points.size(); ++i) vertices.push_back(mesh.add_vertex(to_point(points[i])));
  std::vector<Triangle> triangles;
  for (const auto& [a, b, c] : inside.triangles()) {
    triangles.push_back({vertices[a], vertices[b], vertices[c]});
    if (corner.reversed) std::swap(triangles.back()[1], triangles.back()[2]);
  }
  return triangles;
}

}  // namespace cgal_blend
