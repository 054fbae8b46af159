// SPDX-License-Identifier: GPL-3.0-or-later
// Balls that reach past the end of a neighbouring face and roll on over its edge.
#include "edge_blends.h"

#include <cgal_blend/fillet.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace cgal_blend::test {
namespace {

using unchecked::corefine_and_fillet;

/// Between a wall, a ledge of width w that meets it at a right angle, and the ball of radius r > w that touches the wall
/// and the edge of the ledge: how high it touches, and the area.
double height_on_wall(double w, double r) { return std::sqrt(r * r - (r - w) * (r - w)); }
double section_area(double w, double r) {
  const double h = height_on_wall(w, r);
  return r * h - (h * (r - w) + r * r * std::asin(h / r)) / 2;
}

Blend_mesh stair(double ledge) {
  return prism({{0, 0}, {20, 0}, {20, 4}, {20 - ledge, 4}, {20 - ledge, 14}, {0, 14}}, 0, 20);
}

std::vector<Edge> foot_of_wall(const Blend_mesh& mesh, double ledge) {
  return edges_along(mesh, {20 - ledge, 4, 0}, {20 - ledge, 4, 20});
}

/// Along the edge of the ledge, ended by the planes at both ends.
TEST(Fillet_over_edges, FootOfAStair) {
  const double ledge = 2;
  const Blend_mesh mesh = stair(ledge);
  for (const double r : {2.01, 2.5, 3.0, 5.0, 8.0}) {
    SCOPED_TRACE(r);
    const Blended b = blend_all(mesh, {{foot_of_wall(mesh, ledge), r}}, 2e-4);
    expect_change(b, 20 * section_area(ledge, r), 2e-3);
    if (!b.outcome.ok()) continue;
    EXPECT_TRUE(b.outcome.blends.front().over_edges);
    EXPECT_LT(b.outcome.blends.front().tangency_deg, 1e-6);
    const double x = 20 - ledge + r, y = 4 + height_on_wall(ledge, r);
    for (const Point_3& p : blend_points(b.mesh, b.outcome))
      if (p != Point_3(18, 4, 0) && p != Point_3(18, 4, 20)) {  // corners of the faces that close the ends
        EXPECT_NEAR(std::hypot(p.x() - x, p.y() - y), r, 1e-9 * r);
      }
  }
  const Blended fits = blend_all(mesh, {{foot_of_wall(mesh, ledge), 1.5}}, 2e-4);
  ASSERT_TRUE(fits.outcome.ok());
  EXPECT_FALSE(fits.outcome.blends.front().over_edges);
}

TEST(Fillet_over_edges, FollowsMotionScaleAndOrder) {
  const double ledge = 2, r = 3, expected = 20 * section_area(ledge, r);
  for (const double scale : {1e-3, 1.0, 1e5})
    for (const unsigned seed : {1u, 2u}) {
      Blend_mesh mesh = stair(ledge);
      const auto moved = random_motion(seed, scale);
      const auto ends = std::pair(Point_3(18, 4, 0), Point_3(18, 4, 20));
      Blend_mesh image = shuffled(transformed(mesh, moved), seed);
      Blend_mesh line;
      line.add_vertex(ends.first);
      line.add_vertex(ends.second);
      line = transformed(line, moved);
      const auto edges = edges_along(image, line.point(Vertex(0)), line.point(Vertex(1)));
      ASSERT_FALSE(edges.empty());
      const Blended b = blend_all(image, {{edges, scale * r}}, 1e-3);
      EXPECT_NEAR(b.change / std::pow(scale, 3), expected, 5e-3 * expected) << scale << " " << seed;
    }
}

/// The same from inside: the round of an outer edge reaches past a face that ends at a wall.
TEST(Fillet_over_edges, RoundBesideAWall) {
  const double ledge = 2;
  const Blend_mesh mesh = stair(ledge);
  for (const double r : {2.5, 3.0}) {
    SCOPED_TRACE(r);
    const Blended b = blend_all(mesh, {{edges_along(mesh, {20, 4, 0}, {20, 4, 20}), r}}, 2e-4);
    expect_change(b, -20 * section_area(ledge, r), 2e-3);
  }
}

/// A boss on a disk hardly wider: the ball runs round on the disk's rim.
TEST(Fillet_over_edges, FootOfABossOnANarrowDisk) {
  const double R = 5, D = 7;
  const Blend_mesh disk = cylinder(D, 128, -4, 0), boss = cylinder(R, 128, -1, 10);
  for (const double r : {2.5, 4.0, 9.0}) {
    SCOPED_TRACE(r);
    const double h = height_on_wall(D - R, r);
    double volume = 0;  // in rings
    constexpr int rings = 20000;
    for (int i = 0; i < rings; ++i) {
      const double z = h * (i + 0.5) / rings, at = R + r - std::sqrt(r * r - (z - h) * (z - h));
      volume += pi * (at * at - R * R) * h / rings;
    }
    const Blended b = blend(disk, boss, Boolean_operation::union_, options_of(r, 5e-4));
    expect_change(b, volume, 5e-3);
    if (!b.outcome.ok()) continue;
    EXPECT_TRUE(b.outcome.blends.front().over_edges);
    EXPECT_LT(largest(blend_points(b.mesh, b.outcome),
                      [&](const Point_3& p) { return std::hypot(std::hypot(p.x(), p.y()) - R - r, p.z() - h) - r; }),
              4e-3 * r);
  }
}

/// A boss near the straight edge of a plate: the ball leaves the face, runs along the edge, and comes back.
TEST(Fillet_over_edges, BossNearTheEdgeOfAPlate) {
  const double R = 5, gap = 2;
  const Blend_mesh plate = box({-R - gap, -20, -4}, {20, 20, 0}), boss = cylinder(R, 128, -1, 20);
  for (const double r : {2.5, 4.0, 6.0}) {
    SCOPED_TRACE(r);
    const Blended b = blend(plate, boss, Boolean_operation::union_, options_of(r));
    if (!b.outcome.ok()) continue;  // has failed already
    EXPECT_TRUE(b.outcome.blends.front().over_edges);
    EXPECT_LT(b.outcome.blends.front().radius_error, 0.01);
    EXPECT_LT(b.outcome.blends.front().tangency_deg, 3);                       // half a facet and a little
    const double past = std::sqrt((R + r) * (R + r) - (R + gap) * (R + gap));  // there it is on the edge
    // No farther from the boss than the ball's contacts, nor beyond the edge, and on the ball where it is on the face.
    for (const Point_3& p : blend_points(b.mesh, b.outcome)) {
      EXPECT_GE(p.x(), -R - gap - 1e-12);
      if (p.x() < 0 && std::abs(p.y()) < past) continue;
      const double off = std::hypot(std::hypot(p.x(), p.y()) - R - r, p.z() - r) - r;
      EXPECT_LT(std::abs(off), 1e-2 * r) << p;
    }
  }
}

/// Over the edge and onto the face beyond, where that slopes gently enough for the ball to touch it.
TEST(Fillet_over_edges, FaceBeyondAChamferedEdge) {
  const double ledge = 2;  // then a chamfer of 30 degrees that is long enough
  const double slope = pi / 6, length = 8;
  const double x1 = 18 + ledge, x2 = x1 + length * std::cos(slope), y2 = 10 - length * std::sin(slope);
  const Blend_mesh mesh = prism({{0, 0}, {x2, 0}, {x2, y2}, {x1, 10}, {18, 10}, {18, 20}, {0, 20}}, 0, 20);
  const double r = 5;  // touches the chamfer: the wall and it make an angle of 120 degrees in air
  // The chamfer's line a + t d with outward normal n; the centre is r from it and from the wall.
  const double nx = std::sin(slope), ny = std::cos(slope), cx = 18 + r, cy = (r + nx * x1 + ny * 10 - nx * cx) / ny;
  ASSERT_GT((cx - x1) * std::cos(slope) - (cy - 10) * std::sin(slope), 0);  // the contact is on the chamfer
  Fillet_options options = options_of(r, 2e-4);
  options.smooth_angle = 20;
  Blend_mesh out;
  const Fillet_outcome outcome =
      unchecked::fillet_edges(mesh, {{edges_along(mesh, {18, 10, 0}, {18, 10, 20}), r}}, out, options);
  ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
  EXPECT_TRUE(validate(out).ok());
  EXPECT_TRUE(outcome.blends.front().over_edges);
  for (const Point_3& p : blend_points(out, outcome))
    if (p.y() != 10 || (p.x() != 18 && p.x() != x1)) {  // corners of the faces that close the ends
      EXPECT_NEAR(std::hypot(p.x() - cx, p.y() - cy), r, 1e-9 * r);
    }
}

/// Round the corners of a plate the ball cannot roll.
TEST(Fillet_over_edges, LargestRadiusIsTold) {
  const double R = 5, a = 20;
  Blend_mesh mesh;
  ASSERT_TRUE(
      corefine_and_fillet(plate(a, 10), cylinder(R, 64, -5, 60), Boolean_operation::union_, mesh, options_of(0)).ok());
  const std::vector<Edge> foot = edges_where(mesh, [&](const Point_3& p, const Point_3& q) {
    return p.z() == 0 && q.z() == 0 && std::hypot(p.x(), p.y()) < R + 1 && std::hypot(q.x(), q.y()) < R + 1;
  });
  const double limit = a * std::sqrt(2.0) - R;
  const auto most = expect_largest_radius(mesh, foot, 1.2 * limit, options_of(0, 5e-3));
  if (most) {
    EXPECT_NEAR(*most, limit, 0.05 * limit);
  }
}

}  // namespace
}  // namespace cgal_blend::test
