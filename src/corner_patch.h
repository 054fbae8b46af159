// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_CORNER_PATCH_H
#define CGAL_BLEND_SRC_CORNER_PATCH_H

#include "base_surface.h"
#include "stitching.h"

#include <vector>

namespace cgal_blend {

/// Fills a loop around a ball's centre, such as the great circle arcs in which blends end at a corner, with triangles
/// on the smaller side as seen from the centre; every loop step is an edge of one triangle in its direction. New
/// vertices are at distances from the centre that interpolate the loop's: on the sphere if the loop is.
/// Returns nothing, and adds no vertex, if the loop crosses or touches itself as seen from the centre, lies on a great
/// circle, or is too coarse for the triangles to face the centre.
/// \param spacing of the new vertices, in length units; close to the loop they are as far apart as its own
[[nodiscard]] std::vector<Triangle> tessellate_corner(Blend_mesh& mesh, const Vec& center,
                                                      const std::vector<Vertex>& loop, double spacing);

}  // namespace cgal_blend

#endif
