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

/// Tessellates the blend between two rims: one profile per ball position, cut into the surface's rows; between the
/// first and last row and the rims, triangles to every rim vertex. Adds the inner vertices to the mesh.
/// \param rims left and right rim of the curve, with their vertices
[[nodiscard]] std::vector<Triangle> tessellate_strip(Blend_mesh& mesh, const Virtual_surface& surface,
                                                     const std::array<const Rim*, 2>& rims, double chord_tolerance);

/// A vertex at which two neighbouring triangles of a strip turn against each other by more than `angle` degrees, if there
/// is one: the strip is folded there.
[[nodiscard]] std::optional<Vec> find_fold(const Blend_mesh& mesh, const std::vector<Triangle>& strip, double angle);

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
