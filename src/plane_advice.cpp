// SPDX-License-Identifier: GPL-3.0-or-later
#include "plane_advice.h"

#include "number_text.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace cgal_blend {

namespace {

// A gap between heights of vertices is worth moving to if it is wider than this share of the mesh.
constexpr double gap = 1e-4;

/// Heights of vertices above the plane, in length units, in order.
std::vector<std::pair<double, Vertex>> heights(const Blend_mesh& mesh, const Cut_plane& plane) {
  const double length = std::sqrt(plane.normal.squared_length());
  std::vector<std::pair<double, Vertex>> all;
  for (const Vertex v : mesh.vertices())
    if (!mesh.is_isolated(v)) all.emplace_back((mesh.point(v) - plane.point) * plane.normal / length, v);
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

Diagnosis plane_that_misses(const Blend_mesh& mesh, const Cut_plane& plane) {
  const auto all = heights(mesh, plane);
  const bool beyond = all.front().first > 0;
  const double from = beyond ? all.front().first : -all.back().first;
  const double to = beyond ? all.back().first : -all.front().first;
  return {Status::plane_misses_mesh,
          std::string("move it ") + (beyond ? "along" : "against") + " its normal by between " + number_text(from) +
              " and " + number_text(to),
          mesh.point(beyond ? all.front().second : all.back().second),
          {}};
}

Diagnosis plane_that_meets(const Blend_mesh& mesh, const Cut_plane& plane, Vertex v) {
  Diagnosis diagnosis{Status::plane_meets_vertex, "vertex " + std::to_string(v.idx()), mesh.point(v), {}};
  const auto all = heights(mesh, plane);
  const double least = gap * (all.back().first - all.front().first);
  double best = 0;  // the shortest move to the middle of a gap
  for (std::size_t i = 1; i < all.size(); ++i) {
    if (all[i].first - all[i - 1].first <= least) continue;
    const double middle = (all[i - 1].first + all[i].first) / 2;
    if (best == 0 || std::abs(middle) < std::abs(best)) best = middle;
  }
  if (best != 0)
    diagnosis.detail += std::string(", by ") + number_text(std::abs(best)) + (best > 0 ? " along" : " against") +
                        " its normal for example";
  return diagnosis;
}

}  // namespace cgal_blend
