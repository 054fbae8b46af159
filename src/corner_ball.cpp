// SPDX-License-Identifier: GPL-3.0-or-later
#include "corner_ball.h"

#include "walking_newton.h"

#include <Eigen/Dense>

#include <array>
#include <cmath>

namespace cgal_blend {

namespace {

constexpr double same_ball = 1e-6;     // of the radius
constexpr double least_volume = 1e-3;  // of the normals' determinant: flatter corners have no ball at rest

using Feet = std::array<Surface_point, 3>;
using Residual = Eigen::Matrix<double, 6, 1>;

Vec mean_normal(const Base_surface& surface, const std::vector<Halfedge>& sector) {
  const Blend_mesh& mesh = surface.mesh();
  Vec sum = Vec::Zero();
  for (const Halfedge h : sector) {
    const Base_surface::Frame& f = surface.frame(mesh.face(h));
    const int k = f.halfedge[0] == h ? 0 : f.halfedge[1] == h ? 1 : 2;
    sum += angle_between(f.corner[(k + 1) % 3] - f.corner[k], f.corner[(k + 2) % 3] - f.corner[k]) * f.face_normal;
  }
  return sum.stableNormalized();
}

/// The point of a sector nearest to p, or rather where a walk from there towards p ends.
Surface_point approach(const Base_surface& surface, const std::vector<Halfedge>& sector, const Vec& p) {
  Surface_point best;
  double nearest = -1;
  for (const Halfedge h : sector) {
    const Surface_point at = surface.locate(surface.mesh().face(h), p);
    const double distance = (surface.position(at) - p).norm();
    if (nearest >= 0 && distance >= nearest) continue;
    nearest = distance;
    best = at;
  }
  return nearest > 0 ? surface.walk(best, p - surface.position(best)).end : best;
}

class Corner_solver {
 public:
  Corner_solver(const Base_surface& surface, double distance) : surface_(surface), distance_(distance) {}

  [[nodiscard]] std::optional<Corner_ball> solve(const std::array<const std::vector<Halfedge>*, 3>& sectors) const {
    Eigen::Matrix3d normals;
    for (int i = 0; i < 3; ++i) normals.row(i) = mean_normal(surface_, *sectors[i]);
    if (!(std::abs(normals.determinant()) > least_volume)) return std::nullopt;
    const Vec corner = to_vec(surface_.mesh().point(surface_.mesh().target(sectors[0]->front())));
    const Vec center = corner + normals.colPivHouseholderQr().solve(Vec::Constant(distance_));
    Feet feet;
    for (int i = 0; i < 3; ++i)
      feet[i] = approach(surface_, *sectors[i], center - distance_ * normals.row(i).transpose());
    if (!iterate(feet)) return std::nullopt;
    return Corner_ball{(offset(feet[0]) + offset(feet[1]) + offset(feet[2])) / 3, {feet.begin(), feet.end()}};
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

  bool iterate(Feet& feet) const {
    return walk_to_ball(
        feet, [&](const Feet& at) { return residual(at); },
        [&](const Feet& at, const Residual& value) { return newton_step(at, value); },
        [&](std::size_t, const Surface_point& from, const Vec& displacement) {
          return surface_.walk(from, displacement).end;
        });
  }

  const Base_surface& surface_;
  double distance_;
};

}  // namespace

std::optional<Corner_ball> find_corner_ball(const Base_surface& surface,
                                            const std::vector<std::vector<Halfedge>>& sectors, double distance) {
  if (sectors.size() < 3) return std::nullopt;
  const Corner_solver solver(surface, distance);
  std::optional<Corner_ball> ball = solver.solve({&sectors[0], &sectors[1], &sectors[2]});
  for (std::size_t j = 3; ball && j < sectors.size(); ++j) {
    const auto other = solver.solve({&sectors[0], &sectors[1], &sectors[j]});
    if (!other || (other->center - ball->center).norm() > same_ball * std::abs(distance)) return std::nullopt;
    ball->foot.push_back(other->foot[2]);
  }
  return ball;
}

}  // namespace cgal_blend
