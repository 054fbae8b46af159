// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_CUT_PLANE_H
#define CGAL_BLEND_CUT_PLANE_H

#include <cgal_blend/blend_mesh.h>
#include <cgal_blend/status.h>

namespace cgal_blend {

/// A plane that cuts meshes: exactly the points x with (x - point) . normal = 0 for these six doubles. No equation is
/// rounded anywhere, so that which side a vertex is on is decided exactly, also by decimal coordinates typed in.
struct Cut_plane {
  Point_3 point;    ///< any point of the plane
  Vector_3 normal;  ///< points away from what is kept; its length may be anything from 1e-150 to 1e150
};

/// Refuses numbers that are not finite and a normal of no length (`invalid_parameter`).
[[nodiscard]] Diagnosis check(const Cut_plane& plane);

/// Returns the side of the plane that a point is on: 1 where the normal points to, -1 on the side that is kept, 0 exactly
/// on the plane. Exact for finite numbers.
[[nodiscard]] int side_of(const Cut_plane& plane, const Point_3& p);

}  // namespace cgal_blend

#endif
