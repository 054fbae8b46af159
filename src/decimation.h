// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_DECIMATION_H
#define CGAL_BLEND_SRC_DECIMATION_H

#include <cgal_blend/blend_mesh.h>

#include <cstddef>
#include <vector>

namespace cgal_blend {

/// Consecutive vertices of a curve made of mesh edges; a closed one does not repeat its first vertex.
struct Vertex_chain {
  std::vector<Vertex> vertices;
  bool closed = false;
};

/// Curves keep at least so many vertices, or all if they have fewer.
inline constexpr std::size_t least_curve_vertices = 16;

/// A mesh with fewer faces, and what became of the elements of the fine one.
struct Decimated_mesh {
  Blend_mesh mesh;                   ///< compact: no removed elements
  std::vector<Vertex_chain> curves;  ///< the same chains with fewer vertices, edges of `mesh`
  std::vector<Vertex> merged_into;   ///< indexed by fine vertex: the vertex of `mesh` that it went into
  std::vector<Vertex> origin;        ///< indexed by vertex of `mesh`: the fine vertex at the very same place, or null
  std::vector<Face> fine_face;  ///< indexed by face of `mesh`: the fine face it was, on the same side of all curves
};

/// Collapses edges in the order of their quadric error (Garland & Heckbert 1997), by CGAL's
/// Surface_mesh_simplification. Chains stay chains of edges: they lose vertices only where an edge of theirs collapses
/// onto one of its ends, other vertices collapse onto them, and the ends of open ones stay.
/// \param fine closed triangle mesh without degenerate edges
/// \param curves simple chains, no two of which share a vertex
/// \param faces about how many faces to keep; more are kept where no edge can go without folding the surface
[[nodiscard]] Decimated_mesh decimate(const Blend_mesh& fine, const std::vector<Vertex_chain>& curves,
                                      std::size_t faces);

}  // namespace cgal_blend

#endif
