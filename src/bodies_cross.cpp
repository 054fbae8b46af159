// SPDX-License-Identifier: GPL-3.0-or-later
#include "bodies_cross.h"

#include <CGAL/Bbox_3.h>

#include <vector>

namespace cgal_blend {

namespace {

/// Bounding boxes of the pieces that hang together by edges.
std::vector<CGAL::Bbox_3> piece_boxes(const Blend_mesh& mesh) {
  std::vector<CGAL::Bbox_3> boxes;
  std::vector<bool> seen(mesh.number_of_vertices(), false);
  std::vector<Vertex> stack;
  for (const Vertex start : mesh.vertices()) {
    if (seen[start.idx()] || mesh.is_isolated(start)) continue;
    CGAL::Bbox_3 box;
    seen[start.idx()] = true;
    stack.assign(1, start);
    while (!stack.empty()) {
      const Vertex v = stack.back();
      stack.pop_back();
      box += mesh.point(v).bbox();
      for (const Vertex w : mesh.vertices_around_target(mesh.halfedge(v))) {
        if (seen[w.idx()]) continue;
        seen[w.idx()] = true;
        stack.push_back(w);
      }
    }
    boxes.push_back(box);
  }
  return boxes;
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
