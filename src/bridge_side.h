// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_BRIDGE_SIDE_H
#define CGAL_BLEND_SRC_BRIDGE_SIDE_H

#include "bridge_rays.h"
#include "trim.h"

#include <cgal_blend/bridge.h>

#include <memory>
#include <optional>
#include <vector>

namespace cgal_blend {

/// One end of a bridge on its mesh: coordinates, and the contact curve as a polyline on the mesh.
struct Bridge_side {
  Diagnosis diagnosis;
  const Base_surface* surface = nullptr;
  std::unique_ptr<Geodesic_polar> polar;
  Polar_curve curve;
  double size = 0;  ///< largest distance of the contact curve from the source, length units
  double step = 0;  ///< distance of the knots on rays, length units
  Rim rim;
  std::vector<double> parameters;  ///< of the curve, per station of the rim, in [0, 1)

  [[nodiscard]] Ray_lifter lifter() const { return {*surface, *polar, step}; }

  [[nodiscard]] Vec contact(double s) const;
  [[nodiscard]] Bridge_ray ray(double s) const { return lifter().ray(curve(s), contact(s)); }
  /// Point of the ray at x in [0, 1] that ends in a given point of the contact curve.
  [[nodiscard]] Vec near_contact(double s, double x, const Vec& place) const;
  /// Largest angle between a tangent plane of the rays along the contact curve and the mesh's own, degrees.
  [[nodiscard]] double tangency_deg() const;
};

/// Sets up an end; refuses `invalid_parameter`, `curve_crosses_itself`, `spot_off_surface`, and what the coordinates do.
/// \param surface lives as long as the result
[[nodiscard]] Bridge_side make_side(const Base_surface& surface, const Bridge_end& end, const Bridge_options& options);

/// The same around a closed curve on the mesh, on its left side.
[[nodiscard]] Bridge_side make_side(const Base_surface& surface, const std::vector<Face_point>& source,
                                    const Bridge_end& end, const Bridge_options& options);

/// Why the options of a bridge, or its ends, cannot be accepted whatever the mesh; `ok` if they can.
[[nodiscard]] Diagnosis check_options(const std::array<Bridge_end, 2>& ends, const Bridge_options& options);

}  // namespace cgal_blend

#endif
