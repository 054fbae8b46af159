// SPDX-License-Identifier: GPL-3.0-or-later
// Geodesic polar coordinates along a curve, against curves whose parallel curves are known.
#include "polar_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace cgal_blend::test {
namespace {

/// The face that a half line from the origin or straight down hits, with weights; `up` along which things are seen.
std::optional<Face_point> place_of(const Blend_mesh& mesh, const Point_3& p, const Vector_3& up) {
  for (const Face f : mesh.faces()) {
    const Halfedge h = mesh.halfedge(f);
    const Point_3 &a = mesh.point(mesh.target(h)), &b = mesh.point(mesh.target(mesh.next(h))),
                  &c = mesh.point(mesh.source(h));
    const auto part = [&](const Vector_3& u, const Vector_3& v) { return CGAL::cross_product(u, v) * up; };
    const double wa = part(b - p, c - p), wb = part(c - p, a - p), wc = part(a - p, b - p), sum = wa + wb + wc;
    if (wa >= 0 && wb >= 0 && wc >= 0 && sum > 0) return Face_point{f, {wa / sum, wb / sum, wc / sum}};
  }
  return std::nullopt;
}

/// A circle in the plane z = 0 about a point, counter-clockwise or clockwise.
std::vector<Face_point> circle_on_square(const Blend_mesh& mesh, double x, double y, double radius, int n, int sign) {
  std::vector<Face_point> curve;
  for (int i = 0; i < n; ++i) {
    const double a = sign * 2 * pi * i / n;
    curve.push_back(*place_of(mesh, {x + radius * std::cos(a), y + radius * std::sin(a), 0}, {0, 0, 1}));
  }
  return curve;
}

TEST(Geodesic_polar_curve, CirclesInPlanesHaveRadialDistances) {
  const Blend_mesh mesh = irregular_square(24, 3, false);
  const double x = 0.07, y = -0.04, radius = 0.4;
  for (const int sign : {1, -1}) {
    const Geodesic_polar polar(mesh, circle_on_square(mesh, x, y, radius, 300, sign), 0.32);
    ASSERT_TRUE(polar.diagnosis().ok()) << message(polar.diagnosis());
    const auto truth = [&](const Point_3& p) {
      return Polar_point{sign * (radius - std::hypot(p.x() - x, p.y() - y)), sign * std::atan2(p.y() - y, p.x() - x)};
    };
    const auto on_left = [&](const Point_3& p) { return truth(p).distance > 1e-3; };
    const Polar_errors found = errors(polar, 0.02, truth, on_left);
    EXPECT_GT(found.count, 50U);
    EXPECT_LT(found.absolute, 1e-3) << "0.3 percent of the distances";
    EXPECT_LT(found.angle, pi / 180);
    for (const Vertex v : mesh.vertices()) {
      const double d = truth(mesh.point(v)).distance;
      if (std::abs(d) > 0.3 || std::abs(d) < 1e-3) continue;
      EXPECT_EQ(polar.covers(v), d > 0) << d;
    }
  }
}

TEST(Geodesic_polar_curve, FinerCurvesAreNearerToTheCircle) {
  const Blend_mesh mesh = irregular_square(16, 3, false);
  double before = 0;
  for (const int n : {60, 120, 240}) {
    const Geodesic_polar polar(mesh, circle_on_square(mesh, 0, 0, 0.3, n, -1), 0.4);
    ASSERT_TRUE(polar.diagnosis().ok()) << message(polar.diagnosis());
    double sum = 0;
    int count = 0;
    for (const Vertex v : mesh.vertices()) {
      const double d = std::hypot(mesh.point(v).x(), mesh.point(v).y()) - 0.3;
      if (d <= 0.05 || d > 0.4) continue;  // nearer, single triangles may have been unfolded
      sum += std::abs(polar(v).distance - d) / d;
      ++count;
    }
    if (before > 0) {
      EXPECT_GE(std::log2(before / (sum / count)), 0.9) << n;
    }
    before = sum / count;
  }
  EXPECT_LT(before, 1e-3);
}

/// The vertices of a cylinder at a height, as a curve; from above counter-clockwise or clockwise.
std::vector<Face_point> ring(const Blend_mesh& mesh, double z, int n, int sign) {
  std::vector<Face_point> curve;
  for (int i = 0; i < n; ++i) {
    const double a = sign * 2 * pi * i / n;
    curve.push_back(at_vertex(mesh, vertex_near(mesh, {std::cos(a), std::sin(a), z})));
  }
  return curve;
}

TEST(Geodesic_polar_curve, RimsOfCylindersMeasureAlongTheAxis) {
  for (const int rings : {0, 7, 31}) {
    const int n = 48;
    const Blend_mesh mesh = cylinder(1, n, -1, 1, rings);
    const Geodesic_polar polar(mesh, ring(mesh, 1, n, -1), 1.5);
    ASSERT_TRUE(polar.diagnosis().ok()) << message(polar.diagnosis());
    const auto truth = [&](const Point_3& p) { return Polar_point{1 - p.z(), -std::atan2(p.y(), p.x())}; };
    const Polar_errors found = errors(polar, 0, truth, [](const Point_3& p) { return p.z() < 1; });
    EXPECT_LT(found.absolute, 1e-12);
    EXPECT_LT(found.angle, 1e-12);
    EXPECT_GE(found.count, static_cast<std::size_t>(rings * n * 2 / 3));
    const double apothem = std::cos(pi / n);  // between two vertices the strips are nearer to the axis
    for (double s = 0; s < 1; s += 0.01) {
      const Point_3 p = polar.point({0.75, 2 * pi * s});
      EXPECT_NEAR(p.z(), 0.25, 1e-12);
      EXPECT_LE(std::hypot(p.x(), p.y()), 1 + 1e-12);
      EXPECT_GE(std::hypot(p.x(), p.y()), apothem - 1e-12);
    }
  }
}

/// Also the other way, over the sharp rim onto the flat side: parallel circles there.
TEST(Geodesic_polar_curve, CurvesLeadOverSharpEdges) {
  const int n = 96;
  const Blend_mesh mesh = cylinder(1, n, -1, 1, 9);
  const Geodesic_polar polar(mesh, ring(mesh, 0.6, n, 1), 0.9);  // upwards: 0.4 of wall, then inwards
  ASSERT_TRUE(polar.diagnosis().ok()) << message(polar.diagnosis());
  for (double s = 0; s < 1; s += 0.013)
    for (double d = 0.05; d < 0.9; d += 0.05) {
      const Point_3 p = polar.point({d, 2 * pi * s});
      const double should_radius = d < 0.4 ? 1 : 1 - (d - 0.4), should_z = d < 0.4 ? 0.6 + d : 1;
      EXPECT_NEAR(std::hypot(p.x(), p.y()), should_radius, 0.01) << d;
      EXPECT_NEAR(p.z(), should_z, 0.01) << d;
      EXPECT_NEAR(std::remainder(std::atan2(p.y(), p.x()) - 2 * pi * s, 2 * pi), 0, pi / 180 / should_radius);
    }
}

TEST(Geodesic_polar_curve, ParallelsOfSpheresConverge) {
  double before = 0;
  for (const int level : {3, 4, 5}) {
    const Blend_mesh mesh = sphere(1, level);
    std::vector<Face_point> curve;
    const int n = 40 << (level - 2);
    const double z = 0.5, rho = std::sqrt(1 - z * z);
    for (int i = 0; i < n; ++i) {
      const double a = -2 * pi * i / n;  // the equator is on the left
      const Vector_3 p(rho * std::cos(a), rho * std::sin(a), z);
      const auto at = place_of(mesh, CGAL::ORIGIN + p, p);
      ASSERT_TRUE(at.has_value());
      curve.push_back(*at);
    }
    const Geodesic_polar polar(mesh, curve, 1.2);
    ASSERT_TRUE(polar.diagnosis().ok()) << message(polar.diagnosis());
    const auto truth = [&](const Point_3& p) {
      return Polar_point{std::asin(z) - std::asin(p.z()), -std::atan2(p.y(), p.x())};
    };
    const Polar_errors found = errors(polar, 0.1, truth, [&](const Point_3& p) { return truth(p).distance > 0.05; });
    EXPECT_GT(found.count, 200U);
    if (before > 0) {
      EXPECT_GE(std::log2(before / found.mean), 0.85) << level;
    }
    before = found.mean;
    if (level < 5) continue;
    EXPECT_LT(found.mean, 0.01);
    EXPECT_LT(found.angle, pi / 180);
  }
}

TEST(Geodesic_polar_curve, LocatingUndoesCoordinates) {
  std::mt19937 random(5);
  const Blend_mesh mesh = irregular_square(20, 8, true);
  const Geodesic_polar polar(mesh, circle_on_square(mesh, 0, 0, 0.3, 200, -1), 0.5);
  ASSERT_TRUE(polar.diagnosis().ok()) << message(polar.diagnosis());
  int tried = 0;
  for (int i = 0; i < 5000; ++i) {
    const Face_point at = random_place(mesh, random);
    const auto coordinates = polar.coordinates(at);
    if (!coordinates || coordinates->distance > 0.5) continue;
    const auto back = polar.locate(*coordinates);
    ASSERT_TRUE(back.has_value());
    EXPECT_LT(distance_between(position(mesh, *back), position(mesh, at)), 1e-9);
    ++tried;
  }
  EXPECT_GT(tried, 500);
  for (double d = 0.05; d < 0.5; d += 0.05) {
    EXPECT_LT(distance_between(polar.point({d, -1e-9}), polar.point({d, 1e-9})), 1e-8);
    EXPECT_LT(distance_between(polar.point({d, 1}), polar.point({d, 1 + 2 * pi})), 1e-12);
  }
}

TEST(Geodesic_polar_curve, DistancesEndWhereTheFrontsMeet) {
  const int n = 64;
  const Blend_mesh mesh = cylinder(1, n, -1, 1, 9);
  const Geodesic_polar polar(mesh, ring(mesh, 0, n, -1), 3);  // down the wall, then to the middle of the bottom
  EXPECT_EQ(polar.diagnosis().status, Status::radius_exceeds_cut_locus);
  EXPECT_LE(polar.safe_radius(), 2);
  EXPECT_GE(polar.safe_radius(), 1.7);
  const Geodesic_polar again(mesh, ring(mesh, 0, n, -1), polar.safe_radius());
  EXPECT_TRUE(again.diagnosis().ok()) << message(again.diagnosis());
}

TEST(Geodesic_polar_curve, BordersBoundTheRadius) {
  const Blend_mesh mesh = irregular_square(20, 9, false);
  const auto curve = circle_on_square(mesh, 0.1, 0, 0.4, 300, -1);
  const Geodesic_polar polar(mesh, curve, 0.8);
  EXPECT_EQ(polar.diagnosis().status, Status::region_meets_border);
  EXPECT_LT(polar.safe_radius(), 0.5 + 1e-3);
  EXPECT_GT(polar.safe_radius(), 0.45);
  EXPECT_TRUE(Geodesic_polar(mesh, curve, polar.safe_radius()).diagnosis().ok());
}

TEST(Geodesic_polar_curve, CurvesThatAreNoneAreRefused) {
  const Blend_mesh mesh = irregular_square(10, 1, false);
  const auto at = [&](double x, double y) { return *place_of(mesh, {x, y, 0}, {0, 0, 1}); };
  const auto status = [&](const std::vector<Face_point>& curve) {
    return Geodesic_polar(mesh, curve, 0.2).diagnosis().status;
  };
  EXPECT_EQ(status({}), Status::invalid_parameter);
  EXPECT_EQ(status({at(0, 0)}), Status::invalid_parameter);
  EXPECT_EQ(status({at(-0.8, 0), at(0.8, 0), at(0, 0.8)}), Status::invalid_parameter) << "steps over many faces";
  std::vector<Face_point> eight;
  for (int i = 0; i < 200; ++i)
    eight.push_back(at(0.4 * std::sin(2 * pi * (i + 0.5) / 200), 0.3 * std::sin(4 * pi * (i + 0.5) / 200)));
  EXPECT_EQ(status(eight), Status::curve_crosses_itself);
}

TEST(Geodesic_polar_curve, ScaleChangesNothing) {
  const Blend_mesh mesh = irregular_square(16, 8, false);
  const auto curve = circle_on_square(mesh, 0, 0, 0.3, 200, -1);
  const Geodesic_polar polar(mesh, curve, 0.4);
  ASSERT_TRUE(polar.diagnosis().ok());
  for (const double scale : {1e-3, 1e6}) {
    const Blend_mesh scaled_mesh = transformed(mesh, placement({1, 2, 3}, 0.7, {3, -4, 5}, scale));
    const Geodesic_polar again(scaled_mesh, curve, 0.4 * scale);
    ASSERT_TRUE(again.diagnosis().ok()) << message(again.diagnosis());
    for (const Vertex v : mesh.vertices()) {
      if (!polar.covers(v)) continue;
      ASSERT_TRUE(again.covers(v));
      EXPECT_NEAR(again(v).distance, scale * polar(v).distance, 1e-7 * scale);
      EXPECT_NEAR(std::remainder(again(v).angle - polar(v).angle, 2 * pi), 0, 1e-6);
    }
  }
}

}  // namespace
}  // namespace cgal_blend::test
