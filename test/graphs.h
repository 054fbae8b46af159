// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_TEST_GRAPHS_H
#define CGAL_BLEND_TEST_GRAPHS_H

#include <cgal_blend/internal/copy_mesh.h>

namespace cgal_blend::test {

/// A mesh as another type.
template <class Graph>
Graph graph_of(const Blend_mesh& mesh) {
  Graph graph;
  (void)internal::copy_out(mesh, graph, CGAL::parameters::default_values());
  return graph;
}

/// And back.
template <class Graph>
Blend_mesh blend_mesh_of(const Graph& graph) {
  return internal::Mesh_copy<Graph>(graph, CGAL::parameters::default_values()).mesh();
}

}  // namespace cgal_blend::test

#endif
