// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_COLLAPSE_SHORT_EDGES_H
#define CGAL_BLEND_SRC_COLLAPSE_SHORT_EDGES_H

#include <cgal_blend/blend_mesh.h>

#include <functional>
#include <utility>
#include <vector>

namespace cgal_blend {

/// Collapses edges of almost no length (`shortest_edge_fraction` of the bounding box): a boolean leaves them where an
/// edge of one operand passes an edge or vertex of the other within rounding. No face may flip or lose its area.
/// \param keep true for vertices that stay where they are when the other end can go
/// \param may_go false for edges that stay, however short
/// Elements are marked as removed; the order of the others stays.
/// \return the vertices that are gone, each with the one that it was merged into, in the order of the collapses
std::vector<std::pair<Vertex, Vertex>> collapse_short_edges(
    Blend_mesh& mesh, const std::function<bool(Vertex)>& keep,
    const std::function<bool(Edge)>& may_go = [](Edge) { return true; });

/// True if there are edges for `collapse_short_edges`.
[[nodiscard]] bool has_short_edges(const Blend_mesh& mesh);

}  // namespace cgal_blend

#endif
