// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_COREFINEMENT_H
#define CGAL_BLEND_SRC_COREFINEMENT_H

#include "cell_map.h"
#include "share_planes.h"

#include <cgal_blend/boolean_operation.h>

#include <array>
#include <cstddef>
#include <vector>

namespace cgal_blend {

/// What corefinement tells about the result of a boolean.
struct Corefinement_record {
  std::array<std::size_t, 2> faces{}, vertices{};     // before corefinement
  std::array<std::vector<Cell_map::Cell>, 2> origin;  // base face of each face, by operand
  std::array<std::vector<Vertex>, 2> vertex_of;       // in the result, by operand
  std::vector<Cell_map::Cell> cell_of_face;           // of the result
  bool coplanar = false;                              // some faces are coplanar
  bool contact = false;                               // some point in common
  bool spread = false;                                // contact beyond vertices, or at vertices not in line
};

/// A mesh with the points to compute with, where these are not its own.
struct Exact_mesh {
  Blend_mesh mesh;
  Blend_mesh::Property_map<Vertex, Exact_point> points;
};

using Edge_marks = Blend_mesh::Property_map<Edge, bool>;

// Two instances of CGAL's corefinement, which take half a minute each to compile.

/// Computes a boolean of two meshes, which are refined on the way; marks the edges where the surfaces meet.
/// \returns false if the result would not be manifold
/// Throws what CGAL throws if the operands cross themselves.
bool corefine(std::array<Blend_mesh, 2>& operands, Boolean_operation operation, Blend_mesh& out, Edge_marks marks,
              Corefinement_record& record);

/// Same, with exact points; those of the meshes themselves stay undefined where there is something new.
bool corefine_exactly(std::array<Exact_mesh, 2>& operands, Boolean_operation operation, Exact_mesh& out,
                      Edge_marks marks, Corefinement_record& record);

}  // namespace cgal_blend

#endif
