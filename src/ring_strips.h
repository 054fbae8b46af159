// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_RING_STRIPS_H
#define CGAL_BLEND_SRC_RING_STRIPS_H

#include "slab_lattice.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace cgal_blend {

/// A transition as triangles, the vertices of the lower rings first, then those of the upper ones.
struct Joined_rings {
  std::vector<Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::optional<Point_3> gap;  ///< where borders and rings are not one to one; the triangles are then void
};

/// Sews strips between the borders of a contour and the rings next to them. Both run side by side, so that the places of
/// the border's vertices along their ring are in order but for small steps back, which are levelled.
[[nodiscard]] Joined_rings join_rings(const Hermite_transition& psi, const Slab_contour& contour);

}  // namespace cgal_blend

#endif
