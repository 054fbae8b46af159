// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_SNAP_TO_PLANES_H
#define CGAL_BLEND_SRC_SNAP_TO_PLANES_H

#include <cgal_blend/blend_mesh.h>

namespace cgal_blend {

/// Puts vertices that lie on an axis-parallel flat side of another body but for rounding exactly onto it, so that flush
/// bodies meet. Moves no coordinate by more than 8 units in the last place of the bodies' size.
/// \returns the number of vertices moved
std::size_t snap_to_planes(Blend_mesh& mesh, const Blend_mesh& other);

}  // namespace cgal_blend

#endif
