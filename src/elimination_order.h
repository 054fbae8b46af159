// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_ELIMINATION_ORDER_H
#define CGAL_BLEND_SRC_ELIMINATION_ORDER_H

#include "base_surface.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace cgal_blend {

/// A point or plane that is to be found from planes or points found earlier.
struct Eliminated {
  bool is_plane;
  std::size_t index;
  std::vector<std::size_t> earlier;  ///< planes of a point, points of a plane: at most three, independent
};

/// Puts points and planes into an order in which each is bound to at most three earlier ones, so that all can be found
/// in turn: points as intersections of planes, planes as those through points. Bonds for which there is no such order
/// are given up, those of `optional` planes first.
/// \param normals unit normals of the planes
/// \param bonds (point, plane) that are to meet
/// \param first_optional planes from this one on may be given up as a whole
/// \param least_distance points must be so far apart to determine a plane
[[nodiscard]] std::vector<Eliminated> elimination_order(const std::vector<Vec>& points, const std::vector<Vec>& normals,
                                                        const std::vector<std::pair<std::size_t, std::size_t>>& bonds,
                                                        std::size_t first_optional, double least_distance);

}  // namespace cgal_blend

#endif
