// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_MESH_CHECKS_H
#define CGAL_BLEND_SRC_MESH_CHECKS_H

#include <cgal_blend/blend_mesh.h>

#include "triangle_topology.h"

#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

// The parts of validation that are worth a test of their own.

namespace cgal_blend::internal {

/// Faces of a mesh with their vertices in flat arrays; `corner 3 i` is the source of the halfedge of face i.
struct Face_table {
  std::vector<Face> faces;
  std::vector<Triangle> triangles;
};

/// Pieces of a closed mesh.
struct Components {
  std::size_t count = 0;
  std::vector<std::uint32_t> of_face;  ///< by face index
  std::vector<double> volume;          ///< signed, per component
};

using Face_pair = std::pair<Face, Face>;  ///< the smaller index first

/// Returns the pairs of faces that meet in more than a shared vertex or edge, sorted. Degenerate faces are left out.
[[nodiscard]] std::vector<Face_pair> intersecting_pairs(const Blend_mesh& mesh);

/// Same, for pairs of which one at least is in `changed`.
[[nodiscard]] std::vector<Face_pair> intersecting_pairs(const Blend_mesh& mesh, const Face_table& table,
                                                        const std::vector<Face>& changed);

/// Returns a point in which the two faces meet, to within rounding.
[[nodiscard]] Point_3 meeting_point(const Blend_mesh& mesh, Face_pair pair);

/// Finds the pieces, numbered by their face of least index, and their volumes.
[[nodiscard]] Components find_components(const Blend_mesh& mesh, const Face_table& table);

/// What has to be known of components that are not all new and clear of each other.
struct Orientation_doubts {
  std::set<std::pair<std::uint32_t, std::uint32_t>> crossing;  ///< pairs that meet, the smaller number first
  std::vector<char> vouched_for;                               ///< per component: not to be judged; empty: judge all
};

/// Returns a component that points the wrong way: outwards where it bounds a cavity, or inwards where it bounds the
/// body; `count` if none does. Components that meet do not enclose each other.
[[nodiscard]] std::size_t misoriented_component(const Blend_mesh& mesh, const Face_table& table,
                                                const Components& components, const Orientation_doubts& doubts);

}  // namespace cgal_blend::internal

#endif
