// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/bridge.h>

#include "bridge_spheres.h"
#include "checks.h"

#include <cgal_blend/validate.h>

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;

/// Spheres about (0, 0, 0) and (0, 0, between) that cross in a circle, with contacts along the surfaces from there.
struct Crossing_spheres {
  double first = 1, second = 0.7, between = 1.2;
  std::array<double, 2> contact{0.3, 0.25};
  double lambda = 0.4, mu = 0.6;
  int order = 2;

  [[nodiscard]] Blend_mesh body(int side, int level) const {
    return side == 0 ? transformed(sphere(first, level), placement({1, 2, 3}, 0.7))
                     : transformed(sphere(second, level), placement({2, -1, 1}, 1.1, {0, 0, between}));
  }

  [[nodiscard]] std::array<Bridge_end, 2> ends() const {
    std::array<Bridge_end, 2> result;
    for (std::size_t k : {0, 1}) {
      result[k].radius = contact[k];
      result[k].lambda = lambda;
    }
    return result;
  }

  [[nodiscard]] Bridge_options options() const {
    Bridge_options result;
    result.mu = mu;
    result.order = order;
    result.chord_tolerance = 2e-4;
    return result;
  }

  /// Distance from the axis, and z, on a sphere at some distance from the circle.
  [[nodiscard]] std::array<double, 2> base(int side, double distance) const {
    const double r = side == 0 ? first : second, other = side == 0 ? second : first;
    const double angle = std::acos((between * between + r * r - other * other) / (2 * between * r)) + distance / r;
    return {r * std::sin(angle), side == 0 ? r * std::cos(angle) : between - r * std::cos(angle)};
  }

  [[nodiscard]] std::array<double, 2> blend(double t) const {
    const double a = mu * std::pow(1 - t, order + 1), b = (1 - mu) * std::pow(t, order + 1), f = a / (a + b);
    const auto p = base(0, contact[0] * (1 - t * (1 - lambda))), q = base(1, contact[1] * (1 - (1 - t) * (1 - lambda)));
    return {f * p[0] + (1 - f) * q[0], f * p[1] + (1 - f) * q[1]};
  }

  [[nodiscard]] std::vector<std::array<double, 2>> profile() const {
    constexpr int steps = 2000;
    std::vector<std::array<double, 2>> points;
    for (int i = 0; i <= steps; ++i) points.push_back(blend(static_cast<double>(i) / steps));
    return points;
  }
};

double largest_distance(int level) {
  const Crossing_spheres spheres;
  Blend_mesh out;
  const Bridge_outcome outcome = unchecked::bridge_intersection(spheres.body(0, level), spheres.body(1, level),
                                                                spheres.ends(), out, spheres.options());
  EXPECT_TRUE(outcome.ok()) << message(outcome.diagnosis);
  EXPECT_TRUE(validate(out).ok());
  EXPECT_EQ(euler(out), 2);
  EXPECT_EQ(outcome.bridge_faces.size(), 1u);
  std::set<Vertex> vertices;
  for (const Face f : outcome.bridge_faces.at(0))
    for (const Vertex v : out.vertices_around_face(out.halfedge(f))) vertices.insert(v);
  EXPECT_GT(vertices.size(), 1000u);
  const auto profile = spheres.profile();
  double largest = 0;
  for (const Vertex v : vertices) {
    const double r = std::hypot(out.point(v).x(), out.point(v).y()), z = out.point(v).z();
    double least = INFINITY;
    for (const auto& q : profile) least = std::min(least, std::hypot(r - q[0], z - q[1]));
    largest = std::max(largest, least);
  }
  return largest;
}

TEST(Bridge_crossing, equals_the_closed_form_between_spheres) {
  const double coarse = largest_distance(3), fine = largest_distance(5);
  EXPECT_GT(coarse, 4 * fine);  // order 1 at least
  EXPECT_LT(fine, 4e-3);
}

TEST(Bridge_crossing, keeps_all_that_is_beyond_the_contacts) {
  const Crossing_spheres spheres;
  const Blend_mesh a = spheres.body(0, 4), b = spheres.body(1, 4), both = side_by_side(a, b);
  Blend_mesh out;
  const Bridge_outcome outcome = unchecked::bridge_intersection(a, b, spheres.ends(), out);
  ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
  ASSERT_EQ(outcome.origins.size(), out.number_of_faces());
  EXPECT_GT(outcome.kept_faces, both.number_of_faces() / 3);
  for (std::size_t f = 0; f < outcome.kept_faces; ++f) {
    ASSERT_NE(outcome.origins[f], no_origin);
    const auto p = corners_of(both, Face(outcome.origins[f])), q = corners_of(out, Face(static_cast<std::uint32_t>(f)));
    std::set<Point_3> before, after;
    for (int i = 0; i < 3; ++i) {
      before.insert(both.point(Vertex(static_cast<std::uint32_t>(p[i]))));
      after.insert(out.point(Vertex(static_cast<std::uint32_t>(q[i]))));
    }
    ASSERT_EQ(before, after);
  }
}

TEST(Bridge_crossing, takes_cylinders_in_symmetric_position) {
  const Blend_mesh upright = cylinder(0.6, 60, -2, 2, 40),
                   lying = transformed(cylinder(0.45, 48, -2, 2, 40), placement({0, 1, 0}, pi / 2));
  for (const double lambda : {0.0, 0.5, 0.95}) {
    std::array<Bridge_end, 2> ends{end_at({0, 0, 0}, 0.2), end_at({0, 0, 0}, 0.25)};
    for (Bridge_end& end : ends) end.lambda = lambda;
    Blend_mesh out;
    const Bridge_outcome outcome = unchecked::bridge_intersection(upright, lying, ends, out);
    ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
    EXPECT_EQ(outcome.bridge_faces.size(), 2u);
    EXPECT_TRUE(validate(out).ok());
    EXPECT_EQ(euler(out), 2);
    EXPECT_LT(outcome.bridges[0].tangency_deg, 4);
  }
}

TEST(Bridge_crossing, takes_coarse_bodies_and_few_facets) {
  const Blend_mesh upright = cylinder(0.6, 16, -1.5, 1.5, 6),
                   lying = transformed(cylinder(0.45, 16, -1.5, 1.5, 6), placement({0, 1, 0}, pi / 2));
  for (const std::size_t segments : {12, 20, 48})
    for (const std::size_t rows : {3, 4, 6, 32}) {
      Bridge_options options;
      options.segments = segments;
      options.rows = rows;
      Blend_mesh out;
      const Bridge_outcome outcome = unchecked::bridge_intersection(
          upright, lying, {end_at({0, 0, 0}, 0.15), end_at({0, 0, 0}, 0.15)}, out, options);
      ASSERT_TRUE(outcome.ok()) << segments << " x " << rows << ": " << message(outcome.diagnosis);
      EXPECT_EQ(euler(out), 2);
    }
}

TEST(Bridge_crossing, is_deterministic) {
  const Crossing_spheres spheres;
  Blend_mesh once, again;
  ASSERT_TRUE(unchecked::bridge_intersection(spheres.body(0, 4), spheres.body(1, 4), spheres.ends(), once).ok());
  ASSERT_TRUE(unchecked::bridge_intersection(spheres.body(0, 4), spheres.body(1, 4), spheres.ends(), again).ok());
  EXPECT_TRUE(identical(once, again));
}

TEST(Bridge_crossing, refuses_by_name) {
  const Crossing_spheres spheres;
  const Blend_mesh a = spheres.body(0, 3), b = spheres.body(1, 3);
  Blend_mesh out = box({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(unchecked::bridge_intersection(a, sphere(0.5, 3, {0, 0, 5}), spheres.ends(), out).diagnosis.status,
            Status::operands_disjoint);
  auto ends = spheres.ends();
  ends[0].radius = 0;
  EXPECT_EQ(unchecked::bridge_intersection(a, b, ends, out).diagnosis.status, Status::invalid_parameter);
  ends[0].radius = 4;  // the way round the sphere and more
  const Diagnosis far = unchecked::bridge_intersection(a, b, ends, out).diagnosis;
  EXPECT_EQ(far.status, Status::radius_exceeds_cut_locus) << message(far);
  // Strips around two intersection curves that meet.
  const Blend_mesh upright = cylinder(0.6, 48, -2, 2, 40),
                   lying = transformed(cylinder(0.5, 48, -2, 2, 40), placement({0, 1, 0}, pi / 2));
  const Bridge_outcome wide =
      unchecked::bridge_intersection(upright, lying, {end_at({0, 0, 0}, 0.45), end_at({0, 0, 0}, 0.2)}, out);
  EXPECT_FALSE(wide.ok());
  EXPECT_EQ(status_class(wide.diagnosis.status), Status_class::blend);
  EXPECT_EQ(out.number_of_faces(), 0u);
}

}  // namespace
