// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_FILLET_STATIONS_H
#define CGAL_BLEND_SRC_FILLET_STATIONS_H

#include <cgal_blend/fillet.h>

#include <array>
#include <cstddef>
#include <vector>

namespace cgal_blend {

/// Stations nearer than this to a vertex, or to each other, are one, in radii: faces between them would be slivers.
inline constexpr double snap_of_station = 1e-3;

/// A place on a curve of edges.
struct Curve_station {
  std::size_t edge = 0;  ///< in the curve; its number of edges for the end of the last one
  double part = 0;       ///< of that edge from the source of its halfedge on, in [0, 1); 0: that vertex
};

/// What a blend is meant for: a part of one of its curves, or all of its edges if it has no ends of its own.
struct Blend_part {
  std::size_t blend = 0;              ///< whose it is
  bool whole = true;                  ///< all edges of the blend; then the rest is of no interest
  bool left_sharp = false;            ///< it is no longer to be blended, but its curve counts as sharp
  std::vector<Halfedge> curve;        ///< consecutive; a closed one from its start on, twice round if the part needs it
  std::array<Curve_station, 2> ends;  ///< the second lies behind the first
};

/// True if the blend begins or ends within its curves.
[[nodiscard]] inline bool is_partial(const Edge_blend& blend) { return !(blend.from == 0 && blend.to == 1); }

/// Returns `ok`, or `invalid_parameter` if a blend cannot begin and end at its fractions, whatever its curves.
[[nodiscard]] Diagnosis check_range(const Edge_blend& blend);

/// Finds what blends are meant for. Stations nearer to a vertex than a small part of the radius are moved there.
struct Blend_parts {
  Diagnosis diagnosis;  ///< `ok`, or `invalid_parameter`: the start is not on the curve, or nothing is left to blend
  std::vector<Blend_part> parts;
};
[[nodiscard]] Blend_parts find_parts(const Blend_mesh& mesh, const std::vector<Edge_blend>& blends,
                                     const Fillet_options& options);

}  // namespace cgal_blend

#endif
