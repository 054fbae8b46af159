// SPDX-License-Identifier: GPL-3.0-or-later
#include "blend_strip.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <unordered_map>

namespace cgal_blend {

namespace {

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

/// A row of a strip: its vertices in order, and which of them stands in which profile.
struct Row {
  std::vector<Vertex> chain;
  std::map<std::size_t, std::size_t> at;  ///< profile to index into the chain; one past the last profile closes a strip
};

Row rim_row(const Rim& rim, std::size_t profiles) {
  Row row;
  row.chain = rim.vertices;
  if (!rim.path.closed) {
    for (std::size_t i = rim.first; i <= rim.last && i < profiles; ++i) row.at[i] = rim.path.station_of[i];
    return row;
  }
  const std::size_t start = rim.path.station_of[0], n = row.chain.size();
  std::rotate(row.chain.begin(), row.chain.begin() + static_cast<std::ptrdiff_t>(start), row.chain.end());
  row.chain.push_back(row.chain.front());
  for (std::size_t i = 0; i < profiles; ++i) row.at[i] = (rim.path.station_of[i] + n - start) % n;
  // Stations of the first profile may be those of the last ones too, once round.
  std::size_t past = profiles;
  while (past > 1 && row.at[past - 1] == 0) --past;
  for (std::size_t i = past; past > 1 && i < profiles; ++i) row.at[i] = n;
  row.at[profiles] = n;
  return row;
}

Row inner_row(const std::vector<Vertex>& inner, std::size_t first, const std::array<const Strip_border*, 2>& ends,
              std::size_t k) {
  Row row;
  if (ends[0]) row.chain.push_back(ends[0]->hit[k]);
  for (std::size_t i = 0; i < inner.size(); ++i) {
    row.at[first + i] = row.chain.size();
    row.chain.push_back(inner[i]);
  }
  if (ends[1]) {
    row.chain.push_back(ends[1]->hit[k]);
  } else {
    row.at[first + inner.size()] = row.chain.size();
    row.chain.push_back(inner.front());
  }
  return row;
}

/// The part of a strip's border between two rows: their ends and what lies between these.
std::vector<Vertex> border_between(Vertex low, const std::vector<Vertex>& between, Vertex high) {
  std::vector<Vertex> chain{low};
  chain.insert(chain.end(), between.begin(), between.end());
  if (high != chain.back()) chain.push_back(high);
  return chain;
}

/// Fills the space between two rows, from one profile that both have to the next. At the ends of an open strip the last
/// cell is filled across, from the rows' last vertices to the border: no triangle has all its corners on that.
void zip_rows(const Blend_mesh& mesh, const Row& low, const Row& high, const std::array<const Strip_border*, 2>& ends,
              std::size_t k, std::vector<Triangle>& out) {
  std::array<std::size_t, 2> begin{0, 0}, end{low.chain.size() - 1, high.chain.size() - 1};
  const auto roomy = [&] { return end[0] - begin[0] > 1 && end[1] - begin[1] > 1; };
  if (ends[0] && roomy()) {
    begin = {1, 1};
    zip(mesh, {low.chain[1], high.chain[1]}, border_between(low.chain[0], ends[0]->between[k], high.chain[0]), out);
  }
  if (ends[1] && end[0] > begin[0] && end[1] > begin[1]) {
    const std::vector<Vertex> border = border_between(low.chain[end[0]], ends[1]->between[k], high.chain[end[1]]);
    end = {end[0] - 1, end[1] - 1};
    const bool from_border = ends[0] && end[0] == 0 && end[1] == 0;  // one cell is all that lies between the ends
    const std::vector<Vertex> none, &between = from_border ? ends[0]->between[k] : none;
    zip(mesh, border, border_between(low.chain[end[0]], between, high.chain[end[1]]), out);
  }
  std::vector<std::array<std::size_t, 2>> stops{begin};
  for (const auto& [profile, index] : low.at) {
    const auto other = high.at.find(profile);
    if (other == high.at.end()) continue;
    const std::array<std::size_t, 2> stop{index, other->second};
    if (stop[0] < begin[0] || stop[1] < begin[1] || stop[0] > end[0] || stop[1] > end[1]) continue;
    if (stop != stops.back()) stops.push_back(stop);
  }
  if (stops.back() != end) stops.push_back(end);
  for (std::size_t s = 0; s + 1 < stops.size(); ++s) {
    const auto part = [&](const Row& row, int side) {
      return std::vector<Vertex>(row.chain.begin() + static_cast<std::ptrdiff_t>(stops[s][side]),
                                 row.chain.begin() + static_cast<std::ptrdiff_t>(stops[s + 1][side]) + 1);
    };
    std::vector<Vertex> below = part(low, 0), above = part(high, 1);
    const bool at_start = s == 0 && ends[0] && begin[0] == 0;
    if (at_start) below.insert(below.begin(), ends[0]->between[k].rbegin(), ends[0]->between[k].rend());
    if (below.front() == above.front() && below.size() > 1) below.erase(below.begin());
    if (below.back() == above.back() && below.size() > 1) below.pop_back();
    zip(mesh, below, above, out);
  }
}

}  // namespace

Strip tessellate_strip(Blend_mesh& mesh, const Virtual_surface& surface, const std::array<const Rim*, 2>& rims,
                       const std::vector<double>& rows, const std::array<const Strip_border*, 2>& ends) {
  Strip strip;
  strip.first_inner = Vertex(static_cast<std::uint32_t>(mesh.number_of_vertices() + mesh.number_of_removed_vertices()));
  std::vector<Row> row(rows.size());
  row.front() = rim_row(*rims[0], surface.size());
  row.back() = rim_row(*rims[1], surface.size());
  std::vector<std::vector<Vertex>> inner(rows.size());
  std::vector<std::size_t> first(rows.size(), 0), past(rows.size(), surface.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (ends[0]) first[k] = ends[0]->last[k];
    if (ends[1]) past[k] = ends[1]->last[k] + 1;
  }
  for (std::size_t i = 0; i < surface.size(); ++i)
    for (std::size_t k = 1; k + 1 < rows.size(); ++k)
      if (first[k] <= i && i < past[k]) {
        inner[k].push_back(mesh.add_vertex(to_point(surface.on_profile(i, rows[k]))));
        strip.profile_of.push_back(i);
      }
  for (std::size_t k = 1; k + 1 < rows.size(); ++k) row[k] = inner_row(inner[k], first[k], ends, k);
  for (std::size_t k = 0; k + 1 < rows.size(); ++k) zip_rows(mesh, row[k], row[k + 1], ends, k, strip.triangles);
  return strip;
}

std::optional<Vec> find_fold(const Blend_mesh& mesh, const Strip& strip, double angle, double least) {
  const double least_cosine = std::cos(angle * pi / 180);
  const std::vector<Triangle>& triangles = strip.triangles;
  const auto is_inner = [&](Vertex v) { return v >= strip.first_inner; };
  const auto profile = [&](Vertex v) { return strip.profile_of[v.idx() - strip.first_inner.idx()]; };
  const auto runs_across = [&](Vertex a, Vertex b) { return !is_inner(a) || !is_inner(b) || profile(a) == profile(b); };
  const auto key = [](Vertex a, Vertex b) { return (static_cast<std::uint64_t>(a.idx()) << 32) | b.idx(); };
  std::vector<Vec> normals;
  std::unordered_map<std::uint64_t, std::size_t> triangle_of;  // by directed edge
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    const Triangle& t = triangles[k];
    const Vec a = to_vec(mesh.point(t[0])), b = to_vec(mesh.point(t[1]));
    const Vec c = to_vec(mesh.point(t[2])), cross = (b - a).cross(c - a);
    normals.push_back(cross.stableNormalized());
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    if (cross.norm() < least * longest) continue;
    for (int i = 0; i < 3; ++i)
      if (runs_across(t[i], t[(i + 1) % 3])) triangle_of.emplace(key(t[i], t[(i + 1) % 3]), k);
  }
  for (std::size_t k = 0; k < triangles.size(); ++k)
    for (int i = 0; i < 3; ++i) {
      const auto other = triangle_of.find(key(triangles[k][(i + 1) % 3], triangles[k][i]));
      const bool counts =
          other != triangle_of.end() && triangle_of.count(key(triangles[k][i], triangles[k][(i + 1) % 3]));
      if (counts && normals[k].dot(normals[other->second]) < least_cosine) return to_vec(mesh.point(triangles[k][i]));
    }
  return std::nullopt;
}

Strip_quality measure_rims(const std::vector<Ball_position>& positions, const std::array<const Rim*, 2>& rims) {
  Strip_quality quality;
  for (int side = 0; side < 2; ++side) {
    const Rim& rim = *rims[side];
    for (std::size_t i = rim.first; i < std::min(positions.size(), rim.last); ++i) {
      const std::size_t j = (i + 1) % positions.size(), last = rim.path.station_of[j];
      if (positions[i].mended || positions[j].mended) continue;
      const Vec &a = positions[i].center, &b = positions[j].center;
      for (std::size_t k = rim.path.station_of[i];; k = (k + 1) % rim.path.stations.size()) {
        const Vec& p = rim.path.stations[k].point;
        double part = std::clamp((p - a).dot(b - a) / std::max((b - a).squaredNorm(), 1e-300), 0.0, 1.0);
        if (positions[i].radius != positions[j].radius) {  // the spine is slanted against the planes of the balls
          const double behind = (p - a).dot(positions[i].across), before = (b - p).dot(positions[j].across);
          if (behind + before > 0) part = std::clamp(behind / (behind + before), 0.0, 1.0);
        }
        const double radius = (1 - part) * positions[i].radius + part * positions[j].radius;
        const double off = std::abs((p - a - part * (b - a)).norm() - radius) / radius;
        if (off > quality.radius_error) {
          quality.radius_error = off;
          quality.worst = rim.path.stations[k].point;
        }
        if (k == last) break;
      }
      if (rim.surface->band_edge(positions[i].foot[side].face) != Blend_mesh::null_halfedge()) continue;  // on an edge
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
