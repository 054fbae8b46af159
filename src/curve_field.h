// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_CURVE_FIELD_H
#define CGAL_BLEND_SRC_CURVE_FIELD_H

#include "geodesic_field.h"
#include "region_mesh.h"

#include <cstdint>
#include <vector>

namespace cgal_blend {

/// Distances from a curve to its left, up to a limit; angles are arc-length fractions times 2 pi. Between two vertices
/// of the curve fronts run as from a circle with the curve's geodesic curvature there, or as from a straight line where
/// it has none: exact on developable surfaces for straight lines and circles, of second order in the steps of other
/// smooth curves, of first order near corners.
/// \param curve vertices of the seam that the region was cut along, in order
/// \param stretch length of the curve over which curvature is averaged to both sides
[[nodiscard]] Geodesic_field curve_field(const Region_mesh& region, const std::vector<std::int32_t>& curve,
                                         double stretch, double limit);

}  // namespace cgal_blend

#endif
