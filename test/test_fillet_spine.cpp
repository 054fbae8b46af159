// SPDX-License-Identifier: GPL-3.0-or-later
// Spines that cross themselves, and the largest radius: a pillar with a waist, whose curve of foot points is known.
#include "checks.h"
#include "shapes.h"
#include "spine_loops.h"

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

// The waist of rho = 10 + 4 cos(2 t), at t = 90 degrees, is curved inwards with radius (rho^2 + 2 rho'^2 - rho rho'')^-1
// rho^3 = 216 / 60.
constexpr double waist_radius = 3.6;

double rho(double t) { return 10 + 4 * std::cos(2 * t); }

Blend_mesh waisted_pillar(int n) {
  std::vector<std::pair<double, double>> outline;
  for (int i = 0; i < n; ++i) {
    const double t = 2 * pi * i / n;
    outline.emplace_back(rho(t) * std::cos(t), rho(t) * std::sin(t));
  }
  return prism(outline, -5.3, 20);
}

/// Distance of a point outside the pillar from its wall, in the plane.
double distance_to_wall(double x, double y) {
  const auto distance = [&](double t) { return std::hypot(rho(t) * std::cos(t) - x, rho(t) * std::sin(t) - y); };
  constexpr int samples = 96;
  double best = 0;
  for (int i = 1; i < samples; ++i)
    if (distance(2 * pi * i / samples) < distance(best)) best = 2 * pi * i / samples;
  for (double step = 2 * pi / samples; step > 1e-12; step /= 2)
    for (const double t : {best - step, best + step})
      if (distance(t) < distance(best)) best = t;
  return distance(best);
}

struct Foot {
  Blend_mesh mesh;
  Fillet_outcome outcome;
};

Foot blended_foot(double radius, bool mend, Blend_mode mode = Blend_mode::stitch) {
  Fillet_options options;
  options.radius = radius;
  options.chord_tolerance = 5e-4;
  options.mend_spine = mend;
  options.mode = mode;
  Foot foot;
  foot.outcome =
      unchecked::corefine_and_fillet(plate(40, 10), waisted_pillar(512), Boolean_operation::union_, foot.mesh, options);
  return foot;
}

/// Largest distance of the blend's vertices from the ball that rolls in contact with wall and plate, over the radius, for
/// |x| from `low` on: where wall and plate are d and z away, (r - d)^2 + (r - z)^2 = r^2.
double off_ball(const Foot& foot, double radius, double low) {
  double worst = 0;
  for (const Face f : foot.outcome.blend_faces)
    for (const Vertex v : foot.mesh.vertices_around_face(foot.mesh.halfedge(f))) {
      const Point_3& p = foot.mesh.point(v);
      if (std::abs(p.x()) < low) continue;
      const double d = distance_to_wall(p.x(), p.y());
      worst = std::max(worst, std::abs(std::hypot(radius - d, radius - p.z()) - radius) / radius);
    }
  return worst;
}

TEST(FilletSpine, BallThatFitsTheWaistNeedsNoMending) {
  const Foot foot = blended_foot(3.4, true);
  ASSERT_TRUE(foot.outcome.ok()) << message(foot.outcome.diagnosis);
  EXPECT_EQ(foot.outcome.blends.at(0).loops, 0u);
  EXPECT_LT(off_ball(foot, 3.4, 0), 0.005);
}

TEST(FilletSpine, LoopsInTheWaistAreCutOffAndJoined) {
  for (const double radius : {4.0, 5.0, 7.0}) {
    const Foot foot = blended_foot(radius, true);
    ASSERT_TRUE(foot.outcome.ok()) << radius << message(foot.outcome.diagnosis);
    EXPECT_EQ(foot.outcome.blends.at(0).loops, 2u) << radius;
    EXPECT_TRUE(validate(foot.mesh).ok()) << radius;
    EXPECT_TRUE(is_closed_by_counting(foot.mesh)) << radius;
    // Away from the joints, whose contacts on the wall reach farther out than they do: the ball as ever.
    EXPECT_LT(off_ball(foot, radius, 1.5 * radius), 0.005) << radius;
    EXPECT_LT(off_ball(foot, radius, 0), 0.2) << radius;  // over them: near it
  }
}

TEST(FilletSpine, WithoutMendingTheWaistIsRefusedWithPlaceAndRadius) {
  const Foot foot = blended_foot(5, false);
  ASSERT_EQ(foot.outcome.diagnosis.status, Status::radius_exceeds_curvature);
  EXPECT_TRUE(foot.mesh.is_empty());
  ASSERT_TRUE(foot.outcome.diagnosis.point.has_value());
  EXPECT_NEAR(foot.outcome.diagnosis.point->x(), 0, 1);  // in one of the two waists
  ASSERT_TRUE(foot.outcome.diagnosis.max_radius.has_value());
  EXPECT_NEAR(*foot.outcome.diagnosis.max_radius, waist_radius, 0.04 * waist_radius);
  EXPECT_TRUE(blended_foot(*foot.outcome.diagnosis.max_radius, false).outcome.ok());
}

TEST(FilletSpine, LargestRadiusOnARimIsTheDistanceToTheAxis) {
  const Blend_mesh body = cylinder(15, 128, 0, 40);
  std::vector<Edge> rim;
  for (const Edge e : body.edges())
    if (body.point(body.vertex(e, 0)).z() == 40 && body.point(body.vertex(e, 1)).z() == 40 &&
        std::hypot(body.point(body.vertex(e, 0)).x(), body.point(body.vertex(e, 0)).y()) > 14 &&
        std::hypot(body.point(body.vertex(e, 1)).x(), body.point(body.vertex(e, 1)).y()) > 14)
      rim.push_back(e);
  ASSERT_EQ(rim.size(), 128u);
  Fillet_options options;
  options.radius = 16;
  Blend_mesh out;
  const Fillet_outcome outcome = unchecked::fillet_edges(body, {{rim, 0, {}}}, out, options);
  ASSERT_FALSE(outcome.ok());
  ASSERT_TRUE(outcome.diagnosis.max_radius.has_value());
  EXPECT_LT(*outcome.diagnosis.max_radius, 15);
  EXPECT_GT(*outcome.diagnosis.max_radius, 0.94 * 15);
  options.radius = *outcome.diagnosis.max_radius;
  EXPECT_TRUE(unchecked::fillet_edges(body, {{rim, 0, {}}}, out, options).ok());
}

// The unit itself: spines over a plane.

Ball_position over_plane(double x, double y, double radius, const Base_surface& plane) {
  Ball_position p;
  p.center = Vec(x, y, radius);
  const Vec below(x, y, 0);
  for (const Face f : plane.mesh().faces()) {
    if (plane.frame(f).face_normal.z() < 0.5) continue;
    const Surface_point at = plane.locate(f, below);
    if ((plane.position(at) - below).norm() < 1e-9) p.foot = {at, at};
  }
  p.contact = {below, below};
  return p;
}

/// rho = 8 + 16 cos t runs through the origin twice.
std::vector<Ball_position> limacon(double radius, const Base_surface& plane) {
  std::vector<Ball_position> positions;
  constexpr int n = 240;
  for (int i = 0; i < n; ++i) {
    const double t = 2 * pi * (i + 0.5) / n, rho = 8 + 16 * std::cos(t);
    positions.push_back(over_plane(rho * std::cos(t), rho * std::sin(t), radius, plane));
  }
  return positions;
}

TEST(SpineLoops, CrossingIsFoundAndTheLoopIsGone) {
  const double radius = 2;
  const Blend_mesh body = box({-200, -200, -10}, {200, 200, 0});
  const Base_surface plane(body, {});
  const std::vector<Ball_position> positions = limacon(radius, plane);
  const auto crossing = find_crossing(positions, radius);
  ASSERT_TRUE(crossing.has_value());
  EXPECT_LT((crossing->point - Vec(0, 0, radius)).norm(), 0.05 * radius);
  const auto mended = cut_loop(positions, *crossing, {&plane, &plane}, radius, 0.3 * radius);
  ASSERT_TRUE(mended.has_value());
  EXPECT_FALSE(find_crossing(*mended, radius).has_value());
  double sharpest = 1;
  for (std::size_t i = 0, n = mended->size(); i < n; ++i) {
    const Vec a = (*mended)[i].center, b = (*mended)[(i + 1) % n].center, c = (*mended)[(i + 2) % n].center;
    sharpest = std::min(sharpest, (b - a).normalized().dot((c - b).normalized()));
    for (int side = 0; side < 2; ++side) EXPECT_NEAR((b - (*mended)[(i + 1) % n].contact[side]).norm(), radius, 1e-9);
    EXPECT_GT(a.head<2>().norm(), 0.1 * radius);  // the joint keeps away from the crossing
  }
  EXPECT_GT(sharpest, std::cos(50 * pi / 180));
}

TEST(SpineLoops, SimpleSpinesHaveNoCrossing) {
  const Blend_mesh body = box({-200, -200, -10}, {200, 200, 0});
  const Base_surface plane(body, {});
  std::vector<Ball_position> circle;
  for (int i = 0; i < 100; ++i)
    circle.push_back(over_plane(10 * std::cos(2 * pi * i / 100), 10 * std::sin(2 * pi * i / 100), 1, plane));
  EXPECT_FALSE(find_crossing(circle, 1).has_value());
  EXPECT_FALSE(find_trimmed_loop(circle, {&plane, &plane}, 1).has_value());
}

TEST(SpineLoops, StrandsSideBySideDoNotCross) {
  // A ball that nearly fills a slot: there and back again, 0.02 of its radius apart.
  const Blend_mesh body = box({-200, -200, -10}, {200, 200, 0});
  const Base_surface plane(body, {});
  std::vector<Ball_position> slot;
  for (int i = 0; i <= 40; ++i) slot.push_back(over_plane(0.25 * i, -0.005, 1, plane));
  for (int i = 40; i >= 0; --i) slot.push_back(over_plane(0.25 * i, 0.005, 1, plane));
  EXPECT_FALSE(find_crossing(slot, 1).has_value());
}

}  // namespace
}  // namespace cgal_blend::test
