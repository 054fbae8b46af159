// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_PLANE_CUT_H
#define CGAL_BLEND_SRC_PLANE_CUT_H

#include <cgal_blend/cut_plane.h>
#include <cgal_blend/status.h>

#include <array>
#include <cstddef>
#include <vector>

namespace cgal_blend {

/// A closed curve in which a plane cuts a mesh; the first point is not repeated.
using Section_loop = std::vector<Point_3>;

/// Returns all closed curves in which a plane cuts a closed mesh, in the order of their first edges; each runs counter-clockwise
/// around the side to which the normal points, holes clockwise. Vertices on the plane count as beyond it, so that the
/// curves are closed and do not cross, but may touch there. Open curves of a mesh with holes are left out.
[[nodiscard]] std::vector<Section_loop> section(const Blend_mesh& mesh, const Cut_plane& plane);

/// A mesh without what lies beyond a plane. Indices stand for the kept vertices in their order, then for `points`.
struct Plane_cut {
  /// `plane_misses_mesh`, `plane_meets_vertex`, `section_not_closed`
  Diagnosis diagnosis;
  std::vector<Vertex> vertices;                      ///< vertices of kept faces and of remnants, in their order
  std::vector<Face> faces;                           ///< faces that are kept whole, in their order
  std::vector<Point_3> points;                       ///< new vertices, in the plane but for rounding
  std::vector<std::array<std::size_t, 3>> remnants;  ///< parts of faces that the plane divides
  /// The border in the plane, one loop of indices for each curve of the section, counter-clockwise around the normal;
  /// the kept part is to the right, seen from outside.
  std::vector<std::vector<std::size_t>> rings;

  [[nodiscard]] bool ok() const noexcept { return diagnosis.ok(); }
};

// Edges of a ring shorter than this share of the longest one close by are tidied away: they make slivers of the
// transition, and come from where the plane passes close to a vertex.
inline constexpr double short_ring_edge = 0.15;

/// Cuts a mesh by a plane and keeps the side that the normal points away from. Short edges of the rings are collapsed, if they
/// are to be tidied, where no remnant turns far. What lies on which side is decided exactly; new vertices are rounded.
/// \param mesh without self-intersections; closed but for holes that the plane does not meet
[[nodiscard]] Plane_cut cut(const Blend_mesh& mesh, const Cut_plane& plane, bool tidy = true);

/// Takes the holes of an open mesh for rings: the whole mesh is kept, `points` and `remnants` are empty.
/// \param plane receives the plane of the holes, the normal pointing away from the mesh
/// Refuses `opening_not_planar` if they leave it by more than `planar_hole` of their extent, `section_not_closed` if there are none.
[[nodiscard]] Plane_cut take_holes(const Blend_mesh& mesh, Cut_plane& plane);

inline constexpr double planar_hole = 1e-6;

}  // namespace cgal_blend

#endif
