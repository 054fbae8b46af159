// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_BRIDGE_SURFACE_H
#define CGAL_BLEND_SRC_BRIDGE_SURFACE_H

#include "bridge_rays.h"

#include <cgal_blend/bridge.h>

#include <array>
#include <vector>

namespace cgal_blend {

/// Hartmann's function, 1 at t = 0 and 0 at t = 1, with `order` derivatives 0 at both ends.
/// Source: Hartmann, Parametric G^n blending of curves and surfaces, The Visual Computer 17 (2001).
[[nodiscard]] double hartmann(double t, double mu, int order);

/// The free parameters of a bridge.
struct Bridge_shape {
  std::array<double, 2> lambda{0.5, 0.5};
  double mu = 0.5;
  int order = 2;
};

/// One curve s = constant of the blend surface: the two rays that it is made of.
struct Bridge_column {
  std::array<Bridge_ray, 2> ray;

  /// B(t) = f S_1 + (1 - f) S_2, S_1 at x = 1 - t (1 - lambda_1) of its ray, S_2 at x = 1 - (1 - t)(1 - lambda_2).
  [[nodiscard]] Vec point(double t, const Bridge_shape& shape) const;
};

/// The lambdas in [0, most_lambda]^2 at which B(t) is nearest to a point.
[[nodiscard]] std::array<double, 2> nearest_lambdas(const Bridge_column& column, double t, const Bridge_shape& shape,
                                                    const Vec& target);

/// Parameter of the second end's curve for that of the first: both run counter-clockwise seen from outside, which is
/// the opposite way round seen along the bridge. Result in [0, 1).
[[nodiscard]] double opposite_parameter(double s, double turn);

/// The turn at which the closed curves, sampled at equal steps of their parameters, are nearest to each other:
/// the least sum of squared distances between points at s and `opposite_parameter(s, turn)`. In [0, 1).
[[nodiscard]] double least_twist(const std::vector<Vec>& first, const std::vector<Vec>& second);

}  // namespace cgal_blend

#endif
