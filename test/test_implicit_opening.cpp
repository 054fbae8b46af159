// SPDX-License-Identifier: GPL-3.0-or-later
// Implicit openings: distances against brute force and closed forms, thin plates against a dense solve.
#include "openings.h"
#include "rbf_constraints.h"
#include "segment_tree.h"
#include "thin_plate.h"

#include <gtest/gtest.h>
#include <Eigen/QR>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>
#include <vector>

namespace cgal_blend::test {
namespace {

std::vector<Point_2> random_points(int count, double reach) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-reach, reach);
  std::vector<Point_2> points;
  for (int i = 0; i < count; ++i) points.emplace_back(place(random), place(random));
  return points;
}

std::vector<Ring> jagged_rings() {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> noise(0.8, 1.2);
  std::vector<Ring> rings = rings_of({{1, 0, 0, 200}, {0.5, 0.1, 0, 57}, {0.2, 0.1, 0.05, 9}, {0.7, 3, 1, 4}});
  for (Point_2& p : rings[0]) p = CGAL::ORIGIN + noise(random) * (p - CGAL::ORIGIN);
  return rings;
}

double distance_by_brute_force(const std::vector<Ring>& rings, const Point_2& p) {
  double least = 1e300;
  for (const Ring& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i)
      least = std::min(least, CGAL::squared_distance(Kernel::Segment_2(ring[i], ring[(i + 1) % ring.size()]), p));
  return std::sqrt(least);
}

/// Turns of the rings around a point by the angles that their sides subtend.
bool odd_turns(const std::vector<Ring>& rings, const Point_2& p) {
  int turns = 0;
  for (const Ring& ring : rings) {
    double angle = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const auto u = ring[i] - p, v = ring[(i + 1) % ring.size()] - p;
      angle += std::atan2(u.x() * v.y() - u.y() * v.x(), u * v);
    }
    turns += static_cast<int>(std::lround(std::abs(angle) / (2 * pi)));
  }
  return turns % 2 != 0;
}

TEST(Implicit_opening, distance_agrees_with_brute_force) {
  const std::vector<Ring> rings = jagged_rings();
  const Planar_function f = distance_opening()(rings);
  for (const Point_2& p : random_points(4000, 4)) {
    const double d = distance_by_brute_force(rings, p);
    EXPECT_NEAR(f(p), odd_turns(rings, p) ? -d : d, 1e-14 * 4) << p;
  }
}

TEST(Implicit_opening, weighted_tree_is_the_lower_envelope_of_cones) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<Weighted_segment> segments;
  for (int i = 0; i < 133; ++i) {
    const Point_2 a(number(random), number(random));
    segments.push_back({a, a + Kernel::Vector_2(0.1 * number(random), 0.1 * number(random)), 0.3 * number(random)});
  }
  const Segment_tree tree(segments, 0.4);
  for (const Point_2& p : random_points(2000, 2)) {
    double least = 1e300;
    for (const Weighted_segment& s : segments) {
      const double d = std::sqrt(CGAL::squared_distance(Kernel::Segment_2(s.source, s.target), p));
      least = std::min(least, s.weight + 0.4 * d);
    }
    EXPECT_NEAR(tree(p), least, 1e-14);
  }
}

TEST(Implicit_opening, distance_is_zero_on_rings_and_keeps_its_sign_beside_vertices) {
  const std::vector<Ring> square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  const Planar_function f = distance_opening()(square);
  for (const Point_2& p : square[0]) EXPECT_EQ(f(p), 0);
  EXPECT_EQ(f({0.5, 0}), 0);
  const double tiny = 1e-100;  // lost in any sum, but not in a predicate
  EXPECT_LT(f({tiny, tiny}), 0);
  EXPECT_GT(f({-tiny, tiny}), 0);
  EXPECT_GT(f({1, 2}), 0);  // in line with vertices
  EXPECT_GT(f({-1, 1}), 0);
  EXPECT_GT(f({-1, 0}), 0);
}

TEST(Implicit_opening, nested_rings_alternate) {
  const Planar_function f = distance_opening()(rings_of({{3}, {2}, {1}}));
  EXPECT_NEAR(f({0, 0}), -std::cos(pi / 64), 1e-12);
  EXPECT_GT(f({1.5, 0}), 0.4);
  EXPECT_LT(f({2.5, 0}), -0.4);
  EXPECT_GT(f({3.5, 0}), 0.4);
}

TEST(Implicit_opening, grid_converges_to_the_distance) {
  const std::vector<Ring> rings = rings_of({{1, 0.2, 0.1}, {0.4, 0.2, 0.1}});
  const Planar_function exact = distance_opening()(rings);
  double previous = 0;
  for (const std::size_t cells : {32, 64, 128}) {
    const Planar_function f = distance_grid_opening(cells)(rings);
    double largest = 0;
    for (const Point_2& p : random_points(2000, 1.8)) largest = std::max(largest, std::abs(f(p) - exact(p)));
    EXPECT_LT(largest, 4.0 / static_cast<double>(cells));  // a cell: it is a function of slope 1
    if (previous > 0) {
      EXPECT_LT(largest, 0.7 * previous);
    }
    previous = largest;
  }
  EXPECT_NEAR(distance_grid_opening(64)(rings)({50, 0.1}), 48.8, 2 * 48.8 * 0.02);  // beyond the grid
}

/// The bordered system solved by QR, which does not care about definiteness, in long double.
double dense_reference(const std::vector<Point_2>& centres, const std::vector<double>& values, const Point_2& p) {
  using Matrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
  const auto n = static_cast<Eigen::Index>(centres.size());
  const auto phi = [](const Point_2& a, const Point_2& b) {
    const long double r = std::sqrt(static_cast<long double>(CGAL::squared_distance(a, b)));
    return r > 0 ? r * r * std::log(r) : 0.0L;
  };
  Matrix matrix = Matrix::Zero(n + 3, n + 3), right = Matrix::Zero(n + 3, 1);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Point_2& a = centres[static_cast<std::size_t>(i)];
    for (Eigen::Index j = 0; j < n; ++j) matrix(i, j) = phi(a, centres[static_cast<std::size_t>(j)]);
    matrix.row(i).tail(3) << 1, a.x(), a.y();
    matrix.col(i).tail(3) << 1, a.x(), a.y();
    right(i, 0) = values[static_cast<std::size_t>(i)];
  }
  const Matrix solution = matrix.householderQr().solve(right);
  long double sum = solution(n, 0) + solution(n + 1, 0) * p.x() + solution(n + 2, 0) * p.y();
  for (Eigen::Index i = 0; i < n; ++i) sum += solution(i, 0) * phi(p, centres[static_cast<std::size_t>(i)]);
  return static_cast<double>(sum);
}

TEST(Implicit_opening, thin_plate_agrees_with_a_dense_solve) {
  // Far from the origin and in other units: the spline does not depend on the frame.
  for (const double scale : {1e-3, 1.0, 1e4}) {
    const std::vector<Ring> rings{
        mapped({{ring_of({1, 0, 0, 33})}, std::vector<Ring>{}, std::vector<Ring>{}, 1}, [&](const Point_2& p) {
          return Point_2(p.x() * scale + 3 * scale, p.y() * scale);
        }).rings};
    const std::vector<Rbf_constraint> constraints = rbf_constraints(rings, mean_edge(rings) / 2);
    std::vector<Point_2> centres;
    std::vector<double> values;
    for (const auto& [point, value] : constraints) {
      centres.push_back(point);
      values.push_back(value);
    }
    const Planar_function f = rbf_opening()(rings);
    for (const Point_2& p : {Point_2(3 * scale, 0), Point_2(3.7 * scale, 0.4 * scale), Point_2(1.5 * scale, scale)})
      EXPECT_NEAR(f(p), dense_reference(centres, values, p), 1e-6 * scale);
  }
}

TEST(Implicit_opening, tree_of_a_thin_plate_sums_its_terms) {
  const std::vector<Ring> rings{wavy_ring(1, 0.2, 5, 150)};
  std::vector<Point_2> centres;
  Eigen::VectorXd values(450);
  for (const auto& [point, value] : rbf_constraints(rings, 0.02)) {
    values[static_cast<Eigen::Index>(centres.size())] = value;
    centres.push_back(point);
  }
  const Thin_plate spline(centres, values);
  const Thin_plate_tree tree(spline);
  for (const double reach : {1.3, 5.0, 30.0})  // the last beyond the tree
    for (const Point_2& p : random_points(1000, reach)) EXPECT_NEAR(tree(p), spline(p), 2e-6 * reach * reach);
  for (const Point_2& p : centres) EXPECT_NEAR(tree(p), spline(p), 1e-6);
}

TEST(Implicit_opening, thin_plate_meets_its_constraints) {
  for (const int n : {5, 60, 300, 2000}) {
    const std::vector<Ring> rings{wavy_ring(1, 0.1, 5, n)};
    const double edge = mean_edge(rings);
    const Planar_function f = rbf_opening()(rings);
    double largest = 0;
    for (const Point_2& p : rings[0]) largest = std::max(largest, std::abs(f(p)));
    EXPECT_LE(largest, 0.0101 * edge) << n;
    EXPECT_LT(f({0, 0}), 0);
    EXPECT_GT(f({2, 0}), 0);
  }
}

TEST(Implicit_opening, thin_plate_of_a_circle_vanishes_on_it) {
  const Planar_function f = rbf_opening()(rings_of({{1, 0, 0, 64}}));
  for (int i = 0; i < 400; ++i) {
    const double a = 2 * pi * i / 400;
    // The root along the ray: |f| over its slope, which is about 1 there.
    double low = 0.8, high = 1.2;
    for (int k = 0; k < 50; ++k) {
      const double middle = (low + high) / 2;
      (f({middle * std::cos(a), middle * std::sin(a)}) < 0 ? low : high) = middle;
    }
    EXPECT_NEAR(low, 1, 0.001);
  }
}

TEST(Implicit_opening, thin_plate_keeps_to_long_sides) {
  const std::vector<Ring> box{{{-1, -0.5}, {1, -0.5}, {1, 0.5}, {-1, 0.5}}};
  const Planar_function f = rbf_opening()(box);
  for (double x = -0.9; x < 0.95; x += 0.05)
    for (const double y : {-0.5, 0.5}) EXPECT_NEAR(f({x, y}), 0, 0.04);  // corners make it swing a little
}

TEST(Implicit_opening, offset_points_stay_clear_of_other_walls) {
  // A wall of 0.02 between rings whose edges are 0.1: rho as asked would put points across it.
  const std::vector<Ring> rings = rings_of({{1, 0, 0, 64}, {0.98, 0, 0, 64}});
  const double rho = 0.05;
  int moved = 0;
  for (const auto& [point, value] : rbf_constraints(rings, rho)) {
    const double r = std::hypot(point.x(), point.y());
    if (value == 0) continue;
    EXPECT_EQ(value < 0, odd_turns(rings, point));
    EXPECT_LE(std::abs(value), rho);
    moved += std::abs(value) < 0.99 * rho;
    if (value < 0) {
      EXPECT_NEAR(r, 0.99, 0.0075);  // within the wall, off both faces
    }
  }
  EXPECT_EQ(moved, 128);
  const Planar_function f = rbf_opening({rho})(rings);
  EXPECT_LT(f({0.99, 0}), 0);
  EXPECT_GT(f({0.9, 0}), 0);
  EXPECT_GT(f({1.1, 0}), 0);
}

TEST(Implicit_opening, large_openings_take_few_centres_in_little_time) {
  const auto start = std::chrono::steady_clock::now();
  const Planar_function f = rbf_opening()({wavy_ring(1, 0.3, 5, 2000)});
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  EXPECT_LT(taken.count(), 10);  // a second is promised; sanitizers and other programs take their share
  EXPECT_LT(f({0, 0}), 0);
}

}  // namespace
}  // namespace cgal_blend::test
