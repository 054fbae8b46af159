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
  Vertex first_inner;  ///< inner vertices follow each other profile by profile
  std::size_t inner_per_profile = 0;
};

/// Tessellates the blend between two rims: one profile per ball position, cut into the surface's rows; between the
/// first and last row and the rims, triangles to every rim vertex. Adds the inner vertices to the mesh.
/// \param rims left and right rim of the curve, with their vertices
[[nodiscard]] Strip tessellate_strip(Blend_mesh& mesh, const Virtual_surface& surface,
                                     const std::array<const Rim*, 2>& rims, double chord_tolerance);

/// A vertex at which a strip is folded along its curve, if there is one: triangles on both sides of an edge that runs
/// across the strip turn against each other by more than `angle` degrees. How a profile bends does not matter.
[[nodiscard]] std::optional<Vec> find_fold(const Blend_mesh& mesh, const Strip& strip, double angle);

/// How far the rims are off the ball, see `Blend_report`; joints over loops of the spine apart.
struct Strip_quality {
  double radius_error = 0;
  double tangency_deg = 0;  ///< largest
  double mean_tangency_deg = 0;
  Vec worst = Vec::Zero();  ///< where the radius error is largest
};
[[nodiscard]] Strip_quality measure_rims(const std::vector<Ball_position>& positions,
                                         const std::array<const Rim*, 2>& rims, double radius);

/// Largest angle between the ends of the profiles and the base faces there, degrees.
[[nodiscard]] double measure_tangency(const Virtual_surface& surface);

}  // namespace cgal_blend

#endif
