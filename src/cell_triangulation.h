// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_CELL_TRIANGULATION_H
#define CGAL_BLEND_SRC_CELL_TRIANGULATION_H

#include "base_surface.h"

#include <array>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace cgal_blend {

struct Cell_triangulation {
  std::vector<std::array<Vertex, 3>> triangles;  ///< of the part to keep, oriented as the cell
  std::optional<Point_3> conflict;               ///< where curves cross or the part to keep is not bounded
};

/// Triangulates the part of a planar cell that lies left of the given segments.
/// \param normal of the cell's plane, outward
/// \param border directed steps around the cell, interior to the left; may be incomplete away from the part to keep
/// \param segments directed steps with the part to keep to their left
/// \param inner further vertices inside the cell
[[nodiscard]] Cell_triangulation triangulate_cell(const Blend_mesh& mesh, const Vec& normal,
                                                  const std::vector<std::pair<Vertex, Vertex>>& border,
                                                  const std::vector<std::pair<Vertex, Vertex>>& segments,
                                                  const std::set<Vertex>& inner);

}  // namespace cgal_blend

#endif
