// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_SLAB_VERIFICATION_H
#define CGAL_BLEND_SRC_SLAB_VERIFICATION_H

#include "hermite_transition.h"

#include <cgal_blend/blend_mesh.h>

#include <array>
#include <cstddef>
#include <vector>

namespace cgal_blend {

/// Centres of facets and middles of inner edges that have Psi = 0 not within a quarter of their mean edge, or have the wrong
/// sign of Psi on a side: there a facet bridges something narrow, lies across a crease, or is no part of the surface.
[[nodiscard]] std::vector<Point_3> doubtful_places(const Hermite_transition& psi, const Blend_mesh& mesh);

/// Vertices - edges + faces of a triangulated surface; vertices of no triangle do not count.
[[nodiscard]] long euler_characteristic(const std::vector<std::array<std::size_t, 3>>& triangles);

}  // namespace cgal_blend

#endif
