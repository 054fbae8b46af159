// SPDX-License-Identifier: GPL-3.0-or-later
// Blends that keep the mesh's connectivity: what moves, where to, and how near it comes to the stitched blend.
#include "blends.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace cgal_blend::test {
namespace {

using unchecked::corefine_and_fillet;
using unchecked::fillet_edges;

constexpr double R = 15, r = 5;

Fillet_options mapping(double radius, double chord_tolerance = 1e-5) {
  Fillet_options options = options_of(radius, chord_tolerance);
  options.mode = Blend_mode::map;
  return options;
}

std::vector<Vertex> moved_vertices(const Blend_mesh& before, const Blend_mesh& after) {
  std::vector<Vertex> moved;
  for (const Vertex v : before.vertices())
    if (before.point(v) != after.point(v)) moved.push_back(v);
  return moved;
}

double off_torus(const Point_3& p) { return distance_to_torus(p, {0, 0, r}, {0, 0, 1}, R + r, r); }

struct Mapped {
  Blend_mesh sharp, mesh;
  Fillet_outcome outcome;
  std::vector<Vertex> moved;
};

void check(Mapped& m) {
  EXPECT_EQ(m.outcome.diagnosis.status, Status::ok) << message(m.outcome.diagnosis);
  if (!m.outcome.ok()) return;
  EXPECT_TRUE(validate(m.mesh).ok());
  EXPECT_TRUE(same_connectivity(m.sharp, m.mesh));
  m.moved = moved_vertices(m.sharp, m.mesh);
}

/// The boss and the plate are one mesh, in steps of about the given length.
Mapped foot_of_one_mesh(double step, const Fillet_options& options) {
  Mapped m;
  m.sharp = boss_on_plate(R, 40, 8, 30, step);
  std::vector<Edge> foot;
  for (const Edge e : creases_at_height(m.sharp, 0))
    if (!is_convex_edge(e, m.sharp)) foot.push_back(e);
  m.outcome = fillet_edges(m.sharp, {{foot, 0}}, m.mesh, options);
  check(m);
  return m;
}

/// A boss whose vertices do not meet the plate's.
Blend_mesh boss(int sides, double z0, int rings) {
  return transformed(cylinder(R, sides, z0, 40.3, rings), placement({0, 0, 1}, 0.1));
}

/// The boss and the plate are operands; n squares along the plate of 100, and circles of the boss at the same distances.
Mapped foot_of_a_union(int n, const Fillet_options& options) {
  const Blend_mesh a = grid_box({-50, -50, -10}, {50, 50, 0}, n),
                   b = boss(static_cast<int>(std::lround(0.94 * n)), -5.1, static_cast<int>(0.45 * n));
  Mapped m;
  EXPECT_TRUE(corefine_and_fillet(a, b, Boolean_operation::union_, m.sharp, options_of(0)).ok());
  m.outcome = corefine_and_fillet(a, b, Boolean_operation::union_, m.mesh, options);
  check(m);
  return m;
}

/// Vertices that lie between the linkage curves, by their places before.
bool was_between(const Point_3& p, double margin) {
  const double rho = std::hypot(p.x(), p.y());
  return p.z() > -1e-9 && p.z() < r - margin && rho < R + r - margin && rho > R - 1;
}

double largest_off_torus(const Mapped& m) {
  double largest = 0;
  for (const Vertex v : m.moved) largest = std::max(largest, std::abs(off_torus(m.mesh.point(v))));
  return largest;
}

TEST(Fillet_map, MovedVerticesAreOnTheTorus) {
  std::vector<double> error;
  for (const double step : {1.6, 0.8, 0.4}) {
    const Mapped m = foot_of_one_mesh(step, mapping(r));
    ASSERT_TRUE(m.outcome.ok());
    error.push_back(largest_off_torus(m));
    EXPECT_LT(error.back(), 1.1 * R * (1 - std::cos(step / R / 2)) + 1e-5 * r) << "the height of the boss's facets";
    // Every vertex between the linkage curves has moved.
    for (const Vertex v : m.sharp.vertices())
      EXPECT_TRUE(!was_between(m.sharp.point(v), 0.01) || m.sharp.point(v) != m.mesh.point(v)) << m.sharp.point(v);
    EXPECT_LT(m.outcome.blends.at(0).radius_error, 0.01);
  }
  EXPECT_LT(error[2], 0.25 * error[0]);
}

TEST(Fillet_map, OnlyVerticesNearTheCurveMove) {
  const double step = 0.8;
  for (const Mapped& m : {foot_of_one_mesh(step, mapping(r)), foot_of_a_union(100, mapping(r))}) {
    ASSERT_TRUE(m.outcome.ok());
    ASSERT_GT(m.moved.size(), 500u);
    for (const Vertex v : m.moved) {
      EXPECT_TRUE(was_between(m.sharp.point(v), -1)) << m.sharp.point(v);
      EXPECT_LT(std::sqrt(CGAL::squared_distance(m.sharp.point(v), m.mesh.point(v))), r) << m.sharp.point(v);
    }
    // The report says which faces are changed: those of moved vertices.
    std::set<Face> changed(m.outcome.changed_faces.begin(), m.outcome.changed_faces.end()), expected;
    for (const Vertex v : m.moved)
      for (const Face f : m.mesh.faces_around_target(m.mesh.halfedge(v))) expected.insert(f);
    EXPECT_EQ(changed, expected);
    EXPECT_EQ(m.outcome.kept_faces, m.mesh.number_of_faces() - expected.size());
    EXPECT_EQ(std::set<Face>(m.outcome.blend_faces.begin(), m.outcome.blend_faces.end()), changed);
    EXPECT_EQ(m.outcome.volume, validate(m.mesh).volume);
  }
}

TEST(Fillet_map, MovedVerticesOfAUnionAreOnTheTorus) {
  std::vector<double> error;
  for (const int n : {50, 100}) {
    const Mapped m = foot_of_a_union(n, mapping(r));
    ASSERT_TRUE(m.outcome.ok());
    error.push_back(largest_off_torus(m));
    EXPECT_LT(error.back(), 1.5 * R * (1 - std::cos(pi / (0.94 * n))) + 1e-5 * r);
  }
  EXPECT_LT(error[1], 0.5 * error[0]);
}

/// Largest distance of points of the mapped faces between the linkage curves from the torus.
double off_torus_over_faces(const Mapped& m) {
  double largest = 0;
  constexpr int n = 4;
  for (const Face f : m.outcome.blend_faces) {
    const auto c = corners_of(m.mesh, f);
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j) {
        const Point_3 p = CGAL::barycenter(m.mesh.point(Vertex(c[0])), 1.0 * i / n, m.mesh.point(Vertex(c[1])),
                                           1.0 * j / n, m.mesh.point(Vertex(c[2])), 1.0 * (n - i - j) / n);
        if (was_between(p, 0)) largest = std::max(largest, std::abs(off_torus(p)));
      }
  }
  return largest;
}

TEST(Fillet_map, FacesComeNearTheTorusAsTheMeshIsRefined) {
  std::vector<double> error, volume;
  for (const double step : {1.6, 0.8, 0.4}) {
    const Mapped m = foot_of_one_mesh(step, mapping(r));
    ASSERT_TRUE(m.outcome.ok());
    error.push_back(off_torus_over_faces(m));
    volume.push_back(std::abs(volume_of(m.mesh) - volume_of(m.sharp) - foot_volume(R, r)) / foot_volume(R, r));
    EXPECT_LT(m.outcome.blends.at(0).coarseness, 1.5 * error.back() / r);
  }
  EXPECT_GT(order(error[0], error[1]), 1);
  EXPECT_GT(order(error[1], error[2]), 1);
  EXPECT_LT(volume[2], 0.02);
  EXPECT_GT(order(volume[0], volume[2]), 2);
}

using Primitive = CGAL::AABB_face_graph_triangle_primitive<Blend_mesh>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

/// Largest distance of vertices and face centres of some faces from another mesh.
double distance_from(const Blend_mesh& mesh, const std::vector<Face>& faces, const Blend_mesh& other) {
  const Tree tree(other.faces().begin(), other.faces().end(), other);
  double largest = 0;
  for (const Face f : faces) {
    const auto c = corners_of(mesh, f);
    const std::array<Point_3, 3> p{mesh.point(Vertex(c[0])), mesh.point(Vertex(c[1])), mesh.point(Vertex(c[2]))};
    for (const Point_3& q :
         {p[0], CGAL::midpoint(p[0], p[1]), CGAL::midpoint(p[1], p[2]), CGAL::centroid(p[0], p[1], p[2])})
      largest = std::max(largest, tree.squared_distance(q));
  }
  return std::sqrt(largest);
}

TEST(Fillet_map, AgreesWithTheStitchedBlendAsTheMeshIsRefined) {
  // Two spheres: nothing is planar, and the operands' edges cross at all angles.
  std::vector<double> apart;
  for (const int level : {3, 4, 5}) {
    const Blend_mesh a = transformed(sphere(10, level), placement({1, 2, 3}, 0.4)),
                     b = sphere(8, level, {9, 0.5, 0.25});
    const Blended stitched = blend(a, b, Boolean_operation::union_, options_of(3, 1e-4));
    const Blended mapped = blend(a, b, Boolean_operation::union_, mapping(3, 1e-4));
    ASSERT_TRUE(stitched.outcome.ok() && mapped.outcome.ok());
    apart.push_back(std::max(distance_from(mapped.mesh, mapped.outcome.blend_faces, stitched.mesh),
                             distance_from(stitched.mesh, stitched.outcome.blend_faces, mapped.mesh)));
  }
  EXPECT_LT(apart[2], 0.03 * 3);
  EXPECT_LT(apart[1], apart[0]);
  EXPECT_GT(order(apart[0], apart[2]), 2 * 1);  // over two refinements
}

TEST(Fillet_map, RoundsConvexRims) {
  Blend_mesh sharp = boss_on_plate(R, 40, 8, 30, 0.8), out;
  const Fillet_outcome outcome = fillet_edges(sharp, {{creases_at_height(sharp, 30), 4}}, out, mapping(4));
  ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
  EXPECT_TRUE(validate(out).ok());
  EXPECT_TRUE(same_connectivity(sharp, out));
  for (const Vertex v : moved_vertices(sharp, out))
    EXPECT_NEAR(distance_to_torus(out.point(v), {0, 0, 26}, {0, 0, 1}, R - 4, 4), 0, 2e-3 * 4);
  EXPECT_NEAR(volume_of(sharp) - volume_of(out), rim_volume(R, 4), 0.05 * rim_volume(R, 4));
}

TEST(Fillet_map, TakesOtherProfiles) {
  for (const Profile& profile : {Profile(chamfer_profile()), Profile(Conic_profile{2}), Profile(G2_profile())}) {
    Fillet_options options = mapping(r);
    options.profile = profile;
    const Mapped m = foot_of_one_mesh(0.8, options);
    ASSERT_TRUE(m.outcome.ok());
    // Every profile of the foot is congruent to the one in the half-plane y = 0.
    std::vector<std::array<double, 2>> section;
    for (int k = 0; k <= 2000; ++k) {
      const Profile_point p = profile(k / 2000.0, {pi / 2, {}});
      section.push_back(
          {(R + r) * (p.centre + p.contact_1) + R * (p.apex + p.contact_2), r * (p.centre + p.contact_2)});
    }
    for (std::size_t i = 0; i < m.moved.size(); i += 5) {
      const Point_3& p = m.mesh.point(m.moved[i]);
      double nearest = r;
      for (const auto& [rho, z] : section)
        nearest = std::min(nearest, std::hypot(std::hypot(p.x(), p.y()) - rho, p.z() - z));
      EXPECT_LT(nearest, 3e-3 * r) << p;
    }
  }
}

TEST(Fillet_map, SameInputGivesTheSameBytes) {
  const Mapped one = foot_of_a_union(60, mapping(r)), two = foot_of_a_union(60, mapping(r));
  EXPECT_TRUE(identical(one.mesh, two.mesh));
}

TEST(Fillet_map, FollowsMotionAndScale) {
  const Blend_mesh a = grid_box({-50, -50, -10}, {50, 50, 0}, 60), b = boss(60, -5.1, 27);
  const double change = blend(a, b, Boolean_operation::union_, mapping(r)).change;
  EXPECT_NEAR(change, foot_volume(R, r), 0.1 * foot_volume(R, r));
  for (const double scale : {1e-3, 1.0, 1e6}) {
    const Placement move = placement({1, 2, 3}, 0.7, {3 * scale, -5 * scale, 8 * scale}, scale);
    const Blended moved =
        blend(transformed(a, move), transformed(b, move), Boolean_operation::union_, mapping(r * scale));
    ASSERT_TRUE(moved.outcome.ok());
    // Aligned operands are triangulated along their common lines, turned ones are not: a few diagonals differ.
    EXPECT_NEAR(moved.change / std::pow(scale, 3), change, 3e-3 * change) << scale;
  }
}

TEST(Fillet_map, SeveralCurvesAtOnce) {
  const Blend_mesh a = grid_box({-50, -50, -10}, {50, 50, 0}, 80), b = boss(80, -30.1, 50);
  Blend_mesh sharp, out;
  ASSERT_TRUE(corefine_and_fillet(a, b, Boolean_operation::union_, sharp, options_of(0)).ok());
  const Fillet_outcome outcome = corefine_and_fillet(a, b, Boolean_operation::union_, out, mapping(4));
  ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
  EXPECT_EQ(outcome.blends.size(), 2u);
  EXPECT_TRUE(validate(out).ok());
  EXPECT_TRUE(same_connectivity(sharp, out));
  EXPECT_NEAR(volume_of(out) - volume_of(sharp), 2 * foot_volume(R, 4), 0.1 * 2 * foot_volume(R, 4));
}

// Meshes that are too coarse to be blended without new vertices.

TEST(Fillet_map, CoarseMeshesAreRefusedByNameOrValid) {
  const Blend_mesh cube = box({-10, -10, 0}, {10, 10, 20});
  struct Case {
    std::string name;
    std::function<Fillet_outcome(Blend_mesh&)> run;
  };
  const Blend_mesh post = box({-5, -5, 10}, {5, 5, 40}), rod = cylinder(5, 32, 10, 40), bore = cylinder(5, 32, -10, 40);
  const Blend_mesh drum = cylinder(10, 32, 0, 20);
  const std::vector<Case> cases{
      {"rod on a box",
       [&](Blend_mesh& out) {
         return corefine_and_fillet(cube, rod, Boolean_operation::union_, out, mapping(2, 2e-3));
       }},
      {"bored box",
       [&](Blend_mesh& out) {
         return corefine_and_fillet(cube, bore, Boolean_operation::difference, out, mapping(2, 2e-3));
       }},
      {"post on a box",
       [&](Blend_mesh& out) {
         return corefine_and_fillet(cube, post, Boolean_operation::union_, out, mapping(2, 2e-3));
       }},
      {"small radius",
       [&](Blend_mesh& out) {
         return corefine_and_fillet(cube, rod, Boolean_operation::union_, out, mapping(0.1, 2e-3));
       }},
      {"rim of a drum",
       [&](Blend_mesh& out) {
         return fillet_edges(drum, {{creases_at_height(drum, 20), 2}}, out, mapping(2, 2e-3));
       }},
      {"large round of a drum",
       [&](Blend_mesh& out) {
         return fillet_edges(drum, {{creases_at_height(drum, 20), 8}}, out, mapping(8, 2e-3));
       }},
      {"top of a box", [&](Blend_mesh& out) {
         return fillet_edges(cube, {{creases_at_height(cube, 20), 2}}, out, mapping(2, 2e-3));
       }}};
  for (const Case& c : cases) {
    Blend_mesh out;
    const Fillet_outcome outcome = c.run(out);
    if (outcome.ok()) {
      EXPECT_TRUE(validate(out).ok()) << c.name;
      continue;
    }
    EXPECT_EQ(status_class(outcome.diagnosis.status), Status_class::blend) << c.name << message(outcome.diagnosis);
    EXPECT_TRUE(outcome.diagnosis.point.has_value()) << c.name;
    EXPECT_TRUE(out.is_empty()) << c.name;
  }
}

}  // namespace
}  // namespace cgal_blend::test
