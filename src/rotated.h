// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_ROTATED_H
#define CGAL_BLEND_SRC_ROTATED_H

#include <cgal_blend/blend_mesh.h>

#include <cmath>

namespace cgal_blend {

/// Rotates a vector about a unit axis (Rodrigues); angle in radians.
inline Vector_3 rotated(const Vector_3& v, const Vector_3& axis, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return c * v + s * CGAL::cross_product(axis, v) + (1 - c) * (axis * v) * axis;
}

}  // namespace cgal_blend

#endif
