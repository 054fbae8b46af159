// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_EDGE_FINDER_H
#define CGAL_BLEND_SRC_EDGE_FINDER_H

#include <cgal_blend/blend_mesh.h>

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace cgal_blend {

/// Finds vertices of a mesh by their exact places, and edges by those of their ends.
class Edge_finder {
 public:
  using Step = std::pair<Point_3, Point_3>;

  explicit Edge_finder(const Blend_mesh& mesh) : mesh_(mesh) {
    for (const Vertex v : mesh.vertices()) vertex_.emplace(mesh.point(v), v);
  }

  /// Returns the vertex at a place, or null.
  [[nodiscard]] Vertex vertex(const Point_3& p) const {
    const auto found = vertex_.find(p);
    return found == vertex_.end() ? Blend_mesh::null_vertex() : found->second;
  }

  /// Returns the edges that there are; steps that are no edge are left out.
  [[nodiscard]] std::vector<Edge> operator()(const std::vector<Step>& steps) const {
    std::vector<Edge> edges;
    for (const Step& step : steps)
      if (const Halfedge h = find(step); h != Blend_mesh::null_halfedge()) edges.push_back(mesh_.edge(h));
    return edges;
  }

  /// Returns where the first of them begins that is an edge.
  [[nodiscard]] std::optional<Vertex> first(const std::vector<Step>& steps) const {
    for (const Step& step : steps)
      if (const Halfedge h = find(step); h != Blend_mesh::null_halfedge()) return mesh_.source(h);
    return std::nullopt;
  }

 private:
  [[nodiscard]] Halfedge find(const Step& step) const {
    const Vertex from = vertex(step.first), to = vertex(step.second);
    if (from == Blend_mesh::null_vertex() || to == Blend_mesh::null_vertex()) return Blend_mesh::null_halfedge();
    return mesh_.halfedge(from, to);
  }

  const Blend_mesh& mesh_;
  std::map<Point_3, Vertex> vertex_;
};

}  // namespace cgal_blend

#endif
