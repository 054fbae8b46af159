// SPDX-License-Identifier: GPL-3.0-or-later
#include "ball_solver.h"

#include <Eigen/Dense>

#include <cmath>

namespace cgal_blend {

namespace {

constexpr int most_iterations = 60;
constexpr int most_halvings = 8;
constexpr double longest_step = 0.7;       // of the radius
constexpr double solved = 1e-22;           // squared residual, in units of the radius
constexpr double acceptable = 1e-16;

/// Two unit tangents of a face.
Eigen::Matrix<double, 3, 2> tangents(const Base_surface::Frame& frame) {
  Eigen::Matrix<double, 3, 2> t;
  t.col(0) = (frame.corner[1] - frame.corner[0]).stableNormalized();
  t.col(1) = frame.face_normal.cross(t.col(0));
  return t;
}

}  // namespace

Ball_solver::Residual Ball_solver::residual(const Feet& feet, const Ball_guess& guess) const {
  const double away = distance(guess.fraction);
  const Vec a = surfaces_[0]->offset(feet[0], away).point;
  const Vec b = surfaces_[1]->offset(feet[1], away).point;
  Residual value;
  value << (a - b) / radius(), ((a + b) / 2 - guess.point).dot(guess.direction) / radius();
  return value;
}

std::array<Vec, 2> Ball_solver::newton_step(const Feet& feet, const Ball_guess& guess, const Residual& value) const {
  const double away = distance(guess.fraction);
  Eigen::Matrix4d jacobian;
  std::array<Eigen::Matrix<double, 3, 2>, 2> tangent;
  for (int side = 0; side < 2; ++side) {
    tangent[side] = tangents(surfaces_[side]->frame(feet[side].face));
    const Eigen::Matrix<double, 3, 2> moved = surfaces_[side]->offset(feet[side], away).derivative * tangent[side];
    jacobian.block<3, 2>(0, 2 * side) = (side == 0 ? 1 : -1) * moved / radius();
    jacobian.block<1, 2>(3, 2 * side) = guess.direction.transpose() * moved / (2 * radius());
  }
  const Eigen::Vector4d step = -jacobian.colPivHouseholderQr().solve(value);
  std::array<Vec, 2> result{tangent[0] * step.head<2>(), tangent[1] * step.tail<2>()};
  const double length = std::max(result[0].norm(), result[1].norm());
  if (length > longest_step * radius())
    for (Vec& v : result) v *= longest_step * radius() / length;
  return result;
}

Ball_solution Ball_solver::solve(const Ball_guess& guess) const {
  Ball_solution solution;
  Feet feet = guess.foot;
  Residual value = residual(feet, guess);
  for (int iteration = 0; iteration < most_iterations && value.squaredNorm() > solved; ++iteration) {
    const std::array<Vec, 2> step = newton_step(feet, guess, value);
    if (!step[0].allFinite() || !step[1].allFinite()) break;
    bool improved = false;
    double part = 1;
    for (int halving = 0; halving < most_halvings && !improved; ++halving, part /= 2) {
      Feet trial;
      for (int side = 0; side < 2; ++side) {
        const Base_surface::Walk walk = surfaces_[side]->walk(feet[side], part * step[side]);
        trial[side] = walk.end;
        if (walk.blocked != Blend_mesh::null_halfedge()) solution.blocked = surfaces_[side]->position(walk.end);
      }
      const Residual next = residual(trial, guess);
      improved = next.squaredNorm() < value.squaredNorm();
      if (!improved) continue;
      feet = trial;
      value = next;
    }
    if (!improved) break;
  }
  if (!(value.squaredNorm() <= acceptable)) return solution;
  solution.blocked.reset();
  Ball_position ball;
  ball.foot = feet;
  for (int side = 0; side < 2; ++side) ball.contact[side] = surfaces_[side]->position(feet[side]);
  const double away = distance(guess.fraction);
  ball.center = (surfaces_[0]->offset(feet[0], away).point + surfaces_[1]->offset(feet[1], away).point) / 2;
  ball.radius = std::abs(away);
  ball.fraction = guess.fraction;
  ball.across = guess.direction;
  solution.position = ball;
  return solution;
}

}  // namespace cgal_blend
