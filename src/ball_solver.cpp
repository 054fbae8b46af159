// SPDX-License-Identifier: GPL-3.0-or-later
#include "ball_solver.h"

#include "walking_newton.h"

#include <Eigen/Dense>

#include <cmath>

namespace cgal_blend {

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
  limit_steps(result, radius());
  return result;
}

Ball_solution Ball_solver::solve(const Ball_guess& guess) const {
  Ball_solution solution;
  Feet feet = guess.foot;
  const auto walk = [&](std::size_t side, const Surface_point& from, const Vec& displacement) {
    const Base_surface::Walk walk = surfaces_[side]->walk(from, displacement);
    if (walk.blocked != Blend_mesh::null_halfedge()) solution.blocked = surfaces_[side]->position(walk.end);
    return walk.end;
  };
  if (!walk_to_ball(
          feet, [&](const Feet& at) { return residual(at, guess); },
          [&](const Feet& at, const Residual& value) { return newton_step(at, guess, value); }, walk))
    return solution;
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
