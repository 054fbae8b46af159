// SPDX-License-Identifier: GPL-3.0-or-later
// Sharpening: a round along planes and cylinders is taken back to the edge that it came from.
#include "checks.h"
#include "shapes.h"

#include <cgal_blend/fillet.h>
#include <cgal_blend/validate.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace cgal_blend::test {
namespace {

constexpr double round_radius = 3;

/// A cylinder of radius 15 and height 20 whose top rim is rounded in `steps` facets (an even number), with rings of faces
/// `spacing` apart.
struct Rounded {
  Blend_mesh mesh;
  std::vector<Edge> middle;
};

Rounded rounded_cylinder(int n, int steps, double spacing) {
  constexpr double R = 15, r = round_radius, top = 20;
  std::vector<std::pair<double, double>> outline{{0, 0}};
  for (double x = spacing; x < R - spacing / 2; x += spacing) outline.emplace_back(x, 0);
  for (double z = 0; z < top - r - spacing / 2; z += spacing) outline.emplace_back(R, z);
  for (int k = 0; k <= steps; ++k) {
    const double a = pi / 2 * k / steps;
    outline.emplace_back(R - r + r * std::cos(a), top - r + r * std::sin(a));
  }
  for (double x = R - r - spacing; x > spacing / 2; x -= spacing) outline.emplace_back(x, top);
  outline.emplace_back(0, top);
  Rounded result{turned(outline, n), {}};
  const double z = top - r + r * std::sqrt(0.5);
  for (const Edge e : result.mesh.edges())
    if (std::abs(result.mesh.point(result.mesh.vertex(e, 0)).z() - z) < 1e-9 &&
        std::abs(result.mesh.point(result.mesh.vertex(e, 1)).z() - z) < 1e-9)
      result.middle.push_back(e);
  return result;
}

double off_sharp_cylinder(const Point_3& p) {
  return std::min(std::abs(p.z() - 20), std::abs(std::hypot(p.x(), p.y()) - 15));
}

/// Sharpens and checks that all vertices that are new or moved lie on the two surfaces, and some on the edge.
void expect_sharp(const Rounded& body, Blend_mode mode, double radius) {
  ASSERT_EQ(body.middle.size(), 256u);
  Fillet_options options;
  options.radius = radius;
  options.profile = sharp_profile();
  options.mode = mode;
  options.chord_tolerance = 1e-4;
  Blend_mesh out;
  const Fillet_outcome outcome = unchecked::fillet_edges(body.mesh, {{body.middle, 0, {}}}, out, options);
  ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
  EXPECT_TRUE(validate(out).ok());
  const auto old_points = body.mesh.points();
  const std::set<Point_3> old(old_points.begin(), old_points.end());
  double off = 0, edge = 0;
  std::size_t on_edge = 0;
  for (const Vertex v : out.vertices()) {
    const Point_3& p = out.point(v);
    if (old.count(p) != 0) continue;
    off = std::max(off, off_sharp_cylinder(p));
    if (std::hypot(p.z() - 20, std::hypot(p.x(), p.y()) - 15) < 0.01 * round_radius) ++on_edge;
  }
  EXPECT_LT(off, 0.01 * round_radius);
  EXPECT_GE(on_edge, mode == Blend_mode::map ? 256u : 50u);
  for (const Vertex v : out.vertices())  // nothing of the round is left
    if (out.point(v).z() > 17.5 && std::hypot(out.point(v).x(), out.point(v).y()) > 12.5)
      edge = std::max(edge, off_sharp_cylinder(out.point(v)));
  EXPECT_LT(edge, 0.01 * round_radius);
  const double sharp_volume = 20 * 0.5 * 256 * 15 * 15 * std::sin(2 * pi / 256);
  EXPECT_NEAR(volume_of(out), sharp_volume, 2e-4 * sharp_volume);
}

TEST(Sharpen, RoundedRimByStitching) { expect_sharp(rounded_cylinder(256, 14, 2), Blend_mode::stitch, 3.6); }
TEST(Sharpen, LargerBall) { expect_sharp(rounded_cylinder(256, 14, 2), Blend_mode::stitch, 4.5); }
TEST(Sharpen, RoundedRimByMapping) { expect_sharp(rounded_cylinder(256, 14, 0.3), Blend_mode::map, 3.6); }

TEST(Sharpen, RadiusThatDoesNotReachBeyondTheRound) {
  const Rounded body = rounded_cylinder(256, 14, 2);
  Fillet_options options;
  options.profile = sharp_profile();
  for (const double share : {0.7, 0.95, 1.02}) {
    options.radius = share * round_radius;
    Blend_mesh out;
    const Fillet_outcome outcome = unchecked::fillet_edges(body.mesh, {{body.middle, 0, {}}}, out, options);
    if (!outcome.ok()) continue;
    double off = 0;  // what is handed out is sharp
    for (const Face f : outcome.blend_faces)
      for (const Vertex v : out.vertices_around_face(out.halfedge(f)))
        off = std::max(off, off_sharp_cylinder(out.point(v)));
    EXPECT_LT(off, 0.01 * round_radius) << share;
  }
}

TEST(Sharpen, UndoesAFillet) {
  // A fillet at the foot of a boss: the blend's own rows hold the curve.
  const Blend_mesh ground = plate(40, 10), boss = cylinder(15, 128, -4.3, 20);
  Fillet_options options;
  options.radius = round_radius;
  Blend_mesh sharp, rounded, out;
  ASSERT_TRUE(unchecked::corefine_and_fillet(ground, boss, Boolean_operation::union_, sharp, {}).ok());
  ASSERT_TRUE(unchecked::corefine_and_fillet(ground, boss, Boolean_operation::union_, rounded, options).ok());
  // One row near the middle of the arc: all edges whose ends are on the same circle of the torus.
  double height = 0, nearest = 1;
  for (const Vertex v : rounded.vertices()) {
    const Point_3& p = rounded.point(v);
    const double radial = std::hypot(p.x(), p.y());
    if (radial < 15 || radial > 18 || p.z() <= 0 || p.z() >= 3) continue;
    const double angle = std::atan2(3 - p.z(), 18 - radial);
    if (std::abs(angle - pi / 4) < nearest) {
      nearest = std::abs(angle - pi / 4);
      height = p.z();
    }
  }
  std::vector<Edge> middle;
  for (const Edge e : rounded.edges()) {
    const Point_3 &p = rounded.point(rounded.vertex(e, 0)), &q = rounded.point(rounded.vertex(e, 1));
    if (std::abs(p.z() - height) < 0.02 && std::abs(q.z() - height) < 0.02) middle.push_back(e);
  }
  ASSERT_GT(middle.size(), 50u);
  options.radius = 1.2 * round_radius;
  options.profile = sharp_profile();
  const Fillet_outcome outcome = unchecked::fillet_edges(rounded, {{middle, 0, {}}}, out, options);
  ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
  EXPECT_TRUE(validate(out).ok());
  double off = 0;
  for (const Face f : outcome.blend_faces)
    for (const Vertex v : out.vertices_around_face(out.halfedge(f))) {
      const Point_3& p = out.point(v);
      off = std::max(off, std::min(std::abs(p.z()), std::abs(std::hypot(p.x(), p.y()) - 15)));
    }
  EXPECT_LT(off, 0.01 * round_radius);
  EXPECT_NEAR(volume_of(out), volume_of(sharp), 0.01 * (volume_of(rounded) - volume_of(sharp)));
}

}  // namespace
}  // namespace cgal_blend::test
