// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/validate.h>

#include "checks.h"
#include "shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <string>

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;

const Point_3 origin(0, 0, 0);

double distance(const Point_3& p, const Point_3& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

bool mentions(const Diagnosis& diagnosis, const std::string& words) {
  return diagnosis.detail.find(words) != std::string::npos;
}

void remove_face(Blend_mesh& mesh, Face f) { CGAL::Euler::remove_face(mesh.halfedge(f), mesh); }

// ---------------------------------------------------------------- whole meshes

TEST(Validate, Measures_a_box) {
  const Validity_report r = validate(box({1, 2, 3}, {3, 5, 7}));
  EXPECT_TRUE(r.ok()) << message(r.diagnosis);
  EXPECT_TRUE(r.finite && r.closed && r.manifold && r.outward && r.intersections_checked);
  EXPECT_EQ(r.vertices, 8u);
  EXPECT_EQ(r.faces, 12u);
  EXPECT_EQ(r.components, 1u);
  EXPECT_DOUBLE_EQ(r.volume, 24);
  EXPECT_DOUBLE_EQ(r.area, 52);
}

TEST(Validate, Accepts_every_shape_wherever_it_lies) {
  const Blend_mesh shapes[] = {grid_box({0, 0, 0}, {1, 2, 3}, 4),
                               cylinder(1, 48, 0, 2, 3),
                               cone(1, 2, 32),
                               torus(2, 0.5, 32, 16),
                               sphere(1, 3),
                               l_bracket(3, 1, 2),
                               plate(4, 1)};
  for (const double scale : {1e-3, 1.0, 1e6})
    for (const Blend_mesh& shape : shapes) {
      const Blend_mesh mesh = transformed(shape, placement({1, 2, 3}, 0.7, {3 * scale, -5 * scale, scale}, scale));
      const Validity_report r = validate(mesh);
      EXPECT_TRUE(r.ok()) << message(r.diagnosis);
      EXPECT_NEAR(r.volume, volume_of(shape) * scale * scale * scale, 1e-9 * r.volume);
      EXPECT_NEAR(r.area, area_of(shape) * scale * scale, 1e-9 * r.area);
    }
}

TEST(Validate, Volume_keeps_its_digits_far_from_the_origin) {
  const Validity_report r = validate(box({1e8, 1e8, 1e8}, {1e8 + 1, 1e8 + 1, 1e8 + 1}));
  EXPECT_DOUBLE_EQ(r.volume, 1);
}

TEST(Validate, Names_an_empty_mesh) {
  EXPECT_EQ(validate(Blend_mesh()).diagnosis.status, Status::input_empty);
  Blend_mesh points_only;
  points_only.add_vertex(origin);
  EXPECT_EQ(validate(points_only).diagnosis.status, Status::input_empty);
}

TEST(Validate, Ignores_vertices_without_faces) {
  Blend_mesh mesh = box(origin, {1, 1, 1});
  mesh.add_vertex(Point_3(1e30, 0, 0));
  mesh.add_vertex(Point_3(std::numeric_limits<double>::quiet_NaN(), 0, 0));
  EXPECT_TRUE(validate(mesh).ok());
}

TEST(Validate, Ignores_removed_elements) {
  Blend_mesh mesh = side_by_side(box(origin, {1, 1, 1}), box({5, 0, 0}, {6, 1, 1}));
  for (std::uint32_t f = 0; f < 12; ++f) remove_face(mesh, Face(f));
  ASSERT_TRUE(mesh.has_garbage());
  const Validity_report r = validate(mesh);
  EXPECT_TRUE(r.ok()) << message(r.diagnosis);
  EXPECT_EQ(r.faces, 12u);
  EXPECT_EQ(r.components, 1u);
  EXPECT_DOUBLE_EQ(r.volume, 1);
}

TEST(Validate, Names_the_vertex_that_is_not_finite) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Blend_mesh mesh = box(origin, {1, 1, 1});
    mesh.point(Vertex(5)) = Point_3(0, bad, 0);
    const Validity_report r = validate(mesh);
    EXPECT_EQ(r.diagnosis.status, Status::input_not_finite);
    EXPECT_FALSE(r.finite);
    EXPECT_EQ(r.diagnosis.detail, "vertex 5");
  }
}

TEST(Validate, Names_the_open_edge) {
  Blend_mesh mesh = box(origin, {1, 1, 1});
  remove_face(mesh, Face(3));  // corners 4, 7, 6 of the top
  const Validity_report r = validate(mesh);
  EXPECT_EQ(r.diagnosis.status, Status::input_not_closed);
  EXPECT_FALSE(r.closed);
  EXPECT_TRUE(r.manifold);
  EXPECT_FALSE(r.outward);
  ASSERT_TRUE(r.diagnosis.point);
  const Point_3 middles[] = {{0.5, 0.5, 1}, {0.5, 1, 1}, {0, 0.5, 1}};
  EXPECT_TRUE(std::find(std::begin(middles), std::end(middles), *r.diagnosis.point) != std::end(middles));
  EXPECT_EQ(r.volume, 0);
  EXPECT_DOUBLE_EQ(r.area, 5.5);
}

TEST(Validate, Lists_flaws_and_accepts_them_on_request) {
  const Blend_mesh mesh = with_needle(box_with_folded_spike(), {1, 1, 0}, {2, 1, 0});
  const Validity_report refused = validate(mesh), accepted = validate(mesh, Flaw_policy::accept);
  EXPECT_EQ(refused.diagnosis.status, Status::input_degenerate);
  EXPECT_TRUE(accepted.ok()) << message(accepted.diagnosis);
  EXPECT_TRUE(accepted.outward);
  EXPECT_EQ(accepted.degenerate_faces, 1u);
  EXPECT_GT(accepted.self_intersections, 0u);
  EXPECT_EQ(refused.self_intersections, accepted.self_intersections);
  ASSERT_EQ(accepted.flaws.size(), 1 + accepted.self_intersections) << "its middle lies on a side of a neighbour";
  EXPECT_EQ(accepted.flaws[0].status, Status::input_degenerate);
  const Face needle(static_cast<std::uint32_t>(mesh.number_of_faces() - 1));
  EXPECT_TRUE(accepted.flaws[0].faces[0] == needle && accepted.flaws[0].faces[1] == needle);
  std::vector<std::pair<Face, Face>> pairs;
  for (const Flaw& flaw : validate(box_with_folded_spike()).flaws) {
    EXPECT_EQ(flaw.status, Status::input_self_intersecting);
    pairs.emplace_back(flaw.faces[0], flaw.faces[1]);
  }
  EXPECT_EQ(pairs, crossing_faces_by_brute_force(box_with_folded_spike()));
}

TEST(Validate, Accepts_pieces_that_cross_each_other_on_request) {
  for (const double inside : {0.0, 0.5}) {  // with a vertex of one in the other, or none
    const Blend_mesh pair =
        side_by_side(box(origin, {4, 4, 4}), box({inside, inside, inside}, {2, 2, inside == 0 ? 2.0 : 5.0}));
    EXPECT_FALSE(validate(pair).ok());
    const Validity_report r = validate(pair, Flaw_policy::accept);
    EXPECT_TRUE(r.ok()) << message(r.diagnosis);
  }
  const Blend_mesh cavity = side_by_side(side_by_side(box(origin, {4, 4, 4}), inside_out(box({1, 1, 1}, {2, 2, 2}))),
                                         box({3, 3, 3}, {5, 5, 5}));
  EXPECT_TRUE(validate(cavity, Flaw_policy::accept).ok());
}

TEST(Validate, Accepts_nothing_but_flaws) {
  const auto status_of = [](const Blend_mesh& mesh) { return validate(mesh, Flaw_policy::accept).diagnosis.status; };
  EXPECT_EQ(status_of(inside_out(box_with_folded_spike())), Status::input_misoriented);
  EXPECT_EQ(status_of(side_by_side(box_with_folded_spike(), inside_out(box({8, 8, 8}, {9, 9, 9})))),
            Status::input_misoriented);
  Blend_mesh open = box_with_folded_spike();
  remove_face(open, Face(3));
  EXPECT_EQ(status_of(open), Status::input_not_closed);
  Blend_mesh endless = box_with_folded_spike();
  endless.point(Vertex(5)) = Point_3(std::numeric_limits<double>::infinity(), 0, 0);
  EXPECT_EQ(status_of(endless), Status::input_not_finite);
  EXPECT_EQ(status_of(Blend_mesh()), Status::input_empty);
}

/// Makes two vertices at one place the same one. `add_face` would not build what comes of it; a defect might.
void weld(Blend_mesh& mesh, const Point_3& place) {
  std::vector<Vertex> there;
  for (const Vertex v : mesh.vertices())
    if (mesh.point(v) == place) there.push_back(v);
  ASSERT_EQ(there.size(), 2u);
  for (const Halfedge h : mesh.halfedges())
    if (mesh.target(h) == there[1]) mesh.set_target(h, there[0]);
  mesh.remove_vertex(there[1]);
}

TEST(Validate, Names_the_edge_with_four_faces) {
  Blend_mesh mesh = side_by_side(box({0, 0, 0}, {1, 1, 1}), box({-1, -1, 0}, {0, 0, 1}));
  weld(mesh, {0, 0, 0});
  weld(mesh, {0, 0, 1});
  const Validity_report r = validate(mesh);
  EXPECT_EQ(r.diagnosis.status, Status::input_not_manifold);
  EXPECT_FALSE(r.manifold);
  EXPECT_EQ(r.diagnosis.point, Point_3(0, 0, 0.5));
  EXPECT_TRUE(mentions(r.diagnosis, "edge between vertices")) << r.diagnosis.detail;
}

/// Two boxes with a common corner; the faces of the second one are 12 to 23.
Blend_mesh two_tips() {
  Blend_mesh mesh = side_by_side(box({0, 0, 0}, {1, 1, 1}), box({-1, -1, -1}, {0, 0, 0}));
  weld(mesh, origin);
  return mesh;
}

TEST(Validate, Finds_halfedges_that_contradict_each_other) {
  Blend_mesh mesh = side_by_side(box({0, 0, 0}, {1, 1, 1}), box({5, 0, 0}, {6, 1, 1}));
  mesh.set_face(mesh.halfedge(Face(3)), Face(15));
  const Validity_report r = validate(mesh);
  EXPECT_EQ(r.diagnosis.status, Status::input_not_manifold);
  EXPECT_TRUE(mentions(r.diagnosis, "not linked")) << r.diagnosis.detail;
}

TEST(Validate, Names_the_vertex_where_two_fans_meet) {
  const Blend_mesh mesh = two_tips();
  ASSERT_TRUE(is_closed_by_counting(mesh));
  ASSERT_FALSE(has_single_fans(mesh));
  const Validity_report r = validate(mesh);
  EXPECT_EQ(r.diagnosis.status, Status::input_not_manifold);
  EXPECT_TRUE(mentions(r.diagnosis, "vertex 0")) << r.diagnosis.detail;
  EXPECT_EQ(r.diagnosis.point, origin);
  EXPECT_FALSE(r.manifold);
  EXPECT_TRUE(r.closed);
}

TEST(Validate, Names_an_inverted_body) {
  const Validity_report r = validate(inside_out(box(origin, {1, 1, 1})));
  EXPECT_EQ(r.diagnosis.status, Status::input_misoriented);
  EXPECT_FALSE(r.outward);
  EXPECT_DOUBLE_EQ(r.volume, -1);
}

TEST(Validate, A_cavity_must_point_into_its_hollow) {
  const Blend_mesh outer = grid_box({0, 0, 0}, {10, 10, 10}, 3);
  const Blend_mesh inner = sphere(2, 2, {5, 5, 5});
  const Validity_report good = validate(side_by_side(outer, inside_out(inner)));
  EXPECT_TRUE(good.ok()) << message(good.diagnosis);
  EXPECT_EQ(good.components, 2u);
  EXPECT_NEAR(good.volume, 1000 - volume_of(inner), 1e-9);

  const Validity_report bad = validate(side_by_side(outer, inner));
  EXPECT_EQ(bad.diagnosis.status, Status::input_misoriented);
  EXPECT_TRUE(mentions(bad.diagnosis, "face 108 ")) << bad.diagnosis.detail;  // the first of the sphere
}

TEST(Validate, A_body_inside_a_cavity_points_outward) {
  const Blend_mesh shell = side_by_side(sphere(10, 3), inside_out(sphere(8, 3)));
  EXPECT_TRUE(validate(side_by_side(shell, sphere(5, 3))).ok());
  EXPECT_EQ(validate(side_by_side(shell, inside_out(sphere(5, 3)))).diagnosis.status, Status::input_misoriented);
}

TEST(Validate, Boxes_of_bodies_may_overlap_without_nesting) {
  // The sphere lies in the torus's hole: its box is inside, it is not.
  const Validity_report r = validate(side_by_side(torus(3, 1, 64, 32), sphere(1, 2)));
  EXPECT_TRUE(r.ok()) << message(r.diagnosis);
  EXPECT_EQ(r.components, 2u);
}

TEST(Validate, Names_the_face_without_area) {
  Blend_mesh mesh = grid_box(origin, {4, 4, 4}, 4);
  const Face_corners v = corners_of(mesh, Face(10));
  mesh.point(Vertex(v[0])) = CGAL::midpoint(mesh.point(Vertex(v[1])), mesh.point(Vertex(v[2])));
  const Validity_report r = validate(mesh);
  EXPECT_EQ(r.diagnosis.status, Status::input_degenerate);
  EXPECT_GE(r.degenerate_faces, 1u);
  EXPECT_TRUE(mentions(r.diagnosis, "face ")) << r.diagnosis.detail;
}

TEST(Validate, Names_the_edge_without_length) {
  Blend_mesh mesh = cylinder(1, 32, 0, 1);
  const Point_3 p = mesh.point(Vertex(0)), q = mesh.point(Vertex(1));
  mesh.point(Vertex(1)) = p + 1e-13 * (q - p) / distance(p, q);
  const Validity_report r = validate(mesh);
  EXPECT_EQ(r.diagnosis.status, Status::input_degenerate);
  EXPECT_EQ(r.short_edges, 1u);
  EXPECT_TRUE(mentions(r.diagnosis, "vertices 0 and 1")) << r.diagnosis.detail;
  for (const Face f : mesh.faces()) {  // each of the two faces at the edge finds it, and no other
    const Face_corners v = corners_of(mesh, f);
    const bool has_edge = std::count(v.begin(), v.end(), 0u) + std::count(v.begin(), v.end(), 1u) == 2;
    EXPECT_EQ(validate_changes(mesh, {f}).short_edges, has_edge ? 1u : 0u);
  }
}

TEST(Validate, An_edge_just_long_enough_passes) {
  Blend_mesh mesh = cylinder(1, 32, 0, 1);
  const Point_3 p = mesh.point(Vertex(0)), q = mesh.point(Vertex(1));
  mesh.point(Vertex(1)) = p + 1e-11 * (q - p) / distance(p, q);
  EXPECT_EQ(validate(mesh).short_edges, 0u);
}

TEST(Validate, Names_crossing_faces_and_where_they_cross) {
  const Blend_mesh mesh = side_by_side(box({-2, -2, -1}, {2, 2, 0}), cylinder(1, 16, -0.5, 2));
  const auto expected = crossing_faces_by_brute_force(mesh);
  ASSERT_FALSE(expected.empty());
  const Validity_report r = validate(mesh);
  EXPECT_EQ(r.diagnosis.status, Status::input_self_intersecting);
  EXPECT_EQ(r.self_intersections, expected.size());
  const auto first = *std::min_element(expected.begin(), expected.end());
  EXPECT_TRUE(mentions(r.diagnosis, "faces " + std::to_string(first.first) + " and " + std::to_string(first.second)));
  ASSERT_TRUE(r.diagnosis.point);
  EXPECT_NEAR(r.diagnosis.point->z(), 0, 1e-12);
  EXPECT_NEAR(distance_to_cylinder(*r.diagnosis.point, origin, {0, 0, 1}, 1), 0, 1 - std::cos(pi / 16));
}

TEST(Validate, Finds_faces_folded_onto_each_other) {
  // A tent whose two sides lie in one plane, one on the other.
  const Blend_mesh mesh =
      mesh_of({{0, 0, 0}, {4, 0, 0}, {2, 3, 0}, {2, 1, 0}}, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}});
  const Validity_report r = validate(mesh);
  EXPECT_EQ(r.diagnosis.status, Status::input_self_intersecting);
  EXPECT_EQ(r.self_intersections, crossing_faces_by_brute_force(mesh).size());
}

TEST(Validate, Bodies_that_touch_in_a_point_intersect) {
  const Validity_report r = validate(side_by_side(box(origin, {1, 1, 1}), box({1, 1, 1}, {2, 2, 2})));
  EXPECT_EQ(r.diagnosis.status, Status::input_self_intersecting);
  ASSERT_TRUE(r.diagnosis.point);
  EXPECT_LT(distance(*r.diagnosis.point, {1, 1, 1}), 1e-12);
}

TEST(Validate, Reports_the_earlier_promise_first) {
  Blend_mesh mesh = side_by_side(box({-2, -2, -1}, {2, 2, 0}), cylinder(1, 16, -0.5, 2));
  remove_face(mesh, Face(0));
  const Validity_report r = validate(mesh);
  EXPECT_EQ(r.diagnosis.status, Status::input_not_closed);
  EXPECT_GT(r.self_intersections, 0u);
}

TEST(Validate, Says_the_same_every_time) {
  const Blend_mesh mesh = side_by_side(sphere(1, 3), transformed(sphere(1, 3), moved_by(0.5, 0.3, 0.2)));
  EXPECT_EQ(message(validate(mesh).diagnosis), message(validate(mesh).diagnosis));
  EXPECT_EQ(validate(mesh).self_intersections, crossing_faces_by_brute_force(mesh).size());
}

TEST(Validate, Agrees_with_brute_force_on_crumpled_spheres) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> push(-0.12, 0.12);
    Blend_mesh mesh = sphere(1, 2);
    for (const Vertex v : mesh.vertices())
      mesh.point(v) = mesh.point(v) + Vector_3(push(random), push(random), push(random));
    EXPECT_EQ(validate(mesh).self_intersections, crossing_faces_by_brute_force(mesh).size());
  }
}

// ---------------------------------------------------------------- changes only

std::vector<Face> faces_near(const Blend_mesh& mesh, const Point_3& centre, double radius) {
  std::vector<Face> near;
  for (const Face f : mesh.faces())
    if (distance(mesh.point(mesh.source(mesh.halfedge(f))), centre) < radius) near.push_back(f);
  return near;
}

TEST(Validate_changes, Accepts_any_part_of_a_good_mesh) {
  const Blend_mesh mesh = transformed(torus(2, 0.7, 48, 24), placement({1, 1, 0}, 0.4));
  const Validity_report whole = validate(mesh);
  for (const std::size_t step : {1, 2, 7, 100}) {
    std::vector<Face> changed;
    for (std::size_t f = 0; f < mesh.number_of_faces(); f += step)
      changed.push_back(Face(static_cast<std::uint32_t>(f)));
    const Validity_report r = validate_changes(mesh, changed);
    EXPECT_TRUE(r.ok()) << message(r.diagnosis);
    EXPECT_TRUE(r.closed && r.manifold && r.outward && r.finite);
    EXPECT_EQ(r.components, 1u);
    EXPECT_DOUBLE_EQ(r.volume, whole.volume);
    EXPECT_DOUBLE_EQ(r.area, whole.area);
  }
}

TEST(Validate_changes, Accepts_no_change_at_all) { EXPECT_TRUE(validate_changes(sphere(1, 1), {}).ok()); }

TEST(Validate_changes, Finds_exactly_the_crossings_of_changed_faces) {
  const Blend_mesh mesh = side_by_side(sphere(1, 3), transformed(sphere(1, 3), moved_by(0.5, 0.3, 0.2)));
  const auto all = crossing_faces_by_brute_force(mesh);
  for (const Point_3& centre : {Point_3(0.2, 0.1, 0.9), Point_3(-0.9, -0.2, 0.1), Point_3(0.25, 0.15, 0.1)})
    for (const double radius : {0.2, 0.5, 1.5}) {
      const std::vector<Face> changed = faces_near(mesh, centre, radius);
      const auto is_changed = [&](Face f) { return std::find(changed.begin(), changed.end(), f) != changed.end(); };
      std::size_t expected = 0;
      for (const auto& [f, g] : all) expected += is_changed(f) || is_changed(g);
      EXPECT_EQ(validate_changes(mesh, changed).self_intersections, expected);
    }
}

TEST(Validate_changes, Finds_a_spike_through_a_far_wall) {
  Blend_mesh mesh = grid_box(origin, {10, 10, 10}, 10);
  Vertex spike;
  for (const Vertex v : mesh.vertices())
    if (mesh.point(v) == Point_3(5, 5, 10)) spike = v;
  ASSERT_TRUE(spike.is_valid());
  mesh.point(spike) = Point_3(5.2, 5.3, -1);
  std::vector<Face> changed;
  for (const Face f : faces_around_target(mesh.halfedge(spike), mesh)) changed.push_back(f);
  const Validity_report r = validate_changes(mesh, changed);
  EXPECT_EQ(r.diagnosis.status, Status::input_self_intersecting);
  EXPECT_EQ(r.self_intersections, crossing_faces_by_brute_force(mesh).size());
  ASSERT_TRUE(r.diagnosis.point);
  EXPECT_NEAR(r.diagnosis.point->z(), 0, 1e-9);
}

TEST(Validate_changes, Finds_a_hole_at_the_changed_faces) {
  Blend_mesh mesh = grid_box(origin, {4, 4, 4}, 4);
  remove_face(mesh, Face(20));
  std::vector<Face> beside;
  for (const Face f : mesh.faces())
    if (f.idx() > 16 && f.idx() < 24) beside.push_back(f);
  const Validity_report r = validate_changes(mesh, beside);
  EXPECT_EQ(r.diagnosis.status, Status::input_not_closed);
}

TEST(Validate_changes, Finds_fans_that_meet_in_a_vertex_though_one_is_unchanged) {
  const Blend_mesh mesh = two_tips();
  std::vector<Face> upper, lower;
  for (const Face f : mesh.faces()) (f.idx() < 12 ? upper : lower).push_back(f);
  EXPECT_EQ(validate_changes(mesh, upper).diagnosis.status, Status::input_not_manifold);
  EXPECT_EQ(validate_changes(mesh, lower).diagnosis.status, Status::input_not_manifold);
}

TEST(Validate_changes, Finds_degenerate_changed_faces) {
  Blend_mesh mesh = grid_box(origin, {4, 4, 4}, 4);
  const Face_corners v = corners_of(mesh, Face(10));
  mesh.point(Vertex(v[0])) = CGAL::midpoint(mesh.point(Vertex(v[1])), mesh.point(Vertex(v[2])));
  EXPECT_EQ(validate_changes(mesh, {Face(10)}).diagnosis.status, Status::input_degenerate);
}

TEST(Validate_changes, Finds_coordinates_that_are_not_finite) {
  Blend_mesh mesh = sphere(1, 2);
  mesh.point(Vertex(3)) = Point_3(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  std::vector<Face> changed;
  for (const Face f : faces_around_target(mesh.halfedge(Vertex(3)), mesh)) changed.push_back(f);
  EXPECT_EQ(validate_changes(mesh, changed).diagnosis.status, Status::input_not_finite);
}

TEST(Validate_changes, A_piece_without_any_old_face_is_judged_by_its_volume) {
  const Blend_mesh mesh = side_by_side(box(origin, {1, 1, 1}), inside_out(box({5, 0, 0}, {6, 1, 1})));
  std::vector<Face> second;
  for (const Face f : mesh.faces())
    if (f.idx() >= 12) second.push_back(f);
  const Validity_report r = validate_changes(mesh, second);
  EXPECT_EQ(r.diagnosis.status, Status::input_misoriented);
  EXPECT_EQ(r.components, 2u);
}

}  // namespace
