// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_NEAR_FACES_H
#define CGAL_BLEND_SRC_NEAR_FACES_H

#include <cgal_blend/blend_mesh.h>

#include <limits>
#include <utility>
#include <vector>

namespace cgal_blend {

/// What counts as rounding, as a fraction of the largest coordinate of two bodies: 64 units in the last place. Turning
/// and moving a body in doubles takes some 4.
inline constexpr double rounding_fraction = 64 * std::numeric_limits<double>::epsilon();

/// What counts as rounding between two bodies, length units.
[[nodiscard]] double rounding_tolerance(const Blend_mesh& a, const Blend_mesh& b);

/// Finds the faces of `a` with those of `b` that their bounding boxes meet within the tolerance, sorted.
[[nodiscard]] std::vector<std::pair<Face, Face>> near_faces(const Blend_mesh& a, const Blend_mesh& b, double tolerance);

/// True if the corners of one face lie in the plane of the other within the tolerance.
[[nodiscard]] bool nearly_coplanar(const Blend_mesh& a, Face f, const Blend_mesh& b, Face g, double tolerance);

/// True if two bodies have faces near each other that are coplanar within rounding, but not exactly.
[[nodiscard]] bool coplanar_but_for_rounding(const Blend_mesh& a, const Blend_mesh& b);

}  // namespace cgal_blend

#endif
