// SPDX-License-Identifier: GPL-3.0-or-later
// Corners of four edges and more that all bend the same way, with several balls at rest, against the inner parallel body:
// what is left of a convex polytope is that body and a ball (Steiner), and in pockets it is what is cut out.
#include "edge_blends.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace cgal_blend::test {
namespace {

constexpr double fine = 1e-3;  // chord tolerance
constexpr double snapped =
    1e-4;  // radii: rims keep off vertices and edges, moving by 0.01 radii at most along the face

// Bodies.

/// Pyramid over a convex polygon at z = 0, counterclockwise, or a roof: one or more points above.
Polytope roof_over(const std::vector<std::pair<double, double>>& base, const std::vector<Vec3>& top) {
  std::vector<Vec3> points = top;
  for (const auto& [x, y] : base) points.emplace_back(x, y, 0);
  return hull_of(points);
}

const std::vector<std::pair<double, double>> rectangle{{8, 5}, {-8, 5}, {-8, -5}, {8, -5}};
const std::vector<std::pair<double, double>> pentagon{{9, 0}, {3, 7}, {-6, 6}, {-8, -3}, {2, -7}};
const std::vector<std::pair<double, double>> heptagon{{9, 0}, {7, 5}, {1, 8}, {-6, 6}, {-8, 1}, {-4, -6}, {4, -7}};
const std::vector<std::pair<double, double>> narrow{{2.5, 4}, {-2.5, 4}, {-2.5, -4}, {2.5, -4}};

struct Body {
  std::string what;
  Polytope shape;
  double most;  // radius that still leaves an inner parallel body with all the sides
};

/// Apexes with one ball per three sides, and a ridge of which balls of more than 0.49 leave nothing.
std::vector<Body> bodies() {
  return {{"rectangular pyramid", roof_over(rectangle, {{0, 0, 6}}), 2},
          {"steep rectangular pyramid", roof_over(rectangle, {{1, 2, 20}}), 3},
          {"pentagonal pyramid", roof_over(pentagon, {{0, 0, 6}}), 2},
          {"heptagonal pyramid", roof_over(heptagon, {{1, -1, 9}}), 1.5},
          {"roof", roof_over(narrow, {{0.2, 0, 4}, {-0.2, 0, 4}}), 1.2}};
}

// Oracles.

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - t * (b - a)).norm();
}

/// Distance of a point from a convex polytope, by its faces, edges and vertices; 0 inside.
double distance_to_polytope(const Vec3& p, const Polytope& body) {
  double above = 0, nearest = 1e300;
  const double same = 1e-9 * std::max(1.0, p.norm());
  for (const Half_space& side : body.sides()) {
    const double height = side.above(p);
    above = std::max(above, height);
    const Vec3 foot = p - height * side.normal;
    const bool on_face = std::all_of(body.sides().begin(), body.sides().end(),
                                     [&](const Half_space& s) { return s.above(foot) < same; });
    if (height > 0 && on_face) nearest = std::min(nearest, height);
  }
  if (above <= 0) return 0;
  for (const Polytope_edge& e : body.edges())
    nearest = std::min(nearest, distance_to_segment(p, body.points()[e.a], body.points()[e.b]));
  for (const Vec3& q : body.points()) nearest = std::min(nearest, (p - q).norm());
  return nearest;
}

/// The volume is Steiner's, up to the segments between arcs and chords.
void expect_steiner_volume(const Blended& b, const Polytope& body, double r, double chord_tolerance) {
  if (!b.outcome.ok()) return;
  EXPECT_NEAR(volume_of(b.mesh), rounded_volume(body, r),
              1.2 * 2.0 / 3 * chord_tolerance * r * area_of(b.mesh, b.outcome.blend_faces));
}

/// So it is, and every vertex of the blends is as far from the inner parallel body as the ball is large.
void expect_rounded(const Blended& b, const Polytope& body, double r, double chord_tolerance) {
  if (!b.outcome.ok()) return;
  expect_steiner_volume(b, body, r, chord_tolerance);
  const Polytope core = body.inner_parallel(r);
  const double worst = largest(blend_points(b.mesh, b.outcome),
                               [&](const Point_3& p) { return distance_to_polytope(vec3(p), core) - r; });
  EXPECT_LT(worst, snapped * r);
}

/// The inner parallel body of a body that stands on z = 0, as if it went on below.
Polytope core_without_base(const Polytope& body, double r) {
  std::vector<Half_space> sides;
  for (const Half_space& s : body.sides()) sides.push_back(s.normal.z() > -0.5 ? s : Half_space{s.normal, 20 * r});
  return Polytope(sides).inner_parallel(r);
}

/// What the rounds of the upper edges alone take from a body that stands on z = 0, with rounds that go on below:
/// summed up over the directions from a point of the base.
double removed_above_base(const Polytope& body, double r, int steps = 240) {
  const Polytope core = core_without_base(body, r);
  double sum = 0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < 4 * steps; ++j) {
      const double t = (i + 0.5) / steps, z = 1 - t * t, angle = (j + 0.5) * 2 * pi / (4 * steps),
                   s = std::sqrt(1 - z * z);
      const Vec3 u(s * std::cos(angle), s * std::sin(angle), z);
      double far = 1e300;
      for (const Half_space& side : body.sides())
        if (side.normal.dot(u) > 0) far = std::min(far, side.height / side.normal.dot(u));
      if (distance_to_polytope(far * u, core) <= r) continue;
      double low = 0, high = far;
      for (int k = 0; k < 40; ++k) {
        const double middle = (low + high) / 2;
        (distance_to_polytope(middle * u, core) <= r ? low : high) = middle;
      }
      sum += (far * far * far - low * low * low) / 3 * (2 * t / steps) * (2 * pi / (4 * steps));
    }
  return sum;
}

/// A volume is taken or added, up to the segments between arcs and chords and the error of the sum.
void expect_taken(const Blended& b, double volume, double r) {
  if (!b.outcome.ok()) return;
  const double segments = 2.0 / 3 * fine * r * area_of(b.mesh, b.outcome.blend_faces);
  EXPECT_NEAR(std::abs(b.change), volume, 1.2 * segments + 5e-3 * volume);
}

std::vector<Edge> upper_edges(const Blend_mesh& mesh) {
  return edges_where(mesh, [](const Point_3& p, const Point_3& q) { return std::max(p.z(), q.z()) > 1e-9; });
}

/// Block with a pocket in its upper side z = 0: the mirror image of a body that stands there.
Blend_mesh block_with_pocket(const Polytope& body, const std::vector<std::pair<double, double>>& rim, double depth) {
  const Blend_mesh mesh = body.mesh();
  const std::size_t n = rim.size();
  std::vector<Point_3> points;
  std::vector<Corner_indices> triangles;
  for (const Vertex v : mesh.vertices()) points.emplace_back(mesh.point(v).x(), mesh.point(v).y(), -mesh.point(v).z());
  for (const Face f : mesh.faces()) {
    const Face_corners c = corners_of(mesh, f);
    const bool on_base = std::all_of(c.begin(), c.end(), [&](std::size_t v) { return points[v].z() == 0; });
    if (!on_base) triangles.push_back({c[0], c[1], c[2]});  // mirrored, and turned inside out
  }
  std::vector<std::size_t> inner;
  for (const auto& [x, y] : rim)
    for (std::size_t v = 0; v < points.size(); ++v)
      if ((vec3(points[v]) - Vec3(x, y, 0)).norm() < 1e-9) inner.push_back(v);
  EXPECT_EQ(inner.size(), n);
  const std::size_t upper = points.size(), lower = upper + n;
  for (const double z : {0.0, -depth})
    for (const auto& [x, y] : rim) points.emplace_back(2 * x, 2 * y, z);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    triangles.push_back({inner[i], upper + i, upper + j});
    triangles.push_back({inner[i], upper + j, inner[j]});
    triangles.push_back({lower + i, lower + j, upper + j});
    triangles.push_back({lower + i, upper + j, upper + i});
    if (i + 2 < n) triangles.push_back({lower, lower + i + 2, lower + i + 1});
  }
  return mesh_of(points, triangles);
}

std::size_t largest_degree(const Blend_mesh& mesh) {
  std::size_t most = 0;
  for (const Vertex v : mesh.vertices()) {
    std::size_t n = 0;
    for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
      n += is_crease(mesh.edge(h), mesh, 1) ? 1 : 0;
    most = std::max(most, n);
  }
  return most;
}

// All edges.

TEST(Fillet_corners_many, AllEdgesOfPyramidsAndRoofs) {
  for (const Body& body : bodies()) {
    const Blend_mesh mesh = body.shape.mesh();
    for (const double share : {0.03, 0.25, 0.5, 1.0}) {
      const double r = share * body.most;
      SCOPED_TRACE(body.what + ", radius " + std::to_string(r));
      expect_rounded(blend_all(mesh, {{all_creases(mesh), r}}, fine), body.shape, r, fine);
    }
  }
}

TEST(Fillet_corners_many, FollowsMotionScaleAndOrder) {
  const Body body = bodies()[2];
  const Blend_mesh mesh = body.shape.mesh();
  const double volume = volume_of(blend_all(mesh, {{all_creases(mesh), 1}}, fine).mesh);
  for (const unsigned seed : {1u, 2u, 3u})
    for (const double scale : {1.0, 1e-3, 1e6}) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", scale " + std::to_string(scale));
      const Blend_mesh moved = shuffled(transformed(mirrored(mesh), random_motion(seed, scale)), seed);
      const Blended b = blend_all(moved, {{all_creases(moved), scale}}, fine);
      EXPECT_NEAR(volume_of(b.mesh) / std::pow(scale, 3), volume, 1e-3 * volume);
    }
}

TEST(Fillet_corners_many, SameInputGivesTheSameBytes) {
  const Blend_mesh mesh = bodies()[3].shape.mesh();
  EXPECT_TRUE(identical(blend_all(mesh, {{all_creases(mesh), 1}}, fine).mesh,
                        blend_all(mesh, {{all_creases(mesh), 1}}, fine).mesh));
}

/// Nearly square: the spine across the apex is as short as the sides differ, down to nothing.
TEST(Fillet_corners_many, ShortSpines) {
  for (const double longer : {1.0, 0.1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-9, 1e-12, 1e-15, 0.0})
    for (const unsigned seed : {0u, 1u}) {
      const double a = 5 + longer;
      SCOPED_TRACE("longer by " + std::to_string(longer) + ", seed " + std::to_string(seed));
      const Polytope body = roof_over({{a, 5}, {-a, 5}, {-a, -5}, {a, -5}}, {{0, 0, 5}});
      const Blend_mesh mesh = seed == 0 ? body.mesh() : transformed(body.mesh(), random_motion(seed));
      const Blended b = blend_all(mesh, {{all_creases(mesh), 1}}, fine);
      expect_steiner_volume(b, body, 1, fine);
    }
}

/// One ball for as many faces as there are, whatever rounding makes of them.
TEST(Fillet_corners_many, OneBallForManyFaces) {
  for (const int n : {5, 6, 8}) {
    std::vector<std::pair<double, double>> base;
    for (int k = 0; k < n; ++k) base.emplace_back(5 * std::cos(2 * pi * k / n), 5 * std::sin(2 * pi * k / n));
    const Polytope body = roof_over(base, {{0, 0, 5}});
    for (const unsigned seed : {1u, 2u, 3u}) {
      SCOPED_TRACE(std::to_string(n) + " faces, seed " + std::to_string(seed));
      const Blend_mesh mesh = shuffled(transformed(body.mesh(), random_motion(seed)), seed);
      const Blended b = blend_all(mesh, {{all_creases(mesh), 0.7}}, fine);
      expect_steiner_volume(b, body, 0.7, fine);
    }
  }
}

/// A ridge that just survives the ball, vanishes, and is gone for long.
TEST(Fillet_corners_many, RidgeThatTheBallSwallows) {
  const double half = 0.2, slope = std::atan(4 / 2.3), main = std::atan(4 / 4.0);
  const double limit = half * std::sin(slope) / (1 - std::cos(slope) / std::cos(main));
  const Polytope body = roof_over(narrow, {{half, 0, 4}, {-half, 0, 4}});
  const Blend_mesh mesh = body.mesh();
  for (const double share : {0.5, 0.9, 0.99, 0.999, 0.999999, 1.0, 1.000001, 1.001, 1.01, 1.1, 2.0}) {
    const double r = share * limit;
    SCOPED_TRACE("radius " + std::to_string(r));
    expect_rounded(blend_all(mesh, {{all_creases(mesh), r}}, fine), body, r, fine);
  }
}

TEST(Fillet_corners_many, LargestRadiusIsTold) {
  const Blend_mesh mesh = bodies()[0].shape.mesh();
  const double limit = 6 * 5 / (5 + std::hypot(6, 5));  // of balls between the long sides and the base
  const auto most = expect_largest_radius(mesh, all_creases(mesh), 2.6, options_of(0, 5e-3));
  ASSERT_TRUE(most);
  EXPECT_NEAR(*most, limit, 0.1 * limit);
}

/// Other radii, or edges that bend the other way, have no ball at rest there: refused, and kept sharp where it goes on.
TEST(Fillet_corners_many, DifferentRadiiAreRefused) {
  const Blend_mesh mesh = bodies()[0].shape.mesh();
  const std::vector<Edge> edges = upper_edges(mesh);
  ASSERT_EQ(edges.size(), 4u);
  const std::vector<Edge_blend> blends{{{edges[0]}, 0.5}, {{edges[1], edges[2], edges[3]}, 0.6}};
  Blend_mesh out;
  const Fillet_outcome outcome = unchecked::fillet_edges(mesh, blends, out, options_of(0, fine));
  EXPECT_EQ(outcome.diagnosis.status, Status::corner);
  ASSERT_TRUE(outcome.diagnosis.point);
  EXPECT_LT((vec3(*outcome.diagnosis.point) - Vec3(0, 0, 6)).norm(), 1e-9);
  EXPECT_EQ(out.number_of_faces(), 0u);
}

// Upper edges only: the base cuts their rounds.

TEST(Fillet_corners_many, UpperEdgesOfPyramidsAndRoofs) {
  for (const Body& body : bodies()) {
    const Blend_mesh mesh = body.shape.mesh();
    for (const double share : {0.25, 0.75}) {
      const double r = share * std::min(1.0, body.most);
      SCOPED_TRACE(body.what + ", radius " + std::to_string(r));
      const Blended b = blend_all(mesh, {{upper_edges(mesh), r}}, fine);
      expect_taken(b, removed_above_base(body.shape, r), r);
    }
  }
}

TEST(Fillet_corners_many, Pockets) {
  const std::vector<std::pair<const char*, std::vector<std::pair<double, double>>>> rims{
      {"rectangle", rectangle}, {"pentagon", pentagon}, {"roof", narrow}};
  for (const auto& [what, rim] : rims) {
    const bool is_roof = std::string(what) == "roof";
    const Polytope body = is_roof ? roof_over(rim, {{0.2, 0, 4}, {-0.2, 0, 4}}) : roof_over(rim, {{0, 0, 6}});
    const Blend_mesh mesh = block_with_pocket(body, rim, 9);
    ASSERT_TRUE(validate(mesh).ok());
    const std::vector<Edge> edges = edges_where(mesh, [&](const Point_3& p, const Point_3& q) {
      const double low = std::min(p.z(), q.z()), depth = is_roof ? 4 : 6;
      return std::abs(low + depth) < 1e-9;
    });
    for (const double r : {0.3, 0.8}) {
      SCOPED_TRACE(std::string(what) + ", radius " + std::to_string(r));
      const Blended b = blend_all(mesh, {{edges, r}}, fine);
      expect_taken(b, removed_above_base(body, r), r);
      const Polytope core = core_without_base(body, r);
      expect_on(b, r, snapped, [&](const Point_3& p) {  // on the rim the segments between rows are cut
        return p.z() == 0 ? 0 : distance_to_polytope(Vec3(p.x(), p.y(), -p.z()), core) - r;
      });
    }
  }
}

// Bodies at random.

TEST(Fillet_corners_many, HullsAtRandom) {
  std::size_t several = 0;  // hulls whose corners have more than three edges
  for (unsigned seed = 0; seed < 12; ++seed) {
    std::mt19937 random(200 + seed);
    const Polytope body = random_hull(8 + seed % 7, random);
    const Blend_mesh mesh = body.mesh();
    several += largest_degree(mesh) > 3 ? 1 : 0;
    for (const double r : {0.005, 0.02}) {
      const double tolerance = 5e-3;
      SCOPED_TRACE("seed " + std::to_string(seed) + ", radius " + std::to_string(r));
      Fillet_options options = options_of(0, tolerance);
      options.smooth_angle = 1;
      Blended b;
      b.outcome = unchecked::fillet_edges(mesh, {{all_creases(mesh, 0), r}}, b.mesh, options);
      EXPECT_TRUE(b.outcome.ok()) << message(b.outcome.diagnosis);
      if (!b.outcome.ok()) continue;
      EXPECT_TRUE(validate(b.mesh).ok());
      expect_rounded(b, body, r, tolerance);
    }
  }
  EXPECT_GT(several, 8u);
}

/// Where larger balls swallow edges and faces, the result is right or refused by name.
TEST(Fillet_corners_many, LargeBallsInHullsAtRandom) {
  int tried = 0, done = 0;
  for (unsigned seed = 0; seed < 8; ++seed) {
    std::mt19937 random(300 + seed);
    const Polytope body = random_hull(8 + seed % 7, random);
    const Blend_mesh mesh = body.mesh();
    for (const double r : {0.03, 0.08, 0.15}) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", radius " + std::to_string(r));
      Fillet_options options = options_of(0, 5e-3);
      options.smooth_angle = 1;
      Blended b;
      b.outcome = unchecked::fillet_edges(mesh, {{all_creases(mesh, 0), r}}, b.mesh, options);
      ++tried;
      if (!b.outcome.ok()) {
        EXPECT_EQ(status_class(b.outcome.diagnosis.status), Status_class::blend) << message(b.outcome.diagnosis);
        EXPECT_TRUE(b.outcome.diagnosis.point);
        EXPECT_EQ(b.mesh.number_of_faces(), 0u);
        continue;
      }
      ++done;
      EXPECT_TRUE(validate(b.mesh).ok());
      expect_rounded(b, body, r, 5e-3);
    }
  }
  std::cout << "large balls: " << done << " of " << tried << " blended\n";
  EXPECT_GT(2 * done, tried);
}

}  // namespace
}  // namespace cgal_blend::test
