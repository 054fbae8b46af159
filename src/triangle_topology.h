// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_TRIANGLE_TOPOLOGY_H
#define CGAL_BLEND_SRC_TRIANGLE_TOPOLOGY_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace cgal_blend::internal {

using Triangle = std::array<std::uint32_t, 3>;

/// Corner 3 f + i of triangle f also stands for the directed edge from its vertex to the next one of f.
inline std::uint32_t next_corner(std::uint32_t c) { return c % 3 == 2 ? c - 2 : c + 1; }
inline std::uint32_t previous_corner(std::uint32_t c) { return c % 3 == 0 ? c + 2 : c - 1; }

/// How indexed triangles hang together. Counts of defects, and of each kind the one at the face of least index.
struct Triangle_topology {
  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

  std::vector<std::uint32_t> twin;  ///< per corner: the corner of the opposite directed edge, or `none`
  std::size_t repeated_corners = 0, crowded_edges = 0, misoriented_edges = 0, border_edges = 0, crowded_vertices = 0;

  std::optional<std::uint32_t> repeated_corner;   ///< face that names a vertex twice
  std::optional<std::uint32_t> crowded_edge;      ///< corner of an edge with more than two faces
  std::optional<std::uint32_t> misoriented_edge;  ///< corner of an edge that both its faces run through the same way
  std::optional<std::uint32_t> border_edge;       ///< corner of an edge with one face
  std::optional<std::uint32_t> crowded_vertex;    ///< vertex at which separate fans of faces meet

  /// True if a halfedge structure can hold the triangles; an open border is no obstacle.
  [[nodiscard]] bool manifold() const {
    return !repeated_corner && !crowded_edge && !misoriented_edge && !crowded_vertex;
  }
};

/// Analyzes triangles over the vertices 0 .. vertex_count-1. Fans are only looked at where all edges are good.
/// \param judged if not empty: defects are only counted at vertices with a true entry and at their edges; the
///        triangles must then include all that have such a vertex
[[nodiscard]] Triangle_topology analyze_topology(std::size_t vertex_count, const std::vector<Triangle>& triangles,
                                                 const std::vector<char>& judged = {});

}  // namespace cgal_blend::internal

#endif
