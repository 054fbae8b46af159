// SPDX-License-Identifier: GPL-3.0-or-later
// Blending a coarse level and restoring the detail, against the torus between two spheres.
#include "checks.h"
#include "shapes.h"

#include <cgal_blend/fillet.h>
#include <cgal_blend/validate.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace cgal_blend::test {
namespace {

constexpr double R1 = 30, R2 = 22, distance = 28, ball = 6;

struct Spheres {
  Blend_mesh a = sphere(R1, 5), b = sphere(R2, 5, {distance, 0.3, 0.2});
};

Fillet_options options_of(std::size_t coarse_faces) {
  Fillet_options options;
  options.radius = ball;
  options.mode = Blend_mode::map;
  options.coarse_faces = coarse_faces;
  return options;
}

/// The ball touches both spheres from outside: its centre runs on a circle about the line of centres.
struct Torus {
  Point_3 centre;
  Vector_3 axis;
  double major;
};

Torus between(const Point_3& c1, const Point_3& c2) {
  const double d = std::sqrt(CGAL::squared_distance(c1, c2)), p = R1 + ball, q = R2 + ball;
  const double along = (d * d + p * p - q * q) / (2 * d);
  return {c1 + along / d * (c2 - c1), c2 - c1, std::sqrt(p * p - along * along)};
}

/// Root mean square distance from the torus of the vertices between the contact circles, over the radius, and how many.
std::pair<double, int> off_torus(const Blend_mesh& mesh) {
  const Point_3 c1(0, 0, 0), c2(distance, 0.3, 0.2);
  const Torus torus = between(c1, c2);
  double sum = 0;
  int count = 0;
  for (const Vertex v : mesh.vertices()) {
    const Point_3& p = mesh.point(v);
    const double height = distance_to_plane(p, torus.centre, torus.axis);
    // Between the cones through the contacts.
    const double to_1 = R1 / (R1 + ball) * std::sqrt(CGAL::squared_distance(c1, torus.centre));
    const double to_2 = std::sqrt(CGAL::squared_distance(c1, c2)) -
                        R2 / (R2 + ball) * std::sqrt(CGAL::squared_distance(c2, torus.centre));
    const double x = std::sqrt(CGAL::squared_distance(c1, torus.centre)) + height;
    if (x < to_1 || x > to_2) continue;
    const double off = distance_to_torus(p, torus.centre, torus.axis, torus.major, ball) / ball;
    sum += off * off;
    ++count;
  }
  return {std::sqrt(sum / count), count};
}

TEST(FilletCoarse, NearerToTheTorusTheFinerTheLevel) {
  const Spheres bodies;
  Blend_mesh sharp;
  ASSERT_TRUE(unchecked::corefine_and_fillet(bodies.a, bodies.b, Boolean_operation::union_, sharp, {}).ok());
  double last = 1;
  for (const std::size_t faces : {1000u, 4000u, 0u}) {  // 0: the mesh itself
    Blend_mesh out;
    const Fillet_outcome outcome =
        unchecked::corefine_and_fillet(bodies.a, bodies.b, Boolean_operation::union_, out, options_of(faces));
    ASSERT_TRUE(outcome.ok()) << faces << message(outcome.diagnosis);
    EXPECT_TRUE(validate(out).ok()) << faces;
    const auto [off, count] = off_torus(out);
    EXPECT_GT(count, 200) << faces;
    EXPECT_LT(off, faces == 0 ? 0.002 : faces == 4000 ? 0.01 : 0.03) << faces;
    EXPECT_LT(off, last) << faces;
    last = off;
    // The connectivity is that of the sharp union, and vertices far from the blend are where they were.
    ASSERT_EQ(out.number_of_vertices(), sharp.number_of_vertices()) << faces;
    ASSERT_EQ(out.number_of_faces(), sharp.number_of_faces()) << faces;
    auto g = sharp.faces().begin();
    for (const Face f : out.faces()) ASSERT_EQ(corners_of(out, f), corners_of(sharp, *g++)) << faces;
    for (const Vertex v : sharp.vertices())
      if (std::abs(sharp.point(v).x() - 20) > 26) {  // more than two coarse faces from the contacts
        EXPECT_EQ(sharp.point(v), out.point(v)) << faces;
      }
    EXPECT_EQ(outcome.kept_faces + outcome.changed_faces.size(), out.number_of_faces()) << faces;
  }
}

TEST(FilletCoarse, SameInputSameOutput) {
  const Spheres bodies;
  Blend_mesh first, second;
  ASSERT_TRUE(
      unchecked::corefine_and_fillet(bodies.a, bodies.b, Boolean_operation::union_, first, options_of(2000)).ok());
  ASSERT_TRUE(
      unchecked::corefine_and_fillet(bodies.a, bodies.b, Boolean_operation::union_, second, options_of(2000)).ok());
  EXPECT_TRUE(identical(first, second));
}

TEST(FilletCoarse, StitchingHasNoCoarseLevel) {
  const Spheres bodies;
  Fillet_options options = options_of(2000);
  options.mode = Blend_mode::stitch;
  Blend_mesh out;
  EXPECT_EQ(
      unchecked::corefine_and_fillet(bodies.a, bodies.b, Boolean_operation::union_, out, options).diagnosis.status,
      Status::invalid_parameter);
}

TEST(FilletCoarse, TooFewFacesAreRefusedOrValid) {
  const Spheres bodies;
  for (const std::size_t faces : {4u, 50u, 200u}) {
    Blend_mesh out;
    const Fillet_outcome outcome =
        unchecked::corefine_and_fillet(bodies.a, bodies.b, Boolean_operation::union_, out, options_of(faces));
    if (outcome.ok()) {
      EXPECT_TRUE(validate(out).ok()) << faces;
    } else {
      EXPECT_EQ(status_class(outcome.diagnosis.status), Status_class::blend) << faces;
    }
    EXPECT_EQ(outcome.ok(), !out.is_empty()) << faces;
  }
}

}  // namespace
}  // namespace cgal_blend::test
