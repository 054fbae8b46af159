// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_STITCHING_H
#define CGAL_BLEND_SRC_STITCHING_H

#include <cgal_blend/blend_mesh.h>

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace cgal_blend {

using Triangle = std::array<Vertex, 3>;

/// Replaces faces of a closed mesh by triangles on its vertices, so that the mesh is closed and 2-manifold again. Costs
/// time in proportion to what is replaced. Vertices left without a face are removed; elements are marked as removed,
/// not reused, so that the order of all others stays.
struct Replacement {
  std::vector<Face> faces;         ///< one per triangle, in order
  std::optional<Vertex> conflict;  ///< a vertex where the triangles do not fit; the mesh is then unusable
};
[[nodiscard]] Replacement replace_faces(Blend_mesh& mesh, const std::vector<Face>& removed,
                                        const std::vector<Triangle>& triangles);

/// A compact copy of a closed mesh with vertices and faces in a chosen order, which gives that of the edges, and where
/// the faces went (null if not listed).
struct Reordered {
  Blend_mesh mesh;
  std::vector<Face> face_of;  ///< indexed by old face
};
/// \param vertices, faces all elements of the mesh that are not removed, in the new order
[[nodiscard]] Reordered reorder(const Blend_mesh& mesh, const std::vector<Vertex>& vertices,
                                const std::vector<Face>& faces);

}  // namespace cgal_blend

#endif
