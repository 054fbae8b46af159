// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_FILLED_MESH_H
#define CGAL_BLEND_FILLED_MESH_H

#include <cgal_blend/blend_mesh.h>
#include <cgal_blend/status.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cgal_blend {

/// A closed mesh whose holes stand filled while something is built that takes them away.
struct Filled_mesh {
  /// A hole, and what fills it.
  struct Hole {
    std::vector<Vertex> rim;                   ///< in its order, the hole on the right
    std::size_t first = 0;                     ///< faces of the filling: this one,
    std::size_t last = 0;                      ///< up to before that one
    std::vector<std::array<Point_3, 3>> flat;  ///< triangles between vertices of the rim only
  };

  Diagnosis diagnosis;        ///< `ok`, or `input_not_closed` with the hole that cannot be filled
  Blend_mesh mesh;            ///< the faces of the input come first, in their order, then those of the fillings
  std::size_t own_faces = 0;  ///< number of faces of the input
  std::vector<Hole> holes;
};

/// Fills all holes of a mesh with triangles that go on smoothly from the faces around (CGAL's hole filling, with fairing).
/// \param mesh 2-manifold, without removed elements
[[nodiscard]] Filled_mesh fill_mesh(const Blend_mesh& mesh);

/// Says whether a mesh is valid; with holes allowed, whether it is so but for its holes.
/// \param advice appended to the text where holes are refused, which names the first
[[nodiscard]] Diagnosis check_but_for_holes(const Blend_mesh& mesh, bool holes_allowed, const std::string& advice);

/// Returns the point of a filling that lies over a point within the opening, to within a distance of the flat triangles
/// between the rim's vertices; none if the point is in no opening.
[[nodiscard]] std::optional<Point_3> point_on_filling(const Filled_mesh& filled, const Point_3& p, double tolerance);

/// Finds a hole of whose filling something is left.
/// \param origins per face of the result: face of the filled mesh that it is, or is a part of, or `no_origin`
[[nodiscard]] const Filled_mesh::Hole* hole_left(const Filled_mesh& filled, const std::vector<std::uint32_t>& origins);

/// Mean of a hole's vertices.
[[nodiscard]] Point_3 centre(const Filled_mesh& filled, const Filled_mesh::Hole& hole);

}  // namespace cgal_blend

#endif
