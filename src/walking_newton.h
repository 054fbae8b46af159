// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_WALKING_NEWTON_H
#define CGAL_BLEND_SRC_WALKING_NEWTON_H

#include "base_surface.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace cgal_blend {

/// Two unit tangents of a face.
inline Eigen::Matrix<double, 3, 2> tangents(const Base_surface::Frame& frame) {
  Eigen::Matrix<double, 3, 2> t;
  t.col(0) = (frame.corner[1] - frame.corner[0]).stableNormalized();
  t.col(1) = frame.face_normal.cross(t.col(0));
  return t;
}

/// Shortens the steps of all feet alike, so that none is longer than a share of the radius.
template <std::size_t N>
void limit_steps(std::array<Vec, N>& steps, double radius) {
  constexpr double longest_step = 0.7;  // of the radius
  double length = 0;
  for (const Vec& step : steps) length = std::max(length, step.norm());
  if (length > longest_step * radius)
    for (Vec& step : steps) step *= longest_step * radius / length;
}

/// Damped Newton iteration in the feet of a ball, which walk over the faces of their surfaces; true if it arrives.
/// \param residual of the feet, in units of the radius
/// \param newton_step displacements of the feet, from the feet and their residual
/// \param walk where foot i comes to by a displacement, from (i, foot, displacement)
template <std::size_t N, class Residual, class Newton_step, class Walk>
bool walk_to_ball(std::array<Surface_point, N>& feet, const Residual& residual, const Newton_step& newton_step,
                  const Walk& walk) {
  constexpr int most_iterations = 60, most_halvings = 8;
  constexpr double solved = 1e-22, acceptable = 1e-16;  // squared residual
  auto value = residual(feet);
  for (int iteration = 0; iteration < most_iterations && value.squaredNorm() > solved; ++iteration) {
    const std::array<Vec, N> steps = newton_step(feet, value);
    if (!std::all_of(steps.begin(), steps.end(), [](const Vec& step) { return step.allFinite(); })) break;
    bool improved = false;
    double part = 1;
    for (int halving = 0; halving < most_halvings && !improved; ++halving, part /= 2) {
      std::array<Surface_point, N> trial;
      for (std::size_t i = 0; i < N; ++i) trial[i] = walk(i, feet[i], Vec(part * steps[i]));
      const auto next = residual(trial);
      improved = next.squaredNorm() < value.squaredNorm();
      if (!improved) continue;
      feet = trial;
      value = next;
    }
    if (!improved) break;
  }
  return value.squaredNorm() <= acceptable;
}

}  // namespace cgal_blend

#endif
