// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_CORNER_BALL_H
#define CGAL_BLEND_SRC_CORNER_BALL_H

#include "base_surface.h"

#include <optional>
#include <vector>

namespace cgal_blend {

/// The ball at rest in a corner: it touches every smooth sector of faces around a vertex.
struct Corner_ball {
  Vec center;
  std::vector<Surface_point> foot;  ///< per sector
};

/// Finds the ball that touches all sectors, or nothing if there is none: with three sectors by a Newton iteration in the
/// feet, with more if they happen to have one ball in common.
/// \param sectors per sector its halfedges that point to the vertex, each standing for its face
/// \param distance of the centre from the surface along its normals, negative inside the solid
[[nodiscard]] std::optional<Corner_ball> find_corner_ball(const Base_surface& surface,
                                                          const std::vector<std::vector<Halfedge>>& sectors,
                                                          double distance);

}  // namespace cgal_blend

#endif
