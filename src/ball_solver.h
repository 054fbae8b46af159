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
  double fraction = 0;  ///< of the blending curve's length, for the radius
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
  /// \param inside the ball rolls inside the solid
  Ball_solver(const std::array<const Base_surface*, 2>& surfaces, const Radius_law& law, bool inside)
      : surfaces_(surfaces), law_(law), sign_(inside ? -1 : 1), radius_(law.largest()) {}

  [[nodiscard]] Ball_solution solve(const Ball_guess& guess) const;
  /// The largest radius.
  [[nodiscard]] double radius() const { return radius_; }
  [[nodiscard]] bool is_constant() const { return law_.is_constant(); }

  /// Of the centre from the surfaces along their outward normals, at a fraction of the curve's length.
  [[nodiscard]] double distance(double fraction = 0) const {
    return sign_ * (law_.is_constant() ? radius_ : law_(fraction));
  }
  [[nodiscard]] const Base_surface& surface(int side) const { return *surfaces_[side]; }

 private:
  using Residual = Eigen::Matrix<double, 4, 1>;
  using Feet = std::array<Surface_point, 2>;
  [[nodiscard]] Residual residual(const Feet& feet, const Ball_guess& guess) const;
  [[nodiscard]] std::array<Vec, 2> newton_step(const Feet& feet, const Ball_guess& guess, const Residual& value) const;

  std::array<const Base_surface*, 2> surfaces_;
  const Radius_law& law_;
  double sign_, radius_;
};

}  // namespace cgal_blend

#endif
