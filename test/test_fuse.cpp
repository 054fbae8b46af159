// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks.h"
#include "fusion_checks.h"
#include "fusions.h"
#include "shapes.h"

#include <cgal_blend/fuse.h>
#include <cgal_blend/validate.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;

/// Radius of the transition between coaxial circles, Hermite in w = z / height.
double profile_radius(double w, double r1, double r2, double slope1, double slope2, double height) {
  return r1 * (w - 1) * (w - 1) * (1 + 2 * w) + r2 * w * w * (3 - 2 * w) + height * slope1 * w * (w - 1) * (w - 1) +
         height * slope2 * w * w * (w - 1);
}

/// Integral of rho^2 by Simpson's rule, times the area of a regular polygon of radius 1.
double profile_volume(int n, double r1, double r2, double slope1, double slope2, double height) {
  double sum = 0;
  constexpr int steps = 400;
  for (int k = 0; k <= steps; ++k) {
    const double r = profile_radius(static_cast<double>(k) / steps, r1, r2, slope1, slope2, height);
    sum += r * r * (k == 0 || k == steps ? 1 : k % 2 == 1 ? 4 : 2);
  }
  return sum * height / steps / 3 * n / 2 * std::sin(2 * pi / n);
}

double frustum_volume(int n, double r0, double r1, double height) {
  return (r0 * r0 + r0 * r1 + r1 * r1) / 3 * height * n / 2 * std::sin(2 * pi / n);
}

/// Faces of a side that its plane leaves whole, by the heights of their vertices.
std::vector<Face> faces_below(const Blend_mesh& mesh, const Cut_plane& plane) {
  std::vector<Face> kept;
  for (const Face f : mesh.faces()) {
    bool below = true;
    for (const std::size_t v : corners_of(mesh, f))
      below = below && (mesh.point(Vertex(v)) - plane.point) * plane.normal < 0;
    if (below) kept.push_back(f);
  }
  return kept;
}

struct Coaxial {
  double r1, r2, slope1, slope2, height;
};

class Fuse_coaxial : public testing::TestWithParam<Coaxial> {};

TEST_P(Fuse_coaxial, encloses_the_volume_of_the_profile) {
  const Coaxial c = GetParam();
  constexpr int n = 64;
  // Levels at -1.5, -0.5, 0.5 ...: the plane cuts half-way between them.
  const Blend_mesh low = frustum(c.r1 - 1.5 * c.slope1, c.r1 + 0.5 * c.slope1, n, -1.5, 0.5, 2);
  const Blend_mesh high = frustum(c.r2 - 0.5 * c.slope2, c.r2 + 1.5 * c.slope2, n, c.height - 0.5, c.height + 1.5, 2);
  Blend_mesh out;
  const Fuse_outcome outcome = unchecked::fuse({{&low}, lower_plane}, {{&high}, upper_plane(c.height)}, out);
  expect_valid(outcome, out);
  const double expected = frustum_volume(n, c.r1 - 1.5 * c.slope1, c.r1, 1.5) +
                          profile_volume(n, c.r1, c.r2, c.slope1, c.slope2, c.height) +
                          frustum_volume(n, c.r2, c.r2 + 1.5 * c.slope2, 1.5);
  EXPECT_NEAR(volume_of(out), expected, 0.005 * expected);
  EXPECT_NEAR(outcome.volume, volume_of(out), 1e-9 * expected);
  EXPECT_EQ(outcome.euler_characteristic, 2);
  EXPECT_EQ(outcome.rings, (std::array<std::size_t, 2>{1, 1}));
  for (const Face f : outcome.transition_faces)
    for (const std::size_t v : corners_of(out, f)) {
      const Point_3& p = out.point(Vertex(v));
      const double rho = profile_radius(p.z() / c.height, c.r1, c.r2, c.slope1, c.slope2, c.height);
      EXPECT_NEAR(std::hypot(p.x(), p.y()), rho, 0.005 * std::max(c.r1, c.r2));
    }
  EXPECT_LE(outcome.tangency_max, 360.0 / n);
  EXPECT_LE(outcome.tangency_mean, outcome.tangency_max);
}

INSTANTIATE_TEST_SUITE_P(Profiles, Fuse_coaxial,
                         testing::Values(Coaxial{1, 1, 0, 0, 2}, Coaxial{1, 0.6, 0, 0, 1.5},
                                         Coaxial{1, 1.3, 0.2, -0.3, 2}, Coaxial{1.2, 0.8, -0.3, 0.2, 3},
                                         Coaxial{1, 1, 0.4, -0.4, 0.7}));

/// w = eta(t): the Bezier curve of degree 5 with two free control values.
double eta_at(double t, const std::array<double, 2>& free) {
  const double c[] = {0, 0.2, free[0], free[1], 0.8, 1};
  const double binomial[] = {1, 5, 10, 10, 5, 1};
  double w = 0;
  for (int k = 0; k < 6; ++k) w += binomial[k] * std::pow(t, k) * std::pow(1 - t, 5 - k) * c[k];
  return w;
}

/// Fuses cylinders of radius 1 and 0.5 at a distance of 1.5, and compares with the radius by height; returns the volume.
double shaped_volume(const Fuse_options& options, const std::function<double(double)>& radius) {
  const Blend_mesh low = frustum(1, 1, 48, -1.3, 0.4, 3), high = frustum(0.5, 0.5, 48, 1, 2.6, 3);
  Blend_mesh out;
  const Fuse_outcome outcome = unchecked::fuse({{&low}, lower_plane}, {{&high}, upper_plane(1.5)}, out, options);
  expect_valid(outcome, out);
  for (const Face f : outcome.transition_faces)
    for (const std::size_t v : corners_of(out, f)) {
      const Point_3& p = out.point(Vertex(v));
      EXPECT_NEAR(std::hypot(p.x(), p.y()), radius(p.z() / 1.5), 0.005);
    }
  return outcome.volume;
}

TEST(Fuse, shapes_by_eta) {
  double last = 1e9;
  for (const std::array<double, 2> eta : {std::array<double, 2>{0, 0}, {0.4, 0.6}, {1, 1}}) {
    Fuse_options options;
    options.eta = eta;
    const double volume =
        shaped_volume(options, [&](double t) { return profile_radius(eta_at(t, eta), 1, 0.5, 0, 0, 1.5); });
    EXPECT_LT(volume, 0.99 * last) << "sections become narrow sooner";
    last = volume;
  }
}

TEST(Fuse, shapes_by_weights) {
  double last = 0;
  for (const double weight : {0.25, 1.0, 4.0}) {
    Fuse_options options;
    options.weight = {weight, 1};
    const double volume = shaped_volume(options, [&](double w) {
      const double f1 = weight * (w - 1) * (w - 1) * (1 + 2 * w), f2 = w * w * (3 - 2 * w);
      return (f1 * 1 + f2 * 0.5) / (f1 + f2);
    });
    EXPECT_GT(volume, 1.05 * last) << "the wide side reaches further";
    last = volume;
  }
}

/// Openings on circles about the axis. Where both sides have several, turned against each other, the axis stays outside
/// of all sections and the bodies join in a wreath about it: genus 1.
struct Topology {
  int lower, upper;
  long euler;
  std::size_t components;
};

class Fuse_topology : public testing::TestWithParam<Topology> {};

TEST_P(Fuse_topology, is_valid_and_as_predicted) {
  const Topology t = GetParam();
  const Blend_mesh low = frustum(0.5, 0.5, 32, -1.3, 0.4, 3), high = frustum(0.5, 0.5, 32, 3 - 0.4, 4.3, 3);
  const double r = t.lower == 2 && t.upper == 2 ? 0.6 : 0.9;
  const auto lows = on_circle(low, t.lower, r, 0), highs = on_circle(high, t.upper, r, t.upper == 1 ? 0 : pi / t.upper);
  const Fusion_side a = side_of_meshes(lows, lower_plane), b = side_of_meshes(highs, upper_plane(3));
  Blend_mesh out;
  const Fuse_outcome outcome = unchecked::fuse(a, b, out);
  expect_valid(outcome, out);
  EXPECT_EQ(outcome.euler_characteristic, t.euler);
  EXPECT_EQ(validate(out).components, t.components);
  EXPECT_EQ(outcome.rings[0], static_cast<std::size_t>(t.lower));
  EXPECT_EQ(outcome.rings[1], static_cast<std::size_t>(t.upper));
  EXPECT_LE(outcome.tangency_mean, 360.0 / 32);
  std::vector<Face> kept;
  std::size_t count = 0;
  for (const Fusion_side* side : {&a, &b})
    for (const Blend_mesh* mesh : side->meshes) {
      const auto whole = faces_below(*mesh, *side->plane);
      EXPECT_TRUE(faces_kept_in_order(*mesh, out, whole));
      count += whole.size();
    }
  EXPECT_EQ(outcome.kept_faces, count);
}

INSTANTIATE_TEST_SUITE_P(Rings, Fuse_topology,
                         testing::Values(Topology{1, 1, 2, 1}, Topology{1, 2, 2, 1}, Topology{1, 3, 2, 1},
                                         Topology{1, 4, 2, 1}, Topology{2, 2, 0, 1}, Topology{3, 3, 0, 1},
                                         Topology{2, 1, 2, 1}));

TEST(Fuse, keeps_separate_tubes_apart) {
  const auto lows = on_circle(frustum(0.5, 0.5, 32, -1.3, 0.4, 3), 2, 1.5, 0);
  const auto highs = on_circle(frustum(0.4, 0.4, 32, 1, 3, 3), 2, 1.5, 0);
  Blend_mesh out;
  const Fuse_outcome outcome =
      unchecked::fuse(side_of_meshes(lows, lower_plane), side_of_meshes(highs, upper_plane(1.5)), out);
  expect_valid(outcome, out);
  EXPECT_EQ(outcome.euler_characteristic, 4);
  EXPECT_EQ(validate(out).components, 2u);
}

TEST(Fuse, joins_openings_in_a_row) {
  // Each opening lies half under the next one of the other side: one body without a hole.
  const Blend_mesh low = frustum(0.5, 0.5, 32, -1.3, 0.4, 3), high = frustum(0.5, 0.5, 32, 2, 4, 3);
  const Blend_mesh lows[] = {transformed(low, moved_by(-0.9, 0, 0)), transformed(low, moved_by(0.9, 0, 0))};
  const Blend_mesh highs[] = {high, transformed(high, moved_by(1.8, 0, 0))};
  Blend_mesh out;
  const Fuse_outcome outcome =
      unchecked::fuse({{&lows[0], &lows[1]}, lower_plane}, {{&highs[0], &highs[1]}, upper_plane(2.5)}, out);
  expect_valid(outcome, out);
  EXPECT_EQ(outcome.euler_characteristic, 2);
  EXPECT_EQ(validate(out).components, 1u);
}

TEST(Fuse, joins_a_tube_to_a_tube) {
  const Blend_mesh low = pipe(0.5, 1, 48, -1, 0.5), high = pipe(0.8, 1.4, 48, 1, 3);
  Blend_mesh out;
  const Fuse_outcome outcome = unchecked::fuse({{&low}, lower_plane}, {{&high}, upper_plane(1.5)}, out);
  expect_valid(outcome, out);
  EXPECT_EQ(outcome.rings, (std::array<std::size_t, 2>{2, 2}));
  EXPECT_EQ(outcome.euler_characteristic, 0) << "a torus";
  const double polygon = 48.0 / 2 * std::sin(2 * pi / 48);
  const double expected = polygon * (1 - 0.25) * 1 + polygon * (1.96 - 0.64) * 1.5 +
                          profile_volume(48, 1, 1.4, 0, 0, 1.5) - profile_volume(48, 0.5, 0.8, 0, 0, 1.5);
  EXPECT_NEAR(volume_of(out), expected, 0.02 * expected);
}

TEST(Fuse, joins_holes_without_planes) {
  // The same body, cut by a plane and with a hole there: the kept part of the cut one is the mesh with the hole.
  const Blend_mesh low = frustum(0.8, 1.2, 40, -2, 2, 4), high = frustum(0.7, 0.7, 40, 2, 4, 2);
  Blend_mesh open = low;
  for (const Face f : open.faces()) {
    double highest = -9;
    for (const std::size_t v : corners_of(open, f)) highest = std::max(highest, open.point(Vertex(v)).z());
    if (highest > 1e-9) CGAL::Euler::remove_face(open.halfedge(f), open);
  }
  open.collect_garbage();
  Blend_mesh out;
  EXPECT_TRUE(check_fusion_part(open, std::nullopt).ok());
  const Fuse_outcome outcome = unchecked::fuse({{&open}, std::nullopt}, {{&high}, upper_plane(2.5)}, out);
  expect_valid(outcome, out);
  EXPECT_TRUE(outcome.one_sided[0]);
  EXPECT_FALSE(outcome.one_sided[1]);
  EXPECT_EQ(outcome.kept_faces, open.number_of_faces() + faces_below(high, upper_plane(2.5)).size());
  const double expected =
      frustum_volume(40, 0.8, 1, 2) + profile_volume(40, 1, 0.7, 0.1, 0, 2.5) + 0.49 * 1.5 * 20 * std::sin(2 * pi / 40);
  EXPECT_NEAR(volume_of(out), expected, 0.005 * expected);
}

TEST(Fuse, follows_rigid_motions_and_scale) {
  const Blend_mesh low = frustum(1.1, 0.8, 32, -1, 0.5, 4),
                   high = transformed(frustum(0.5, 0.7, 32, 1, 3, 3), moved_by(0.2, 0.1, 0));
  Blend_mesh plain;
  const Fuse_outcome first = unchecked::fuse({{&low}, lower_plane}, {{&high}, upper_plane(1.4)}, plain);
  expect_valid(first, plain);
  for (const double scale : {1e-3, 1.0, 1e6}) {
    const Placement to = placement({1, -2, 0.5}, 2.2, {3 * scale, -4 * scale, scale}) * Placement(CGAL::SCALING, scale);
    const auto moved = [&](const Cut_plane& p) { return Cut_plane{to.transform(p.point), to.transform(p.normal)}; };
    const Blend_mesh a = transformed(low, to), b = transformed(high, to);
    Blend_mesh out;
    const Fuse_outcome outcome = unchecked::fuse({{&a}, moved(lower_plane)}, {{&b}, moved(upper_plane(1.4))}, out);
    expect_valid(outcome, out);
    EXPECT_NEAR(outcome.volume, first.volume * std::pow(scale, 3), 2e-3 * first.volume * std::pow(scale, 3));
    EXPECT_NEAR(outcome.height, 1.4 * scale, 1e-9 * scale);
    EXPECT_NEAR(outcome.tangency_mean, first.tangency_mean, 0.5);
  }
}

TEST(Fuse, is_deterministic) {
  const auto lows = on_circle(frustum(0.5, 0.5, 24, -1.3, 0.4, 3), 2, 0.9, 0.1);
  const Blend_mesh high = frustum(0.9, 0.9, 32, 1, 3, 3);
  Blend_mesh one, two;
  ASSERT_TRUE(unchecked::fuse(side_of_meshes(lows, lower_plane), {{&high}, upper_plane(2)}, one).ok());
  ASSERT_TRUE(unchecked::fuse(side_of_meshes(lows, lower_plane), {{&high}, upper_plane(2)}, two).ok());
  EXPECT_TRUE(identical(one, two));
}

TEST(Fuse, is_independent_of_what_is_far_away) {
  const Blend_mesh low = frustum(1, 1, 32, -4, 0.5, 8), high = frustum(0.7, 0.7, 32, 1, 3, 3);
  const Blend_mesh other = side_by_side(low, transformed(sphere(1, 2), moved_by(20, 0, -9)));
  Blend_mesh a, b;
  const Fuse_outcome one = unchecked::fuse({{&low}, lower_plane}, {{&high}, upper_plane(1.5)}, a);
  const Fuse_outcome two = unchecked::fuse({{&other}, lower_plane}, {{&high}, upper_plane(1.5)}, b);
  expect_valid(one, a);
  expect_valid(two, b);
  EXPECT_EQ(one.transition_faces.size(), two.transition_faces.size());
  EXPECT_EQ(two.euler_characteristic, one.euler_characteristic + 2);
}

/// Converts to a mesh of another type by its own points.
template <class Graph>
Graph as(const Blend_mesh& mesh) {
  Graph graph;
  CGAL::copy_face_graph(mesh, graph);
  return graph;
}

TEST(Fuse, takes_meshes_of_any_type) {
  using Exact_mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3>;
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  using Plain_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  const Blend_mesh low = frustum(1, 1, 24, -1, 0.5, 4), high = frustum(0.7, 0.7, 24, 1, 3, 3);
  Blend_mesh expected;
  const Fuse_outcome plain = unchecked::fuse({{&low}, lower_plane}, {{&high}, upper_plane(1.5)}, expected);
  ASSERT_TRUE(plain.ok());
  const auto exact = as<Exact_mesh>(low);
  const auto polyhedron = as<Polyhedron>(high);
  const Fusion_side_of<Exact_mesh> a{{&exact}, lower_plane};
  const Fusion_side_of<Polyhedron> b{{&polyhedron}, upper_plane(1.5)};
  Polyhedron out;
  const auto result = fuse(a, b, out);
  ASSERT_TRUE(result.ok()) << message(result.diagnosis);
  EXPECT_EQ(num_faces(out), expected.number_of_faces());
  EXPECT_EQ(result.transition_faces.size(), plain.transition_faces.size());
  EXPECT_EQ(result.volume, plain.volume);
  Plain_mesh other;
  EXPECT_EQ(fuse(a, b, other).kept_faces, plain.kept_faces);
  EXPECT_EQ(num_faces(other), expected.number_of_faces());
  Exact_mesh exact_out;
  ASSERT_EQ(fuse(a, Fusion_side_of<Polyhedron>{{&polyhedron}, upper_plane(9)}, exact_out).diagnosis.status,
            Status::plane_misses_mesh);
  EXPECT_EQ(num_faces(exact_out), 0u) << "refused: not touched";
}

TEST(Fuse, takes_points_from_maps) {
  const Blend_mesh low = frustum(1, 1, 24, -1, 0.5, 4), high = frustum(0.7, 0.7, 24, 1, 3, 3);
  Blend_mesh expected;
  ASSERT_TRUE(unchecked::fuse({{&low}, lower_plane}, {{&high}, upper_plane(1.5)}, expected).ok());
  Blend_mesh elsewhere = high;
  auto points = elsewhere.add_property_map<Vertex, Point_3>("v:true_point").first;
  for (const Vertex v : elsewhere.vertices()) {
    points[v] = elsewhere.point(v);
    elsewhere.point(v) = CGAL::ORIGIN;
  }
  Blend_mesh out;
  auto out_points = out.add_property_map<Vertex, Point_3>("v:true_point").first;
  const auto result = fuse(Fusion_side{{&low}, lower_plane}, Fusion_side{{&elsewhere}, upper_plane(1.5)}, out,
                           Fuse_options(), CGAL::parameters::default_values(),
                           CGAL::parameters::vertex_point_map(points), CGAL::parameters::vertex_point_map(out_points));
  ASSERT_TRUE(result.ok()) << message(result.diagnosis);
  EXPECT_TRUE(same_connectivity(out, expected));
  for (const Vertex v : out.vertices()) EXPECT_EQ(out_points[v], expected.point(v));
}

TEST(Fuse, does_with_the_kept_side_just_below_a_lid) {
  // The lid is nearer than the shifted section: there is none above, and the slope comes from below.
  const Blend_mesh low = frustum(1.2, 1, 24, -1, 0.02, 3), high = frustum(0.7, 0.7, 24, 1, 3, 3);
  Blend_mesh out;
  const Fuse_outcome outcome = unchecked::fuse({{&low}, lower_plane}, {{&high}, upper_plane(1.5)}, out);
  expect_valid(outcome, out);
  EXPECT_TRUE(outcome.one_sided[0]);
  EXPECT_FALSE(outcome.one_sided[1]);
  EXPECT_LE(outcome.tangency_max, 360.0 / 24);
}

}  // namespace
