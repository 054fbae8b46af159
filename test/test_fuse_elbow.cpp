// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks.h"
#include "fusion_checks.h"
#include "fusions.h"
#include "shapes.h"

#include <cgal_blend/fuse.h>

#include <gtest/gtest.h>

#include <cmath>

// Planes that are not parallel.

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;

class Fuse_elbow : public testing::TestWithParam<double> {};

TEST_P(Fuse_elbow, is_a_torus) {
  const double angle = GetParam(), major = 1.4, minor = 0.5;
  const Blend_mesh low = frustum(minor, minor, 48, -1, 0.3, 3), straight = frustum(minor, minor, 48, -0.3, 1, 3);
  // The upper cylinder turned about the y axis through (major, 0, 0).
  const Point_3 centre(major, 0, 0);
  const Placement to = moved_by(major, 0, 0) * placement({0, 1, 0}, angle) * moved_by(-major, 0, 0);
  const Blend_mesh high = transformed(straight, to);
  const Cut_plane up{to.transform(Point_3(0, 0, 0)), -to.transform(Vector_3(0, 0, 1))};
  Blend_mesh out;
  const Fuse_outcome outcome = unchecked::fuse({{&low}, lower_plane}, {{&high}, up}, out);
  expect_valid(outcome, out);
  EXPECT_NEAR(outcome.angle, angle * 180 / pi, 1e-9);
  EXPECT_NEAR(outcome.height, major * angle, 1e-3 * major * angle);
  EXPECT_EQ(outcome.euler_characteristic, 2);
  for (const Face f : outcome.transition_faces)
    for (const std::size_t v : corners_of(out, f))
      EXPECT_NEAR(distance_to_torus(out.point(Vertex(v)), centre, {0, 1, 0}, major, minor), 0, 0.01 * minor);
  const double polygon = 24 * std::sin(2 * pi / 48) * minor * minor;
  EXPECT_NEAR(outcome.volume, polygon * (2 + major * angle), 0.005 * outcome.volume);
  EXPECT_LE(outcome.tangency_max, 360.0 / 48);
}

INSTANTIATE_TEST_SUITE_P(Angles, Fuse_elbow, testing::Values(0.02, pi / 6, pi / 2, 2 * pi / 3 - 1e-9));

TEST(Fuse, keeps_tangents_of_cones_in_an_elbow) {
  const Blend_mesh low = frustum(0.9, 0.5, 48, -1, 0.25, 4), straight = frustum(0.5, 0.9, 48, -0.25, 1, 4);
  const Placement to = moved_by(1.5, 0.2, 0.1) * placement({0, 1, 0}, 1.2) * moved_by(-1.5, 0, 0);
  const Blend_mesh high = transformed(straight, to);
  const Cut_plane up{to.transform(Point_3(0, 0, 0)), -to.transform(Vector_3(0, 0, 1))};
  Blend_mesh out;
  const Fuse_outcome outcome = unchecked::fuse({{&low}, lower_plane}, {{&high}, up}, out);
  expect_valid(outcome, out);
  EXPECT_LE(outcome.tangency_max, 360.0 / 48);
}

TEST(Fuse, goes_over_into_the_parallel_case) {
  // As the angle vanishes nothing moves: an offset across stays what it is.
  const Blend_mesh low = frustum(0.8, 0.8, 32, -1, 0.5, 4),
                   plain = transformed(frustum(0.6, 0.6, 32, 1, 3, 3), moved_by(0.3, 0.2, 0));
  Blend_mesh straight;
  const Fuse_outcome first = unchecked::fuse({{&low}, lower_plane}, {{&plain}, upper_plane(1.5)}, straight);
  expect_valid(first, straight);
  for (const double angle : {1e-3, 1e-5, 1e-9}) {
    const Placement to = moved_by(0, 0, 1.5) * placement({1, 1, 0}, angle) * moved_by(0, 0, -1.5);
    const Blend_mesh high = transformed(plain, to);
    Blend_mesh out;
    const Fuse_outcome outcome =
        unchecked::fuse({{&low}, lower_plane},
                        {{&high}, Cut_plane{to.transform(Point_3(0, 0, 1.5)), to.transform(Vector_3(0, 0, -1))}}, out);
    expect_valid(outcome, out);
    EXPECT_NEAR(outcome.volume, first.volume, (2 * angle + 1e-6) * first.volume);
    EXPECT_NEAR(outcome.height, 1.5, 2 * angle);
  }
}

/// A mesh beyond z = 0, turned about the parallel to the y axis through (x, 0, 0), with its plane.
struct Turned {
  Turned(const Blend_mesh& straight, double angle, double x) {
    const Placement to = moved_by(x, 0, 0) * placement({0, 1, 0}, angle) * moved_by(-x, 0, 0);
    mesh = transformed(straight, to);
    plane = {to.transform(Point_3(0, 0, 0)), to.transform(Vector_3(0, 0, -1))};
  }
  Blend_mesh mesh;
  Cut_plane plane;
};

/// A wide tube below, and a thin one above its edge that leads away at an angle; the arc's axis passes through the wide opening,
/// and through (x, 0, 0).
struct Corner {
  double wide, thin, x, angle;
};

class Fuse_corner : public testing::TestWithParam<Corner> {};

TEST_P(Fuse_corner, is_as_tangent_as_straight_tubes) {
  const Corner c = GetParam();
  const Blend_mesh low = frustum(c.wide, c.wide, 48, -1, 0.5, 4), thin = frustum(c.thin, c.thin, 24, -0.5, 2, 8);
  const Turned high(thin, c.angle, c.x);
  Blend_mesh out;
  const Fuse_outcome outcome = unchecked::fuse({{&low}, lower_plane}, {{&high.mesh}, high.plane}, out);
  expect_valid(outcome, out);
  EXPECT_EQ(outcome.euler_characteristic, 2);
  const Blend_mesh above = transformed(thin, moved_by(0, 0, outcome.height));
  const Fuse_outcome straight = unchecked::fuse({{&low}, lower_plane}, {{&above}, upper_plane(outcome.height)}, out);
  expect_valid(straight, out);
  EXPECT_NEAR(outcome.tangency_mean, straight.tangency_mean, 0.5);
  EXPECT_LE(outcome.tangency_max, straight.tangency_max + 3);
}

INSTANTIATE_TEST_SUITE_P(Tubes, Fuse_corner,
                         testing::Values(Corner{1, 0.2, 0.8, pi / 3}, Corner{1, 0.2, 0.8, pi / 2},
                                         Corner{1, 0.2, 0.8, 2 * pi / 3 - 1e-9}));

TEST(Fuse, keeps_tangents_where_the_arcs_centre_is_just_beside_an_opening) {
  // There is an arc, but it shortens its inner side too far to be rigid at the planes.
  const Blend_mesh low = frustum(0.4, 0.4, 48, -1, 0.5, 4), wide = frustum(0.9, 0.9, 48, -0.5, 2, 8);
  Turned high(wide, 75 * pi / 180, 0.5);
  high.mesh = transformed(high.mesh, moved_by(0, 0, 0.35));
  high.plane.point += Vector_3(0, 0, 0.35);
  Blend_mesh out;
  const Fuse_outcome outcome = unchecked::fuse({{&low}, lower_plane}, {{&high.mesh}, high.plane}, out);
  expect_valid(outcome, out);
  EXPECT_LE(outcome.tangency_max, 360.0 / 48);
}

TEST(Fuse, refuses_a_corner_that_is_too_tight) {
  // Both tubes are wider than the arc's radius: the kept parts themselves meet.
  const Blend_mesh low = frustum(1, 1, 32, -1, 0.5, 4);
  const Turned high(frustum(1, 1, 32, -0.5, 2, 4), pi / 2, 0.4);
  Blend_mesh out;
  const Fuse_outcome outcome = unchecked::fuse({{&low}, lower_plane}, {{&high.mesh}, high.plane}, out);
  EXPECT_EQ(outcome.diagnosis.status, Status::blend_folds) << message(outcome.diagnosis);
  EXPECT_TRUE(outcome.diagnosis.point);
  EXPECT_EQ(out.number_of_faces(), 0u);
}

}  // namespace
