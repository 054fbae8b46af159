// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_formats.h"

namespace cgal_blend::internal {

namespace {

/// Makes an edge per pair of corners, in the order of the first; returns the halfedge of every corner.
std::vector<Halfedge> add_edges(Blend_mesh& mesh, const std::vector<Triangle>& triangles,
                                const Triangle_topology& topology) {
  std::vector<Halfedge> halfedges(3 * triangles.size());
  for (std::uint32_t c = 0; c < halfedges.size(); ++c) {
    const std::uint32_t twin = topology.twin[c];
    if (twin != Triangle_topology::none && twin < c) {
      halfedges[c] = mesh.opposite(halfedges[twin]);
    } else {
      const std::uint32_t next = next_corner(c);
      halfedges[c] = mesh.add_edge(Vertex(triangles[c / 3][c % 3]), Vertex(triangles[next / 3][next % 3]));
    }
  }
  return halfedges;
}

/// Links the halfedges without face: at a vertex of a manifold one of them comes in and one goes out.
void link_border(Blend_mesh& mesh, const std::vector<Halfedge>& halfedges, const Triangle_topology& topology) {
  std::vector<Halfedge> leaving(mesh.num_vertices());
  const auto each_border = [&](auto&& visit) {
    for (std::uint32_t c = 0; c < halfedges.size(); ++c)
      if (topology.twin[c] == Triangle_topology::none) visit(mesh.opposite(halfedges[c]));
  };
  each_border([&](Halfedge h) { leaving[mesh.source(h)] = h; });
  each_border([&](Halfedge h) {
    mesh.set_next(h, leaving[mesh.target(h)]);
    mesh.set_halfedge(mesh.target(h), h);
  });
}

}  // namespace

Blend_mesh assemble(const std::vector<Point_3>& points, const std::vector<Triangle>& triangles,
                    const Triangle_topology& topology) {
  Blend_mesh mesh;
  mesh.reserve(static_cast<Blend_mesh::size_type>(points.size()),
               static_cast<Blend_mesh::size_type>(3 * triangles.size() / 2),
               static_cast<Blend_mesh::size_type>(triangles.size()));
  for (const Point_3& p : points) mesh.add_vertex(p);
  const std::vector<Halfedge> halfedges = add_edges(mesh, triangles, topology);
  for (std::uint32_t f = 0; f < triangles.size(); ++f) {
    const Face face = mesh.add_face();
    mesh.set_halfedge(face, halfedges[3 * f]);
    for (std::uint32_t c = 3 * f; c < 3 * f + 3; ++c) {
      mesh.set_face(halfedges[c], face);
      mesh.set_next(halfedges[c], halfedges[next_corner(c)]);
      mesh.set_halfedge(mesh.target(halfedges[c]), halfedges[c]);
    }
  }
  link_border(mesh, halfedges, topology);
  return mesh;
}

}  // namespace cgal_blend::internal
