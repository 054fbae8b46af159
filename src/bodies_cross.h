// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_BODIES_CROSS_H
#define CGAL_BLEND_SRC_BODIES_CROSS_H

#include <cgal_blend/blend_mesh.h>

namespace cgal_blend {

/// False if the bounding boxes of the pieces of a mesh are apart, so that they cannot cross.
[[nodiscard]] bool bodies_may_cross(const Blend_mesh& mesh);

}  // namespace cgal_blend

#endif
