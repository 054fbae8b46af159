// SPDX-License-Identifier: GPL-3.0-or-later
// Rolling-ball blends against closed forms: tori where planes and cylinders meet, and the exact spine of two cylinders.
#include "blends.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace cgal_blend::test {
namespace {

using unchecked::corefine_and_fillet;
using unchecked::corefine_and_fillet_all;
using unchecked::fillet_edges;

constexpr double R = 15, r = 5;
constexpr double fine = 1e-4;  // chord tolerance: only the operands' facets count

struct Step {
  int sides;
  double tolerance;
};
constexpr Step steps[] = {{64, 0.01}, {128, 0.003}, {256, 0.001}};

TEST(Fillet, BossOnPlateIsATorus) {
  std::vector<double> error;
  for (const Step& step : steps) {
    const Blended b = blend(plate(50, 10), cylinder(R, step.sides, -5, 40), Boolean_operation::union_, options_of(r, fine));
    ASSERT_TRUE(b.outcome.ok());
    EXPECT_FALSE(b.outcome.blends.at(0).convex);
    EXPECT_NEAR(b.change, foot_volume(R, r), step.tolerance * foot_volume(R, r)) << step.sides;
    const double off = largest(blend_points(b.mesh, b.outcome),
                               [](const Point_3& p) { return distance_to_torus(p, {0, 0, r}, {0, 0, 1}, R + r, r); });
    error.push_back(off);
    if (step.sides != 128) continue;
    EXPECT_LT(off, 0.002 * r);
    EXPECT_LT(b.outcome.blends[0].radius_error, 0.002);
    EXPECT_LT(b.outcome.blends[0].tangency_deg, 360.0 / 128);  // half a facet angle, and the rest of the path
  }
  EXPECT_GE(order(error[0], error[1]), 1.8);
  EXPECT_GE(order(error[1], error[2]), 1.8);
}

TEST(Fillet, TopRimOfABossIsATorus) {
  std::vector<double> error;
  for (const Step& step : steps) {
    const Blend_mesh boss = cylinder(R, step.sides, 0, 40);
    const Blended b = blend_edges(boss, creases_at_height(boss, 40), options_of(r, fine));
    ASSERT_TRUE(b.outcome.ok());
    EXPECT_TRUE(b.outcome.blends.at(0).convex);
    EXPECT_NEAR(-b.change, rim_volume(R, r), step.tolerance * rim_volume(R, r)) << step.sides;
    error.push_back(largest(blend_points(b.mesh, b.outcome), [](const Point_3& p) {
      return distance_to_torus(p, {0, 0, 40 - r}, {0, 0, 1}, R - r, r);
    }));
    if (step.sides == 128) {
      EXPECT_LT(error.back(), 0.002 * r);
    }
  }
  EXPECT_GE(order(error[0], error[1]), 1.8);
  EXPECT_GE(order(error[1], error[2]), 1.8);
}

TEST(Fillet, RimsOfABoreAreTori) {
  const double small = 3;  // two rims share the plate's thickness of 10
  std::vector<double> error;
  for (const Step& step : steps) {
    const Blended b =
        blend(plate(50, 10), cylinder(R, step.sides, -20, 20), Boolean_operation::difference, options_of(small, fine));
    ASSERT_TRUE(b.outcome.ok());
    ASSERT_EQ(b.outcome.blends.size(), 2u);
    EXPECT_TRUE(b.outcome.blends[0].convex);
    EXPECT_NEAR(-b.change, 2 * foot_volume(R, small), step.tolerance * 2 * foot_volume(R, small)) << step.sides;
    error.push_back(largest(blend_points(b.mesh, b.outcome), [&](const Point_3& p) {
      const double z = p.z() > -5 ? -small : -10 + small;
      return distance_to_torus(p, {0, 0, z}, {0, 0, 1}, R + small, small);
    }));
    if (step.sides == 128) {
      EXPECT_LT(error.back(), 0.002 * small);
    }
  }
  EXPECT_GE(order(error[0], error[1]), 1.8);
  EXPECT_GE(order(error[1], error[2]), 1.8);
}

TEST(Fillet, IntersectionRoundsBothRims) {
  const Blended b = blend(plate(50, 10), cylinder(R, 128, -20, 20), Boolean_operation::intersection, options_of(3, fine));
  ASSERT_TRUE(b.outcome.ok());
  EXPECT_NEAR(-b.change, 2 * rim_volume(R, 3), 0.003 * 2 * rim_volume(R, 3));
}

/// Points of the intersection of the cylinder of radius `big` about z with the one of radius `small` about `axis`.
std::vector<Point_3> cylinders_meet(double big, double small, const Vector_3& axis) {
  const Vector_3 side{0, 1, 0}, up = CGAL::cross_product(axis, side);
  std::vector<Point_3> points;
  const int samples = 40000;
  for (int i = 0; i < samples; ++i) {
    const double t = 2 * pi * i / samples;
    const Vector_3 q = small * (std::cos(t) * side + std::sin(t) * up);
    // |q + s axis| = big, z left out: a quadratic in s.
    const double a = axis.x() * axis.x() + axis.y() * axis.y(), b = q.x() * axis.x() + q.y() * axis.y();
    const double c = q.x() * q.x() + q.y() * q.y() - big * big;
    for (const double sign : {-1.0, 1.0}) points.push_back(CGAL::ORIGIN + (q + (-b + sign * std::sqrt(b * b - a * c)) / a * axis));
  }
  return points;
}

double nearest_distance(const Point_3& p, const std::vector<Point_3>& points) {
  double best = std::numeric_limits<double>::max();
  for (const Point_3& q : points) best = std::min(best, CGAL::squared_distance(p, q));
  return std::sqrt(best);
}

TEST(Fillet, SpineOfTwoCylindersIsExact) {
  for (const double degrees : {90.0, 45.0}) {
    const double angle = degrees * pi / 180;
    Blend_mesh second = cylinder(7, 128, -60, 60);
    second = transformed(second, placement({0, 1, 0}, angle));
    const Vector_3 axis{std::sin(angle), 0, std::cos(angle)};
    const Blended b = blend(cylinder(10, 128, -60, 60), second, Boolean_operation::union_, options_of(2));
    ASSERT_TRUE(b.outcome.ok());
    ASSERT_EQ(b.outcome.blends.size(), 2u);
    const std::vector<Point_3> spine = cylinders_meet(12, 9, axis);
    std::vector<Point_3> points = blend_points(b.mesh, b.outcome);
    for (std::size_t i = 0; i < points.size(); i += 7)
      EXPECT_NEAR(nearest_distance(points[i], spine), 2, 0.005 * 2) << degrees << " degrees, " << points[i];
  }
}

TEST(Fillet, FacesAwayFromTheBlendAreUntouched) {
  const Blend_mesh a = grid_box({-50, -50, -10}, {50, 50, 0}, 16), b = cylinder(R + 0.3, 96, -5, 40, 30);
  const Blended blended = blend(a, b, Boolean_operation::union_, options_of(r));
  ASSERT_TRUE(blended.outcome.ok());
  // Faces of a come first, then those of b, each in the operand's order, bit for bit; none beyond a distance is missing.
  std::vector<Face> far_a, far_b;
  for (const Face f : a.faces()) {
    bool far = true;
    for (const Vertex v : a.vertices_around_face(a.halfedge(f))) {
      const Point_3& p = a.point(v);
      far = far && (p.z() < 0 || std::hypot(p.x(), p.y()) > R + 0.3 + r + 10);
    }
    if (far) far_a.push_back(f);
  }
  for (const Face f : b.faces()) {
    bool far = true;
    for (const Vertex v : b.vertices_around_face(b.halfedge(f))) far = far && b.point(v).z() > r + 2;
    if (far) far_b.push_back(f);
  }
  EXPECT_TRUE(faces_kept_in_order(a, blended.mesh, far_a));
  EXPECT_TRUE(faces_kept_in_order(b, blended.mesh, far_b));
  EXPECT_GE(blended.outcome.kept_faces, far_a.size() + far_b.size());
}

TEST(Fillet, LinkageCurvesMayRunAlongEdges) {
  // Circles of edges where the ball touches: on the boss, on the plate, or on both.
  std::vector<Blend_mesh> bodies;
  for (const double step : {1.0, 0.5, 5.0}) bodies.push_back(boss_on_plate(R, 40, 8, 30, step));
  for (const Blend_mesh& body : bodies)
    for (const Blend_mode mode : {Blend_mode::stitch, Blend_mode::map}) {
      Fillet_options options = options_of(r);
      options.mode = mode;
      std::vector<Edge> foot;
      for (const Edge e : creases_at_height(body, 0))
        if (!is_convex_edge(e, body)) foot.push_back(e);
      Blend_mesh out;
      const Fillet_outcome outcome = fillet_edges(body, {{foot, 0}}, out, options);
      if (mode == Blend_mode::map && body.number_of_vertices() < 1000) continue;  // too coarse to be moved
      ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
      EXPECT_TRUE(validate(out).ok());
      EXPECT_LT(outcome.blends[0].radius_error, 0.1);
      EXPECT_NEAR(volume_of(out) - volume_of(body), foot_volume(R, r), 0.1 * foot_volume(R, r));
    }
  for (const int rings : {8, 17}) {  // at 0, 5, 10, ...; every 2.5
    const Blended b =
        blend(plate(50, 10), cylinder(R, 128, -5, 40, rings), Boolean_operation::union_, options_of(r, fine));
    ASSERT_TRUE(b.outcome.ok());
    EXPECT_NEAR(b.change, foot_volume(R, r), 0.003 * foot_volume(R, r));
  }
  // The equator of a sphere is made of edges.
  const Blended b = blend(plate(50, 10), sphere(20, 4, {0.01, 0.02, r}), Boolean_operation::union_, options_of(r));
  ASSERT_TRUE(b.outcome.ok());
  EXPECT_LT(b.outcome.blends[0].radius_error, 0.005);
}

TEST(Fillet, LinkageCurvesMayTouchEdges) {
  // The contact circle's polyline meets the grid line x = 20 in points from one side.
  const Blend_mesh body = grid_box({-50, -50, -10}, {50, 50, 0}, 60),
                   boss = transformed(cylinder(R, 56, -5.1, 40.3, 27), placement({0, 0, 1}, 0.1));
  const Blended b = blend(body, boss, Boolean_operation::union_, options_of(r, 1e-5));
  ASSERT_TRUE(b.outcome.ok());
  EXPECT_NEAR(b.change, foot_volume(R, r), 0.01 * foot_volume(R, r));
}

TEST(Fillet, SameInputGivesTheSameBytes) {
  const Blend_mesh a = sphere(10, 3), b = sphere(7, 3, {9, 1, 2});
  const Blended first = blend(a, b, Boolean_operation::union_, options_of(1));
  const Blended second = blend(a, b, Boolean_operation::union_, options_of(1));
  EXPECT_TRUE(identical(first.mesh, second.mesh));
}

TEST(Fillet, SameInputGivesTheSameBytesWhereverItLiesInMemory) {
  struct Case {
    Blend_mesh a, b;
    double radius;
  };
  const std::vector<Case> cases{
      {cylinder(1, 64, -2, 2), transformed(cylinder(1, 64, -3, 3), placement({0, 1, 0}, pi / 2)), 0},
      {sphere(10, 4), sphere(8, 4, {9, 0, 0}), 1}};
  for (const Case& c : cases) {
    std::vector<std::vector<char>> gaps;  // what comes after them goes to other addresses
    std::vector<Blend_mesh> ballast;
    Blend_mesh first;
    for (int k = 0; k < 12; ++k) {
      gaps.emplace_back(1000 * (k + 1));
      ballast.push_back(sphere(1, k % 4));
      Blend_mesh out;
      const auto outcome = corefine_and_fillet(c.a, c.b, Boolean_operation::union_, out, options_of(c.radius));
      ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
      if (k == 0) first = out;
      EXPECT_TRUE(identical(first, out)) << "radius " << c.radius << ", run " << k;
    }
  }
}

TEST(Fillet, FollowsMotionAndScale) {
  const Blend_mesh a = plate(50, 10), b = cylinder(R, 64, -5, 40);
  const double change = blend(a, b, Boolean_operation::union_, options_of(r)).change;
  for (const double scale : {1e-3, 1.0, 1e6}) {
    const Placement move = placement({1, 2, 3}, 0.7, {3 * scale, -5 * scale, 8 * scale}, scale);
    const Blended b2 =
        blend(transformed(a, move), transformed(b, move), Boolean_operation::union_, options_of(r * scale));
    EXPECT_NEAR(b2.change / std::pow(scale, 3), change, 1e-3 * change) << scale;
  }
}

/// Two spheres: the spine is a circle, the blend a torus about the line through the centres.
TEST(Fillet, TwoSpheresBlendInATorus) {
  const double big = 10, small = 8, d = 9, ball = 1.5;
  Blend_mesh second = sphere(small, 5, {d, 0, 0});
  const Blended b = blend(sphere(big, 5), second, Boolean_operation::union_, options_of(ball));
  ASSERT_TRUE(b.outcome.ok());
  const double p = big + ball, q = small + ball;
  const double x = (d * d + p * p - q * q) / (2 * d), major = std::sqrt(p * p - x * x);
  const double off = largest(blend_points(b.mesh, b.outcome),
                             [&](const Point_3& at) { return distance_to_torus(at, {x, 0, 0}, {1, 0, 0}, major, ball); });
  EXPECT_LT(off, 0.01 * ball);
}

TEST(Fillet, BlendOfSpheresIsSmoothAgainstBothSurfaces) {
  const Blended coarse = blend(sphere(10, 3), sphere(8, 3, {9, 0.5, 0.25}), Boolean_operation::union_, options_of(1.5));
  const Blended finer = blend(sphere(10, 5), sphere(8, 5, {9, 0.5, 0.25}), Boolean_operation::union_, options_of(1.5));
  ASSERT_TRUE(coarse.outcome.ok() && finer.outcome.ok());
  EXPECT_LT(finer.outcome.blends[0].tangency_deg, 0.5 * coarse.outcome.blends[0].tangency_deg);
  EXPECT_LT(finer.outcome.blends[0].tangency_deg, 3);
}

// Series of booleans, each blended with a radius of its own.

/// A boss through the plate z <= 0 and the radius of its foot.
struct Boss {
  double x, y, R, r;
  [[nodiscard]] Blend_mesh mesh() const { return transformed(cylinder(R, 128, -5, 40), moved_by(x, y, 0)); }
  [[nodiscard]] double distance(const Point_3& p) const {
    return distance_to_torus(p, {x, y, r}, {0, 0, 1}, R + r, r);
  }
  /// Of the quarter circle turned about the axis (Pappus).
  [[nodiscard]] double foot_area() const { return 2 * pi * r * (pi / 2 * (R + r) - r); }
};

const std::vector<Boss> bosses{{-25, -20, 12, 6}, {25, -22, 9, 3}, {22, 20, 14, 4}, {-20, 25, 6, 1.5}};

struct Series {
  std::vector<Blend_mesh> meshes;
  std::vector<Part> parts;
  explicit Series(const std::vector<Boss>& all) {
    for (const Boss& boss : all) meshes.push_back(boss.mesh());
    for (std::size_t k = 0; k < all.size(); ++k)
      parts.push_back({&meshes[k], Boolean_operation::union_, all[k].r});
  }
};

TEST(Fillet_parts, EachBossStandsOnATorusOfItsOwn) {
  const Series series(bosses);
  Blend_mesh out;
  const Fillet_outcome outcome = corefine_and_fillet_all(plate(50, 10), series.parts, out, options_of(0, fine));
  ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
  EXPECT_TRUE(validate(out).ok());
  ASSERT_EQ(outcome.blends.size(), bosses.size());
  double sharp = 100 * 100 * 10, added = 0;
  for (std::size_t k = 0; k < bosses.size(); ++k) {
    const auto& [x, y, big, small] = bosses[k];
    EXPECT_EQ(outcome.blends[k].radius, small);
    EXPECT_LT(outcome.blends[k].radius_error, 0.005);
    sharp += volume_of(cylinder(big, 128, 0, 40));
    added += foot_volume(big, small);
  }
  EXPECT_NEAR(outcome.volume - sharp, added, 0.003 * added);
  EXPECT_EQ(outcome.volume, validate(out).volume);

  // The blend faces are those on one of the tori, all of them.
  std::vector<double> area(bosses.size(), 0);
  for (const Face f : outcome.blend_faces) {
    double off = 1e9;
    std::size_t nearest = 0;
    for (std::size_t k = 0; k < bosses.size(); ++k) {
      double worst = 0;
      for (const Vertex v : out.vertices_around_face(out.halfedge(f)))
        worst = std::max(worst, std::abs(bosses[k].distance(out.point(v))) / bosses[k].r);
      if (worst < off) nearest = k;
      off = std::min(off, worst);
    }
    EXPECT_LT(off, 0.005);
    area[nearest] += area_of(out, std::vector<Face>{f});
  }
  for (std::size_t k = 0; k < bosses.size(); ++k)
    EXPECT_NEAR(area[k], bosses[k].foot_area(), 0.005 * bosses[k].foot_area());
}

TEST(Fillet_parts, FacesOfTheInputComeFirstAndAreTraced) {
  const Series series(bosses);
  const Blend_mesh body = grid_box({-50, -50, -10}, {50, 50, 0}, 20);
  Blend_mesh all_inputs = body;
  for (const Blend_mesh& mesh : series.meshes) all_inputs = side_by_side(all_inputs, mesh);
  Blend_mesh out;
  const Fillet_outcome outcome = corefine_and_fillet_all(body, series.parts, out, options_of(0));
  ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
  ASSERT_GT(outcome.kept_faces, body.number_of_faces() / 2);
  EXPECT_EQ(outcome.kept_faces + outcome.changed_faces.size(), out.number_of_faces());
  std::vector<Face> kept;
  for (std::uint32_t f = 0; f < outcome.kept_faces; ++f) kept.push_back(Face(f));
  EXPECT_TRUE(faces_kept_in_order(out, all_inputs, kept));

  ASSERT_EQ(outcome.origins.size(), out.number_of_faces());
  std::set<Face> blends(outcome.blend_faces.begin(), outcome.blend_faces.end());
  for (const Face f : out.faces()) {
    ASSERT_EQ(outcome.origins[f] == no_origin, blends.count(f) == 1);
    if (blends.count(f)) continue;
    std::vector<Point_3> plane;  // parts lie in the planes of their origins
    for (const auto v : corners_of(all_inputs, Face(outcome.origins[f]))) plane.push_back(all_inputs.point(Vertex(v)));
    const Vector_3 normal = CGAL::normal(plane[0], plane[1], plane[2]);
    for (const Vertex v : out.vertices_around_face(out.halfedge(f)))
      ASSERT_NEAR(distance_to_plane(out.point(v), plane[0], normal), 0, 1e-9);
  }
}

TEST(Fillet_parts, LaterStepsLeaveTheRestOfEarlierBlends) {
  // Half the boss with its foot is cut away: half the torus is left, partly in cut faces.
  const Boss boss{0, 0, R, r};
  const Blend_mesh mesh = boss.mesh(), half = box({-60, 0, -20}, {60, 60, 60});
  const std::vector<Part> parts{{&mesh, Boolean_operation::union_, r}, {&half, Boolean_operation::difference, 0}};
  Blend_mesh out;
  const Fillet_outcome outcome = corefine_and_fillet_all(plate(50, 10), parts, out, options_of(0));
  ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
  EXPECT_NEAR(area_of(out, outcome.blend_faces), boss.foot_area() / 2, 0.005 * boss.foot_area());
  EXPECT_LT(largest(blend_points(out, outcome), [&](const Point_3& p) { return boss.distance(p); }), 0.005 * r);
  EXPECT_EQ(outcome.blends.size(), 1u);
}

TEST(Fillet_parts, LaterPartsStandOnEarlierBlends) {
  // The foot of the first boss reaches out to 18, where the second stands from 16 on.
  const std::vector<Boss> pair{{0, 0, 12, 6}, {24, 0, 8, 1}};
  const Series series(pair);
  Blend_mesh out;
  const Fillet_outcome outcome = corefine_and_fillet_all(plate(50, 10), series.parts, out, options_of(0));
  ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
  EXPECT_TRUE(validate(out).ok());
  ASSERT_EQ(outcome.blends.size(), 2u);
  EXPECT_LT(outcome.blends[1].radius_error, 0.01);
  EXPECT_LT(outcome.blends[1].tangency_deg, 5);
  // Away from the first foot the second is a torus as ever; the others are points of the first, or of the ball's way up.
  for (const Point_3& p : blend_points(out, outcome))
    EXPECT_TRUE(std::abs(pair[0].distance(p)) < 0.01 * pair[0].r || std::abs(pair[1].distance(p)) < 0.01 * pair[1].r ||
                std::hypot(p.x(), p.y()) < 12 + 6 + 1);
}

TEST(Fillet_parts, OnePartIsABooleanWithBlend) {
  const Blend_mesh a = sphere(10, 3), b = sphere(8, 3, {9, 0.5, 0.25});
  Blend_mesh expected, out;
  for (const double radius : {0.0, 1.5}) {
    const auto one = corefine_and_fillet(a, b, Boolean_operation::difference, expected, options_of(radius));
    const auto all = corefine_and_fillet_all(a, {{&b, Boolean_operation::difference, 0}}, out, options_of(radius));
    ASSERT_TRUE(one.ok() && all.ok());
    EXPECT_TRUE(identical(out, expected));
    EXPECT_EQ(all.blend_faces, one.blend_faces);
    EXPECT_EQ(all.changed_faces, one.changed_faces);
    EXPECT_EQ(all.kept_faces, one.kept_faces);
    EXPECT_EQ(all.origins, one.origins);
    EXPECT_EQ(all.volume, one.volume);
  }
}

TEST(Fillet_parts, FollowsMotionAndScaleAndIsDeterministic) {
  const Series series(bosses);
  Blend_mesh out, again;
  const Fillet_outcome outcome = corefine_and_fillet_all(plate(50, 10), series.parts, out, options_of(0));
  ASSERT_TRUE(corefine_and_fillet_all(plate(50, 10), series.parts, again, options_of(0)).ok());
  EXPECT_TRUE(identical(out, again));
  double added = 0;
  for (const Boss& boss : bosses) added += foot_volume(boss.R, boss.r);
  const double scale = 1e-3;
  const Placement move = placement({1, 2, 3}, 0.7, {0.1, 0.2, 0.3}, scale);
  Series moved(bosses);
  for (Blend_mesh& mesh : moved.meshes) mesh = transformed(mesh, move);
  for (Part& part : moved.parts) part.radius *= scale;
  const auto turned = corefine_and_fillet_all(transformed(plate(50, 10), move), moved.parts, again, options_of(0));
  ASSERT_TRUE(turned.ok()) << message(turned.diagnosis);
  EXPECT_NEAR(turned.volume / std::pow(scale, 3), outcome.volume, 2e-3 * added);
}

TEST(Fillet_parts, RefusalsNameTheStep) {
  Series series(bosses);
  Blend_mesh out;
  const auto run = [&](const Fillet_options& options) {
    out = plate(1, 1);
    const Fillet_outcome outcome = corefine_and_fillet_all(plate(50, 10), series.parts, out, options);
    EXPECT_EQ(outcome.ok(), !out.is_empty());
    return outcome;
  };
  series.parts[2].radius = 35;  // runs off the plate
  const Fillet_outcome off = run(options_of(0));
  EXPECT_EQ(off.diagnosis.detail.rfind("part 3", 0), 0u) << message(off.diagnosis);
  EXPECT_EQ(off.blends.size(), 3u) << "of the steps before, and that of the step";
  EXPECT_TRUE(off.blends[0].diagnosis.ok() && !off.blends[2].diagnosis.ok());
  series.parts[2].radius = -1;
  const Fillet_outcome wrong = run(options_of(0));
  EXPECT_EQ(wrong.diagnosis.status, Status::invalid_parameter);
  EXPECT_EQ(wrong.diagnosis.detail.rfind("part 3: ", 0), 0u) << message(wrong.diagnosis);
  const Blend_mesh far = sphere(1, 1, {900, 0, 0});
  series.parts[2] = {&far, Boolean_operation::union_, 1};
  EXPECT_EQ(message(run(options_of(0)).diagnosis), std::string(describe(Status::operands_disjoint)) + ": part 3");
  series.parts.clear();
  EXPECT_EQ(corefine_and_fillet_all(plate(50, 10), {}, out, options_of(0)).diagnosis.status, Status::invalid_parameter);
}

TEST(Fillet_parts, ProgressRunsThroughAllStepsAndCancels) {
  const Series series(bosses);
  std::vector<double> fractions;
  Fillet_options options = options_of(0);
  options.progress = [&](double fraction) {
    fractions.push_back(fraction);
    return fraction < 0.7;
  };
  Blend_mesh out;
  EXPECT_EQ(corefine_and_fillet_all(plate(50, 10), series.parts, out, options).diagnosis.status, Status::cancelled);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_EQ(fractions.back(), 0.75) << "before the last of four steps";
}

// Refusals: named, located, nothing handed out.

Status refusal_of(const Blend_mesh& a, const Blend_mesh& b, double radius) {
  Blend_mesh out;
  const Fillet_outcome outcome = corefine_and_fillet(a, b, Boolean_operation::union_, out, options_of(radius));
  EXPECT_TRUE(outcome.ok() || out.is_empty());
  return outcome.diagnosis.status;
}

TEST(Fillet, RefusesOperandsThatDoNotCross) {
  EXPECT_EQ(refusal_of(sphere(1, 2), sphere(1, 2, {5, 0, 0}), 0.1), Status::operands_disjoint);
  EXPECT_EQ(refusal_of(sphere(1, 2), sphere(1, 2), 0.1), Status::operands_identical);
  EXPECT_EQ(refusal_of(box({0, 0, 0}, {1, 1, 1}), box({1, 1, 1}, {2, 2, 2}), 0.1), Status::operands_touch);
}

/// Over the edges of the plate the ball rolls on, but not over its corners.
TEST(Fillet, RefusesARadiusThatRunsOffTheFace) {
  Blend_mesh out;
  const Fillet_outcome outcome =
      corefine_and_fillet(plate(50, 10), cylinder(R, 64, -5, 40), Boolean_operation::union_, out, options_of(80));
  ASSERT_FALSE(outcome.ok());
  EXPECT_EQ(outcome.diagnosis.status, Status::radius_exceeds_face);
  EXPECT_TRUE(outcome.diagnosis.point.has_value());
  EXPECT_TRUE(out.is_empty());
}

TEST(Fillet, RefusesToMapOpenBranches) {
  const Blend_mesh cube = box({0, 0, 0}, {10, 10, 10});
  Blend_mesh out;
  std::vector<Edge> all;
  for (const Edge e : cube.edges())
    if (is_crease(e, cube, 45)) all.push_back(e);
  ASSERT_EQ(all.size(), 12u);
  Fillet_options options = options_of(1);
  options.mode = Blend_mode::map;
  EXPECT_EQ(fillet_edges(cube, {{all, 1}}, out, options).diagnosis.status, Status::open_branch);
  EXPECT_EQ(fillet_edges(cube, {{{all[0]}, 1}}, out, options).diagnosis.status, Status::open_branch);
  EXPECT_TRUE(out.is_empty());
}

TEST(Fillet, RefusesWrongNumbers) {
  const Blend_mesh a = sphere(1, 2), b = sphere(1, 2, {1, 0, 0});
  EXPECT_EQ(refusal_of(a, b, -1), Status::invalid_parameter);
  EXPECT_EQ(refusal_of(a, b, std::numeric_limits<double>::quiet_NaN()), Status::invalid_parameter);
  EXPECT_EQ(refusal_of(a, b, std::numeric_limits<double>::infinity()), Status::invalid_parameter);
}

TEST(Fillet, CanBeCancelled) {
  Fillet_options options = options_of(0.1);
  options.progress = [](double) { return false; };
  Blend_mesh out;
  const Blend_mesh a = sphere(1, 2), b = sphere(1, 2, {1, 0, 0});
  EXPECT_EQ(corefine_and_fillet(a, b, Boolean_operation::union_, out, options).diagnosis.status, Status::cancelled);
  EXPECT_TRUE(out.is_empty());
}

TEST(Fillet, KeepGoingLeavesTheRestSharp) {
  // One boss has room for the ball, the other stands in a corner of the plate.
  const Blend_mesh body = plate(50, 10);
  Blend_mesh both;
  const Blend_mesh border_boss = transformed(cylinder(4, 48, -5, 30), placement({0, 0, 1}, 0.1, {45.8, 45.8, 0}));
  ASSERT_TRUE(corefine_and_fillet(body, border_boss, Boolean_operation::union_, both, options_of(0)).ok());
  Blend_mesh all;
  ASSERT_TRUE(corefine_and_fillet(both, cylinder(R, 64, -5, 40), Boolean_operation::union_, all, options_of(0)).ok());
  const std::vector<Edge> feet = creases_at_height(all, 0);
  std::vector<Edge> concave;
  for (const Edge e : feet)
    if (!is_convex_edge(e, all)) concave.push_back(e);
  Fillet_options options = options_of(3);
  Blend_mesh out;
  EXPECT_EQ(fillet_edges(all, {{concave, 3}}, out, options).diagnosis.status, Status::radius_exceeds_face);
  options.keep_going = true;
  const Fillet_outcome outcome = fillet_edges(all, {{concave, 3}}, out, options);
  ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
  EXPECT_TRUE(validate(out).ok());
  EXPECT_NEAR(volume_of(out) - volume_of(all), foot_volume(R, 3), 0.02 * foot_volume(R, 3));
}

TEST(Fillet, SharpUnionOfAlignedGridAndCylinder) {
  // Grid lines run through vertices of the cylinder within rounding: splinters between two edges of almost no length.
  const Blend_mesh block = grid_box({-1, -1, -1}, {1, 1, 1}, 16), pin = cylinder(0.5, 64, -2, 2);
  Blend_mesh out;
  const Fillet_outcome outcome = corefine_and_fillet(block, pin, Boolean_operation::union_, out, options_of(0));
  ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
  EXPECT_TRUE(validate(out).ok());
  EXPECT_NEAR(volume_of(out), 8 + 2 * 32 * 0.25 * std::sin(2 * pi / 64), 1e-12);
}

TEST(Fillet, TouchInAVertexBesidesACurve) {
  const Blend_mesh apart = side_by_side(box({0, 0, 0}, {1, 1, 1}), box({2, 2, 2}, {4, 4, 4}));
  Blend_mesh out;
  const Fillet_outcome outcome =
      corefine_and_fillet(apart, box({1, 1, 1}, {3, 3, 3}), Boolean_operation::union_, out, options_of(0));
  EXPECT_EQ(outcome.diagnosis.status, Status::operands_touch);
  ASSERT_TRUE(outcome.diagnosis.point);
  EXPECT_EQ(*outcome.diagnosis.point, Point_3(1, 1, 1));
}

TEST(Fillet, ShortEdgesOfTheBooleanAwayFromTheBlend) {
  // The boss ends flush with the plate below, where one of its vertices misses the plate's diagonal by a rounding error.
  const Blend_mesh flat = box({-1, -1, -0.25}, {1, 1, 0});
  const Blend_mesh boss = transformed(cylinder(0.25, 64, -0.25, 1), moved_by(0, -0.25, 0));
  const Blended b = blend(flat, boss, Boolean_operation::union_, options_of(0.05));
  ASSERT_TRUE(b.outcome.ok()) << message(b.outcome.diagnosis);
  EXPECT_TRUE(validate(b.mesh).ok());
  EXPECT_NEAR(b.change, foot_volume(0.25, 0.05), 0.02 * foot_volume(0.25, 0.05));
}

}  // namespace
}  // namespace cgal_blend::test
