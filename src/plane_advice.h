// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_PLANE_ADVICE_H
#define CGAL_BLEND_SRC_PLANE_ADVICE_H

#include <cgal_blend/cut_plane.h>

#include <string>

namespace cgal_blend {

/// `plane_misses_mesh`, with the vertex that is nearest to the plane, and how far the plane is to be moved.
[[nodiscard]] Diagnosis plane_that_misses(const Blend_mesh& mesh, const Cut_plane& plane);

/// `plane_meets_vertex`, with a move that frees the plane, if there is one where heights of vertices leave a gap.
[[nodiscard]] Diagnosis plane_that_meets(const Blend_mesh& mesh, const Cut_plane& plane, Vertex v);

}  // namespace cgal_blend

#endif
