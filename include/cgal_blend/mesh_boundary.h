// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_MESH_BOUNDARY_H
#define CGAL_BLEND_MESH_BOUNDARY_H

#include <cgal_blend/boundary_curve.h>

#include <vector>

namespace cgal_blend {

/// Closed chain of edges of a mesh as a boundary curve: a cubic spline through its vertices with one derivative, and
/// normals between those of the vertices. The kept part is on the left seen from outside; the transversal leaves it.
/// Linkage curves, loops of border edges and any other closed polyline of edges are such chains.
class Mesh_boundary {
 public:
  /// \param chain three vertices or more, each joined to the next by an edge with a face of positive area on its left
  Mesh_boundary(const Blend_mesh& mesh, const std::vector<Vertex>& chain);

  [[nodiscard]] Boundary_point at(double s) const;
  [[nodiscard]] bool is_closed() const { return true; }
  /// One per vertex of the chain.
  [[nodiscard]] std::vector<double> fixed_parameters() const { return parameters_; }

 private:
  std::vector<double> parameters_;  // proportional to the length of the chain
  std::vector<Point_3> points_;
  std::vector<Vector_3> tangents_;  // by the parameter
  std::vector<Vector_3> normals_;
};

/// Returns the border that a vertex lies on, as a chain with the mesh on its left; empty if it lies on none.
[[nodiscard]] std::vector<Vertex> border_chain(const Blend_mesh& mesh, Vertex on_it);

}  // namespace cgal_blend

#endif
