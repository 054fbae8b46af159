// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_FILL_HOLES_H
#define CGAL_BLEND_SRC_FILL_HOLES_H

#include "region_mesh.h"

#include <array>
#include <functional>

namespace cgal_blend {

/// Closes holes of the mesh with triangles of the region only, which go on smoothly from the faces around: those with an
/// edge of a triangle that passes the test. The region is not divided yet. Returns whether there were any; holes that
/// cannot be filled stay.
bool fill_holes(Region_mesh& region, const std::function<bool(const std::array<Vec, 3>&)>& belongs);

}  // namespace cgal_blend

#endif
