// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/filled_mesh.h>

#include "checks.h"
#include "shapes.h"

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <cgal_blend/face_origin.h>
#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;

/// A sphere of radius 1 about the origin without the faces that lie above a height.
Blend_mesh sphere_cut_off(double height) {
  Blend_mesh mesh = transformed(sphere(1, 4), placement({1, 2, 3}, 0.7));
  for (const Face f : std::vector<Face>(mesh.faces().begin(), mesh.faces().end())) {
    const auto corners = corners_of(mesh, f);
    double z = 0;
    for (const std::size_t v : corners) z += mesh.point(Vertex(static_cast<std::uint32_t>(v))).z() / 3;
    if (z > height) CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
  }
  mesh.collect_garbage();
  return mesh;
}

double radius_of(const Point_3& p) { return std::sqrt(CGAL::squared_distance(p, Point_3(0, 0, 0))); }

TEST(Filled_mesh, goes_on_smoothly_behind_the_faces_of_the_input) {
  const Blend_mesh mesh = sphere_cut_off(0.9);
  const Filled_mesh filled = fill_mesh(mesh);
  ASSERT_TRUE(filled.diagnosis.ok());
  EXPECT_TRUE(CGAL::is_closed(filled.mesh));
  ASSERT_EQ(filled.own_faces, mesh.number_of_faces());
  for (const Face f : mesh.faces()) EXPECT_EQ(corners_of(mesh, f), corners_of(filled.mesh, f));
  ASSERT_EQ(filled.holes.size(), 1u);
  EXPECT_EQ(filled.holes[0].first, filled.own_faces);
  EXPECT_EQ(filled.holes[0].last, filled.mesh.number_of_faces());
  for (const Vertex v : filled.mesh.vertices()) EXPECT_NEAR(radius_of(filled.mesh.point(v)), 1, 0.02);
}

TEST(Filled_mesh, finds_points_over_an_opening_only) {
  const Filled_mesh filled = fill_mesh(sphere_cut_off(0.9));
  const auto over = point_on_filling(filled, {0.1, 0, 0.89}, 0.05);
  ASSERT_TRUE(over.has_value());
  EXPECT_NEAR(over->x(), 0.1, 0.02);  // along the axis of the opening, which is about that of z
  EXPECT_NEAR(radius_of(*over), 1, 0.02);
  EXPECT_FALSE(point_on_filling(filled, {0, 0, 0.5}, 0.05).has_value());
  EXPECT_FALSE(point_on_filling(filled, {0.8, 0, 0.89}, 0.05).has_value());
}

TEST(Filled_mesh, tells_which_hole_is_left) {
  const Filled_mesh filled = fill_mesh(sphere_cut_off(0.9));
  const auto last_own = static_cast<std::uint32_t>(filled.own_faces - 1);
  EXPECT_EQ(hole_left(filled, {0, no_origin, last_own}), nullptr);
  EXPECT_EQ(hole_left(filled, {0, last_own + 1}), &filled.holes[0]);
  EXPECT_NEAR(centre(filled, filled.holes[0]).z(), 0.9, 0.03);
}

TEST(Filled_mesh, judges_meshes_but_for_their_holes) {
  const Blend_mesh open = sphere_cut_off(0.9), closed = sphere(1, 2);
  EXPECT_TRUE(check_but_for_holes(open, true, "").ok());
  EXPECT_TRUE(check_but_for_holes(closed, false, "").ok());
  EXPECT_TRUE(fill_mesh(closed).holes.empty());
  const Diagnosis refused = check_but_for_holes(open, false, "; advice");
  EXPECT_EQ(refused.status, Status::input_not_closed);
  EXPECT_NE(refused.detail.find("; advice"), std::string::npos) << refused.detail;
  EXPECT_EQ(check_but_for_holes(inside_out(open), true, "").status, Status::input_misoriented);
  EXPECT_EQ(check_but_for_holes(side_by_side(open, sphere(0.3, 2, {0, 0, -1})), true, "").status,
            Status::input_self_intersecting);
  EXPECT_EQ(check_but_for_holes(Blend_mesh(), true, "").status, Status::input_empty);
}

}  // namespace
