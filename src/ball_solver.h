// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_BALL_SOLVER_H
#define CGAL_BLEND_SRC_BALL_SOLVER_H

#include "rolling_ball.h"

#include <optional>

namespace cgal_blend {

/// Where a ball position is sought: in the plane through `point` across `direction`, from these feet on.
struct Ball_guess {
  Vec point;
  Vec direction;
  std::array<Surface_point, 2> foot;
};

/// Outcome of one search; `blocked` is where a foot ran into a sharp edge of its surface, if one did.
struct Ball_solution {
  std::optional<Ball_position> position;
  std::optional<Vec> blocked;
};

/// Finds the ball that touches two base surfaces, with its centre in a given plane: a damped Newton iteration in the
/// two feet, which walk over the faces of their surfaces.
class Ball_solver {
 public:
  /// \param distance signed offset along the outward normals: positive where the ball rolls outside the solid
  Ball_solver(const std::array<const Base_surface*, 2>& surfaces, double distance)
      : surfaces_(surfaces), distance_(distance) {}

  [[nodiscard]] Ball_solution solve(const Ball_guess& guess) const;
  [[nodiscard]] double radius() const { return distance_ < 0 ? -distance_ : distance_; }
  [[nodiscard]] double distance() const { return distance_; }
  [[nodiscard]] const Base_surface& surface(int side) const { return *surfaces_[side]; }

 private:
  using Residual = Eigen::Matrix<double, 4, 1>;
  using Feet = std::array<Surface_point, 2>;
  [[nodiscard]] Residual residual(const Feet& feet, const Ball_guess& guess) const;
  [[nodiscard]] std::array<Vec, 2> newton_step(const Feet& feet, const Ball_guess& guess, const Residual& value) const;

  std::array<const Base_surface*, 2> surfaces_;
  double distance_;
};

}  // namespace cgal_blend

#endif
