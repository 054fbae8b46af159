// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_FUSE_BEND_H
#define CGAL_BLEND_SRC_FUSE_BEND_H

#include <cgal_blend/blend_mesh.h>

#include <cstddef>
#include <vector>

namespace cgal_blend {

/// Relaxes a bent transition towards the shape that it has straight, by rotation-aware Laplacian editing (as rigid as
/// possible, smooth rotations). The rings and the vertices of kept faces beside them are the handles, so that tangents follow.
/// Stops before faces turn over.
/// \param mesh in the places wanted, the transition as it is bent to begin with; receives its inner vertices
/// \param straight places of all vertices with the upper side unbent
/// \param first_inner vertices from here on are inside the transition
/// Source: Jin et al. (2006), section 4, after Sorkine et al., Laplacian surface editing (2004); Sorkine and Alexa, As-rigid-as-
/// possible surface modeling (2007); Levi and Gotsman, Smooth rotation enhanced as-rigid-as-possible mesh animation (2015).
void relax_bend(Blend_mesh& mesh, const std::vector<Point_3>& straight, std::size_t first_inner);

}  // namespace cgal_blend

#endif
