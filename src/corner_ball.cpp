// SPDX-License-Identifier: GPL-3.0-or-later
#include "corner_ball.h"

#include "walking_newton.h"

#include <Eigen/Dense>

#include <array>
#include <cmath>

namespace cgal_blend {

namespace {

using Feet = std::array<Surface_point, 3>;
using Residual = Eigen::Matrix<double, 6, 1>;

/// The point of a sector nearest to p, or rather where a walk from there towards p ends.
Surface_point approach(const Base_surface& surface, const std::vector<Halfedge>& sector, const Vec& p,
                       std::optional<Vec>& blocked) {
  Surface_point best;
  double nearest = -1;
  for (const Halfedge h : sector) {
    const Surface_point at = surface.locate(surface.mesh().face(h), p);
    const double distance = (surface.position(at) - p).norm();
    if (nearest >= 0 && distance >= nearest) continue;
    nearest = distance;
    best = at;
  }
  if (!(nearest > 0)) return best;
  const Base_surface::Walk walk = surface.walk(best, p - surface.position(best));
  if (walk.blocked != Blend_mesh::null_halfedge()) blocked = surface.position(walk.end);
  return walk.end;
}

class Corner_solver {
 public:
  Corner_solver(const Base_surface& surface, double distance) : surface_(surface), distance_(distance) {}

  [[nodiscard]] Corner_solution solve(const std::array<const std::vector<Halfedge>*, 3>& sectors,
                                      const Vec& center) const {
    Corner_solution solution;
    Feet feet;
    for (int i = 0; i < 3; ++i)
      feet[i] =
          approach(surface_, *sectors[i], center - distance_ * sector_normal(surface_, *sectors[i]), solution.blocked);
    if (iterate(feet, solution.blocked))
      solution = {Corner_ball{(offset(feet[0]) + offset(feet[1]) + offset(feet[2])) / 3, {feet.begin(), feet.end()}},
                  std::nullopt};
    return solution;
  }

 private:
  [[nodiscard]] double radius() const { return std::abs(distance_); }
  [[nodiscard]] Vec offset(const Surface_point& at) const { return surface_.offset(at, distance_).point; }

  [[nodiscard]] Residual residual(const Feet& feet) const {
    Residual value;
    const Vec first = offset(feet[0]);
    value << (first - offset(feet[1])) / radius(), (first - offset(feet[2])) / radius();
    return value;
  }

  [[nodiscard]] std::array<Vec, 3> newton_step(const Feet& feet, const Residual& value) const {
    Eigen::Matrix<double, 6, 6> jacobian = Eigen::Matrix<double, 6, 6>::Zero();
    std::array<Eigen::Matrix<double, 3, 2>, 3> tangent;
    for (int i = 0; i < 3; ++i) {
      tangent[i] = tangents(surface_.frame(feet[i].face));
      const Eigen::Matrix<double, 3, 2> moved = surface_.offset(feet[i], distance_).derivative * tangent[i] / radius();
      if (i == 0) {
        jacobian.block<3, 2>(0, 0) = jacobian.block<3, 2>(3, 0) = moved;
      } else {
        jacobian.block<3, 2>(3 * (i - 1), 2 * i) = -moved;
      }
    }
    const Residual step = -jacobian.colPivHouseholderQr().solve(value);
    std::array<Vec, 3> result;
    for (int i = 0; i < 3; ++i) result[i] = tangent[i] * step.segment<2>(2 * i);
    limit_steps(result, radius());
    return result;
  }

  bool iterate(Feet& feet, std::optional<Vec>& blocked) const {
    return walk_to_ball(
        feet, [&](const Feet& at) { return residual(at); },
        [&](const Feet& at, const Residual& value) { return newton_step(at, value); },
        [&](std::size_t, const Surface_point& from, const Vec& displacement) {
          const Base_surface::Walk walk = surface_.walk(from, displacement);
          if (walk.blocked != Blend_mesh::null_halfedge()) blocked = surface_.position(walk.end);
          return walk.end;
        });
  }

  const Base_surface& surface_;
  double distance_;
};

}  // namespace

Vec sector_normal(const Base_surface& surface, const std::vector<Halfedge>& sector) {
  const Blend_mesh& mesh = surface.mesh();
  Vec sum = Vec::Zero();
  for (const Halfedge h : sector) {
    const Base_surface::Frame& f = surface.frame(mesh.face(h));
    const int k = f.halfedge[0] == h ? 0 : f.halfedge[1] == h ? 1 : 2;
    sum += angle_between(f.corner[(k + 1) % 3] - f.corner[k], f.corner[(k + 2) % 3] - f.corner[k]) * f.face_normal;
  }
  return sum.stableNormalized();
}

Corner_solution find_corner_ball(const Base_surface& surface,
                                 const std::array<const std::vector<Halfedge>*, 3>& sectors, const Vec& center,
                                 double distance) {
  return Corner_solver(surface, distance).solve(sectors, center);
}

}  // namespace cgal_blend
