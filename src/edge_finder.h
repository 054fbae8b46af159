// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_EDGE_FINDER_H
#define CGAL_BLEND_SRC_EDGE_FINDER_H

#include <cgal_blend/blend_mesh.h>

#include <map>
#include <utility>
#include <vector>

namespace cgal_blend {

/// Finds edges of a mesh by the exact places of their ends.
class Edge_finder {
 public:
  using Step = std::pair<Point_3, Point_3>;

  explicit Edge_finder(const Blend_mesh& mesh) : mesh_(mesh) {
    for (const Vertex v : mesh.vertices()) vertex_.emplace(mesh.point(v), v);
  }

  /// Returns the edges that there are; steps that are no edge are left out.
  [[nodiscard]] std::vector<Edge> operator()(const std::vector<Step>& steps) const {
    std::vector<Edge> edges;
    for (const auto& [a, b] : steps) {
      const auto from = vertex_.find(a), to = vertex_.find(b);
      if (from == vertex_.end() || to == vertex_.end()) continue;
      const Halfedge h = mesh_.halfedge(from->second, to->second);
      if (h != Blend_mesh::null_halfedge()) edges.push_back(mesh_.edge(h));
    }
    return edges;
  }

 private:
  const Blend_mesh& mesh_;
  std::map<Point_3, Vertex> vertex_;
};

}  // namespace cgal_blend

#endif
