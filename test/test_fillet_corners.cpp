// SPDX-License-Identifier: GPL-3.0-or-later
// Blends that meet: the ball at rest in corners, mitres, and corners that bend both ways, against closed forms.
#include "edge_blends.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace cgal_blend::test {
namespace {

constexpr double fine = 4e-4;

// Boxes with all edges rounded.

double rounded_box_volume(double a, double r) {
  const double b = a - 2 * r;
  return b * b * b + 6 * r * b * b + 3 * pi * r * r * b + 4 * pi * r * r * r / 3;
}

/// Distance from the rounded box [0, a]^3 of radius r: off the box of the ball's centres.
double distance_to_rounded_box(const Point_3& p, double a, double r) {
  const auto off = [&](double x) { return x - std::clamp(x, r, a - r); };
  return std::sqrt(off(p.x()) * off(p.x()) + off(p.y()) * off(p.y()) + off(p.z()) * off(p.z())) - r;
}

TEST(Fillet_corners, AllEdgesOfABox) {
  for (const Blend_mesh& mesh : {box({0, 0, 0}, {10, 10, 10}), grid_box({0, 0, 0}, {10, 10, 10}, 16)}) {
    const Blended b = blend_all(mesh, {{all_creases(mesh), 1}}, 1.0 / 200);
    ASSERT_TRUE(b.outcome.ok());
    EXPECT_NEAR(volume_of(b.mesh), rounded_box_volume(10, 1), 0.002 * rounded_box_volume(10, 1));
    expect_on(b, 1, 1e-3, [](const Point_3& p) { return distance_to_rounded_box(p, 10, 1); });
    for (const Blend_report& report : b.outcome.blends) {
      EXPECT_TRUE(report.convex);
      EXPECT_LT(report.radius_error, 1e-3);
    }
  }
}

TEST(Fillet_corners, AllEdgesOfABoxInAnyPlaceAndSize) {
  for (const Blend_mesh& mesh : {box({0, 0, 0}, {10, 10, 10}), grid_box({0, 0, 0}, {10, 10, 10}, 16)}) {
    const double volume = volume_of(blend_all(mesh, {{all_creases(mesh), 1}}, 1.0 / 200).mesh);
    for (const unsigned seed : {1u, 2u, 3u})
      for (const double scale : {1.0, 1e-3, 1e6}) {
        if (scale != 1 && seed != 2) continue;
        const Blend_mesh moved = transformed(mesh, random_motion(seed, scale));
        const Blended b = blend_all(moved, {{all_creases(moved), scale}}, 1.0 / 200);
        EXPECT_NEAR(volume_of(b.mesh) / std::pow(scale, 3), volume, 1e-6 * volume) << seed << ", scale " << scale;
      }
  }
}

TEST(Fillet_corners, ErrorOfVolumeGoesWithTheChordTolerance) {
  const Blend_mesh mesh = box({0, 0, 0}, {10, 10, 10});
  std::vector<double> error;
  for (const double tolerance : {3.2e-2, 8e-3, 2e-3, 5e-4})
    error.push_back(
        std::abs(volume_of(blend_all(mesh, {{all_creases(mesh), 2}}, tolerance).mesh) - rounded_box_volume(10, 2)));
  for (std::size_t i = 0; i + 1 < error.size(); ++i)
    EXPECT_GE(order(error[i], error[i + 1]) / 2, 0.7) << error[i] << " " << error[i + 1];
  EXPECT_GE(order(error.front(), error.back()) / 6, 0.85);
}

/// Edges that meet in one corner; all others stay sharp.
TEST(Fillet_corners, OneCornerOfABox) {
  const Blend_mesh mesh = box({0, 0, 0}, {10, 10, 10});
  const double r = 2;
  std::vector<Edge> edges;
  for (const Point_3& to : {Point_3(10, 0, 0), Point_3(0, 10, 0), Point_3(0, 0, 10)})
    edges = joined(edges, edges_along(mesh, {0, 0, 0}, to));
  const Blended b = blend_all(mesh, {{edges, r}}, fine);
  expect_change(b, -3 * spandrel(r) * (10 - r) - r * r * r * (1 - pi / 6), 4e-3);
}

TEST(Fillet_corners, LargeBallInACornerOfABox) {
  const Blend_mesh mesh = box({0, 0, 0}, {10, 8, 6});
  const auto corner = [](const Point_3& p) { return p == Point_3(0, 0, 0); };
  const std::vector<Edge> edges =
      edges_where(mesh, [&](const Point_3& p, const Point_3& q) { return corner(p) || corner(q); });
  for (const double r : {4.0, 4.5, 5.0, 5.8})
    expect_change(blend_all(mesh, {{edges, r}}), -spandrel(r) * (24 - 3 * r) - r * r * r * (1 - pi / 6), 0.02);
}

// Convex polytopes with all edges rounded: the inner parallel body and a ball.

TEST(Fillet_corners, RegularSolids) {
  for (const int faces : {4, 6, 8, 12, 20}) {
    const Polytope body = hull_of(regular_solid(faces));
    const Blend_mesh mesh = body.mesh();
    const double inradius = body.sides().front().height;
    for (const double share : {0.1, 0.4}) {
      SCOPED_TRACE(std::to_string(faces) + " faces, radius " + std::to_string(share) + " of the inradius");
      const double r = share * inradius;
      const Blended b = blend_all(mesh, {{all_creases(mesh), r}}, 1e-3);
      if (!b.outcome.ok()) continue;
      // Segments between arcs and chords: at most 2/3 of the chord's height deep on average.
      EXPECT_NEAR(b.change, rounded_volume(body, r) - body.volume(),
                  1.2 * 2.0 / 3 * 1e-3 * r * area_of(b.mesh, b.outcome.blend_faces));
      EXPECT_NEAR(area_of(b.mesh), rounded_area(body, r), 2e-3 * rounded_area(body, r));
    }
  }
}

TEST(Fillet_corners, AllEdgesOfAPyramid) {
  for (const double height : {3.0, 5.0, 10.0}) {
    SCOPED_TRACE(height);
    const Polytope body = pyramid(5, height);
    const Blend_mesh mesh = body.mesh();
    const Blended b = blend_all(mesh, {{all_creases(mesh), 0.5}}, 5e-4);
    expect_change(b, rounded_volume(body, 0.5) - body.volume(), 5e-3);
  }
}

/// What a ball at rest takes away at a vertex of a polytope, up to the planes across the edges through its centre: the
/// polytope between centre, contacts, feet on the edges and vertex, less the ball's sector. The sector's solid angle is
/// that of the cone of normals, 2 pi less the face angles at the vertex.
double removed_at_corner(const Polytope& body, std::size_t vertex, const Vec3& center, double r) {
  const Vec3 v = body.points()[vertex];
  double volume = 0, angles = 0;
  for (std::size_t f = 0; f < body.sides().size(); ++f) {
    if (!body.has(f, vertex)) continue;
    const Vec3 contact = center + r * body.sides()[f].normal;
    std::vector<Vec3> along;
    for (const Polytope_edge& e : body.edges())
      if ((e.a == vertex || e.b == vertex) && (e.f == f || e.g == f))
        along.push_back((body.points()[e.a == vertex ? e.b : e.a] - v).normalized());
    for (const Vec3& u : along) volume += r / 3 * ((center - v).dot(u) * u).cross(contact - v).norm() / 2;
    angles += std::acos(along[0].dot(along[1]));
  }
  return volume - r * r * r / 3 * (2 * pi - angles);
}

/// Four faces with one ball in common; the edges of the base stay sharp, and the base cuts the rounds.
TEST(Fillet_corners, ApexOfAPyramid) {
  for (const double height : {3.0, 5.0, 10.0}) {
    SCOPED_TRACE(height);
    const Polytope body = pyramid(5, height);
    const Blend_mesh mesh = body.mesh();
    const double r = 0.5;
    const double slope =
        std::hypot(height, 5) / 5;  // a face through the axis at the centre's height is r * slope below the apex
    const Vec3 center(0, 0, height - r * slope);
    double removed = 0;
    for (std::size_t v = 0; v < body.points().size(); ++v)
      if (body.points()[v].z() > 1) removed += removed_at_corner(body, v, center, r);
    for (const Polytope_edge& e : body.edges()) {
      const Vec3 p = body.points()[e.a], q = body.points()[e.b];
      if (std::max(p.z(), q.z()) < 1) continue;
      const Vec3 up = (p.z() > q.z() ? p - q : q - p).normalized();
      std::vector<Half_space> sides = body.sides();
      sides.push_back(half_space(up, center));
      removed += removed_by_round(Polytope(sides), {body.sides()[e.f], body.sides()[e.g], r});
    }
    const std::vector<Edge> edges =
        edges_where(mesh, [](const Point_3& p, const Point_3& q) { return std::max(p.z(), q.z()) > 1; });
    ASSERT_EQ(edges.size(), 4u);
    const Blended b = blend_all(mesh, {{edges, r}}, fine);
    expect_change(b, -removed, 1e-2);  // flat arcs: chords count for more
  }
}

// Prisms with right angles, all edges rounded. Where the outline turns in, the concave upright edge comes first: it adds
// a spandrel of the full height and makes the caps' outline round there; the ball then rolls along that arc with its
// centre outside of it, and takes a spandrel turned about the arc's centre by a quarter turn (Pappus). Straight edges
// are shorter by the radius of what they end in, and each convex corner of the outline has two eighths of a ball.

using Outline = std::vector<std::pair<double, double>>;

const Outline l_outline{{0, 0}, {10, 0}, {10, 4}, {4, 4}, {4, 10}, {0, 10}};
const Outline t_outline{{0, 0}, {14, 0}, {14, 4}, {9, 4}, {9, 12}, {5, 12}, {5, 4}, {0, 4}};
const Outline u_outline{{0, 0}, {14, 0}, {14, 10}, {10, 10}, {10, 4}, {4, 4}, {4, 10}, {0, 10}};
const Outline plus_outline{{4, 0},  {8, 0},  {8, 4}, {12, 4}, {12, 8}, {8, 8},
                           {8, 12}, {4, 12}, {4, 8}, {0, 8},  {0, 4},  {4, 4}};

struct Change {
  double added = 0, removed = 0;
  [[nodiscard]] double total() const { return added - removed; }
};

/// Convex edges of radius r, the concave uprights of radius groove.
Change all_edges_of_prism(const Outline& outline, double h, double r, double groove) {
  Change change;
  const std::size_t n = outline.size();
  const auto side = [&](std::size_t i) {
    return Vec3(outline[(i + 1) % n].first - outline[i % n].first, outline[(i + 1) % n].second - outline[i % n].second,
                0);
  };
  const auto reflex = [&](std::size_t i) { return side(i + n - 1).cross(side(i)).z() < 0; };
  for (std::size_t i = 0; i < n; ++i) {
    const auto shorter = [&](std::size_t k) { return reflex(k % n) ? groove : r; };
    change.removed += 2 * spandrel(r) * (side(i).norm() - shorter(i) - shorter(i + 1));
    if (reflex(i)) {
      change.added += spandrel(groove) * h;
      change.removed += 2 * spandrel(r) * pi / 2 * (groove + spandrel_centroid(r));
    } else {
      change.removed += spandrel(r) * (h - 2 * r) + 2 * r * r * r * (1 - pi / 6);
    }
  }
  return change;
}

TEST(Fillet_corners, AllEdgesOfBrackets) {
  const double h = 6;
  int which = 0;
  for (const Outline& outline : {l_outline, t_outline, u_outline, plus_outline}) {
    const Blend_mesh mesh = tower(outline, {0, h});
    for (const auto& [r, groove] : {std::pair(1.0, 1.0), std::pair(1.0, 1.7)}) {
      SCOPED_TRACE("outline " + std::to_string(which) + ", radii " + std::to_string(r) + " and " +
                   std::to_string(groove));
      Edge_blend convex{{}, r}, concave{{}, groove};
      for (const Edge e : all_creases(mesh)) (is_convex_edge(e, mesh) ? convex : concave).edges.push_back(e);
      const Blended b = blend_all(mesh, {convex, concave}, 1e-3);
      if (!b.outcome.ok()) continue;
      const Change change = all_edges_of_prism(outline, h, r, groove);
      EXPECT_NEAR(b.change, change.total(), 8e-3 * (change.added + change.removed));
    }
    ++which;
  }
}

/// The rim of one end of a bracket, over its grooves: uprights that bend outward stay sharp, which makes mitres there.
TEST(Fillet_corners, MixedCornersOfABracketOneByOne) {
  const double h = 6, r = 1;
  const Blend_mesh mesh = tower(l_outline, {0, h});
  const auto at_reflex = [](const Point_3& p) { return p.x() == 4 && p.y() == 4 && p.z() == 6; };
  const std::vector<Edge> edges =
      edges_where(mesh, [&](const Point_3& p, const Point_3& q) { return at_reflex(p) || at_reflex(q); });
  ASSERT_EQ(edges.size(), 3u);
  // Both rims run out at their other ends, from the arc on.
  const double expected =
      spandrel(r) * h - 2 * spandrel(r) * (6 - r) - pi / 2 * (r + spandrel_centroid(r)) * spandrel(r);
  expect_change(blend_all(mesh, {{edges, r}}, fine), expected, 5e-3);
}

/// Condition on both ends: within the square of the boss or pit, its edges.
std::vector<Edge> edges_of_square(const Blend_mesh& mesh, double low, double high) {
  return edges_where(mesh, [&](const Point_3& p, const Point_3& q) {
    const auto in = [&](const Point_3& s) {
      return std::max(std::abs(s.x()), std::abs(s.y())) == 4 && s.z() >= low && s.z() <= high;
    };
    return in(p) && in(q);
  });
}

TEST(Fillet_corners, FootOfASquareBoss) {
  const Blend_mesh mesh = boss_or_pit(false);
  for (const auto& [r, upright] : {std::pair(1.0, 1.0), std::pair(1.5, 1.0), std::pair(0.7, 2.0)}) {
    SCOPED_TRACE(std::to_string(r) + " around " + std::to_string(upright));
    Edge_blend convex{{}, upright}, concave{{}, r};
    for (const Edge e : edges_of_square(mesh, 0, 6)) {
      const bool up = mesh.point(mesh.vertex(e, 0)).z() != mesh.point(mesh.vertex(e, 1)).z();
      if (up) convex.edges.push_back(e);
      if (!up && !is_convex_edge(e, mesh)) concave.edges.push_back(e);
    }
    const double added = spandrel(r) * (4 * (8 - 2 * upright) + 2 * pi * (upright + spandrel_centroid(r)));
    const Blended b = blend_all(mesh, {convex, concave}, 5e-4);
    if (b.outcome.ok()) {
      EXPECT_NEAR(b.change, added - 4 * spandrel(upright) * 6, 5e-3 * (added + 4 * spandrel(upright) * 6));
    }
  }
}

TEST(Fillet_corners, AllEdgesOfASquareBoss) {
  const Blend_mesh mesh = boss_or_pit(false);
  const double r = 1, foot = spandrel(r) * (4 * (8 - 2 * r) + 2 * pi * (r + spandrel_centroid(r)));
  const double removed = 4 * spandrel(r) * (6 - r) + 4 * spandrel(r) * (8 - 2 * r) + 4 * r * r * r * (1 - pi / 6);
  const Blended b = blend_all(mesh, {{edges_of_square(mesh, 0, 6), r}}, 5e-4);
  if (b.outcome.ok()) {
    EXPECT_NEAR(b.change, foot - removed, 5e-3 * (foot + removed));
  }
}

TEST(Fillet_corners, AllEdgesOfASquarePit) {
  const Blend_mesh mesh = boss_or_pit(true);
  const double r = 1, added = spandrel(r) * (4 * (8 - 2 * r) + 4 * (6 - r)) + 4 * r * r * r * (1 - pi / 6);
  const double rim = spandrel(r) * (4 * (8 - 2 * r) + 2 * pi * (r + spandrel_centroid(r)));
  const Blended all = blend_all(mesh, {{edges_of_square(mesh, -6, 0), r}}, 5e-4);
  if (all.outcome.ok()) {
    EXPECT_NEAR(all.change, added - rim, 5e-3 * (added + rim));
  }
  std::vector<Edge> concave;
  for (const Edge e : edges_of_square(mesh, -6, 0))
    if (!is_convex_edge(e, mesh)) concave.push_back(e);
  expect_change(blend_all(mesh, {{concave, r}}, 5e-4), added, 5e-3);
}

// Mitres. At a corner of a box the rounds of two edges, the third edge being sharp, overlap in the points of both
// spandrels. With z measured from the face between them, both are w(z) = r - sqrt(r^2 - (r - z)^2) wide there: the
// overlap is the integral of w1 w2, for equal radii r^3 (5/3 - pi/2).

double overlap_of_mitre(double r1, double r2) {
  const double depth = std::min(r1, r2);
  const auto width = [](double r, double z) { return r - std::sqrt(std::max(0.0, r * r - (r - z) * (r - z))); };
  double sum = 0;
  const int steps = 100000;
  for (int i = 0; i < steps; ++i) {
    const double z = (i + 0.5) * depth / steps;
    sum += width(r1, z) * width(r2, z) * depth / steps;
  }
  return sum;
}

TEST(Fillet_corners, MitresOfABox) {
  EXPECT_NEAR(overlap_of_mitre(2, 2), 8 * (5.0 / 3 - pi / 2), 1e-6);
  const Blend_mesh mesh = box({0, 0, 0}, {10, 10, 10});
  const std::vector<Edge> x = edges_along(mesh, {0, 0, 0}, {10, 0, 0}), y = edges_along(mesh, {0, 0, 0}, {0, 10, 0});
  for (const auto& [r1, r2] : {std::pair(2.0, 2.0), std::pair(2.0, 1.0), std::pair(1.0, 2.0), std::pair(2.0, 1.9)}) {
    SCOPED_TRACE(std::to_string(r1) + " and " + std::to_string(r2));
    const double expected = -10 * (spandrel(r1) + spandrel(r2)) + overlap_of_mitre(r1, r2);
    const Blended b = blend_all(mesh, {{x, r1}, {y, r2}}, fine);
    expect_change(b, expected, 4e-3);
    const Blended other = blend_all(mesh, {{y, r2}, {x, r1}}, fine);
    EXPECT_NEAR(other.change, b.change, 1e-9 * 1000);
  }
}

std::vector<Edge> rim_of_box(const Blend_mesh& mesh) {
  return edges_where(mesh, [](const Point_3& p, const Point_3& q) { return p.z() == 10 && q.z() == 10; });
}

TEST(Fillet_corners, FourMitresAroundAFace) {
  const double expected = -4 * (10 * spandrel(2) - overlap_of_mitre(2, 2));
  for (unsigned seed = 0; seed < 10; ++seed) {  // one of the four goes first
    SCOPED_TRACE(seed);
    const Blend_mesh mesh = shuffled(box({0, 0, 0}, {10, 10, 10}), seed);
    expect_change(blend_all(mesh, {{rim_of_box(mesh), 2}}), expected, 0.02);
  }
}

TEST(Fillet_corners, FourMitresOfDifferentRadii) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    SCOPED_TRACE(seed);
    const Blend_mesh mesh = shuffled(box({0, 0, 0}, {10, 10, 10}), seed);
    const std::vector<Edge> rim = rim_of_box(mesh);
    const std::array<double, 4> radius{2, 1, 2.5, 1.5};
    std::vector<Edge_blend> blends;
    double expected = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      Edge_blend& blend = blends.emplace_back();
      blend.edges = {rim[i]};
      blend.radius = radius[i];
      expected -= 10 * spandrel(radius[i]);
      for (std::size_t k = 0; k < i; ++k)
        for (const int end : {0, 1})
          for (const int other : {0, 1})
            if (mesh.vertex(rim[i], end) == mesh.vertex(rim[k], other))
              expected += overlap_of_mitre(radius[i], radius[k]);
    }
    expect_change(blend_all(mesh, blends), expected, 0.02);
  }
}

TEST(Fillet_corners, ChainOfThreeEdgesOnABox) {
  const Blend_mesh mesh = box({0, 0, 0}, {10, 10, 10});
  const std::vector<Edge> chain =
      joined(joined(edges_along(mesh, {0, 0, 0}, {10, 0, 0}), edges_along(mesh, {0, 0, 0}, {0, 0, 10})),
             edges_along(mesh, {0, 0, 10}, {0, 10, 10}));
  expect_change(blend_all(mesh, {{chain, 1.5}}, fine), -30 * spandrel(1.5) + 2 * overlap_of_mitre(1.5, 1.5), 4e-3);
}

/// Three radii at one corner: no ball touches all three rounds' faces. The rounds are at least what each takes alone, and
/// not more than with a corner cube of the largest radius. The order in which they are given does not matter.
void blend_three_radii(const std::array<double, 3>& r) {
  SCOPED_TRACE(std::to_string(r[0]) + " " + std::to_string(r[1]) + " " + std::to_string(r[2]));
  const Blend_mesh mesh = box({0, 0, 0}, {10, 10, 10});
  const std::vector<std::vector<Edge>> edges{edges_along(mesh, {0, 0, 0}, {10, 0, 0}),
                                             edges_along(mesh, {0, 0, 0}, {0, 10, 0}),
                                             edges_along(mesh, {0, 0, 0}, {0, 0, 10})};
  double least = 0, most = 0, big = 0;
  for (const double x : r) {
    least += spandrel(x) * (10 - 2);
    most += spandrel(x) * 10;
    big = std::max(big, x);
  }
  std::array<std::size_t, 3> order{0, 1, 2};
  std::optional<double> first;
  do {
    const Blended b = blend_all(
        mesh, {{edges[order[0]], r[order[0]]}, {edges[order[1]], r[order[1]]}, {edges[order[2]], r[order[2]]}});
    if (!b.outcome.ok()) break;
    EXPECT_LT(-b.change, most + big * big * big * (1 - pi / 6));
    EXPECT_GT(-b.change, least);
    if (first) {
      EXPECT_NEAR(b.change, *first, 1e-9 * 1000);
    }
    first = b.change;
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(Fillet_corners, ThreeRadiiAtACorner) {
  for (const std::array<double, 3>& r : {std::array<double, 3>{1, 1.5, 2}, {2, 1, 1}, {0.5, 2, 1}})
    blend_three_radii(r);
}

TEST(Fillet_corners, TwoLargeRadiiAndASmallerAtACorner) { blend_three_radii({2, 2, 1}); }

// A cylinder cut in half: arcs of many small edges meet straight ones.

Blend_mesh half_cylinder(double R, double h, int n) {
  Outline outline;
  for (int i = 0; i <= n; ++i)
    outline.emplace_back(R * std::cos(pi * i / n), i == 0 || i == n ? 0 : R * std::sin(pi * i / n));
  return tower(outline, {0, h});
}

/// The rims of one end. At depth z all of the half disk goes that is nearer than w(z) to the straight side or to the arc.
TEST(Fillet_corners, RimOfAHalfCylinder) {
  const double R = 8, h = 10, r = 1.5;
  const Blend_mesh mesh = half_cylinder(R, h, 96);
  const std::vector<Edge> rim =
      edges_where(mesh, [&](const Point_3& p, const Point_3& q) { return p.z() == h && q.z() == h; });
  double removed = 0;
  const int steps = 100000;
  for (int i = 0; i < steps; ++i) {
    const double z = (i + 0.5) * r / steps, w = r - std::sqrt(r * r - (r - z) * (r - z)), q = R - w;
    const double segment = q * q * std::acos(w / q) - w * std::sqrt(q * q - w * w);
    removed += (pi * R * R / 2 - segment) * r / steps;
  }
  expect_change(blend_all(mesh, {{rim, r}}, 5e-4), -removed, 0.01);
}

TEST(Fillet_corners, AllEdgesOfAHalfCylinder) {
  // Inner parallel body: prism of height H over the segment of radius R - r at r from the middle, of area A and
  // perimeter P; moved out by r it gains 2 r (A + P H / 2) + pi r^2 (P / 2 + H) + 4/3 pi r^3 (Steiner).
  const double R = 8, h = 10, r = 1;
  const Blend_mesh mesh = half_cylinder(R, h, 96);
  const double q = R - r, half = std::acos(r / q), chord = 2 * q * std::sin(half);
  const double A = q * q * half - r * chord / 2, P = 2 * q * half + chord, H = h - 2 * r;
  const double volume = A * H + 2 * r * (A + P * H / 2) + pi * r * r * (P / 2 + H) + 4 * pi * r * r * r / 3;
  const Blended b = blend_all(mesh, {{all_creases(mesh, 20), r}}, 5e-4);
  expect_change(b, volume - pi * R * R / 2 * h, 0.02);
}

// What holds of every blend.

struct Body {
  const char* what;
  Blend_mesh mesh;
  double r;
};

std::vector<Body> bodies() {
  return {{"box", box({0, 0, 0}, {10, 8, 6}), 1},
          {"bracket", tower(l_outline, {0, 6}), 1},
          {"boss", boss_or_pit(false), 1},
          {"pit", boss_or_pit(true), 1},
          {"pyramid", pyramid(5, 5).mesh(), 0.5}};
}

/// Corners are triangulated as the numbering has it: to within the facets' chords.
TEST(Fillet_corners, FollowsMotionScaleAndOrder) {
  for (const Body& body : bodies()) {
    SCOPED_TRACE(body.what);
    const Blended plain = blend_all(body.mesh, {{all_creases(body.mesh), body.r}}, 5e-3);
    if (!plain.outcome.ok()) continue;
    const double volume = volume_of(plain.mesh);
    for (const double scale : {1e-3, 1.0, 1e6}) {
      const Blend_mesh moved = transformed(body.mesh, random_motion(5, scale));
      const Blended b = blend_all(moved, {{all_creases(moved), scale * body.r}}, 5e-3);
      EXPECT_NEAR(volume_of(b.mesh) / std::pow(scale, 3), volume, 1e-5 * volume) << scale;
    }
    for (const unsigned seed : {1u, 2u, 3u}) {
      const Blend_mesh other = shuffled(body.mesh, seed);
      const Blended b = blend_all(other, {{all_creases(other), body.r}}, 5e-3);
      EXPECT_NEAR(volume_of(b.mesh), volume, 1e-5 * volume) << seed;
    }
    const Blend_mesh image = mirrored(body.mesh);
    EXPECT_NEAR(volume_of(blend_all(image, {{all_creases(image), body.r}}, 5e-3).mesh), volume, 1e-5 * volume);
  }
}

void blend_again(const Blend_mesh& mesh, double r) {
  std::vector<std::vector<char>> gaps;  // what comes after them goes to other addresses
  std::vector<Blend_mesh> ballast;
  Blend_mesh first;
  for (int k = 0; k < 6; ++k) {
    gaps.emplace_back(1000 * (k + 1));
    ballast.push_back(mesh);
    const Blended b = blend_all(mesh, {{all_creases(mesh), r}}, 2e-2);
    if (k == 0) first = b.mesh;
    EXPECT_TRUE(identical(first, b.mesh)) << k;
  }
}

TEST(Fillet_corners, SameInputGivesTheSameBytesWhereverItLiesInMemory) {
  blend_again(box({0, 0, 0}, {10, 8, 6}), 1);
  blend_again(tower(l_outline, {0, 6}), 1);
  blend_again(pyramid(5, 5).mesh(), 0.5);
}

TEST(Fillet_corners, SameInputGivesTheSameBytesOnClosedChains) {
  blend_again(boss_or_pit(false), 1);
  blend_again(boss_or_pit(true), 1);
}

TEST(Fillet_corners, OrderOfTheSelectionDoesNotMatter) {
  for (const Body& body : bodies()) {
    SCOPED_TRACE(body.what);
    std::vector<Edge> edges = all_creases(body.mesh);
    const Blended plain = blend_all(body.mesh, {{edges, body.r}}, 5e-3);
    if (!plain.outcome.ok()) continue;
    std::mt19937 random(7);
    for (int k = 0; k < 2; ++k) {
      for (std::size_t i = edges.size(); i > 1; --i) std::swap(edges[i - 1], edges[random() % i]);
      const Blended b = blend_all(body.mesh, {{edges, body.r}}, 5e-3);
      EXPECT_NEAR(b.change, plain.change, 1e-9 * volume_of(body.mesh));
      std::vector<Edge_blend> apart;  // each edge a blend of its own
      for (const Edge e : edges) {
        Edge_blend& blend = apart.emplace_back();
        blend.edges = {e};
        blend.radius = body.r;
      }
      EXPECT_NEAR(blend_all(body.mesh, apart, 5e-3).change, plain.change, 1e-9 * volume_of(body.mesh));
    }
  }
}

TEST(Fillet_corners, FacesAwayFromTheBlendsAreUntouched) {
  const Blend_mesh mesh = grid_box({0, 0, 0}, {10, 10, 10}, 16);
  const Blended b = blend_all(mesh, {{all_creases(mesh), 1}});
  ASSERT_TRUE(b.outcome.ok());
  const std::vector<Face> far = faces_beyond(mesh, 1.7, [](const Point_3& p) {  // from the nearest edge
    std::array<double, 3> d;
    for (int k = 0; k < 3; ++k) d[k] = std::min(p[k], 10 - p[k]);
    std::sort(d.begin(), d.end());
    return std::hypot(d[0], d[1]);
  });
  ASSERT_GT(far.size(), mesh.number_of_faces() / 3);
  EXPECT_TRUE(faces_kept_in_order(mesh, b.mesh, far));
  EXPECT_GE(b.outcome.kept_faces, far.size());
}

TEST(Fillet_corners, LargestRadiusIsTold) {
  const Blend_mesh brick = box({0, 0, 0}, {10, 8, 6}), l = tower(l_outline, {0, 6}), roof = pyramid(5, 5).mesh(),
                   tetrahedron = hull_of(regular_solid(4)).mesh();
  struct Case {
    const char* what;
    const Blend_mesh& mesh;
    std::vector<Edge> edges;
    double radius, limit;
  };
  const std::vector<Case> cases{
      {"box", brick, all_creases(brick), 3.6, 3},
      {"rim of a box", brick,
       edges_where(brick, [](const Point_3& p, const Point_3& q) { return p.z() == 6 && q.z() == 6; }), 4.8, 4},
      {"bracket", l, all_creases(l), 2.4, 2},
      {"pyramid", roof, all_creases(roof), 2.5, 5 / (1 + std::sqrt(2.0))},
      {"tetrahedron", tetrahedron, all_creases(tetrahedron), 0.65, 1 / std::sqrt(3.0)}};
  for (const Case& c : cases) {
    SCOPED_TRACE(c.what);
    const auto most = expect_largest_radius(c.mesh, c.edges, c.radius, options_of(0, 5e-3));
    if (most) {
      EXPECT_NEAR(*most, c.limit, 0.1 * c.limit);
    }
  }
}

// Polytopes at random, with any of their edges rounded.

/// A convex polytope of which some edges are rounded: a point is inside if it is in no round and in no corner beyond the
/// ball. Rounds are continued along their edges; in a convex body nothing else is there.
class Rounded_polytope {
 public:
  explicit Rounded_polytope(const Polytope& body) : body_(body) {}

  void round(const Polytope_edge& e, double r) { rounds_.push_back({body_.sides()[e.f], body_.sides()[e.g], r}); }
  void rest_at(const Vec3& center, double r, const std::vector<std::size_t>& faces) {
    corners_.push_back({center, r, faces});
  }

  /// Positive outside, negative inside; near the surface about the distance from it.
  [[nodiscard]] double above(const Vec3& p) const {
    double worst = -1e300;
    for (const Half_space& s : body_.sides()) worst = std::max(worst, s.above(p));
    for (const Edge_round& round : rounds_)
      if (const auto off = round.off_axis(p)) worst = std::max(worst, *off - round.r);
    for (const Corner& c : corners_) {
      Eigen::Matrix3d m;
      for (int k = 0; k < 3; ++k) m.col(k) = body_.sides()[c.faces[k]].normal;
      if (((m.inverse() * (p - c.center)).array() >= 0).all()) worst = std::max(worst, (p - c.center).norm() - c.r);
    }
    return worst;
  }

 private:
  struct Corner {
    Vec3 center;
    double r;
    std::vector<std::size_t> faces;
  };
  const Polytope& body_;
  std::vector<Edge_round> rounds_;
  std::vector<Corner> corners_;
};

/// Box cut by random planes: three faces at every vertex.
Polytope random_simple_polytope(std::mt19937& random) {
  std::vector<Half_space> sides = polytope_of_box({-1, -1, -1}, {1, 1, 1}).sides();
  for (int k = 0; k < 5; ++k) {
    const Vec3 n = random_direction(random);
    sides.push_back({n, 0.75 + 0.3 * (random() / 4294967296.0)});
  }
  return Polytope(sides);
}

struct Random_blend {
  std::vector<Edge_blend> blends;
  std::vector<std::size_t> chosen;  // edges of the polytope
  double r = 0;
};

Random_blend random_selection(const Polytope& body, const Blend_mesh& mesh, double share, double r,
                              std::mt19937& random) {
  Random_blend result;
  result.r = r;
  result.blends.emplace_back().radius = r;
  for (std::size_t k = 0; k < body.edges().size(); ++k) {
    if (random() / 4294967296.0 >= share) continue;
    const Polytope_edge& e = body.edges()[k];
    result.blends[0].edges.push_back(
        mesh.edge(mesh.halfedge(Vertex(static_cast<std::uint32_t>(e.a)), Vertex(static_cast<std::uint32_t>(e.b)))));
    result.chosen.push_back(k);
  }
  return result;
}

/// Valid, or refused by name with nothing written.
void expect_valid_or_refused(const Fillet_outcome& outcome, const Blend_mesh& out) {
  if (outcome.ok()) {
    EXPECT_TRUE(validate(out).ok());
    return;
  }
  EXPECT_EQ(status_class(outcome.diagnosis.status), Status_class::blend) << message(outcome.diagnosis);
  EXPECT_EQ(out.number_of_faces(), 0u);
}

/// What has become of blends of bodies at random.
struct Tally {
  int tried = 0, done = 0;
  std::map<std::string, int> refusals;

  /// Expects a valid result, or a refusal; true if it is the first.
  bool blend(const Blend_mesh& mesh, const std::vector<Edge_blend>& blends, double chord_tolerance, Blend_mesh& out) {
    Fillet_options options = options_of(0, chord_tolerance);
    options.smooth_angle = 1;  // there are blunt edges
    const Fillet_outcome outcome = unchecked::fillet_edges(mesh, blends, out, options);
    ++tried;
    expect_valid_or_refused(outcome, out);
    ++(outcome.ok() ? done : refusals[name(outcome.diagnosis.status)]);
    return outcome.ok();
  }

  void print(const char* what) const {
    std::string counts;
    for (const auto& [status, count] : refusals) counts += ", " + std::to_string(count) + " " + status;
    std::cout << what << ": " << done << " of " << tried << " blended" << counts << "\n";
  }
};

TEST(Fillet_corners, SimplePolytopesAtRandom) {
  Tally tally;
  for (const unsigned seed : {0u, 3u, 4u, 5u, 6u, 7u, 12u, 13u}) {
    std::mt19937 random(seed);
    const Polytope body = random_simple_polytope(random);
    const Blend_mesh mesh = body.mesh();
    double shortest = 1e300;
    for (const Polytope_edge& e : body.edges()) shortest = std::min(shortest, body.length(e));
    for (const double share : {0.2, 0.5, 1.0}) {
      const double r = 0.25 * std::clamp(shortest, 0.1, 1.0);
      const Random_blend choice = random_selection(body, mesh, share, r, random);
      if (choice.chosen.empty()) continue;
      SCOPED_TRACE("seed " + std::to_string(seed) + ", share " + std::to_string(share) + ", radius " +
                   std::to_string(r));
      const double tolerance = 2e-2;
      Blend_mesh out;
      if (!tally.blend(mesh, choice.blends, tolerance, out)) continue;
      Rounded_polytope rounded(body);
      std::map<std::size_t, int> degree;
      for (const std::size_t k : choice.chosen) {
        rounded.round(body.edges()[k], r);
        ++degree[body.edges()[k].a];
        ++degree[body.edges()[k].b];
      }
      for (const auto& [v, n] : degree) {
        if (n != 3) continue;
        std::vector<std::size_t> faces;
        for (std::size_t f = 0; f < body.sides().size(); ++f)
          if (body.has(f, v)) faces.push_back(f);
        Eigen::Matrix3d m;
        Vec3 heights;
        for (int k = 0; k < 3; ++k) {
          m.row(k) = body.sides()[faces[k]].normal.transpose();
          heights[k] = body.sides()[faces[k]].height - r;
        }
        rounded.rest_at(m.inverse() * heights, r, faces);
      }
      double worst = 0;
      Vec3 where = Vec3::Zero();
      for (const Face f : out.faces()) {
        Vec3 middle = Vec3::Zero();
        for (const Vertex v : out.vertices_around_face(out.halfedge(f))) {
          middle += vec3(out.point(v)) / 3;
          const double off = std::abs(rounded.above(vec3(out.point(v))));
          if (off > worst) where = vec3(out.point(v));
          worst = std::max(worst, off);
        }
        worst = std::max(worst, std::abs(rounded.above(middle)));
      }
      EXPECT_LT(worst, 4 * tolerance * r) << worst / r << " r, at " << where.transpose();
      if (share == 1.0) {
        const double lost = body.volume() - rounded_volume(body, r);
        EXPECT_NEAR(body.volume() - volume_of(out), lost, 0.1 * lost);
      }
    }
  }
  tally.print("simple polytopes");
  EXPECT_GT(2 * tally.done, tally.tried);
}

TEST(Fillet_corners, HullsAtRandom) {
  Tally tally;
  for (unsigned seed = 0; seed < 4; ++seed) {
    std::mt19937 random(100 + seed);
    const Polytope body = random_hull(8 + 4 * seed, random);
    const Blend_mesh mesh = body.mesh();
    for (const double share : {0.05, 0.15, 0.4})
      for (const double r : {0.03}) {
        const Random_blend choice = random_selection(body, mesh, share, r, random);
        if (choice.chosen.empty()) continue;
        SCOPED_TRACE("seed " + std::to_string(seed) + ", share " + std::to_string(share) + ", radius " +
                     std::to_string(r));
        Blend_mesh out;
        if (!tally.blend(mesh, choice.blends, 5e-2, out)) continue;
        // No ball inside the body is cut: the result holds the body with all edges rounded.
        EXPECT_LT(volume_of(out), body.volume());
        EXPECT_GT(volume_of(out), rounded_volume(body, r) - 5e-2 * r * body.area());
      }
  }
  tally.print("hulls");
}

TEST(Fillet_corners, OneEdgeOfAHull) {
  for (unsigned seed = 0; seed < 3; ++seed) {
    std::mt19937 random(100 + seed);
    const Polytope body = random_hull(8 + 4 * seed, random);
    const Blend_mesh mesh = body.mesh();
    for (const Polytope_edge& e : body.edges()) {
      if (body.turn(e) < pi / 9 || body.length(e) < 0.5) continue;
      SCOPED_TRACE("seed " + std::to_string(seed) + ", edge " + std::to_string(e.a) + " " + std::to_string(e.b));
      const double r = 0.01;
      Blend_mesh out;
      Fillet_options options = options_of(r, 2e-2);
      options.smooth_angle = 1;
      const Edge edge =
          mesh.edge(mesh.halfedge(Vertex(static_cast<std::uint32_t>(e.a)), Vertex(static_cast<std::uint32_t>(e.b))));
      const Fillet_outcome outcome = unchecked::fillet_edges(mesh, {{{edge}, r}}, out, options);
      EXPECT_TRUE(outcome.ok()) << message(outcome.diagnosis);
      if (!outcome.ok()) continue;
      EXPECT_TRUE(validate(out).ok());
      const double removed = removed_by_round(body, {body.sides()[e.f], body.sides()[e.g], r});
      EXPECT_NEAR(body.volume() - volume_of(out), removed, 0.3 * removed);
    }
  }
}

}  // namespace
}  // namespace cgal_blend::test
