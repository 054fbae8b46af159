// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/bridge.h>

#include "bridge_spheres.h"
#include "checks.h"

#include <cgal_blend/validate.h>

#include <gtest/gtest.h>

#include <set>
#include <vector>

// What bridges make of bodies; their shape is tested in test_bridge.cpp.

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;

TEST(Bridge_bodies, makes_one_body_of_two) {
  const Two_spheres spheres;
  const Blend_mesh mesh = spheres.mesh(4);
  Blend_mesh out;
  const Bridge_outcome outcome = unchecked::bridge(mesh, spheres.ends(), out);
  ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
  const Validity_report report = validate(out);
  EXPECT_TRUE(report.ok()) << message(report.diagnosis);
  EXPECT_EQ(report.components, 1u);
  EXPECT_EQ(euler(out), 2);
  EXPECT_NEAR(outcome.volume, volume_of(out), 1e-12 * outcome.volume);
}

TEST(Bridge_bodies, raises_the_genus_by_a_handle) {
  const Blend_mesh ring = torus(1, 0.35, 96, 48);
  Blend_mesh out;
  const Bridge_outcome outcome = unchecked::bridge(ring, {end_at({0.65, 0, 0}, 0.2), end_at({-0.65, 0, 0}, 0.2)}, out);
  ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
  EXPECT_TRUE(validate(out).ok());
  EXPECT_EQ(validate(out).components, 1u);
  EXPECT_EQ(euler(out), -2);  // genus 2
}

TEST(Bridge_bodies, makes_a_tunnel_where_it_runs_inside) {
  const auto volume_error = [](int level) {
    const Blend_mesh ball = transformed(sphere(1, level), placement({1, 2, 3}, 0.7));
    Bridge_options options;
    options.chord_tolerance = 2e-4;
    Blend_mesh out;
    const Bridge_outcome outcome =
        unchecked::bridge(ball, {end_at({0, 0, 1}, 0.3), end_at({0, 0, -1}, 0.3)}, out, options);
    EXPECT_TRUE(outcome.ok()) << message(outcome.diagnosis);
    EXPECT_EQ(euler(out), 0);
    Two_spheres same;  // both ends on one sphere
    same.second = 1;
    same.between = 0;
    same.contact = {0.3, 0.3};
    double exact = 4 * pi / 3 - 2 * pi * std::pow(1 - std::cos(0.3), 2) * (2 + std::cos(0.3)) / 3;
    constexpr int steps = 20000;
    for (int i = 0; i < steps; ++i) {
      const auto p = same.blend(static_cast<double>(i) / steps, 0.5, 2, 0.5, 0.5),
                 q = same.blend((i + 1.0) / steps, 0.5, 2, 0.5, 0.5);
      exact -= pi / 4 * (p[0] + q[0]) * (p[0] + q[0]) * (p[1] - q[1]);
    }
    return std::abs(outcome.volume / exact - 1);
  };
  const double coarse = volume_error(3), fine = volume_error(5);
  EXPECT_GT(coarse, 6 * fine);
  EXPECT_LT(fine, 2e-3);
}

TEST(Bridge_bodies, sees_the_bridges_made_before) {
  const Two_spheres spheres;
  const Blend_mesh mesh = spheres.mesh(4);
  const auto pair = [&](double angle) {
    Bridge bridge;
    bridge.ends = {
        end_at({std::sin(angle), 0, std::cos(angle)}, 0.2),
        end_at({spheres.second * std::sin(angle), 0, spheres.between - spheres.second * std::cos(angle)}, 0.2)};
    return bridge;
  };
  Blend_mesh out;
  const Bridge_outcome outcome = unchecked::bridge_all(mesh, {pair(0.6), pair(-0.6), pair(0)}, out);
  ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
  EXPECT_TRUE(validate(out).ok());
  EXPECT_EQ(euler(out), -2);  // three tubes between two spheres: genus 2
  ASSERT_EQ(outcome.bridge_faces.size(), 3u);
  std::set<Face> all;
  for (const auto& faces : outcome.bridge_faces) all.insert(faces.begin(), faces.end());
  EXPECT_EQ(all.size(),
            outcome.bridge_faces[0].size() + outcome.bridge_faces[1].size() + outcome.bridge_faces[2].size());
  for (std::size_t f = 0; f < outcome.kept_faces; ++f) EXPECT_EQ(all.count(Face(f)), 0u);

  const Bridge_outcome crossing = unchecked::bridge_all(mesh, {pair(0.6), pair(0.62)}, out);
  EXPECT_FALSE(crossing.ok());
  EXPECT_EQ(crossing.diagnosis.detail.rfind("bridge 2", 0), 0u) << crossing.diagnosis.detail;
  EXPECT_EQ(out.number_of_faces(), 0u);
}

TEST(Bridge_bodies, leaves_everything_beyond_the_contacts_as_it_is) {
  const Two_spheres spheres;
  const Blend_mesh mesh = spheres.mesh(4);
  Blend_mesh out;
  const Bridge_outcome outcome = unchecked::bridge(mesh, spheres.ends(), out);
  ASSERT_TRUE(outcome.ok());
  std::vector<Face> beyond;  // with all corners outside the contacts, by exact geodesics and a facet's sagitta
  for (const Face f : mesh.faces()) {
    bool outside = true;
    for (const std::size_t v : corners_of(mesh, f)) {
      const Point_3& p = mesh.point(Vertex(static_cast<std::uint32_t>(v)));
      const int side = p.z() < 1.3 ? 0 : 1;
      const double r = side == 0 ? spheres.first : spheres.second;
      const double cosine = side == 0 ? p.z() / r : (spheres.between - p.z()) / r;
      outside = outside && r * std::acos(std::clamp(cosine, -1.0, 1.0)) > 1.02 * spheres.contact[side] + 0.1 * r;
    }
    if (outside) beyond.push_back(f);
  }
  EXPECT_GT(beyond.size(), mesh.number_of_faces() / 2);
  EXPECT_TRUE(faces_kept_in_order(mesh, out, beyond));
  ASSERT_EQ(outcome.origins.size(), out.number_of_faces());
  for (std::size_t f = 0; f < outcome.kept_faces; ++f) {
    const Face origin(outcome.origins[f]);
    const auto a = corners_of(mesh, origin), b = corners_of(out, Face(static_cast<std::uint32_t>(f)));
    for (int i = 0; i < 3; ++i)
      ASSERT_EQ(mesh.point(Vertex(static_cast<std::uint32_t>(a[i]))),
                out.point(Vertex(static_cast<std::uint32_t>(b[i]))));
  }
}

TEST(Bridge_bodies, does_not_depend_on_position_and_size) {
  const Two_spheres spheres;
  const Blend_mesh mesh = spheres.mesh(4);
  Blend_mesh out;
  const double volume = unchecked::bridge(mesh, spheres.ends(), out).volume;
  ASSERT_GT(volume, 0);
  for (const double scale : {1e-3, 1.0, 1e6}) {
    const Placement motion = placement({3, 1, 2}, 0.9, {5 * scale, -2 * scale, 7 * scale}, scale);
    auto ends = spheres.ends();
    for (Bridge_end& end : ends) {
      end.spot = motion.transform(end.spot);
      end.radius *= scale;
    }
    Blend_mesh moved;
    const Bridge_outcome outcome = unchecked::bridge(transformed(mesh, motion), ends, moved);
    ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
    EXPECT_NEAR(outcome.volume / (scale * scale * scale * volume), 1, 1e-4) << scale;
  }
}

TEST(Bridge_bodies, is_deterministic) {
  const Two_spheres spheres;
  Blend_mesh once, again;
  ASSERT_TRUE(unchecked::bridge(spheres.mesh(4), spheres.ends(), once).ok());
  ASSERT_TRUE(unchecked::bridge(spheres.mesh(4), spheres.ends(), again).ok());
  EXPECT_TRUE(identical(once, again));
}

TEST(Bridge_bodies, takes_all_curves_and_extremes_of_lambda) {
  const Two_spheres spheres;
  const Blend_mesh mesh = spheres.mesh(4);
  const std::vector<Polar_curve> curves{rectangle_curve(0.5, 0.3, 0.1), cross_curve(0.5, 0.2, 0.08),
                                        star_curve(0.4, 0.3, 5), ellipse_curve(0.6, 0.3),
                                        spline_curve({{0.3, 0}, {0.5, 2}, {0.4, 4}})};
  for (std::size_t i = 0; i < curves.size(); ++i)
    for (const double lambda : {0.0, 0.9}) {
      auto ends = spheres.ends();
      ends[0].curve = curves[i];
      ends[1].curve = curves[(i + 1) % curves.size()];
      ends[0].lambda = ends[1].lambda = lambda;
      Blend_mesh out;
      const Bridge_outcome outcome = unchecked::bridge(mesh, ends, out);
      ASSERT_TRUE(outcome.ok()) << i << ", lambda " << lambda << ": " << message(outcome.diagnosis);
      EXPECT_TRUE(validate(out).ok());
      EXPECT_EQ(euler(out), 2);
    }
}

TEST(Bridge_bodies, works_within_single_facets_and_across_sharp_edges) {
  const Blend_mesh boxes = side_by_side(box({-1, -1, -1}, {1, 1, 0}), box({-1, -1, 1}, {1, 1, 2}));
  for (const double radius : {0.1, 0.6}) {  // within one of the 12 faces; across its diagonal
    Blend_mesh out;
    const Bridge_outcome outcome =
        unchecked::bridge(boxes, {end_at({0.5, -0.3, 0}, radius), end_at({0.2, 0.1, 1}, radius)}, out);
    ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
    EXPECT_TRUE(validate(out).ok());
    EXPECT_EQ(euler(out), 2);
  }
  Blend_mesh out;  // around a corner of each
  const Blend_mesh apart = side_by_side(grid_box({-2, -2, -2}, {0, 0, 0}, 8), grid_box({1, 1, 1}, {3, 3, 3}, 8));
  const Bridge_outcome outcome = unchecked::bridge(apart, {end_at({0, 0, 0}, 0.6), end_at({1, 1, 1}, 0.6)}, out);
  ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
  EXPECT_EQ(euler(out), 2);
}

TEST(Bridge_bodies, takes_as_many_facets_as_it_is_told) {
  const Two_spheres spheres;
  Blend_mesh out;
  Bridge_options options;
  options.segments = 24;
  options.rows = 10;
  const Bridge_outcome outcome = unchecked::bridge(spheres.mesh(4), spheres.ends(), out, options);
  ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
  EXPECT_EQ(outcome.bridges[0].segments, 24u);
  EXPECT_EQ(outcome.bridges[0].rows, 10u);
  EXPECT_GT(outcome.bridge_faces[0].size(), 2u * 24 * 10);
}

}  // namespace
