// SPDX-License-Identifier: GPL-3.0-or-later
// Blends of a part of a curve, between stations within edges: closed forms, flat ends, and what stays as it was.
#include "edge_blends.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace cgal_blend::test {
namespace {

constexpr double fine = 4e-4;  // chord tolerance

/// Share of the section that the segments between arc and chords make up, and a little.
const double arc_share = 2e-4 + 2.0 / 3 * fine * (pi / 2) / spandrel(1);

Vertex vertex_at(const Blend_mesh& mesh, const Point_3& p) {
  for (const Vertex v : mesh.vertices())
    if (CGAL::squared_distance(mesh.point(v), p) < 1e-18) return v;
  ADD_FAILURE() << "no vertex at " << p;
  return Blend_mesh::null_vertex();
}

/// The part of the curve from one point on straight to another, fractions counted from there.
Edge_blend part(const Blend_mesh& mesh, const Point_3& p, const Point_3& q, double radius, double from, double to) {
  Edge_blend blend{edges_along(mesh, p, q), radius};
  blend.start = vertex_at(mesh, p);
  blend.from = from;
  blend.to = to;
  return blend;
}

struct Flat_end {
  double area = 0, off_plane = 0, tilt_deg = 0;  // largest distance and angle against the plane
};

/// Faces of the blend near a point that lie in a plane through it but for a hundredth of `size`.
Flat_end flat_end(const Blended& b, const Point_3& on_plane, const Vector_3& normal, double size) {
  Flat_end result;
  for (const Face f : b.outcome.blend_faces) {
    double off = 0;
    const Face_corners v = corners_of(b.mesh, f);
    if (CGAL::squared_distance(b.mesh.point(Vertex(v[0])), on_plane) > 4 * size * size) continue;
    for (const std::size_t k : v)
      off = std::max(off, std::abs(distance_to_plane(b.mesh.point(Vertex(k)), on_plane, normal)));
    const Vector_3 n = CGAL::cross_product(b.mesh.point(Vertex(v[1])) - b.mesh.point(Vertex(v[0])),
                                           b.mesh.point(Vertex(v[2])) - b.mesh.point(Vertex(v[0])));
    const double tilt = std::atan2(std::sqrt(CGAL::cross_product(n, normal).squared_length()), std::abs(n * normal));
    if (off > size / 100 || tilt > pi / 4) continue;
    result.area += std::sqrt(n.squared_length()) / 2;
    result.off_plane = std::max(result.off_plane, off);
    result.tilt_deg = std::max(result.tilt_deg, tilt * 180 / pi);
  }
  return result;
}

/// A whole spandrel in a plane.
void expect_flat_end(const Blended& b, const Point_3& on_plane, const Vector_3& normal, double r,
                     double off_plane = 1e-12, double tilt_deg = 1e-4) {
  const Flat_end end = flat_end(b, on_plane, normal, r);
  EXPECT_NEAR(end.area, spandrel(r), 0.01 * spandrel(r));
  EXPECT_LE(end.off_plane, off_plane * r);
  EXPECT_LE(end.tilt_deg, tilt_deg);
}

TEST(Fillet_partial, EdgeOfABox) {
  const Blend_mesh mesh = box({0, 0, 0}, {10, 8, 6});
  const Point_3 p(0, 8, 6), q(10, 8, 6);
  for (const auto& [from, to] : std::vector<std::pair<double, double>>{
           {0.25, 0.75}, {0, 0.4}, {0.4, 1}, {0.5, 0.51}, {0.01, 0.99}, {1.0 / 3, 0.998}}) {
    SCOPED_TRACE(std::to_string(from) + " to " + std::to_string(to));
    for (const bool forward : {true, false}) {
      const Blended b =
          blend_all(mesh, {forward ? part(mesh, p, q, 1, from, to) : part(mesh, q, p, 1, 1 - to, 1 - from)}, fine);
      expect_change(b, -spandrel(1) * 10 * (to - from), arc_share);
      if (!b.outcome.ok()) continue;
      const Blend_report& report = b.outcome.blends.at(0);
      EXPECT_TRUE(report.convex);
      EXPECT_FALSE(report.closed);
      EXPECT_EQ(report.edges, 1u);
      EXPECT_EQ(report.flat_ends, (from > 0 ? 1u : 0u) + (to < 1 ? 1u : 0u));
      EXPECT_LT(report.radius_error, 1e-5);
      EXPECT_LT(report.tangency_deg, 1e-3);
      if (from > 0) expect_flat_end(b, {10 * from, 8, 6}, {1, 0, 0}, 1);
      if (to < 1) expect_flat_end(b, {10 * to, 8, 6}, {1, 0, 0}, 1);
      const auto off_cylinder = [&](const Point_3& at) {
        const bool at_end = std::min(std::abs(at.x() - 10 * from), std::abs(at.x() - 10 * to)) < 1e-12;
        const bool on_box = std::abs(at.y() - 8) < 1e-12 || std::abs(at.z() - 6) < 1e-12;  // the sides of the flat ends
        return at_end && on_box ? 0 : distance_to_cylinder(at, {0, 7, 5}, {1, 0, 0}, 1);
      };
      expect_on(b, 1, 1e-3, off_cylinder);
    }
  }
}

TEST(Fillet_partial, ConcaveEdge) {
  const Blend_mesh mesh = l_bracket(10, 4, 6);
  for (const auto& [from, to] : std::vector<std::pair<double, double>>{{0.25, 0.75}, {0, 0.3}, {0.6, 1}}) {
    SCOPED_TRACE(std::to_string(from) + " to " + std::to_string(to));
    const Blended b = blend_all(mesh, {part(mesh, {4, 4, 0}, {4, 4, 6}, 1.5, from, to)}, fine);
    expect_change(b, spandrel(1.5) * 6 * (to - from), arc_share);
    if (!b.outcome.ok()) continue;
    EXPECT_FALSE(b.outcome.blends.at(0).convex);
    if (from > 0) expect_flat_end(b, {4, 4, 6 * from}, {0, 0, 1}, 1.5);
    if (to < 1) expect_flat_end(b, {4, 4, 6 * to}, {0, 0, 1}, 1.5);
  }
}

/// On a grid edges of the mesh pass near the flat ends, and stations fall on vertices and next to them.
TEST(Fillet_partial, StationsAmongVertices) {
  const double r = 1.3;
  const Blend_mesh mesh = grid_box({0, 0, 0}, {10, 10, 10}, 10);
  for (const double from : {0.2, 0.20005, 0.2003, 0.205, 0.25, 0.2 + 0.2 / 3, 0.29995}) {
    SCOPED_TRACE(from);
    const Blended b = blend_all(mesh, {part(mesh, {0, 10, 10}, {10, 10, 10}, r, from, 0.7)}, fine);
    const double moved = 1e-3 * r;  // as far as a station may be moved
    expect_change(b, -spandrel(r) * 10 * (0.7 - from), arc_share + moved / (10 * (0.7 - from)));
    if (b.outcome.ok()) {
      expect_flat_end(b, {10 * from, 10, 10}, {1, 0, 0}, r, 1e-3);
    }
  }
}

/// The radius runs from one end of the part to the other, from the blend's start on.
TEST(Fillet_partial, LawRunsOverThePart) {
  const Blend_mesh mesh = box({0, 0, 0}, {10, 8, 6});
  const Point_3 p(0, 8, 6), q(10, 8, 6);
  Edge_blend forward = part(mesh, p, q, 0, 0.2, 0.8), backward = part(mesh, q, p, 0, 0.2, 0.8);
  forward.law = backward.law = Linear_radius{0.5, 1.5};
  const double squares = (0.25 + 0.75 + 2.25) / 3;
  for (const bool turned : {false, true}) {
    const Blended b = blend_all(mesh, {turned ? backward : forward}, fine);
    expect_change(b, -spandrel(1) * squares * 6, arc_share);
    expect_flat_end(b, {turned ? 8.0 : 2.0, 8, 6}, {1, 0, 0}, 0.5);
    expect_flat_end(b, {turned ? 2.0 : 8.0, 8, 6}, {1, 0, 0}, 1.5);
  }
  Blend_mesh out;
  Fillet_options options = options_of(0, fine);
  options.law = Linear_radius{0.5, 1.5};
  forward.law.reset();
  ASSERT_TRUE(unchecked::fillet_edges(mesh, {forward}, out, options).ok());
  EXPECT_TRUE(identical(out, blend_all(mesh, {[&] {
                                         forward.law = options.law;
                                         return forward;
                                       }()},
                                       fine)
                                 .mesh));
}

TEST(Fillet_partial, SeveralPartsOfOneEdge) {
  const Blend_mesh mesh = box({0, 0, 0}, {10, 8, 6});
  const Point_3 p(0, 8, 6), q(10, 8, 6);
  const Blended three = blend_all(
      mesh, {part(mesh, p, q, 1, 0.1, 0.2), part(mesh, q, p, 0.5, 0.4, 0.6), part(mesh, p, q, 1, 0.7, 0.95)}, fine);
  expect_change(three, -spandrel(1) * 3.5 - spandrel(0.5) * 2, arc_share);
  EXPECT_EQ(three.outcome.blends.size(), 3u);
  for (const double x : {1.0, 2.0, 7.0, 9.5}) expect_flat_end(three, {x, 8, 6}, {1, 0, 0}, 1);
  for (const double x : {4.0, 6.0}) expect_flat_end(three, {x, 8, 6}, {1, 0, 0}, 0.5);
  const Blended one = blend_all(mesh, {part(mesh, p, q, 1, 0.2, 0.5), part(mesh, q, p, 1, 0.2, 0.5)}, fine);
  expect_change(one, -spandrel(1) * 6, arc_share);
  EXPECT_EQ(one.outcome.blends.size(), 1u) << "parts that meet and want the same are one";
}

/// One blend stands for all of its curves.
TEST(Fillet_partial, PartOfEveryEdge) {
  const Blend_mesh mesh = box({0, 0, 0}, {10, 8, 6});
  Edge_blend blend{all_creases(mesh), 0.7};
  blend.from = 0.3;
  blend.to = 0.6;
  const Blended b = blend_all(mesh, {blend}, fine);
  expect_change(b, -spandrel(0.7) * 0.3 * 4 * (10 + 8 + 6), arc_share);
  EXPECT_EQ(b.outcome.blends.size(), 12u);
}

/// Three parts that begin in one corner share the ball at rest there.
TEST(Fillet_partial, PartsThatBeginInACorner) {
  const Blend_mesh mesh = box({0, 0, 0}, {10, 8, 6});
  const Blended b =
      blend_all(mesh,
                {part(mesh, {0, 0, 0}, {10, 0, 0}, 1, 0, 0.5), part(mesh, {0, 0, 0}, {0, 8, 0}, 1, 0, 0.5),
                 part(mesh, {0, 0, 0}, {0, 0, 6}, 1, 0, 0.5)},
                fine);
  // Beyond the ball's centre each has its spandrel; the corner is a cube less an eighth of a ball.
  expect_change(b, -(spandrel(1) * (12 - 3) + 1 - pi / 6), arc_share);
  for (const Blend_report& report : b.outcome.blends) EXPECT_EQ(report.flat_ends, 1u);
}

/// Stations within chords of a polygon: the volume is a share of the torus's, ends lie in planes through the axis.
TEST(Fillet_partial, RimOfACylinder) {
  const double R = 5, r = 1;
  for (const int n : {64, 256}) {
    SCOPED_TRACE(n);
    const Blend_mesh mesh = cylinder(R, n, 0, 10);
    const auto on_rim = [&](double fraction) {
      const auto corner = [&](double i) {
        return Point_3(R * std::cos(2 * pi * i / n), R * std::sin(2 * pi * i / n), 10);
      };
      const double i = std::floor(fraction * n), t = fraction * n - i;
      return corner(i) + t * (corner(i + 1) - corner(i));
    };
    for (const auto& [from, to] : std::vector<std::pair<double, double>>{{0.1, 0.6}, {0.3, 0.9}, {0.8, 0.2}}) {
      SCOPED_TRACE(std::to_string(from) + " to " + std::to_string(to));
      Edge_blend blend{creases_at_height(mesh, 10), r};
      blend.start = vertex_at(mesh, {R, 0, 10});
      blend.from = from;
      blend.to = to;
      // The rim's own sense decides on which side of the start the part lies.
      Blended b = blend_all(mesh, {blend}, fine);
      const double length = to - from + (to < from ? 1 : 0);
      expect_change(b, -rim_volume(R, r) * length, 0.005);
      expect_on(b, r, 0.01, [&](const Point_3& p) {
        const bool is_corner = p.z() == 10 && std::hypot(p.x(), p.y()) > R - 0.1;
        return is_corner ? 0 : distance_to_torus(p, {0, 0, 10 - r}, {0, 0, 1}, R - r, r);
      });
      const bool turned = flat_end(b, on_rim(from), on_rim(from + 0.25) - Point_3(0, 0, 10), r).area < spandrel(r) / 2;
      for (const double end : {from, to}) {
        const double at = turned ? 1 - end : end;
        const Point_3 p = on_rim(at);
        expect_flat_end(b, p, Vector_3(-p.y(), p.x(), 0), r, 0.01, 0.01);
      }
    }
  }
}

/// A crease too shallow to count as one by itself ends flat at a station too, and does not fade.
TEST(Fillet_partial, ShallowCrease) {
  const double bend = 15 * pi / 180, r = 10;
  const Blend_mesh mesh = prism({{-5, 0}, {5, 0}, {5, 4}, {0, 4 + 5 * std::tan(bend / 2)}, {-5, 4}}, 0, 20);
  const Point_3 p(0, 4 + 5 * std::tan(bend / 2), 0), q(p.x(), p.y(), 20);
  const Blended b = blend_all(mesh, {part(mesh, p, q, r, 0.25, 0.75)}, fine);
  const double section = (std::tan(bend / 2) - bend / 2) * r * r;
  expect_change(b, -section * 10, 2e-4 + 2.0 / 3 * fine * bend * r * r / section);
  EXPECT_EQ(b.outcome.blends.at(0).flat_ends, 2u);
}

/// Edges of any angle between planes.
TEST(Fillet_partial, EdgesOfBodiesAtRandom) {
  std::mt19937 random(3);
  Fillet_options options = options_of(0, fine);
  options.smooth_angle = 5;
  for (int trial = 0; trial < 30; ++trial) {
    std::vector<Vec3> points;
    for (int i = 0; i < 12; ++i) points.push_back(8 * random_direction(random));
    const Polytope body = hull_of(points);
    const Blend_mesh mesh = body.mesh();
    const Polytope_edge e = body.edges()[static_cast<std::size_t>(random()) % body.edges().size()];
    const Vec3 p = body.points()[e.a], q = body.points()[e.b];
    const double length = (q - p).norm(), turn = body.turn(e), r = 0.02 * length;
    if (turn < 0.2) continue;
    SCOPED_TRACE(trial);
    Blend_mesh out;
    const Fillet_outcome outcome = unchecked::fillet_edges(
        mesh, {part(mesh, {p.x(), p.y(), p.z()}, {q.x(), q.y(), q.z()}, r, 0.3, 0.6)}, out, options);
    ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
    EXPECT_TRUE(validate(out).ok());
    EXPECT_EQ(outcome.blends.at(0).flat_ends, 2u);
    const double section = (std::tan(turn / 2) - turn / 2) * r * r, expected = section * 0.3 * length;
    const double share = 1e-3 + 2.0 / 3 * fine * turn * r * r / section;
    EXPECT_NEAR(volume_of(mesh) - volume_of(out), expected, share * expected);
  }
}

/// Beside a coarse round the arc is tangent to normals of no facet, and leaves the body before it comes back into it. The
/// sections of a prism are alike, so volumes are as lengths.
TEST(Fillet_partial, BesideACoarseRound) {
  for (const int steps : {8, 9, 12, 24}) {
    SCOPED_TRACE(steps);
    std::vector<std::pair<double, double>> outline;  // half a disk
    for (int i = 0; i <= steps; ++i) outline.emplace_back(5 * std::cos(pi * i / steps), 5 * std::sin(pi * i / steps));
    outline.front().second = outline.back().second = 0;
    const Blend_mesh mesh = prism(outline, 0, 20);
    const Point_3 p(5, 0, 0), q(5, 0, 20);
    for (const double r : {0.3, 1.0}) {
      const Blended long_part = blend_all(mesh, {part(mesh, p, q, r, 0.1, 0.9)}, fine);
      const Blended half = blend_all(mesh, {part(mesh, p, q, r, 0.25, 0.75)}, fine);
      expect_change(half, long_part.change * 0.5 / 0.8, 0.005);
      EXPECT_LT(half.change, 0);
      const Flat_end end = flat_end(half, {5, 0, 5}, {0, 0, 1}, r);
      EXPECT_GT(end.area, 0);
      EXPECT_LT(end.off_plane, 1e-3 * r);
    }
  }
}

TEST(Fillet_partial, FollowsMotionScaleAndOrder) {
  const Blend_mesh mesh = l_bracket(10, 4, 6);
  struct Case {
    Point_3 from, to;
  };
  for (const Case& c : {Case{{4, 4, 0}, {4, 4, 6}}, Case{{0, 0, 0}, {10, 0, 0}}}) {
    const Blended plain = blend_all(mesh, {part(mesh, c.from, c.to, 1, 0.3, 0.65)});
    ASSERT_TRUE(plain.outcome.ok());
    const double volume = volume_of(plain.mesh);
    for (const double scale : {1e-3, 1.0, 1e6}) {
      const Placement motion = random_motion(5, scale);
      const Blend_mesh moved = transformed(mesh, motion);
      Edge_blend blend{edges_along(moved, motion.transform(c.from), motion.transform(c.to)), scale};
      blend.start = vertex_at(mesh, c.from);  // the order is the same
      blend.from = 0.3;
      blend.to = 0.65;
      const Blended b = blend_all(moved, {blend});
      EXPECT_NEAR(volume_of(b.mesh) / std::pow(scale, 3), volume, 1e-6 * volume) << scale;
      expect_flat_end(b, motion.transform(c.from + 0.3 * (c.to - c.from)), motion.transform(c.to - c.from), scale,
                      1e-9);
    }
    for (const unsigned seed : {1u, 2u, 3u, 4u}) {
      const Blend_mesh other = shuffled(mesh, seed);
      EXPECT_NEAR(volume_of(blend_all(other, {part(other, c.from, c.to, 1, 0.3, 0.65)}).mesh), volume, 1e-9 * volume);
    }
    EXPECT_TRUE(identical(plain.mesh, blend_all(mesh, {part(mesh, c.from, c.to, 1, 0.3, 0.65)}).mesh));
  }
}

// What stays, and where faces come from.

/// Every face lies in the face that it is told to be a part of, or is new; whole ones are the first.
void expect_origins(const Blend_mesh& mesh, const Blended& b) {
  ASSERT_EQ(b.outcome.origins.size(), b.mesh.number_of_faces());
  std::size_t fresh = 0;
  for (const Face f : b.mesh.faces()) {
    const std::uint32_t origin = b.outcome.origins[f.idx()];
    fresh += origin == no_origin ? 1 : 0;
    if (origin == no_origin) continue;
    const Face_corners of = corners_of(mesh, Face(origin)), part = corners_of(b.mesh, f);
    const auto at = [&](std::size_t k) { return mesh.point(Vertex(of[k % 3])); };
    const Vector_3 n = CGAL::cross_product(at(1) - at(0), at(2) - at(0));
    for (const std::size_t v : part) {
      const Point_3& p = b.mesh.point(Vertex(v));
      EXPECT_NEAR(distance_to_plane(p, at(0), n), 0, 1e-12);
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_GT(distance_to_plane(p, at(k), CGAL::cross_product(n, at(k + 1) - at(k))), -1e-12);
    }
    if (f.idx() >= b.outcome.kept_faces) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto is_there = [&](std::size_t v) { return b.mesh.point(Vertex(v)) == at(k); };
      EXPECT_TRUE(std::any_of(part.begin(), part.end(), is_there));
    }
  }
  EXPECT_EQ(fresh, b.outcome.blend_faces.size());
  EXPECT_EQ(b.outcome.changed_faces.size() + b.outcome.kept_faces, b.mesh.number_of_faces());
}

TEST(Fillet_partial, OriginsOfFaces) {
  const Blend_mesh plain = box({0, 0, 0}, {10, 8, 6}), grid = grid_box({0, 0, 0}, {10, 10, 10}, 10);
  const Blended b = blend_all(plain, {part(plain, {0, 8, 6}, {10, 8, 6}, 1, 0.2, 0.5)});
  expect_origins(plain, b);
  EXPECT_EQ(b.outcome.kept_faces, 10u) << "all but the two beside the edge";
  const Blended g = blend_all(grid, {part(grid, {0, 10, 10}, {10, 10, 10}, 1, 0.43, 0.58)});
  expect_origins(grid, g);
  const std::vector<Face> far = faces_beyond(
      grid, 3.5, [](const Point_3& p) { return std::sqrt(CGAL::squared_distance(p, Point_3(5, 10, 10))); });
  ASSERT_GT(far.size(), grid.number_of_faces() * 3 / 4);
  EXPECT_TRUE(faces_kept_in_order(grid, g.mesh, far));
  EXPECT_GE(g.outcome.kept_faces, far.size());
}

/// A part that is left sharp leaves its faces as they were.
TEST(Fillet_partial, KeepGoingDividesNothingInVain) {
  const Blend_mesh mesh = box({0, 0, 0}, {10, 8, 6});
  const Edge_blend good = part(mesh, {0, 8, 6}, {10, 8, 6}, 1, 0.25, 0.75);
  const Edge_blend bad = part(mesh, {0, 0, 0}, {10, 0, 0}, 9, 0.25, 0.75);
  Fillet_options options = options_of(0);
  options.keep_going = true;
  Blended both;
  both.outcome = unchecked::fillet_edges(mesh, {bad, good}, both.mesh, options);
  ASSERT_TRUE(both.outcome.ok()) << message(both.outcome.diagnosis);
  EXPECT_TRUE(identical(both.mesh, blend_all(mesh, {good}).mesh));
  expect_origins(mesh, both);
  ASSERT_EQ(both.outcome.blends.size(), 2u);
  const auto refused =
      std::count_if(both.outcome.blends.begin(), both.outcome.blends.end(), [](const Blend_report& report) {
        return report.diagnosis.status == Status::radius_exceeds_face && report.radius == 9 &&
               report.diagnosis.max_radius;
      });
  EXPECT_EQ(refused, 1);
  options.keep_going = false;
  EXPECT_EQ(unchecked::fillet_edges(mesh, {bad, good}, both.mesh, options).diagnosis.status,
            Status::radius_exceeds_face);
  EXPECT_EQ(both.mesh.number_of_faces(), 0u);
}

TEST(Fillet_partial, FlawsStayAsTheyAre) {
  const Blend_mesh mesh = box_with_folded_spike();
  const std::vector<Flaw> flaws = validate(mesh, Flaw_policy::accept).flaws;
  ASSERT_FALSE(flaws.empty());
  const Edge_blend blend = part(mesh, {0, 0, 0}, {4, 0, 0}, 0.3, 0.1, 0.6);
  Blend_mesh out;
  const Fillet_outcome outcome = unchecked::fillet_edges(mesh, {blend}, flaws, out, options_of(0, fine));
  ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
  EXPECT_EQ(validate(out, Flaw_policy::accept).flaws.size(), flaws.size());
  EXPECT_NEAR(volume_of(out) - volume_of(mesh), -spandrel(0.3) * 2, 1e-2 * spandrel(0.3) * 2);
  const Halfedge h = mesh.halfedge(blend.edges.front());
  const std::vector<Flaw> beside{{Status::input_self_intersecting, {mesh.face(h), mesh.face(mesh.opposite(h))}}};
  Edge_blend within = blend;
  within.edges = {blend.edges.front()};
  within.start.reset();
  EXPECT_EQ(unchecked::fillet_edges(mesh, {within}, beside, out, options_of(0)).diagnosis.status,
            Status::input_self_intersecting);
}

// Refusals.

TEST(Fillet_partial, LargestRadiusIsTold) {
  const Blend_mesh mesh = box({0, 0, 0}, {10, 8, 6});
  Blend_mesh out;
  const auto run = [&](double r) {
    return unchecked::fillet_edges(mesh, {part(mesh, {0, 0, 0}, {10, 0, 0}, r, 0.25, 0.75)}, out, options_of(0));
  };
  const Fillet_outcome refused = run(9);
  ASSERT_TRUE(refused.diagnosis.max_radius) << message(refused.diagnosis);
  EXPECT_NEAR(*refused.diagnosis.max_radius, 6, 0.15) << "the box is 6 high";
  EXPECT_TRUE(run(*refused.diagnosis.max_radius).ok());
  EXPECT_FALSE(run(1.02 * *refused.diagnosis.max_radius).ok());
}

TEST(Fillet_partial, RefusesByName) {
  const Blend_mesh mesh = box({0, 0, 0}, {10, 8, 6});
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  Blend_mesh out;
  const auto status = [&](const std::vector<Edge_blend>& blends, const Fillet_options& options) {
    const Status result = unchecked::fillet_edges(mesh, blends, out, options).diagnosis.status;
    EXPECT_EQ(out.number_of_faces(), 0u);
    return result;
  };
  const Point_3 p(0, 0, 0), q(10, 0, 0);
  for (const auto& [from, to] : std::vector<std::pair<double, double>>{{0.5, 0.5},
                                                                       {0.7, 0.3},
                                                                       {-0.1, 0.5},
                                                                       {0.2, 1.1},
                                                                       {nan, 1},
                                                                       {0, nan},
                                                                       {inf, 1},
                                                                       {0, -inf},
                                                                       {1, 1},
                                                                       {0, 0},
                                                                       {0.5, 0.50001}}) {
    SCOPED_TRACE(std::to_string(from) + " to " + std::to_string(to));
    EXPECT_EQ(status({part(mesh, p, q, 1, from, to)}, options_of(0)), Status::invalid_parameter);
  }
  Edge_blend elsewhere = part(mesh, p, q, 1, 0.2, 0.5);
  elsewhere.start = vertex_at(mesh, {10, 8, 6});
  EXPECT_EQ(status({elsewhere}, options_of(0)), Status::invalid_parameter);
  Edge_blend without_radius = part(mesh, p, q, 0, 0.2, 0.5);
  EXPECT_EQ(status({without_radius}, options_of(0)), Status::invalid_parameter);
  Fillet_options map = options_of(0);
  map.mode = Blend_mode::map;
  EXPECT_EQ(status({part(mesh, p, q, 1, 0.2, 0.5)}, map), Status::open_branch);
  EXPECT_EQ(status({part(mesh, p, q, 1, 0.2, 0.6), part(mesh, p, q, 0.5, 0.5, 0.8)}, options_of(0)),
            Status::blends_overlap);
  EXPECT_EQ(status({part(mesh, p, q, 1, 0.2, 0.5), part(mesh, p, q, 0.5, 0.5, 0.8)}, options_of(0)), Status::corner);
}

/// Meshes of other types, and chains that grow: fractions are those of the curve as it has grown.
TEST(Fillet_partial, GraphsAndPropagation) {
  const Blend_mesh mesh = cylinder(5, 64, 0, 10);
  Edge_blend blend{{creases_at_height(mesh, 10).front()}, 1};
  blend.from = 0.25;
  blend.to = 0.75;
  Graph_fillet_options options{options_of(0, fine)};
  options.propagate = true;
  Blend_mesh out;
  const Fillet_result<Blend_mesh> result = fillet_edges(mesh, std::vector<Edge_blend>{blend}, out, options);
  ASSERT_TRUE(result.ok()) << message(result.diagnosis);
  const double expected = -rim_volume(5, 1) / 2;
  EXPECT_NEAR(volume_of(out) - volume_of(mesh), expected, 0.005 * std::abs(expected));
}

// Flat ends that nobody asked for.

/// Four columns of heights 3, 2, 1 and 2 round a vertical line: ridges and grooves alternate where the highest one's edge
/// comes down.
TEST(Fillet_partial, FlatEndWhereFacesAreInNoOrder) {
  const Blend_mesh low = box({-2, -2, 0}, {2, 2, 1}), high = box({0, 0, 0}, {2, 2, 3});
  const Blend_mesh middle = tower({{0, 0}, {0, -2}, {2, -2}, {2, 2}, {-2, 2}, {-2, 0}}, {0, 2});
  Blend_mesh body;
  const std::vector<Part> parts{{&middle}, {&high}};
  ASSERT_TRUE(unchecked::corefine_and_fillet_all(low, parts, body, options_of(0)).ok());
  const std::vector<Edge> edge = edges_along(body, {0, 0, 2}, {0, 0, 3});
  ASSERT_EQ(edge.size(), 1u);
  const Blended b = blend_all(body, {{edge, 0.5}}, fine);
  expect_change(b, -spandrel(0.5), arc_share);
  ASSERT_EQ(b.outcome.blends.size(), 1u);
  EXPECT_EQ(b.outcome.blends[0].flat_ends, 1u);
  expect_flat_end(b, {0, 0, 2}, {0, 0, 1}, 0.5);
}

}  // namespace
}  // namespace cgal_blend::test
