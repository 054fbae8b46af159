// SPDX-License-Identifier: GPL-3.0-or-later
// Plane loops, and polygons with inner points: areas by the shoelace formula, edges by counting.
#include "checks.h"
#include "fill_loop.h"
#include "shapes.h"

#include <cgal_blend/validate.h>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace cgal_blend::test {
namespace {

using Outline = std::vector<std::pair<double, double>>;

struct Plane_loop {
  Blend_mesh mesh;
  std::vector<Vertex> loop;
  Vec normal;
  std::optional<std::vector<Triangle>> triangles;

  explicit Plane_loop(const Outline& outline, const Placement& placement = moved_by(0, 0, 0), double bumps = 0)
      : normal(to_vec(CGAL::ORIGIN + placement.transform(Vector_3(0, 0, 1)))) {
    mesh.add_vertex({0, 0, 1e3});  // vertices of the loop need not be the first
    double height = bumps;
    for (const auto& [x, y] : outline) {
      loop.push_back(mesh.add_vertex(placement.transform(Point_3(x, y, height))));
      height = -height;
    }
    triangles = fill_loop(mesh, normal, loop);
  }

  [[nodiscard]] Blend_mesh surface() const {
    std::vector<Point_3> points;
    std::vector<Corner_indices> faces;
    for (const Vertex v : mesh.vertices()) points.push_back(mesh.point(v));
    for (const Triangle& t : *triangles) faces.push_back({t[0], t[1], t[2]});
    return mesh_of(points, faces);
  }
};

double area_of_outline(const Outline& outline) {
  double sum = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const auto [x, y] = outline[i];
    const auto [u, v] = outline[(i + 1) % outline.size()];
    sum += (x * v - u * y) / 2;
  }
  return sum;
}

/// In the plane and turned out of it, small and large.
std::vector<Placement> placements() {
  return {moved_by(0, 0, 0), placement({1, 0, 0}, pi), placement({1, 2, 3}, 1, {10, -20, 30}),
          placement({-2, 1, 0.3}, 2.5, {0, 0, 0}, 1e-3), placement({0.1, 1, -1}, 0.7, {1e6, 0, 0}, 1e6)};
}

void check(const Outline& outline, const std::string& name) {
  SCOPED_TRACE(name);
  int number = 0;
  for (const Placement& place : placements()) {
    SCOPED_TRACE("placement " + std::to_string(number++));
    const Plane_loop filled(outline, place);
    ASSERT_TRUE(filled.triangles.has_value());
    EXPECT_EQ(filled.triangles->size(), outline.size() - 2);
    EXPECT_TRUE(fill_exactly(*filled.triangles, filled.loop));
    const double scale = filled.normal.squaredNorm();
    EXPECT_NEAR(area_of(filled.surface()) / scale, area_of_outline(outline), 1e-8);
    for (const Triangle& t : *filled.triangles) {
      const Vec p = to_vec(filled.mesh.point(t[0]));
      const Vec area = (to_vec(filled.mesh.point(t[1])) - p).cross(to_vec(filled.mesh.point(t[2])) - p);
      EXPECT_GT(area.dot(filled.normal.normalized()), 1e-9 * scale) << "neither turned over nor without area";
    }
    EXPECT_FALSE(Plane_loop({outline.rbegin(), outline.rend()}, place).triangles.has_value()) << "clockwise";
  }
}

TEST(Fill_loop, FillsPolygons) {
  check({{0, 0}, {1, 0}, {0, 1}}, "triangle");
  check({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, "square");
  check({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}, "bracket");
  check({{0, 0}, {4, 0}, {4, 4}, {1, 4}, {1, 2}, {2, 2}, {2, 3}, {3, 3}, {3, 1}, {0, 1}}, "spiral");
  Outline comb{{0, -1}, {20, -1}};
  for (int i = 20; i-- > 0;) comb.insert(comb.end(), {{i + 1.0, 10 - i % 3}, {i + 0.5, 0}});
  comb.push_back({0, 5});
  check(comb, "comb");
}

TEST(Fill_loop, CollinearVerticesSpanNoTriangle) {
  check({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {0, 1}}, "triangle with a divided side");
  check({{0, 0}, {0.1, 0}, {0.3, 0}, {0.7, 0}, {1, 0}, {1, 0.3}, {1, 1}, {0.5, 1}, {0.3, 1}, {0, 1}, {0, 0.9}},
        "square");
  check({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 1}}, "bracket with vertices in line across");
  Outline strip;
  for (int i = 0; i <= 30; ++i) strip.emplace_back(i / 3.0, 0);
  for (int i = 30; i >= 0; --i) strip.emplace_back(i / 3.0, 1);
  check(strip, "strip");
}

TEST(Fill_loop, IsDelaunayInThePlaneOfTheLoop) {
  Outline strip;
  for (int i = 0; i <= 10; ++i) strip.emplace_back(i, 0);
  for (int i = 10; i >= 0; --i) strip.emplace_back(i, 1);
  for (const Placement& place : placements())
    EXPECT_GT(smallest_angle_deg(Plane_loop(strip, place).surface()), 44.99) << "halved squares";
}

TEST(Fill_loop, FillsRandomPolygonsThatAreNearlyPlane) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.2, 1);
  for (int trial = 0; trial < 100; ++trial) {
    const int n = 3 + trial;
    Outline star;
    for (int i = 0; i < n; ++i) {
      const double turn = 2 * pi * (i + 0.5 * uniform(random)) / n, size = uniform(random);
      star.emplace_back(size * std::cos(turn), size * std::sin(turn));
    }
    const Plane_loop filled(star, placement({1, 2, 3}, trial), 1e-3);
    ASSERT_TRUE(filled.triangles.has_value()) << trial;
    EXPECT_TRUE(fill_exactly(*filled.triangles, filled.loop)) << trial;
    EXPECT_EQ(filled.triangles->size(), star.size() - 2);
  }
}

TEST(Fill_loop, ClosesABody) {
  const Outline outline{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {2, 1}, {1, 1}, {1, 2}, {1, 3}, {0, 3}, {0, 1}};
  Blend_mesh body;
  std::vector<Vertex> low, high;
  for (const auto& [x, y] : outline) {
    low.push_back(body.add_vertex({x, y, 0}));
    high.push_back(body.add_vertex({x, y, 1}));
  }
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    body.add_face(low[i], low[j], high[j]);
    body.add_face(low[i], high[j], high[i]);
  }
  const auto top = fill_loop(body, {0, 0, 1}, high), bottom = fill_loop(body, {0, 0, -5}, {low.rbegin(), low.rend()});
  ASSERT_TRUE(top && bottom);
  for (const auto& triangles : {*top, *bottom})
    for (const auto& [a, b, c] : triangles) ASSERT_NE(body.add_face(a, b, c), Blend_mesh::null_face());
  EXPECT_TRUE(validate(body).ok());
  EXPECT_NEAR(volume_of(body), 5, 1e-12);
}

TEST(Fill_loop, RefusesWhatIsNotSimple) {
  const auto refused = [](const Outline& outline) {
    for (const Placement& place : {moved_by(0, 0, 0), placement({1, 0, 0}, pi), placement({0, 1, 0}, pi / 2)})
      if (Plane_loop(outline, place).triangles || Plane_loop({outline.rbegin(), outline.rend()}, place).triangles)
        return false;
    return true;
  };
  EXPECT_TRUE(refused({}));
  EXPECT_TRUE(refused({{0, 0}}));
  EXPECT_TRUE(refused({{0, 0}, {1, 0}}));
  EXPECT_TRUE(refused({{0, 0}, {1, 0}, {2, 0}})) << "in line";
  EXPECT_TRUE(refused({{0, 0}, {2, 0}, {3, 0}, {1, 0}})) << "in line";
  EXPECT_TRUE(refused({{0, 0}, {1, 1}, {1, 0}, {0, 1}})) << "crosses itself";
  EXPECT_TRUE(refused({{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 1}})) << "corners at one place";
  EXPECT_TRUE(refused({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}})) << "a corner on a side";
  EXPECT_TRUE(refused({{0, 0}, {1, 0}, {3, 0}, {1, 0}, {1, 1}})) << "there and back";
  EXPECT_TRUE(refused({{0, 0}, {1, 0}, {2, 0}, {1.5, 0}, {1, 1}})) << "back along a side";
  EXPECT_TRUE(refused({{0, 0}, {1, 0}, {1, 0}, {0, 1}})) << "a step of no length";
  EXPECT_TRUE(refused({{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 0}, {1, 1}})) << "twice around";

  Blend_mesh mesh;
  const std::vector<Vertex> loop{mesh.add_vertex({0, 0, 0}), mesh.add_vertex({1, 0, 0}), mesh.add_vertex({1, 0, 1}),
                                 mesh.add_vertex({0, 1, 0})};
  EXPECT_FALSE(fill_loop(mesh, {0, 0, 1}, loop).has_value()) << "a step along the normal";
  EXPECT_FALSE(fill_loop(mesh, {0, 0, 0}, loop).has_value());
  EXPECT_FALSE(fill_loop(mesh, {0, 0, 1}, {loop[0], loop[1], loop[3], loop[1]}).has_value()) << "a vertex twice";
}

TEST(Fill_loop, InnerPointsAreInside) {
  using Point_2 = Kernel::Point_2;
  const std::vector<Point_2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const auto triangles = triangulate_inside(square, {{0.5, 0.5}, {0.25, 0.5}});
  ASSERT_TRUE(triangles.has_value());
  EXPECT_EQ(triangles->size(), 6U);
  EXPECT_FALSE(triangulate_inside(square, {{1.5, 0.5}}).has_value()) << "outside";
  EXPECT_FALSE(triangulate_inside(square, {{1, 0.5}}).has_value()) << "on a side";
  EXPECT_FALSE(triangulate_inside(square, {{1, 1}}).has_value()) << "at a corner";
  EXPECT_FALSE(triangulate_inside(square, {{0.5, 0.5}, {0.5, 0.5}}).has_value()) << "at one place";
}

}  // namespace
}  // namespace cgal_blend::test
