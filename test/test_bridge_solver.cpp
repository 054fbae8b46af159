// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/bridge.h>

#include "bridge_spheres.h"
#include "bridge_surface.h"
#include "checks.h"

#include <cgal_blend/validate.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;
using cgal_blend::test::pi;  // base_surface.h has one too

double distance(const Point_3& p, const Point_3& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

TEST(Bridge_ray, reproduces_cubics_with_their_derivatives) {
  const auto cubic = [](double x) { return Vec(1 + x - 2 * x * x * x, 3 * x * x - x, 0.5 - x * x * x / 3); };
  const auto slope = [](double x) { return Vec(1 - 6 * x * x, 6 * x - 1, -x * x); };
  std::vector<Vec> knots;
  for (int i = 0; i <= 11; ++i) knots.push_back(cubic(i / 11.0));
  const Bridge_ray ray(knots);
  for (int i = 0; i <= 100; ++i) {
    const double x = i / 100.0;
    EXPECT_LT((ray.point(x) - cubic(x)).norm(), 1e-13);
    EXPECT_LT((ray.derivative(x) - slope(x)).norm(), 1e-11);
  }
}

TEST(Bridge_surface, weights_the_ends_by_hartmanns_function) {
  for (const int n : {1, 2, 3})
    for (const double mu : {0.1, 0.5, 0.8}) {
      EXPECT_EQ(hartmann(0, mu, n), 1);
      EXPECT_EQ(hartmann(1, mu, n), 0);
      EXPECT_NEAR(hartmann(0.5, mu, n), mu, 1e-15);
      EXPECT_NEAR(hartmann(0.3, mu, n) + hartmann(0.7, 1 - mu, n), 1, 1e-15);
      // 1 - f = (1 - mu) / mu t^(n+1) + ...: n derivatives vanish at the contact, and no more.
      const double t = 1e-3;
      EXPECT_NEAR((1 - hartmann(t, mu, n)) / ((1 - mu) / mu * std::pow(t, n + 1)), 1, 0.02);
    }
}

TEST(Bridge_surface, turns_curves_into_least_twist) {
  constexpr std::size_t n = 90;
  const double turn = 0.237;  // between samples
  std::vector<Vec> first, second;
  for (std::size_t k = 0; k < n; ++k) {
    const double a = 2 * pi * static_cast<double>(k) / n;
    first.emplace_back(2 * std::cos(a) + 10, std::sin(a), 100);
    // The point of the first curve that belongs to parameter s of the second one is turn - s.
    const double b = 2 * pi * (turn - static_cast<double>(k) / n);
    second.emplace_back(2 * std::cos(b) + 10, std::sin(b), 103);
  }
  EXPECT_NEAR(least_twist(first, second), turn, 2e-3);
}

class Solver : public testing::Test {
 protected:
  Two_spheres spheres;
  Blend_mesh mesh = spheres.mesh(4);

  [[nodiscard]] Bridge_solver with(const std::array<double, 2>& lambda, double mu = 0.5, int order = 2,
                                   double twist = 0) const {
    auto ends = spheres.ends();
    for (std::size_t k : {0, 1}) ends[k].lambda = lambda[k];
    Bridge_options options;
    options.mu = mu;
    options.order = order;
    options.twist_deg = twist;
    options.segments = 64;
    options.rows = 32;
    return {mesh, ends, options};
  }
};

TEST_F(Solver, comes_to_the_same_shape_by_changes) {
  Bridge_solver changed = with({0.5, 0.5});
  EXPECT_TRUE(changed.set_lambda(0, 0.2));
  EXPECT_TRUE(changed.set_lambda(1, 0.7));
  EXPECT_TRUE(changed.set_mu(0.3));
  EXPECT_TRUE(changed.set_order(3));
  EXPECT_TRUE(changed.set_twist(35));
  const Bridge_solver made = with({0.2, 0.7}, 0.3, 3, 35);
  EXPECT_EQ(changed.points(), made.points());
  Blend_mesh a, b;
  ASSERT_TRUE(changed.build(a).ok());
  ASSERT_TRUE(made.build(b).ok());
  EXPECT_TRUE(identical(a, b));
  EXPECT_TRUE(validate(a).ok());
  ASSERT_TRUE(made.build(b).ok());  // on the cut of before
  EXPECT_TRUE(identical(a, b));
}

TEST_F(Solver, leaves_values_out_of_range_alone) {
  Bridge_solver solver = with({0.5, 0.5});
  const auto before = solver.points();
  EXPECT_FALSE(solver.set_lambda(0, 1));
  EXPECT_FALSE(solver.set_lambda(1, -0.1));
  EXPECT_FALSE(solver.set_lambda(2, 0.5));
  EXPECT_FALSE(solver.set_mu(0));
  EXPECT_FALSE(solver.set_mu(1));
  EXPECT_FALSE(solver.set_order(0));
  EXPECT_FALSE(solver.set_order(4));
  EXPECT_FALSE(solver.set_twist(INFINITY));
  EXPECT_EQ(solver.points(), before);
}

TEST_F(Solver, samples_the_surface) {
  const Bridge_solver solver = with({0.4, 0.6});
  ASSERT_EQ(solver.segments(), 64u);
  ASSERT_EQ(solver.rows(), 32u);
  ASSERT_EQ(solver.points().size(), 33u * 64);
  for (const std::size_t row : {0, 7, 32})
    for (const std::size_t column : {0, 13, 63})
      EXPECT_LT(distance(solver.points()[row * 64 + column],
                         solver.point(static_cast<double>(column) / 64, static_cast<double>(row) / 32)),
                1e-13);
}

TEST_F(Solver, twists_the_second_end) {
  const Bridge_solver plain = with({0.5, 0.5}), twisted = with({0.5, 0.5}, 0.5, 2, 90);
  EXPECT_LT(distance(plain.point(0.1, 0), twisted.point(0.1, 0)), 1e-13);
  EXPECT_LT(distance(plain.point(0.1, 1), twisted.point(0.1 + 0.25, 1)), 1e-9);
}

TEST_F(Solver, drags_the_surface_through_a_point_that_it_can_reach) {
  for (const auto& lambda : {std::array<double, 2>{0.2, 0.7}, {0.9, 0.1}, {0, 0.5}})
    for (const double t : {0.3, 0.5, 0.8}) {
      const Point_3 target = with(lambda).point(0.3, t);
      Bridge_solver solver = with({0.5, 0.5});
      EXPECT_GT(distance(solver.point(0.3, t), target), 1e-3);
      const Drag drag = solver.drag(0.3, t, target);
      EXPECT_TRUE(drag.reached);
      EXPECT_LT(distance(solver.point(0.3, t), target), 1e-6);
      EXPECT_EQ(solver.lambda(), drag.lambda);
    }
}

TEST_F(Solver, drags_as_near_as_it_can) {
  Bridge_solver solver = with({0.5, 0.5});
  const Point_3 target(0.9, 0.2, 1.5);
  const Drag drag = solver.drag(0.3, 0.4, target);
  EXPECT_FALSE(drag.reached);
  EXPECT_NEAR(drag.residual, distance(solver.point(0.3, 0.4), target), 1e-12);
  double least = INFINITY;  // on a fine grid of lambdas
  for (int i = 0; i <= 80; ++i)
    for (int j = 0; j <= 80; ++j) {
      solver.set_lambda(0, std::min(i / 80.0, 0.999999));
      solver.set_lambda(1, std::min(j / 80.0, 0.999999));
      least = std::min(least, distance(solver.point(0.3, 0.4), target));
    }
  EXPECT_LE(drag.residual, least + 1e-6);
  EXPECT_GE(drag.residual, least - 0.01);
}

TEST_F(Solver, has_a_valid_bridge_after_a_drag) {
  Bridge_solver solver = with({0.5, 0.5});
  const Point_3 p = solver.point(0, 0.5);
  (void)solver.drag(0, 0.5, Point_3(1.3 * p.x(), 1.3 * p.y(), p.z()));
  Blend_mesh out;
  ASSERT_TRUE(solver.build(out).ok());
  EXPECT_TRUE(validate(out).ok());
}

TEST_F(Solver, joins_the_zero_angles_where_both_are_given) {
  auto ends = spheres.ends();
  ends[0].zero_direction = Vector_3(1, 0, 0);
  ends[1].zero_direction = Vector_3(0, 1, 0);
  const Bridge_solver solver(mesh, ends);
  ASSERT_TRUE(solver.diagnosis().ok());
  const Point_3 first = solver.point(0, 0), second = solver.point(0, 1);
  EXPECT_NEAR(std::atan2(first.y(), first.x()), 0, 0.02);
  EXPECT_NEAR(std::atan2(second.y(), second.x()), pi / 2, 0.02);
}

}  // namespace
