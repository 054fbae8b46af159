// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_SOURCE_CURVE_H
#define CGAL_BLEND_SRC_SOURCE_CURVE_H

#include "region_mesh.h"

#include <cgal_blend/status.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace cgal_blend {

/// A point of a curve, and the face that the curve runs through from there to the next one.
struct Curve_point {
  Face_point at;
  Face step;
};

/// Completes a closed curve so that each step is within a face: where it changes to a neighbouring face, the straight
/// line in the plane of both decides where it crosses the edge. Returns nothing if two faces are not neighbours.
[[nodiscard]] std::optional<std::vector<Curve_point>> complete_curve(const Blend_mesh& mesh,
                                                                     const std::vector<Face_point>& points);

/// Makes a curve a closed chain of edges of a region and cuts the region there, so that only what is to the left of the
/// curve is around its vertices. Returns the first vertex, or why it does not work.
[[nodiscard]] Diagnosis cut_along(Region_mesh& region, const std::vector<Curve_point>& curve, std::int32_t& first);

/// The vertices of the curve that a region was cut along, from one of them on; also those of divided edges.
[[nodiscard]] std::vector<std::int32_t> cut_vertices(const Region_mesh& region, std::int32_t first);

}  // namespace cgal_blend

#endif
