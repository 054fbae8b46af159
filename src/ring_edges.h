// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_RING_EDGES_H
#define CGAL_BLEND_SRC_RING_EDGES_H

#include "plane_cut.h"

namespace cgal_blend {

/// Collapses short edges of the rings of a cut where no remnant turns over; points that are left over are removed.
/// \param normals of the faces that the remnants are parts of, one per remnant; of any length > 0
void collapse_short_ring_edges(Plane_cut& cut, const Blend_mesh& mesh, std::vector<Vector_3> normals);

}  // namespace cgal_blend

#endif
