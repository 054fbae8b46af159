// SPDX-License-Identifier: GPL-3.0-or-later
// Geodesic polar coordinates around a point, against surfaces whose geodesics are known.
#include "polar_checks.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace cgal_blend::test {
namespace {

const Vector_3 x_axis(1, 0, 0), z_axis(0, 0, 1);

Geodesic_polar_options along(const Vector_3& direction) {
  Geodesic_polar_options options;
  options.zero_direction = direction;
  return options;
}

/// Polar coordinates of a plane z = constant.
std::function<Polar_point(const Point_3&)> plane_polar(const Point_3& source) {
  return [source](const Point_3& p) {
    const double x = p.x() - source.x(), y = p.y() - source.y();
    return Polar_point{std::hypot(x, y), std::atan2(y, x)};
  };
}

std::vector<Face_point> places_in(Face face) {
  return {{face, {0.2, 0.3, 0.5}}, {face, {0, 1, 0}}, {face, {0, 0.3, 0.7}}, {face, {0.45, 0.55, 0}}};
}

TEST(Geodesic_polar, PlanesAreExactOnIrregularTriangulations) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    const Blend_mesh mesh = irregular_square(24, seed, seed % 2 == 0);
    const Face face = face_near(mesh, {0.1, -0.05, 0});
    for (const Face_point& source : places_in(face)) {
      const Point_3 s = position(mesh, source);
      const Geodesic_polar polar(mesh, source, 0.7, along(x_axis));
      ASSERT_TRUE(polar.diagnosis().ok()) << seed << ": " << message(polar.diagnosis());
      const Polar_errors found = errors(polar, 0, plane_polar(s));
      EXPECT_GT(found.count, 150U);
      EXPECT_LT(found.absolute, 1e-12) << seed;
      EXPECT_LT(found.angle, 1e-12) << seed;
    }
  }
}

TEST(Geodesic_polar, PointsOfAPlaneAreFoundWhereTheyAre) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  const Blend_mesh mesh = irregular_square(20, 5, true);
  for (const Face_point& source : places_in(face_near(mesh, {0, 0, 0}))) {
    const Point_3 s = position(mesh, source);
    const Geodesic_polar polar(mesh, source, 0.8, along(x_axis));
    ASSERT_TRUE(polar.diagnosis().ok());
    for (int i = 0; i < 500; ++i) {
      const Polar_point at{0.8 * std::sqrt(uniform(random)), 40 * uniform(random) - 20};
      const auto found = polar.locate(at);
      ASSERT_TRUE(found.has_value());
      const Point_3 expected(s.x() + at.distance * std::cos(at.angle), s.y() + at.distance * std::sin(at.angle), 0);
      EXPECT_LT(distance_between(position(mesh, *found), expected), 1e-12);
      EXPECT_LT(distance_between(polar.point(at), expected), 1e-12);
      const auto back = polar.coordinates(*found);
      ASSERT_TRUE(back.has_value());
      EXPECT_NEAR(back->distance, at.distance, 1e-12);
    }
    EXPECT_FALSE(polar.locate({0.81, 1}).has_value());
  }
}

/// Faces as large as the body: the disk bends over edges, and all of it is far from vertices.
TEST(Geodesic_polar, CoarseBoxesAreUnfolded) {
  const Blend_mesh mesh = box({-1, -1, -1}, {1, 1, 1});
  const Face top = face_near(mesh, {0.1, 0.1, 1});
  Face_point source{top, {}};
  const Point_3 s(0.7, 0.1, 1);
  const Halfedge h = mesh.halfedge(top);
  const std::array<Point_3, 3> c{mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h))),
                                 mesh.point(mesh.source(h))};
  const auto area = [](const Point_3& p, const Point_3& q, const Point_3& r) {
    return CGAL::cross_product(q - p, r - p).z();
  };
  source.weights = {area(s, c[1], c[2]) / area(c[0], c[1], c[2]), area(c[0], s, c[2]) / area(c[0], c[1], c[2]),
                    area(c[0], c[1], s) / area(c[0], c[1], c[2])};
  ASSERT_GE(*std::min_element(source.weights.begin(), source.weights.end()), 0) << "the other half of the square";
  const Geodesic_polar polar(mesh, source, 0.8, along(x_axis));
  ASSERT_TRUE(polar.diagnosis().ok()) << message(polar.diagnosis());
  for (double angle = -1; angle <= 1; angle += 0.125)
    for (double d = 0.05; d <= 0.8; d += 0.05) {
      const double x = s.x() + d * std::cos(angle), y = s.y() + d * std::sin(angle);
      const Point_3 expected = x <= 1 ? Point_3(x, y, 1) : Point_3(1, y, 2 - x);
      EXPECT_LT(distance_between(polar.point({d, angle}), expected), 1e-12) << d << " " << angle;
    }
}

/// Coordinates on a sphere about the origin.
std::function<Polar_point(const Point_3&)> sphere_polar(double radius, const Point_3& source, const Vector_3& zero) {
  const Vector_3 n = (source - CGAL::ORIGIN) / radius;
  const Vector_3 along = zero - (zero * n) * n, u = along / std::sqrt(along.squared_length());
  const Vector_3 v = CGAL::cross_product(n, u);
  return [=](const Point_3& p) {
    const Vector_3 w = p - CGAL::ORIGIN;
    return Polar_point{radius * std::atan2(std::sqrt(CGAL::cross_product(n, w).squared_length()), n * w),
                       std::atan2(v * w, u * w)};
  };
}

TEST(Geodesic_polar, SpheresConverge) {
  double before = 0;
  for (int level = 3; level <= 6; ++level) {
    const Blend_mesh mesh = sphere(2, level);
    const Vertex source = vertex_near(mesh, {0.3, -0.4, 2});
    const Geodesic_polar polar(mesh, at_vertex(mesh, source), 4, along(x_axis));
    ASSERT_TRUE(polar.diagnosis().ok());
    const Polar_errors found = errors(polar, 0.5, sphere_polar(2, mesh.point(source), x_axis));
    EXPECT_GT(found.count, mesh.number_of_vertices() / 3);
    if (before > 0) {
      EXPECT_GE(std::log2(before / found.mean), 1.0) << level;
    }
    before = found.mean;
    if (level < 5) continue;  // 10 242 vertices from here on
    EXPECT_LT(found.worst, 0.01);
    EXPECT_LT(found.angle, pi / 180);
  }
}

/// Seen along the outside, unrolled: x round the axis, y along it.
std::function<Polar_point(const Point_3&)> cylinder_polar(double radius, const Point_3& source) {
  return [=](const Point_3& p) {
    const double turn = std::remainder(std::atan2(p.y(), p.x()) - std::atan2(source.y(), source.x()), 2 * pi);
    return Polar_point{std::hypot(radius * turn, p.z() - source.z()), std::atan2(p.z() - source.z(), radius * turn)};
  };
}

TEST(Geodesic_polar, CylindersConverge) {
  double before = 0;
  for (const int n : {24, 48, 96}) {
    const Blend_mesh mesh = cylinder(1, n, -4, 4, n);
    const Vertex source = vertex_near(mesh, {1, 0, 0.1});
    const Geodesic_polar polar(mesh, at_vertex(mesh, source), 2.5, along({0, 1, 0}));
    ASSERT_TRUE(polar.diagnosis().ok()) << message(polar.diagnosis());
    const Polar_errors found = errors(polar, 0.3, cylinder_polar(1, mesh.point(source)));
    EXPECT_GT(found.count, static_cast<std::size_t>(n * n / 4));
    if (before > 0) {
      EXPECT_GE(std::log2(before / found.worst), 1.5) << n;
    }
    before = found.worst;
  }
  EXPECT_LT(before, 0.01);
}

TEST(Geodesic_polar, ConesConvergeAwayFromTheApex) {
  double before = 0;
  const double slant = std::sqrt(5.0);
  for (const int n : {24, 48, 96}) {
    std::vector<std::pair<double, double>> outline{{0, 0}};
    for (int k = 0; k <= n; ++k) outline.emplace_back(1 - static_cast<double>(k) / n, 2.0 * k / n);
    outline.back().first = 0;
    const Blend_mesh mesh = turned(outline, n);
    const Vertex source = vertex_near(mesh, {0.5, 0, 1});
    const Point_3 s = mesh.point(source);
    const auto apex_polar = [&](const Point_3& p) {
      return Polar_point{(2 - p.z()) * slant / 2, std::atan2(p.y(), p.x()) / slant};
    };
    const auto truth = [&](const Point_3& p) {  // unrolled about the apex, angle 0 away from it
      const Polar_point a = apex_polar(s), b = apex_polar(p);
      const double x = b.distance * std::cos(b.angle - a.angle) - a.distance,
                   y = b.distance * std::sin(b.angle - a.angle);
      return Polar_point{std::hypot(x, y), std::atan2(y, x)};
    };
    const Geodesic_polar polar(mesh, at_vertex(mesh, source), 0.8, along({1, 0, -2}));
    ASSERT_TRUE(polar.diagnosis().ok()) << message(polar.diagnosis());
    const Polar_errors found = errors(polar, 0.2, truth);
    EXPECT_GT(found.count, static_cast<std::size_t>(n));
    EXPECT_LT(found.angle, pi / 180);
    if (before > 0) {
      EXPECT_GE(std::log2(before / found.worst), 1.0) << n;
    }
    before = found.worst;
  }
  EXPECT_LT(before, 0.01);
}

TEST(Geodesic_polar, LocatingUndoesCoordinates) {
  std::mt19937 random(17);
  const std::vector<Blend_mesh> meshes{sphere(1, 4), grid_box({-1, -1, -1}, {1, 1, 1}, 12), torus(2, 0.7, 80, 40),
                                       box({-1, -1, -1}, {1, 1, 1}), cylinder(1, 48, -1, 1, 3)};
  for (const Blend_mesh& mesh : meshes) {
    int tried = 0;
    for (int spot = 0; spot < 5; ++spot) {
      const Geodesic_polar polar(mesh, random_place(mesh, random), 0.6);
      ASSERT_TRUE(polar.diagnosis().ok()) << message(polar.diagnosis());
      for (int i = 0; i < 2000; ++i) {
        const Face_point at = random_place(mesh, random);
        const auto coordinates = polar.coordinates(at);
        if (!coordinates || coordinates->distance > 0.6) continue;
        const auto back = polar.locate(*coordinates);
        ASSERT_TRUE(back.has_value());
        EXPECT_LT(distance_between(position(mesh, *back), position(mesh, at)), 1e-9);
        EXPECT_LT(distance_between(polar.point(*coordinates), position(mesh, at)), 1e-9);
        ++tried;
      }
    }
    EXPECT_GT(tried, 100);
  }
}

TEST(Geodesic_polar, NothingHappensWhereTheAngleStartsAgain) {
  const Blend_mesh mesh = sphere(1, 4);
  const Geodesic_polar polar(mesh, {Face(7), {0.5, 0.2, 0.3}}, 2);
  ASSERT_TRUE(polar.diagnosis().ok());
  for (double d = 0.1; d <= 2; d += 0.1) {
    EXPECT_LT(distance_between(polar.point({d, -1e-9}), polar.point({d, 1e-9})), 1e-8);
    EXPECT_LT(distance_between(polar.point({d, 0.5}), polar.point({d, 0.5 + 4 * pi})), 1e-12);
    EXPECT_LT(distance_between(polar.point({d, 2 * pi - 1e-9}), polar.point({d, 0})), 1e-8);
  }
}

void expect_works_when_asked_again(const Blend_mesh& mesh, const Face_point& source, const Geodesic_polar& refused) {
  ASSERT_TRUE(refused.diagnosis().max_radius.has_value());
  EXPECT_EQ(*refused.diagnosis().max_radius, refused.safe_radius());
  const Geodesic_polar again(mesh, source, refused.safe_radius());
  EXPECT_TRUE(again.diagnosis().ok()) << message(again.diagnosis());
  EXPECT_EQ(again.safe_radius(), refused.safe_radius());
}

TEST(Geodesic_polar, TubesAreSafeUpToHalfTheirGirth) {
  for (const double rho : {1.0, 0.3})
    for (const int n : {64, 128}) {
      const Blend_mesh mesh = cylinder(rho, n, -8 * rho, 8 * rho, n);
      for (const Face_point& source : places_in(face_near(mesh, {rho, 0, 0}))) {
        const Geodesic_polar polar(mesh, source, 4.5 * rho);
        EXPECT_EQ(polar.diagnosis().status, Status::radius_exceeds_cut_locus);
        EXPECT_LE(polar.safe_radius(), pi * rho);
        EXPECT_GE(polar.safe_radius(), 0.95 * pi * rho);
        ASSERT_TRUE(polar.diagnosis().point.has_value());
        EXPECT_LT(polar.diagnosis().point->x(), -0.8 * rho) << "on the far side";
        expect_works_when_asked_again(mesh, source, polar);
      }
    }
}

/// Long strips: no vertex is near the source or near the cut locus.
TEST(Geodesic_polar, TubesOfLongStripsAreSafeUpToHalfTheirGirth) {
  const Blend_mesh mesh = cylinder(1, 64, -10, 10);
  const Face_point source{face_near(mesh, {1, 0, 2}), {0.3, 0.3, 0.4}};
  const Geodesic_polar polar(mesh, source, 4);
  EXPECT_EQ(polar.diagnosis().status, Status::radius_exceeds_cut_locus);
  EXPECT_LE(polar.safe_radius(), pi);
  EXPECT_GE(polar.safe_radius(), 0.8 * pi);
  expect_works_when_asked_again(mesh, source, polar);
}

TEST(Geodesic_polar, SpheresAreSafeUpToTheOtherPole) {
  for (const double radius : {1.0, 1e-3, 1e6}) {
    const Blend_mesh mesh = sphere(radius, 5);
    for (const Face_point& source : places_in(Face(11))) {
      const Geodesic_polar polar(mesh, source, 3.5 * radius);
      EXPECT_EQ(polar.diagnosis().status, Status::radius_exceeds_cut_locus);
      EXPECT_LE(polar.safe_radius(), pi * radius);
      EXPECT_GE(polar.safe_radius(), 0.9 * pi * radius);
      expect_works_when_asked_again(mesh, source, polar);
    }
  }
}

TEST(Geodesic_polar, BordersBoundTheRadius) {
  const Blend_mesh mesh = irregular_square(20, 9, false);
  const Face_point source{face_near(mesh, {0.4, 0.1, 0}), {0.3, 0.3, 0.4}};
  const Point_3 s = position(mesh, source);
  const Geodesic_polar polar(mesh, source, 0.9);
  EXPECT_EQ(polar.diagnosis().status, Status::region_meets_border);
  EXPECT_NEAR(polar.safe_radius(), 1 - s.x(), 1e-12) << "the nearest side";
  expect_works_when_asked_again(mesh, source, polar);
  EXPECT_TRUE(Geodesic_polar(mesh, source, 0.999 * (1 - s.x())).diagnosis().ok());
}

TEST(Geodesic_polar, SourcesOnABorderAreRefused) {
  const Blend_mesh mesh = irregular_square(6, 2, false);
  for (const Face_point& source : {at_vertex(mesh, Vertex(3)), at_vertex(mesh, Vertex(0))}) {
    const Geodesic_polar polar(mesh, source, 0.1);
    EXPECT_EQ(polar.diagnosis().status, Status::region_meets_border);
    EXPECT_FALSE(polar.diagnosis().max_radius.has_value());
  }
}

/// Takes away the faces around a point.
void punch(Blend_mesh& mesh, const Point_3& at, double radius) {
  for (const Face f : mesh.faces())
    if (distance_between(position(mesh, {f}), at) < radius) CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
  mesh.collect_garbage();
}

TEST(Geodesic_polar, HolesAreRefusedOrFilled) {
  Blend_mesh mesh = irregular_square(24, 4, false);
  punch(mesh, {0.3, 0.2, 0}, 0.12);
  const Face_point source{face_near(mesh, {0, 0, 0}), {0.3, 0.3, 0.4}};
  const Point_3 s = position(mesh, source);
  EXPECT_EQ(Geodesic_polar(mesh, source, 0.7).diagnosis().status, Status::region_meets_border);

  Geodesic_polar_options options = along(x_axis);
  options.fill_holes = true;
  const Geodesic_polar polar(mesh, source, 0.7, options);
  ASSERT_TRUE(polar.diagnosis().ok()) << message(polar.diagnosis());
  const Polar_errors found = errors(polar, 0, plane_polar(s));
  EXPECT_LT(found.absolute, 1e-9);
  EXPECT_LT(found.angle, 1e-9);
  const Polar_point in_hole = plane_polar(s)({0.3, 0.2, 0});
  EXPECT_FALSE(polar.locate(in_hole).has_value());
  EXPECT_LT(distance_between(polar.point(in_hole), {0.3, 0.2, 0}), 1e-9);
  EXPECT_TRUE(polar.locate({in_hole.distance, in_hole.angle + 1}).has_value());
}

TEST(Geodesic_polar, FilledHolesGoOnSmoothly) {
  Blend_mesh mesh = sphere(1, 5);
  punch(mesh, {0.6, 0, 0.8}, 0.2);
  const Vertex source = vertex_near(mesh, {0, 0, 1});
  Geodesic_polar_options options = along(x_axis);
  options.fill_holes = true;
  const Geodesic_polar polar(mesh, at_vertex(mesh, source), 1.5, options);
  ASSERT_TRUE(polar.diagnosis().ok()) << message(polar.diagnosis());
  const Polar_errors found = errors(polar, 0.5, sphere_polar(1, mesh.point(source), x_axis));
  EXPECT_LT(found.worst, 0.01);
  EXPECT_LT(found.angle, pi / 90) << "behind the hole";
}

TEST(Geodesic_polar, NonsenseIsRefused) {
  const Blend_mesh mesh = sphere(1, 2);
  const auto status = [&](const Face_point& source, double radius) {
    return Geodesic_polar(mesh, source, radius).diagnosis().status;
  };
  EXPECT_EQ(status({Face(0)}, 0), Status::invalid_parameter);
  EXPECT_EQ(status({Face(0)}, -1), Status::invalid_parameter);
  EXPECT_EQ(status({Face(0)}, std::nan("")), Status::invalid_parameter);
  EXPECT_EQ(status({Face(100000)}, 1), Status::invalid_parameter);
  EXPECT_EQ(status({Face()}, 1), Status::invalid_parameter);
  EXPECT_EQ(status({Face(0), {0.5, 0.7, -0.2}}, 1), Status::invalid_parameter);
  EXPECT_EQ(status({Face(0), {0.5, 0.7, 0.2}}, 1), Status::invalid_parameter);
  EXPECT_EQ(status({Face(0)}, 1), Status::ok);
}

TEST(Geodesic_polar, MotionAndScaleChangeNothing) {
  const Blend_mesh mesh = torus(2, 0.7, 60, 30);
  const Face_point source{Face(100), {0.2, 0.3, 0.5}};
  const Geodesic_polar polar(mesh, source, 0.9, along(z_axis));
  ASSERT_TRUE(polar.diagnosis().ok());
  for (const double scale : {1.0, 1e-3, 1e6}) {
    const Placement move = placement({1, 2, 3}, 0.7, {3, -4, 5}, scale);
    const Blend_mesh moved = transformed(mesh, move);
    const Geodesic_polar again(moved, source, 0.9 * scale, along(z_axis.transform(move)));
    ASSERT_TRUE(again.diagnosis().ok());
    std::size_t covered = 0;
    for (const Vertex v : mesh.vertices()) {
      if (!polar.covers(v)) continue;
      ++covered;
      ASSERT_TRUE(again.covers(v));
      EXPECT_NEAR(again(v).distance, scale * polar(v).distance, 1e-9 * scale);
      EXPECT_NEAR(std::remainder(again(v).angle - polar(v).angle, 2 * pi), 0, 1e-9);
    }
    EXPECT_GT(covered, 50U);
  }
}

TEST(Geodesic_polar, SameInputSameCoordinates) {
  const Blend_mesh mesh = torus(2, 0.7, 60, 30);
  const Face_point source{Face(100), {0.2, 0.3, 0.5}};
  const Geodesic_polar one(mesh, source, 1), two(mesh, source, 1);
  for (const Vertex v : mesh.vertices()) {
    ASSERT_EQ(one.covers(v), two.covers(v));
    if (!one.covers(v)) continue;
    EXPECT_EQ(one(v).distance, two(v).distance);
    EXPECT_EQ(one(v).angle, two(v).angle);
  }
}

}  // namespace
}  // namespace cgal_blend::test
