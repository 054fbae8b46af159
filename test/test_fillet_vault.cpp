// SPDX-License-Identifier: GPL-3.0-or-later
// A corner of four curved faces with two balls at rest: a vault of spherical faces over a plane, whose rounds are as far
// from what the smaller concentric balls have in common as the rolling ball is large.
#include "edge_blends.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace cgal_blend::test {
namespace {

struct Ball {
  Vec3 center;
  double radius;
};

/// In counterclockwise order; all pass through the apex.
std::vector<Ball> vault_balls(double x, double y, const Vec3& apex) {
  std::vector<Ball> balls;
  for (const Vec3& center : {Vec3(-x, 0, -2), Vec3(0, -y, -2), Vec3(x, 0, -2), Vec3(0, y, -2)})
    balls.push_back({center, (apex - center).norm()});
  return balls;
}

/// Where two of them cross at a height, on the side away from the centres.
Vec3 crossing(const Ball& a, const Ball& b, double z) {
  const auto flat = [&](const Ball& ball) { return Vec3(ball.center.x(), ball.center.y(), z); };
  const Vec3 p = flat(a), q = flat(b), along = (q - p).normalized();
  const double ra = std::sqrt(a.radius * a.radius - std::pow(z - a.center.z(), 2)),
               rb = std::sqrt(b.radius * b.radius - std::pow(z - b.center.z(), 2)), d = (q - p).norm();
  const double t = (ra * ra - rb * rb + d * d) / (2 * d), h = std::sqrt(std::max(0.0, ra * ra - t * t));
  const Vec3 across = along.cross(Vec3::UnitZ());
  return p + t * along + ((p + q).dot(across) < 0 ? h : -h) * across;
}

/// Tessellated in rings; vertices on the surfaces.
Blend_mesh vault(const std::vector<Ball>& balls, const Vec3& apex, std::size_t rings) {
  std::vector<Point_3> points{{apex.x(), apex.y(), apex.z()}, {0, 0, 0}};
  std::vector<Corner_indices> triangles;
  std::vector<std::size_t> above{0};  // one ring after the other; 4 k vertices each
  for (std::size_t k = 1; k <= rings; ++k) {
    const double z = apex.z() * (1 - static_cast<double>(k) / static_cast<double>(rings));
    std::vector<std::size_t> ring;
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3 center(balls[i].center.x(), balls[i].center.y(), z);
      const Vec3 from = crossing(balls[(i + 3) % 4], balls[i], z) - center,
                 to = crossing(balls[i], balls[(i + 1) % 4], z) - center;
      const double turn = std::atan2(from.cross(to).z(), from.dot(to));
      for (std::size_t m = 0; m < k; ++m) {
        const Vec3 p = center + Eigen::AngleAxisd(turn * m / k, Vec3::UnitZ()) * from;
        ring.push_back(points.size());
        points.emplace_back(p.x(), p.y(), p.z());
      }
    }
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t m = 0; m < k; ++m) {
        const std::size_t a = i * k + m, b = (a + 1) % (4 * k), c = i * (k - 1) + m, n = above.size();
        triangles.push_back({ring[a], ring[b], above[c % n]});
        if (m + 1 < k) triangles.push_back({ring[b], above[(c + 1) % n], above[c % n]});
      }
    above = std::move(ring);
  }
  for (std::size_t a = 0; a < above.size(); ++a) triangles.push_back({above[(a + 1) % above.size()], above[a], 1});
  return mesh_of(points, triangles);
}

/// Distance from what balls have in common, by projecting onto them in turn (Dykstra's algorithm).
double distance_to_common_part(const Vec3& p, const std::vector<Ball>& balls) {
  Vec3 at = p;
  std::vector<Vec3> correction(balls.size(), Vec3::Zero());
  for (int round = 0; round < 400; ++round)
    for (std::size_t i = 0; i < balls.size(); ++i) {
      const Vec3 from = at + correction[i], arm = from - balls[i].center;
      at = arm.norm() > balls[i].radius ? Vec3(balls[i].center + balls[i].radius * arm.normalized()) : from;
      correction[i] = from - at;
    }
  return (p - at).norm();
}

TEST(Fillet_vault, UpperEdges) {
  const Vec3 apex(0, 0, 4);
  for (const double y : {12.0, 7.0, 6.0}) {
    const std::vector<Ball> balls = vault_balls(6, y, apex);
    const Blend_mesh mesh = vault(balls, apex, 48);
    ASSERT_TRUE(validate(mesh).ok());
    const std::vector<Edge> edges = edges_where(mesh, [&](const Point_3& p, const Point_3& q) {
      const auto on = [&](const Point_3& at) {  // two balls at least
        return std::count_if(balls.begin(), balls.end(), [&](const Ball& ball) {
                 return std::abs((vec3(at) - ball.center).norm() - ball.radius) < 1e-9;
               }) > 1;
      };
      return on(p) && on(q);
    });
    ASSERT_EQ(edges.size(), 4u * 48);
    for (const double r : {0.2, 0.6}) {
      SCOPED_TRACE("centres " + std::to_string(y) + " off, radius " + std::to_string(r));
      std::vector<Ball> core = balls;
      for (Ball& ball : core) ball.radius -= r;
      const Blended b = blend_all(mesh, {{edges, r}}, 2e-3);
      expect_on(b, r, 1e-2, [&](const Point_3& p) {  // below 1 the base cuts
        return p.z() < 1 ? 0 : distance_to_common_part(vec3(p), core) - r;
      });
      for (const Blend_report& report : b.outcome.blends) EXPECT_LT(report.radius_error, 5e-3);
    }
  }
}

}  // namespace
}  // namespace cgal_blend::test
