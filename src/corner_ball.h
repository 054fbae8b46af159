// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_CORNER_BALL_H
#define CGAL_BLEND_SRC_CORNER_BALL_H

#include "base_surface.h"

#include <array>
#include <optional>
#include <vector>

namespace cgal_blend {

/// A ball at rest in a corner.
struct Corner_ball {
  Vec center;
  std::vector<Surface_point> foot;  ///< per sector of faces that it touches
};

/// Outcome of the search for a ball at rest; `blocked` is where a foot ran into a sharp edge, if one did.
struct Corner_solution {
  std::optional<Corner_ball> ball;
  std::optional<Vec> blocked;
};

/// Mean of a sector's normals at the vertex, weighted by angle; unit, outward.
/// \param sector halfedges that point to the vertex, each standing for its face
[[nodiscard]] Vec sector_normal(const Base_surface& surface, const std::vector<Halfedge>& sector);

/// Finds the ball that touches three sectors around a vertex by a Newton iteration in its feet.
/// \param center where to begin: the centre for the tangent planes
/// \param distance of the centre from the surface along its normals, negative inside the solid
[[nodiscard]] Corner_solution find_corner_ball(const Base_surface& surface,
                                               const std::array<const std::vector<Halfedge>*, 3>& sectors,
                                               const Vec& center, double distance);

}  // namespace cgal_blend

#endif
