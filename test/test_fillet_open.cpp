// SPDX-License-Identifier: GPL-3.0-or-later
// Blends of single open edges and chains against closed forms: what the round takes or adds, and how it ends.
#include "edge_blends.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace cgal_blend::test {
namespace {

constexpr double fine = 4e-4;  // chord tolerance

/// Area between the faces of a wedge of the angle theta and the arc, and the centroid's distance from the edge.
double section_area(double theta, double r) { return (1 / std::tan(theta / 2) - (pi - theta) / 2) * r * r; }
double section_centroid(double theta, double r) {
  const double turn = pi - theta, center = r / std::sin(theta / 2), contact = r / std::tan(theta / 2);
  const double kite = r * contact, sector = turn * r * r / 2;
  const double of_kite = (center + contact * std::cos(theta / 2)) / 3;
  const double of_sector = center - 4 * r * std::sin(turn / 2) / (3 * turn);
  return (kite * of_kite - sector * of_sector) / (kite - sector);
}

/// Share of the section that the segments between arc and chords make up, and a little.
double arc_share_of(double theta) { return 2e-4 + 2.0 / 3 * fine * (pi - theta) / section_area(theta, 1); }
const double arc_share = arc_share_of(pi / 2);

/// Prism with an edge along z through the origin, between the face x > 0 of y = 0 and the one at the angle theta to it;
/// the ends are planes through (0, 0, +-half) that lean by their slopes towards x and y.
Polytope wedge(double theta, double half, const std::array<std::array<double, 2>, 2>& slopes = {}) {
  const Vec3 first(0, -1, 0), second(-std::sin(theta), std::cos(theta), 0);
  const Vec3 bisector(std::cos(theta / 2), std::sin(theta / 2), 0);
  return Polytope({half_space(first, Vec3::Zero()), half_space(second, Vec3::Zero()),
                   half_space(bisector, 12 * bisector), half_space({slopes[0][0], slopes[0][1], -1}, {0, 0, -half}),
                   half_space({slopes[1][0], slopes[1][1], 1}, {0, 0, half})});
}

Blended blend_wedge(const Polytope& body, double r) {
  const Blend_mesh mesh = body.mesh();
  const auto on_edge = [](const Point_3& p) { return std::hypot(p.x(), p.y()) < 1e-9; };
  return blend_all(
      mesh, {{edges_where(mesh, [&](const Point_3& p, const Point_3& q) { return on_edge(p) && on_edge(q); }), r}},
      fine);
}

TEST(Fillet_open, EdgeOfABox) {
  const Blend_mesh mesh = box({0, 0, 0}, {10, 8, 6});
  for (const Edge e : all_creases(mesh)) {
    const Point_3 p = mesh.point(mesh.vertex(e, 0)), q = mesh.point(mesh.vertex(e, 1));
    const Blended b = blend_all(mesh, {{{e}, 1}}, fine);
    expect_change(b, -spandrel(1) * std::sqrt(CGAL::squared_distance(p, q)), arc_share);
    if (!b.outcome.ok()) continue;
    EXPECT_TRUE(b.outcome.blends.at(0).convex);
    EXPECT_FALSE(b.outcome.blends[0].closed);
    EXPECT_LT(b.outcome.blends[0].radius_error, 1e-9);
    EXPECT_LT(b.outcome.blends[0].tangency_deg, 0.1);
    const auto axis = [&](int k) { return p[k] != q[k] ? 0.0 : p[k] == 0 ? 1.0 : p[k] - 1; };
    expect_on(b, 1, 1e-3, [&](const Point_3& at) {
      return distance_to_cylinder(at, {axis(0), axis(1), axis(2)}, q - p, 1);
    });
  }
}

TEST(Fillet_open, ErrorOfVolumeGoesWithTheChordTolerance) {
  const Blend_mesh mesh = box({0, 0, 0}, {10, 8, 6});
  std::vector<double> error;
  for (const double tolerance : {3.2e-2, 8e-3, 2e-3, 5e-4}) {
    const Blended b = blend_all(mesh, {{edges_along(mesh, {0, 0, 0}, {10, 0, 0}), 2}}, tolerance);
    error.push_back(std::abs(-b.change - 10 * spandrel(2)));
    EXPECT_LT(error.back(), 1.1 * 2.0 / 3 * tolerance * pi / 2 * 4 * 10);  // the segments between arc and chords
  }
  for (std::size_t i = 0; i + 1 < error.size(); ++i) EXPECT_GE(order(error[i], error[i + 1]) / 2, 0.75);
}

TEST(Fillet_open, WedgesWithPerpendicularEnds) {
  for (const double degrees : {30.0, 45.0, 60.0, 75.0, 90.0, 110.0, 120.0, 135.0, 150.0}) {
    SCOPED_TRACE(degrees);
    const double theta = degrees * pi / 180, r = degrees < 60 ? 1 : 2;
    expect_change(blend_wedge(wedge(theta, 5), r), -10 * section_area(theta, r), arc_share_of(theta));
  }
}

TEST(Fillet_open, WedgesWithObliqueEnds) {
  for (const double degrees : {45.0, 90.0, 135.0})
    for (const auto& slopes : std::vector<std::array<std::array<double, 2>, 2>>{
             {{{0.4, 0}, {0, 0}}}, {{{0.3, -0.5}, {0.2, 0.6}}}, {{{-0.4, -0.2}, {-0.3, 0.1}}}, {{{0, 0}, {1, 1}}}}) {
      SCOPED_TRACE(std::to_string(degrees) + " degrees, slopes " + std::to_string(slopes[0][0]) + " " +
                   std::to_string(slopes[0][1]) + ", " + std::to_string(slopes[1][0]) + " " +
                   std::to_string(slopes[1][1]));
      const double theta = degrees * pi / 180, r = 1;
      // The planes are linear in x and y: the mean length is the one at the section's centroid.
      const double at = section_centroid(theta, r), x = at * std::cos(theta / 2), y = at * std::sin(theta / 2);
      const double mean = 20 - slopes[0][0] * x - slopes[0][1] * y - slopes[1][0] * x - slopes[1][1] * y;
      const Blended b = blend_wedge(wedge(theta, 10, slopes), r);
      expect_change(b, -mean * section_area(theta, r), arc_share_of(theta));
    }
}

/// The integral over the section agrees with the closed form, so that it may stand for it elsewhere.
TEST(Fillet_open, OracleOfObliqueEndsAgreesWithItself) {
  for (const double theta : {0.8, 1.6, 2.5}) {
    const std::array<std::array<double, 2>, 2> slopes{{{0.3, -0.5}, {0.2, 0.6}}};
    const Polytope body = wedge(theta, 10, slopes);
    const double at = section_centroid(theta, 1), x = at * std::cos(theta / 2), y = at * std::sin(theta / 2);
    const double expected = (20 - 0.5 * x - 0.1 * y) * section_area(theta, 1);
    EXPECT_NEAR(removed_by_round(body, {body.sides()[0], body.sides()[1], 1}), expected, 1e-4 * expected);
  }
}

// Brackets: outlines counterclockwise, legs of thickness t.

using Outline = std::vector<std::pair<double, double>>;

const Outline l_outline{{0, 0}, {10, 0}, {10, 4}, {4, 4}, {4, 10}, {0, 10}};
const Outline t_outline{{0, 0}, {14, 0}, {14, 4}, {9, 4}, {9, 12}, {5, 12}, {5, 4}, {0, 4}};
const Outline u_outline{{0, 0}, {14, 0}, {14, 10}, {10, 10}, {10, 4}, {4, 4}, {4, 10}, {0, 10}};

TEST(Fillet_open, ConcaveEdgesOfBrackets) {
  const double r = 1.5, h = 6;
  for (const Outline& outline : {l_outline, t_outline, u_outline}) {
    const Blend_mesh mesh = tower(outline, {0, h});
    std::vector<Edge> concave;
    for (const Edge e : all_creases(mesh))
      if (!is_convex_edge(e, mesh)) concave.push_back(e);
    for (const Edge e : concave) {
      const Blended b = blend_all(mesh, {{{e}, r}}, fine);
      expect_change(b, spandrel(r) * h, arc_share);
    }
    const Blended both = blend_all(mesh, {{concave, r}}, fine);
    expect_change(both, static_cast<double>(concave.size()) * spandrel(r) * h, arc_share);
  }
}

struct Kind {
  const char* what;
  Blend_mesh mesh;
  Point_3 from, to;
  bool convex;
};

/// One edge with sharp neighbours, of all kinds that a corner of three right angles has: the sides' other edges convex or
/// concave. What bounds the round is planes across it, so what it takes or adds is a cylinder.
TEST(Fillet_open, AllKindsOfNeighboursAtACorner) {
  const Blend_mesh l = tower(l_outline, {0, 6}), boss = boss_or_pit(false), pit = boss_or_pit(true);
  const std::vector<Kind> kinds{
      {"convex between two convex", l, {0, 0, 0}, {0, 0, 6}, true},
      {"convex between convex and concave", l, {4, 4, 6}, {4, 10, 6}, true},
      {"convex between concave and convex", l, {4, 4, 6}, {10, 4, 6}, true},
      {"convex from below", l, {4, 4, 0}, {10, 4, 0}, true},
      {"convex between two concave", boss, {4, 4, 0}, {4, 4, 6}, true},
      {"concave between two convex", l, {4, 4, 0}, {4, 4, 6}, false},
      {"concave between convex and concave", boss, {4, -4, 0}, {4, 4, 0}, false},
      {"concave between two concave", pit, {4, -4, -6}, {4, 4, -6}, false},
      {"concave between convex and concave, in a pit", pit, {4, 4, -6}, {4, 4, 0}, false},
      {"convex between two convex, at a pit", pit, {4, -4, 0}, {4, 4, 0}, true},
  };
  for (const Kind& kind : kinds) {
    SCOPED_TRACE(kind.what);
    const double length = std::sqrt(CGAL::squared_distance(kind.from, kind.to));
    for (const double r : {0.5, 1.5}) {
      const Blended b = blend_all(kind.mesh, {{edges_along(kind.mesh, kind.from, kind.to), r}}, fine);
      expect_change(b, (kind.convex ? -1 : 1) * spandrel(r) * length, arc_share);
      if (b.outcome.ok()) {
        EXPECT_EQ(b.outcome.blends.at(0).convex, kind.convex);
      }
    }
  }
}

/// A rib with a sloping back between a plate and a wall: its back's edges run into the wall, and into the plate.
TEST(Fillet_open, EdgeOfARibRunsIntoAWall) {
  // In the xz-plane: floor z = 0, wall x = 0; rib 2 wide from (0, 6) down to (8, 0).
  Blend_mesh corner = transformed(tower({{-3, -3}, {12, -3}, {12, 0}, {0, 0}, {0, 10}, {-3, 10}}, {-6, 6}),
                                  placement({1, 0, 0}, pi / 2));
  const Blend_mesh rib =
      transformed(tower({{-1, -1}, {28.0 / 3, -1}, {-1, 6.75}}, {-1, 1}), placement({1, 0, 0}, pi / 2));
  Blend_mesh body;
  const auto made = unchecked::corefine_and_fillet(corner, rib, Boolean_operation::union_, body, options_of(0));
  ASSERT_TRUE(made.ok()) << message(made.diagnosis);
  // The back is z = 6 - 3/4 x; its edges are at y = +-1.
  const auto back = [](const Point_3& p) {
    return std::abs(p.z() - 6 + 0.75 * p.x()) < 1e-5 && p.x() > -1e-5 && p.z() > -1e-5;
  };
  for (const double side : {-1.0, 1.0}) {
    const std::vector<Edge> edge = edges_where(body, [&](const Point_3& p, const Point_3& q) {
      return back(p) && back(q) && std::abs(p.y() - side) < 1e-9 && std::abs(q.y() - side) < 1e-9;
    });
    ASSERT_EQ(edge.size(), 1u);
    const double r = 0.5;
    // A point of the section at depth d below the back lies on a line of the back's slope, cut by x = 0 and z = 0.
    const double d = spandrel_centroid(r), length = std::hypot(8, 6) - d * (0.75 + 4.0 / 3);
    expect_change(blend_all(body, {{edge, r}}, fine), -spandrel(r) * length, arc_share);
  }
}

/// The round of one edge of a pyramid runs into the apex, where it is cut by the two faces beyond.
TEST(Fillet_open, OneEdgeOfAPyramid) {
  for (const double height : {3.0, 5.0, 12.0}) {
    const Polytope body = pyramid(5, height);
    const Blend_mesh mesh = body.mesh();
    for (const Polytope_edge& e : {body.edges()[0], body.edges()[1], body.edges().back()}) {
      SCOPED_TRACE("height " + std::to_string(height) + ", edge " + std::to_string(e.a) + " " + std::to_string(e.b));
      const double r = 0.4;
      const Vec3 p = body.points()[e.a], q = body.points()[e.b];
      const Blended b = blend_all(mesh, {{edges_along(mesh, {p.x(), p.y(), p.z()}, {q.x(), q.y(), q.z()}), r}}, fine);
      expect_change(b, -removed_by_round(body, {body.sides()[e.f], body.sides()[e.g], r}),
                    arc_share_of(pi - body.turn(e)));
    }
  }
}

TEST(Fillet_open, OneEdgeOfEachRegularSolid) {
  for (const int faces : {4, 6, 8, 12, 20}) {
    SCOPED_TRACE(faces);
    const Polytope body = hull_of(regular_solid(faces));
    const Blend_mesh mesh = body.mesh();
    const Polytope_edge e = body.edges().front();
    const Vec3 p = body.points()[e.a], q = body.points()[e.b];
    const double r = 0.1;
    const Blended b = blend_all(mesh, {{edges_along(mesh, {p.x(), p.y(), p.z()}, {q.x(), q.y(), q.z()}), r}}, fine);
    expect_change(b, -removed_by_round(body, {body.sides()[e.f], body.sides()[e.g], r}),
                  arc_share_of(pi - body.turn(e)));
  }
}

// Part of a smooth chain: flat caps.

TEST(Fillet_open, PartOfAConvexChain) {
  const Blend_mesh mesh = grid_box({0, 0, 0}, {10, 10, 10}, 10);
  for (const auto& [from, to] : std::vector<std::pair<double, double>>{{3, 7}, {4, 5}, {0, 6}, {2, 10}}) {
    SCOPED_TRACE(std::to_string(from) + " to " + std::to_string(to));
    const Blended b = blend_all(mesh, {{edges_along(mesh, {from, 10, 10}, {to, 10, 10}), 1.3}}, fine);
    expect_change(b, -spandrel(1.3) * (to - from), arc_share);
  }
  const Blended two = blend_all(
      mesh, {{joined(edges_along(mesh, {1, 0, 0}, {3, 0, 0}), edges_along(mesh, {6, 0, 0}, {9, 0, 0})), 1.3}}, fine);
  expect_change(two, -spandrel(1.3) * 5, arc_share);
}

TEST(Fillet_open, PartOfAConcaveChain) {
  const Blend_mesh mesh = tower(l_outline, {0, 1, 2, 3, 4, 5, 6, 7, 8});
  for (const auto& [from, to] : std::vector<std::pair<double, double>>{{3, 6}, {2, 3}, {0, 5}, {4, 8}}) {
    SCOPED_TRACE(std::to_string(from) + " to " + std::to_string(to));
    const Blended b = blend_all(mesh, {{edges_along(mesh, {4, 4, from}, {4, 4, to}), 1.3}}, fine);
    expect_change(b, spandrel(1.3) * (to - from), arc_share);
  }
}

/// Half of a boss's rim or foot: half a torus.
TEST(Fillet_open, PartOfACircle) {
  const Blend_mesh boss = boss_on_plate(15, 30, 8, 20, 1.0);
  const auto half_at = [&](double z) {
    return edges_where(boss, [&](const Point_3& p, const Point_3& q) {
      const auto on = [&](const Point_3& s) {
        return std::abs(std::hypot(s.x(), s.y()) - 15) < 1e-9 && s.z() == z && s.y() > -1e-9;
      };
      return on(p) && on(q);
    });
  };
  for (const double z : {0.0, 20.0}) {
    const std::vector<Edge> half = half_at(z);
    ASSERT_FALSE(half.empty());
    double turned = 0;
    for (const Edge e : half)
      turned +=
          2 * std::asin(
                  std::sqrt(CGAL::squared_distance(boss.point(boss.vertex(e, 0)), boss.point(boss.vertex(e, 1)))) / 30);
    const double expected = turned / (2 * pi) * (z == 0 ? foot_volume(15, 3) : -rim_volume(15, 3));
    expect_change(blend_all(boss, {{half, 3}}, fine), expected, 0.01);
  }
}

/// A roof's ridge that flattens out to nothing at both ends.
TEST(Fillet_open, FadingCrease) {
  const int n = 20;
  const auto height = [&](double x, double y) {  // sharp along y = 0, less and less towards x = 0 and x = 20
    const double s = std::sin(pi * x / 20);
    return 6 - s * s * std::abs(y) * 0.8;
  };
  std::vector<Point_3> points;
  std::vector<Corner_indices> triangles;
  const auto at = [&](int i, int j, int level) { return static_cast<std::size_t>((i * (n + 1) + j) * 2 + level); };
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const double x = i, y = (j - n / 2) * 0.5;
      points.emplace_back(x, y, -2);
      points.emplace_back(x, y, height(x, y));
    }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      triangles.push_back({at(i, j, 1), at(i + 1, j, 1), at(i + 1, j + 1, 1)});
      triangles.push_back({at(i, j, 1), at(i + 1, j + 1, 1), at(i, j + 1, 1)});
      triangles.push_back({at(i, j, 0), at(i + 1, j + 1, 0), at(i + 1, j, 0)});
      triangles.push_back({at(i, j, 0), at(i, j + 1, 0), at(i + 1, j + 1, 0)});
    }
  for (int k = 0; k < n; ++k)
    for (const auto& [a, b] :
         {std::pair(std::pair(k, 0), std::pair(k + 1, 0)), std::pair(std::pair(n, k), std::pair(n, k + 1)),
          std::pair(std::pair(k + 1, n), std::pair(k, n)), std::pair(std::pair(0, k + 1), std::pair(0, k))}) {
      triangles.push_back({at(a.first, a.second, 0), at(b.first, b.second, 0), at(b.first, b.second, 1)});
      triangles.push_back({at(a.first, a.second, 0), at(b.first, b.second, 1), at(a.first, a.second, 1)});
    }
  const Blend_mesh roof = mesh_of(points, triangles);
  std::vector<Edge> ridge;
  for (const Edge e : edges_along(roof, {0, 0, 6}, {20, 0, 6}))
    if (is_crease(e, roof, 30)) ridge.push_back(e);
  ASSERT_GT(ridge.size(), 4u);
  const Blended b = blend_all(roof, {{ridge, 1}});
  EXPECT_LT(b.change, 0);
  EXPECT_GT(b.change, -20 * section_area(pi - 2 * std::atan(0.8), 1));
}

// What holds of every blend.

TEST(Fillet_open, FollowsMotionScaleAndOrder) {
  const Blend_mesh l = tower(l_outline, {0, 6}), boss = boss_or_pit(false);
  struct Case {
    const Blend_mesh& mesh;
    Point_3 from, to;
  };
  for (const Case& c : {Case{l, {0, 0, 0}, {0, 0, 6}}, Case{l, {4, 4, 0}, {4, 4, 6}}, Case{l, {4, 4, 6}, {10, 4, 6}},
                        Case{boss, {4, 4, 0}, {4, 4, 6}}, Case{boss, {4, -4, 0}, {4, 4, 0}}}) {
    const Blended plain = blend_all(c.mesh, {{edges_along(c.mesh, c.from, c.to), 1}});
    ASSERT_TRUE(plain.outcome.ok());
    const double volume = volume_of(plain.mesh);
    for (const double scale : {1e-3, 1.0, 1e6}) {
      const Placement motion = random_motion(3, scale);
      const Blend_mesh moved = transformed(c.mesh, motion);
      const Blended b =
          blend_all(moved, {{edges_along(moved, motion.transform(c.from), motion.transform(c.to)), scale}});
      EXPECT_NEAR(volume_of(b.mesh) / std::pow(scale, 3), volume, 1e-6 * volume) << scale;
    }
    for (const unsigned seed : {1u, 2u, 3u, 4u}) {
      const Blend_mesh other = shuffled(c.mesh, seed);
      const Blended b = blend_all(other, {{edges_along(other, c.from, c.to), 1}});
      EXPECT_NEAR(volume_of(b.mesh), volume, 1e-9 * volume) << seed;
    }
    const Blend_mesh image = mirrored(c.mesh);
    const Blended b = blend_all(
        image, {{edges_along(image, {-c.from.x(), c.from.y(), c.from.z()}, {-c.to.x(), c.to.y(), c.to.z()}), 1}});
    EXPECT_NEAR(volume_of(b.mesh), volume, 1e-9 * volume);
  }
}

TEST(Fillet_open, FacesAwayFromTheBlendAreUntouched) {
  const Blend_mesh mesh = grid_box({0, 0, 0}, {10, 10, 10}, 16);
  const Blended b = blend_all(mesh, {{edges_along(mesh, {0, 10, 10}, {10, 10, 10}), 1}});
  ASSERT_TRUE(b.outcome.ok());
  const std::vector<Face> far =
      faces_beyond(mesh, 2, [](const Point_3& p) { return std::hypot(10 - p.y(), 10 - p.z()); });
  ASSERT_GT(far.size(), mesh.number_of_faces() / 2);
  EXPECT_TRUE(faces_kept_in_order(mesh, b.mesh, far));
  EXPECT_GE(b.outcome.kept_faces, far.size());
}

TEST(Fillet_open, SameInputGivesTheSameBytes) {
  const Blend_mesh mesh = boss_or_pit(false);
  const std::vector<Edge_blend> blends{{edges_along(mesh, {4, -4, 0}, {4, 4, 0}), 1}};
  EXPECT_TRUE(identical(blend_all(mesh, blends).mesh, blend_all(mesh, blends).mesh));
}

/// Too large a ball is refused, and told is one that just fits.
TEST(Fillet_open, LargestRadiusIsTold) {
  const Blend_mesh l = tower(l_outline, {0, 6}), boss = boss_or_pit(false), pit = boss_or_pit(true);
  const Blend_mesh sharp = wedge(pi / 4, 5).mesh(), roof = pyramid(5, 5).mesh();
  struct Case {
    const char* what;
    const Blend_mesh& mesh;
    std::vector<Edge> edges;
    double radius;
  };
  const Blend_mesh brick = box({0, 0, 0}, {10, 8, 6});
  const std::vector<Case> cases{
      {"box, short side 6", brick, edges_along(brick, {0, 0, 0}, {10, 0, 0}), 7},
      {"box, short side 8", brick, edges_along(brick, {0, 0, 0}, {0, 0, 6}), 9},
      {"bracket, outer edge", l, edges_along(l, {10, 0, 0}, {10, 0, 6}), 5},
      {"bracket, rim", l, edges_along(l, {4, 4, 6}, {10, 4, 6}), 5},
      {"boss, upright edge", boss, edges_along(boss, {4, 4, 0}, {4, 4, 6}), 9},
      {"pit, bottom", pit, edges_along(pit, {4, -4, -6}, {4, 4, -6}), 7},
      {"pit, rim", pit, edges_along(pit, {4, -4, 0}, {4, 4, 0}), 7},
      {"wedge", sharp, edges_along(sharp, {0, 0, -5}, {0, 0, 5}), 6},
      {"pyramid", roof, edges_along(roof, {5, 5, 0}, {0, 0, 5}), 16},
      {"pyramid, base", roof, edges_along(roof, {5, 5, 0}, {-5, 5, 0}), 4},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.what);
    expect_largest_radius(c.mesh, c.edges, c.radius, options_of(0));
  }
}

}  // namespace
}  // namespace cgal_blend::test
