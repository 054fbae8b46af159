// SPDX-License-Identifier: GPL-3.0-or-later
// Curves in polar coordinates against the equations of what they draw.
#include "shapes.h"

#include <cgal_blend/polar_curve.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace cgal_blend::test {
namespace {

struct Place {
  double x, y;
};

Place place(const Polar_point& p) { return {p.distance * std::cos(p.angle), p.distance * std::sin(p.angle)}; }

std::vector<std::pair<std::string, Polar_curve>> all_curves() {
  return {{"circle", circle_curve(2)},
          {"ellipse", ellipse_curve(3, 0.5)},
          {"rectangle", rectangle_curve(3, 1, 0.25)},
          {"thin rectangle", rectangle_curve(50, 0.5, 0.5)},
          {"star", star_curve(1, 0.4, 5)},
          {"cross", cross_curve(3, 1, 0.5)},
          {"thin cross", cross_curve(10, 0.2, 0.2)},
          {"spline", spline_curve({{1, 0.3}, {2, 1}, {1.5, 3}, {1, 5}})},
          {"function", function_curve([](double a) { return 1 + 0.5 * std::sin(a); })},
          {"scaled", scaled(cross_curve(3, 1, 0.5), 0.25)}};
}

TEST(Polar_curve, CurvesCloseAfterOneTurnAndRunCounterClockwise) {
  constexpr int steps = 4000;
  for (const auto& [name, curve] : all_curves()) {
    SCOPED_TRACE(name);
    EXPECT_NEAR(curve(0).angle, 0, 1e-12);
    EXPECT_NEAR(curve(1).angle, 2 * pi, 1e-12);
    EXPECT_NEAR(curve(1).distance, curve(0).distance, 1e-12 * curve(0).distance);
    for (int i = 0; i < steps; ++i) {
      const double from = curve(static_cast<double>(i) / steps).angle, to = curve((i + 1.0) / steps).angle;
      EXPECT_GT(to, from);
      EXPECT_LT(to - from, 0.5);
    }
  }
}

/// Jumps would show as steps longer than the curve is at speed: halving the step must halve it.
TEST(Polar_curve, CurvesAreContinuousWithTheirTangents) {
  for (const auto& [name, curve] : all_curves()) {
    SCOPED_TRACE(name);
    double steepest = 0, size = 0;
    constexpr int steps = 1 << 14;
    std::vector<Place> tangents;
    for (int i = 0; i <= steps; ++i) {
      const double s = static_cast<double>(i) / steps, h = 0.25 / steps;
      const Place a = place(curve(s - h)), b = place(curve(s + h));
      tangents.push_back({(b.x - a.x) / (2 * h), (b.y - a.y) / (2 * h)});
      size = std::max(size, std::hypot(tangents.back().x, tangents.back().y));
    }
    for (std::size_t i = 0; i < steps; ++i)
      steepest = std::max(steepest, std::hypot(tangents[i + 1].x - tangents[i].x, tangents[i + 1].y - tangents[i].y));
    EXPECT_LT(steepest, 0.1 * size);  // a corner of a rectangle would turn it by 1.4 of its length
  }
}

TEST(Polar_curve, CircleAndEllipseSatisfyTheirEquations) {
  for (int i = 0; i <= 1000; ++i) {
    EXPECT_EQ(circle_curve(2)(i / 1000.0).distance, 2);
    const Place p = place(ellipse_curve(3, 0.5)(i / 1000.0));
    EXPECT_NEAR(p.x * p.x / 9 + p.y * p.y / 0.25, 1, 1e-12);
  }
}

/// Distance of a point from a box with half sides a, b, negative inside.
double from_box(const Place& p, double a, double b) {
  const double x = std::abs(p.x) - a, y = std::abs(p.y) - b;
  return std::hypot(std::max(x, 0.0), std::max(y, 0.0)) + std::min(std::max(x, y), 0.0);
}

/// Points at distance r from the box that is smaller by r: the definition of the rounded rectangle.
TEST(Polar_curve, RectanglesAreRounded) {
  for (const auto& [a, b, r] : {std::array{3.0, 1.0, 0.25}, std::array{1.0, 2.0, 1.0}, std::array{50.0, 0.5, 0.5}}) {
    const Polar_curve curve = rectangle_curve(a, b, r);
    double widest = 0, highest = 0;
    for (int i = 0; i <= 2000; ++i) {
      const Place p = place(curve(i / 2000.0));
      EXPECT_NEAR(from_box(p, a - r, b - r), r, 1e-13 * a);
      widest = std::max(widest, p.x);
      highest = std::max(highest, p.y);
    }
    EXPECT_NEAR(widest, a, 1e-12);
    EXPECT_NEAR(highest, b, 1e-12);
  }
}

/// Outside a bar's rounded end, inside a corner's arc: by the sharp cross and the circles of its twelve corners.
TEST(Polar_curve, CrossesAreRounded) {
  const double a = 3, b = 1, r = 0.5;
  const Polar_curve curve = cross_curve(a, b, r);
  int straight = 0, outer = 0, inner = 0;
  for (int i = 0; i < 3000; ++i) {
    const Place p = place(curve((i + 0.5) / 3000));
    const double x = std::max(std::abs(p.x), std::abs(p.y)), y = std::min(std::abs(p.x), std::abs(p.y));
    if (x > a - r && y > b - r) {
      EXPECT_NEAR(std::hypot(x - (a - r), y - (b - r)), r, 1e-13);
      ++outer;
    } else if (x < b + r && y > b - r) {
      EXPECT_NEAR(std::hypot(b + r - x, b + r - y), r, 1e-13);
      ++inner;
    } else {
      EXPECT_TRUE(std::abs(x - a) < 1e-13 || std::abs(y - b) < 1e-13) << p.x << " " << p.y;
      ++straight;
    }
  }
  EXPECT_GT(straight, 500);
  EXPECT_NEAR(outer, 2 * inner, 20);  // eight arcs against four, by arc length
}

TEST(Polar_curve, StarsHaveTheirArms) {
  for (int i = 0; i < 100; ++i) {
    const Polar_point p = star_curve(2, 0.4, 7)(i / 100.0);
    EXPECT_NEAR(p.distance, 2 + 0.8 * std::cos(7 * p.angle), 1e-14);
  }
}

/// A cubic spline reproduces itself; its error falls with the fourth power of the step.
TEST(Polar_curve, SplinesPassThroughTheirPointsAndConverge) {
  const auto shape = [](double angle) { return 2 + std::sin(angle) + 0.3 * std::cos(3 * angle); };
  double before = 0;
  for (const int n : {16, 32, 64}) {
    std::vector<Polar_point> points;
    for (int i = 0; i < n; ++i) {
      const double angle = -1 + 2 * pi * (i + 0.2 * std::sin(5.0 * i)) / n;  // not evenly spaced, not from 0
      points.push_back({shape(angle), angle});
    }
    const Polar_curve curve = spline_curve(points);
    for (const Polar_point& p : points) EXPECT_NEAR(curve(p.angle / (2 * pi)).distance, p.distance, 1e-13);
    double error = 0;
    for (int i = 0; i < 1000; ++i)
      error = std::max(error, std::abs(curve(i / 1000.0).distance - shape(2 * pi * i / 1000)));
    if (before > 0) {
      EXPECT_GT(std::log2(before / error), 3.5) << n;
    }
    before = error;
  }
  EXPECT_LT(before, 1e-4);
}

TEST(Polar_curve, SplinesAreSmoothAtTheirKnots) {
  const std::vector<Polar_point> points{{1, 0.3}, {2, 1}, {1.5, 3}, {1, 5}};
  const Polar_curve curve = spline_curve(points);
  const auto value = [&](double angle) { return curve(angle / (2 * pi)).distance; };
  constexpr double h = 1e-4;
  for (const Polar_point& p : points) {
    const double left = (value(p.angle) - 2 * value(p.angle - h) + value(p.angle - 2 * h)) / (h * h),
                 right = (value(p.angle) - 2 * value(p.angle + h) + value(p.angle + 2 * h)) / (h * h);
    EXPECT_NEAR(left, right, 0.05) << "second derivatives from both sides";
    EXPECT_NEAR((value(p.angle) - value(p.angle - h)) / h, (value(p.angle + h) - value(p.angle)) / h, 5e-3);
  }
}

TEST(Polar_curve, ScalingKeepsAngles) {
  const Polar_curve curve = ellipse_curve(2, 1), smaller = scaled(curve, 0.25);
  for (int i = 0; i < 50; ++i) {
    EXPECT_EQ(smaller(i / 50.0).angle, curve(i / 50.0).angle);
    EXPECT_EQ(smaller(i / 50.0).distance, 0.25 * curve(i / 50.0).distance);
  }
}

}  // namespace
}  // namespace cgal_blend::test
