// SPDX-License-Identifier: GPL-3.0-or-later
#include "blend_strip.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace cgal_blend {

namespace {

/// Vertices of a rim from one ball position to the next, both included.
std::vector<Vertex> rim_between(const Rim& rim, std::size_t i, std::size_t j) {
  std::vector<Vertex> chain;
  const std::size_t n = rim.vertices.size(), last = rim.path.station_of[j];
  std::size_t k = rim.path.station_of[i];
  chain.push_back(rim.vertices[k]);
  while (k != last) {
    k = (k + 1) % n;
    chain.push_back(rim.vertices[k]);
  }
  return chain;
}

/// Triangulates between two chains that face each other, `low` to the right of `high` seen along them from above;
/// always takes the shorter of the two possible diagonals.
void zip(const Blend_mesh& mesh, const std::vector<Vertex>& low, const std::vector<Vertex>& high,
         std::vector<Triangle>& out) {
  const auto distance = [&](Vertex a, Vertex b) {
    return (to_vec(mesh.point(a)) - to_vec(mesh.point(b))).squaredNorm();
  };
  std::size_t i = 0, j = 0;
  while (i + 1 < low.size() || j + 1 < high.size()) {
    const bool step_low =
        j + 1 == high.size() || (i + 1 < low.size() && distance(low[i + 1], high[j]) <= distance(low[i], high[j + 1]));
    if (step_low) {
      out.push_back({low[i + 1], low[i], high[j]});
      ++i;
    } else {
      out.push_back({low[i], high[j], high[j + 1]});
      ++j;
    }
  }
}

}  // namespace

Strip tessellate_strip(Blend_mesh& mesh, const Virtual_surface& surface, const std::array<const Rim*, 2>& rims,
                       double chord_tolerance) {
  const std::size_t n = surface.size();
  const std::vector<double> rows = surface.rows(chord_tolerance);
  std::vector<std::vector<Vertex>> inner(n);  // per profile, what lies between its ends
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 1; k + 1 < rows.size(); ++k)
      inner[i].push_back(mesh.add_vertex(to_point(surface.on_profile(i, rows[k]))));
  Strip strip{{}, inner.front().front(), rows.size() - 2};
  std::vector<Triangle>& triangles = strip.triangles;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    zip(mesh, rim_between(*rims[0], i, j), {inner[i].front(), inner[j].front()}, triangles);
    for (std::size_t k = 0; k + 1 < inner[i].size(); ++k)
      zip(mesh, {inner[i][k], inner[j][k]}, {inner[i][k + 1], inner[j][k + 1]}, triangles);
    zip(mesh, {inner[i].back(), inner[j].back()}, rim_between(*rims[1], i, j), triangles);
  }
  return strip;
}

std::optional<Vec> find_fold(const Blend_mesh& mesh, const Strip& strip, double angle) {
  const double least = std::cos(angle * pi / 180);
  const std::vector<Triangle>& triangles = strip.triangles;
  const auto is_inner = [&](Vertex v) { return v >= strip.first_inner; };
  const auto profile = [&](Vertex v) { return (v.idx() - strip.first_inner.idx()) / strip.inner_per_profile; };
  const auto runs_across = [&](Vertex a, Vertex b) { return !is_inner(a) || !is_inner(b) || profile(a) == profile(b); };
  const auto key = [](Vertex a, Vertex b) { return (static_cast<std::uint64_t>(a.idx()) << 32) | b.idx(); };
  std::vector<Vec> normals;
  std::unordered_map<std::uint64_t, std::size_t> triangle_of;  // by directed edge
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    const Triangle& t = triangles[k];
    const Vec a = to_vec(mesh.point(t[0])), b = to_vec(mesh.point(t[1]));
    normals.push_back((b - a).cross(to_vec(mesh.point(t[2])) - a).stableNormalized());
    for (int i = 0; i < 3; ++i)
      if (runs_across(t[i], t[(i + 1) % 3])) triangle_of.emplace(key(t[i], t[(i + 1) % 3]), k);
  }
  for (std::size_t k = 0; k < triangles.size(); ++k)
    for (int i = 0; i < 3; ++i) {
      const auto other = triangle_of.find(key(triangles[k][(i + 1) % 3], triangles[k][i]));
      if (other != triangle_of.end() && normals[k].dot(normals[other->second]) < least)
        return to_vec(mesh.point(triangles[k][i]));
    }
  return std::nullopt;
}

Strip_quality measure_rims(const std::vector<Ball_position>& positions, const std::array<const Rim*, 2>& rims,
                           double radius) {
  Strip_quality quality;
  for (int side = 0; side < 2; ++side) {
    const Rim& rim = *rims[side];
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const std::size_t j = (i + 1) % positions.size(), last = rim.path.station_of[j];
      if (positions[i].mended || positions[j].mended) continue;
      const Vec &a = positions[i].center, &b = positions[j].center;
      for (std::size_t k = rim.path.station_of[i];; k = (k + 1) % rim.path.stations.size()) {
        const double off = std::abs(off_segment(a, b, rim.path.stations[k].point) - radius) / radius;
        if (off > quality.radius_error) {
          quality.radius_error = off;
          quality.worst = rim.path.stations[k].point;
        }
        if (k == last) break;
      }
      const Vec radial = positions[i].contact[side] - positions[i].center;
      const Vec& normal = rim.surface->frame(positions[i].foot[side].face).face_normal;
      const double angle = std::atan2(radial.cross(normal).norm(), std::abs(radial.dot(normal)));
      quality.tangency_deg = std::max(quality.tangency_deg, angle * 180 / pi);
      quality.mean_tangency_deg += angle * 180 / pi / static_cast<double>(2 * positions.size());
    }
  }
  return quality;
}

double measure_tangency(const Virtual_surface& surface) {
  double largest = 0;
  for (std::size_t i = 0; i < surface.size(); ++i)
    for (const int side : {0, 1}) largest = std::max(largest, surface.end_angle(i, side));
  return largest;
}

}  // namespace cgal_blend
