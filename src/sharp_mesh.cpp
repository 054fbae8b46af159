// SPDX-License-Identifier: GPL-3.0-or-later
#include "sharp_mesh.h"

#include "collapse_short_edges.h"

namespace cgal_blend {

Sharp_mesh::Sharp_mesh(const Fillet_body& body) : mesh(*body.mesh) {
  if (body.own_surface) return;  // valid as it is
  const auto collapsed = collapse_short_edges(mesh, [&](Vertex v) { return body.cells.is_original(v); });
  for (auto it = collapsed.rbegin(); it != collapsed.rend(); ++it) {
    const auto further = merged_.find(it->second);
    merged_[it->first] = further != merged_.end() ? further->second : it->second;
  }
}

std::vector<Vertex> Sharp_mesh::curve(const Blend_mesh& body_mesh, const std::vector<Halfedge>& chain) const {
  std::vector<Vertex> vertices;
  for (const Halfedge h : chain) {
    const auto found = merged_.find(body_mesh.source(h));
    const Vertex v = found != merged_.end() ? found->second : body_mesh.source(h);
    if (vertices.empty() || vertices.back() != v) vertices.push_back(v);
  }
  while (vertices.size() > 1 && vertices.front() == vertices.back()) vertices.pop_back();
  return vertices;
}

}  // namespace cgal_blend
