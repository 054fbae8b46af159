// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/bridge.h>

#include "bridge_spheres.h"
#include "checks.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;

struct Case {
  Blend_mesh mesh;
  std::array<Bridge_end, 2> ends;
  Bridge_options options;
};

/// The outcome for the spheres with one thing changed; the input must stay as it is, and nothing come out.
Diagnosis refusal_of(const std::function<void(Case&)>& change) {
  const Two_spheres spheres;
  Case c{spheres.mesh(4), spheres.ends(), {}};
  change(c);
  const Blend_mesh before = c.mesh;
  Blend_mesh out = box({0, 0, 0}, {1, 1, 1});
  const Bridge_outcome outcome = unchecked::bridge(c.mesh, c.ends, out, c.options);
  EXPECT_TRUE(identical(before, c.mesh));
  EXPECT_EQ(out.number_of_faces() == 0, !outcome.ok());
  return outcome.diagnosis;
}

TEST(Bridge_refusals, name_parameters_out_of_range) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::function<void(Case&)>> changes{
      [](Case& c) { c.ends[0].lambda = 1; },
      [](Case& c) { c.ends[1].lambda = -0.01; },
      [=](Case& c) { c.ends[1].lambda = nan; },
      [](Case& c) { c.options.mu = 0; },
      [](Case& c) { c.options.mu = 1; },
      [=](Case& c) { c.options.mu = nan; },
      [](Case& c) { c.options.order = 0; },
      [](Case& c) { c.options.order = 4; },
      [](Case& c) { c.ends[0].radius = 0; },
      [](Case& c) { c.ends[0].radius = -1; },
      [=](Case& c) { c.ends[0].radius = nan; },
      [](Case& c) { c.options.segments = 2; },
      [](Case& c) { c.options.rows = 5000; },
      [=](Case& c) {
        c.ends[1].spot = {0, nan, 1.8};
      },
      [](Case& c) { c.options.rows = 1; },
      [](Case& c) { c.options.chord_tolerance = 0; },
      [=](Case& c) { c.options.twist_deg = nan; },
      [](Case& c) { c.options.smooth_angle = 0; },
      [](Case& c) { c.ends[0].zero_direction = Vector_3(0, 0, 0); },
      [](Case& c) { c.ends[0].curve = function_curve([](double angle) { return 0.2 + 0.3 * std::cos(angle); }); },
      [](Case& c) { c.ends[0].curve = [](double s) {
                      return Polar_point{0.3, -2 * pi * s};
                    }; }};
  for (std::size_t i = 0; i < changes.size(); ++i)
    EXPECT_EQ(refusal_of(changes[i]).status, Status::invalid_parameter) << i;
}

TEST(Bridge_refusals, tell_how_far_a_spot_is_off) {
  const Diagnosis off = refusal_of([](Case& c) { c.ends[1].spot = {0, 0, 1.5}; });
  EXPECT_EQ(off.status, Status::spot_off_surface);
  EXPECT_NE(off.detail.find("second end"), std::string::npos) << off.detail;
  EXPECT_NE(off.detail.find("0.3"), std::string::npos) << off.detail;
}

TEST(Bridge_refusals, find_the_cut_locus) {
  // Geodesic circles on a torus' thin side meet again at half its circumference.
  const double minor = 0.35, half = pi * minor;
  const auto with_radius = [&](double radius) {
    return refusal_of([&](Case& c) {
      c.mesh = side_by_side(torus(1, minor, 96, 48), sphere(0.2, 3, {3, 0, 0}));
      c.ends = {end_at({1 + minor, 0, 0}, radius), end_at({2.8, 0, 0}, 0.1)};
    });
  };
  const Diagnosis far = with_radius(1.3 * half);
  EXPECT_EQ(far.status, Status::radius_exceeds_cut_locus);
  ASSERT_TRUE(far.max_radius.has_value());
  EXPECT_LT(*far.max_radius, 1.02 * half);
  EXPECT_GT(*far.max_radius, 0.8 * half);
  EXPECT_EQ(with_radius(0.7 * half).status, Status::ok);
}

TEST(Bridge_refusals, find_curves_that_cross_themselves) {
  const Diagnosis crossing = refusal_of([](Case& c) {
    c.ends[0].curve = [](double s) {  // runs back and forth in angle
      const double angle = 2 * pi * s;
      return Polar_point{0.4 + 0.1 * std::sin(3 * angle), angle + 0.9 * std::sin(5 * angle)};
    };
  });
  EXPECT_EQ(crossing.status, Status::curve_crosses_itself);
}

TEST(Bridge_refusals, find_regions_that_overlap) {
  const Diagnosis overlap = refusal_of([](Case& c) { c.ends[1] = end_at({std::sin(0.8), 0, std::cos(0.8)}, 0.5); });
  EXPECT_EQ(overlap.status, Status::regions_overlap);
  EXPECT_TRUE(overlap.point.has_value());
}

TEST(Bridge_refusals, find_collisions_with_their_place) {
  // A third sphere in the way.
  const Diagnosis collision = refusal_of([](Case& c) {
    c.mesh = side_by_side(c.mesh, sphere(0.25, 3, {0.2, 0, 1.4}));
  });
  EXPECT_EQ(collision.status, Status::blend_collides);
  ASSERT_TRUE(collision.point.has_value());
  EXPECT_NEAR(collision.point->z(), 1.4, 0.3);
  // From the far side of one sphere to the other.
  const Diagnosis through = refusal_of([](Case& c) { c.ends[0].spot = {0, 0, -1}; });
  EXPECT_EQ(through.status, Status::blend_collides);
}

TEST(Bridge_refusals, find_bodies_that_go_on_crossing) {
  const auto crossing = [](double radius) {
    return refusal_of([=](Case& c) {
      c.mesh = side_by_side(transformed(sphere(1, 4), placement({1, 2, 3}, 0.7)), sphere(0.6, 4, {0, 0, 1.3}));
      c.ends = {end_at({0, 0, 1}, radius), end_at({0, 0, 0.7}, radius)};
    });
  };
  EXPECT_EQ(crossing(0.2).status, Status::blend_collides);  // the contacts are within the intersection
  EXPECT_EQ(crossing(0.7).status, Status::ok);              // and now around it
}

TEST(Bridge_refusals, leave_off_when_told_to) {
  const Diagnosis cancelled = refusal_of([](Case& c) { c.options.progress = [](double) { return false; }; });
  EXPECT_EQ(cancelled.status, Status::cancelled);
}

}  // namespace
