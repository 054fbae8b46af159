// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_BLEND_CORNERS_H
#define CGAL_BLEND_SRC_BLEND_CORNERS_H

#include "corner_balls.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace cgal_blend {

/// A ball at rest in which blends of several branches meet: along edges, or along spines to other balls of its corner.
struct Blend_corner {
  static constexpr std::size_t no_branch = static_cast<std::size_t>(-1);

  std::vector<std::pair<std::size_t, int>> branches;  ///< branch and its end, counterclockwise seen from outside
  Corner_ball ball;                                   ///< per branch its foot on the faces right of it
  std::vector<Vertex> contact;                        ///< of the feet
  std::vector<Vertex> chain;  ///< where the first branch is a blend of an earlier pass: across that, from left to right
};

/// Tells which branches meet in each of a corner's balls.
/// \param branches along edges, with their ends; each has the sector of its own index right of it
/// \param first_spine index that the branch along the first spine has; those along the others follow
[[nodiscard]] std::vector<Blend_corner> blend_corners(const Corner_balls& balls,
                                                      const std::vector<std::pair<std::size_t, int>>& branches,
                                                      std::size_t first_spine);

}  // namespace cgal_blend

#endif
