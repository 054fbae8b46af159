// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_PROPAGATE_CHAIN_H
#define CGAL_BLEND_SRC_PROPAGATE_CHAIN_H

#include <cgal_blend/fillet.h>

#include <vector>

namespace cgal_blend {

/// Continues the chains of blends over edges that go on smoothly, each up to the edges of others; earlier blends grow
/// first. An edge goes on smoothly from another if it is the only further crease at their common vertex, bends to the
/// same side, and turns by less than 25 degrees. The start of a radius law moves along with the end that it is at.
/// \param smooth_angle faces whose normals differ by more make a crease, degrees in (0, 180)
[[nodiscard]] std::vector<Edge_blend> propagate_chains(const Blend_mesh& mesh, std::vector<Edge_blend> blends,
                                                       double smooth_angle);

}  // namespace cgal_blend

#endif
