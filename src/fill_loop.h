// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_FILL_LOOP_H
#define CGAL_BLEND_SRC_FILL_LOOP_H

#include "base_surface.h"
#include "stitching.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace cgal_blend {

using Index_triangle = std::array<std::size_t, 3>;

/// Triangulates the inside of a polygon by constrained Delaunay, with exact predicates; indices count the corners, then
/// the inner points. Returns nothing if the polygon is not simple, touches itself or runs clockwise, or if an inner
/// point is not inside or not the only one at its place.
[[nodiscard]] std::optional<std::vector<Index_triangle>> triangulate_inside(const std::vector<Kernel::Point_2>& polygon,
                                                                            const std::vector<Kernel::Point_2>& inner);

/// Triangulates the inside of a nearly planar loop by constrained Delaunay as seen along the normal, without new
/// vertices; every loop step is an edge of one triangle in its direction, no triangle is degenerate. Returns nothing if
/// the loop crosses or touches itself (exact predicates) or runs clockwise as seen against the normal.
/// \param normal outward normal of the triangles, of any length
[[nodiscard]] std::optional<std::vector<Triangle>> fill_loop(const Blend_mesh& mesh, const Vec& normal,
                                                             const std::vector<Vertex>& loop);

}  // namespace cgal_blend

#endif
