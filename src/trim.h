// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_TRIM_H
#define CGAL_BLEND_SRC_TRIM_H

#include "cell_map.h"
#include "surface_path.h"

#include <cgal_blend/status.h>

#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <unordered_set>
#include <utility>
#include <vector>

namespace cgal_blend {

/// A curve to cut along, as a polyline on its base surface: a linkage curve, or a part of the border of a blend's end.
/// Open ones join to closed curves by shared vertices.
struct Rim {
  const Base_surface* surface = nullptr;
  int operand = 0;
  Surface_path path;
  bool keep_left = true;          ///< what is kept lies left of the path seen from outside, else right of it
  std::size_t blend = 0;          ///< index of the blend, for reports
  std::vector<Vertex> vertices;   ///< per station; those that are null or missing are filled by `add_rim_vertices`
  std::size_t first = 0;          ///< open linkage curves: ball positions that it has as stations, from here ...
  std::size_t last = static_cast<std::size_t>(-1);  ///< ... to here
};

/// What cutting along the rims takes from a mesh and gives back; the mesh itself is changed by `replace_faces`.
struct Trimming {
  Diagnosis diagnosis;                            ///< located, if it is not `ok`
  std::vector<Face> removed;                      ///< cut faces and those between the rims
  std::vector<std::array<Vertex, 3>> remnants;    ///< triangles that remain of the cut faces
  std::vector<Cell_map::Cell> remnant_cells;      ///< per remnant: the cell that it is a part of
  std::map<Edge, std::vector<Vertex>> divided;    ///< edges that rims cross: their vertices from end to end, in order
};

/// Adds the vertices of the rims to the mesh, or finds them where they stand on vertices of it.
[[nodiscard]] Diagnosis add_rim_vertices(Blend_mesh& mesh, const Cell_map& cells, Rim& rim);

/// Cuts the faces along the rims (constrained Delaunay triangulation of each cell in its plane), and finds by flooding
/// what lies between rims and curves. Kept remnants of a face lie in its plane.
/// \param curves edges of the mesh that the blends replace
/// \param filled directed steps of borders of what goes where new triangles take its place: nothing goes beyond them
[[nodiscard]] Trimming trim(const Blend_mesh& mesh, const Cell_map& cells, const std::vector<Rim>& rims,
                            const std::unordered_set<Edge>& curves,
                            const std::set<std::pair<Vertex, Vertex>>& filled = {});

}  // namespace cgal_blend

#endif
