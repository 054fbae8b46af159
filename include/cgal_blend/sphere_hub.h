// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SPHERE_HUB_H
#define CGAL_BLEND_SPHERE_HUB_H

#include <cgal_blend/boundary_models.h>
#include <cgal_blend/quadric.h>
#include <cgal_blend/status.h>

#include <optional>
#include <vector>

namespace cgal_blend {

struct Sphere_hub_options {
  std::optional<Point_3> centre;  ///< none: the point nearest in sum of squares to the axes of the curves, each through
                                  ///< its centroid along its area vector
  std::optional<double> radius;   ///< length units, > 0; none: half the least distance from centre to curve
  double spread = 0.7;            ///< circles' angular radius, of half the least angle between two of them, in (0, 1);
                                  ///< at most 60 degrees
};

/// A sphere with a circle towards each of several boundary curves: blending each curve to its circle joins them all.
struct Sphere_hub {
  Diagnosis diagnosis;  ///< `ok`; or `curves_do_not_correspond`, `blends_overlap`, `invalid_parameter`
  Quadric_3 sphere = Quadric_3::sphere({0, 0, 0}, 1);
  Point_3 centre;
  double radius = 0;
  std::vector<Boundary_curve> circles;  ///< on the sphere, in the order of the curves

  [[nodiscard]] bool ok() const noexcept { return diagnosis.ok(); }
};

/// Places a sphere between closed curves, two or more. Its coefficients are those of the rounded centre and radius.
/// Source: Cheng, Gao, Constructing blending surfaces for two arbitrary surfaces (2003), section 6, figure 14.
[[nodiscard]] Sphere_hub sphere_between(const std::vector<Boundary_curve>& curves,
                                        const Sphere_hub_options& options = {});

}  // namespace cgal_blend

#endif
