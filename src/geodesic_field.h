// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_GEODESIC_FIELD_H
#define CGAL_BLEND_SRC_GEODESIC_FIELD_H

#include "region_mesh.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace cgal_blend {

/// Geodesic polar coordinates of the vertices of a region; distances are infinite where nothing arrived.
struct Geodesic_field {
  static constexpr double infinite = std::numeric_limits<double>::infinity();

  explicit Geodesic_field(std::size_t vertices) : at(vertices) {}

  struct Value {
    double distance = infinite;
    double angle = 0;  ///< radians in [0, 2 pi)
  };
  std::vector<Value> at;            ///< by vertex
  std::vector<std::int32_t> seeds;  ///< vertices with values to start from
  std::vector<std::int32_t> fixed;  ///< those of them that keep their values
};

/// Brings an angle into [0, 2 pi).
[[nodiscard]] double wrapped(double angle);
/// The way from one angle to another, in (-pi, pi].
[[nodiscard]] double turn(double from, double to);
/// The angle at a share of that way, in [0, 2 pi).
[[nodiscard]] double between(double from, double to, double share);

/// Gives the vertices next to a source vertex their coordinates: lengths of edges, and angles around the vertex scaled
/// to 2 pi, from a direction or, if that is zero, from the first edge on. The source is all surrounded by triangles.
[[nodiscard]] Geodesic_field one_ring(const Region_mesh& region, std::int32_t source, const Vec& zero_direction);

/// Extends coordinates to all vertices up to a distance, nearest first, over triangles unfolded into the plane of a
/// virtual source. Exact where the surface is developable and its geodesics are straight from the source on.
/// Source: Melvaer and Reimers, Geodesic polar coordinates on polygonal meshes (2012), section 3.
void propagate(const Region_mesh& region, double limit, Geodesic_field& field);

}  // namespace cgal_blend

#endif
