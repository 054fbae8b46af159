// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_CORNER_BALLS_H
#define CGAL_BLEND_SRC_CORNER_BALLS_H

#include "corner_ball.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace cgal_blend {

/// The balls at rest in a corner all of whose edges bend the same way, and the spines on which a ball rolls from one to
/// the next. Seen as a polygon of the sectors, balls are its parts, and spines the diagonals between these.
struct Corner_balls {
  struct Ball {
    std::vector<std::size_t> sectors;  ///< that it touches, at least three, increasing
    Corner_ball rest;                  ///< its feet are per sector that it touches
  };
  struct Spine {
    std::array<std::size_t, 2> sector;  ///< left and right of it, seen from outside
    std::array<std::size_t, 2> ball;    ///< where it begins and ends
  };

  std::vector<Ball> balls;  ///< none if they are not found
  std::vector<Spine> spines;
  std::optional<Vec> blocked;  ///< where one would have to reach beyond a sharp edge, if that is why
};

/// Finds the balls that touch three sectors or more and cut none: for the tangent planes first, then on the surface.
/// \param sectors counterclockwise seen from outside; per sector its halfedges that point to the vertex, or to one of
/// those that the corner stretches over
/// \param distance of the centres from the surface along its normals, negative inside the solid
[[nodiscard]] Corner_balls find_corner_balls(const Base_surface& surface,
                                             const std::vector<std::vector<Halfedge>>& sectors, double distance);

}  // namespace cgal_blend

#endif
