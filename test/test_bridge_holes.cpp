// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/bridge.h>

#include "bridge_spheres.h"
#include "checks.h"

#include <CGAL/boost/graph/helpers.h>
#include <cgal_blend/validate.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

// Meshes with holes, each within a contact curve.

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;

std::array<Point_3, 3> points_of(const Blend_mesh& mesh, Face f) {
  const auto [a, b, c] = corners_of(mesh, f);
  return {mesh.point(Vertex(static_cast<std::uint32_t>(a))), mesh.point(Vertex(static_cast<std::uint32_t>(b))),
          mesh.point(Vertex(static_cast<std::uint32_t>(c)))};
}

/// The mesh without the faces whose centroid passes the test.
Blend_mesh without(const Blend_mesh& mesh, const std::function<bool(const Point_3&)>& goes) {
  std::map<Vertex, std::size_t> index;
  std::vector<Point_3> points;
  std::vector<Corner_indices> triangles;
  for (const Face f : mesh.faces()) {
    const auto c = points_of(mesh, f);
    if (goes(CGAL::centroid(c[0], c[1], c[2]))) continue;
    Corner_indices t{};
    std::size_t i = 0;
    for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(f))) {
      const auto [place, is_new] = index.emplace(v, points.size());
      if (is_new) points.push_back(mesh.point(v));
      t[i++] = place->second;
    }
    triangles.push_back(t);
  }
  return mesh_of(points, triangles);
}

/// Two spheres, the first with a hole of angular radius `angle` at the spot.
Blend_mesh spheres_with_hole(double angle) {
  const Two_spheres spheres;
  return without(spheres.mesh(4), [=](const Point_3& p) {
    return p.z() < 1.2 && p.z() > 0 && std::hypot(p.x(), p.y()) < std::sin(angle);
  });
}

/// A tube about the z axis from z = 0 to z = `height`, open at the upper end; and, above, a sphere.
Blend_mesh open_tube(int around, int rings) {
  const Blend_mesh tube = without(cylinder(1, around, 0, 3, rings), [](const Point_3& p) { return p.z() > 3 - 1e-9; });
  return side_by_side(tube, sphere(1.2, 4, {0, 0, 6}));
}

/// Every face of the input outside the contact is there as it was, and first.
void expect_sound(const Blend_mesh& mesh, const Bridge_outcome& outcome, const Blend_mesh& out, long genus_and_pieces) {
  ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
  EXPECT_TRUE(validate(out).ok());
  EXPECT_TRUE(CGAL::is_closed(out));
  EXPECT_EQ(euler(out), genus_and_pieces);
  ASSERT_EQ(outcome.origins.size(), out.number_of_faces());
  for (const std::uint32_t origin : outcome.origins)
    EXPECT_TRUE(origin == no_origin || origin < mesh.number_of_faces()) << origin;
  for (std::uint32_t f = 0; f < outcome.kept_faces; ++f)
    EXPECT_EQ(points_of(out, Face(f)), points_of(mesh, Face(outcome.origins[f])));
  EXPECT_GT(outcome.kept_faces, mesh.number_of_faces() / 4);
}

TEST(Bridge_holes, bridge_a_hole_at_the_spot_as_if_it_were_not_there) {
  const Two_spheres spheres;
  const Blend_mesh mesh = spheres_with_hole(0.25), before = mesh;
  ASSERT_FALSE(CGAL::is_closed(mesh));
  Bridge_options options;
  options.fill_holes = true;
  Blend_mesh out;
  const Bridge_outcome outcome = unchecked::bridge(mesh, spheres.ends(), out, options);
  expect_sound(mesh, outcome, out, 2);
  EXPECT_TRUE(identical(mesh, before));
  // The filling goes on smoothly, so coordinates are nearly those of the sphere, and with them the bridge.
  Blend_mesh whole;
  const Bridge_outcome reference = unchecked::bridge(spheres.mesh(4), spheres.ends(), whole, options);
  ASSERT_TRUE(reference.ok());
  EXPECT_NEAR(outcome.volume, reference.volume, 0.01 * reference.volume);
  EXPECT_LT(outcome.bridges[0].tangency_deg, reference.bridges[0].tangency_deg + 0.5);
}

TEST(Bridge_holes, take_the_centre_of_an_opening_for_a_spot) {
  struct Tube {
    int around, rings;
    double radius;
  };
  // Strips as long as the tube tell nothing of its curvature: the filling is flat then.
  for (const auto& [around, rings, radius] : {Tube{48, 20, 2.2}, Tube{24, 4, 1.8}, Tube{24, 0, 1.5}}) {
    const Blend_mesh mesh = open_tube(around, rings);
    Bridge_options options;
    options.fill_holes = true;
    std::array<Bridge_end, 2> ends{end_at({0, 0, 3}, radius), end_at({0, 0, 4.8}, 0.7)};
    Blend_mesh out;
    const Bridge_outcome outcome = unchecked::bridge(mesh, ends, out, options);
    SCOPED_TRACE(around);
    ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
    EXPECT_TRUE(validate(out).ok());
    EXPECT_EQ(euler(out), 2);
  }
}

TEST(Bridge_holes, join_both_ends_of_an_open_tube_in_a_series) {
  const Blend_mesh tube =
      without(cylinder(1, 48, 0, 3, 20), [](const Point_3& p) { return p.z() > 3 - 1e-9 || p.z() < 1e-9; });
  const Blend_mesh mesh = side_by_side(side_by_side(tube, sphere(1.2, 4, {0, 0, 6})), sphere(1.2, 4, {0, 0, -3}));
  std::vector<Bridge> bridges(2);
  bridges[0].ends = {end_at({0, 0, 3}, 2.2), end_at({0, 0, 4.8}, 0.7)};
  bridges[1].ends = {end_at({0, 0, 0}, 2.2), end_at({0, 0, -1.8}, 0.7)};
  for (Bridge& bridge : bridges) bridge.options.fill_holes = true;
  Blend_mesh out;
  expect_sound(mesh, unchecked::bridge_all(mesh, bridges, out), out, 2);
  bridges.pop_back();
  const Bridge_outcome one = unchecked::bridge_all(mesh, bridges, out);
  EXPECT_EQ(one.diagnosis.status, Status::region_meets_border);
  ASSERT_TRUE(one.diagnosis.point.has_value());
  EXPECT_NEAR(one.diagnosis.point->z(), 0, 1e-9);
  EXPECT_EQ(out.number_of_faces(), 0U);
}

/// The number behind "a radius of ".
double named_radius(const Diagnosis& diagnosis) {
  const std::string before = "a radius of ";
  const std::size_t at = diagnosis.detail.find(before);
  return at == std::string::npos ? 0 : std::stod(diagnosis.detail.substr(at + before.size()));
}

TEST(Bridge_holes, name_the_radius_that_takes_a_hole_away) {
  const Two_spheres spheres;
  const Blend_mesh mesh = spheres_with_hole(0.5);
  Bridge_options options;
  options.fill_holes = true;
  std::array<Bridge_end, 2> ends = spheres.ends();
  ends[0].radius = 0.3;  // within the opening
  Blend_mesh out = mesh;
  const Bridge_outcome refused = unchecked::bridge(mesh, ends, out, options);
  EXPECT_EQ(refused.diagnosis.status, Status::region_meets_border);
  EXPECT_EQ(out.number_of_faces(), 0U);
  ends[0].radius = named_radius(refused.diagnosis);
  ASSERT_GT(ends[0].radius, 0.4) << refused.diagnosis.detail;
  ASSERT_LT(ends[0].radius, 0.7) << refused.diagnosis.detail;
  EXPECT_TRUE(unchecked::bridge(mesh, ends, out, options).ok());
}

TEST(Bridge_holes, refuse_holes_elsewhere_with_their_place) {
  const Two_spheres spheres;
  const Blend_mesh mesh = without(spheres.mesh(4), [](const Point_3& p) { return p.z() < -0.97; });
  Bridge_options options;
  options.fill_holes = true;
  Blend_mesh out;
  const Diagnosis far = unchecked::bridge(mesh, spheres.ends(), out, options).diagnosis;
  EXPECT_EQ(far.status, Status::region_meets_border);
  ASSERT_TRUE(far.point.has_value());
  EXPECT_NEAR(far.point->z(), -0.97, 0.03);
}

TEST(Bridge_holes, are_refused_with_their_name_unless_asked_for) {
  const Two_spheres spheres;
  const Blend_mesh mesh = spheres_with_hole(0.25);
  Blend_mesh out;
  const auto closed_only = bridge(mesh, spheres.ends(), out);
  EXPECT_EQ(closed_only.diagnosis.status, Status::input_not_closed);
  EXPECT_NE(closed_only.diagnosis.detail.find("hole of "), std::string::npos) << closed_only.diagnosis.detail;
  EXPECT_NE(closed_only.diagnosis.detail.find("fill_holes"), std::string::npos) << closed_only.diagnosis.detail;
  ASSERT_TRUE(closed_only.diagnosis.point.has_value());
  EXPECT_LT(CGAL::squared_distance(*closed_only.diagnosis.point, Point_3(0, 0, 1)), 0.01);
  Bridge_options options;
  options.fill_holes = true;
  EXPECT_TRUE(bridge(mesh, spheres.ends(), out, options).ok());
  // Other defects count as ever.
  Blend_mesh crossing = side_by_side(mesh, sphere(0.3, 2, {0, 0, -1}));
  EXPECT_EQ(bridge(crossing, spheres.ends(), out, options).diagnosis.status, Status::input_self_intersecting);
  EXPECT_EQ(bridge(inside_out(mesh), spheres.ends(), out, options).diagnosis.status, Status::input_misoriented);
}

TEST(Bridge_holes, go_where_a_crossing_is_bridged) {
  // The open end of a tube within a sphere.
  const Blend_mesh tube = without(cylinder(0.4, 32, -0.2, 3, 24), [](const Point_3& p) { return p.z() < -0.2 + 1e-9; });
  const Blend_mesh ball = transformed(sphere(1, 4), placement({1, 2, 3}, 0.7));
  Bridge_options options;
  options.fill_holes = true;
  const std::array<Bridge_end, 2> ends{end_at({0, 0, 0}, 0.2), end_at({0, 0, 0}, 0.2)};
  Blend_mesh out;
  const Bridge_outcome outcome = unchecked::bridge_intersection(ball, tube, ends, out, options);
  ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
  EXPECT_TRUE(validate(out).ok());
  EXPECT_EQ(euler(out), 2);
  for (std::uint32_t f = 0; f < outcome.kept_faces; ++f) {
    const std::uint32_t origin = outcome.origins[f];
    const std::uint32_t first = ball.number_of_faces();
    EXPECT_EQ(points_of(out, Face(f)),
              origin < first ? points_of(ball, Face(origin)) : points_of(tube, Face(origin - first)));
  }
}

}  // namespace
