// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_BLEND_STRIP_H
#define CGAL_BLEND_SRC_BLEND_STRIP_H

#include "rolling_ball.h"
#include "stitching.h"
#include "trim.h"
#include "virtual_surface.h"

#include <array>
#include <optional>
#include <vector>

namespace cgal_blend {

/// Triangles of a blend between its rims.
struct Strip {
  std::vector<Triangle> triangles;
  Vertex first_inner;                 ///< inner vertices follow each other
  std::vector<std::size_t> profile_of;  ///< per inner vertex
};

/// The border of an open strip at one end, see `Strip_end`.
struct Strip_border {
  std::vector<std::size_t> last;              ///< per row: the outermost profile that it runs through
  std::vector<Vertex> hit;                    ///< per row: the vertex that it ends at
  std::vector<std::vector<Vertex>> between;   ///< per row: further vertices from its end to that of the next one
};

/// Tessellates the blend between two rims: one profile per ball position, cut into rows; between the first and last row
/// and the rims, triangles to every rim vertex. Adds the inner vertices to the mesh.
/// \param rims left and right rim of the curve, with their vertices
/// \param rows parameters of the profiles, see `Virtual_surface::rows`
/// \param ends of an open strip: where its rows begin and end; their first and last vertices are those of the rims
[[nodiscard]] Strip tessellate_strip(Blend_mesh& mesh, const Virtual_surface& surface,
                                     const std::array<const Rim*, 2>& rims, const std::vector<double>& rows,
                                     const std::array<const Strip_border*, 2>& ends = {});

/// A vertex at which a strip is folded along its curve, if there is one: triangles on both sides of an edge that runs
/// across the strip turn against each other by more than `angle` degrees. How a profile bends does not matter, nor do slivers whose height is below `least`: between
/// rim vertices that are near to each other the facets of the base surface decide how they lie.
[[nodiscard]] std::optional<Vec> find_fold(const Blend_mesh& mesh, const Strip& strip, double angle, double least);

/// How far the rims are off the ball, see `Blend_report`; joints over loops of the spine apart.
struct Strip_quality {
  double radius_error = 0;
  double tangency_deg = 0;  ///< largest
  double mean_tangency_deg = 0;
  Vec worst = Vec::Zero();  ///< where the radius error is largest
};
[[nodiscard]] Strip_quality measure_rims(const std::vector<Ball_position>& positions,
                                         const std::array<const Rim*, 2>& rims);

/// Largest angle between the ends of the profiles and the base faces there, degrees.
[[nodiscard]] double measure_tangency(const Virtual_surface& surface);

}  // namespace cgal_blend

#endif
