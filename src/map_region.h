// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_MAP_REGION_H
#define CGAL_BLEND_SRC_MAP_REGION_H

#include "virtual_surface.h"

#include <cgal_blend/status.h>

#include <cstddef>
#include <unordered_set>
#include <utility>
#include <vector>

namespace cgal_blend {

inline constexpr std::size_t mapping_attempts = 4;
inline constexpr std::size_t straight_attempts = 2;  ///< of these leave u as mapped

/// What maps a blending region: connectivity stays, vertices move.
struct Region_mapping {
  Diagnosis diagnosis;                           ///< `ok`, `region_not_annular` or `parametrization_folds`
  std::vector<std::pair<Vertex, Vec>> interior;  ///< vertices between the linkage curves, on the surface
  std::vector<std::pair<Vertex, Vec>> border;    ///< vertices just outside, drawn onto a linkage curve
  std::vector<Face> faces;                       ///< of the blending region
  double coarseness = 0;                         ///< largest distance of the surface from the faces, length units
};

/// Maps the region around a closed blending curve onto the virtual blending surface: splits the annulus of all faces at
/// inner vertices along a shortest path between the ends of the longest profile, maps it to a rectangle whose sides are
/// the linkage curves (conformal weights; mean value weights where those fold, by exact predicates), relaxes it in the
/// plane, and places each vertex at S(t, u). Where coarse faces fold in space all the same, vertices slide on S.
/// \param curve the vertices of the curve in order, along the positions
/// \param attempt below `mapping_attempts`: the first is the map as it is, later ones are for coarse meshes that it folds
/// \param between vertices that may lie between the linkage curves, those of the curve among them
/// Source: Liu et al. (2005), section 5; Eck et al. (1995) and Floater (2003) for the weights.
[[nodiscard]] Region_mapping map_region(const Blend_mesh& mesh, const std::vector<Vertex>& curve,
                                        const std::unordered_set<Vertex>& between, const Virtual_surface& surface,
                                        const std::vector<Ball_position>& positions, std::size_t attempt);

}  // namespace cgal_blend

#endif
