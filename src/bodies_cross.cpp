// SPDX-License-Identifier: GPL-3.0-or-later
#include "bodies_cross.h"

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <vector>

namespace cgal_blend {

namespace {

/// Bounding boxes of the pieces that hang together by edges.
std::vector<CGAL::Bbox_3> piece_boxes(const Blend_mesh& mesh) {
  std::vector<std::uint32_t> parent(mesh.number_of_vertices() + mesh.number_of_removed_vertices());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const Edge e : mesh.edges()) {
    const std::uint32_t a = root(mesh.vertex(e, 0).idx()), b = root(mesh.vertex(e, 1).idx());
    parent[std::max(a, b)] = std::min(a, b);
  }
  std::map<std::uint32_t, CGAL::Bbox_3> boxes;
  for (const Vertex v : mesh.vertices())
    if (!mesh.is_isolated(v)) boxes[root(v.idx())] += mesh.point(v).bbox();
  std::vector<CGAL::Bbox_3> result;
  for (const auto& [piece, box] : boxes) result.push_back(box);
  return result;
}

}  // namespace

bool bodies_may_cross(const Blend_mesh& mesh) {
  const std::vector<CGAL::Bbox_3> boxes = piece_boxes(mesh);
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (CGAL::do_overlap(boxes[i], boxes[j])) return true;
  return false;
}

}  // namespace cgal_blend
