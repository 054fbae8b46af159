// SPDX-License-Identifier: GPL-3.0-or-later
#include "plane_cut.h"

#include "checks.h"
#include "shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;

double length(const Vector_3& v) { return std::sqrt(v.squared_length()); }

Point_3 position(const Blend_mesh& mesh, const Plane_cut& cut, std::size_t v) {
  const std::size_t kept = cut.vertices.size();
  return v < kept ? mesh.point(cut.vertices[v]) : cut.points[v - kept];
}

double area_of_remnants(const Blend_mesh& mesh, const Plane_cut& cut) {
  double sum = 0;
  for (const auto& t : cut.remnants) {
    const Point_3 p = position(mesh, cut, t[0]);
    sum += length(CGAL::cross_product(position(mesh, cut, t[1]) - p, position(mesh, cut, t[2]) - p)) / 2;
  }
  return sum;
}

/// Signed area about the normal.
double area_of_ring(const Blend_mesh& mesh, const Plane_cut& cut, std::size_t ring, const Vector_3& normal) {
  const auto& r = cut.rings[ring];
  const Point_3 origin = position(mesh, cut, r[0]);
  Vector_3 sum(0, 0, 0);
  for (std::size_t i = 0; i < r.size(); ++i)
    sum = sum +
          CGAL::cross_product(position(mesh, cut, r[i]) - origin, position(mesh, cut, r[(i + 1) % r.size()]) - origin);
  return sum * normal / length(normal) / 2;
}

/// The border of what is kept, counted from triangles alone, is the rings, reversed: none of them is divided or left out.
bool rings_are_the_border(const Blend_mesh& mesh, const Plane_cut& cut) {
  std::map<std::pair<std::size_t, std::size_t>, int> uses;
  std::map<Vertex, std::size_t> index;
  for (std::size_t i = 0; i < cut.vertices.size(); ++i) index[cut.vertices[i]] = i;
  const auto use = [&](std::size_t a, std::size_t b, std::size_t c) {
    ++uses[{a, b}];
    ++uses[{b, c}];
    ++uses[{c, a}];
  };
  for (const Face f : cut.faces) {
    const Face_corners c = corners_of(mesh, f);
    use(index.at(Vertex(c[0])), index.at(Vertex(c[1])), index.at(Vertex(c[2])));
  }
  for (const auto& t : cut.remnants) use(t[0], t[1], t[2]);
  for (const auto& ring : cut.rings)
    for (std::size_t i = 0; i < ring.size(); ++i) ++uses[{ring[i], ring[(i + 1) % ring.size()]}];
  return std::all_of(uses.begin(), uses.end(), [&](const auto& use) {
    const auto opposite = uses.find({use.first.second, use.first.first});
    return use.second == 1 && opposite != uses.end() && opposite->second == 1;
  });
}

TEST(Plane_cut, decides_sides_exactly) {
  // 0.1 + 0.2 is not 0.3 in doubles: the plane through (0, 0, 0.3) lies one unit in the last place below that point.
  const Cut_plane plane{{0, 0, 0.3}, {0, 0, 1e-9}};
  EXPECT_EQ(side_of(plane, {5, -7, 0.1 + 0.2}), 1);
  EXPECT_EQ(side_of(plane, {5, -7, 0.3}), 0);
  EXPECT_EQ(side_of(plane, {5, -7, std::nextafter(0.3, 0.0)}), -1);
  // On x + y = 1 exactly, and beside it by less than doubles can tell at that size.
  const Cut_plane slanted{{1, 0, 0}, {1, 1, 0}};
  EXPECT_EQ(side_of(slanted, {1e16 + 2, -1e16, 0}), 1);
  EXPECT_EQ(side_of(slanted, {0.75, 0.25, 9}), 0);
  EXPECT_EQ(side_of(slanted, {0.75, std::nextafter(0.25, 0.0), 9}), -1);
}

TEST(Plane_cut, divides_a_cylinder_at_a_right_angle) {
  const Blend_mesh mesh = cylinder(2, 48, 0, 5, 4);
  const Cut_plane plane{{0, 0, 3.3}, {0, 0, 2}};
  const Plane_cut result = cut(mesh, plane);
  ASSERT_TRUE(result.ok()) << message(result.diagnosis);
  ASSERT_EQ(result.rings.size(), 1u);
  EXPECT_TRUE(rings_are_the_border(mesh, result));
  // Every new vertex is on the tessellated cylinder and in the plane; remnants fill the wall up to it.
  for (const Point_3& p : result.points) {
    EXPECT_NEAR(p.z(), 3.3, 1e-14);
    const double radius = std::hypot(p.x(), p.y());
    EXPECT_LE(radius, 2 + 1e-14);
    EXPECT_GE(radius, 2 * std::cos(pi / 48) - 1e-14);
  }
  const double side = 2 * 2 * std::sin(pi / 48), disk = 48 * 2 * 2 * std::sin(pi / 48) * std::cos(pi / 48);
  EXPECT_NEAR(area_of(mesh, result.faces) + area_of_remnants(mesh, result), 48 * side * 3.3 + disk, 1e-2);
  EXPECT_GT(area_of_ring(mesh, result, 0, plane.normal), 0);
  EXPECT_TRUE(std::is_sorted(result.faces.begin(), result.faces.end()));
}

TEST(Plane_cut, keeps_the_side_that_the_normal_points_away_from) {
  const Blend_mesh mesh = sphere(1, 3);
  const Cut_plane up{{0.1, 0.2, 0.3}, {1, 2, 3}}, down{{0.1, 0.2, 0.3}, {-1, -2, -3}};
  const Plane_cut a = cut(mesh, up), b = cut(mesh, down);
  ASSERT_TRUE(a.ok() && b.ok());
  EXPECT_EQ(a.vertices.size() + b.vertices.size(), mesh.number_of_vertices());
  for (const Vertex v : a.vertices) EXPECT_LT((mesh.point(v) - up.point) * up.normal, 0);
  EXPECT_TRUE(rings_are_the_border(mesh, a) && rings_are_the_border(mesh, b));
  // Tidied rings may cut corners by a share of an edge.
  EXPECT_NEAR(area_of(mesh, a.faces) + area_of_remnants(mesh, a) + area_of(mesh, b.faces) + area_of_remnants(mesh, b),
              area_of(mesh), 1e-3 * area_of(mesh));
}

TEST(Plane_cut, finds_nested_rings) {
  const Blend_mesh mesh = torus(2, 0.5, 40, 20);
  const Cut_plane plane{{0, 0, 0.07}, {0, 0, 1}};
  const Plane_cut result = cut(mesh, plane);
  ASSERT_TRUE(result.ok());
  ASSERT_EQ(result.rings.size(), 2u);
  EXPECT_TRUE(rings_are_the_border(mesh, result));
  const double a = area_of_ring(mesh, result, 0, plane.normal), b = area_of_ring(mesh, result, 1, plane.normal);
  const double half = std::sqrt(0.25 - 0.07 * 0.07);
  EXPECT_NEAR(std::max(a, b), pi * (2 + half) * (2 + half), 0.02 * 20);
  EXPECT_NEAR(std::min(a, b), -pi * (2 - half) * (2 - half), 0.02 * 8);
}

TEST(Plane_cut, finds_all_rings_of_a_section) {
  Blend_mesh mesh = side_by_side(cylinder(1, 24, 0, 4, 2), transformed(cylinder(1, 24, 0, 4, 2), moved_by(5, 0, 0)));
  mesh = side_by_side(mesh, transformed(torus(1, 0.3, 24, 12), placement({1, 0, 0}, pi / 2, {10, 0, 2})));
  const Plane_cut result = cut(mesh, {{0, 0, 2.1}, {0, 0, 1}});
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result.rings.size(), 4u);
  EXPECT_TRUE(rings_are_the_border(mesh, result));
  EXPECT_EQ(section(mesh, {{0, 0, 2.1}, {0, 0, 1}}).size(), 4u);
}

TEST(Plane_cut, tidies_short_edges_of_rings) {
  // Just below a vertex of valence six all edges from it are cut close together.
  const Blend_mesh mesh = sphere(1, 4);
  const Vertex top = *std::max_element(mesh.vertices().begin(), mesh.vertices().end(), [&](Vertex a, Vertex b) {
    return mesh.point(a).x() + 0.3 * mesh.point(a).y() < mesh.point(b).x() + 0.3 * mesh.point(b).y();
  });
  const Point_3 p = mesh.point(top);
  const Cut_plane plane{{p.x(), p.y(), p.z() - 1e-7}, {0.1, 0.2, 1}};
  const Plane_cut result = cut(mesh, plane);
  ASSERT_TRUE(result.ok()) << message(result.diagnosis);
  EXPECT_TRUE(rings_are_the_border(mesh, result));
  for (const auto& ring : result.rings) {
    const std::size_t n = ring.size();
    std::vector<double> edges;
    for (std::size_t i = 0; i < n; ++i)
      edges.push_back(length(position(mesh, result, ring[(i + 1) % n]) - position(mesh, result, ring[i])));
    EXPECT_GT(*std::min_element(edges.begin(), edges.end()), 1e-3 * *std::max_element(edges.begin(), edges.end()));
  }
  for (const Point_3& q : result.points) EXPECT_NEAR((q - plane.point) * plane.normal, 0, 1e-14);
}

TEST(Plane_cut, refuses_what_is_no_clean_cut) {
  const Blend_mesh mesh = cylinder(1, 24, 0, 3, 2);
  EXPECT_EQ(cut(mesh, {{0, 0, 9}, {0, 0, 1}}).diagnosis.status, Status::plane_misses_mesh);
  EXPECT_EQ(cut(mesh, {{0, 0, -9}, {0, 0, 1}}).diagnosis.status, Status::plane_misses_mesh);
  const Plane_cut through = cut(mesh, {{0, 0, 0.5}, {1, 0, 0}});
  EXPECT_EQ(through.diagnosis.status, Status::plane_meets_vertex);
  ASSERT_TRUE(through.diagnosis.point);
  EXPECT_EQ(through.diagnosis.point->x(), 0);
  EXPECT_EQ(cut(mesh, {{0, 0, 0}, {0, 0, 1}}).diagnosis.status, Status::plane_meets_vertex) << "along the base";
  Blend_mesh open = mesh;
  for (const Face f : open.faces()) {
    double low = 9, high = -9;
    for (const std::size_t v : corners_of(open, f)) {
      low = std::min(low, open.point(Vertex(v)).z());
      high = std::max(high, open.point(Vertex(v)).z());
    }
    if (low < 1.3 && high > 1.3) {
      CGAL::Euler::remove_face(open.halfedge(f), open);
      break;
    }
  }
  open.collect_garbage();
  EXPECT_EQ(cut(open, {{0, 0, 1.3}, {0, 0, 1}}).diagnosis.status, Status::section_not_closed);
}

TEST(Plane_cut, takes_planar_holes_for_rings) {
  // A tube without its lid: the caps' fans are all that is at z = 3.
  Blend_mesh open = transformed(cylinder(1, 24, 0, 3, 2), placement({1, 2, 3}, 0.7, {4, 5, 6}));
  const Vector_3 up = placement({1, 2, 3}, 0.7, {4, 5, 6}).transform(Vector_3(0, 0, 1));
  const Point_3 centre = placement({1, 2, 3}, 0.7, {4, 5, 6}).transform(Point_3(0, 0, 3));
  for (const Face f : open.faces()) {
    bool lid = true;
    for (const std::size_t v : corners_of(open, f)) lid = lid && (open.point(Vertex(v)) - centre) * up > -1e-9;
    if (lid) CGAL::Euler::remove_face(open.halfedge(f), open);
  }
  open.collect_garbage();
  Cut_plane plane{{0, 0, 0}, {0, 0, 1}};
  const Plane_cut result = take_holes(open, plane);
  ASSERT_TRUE(result.ok()) << message(result.diagnosis);
  EXPECT_EQ(result.rings.size(), 1u);
  EXPECT_EQ(result.rings[0].size(), 24u);
  EXPECT_TRUE(rings_are_the_border(open, result));
  EXPECT_NEAR(plane.normal * up, 1, 1e-12) << "away from the tube";
  Blend_mesh bent = open;
  bent.point(result.vertices[result.rings[0][3]]) = bent.point(result.vertices[result.rings[0][3]]) + 1e-3 * up;
  EXPECT_EQ(take_holes(bent, plane).diagnosis.status, Status::opening_not_planar);
  EXPECT_EQ(take_holes(cylinder(1, 8, 0, 1), plane).diagnosis.status, Status::section_not_closed);
}

}  // namespace
