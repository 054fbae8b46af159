// SPDX-License-Identifier: GPL-3.0-or-later
// Blends with other cross-sections than the arc, and the sampling of the ball's way, against closed forms.
#include "blends.h"

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace cgal_blend::test {
namespace {

constexpr double R = 15, r = 5;
constexpr int sides = 128;
constexpr double facet_height = R * 3e-4;  // of a side of the pillar, 1 - cos(pi / 128)

Blended foot(const Profile& profile, double chord_tolerance, double scale = 1) {
  Fillet_options options = options_of(r * scale, chord_tolerance);
  options.profile = profile;
  const Placement grow = placement({0, 0, 1}, 0, {0, 0, 0}, scale);
  return blend(transformed(plate(50, 10), grow), transformed(cylinder(R, sides, -5, 40), grow),
               Boolean_operation::union_, options);
}

/// Volume of a ring with the given section area and distance of its centroid from the axis (Pappus).
double ring_volume(double area, double centroid) { return 2 * pi * centroid * area; }

/// A point of the blend at the foot of the pillar: its height over the plate and its distance from the pillar's surface.
struct In_section {
  double along, height;
};
In_section in_section(const Point_3& p) { return {std::hypot(p.x(), p.y()) - R, p.z()}; }

TEST(Fillet_profiles, ChamferIsACone) {
  const Blended b = foot(chamfer_profile(), 1e-3);
  ASSERT_TRUE(b.outcome.ok());
  const double off = largest(blend_points(b.mesh, b.outcome), [](const Point_3& p) {
    const auto [along, height] = in_section(p);
    return (along + height - r) / std::sqrt(2);
  });
  EXPECT_LT(off, 2 * facet_height);
  const double volume = ring_volume(r * r / 2, R + r / 3);
  EXPECT_NEAR(b.change, volume, 5e-3 * volume);
  EXPECT_NEAR(b.outcome.blends.at(0).tangency_deg, 45, 1);
  EXPECT_NEAR(area_of(b.mesh, b.outcome.blend_faces), ring_volume(r * std::sqrt(2.0), R + r / 2),
              5e-3 * 2 * pi * R * r);
}

TEST(Fillet_profiles, SharpChangesNothing) {
  const Blended b = foot(sharp_profile(), 2e-3);
  ASSERT_TRUE(b.outcome.ok());
  EXPECT_LT(std::abs(b.change), 0.01 * r * r * 2 * pi * R);
  // All that is new lies on the plate or on the pillar.
  EXPECT_LT(largest(blend_points(b.mesh, b.outcome),
                    [](const Point_3& p) {
                      const auto [along, height] = in_section(p);
                      return std::min(std::abs(along), std::abs(height));
                    }),
            2 * facet_height);
}

TEST(Fillet_profiles, ConicsAndHermiteAreWhatTheyAreInThePlane) {
  // Points of a conic with weight w between (r, 0) and (0, r), corner (0, 0): 4 w^2 x y = (r - x - y)^2.
  for (const double weight : {0.3, std::sqrt(0.5), 3.0}) {
    const Blended b = foot(Conic_profile{weight}, 5e-4);
    ASSERT_TRUE(b.outcome.ok());
    const double off = largest(blend_points(b.mesh, b.outcome), [&](const Point_3& p) {
      const auto [x, y] = in_section(p);
      const double value = 4 * weight * weight * x * y - (r - x - y) * (r - x - y);
      const double d = 2 * (r - x - y);
      return value / std::hypot(4 * weight * weight * y + d, 4 * weight * weight * x + d);  // distance to first order
    });
    EXPECT_LT(off, 3 * facet_height) << weight;
    EXPECT_LT(b.outcome.blends.at(0).tangency_deg, 0.1) << weight;
  }
  const Blended b = foot(Hermite_profile{1.657, 1.657}, 5e-4);  // nearly the arc
  ASSERT_TRUE(b.outcome.ok());
  EXPECT_LT(largest(blend_points(b.mesh, b.outcome),
                    [](const Point_3& p) {
                      return distance_to_torus(p, {0, 0, r}, {0, 0, 1}, R + r, r);
                    }),
            4e-4 * r + 2 * facet_height);
}

TEST(Fillet_profiles, EachIsValidAndBetweenChordAndCorner) {
  const double most = ring_volume(r * r / 2, R + r / 3);  // the chamfer's
  double last = most * 1.005;
  for (const Profile& profile : std::vector<Profile>{chamfer_profile(), Conic_profile{0.3}, Arc_profile(), G2_profile(),
                                                     Conic_profile{3}, sharp_profile()}) {
    const Blended b = foot(profile, 2e-3);
    ASSERT_TRUE(b.outcome.ok());
    EXPECT_LT(b.change, last);
    last = b.change;
    // Points on the body's own surfaces count as between.
    for (const Point_3& p : blend_points(b.mesh, b.outcome)) {
      const auto [along, height] = in_section(p);
      EXPECT_TRUE(along > -2 * facet_height && height > -1e-9 && along + height < r + 2 * facet_height) << p;
    }
  }
  const Profile hump = Bspline_profile({{0, 0}, {0.3, 0}, {0.6, 0.2}, {0.8, 0.4}, {1, 0.7}, {1, 1}});
  EXPECT_TRUE(foot(hump, 2e-3).outcome.ok());
  EXPECT_TRUE(foot(Bspline_profile({{0, 0}, {0.5, 0}, {0.6, 0.4}, {1, 0.5}, {1, 1}}, 1), 2e-3).outcome.ok());
}

/// Heights of a profile over the plate, by distance from its end there: the points of the mesh in one half-plane.
std::vector<In_section> profile_from_the_plate(const Blended& b) {
  std::vector<std::pair<double, Point_3>> by_azimuth;
  for (const Point_3& p : blend_points(b.mesh, b.outcome))
    if (p.z() > 1e-9) by_azimuth.emplace_back(std::atan2(p.y(), p.x()), p);
  std::sort(by_azimuth.begin(), by_azimuth.end());
  // The longest run of one azimuth is a profile.
  std::size_t first = 0, best = 0, size = 0;
  for (std::size_t i = 1; i <= by_azimuth.size(); ++i) {
    if (i < by_azimuth.size() && by_azimuth[i].first - by_azimuth[i - 1].first < 1e-5) continue;
    if (i - first > size) {
      best = first;
      size = i - first;
    }
    first = i;
  }
  const double azimuth = by_azimuth[best + size / 2].first;
  double end = 0;
  for (const Point_3& p : blend_points(b.mesh, b.outcome))
    if (p.z() <= 1e-9 && std::abs(std::atan2(p.y(), p.x()) - azimuth) < 1e-4)
      end = std::max(end, std::hypot(p.x(), p.y()));
  std::vector<In_section> points;
  for (std::size_t i = best; i < best + size; ++i)
    points.push_back({end - std::hypot(by_azimuth[i].second.x(), by_azimuth[i].second.y()), by_azimuth[i].second.z()});
  std::sort(points.begin(), points.end(), [](const In_section& p, const In_section& q) { return p.along < q.along; });
  return points;
}

/// Curvature at the plate times the radius: twice the height over the square of the distance, extrapolated to the end.
double end_curvature(const std::vector<In_section>& points) {
  const auto at = [&](std::size_t i) { return 2 * r * points[i].height / (points[i].along * points[i].along); };
  const double s = points[0].along, t = points[1].along;
  return (t * at(0) - s * at(1)) / (t - s);
}

TEST(Fillet_profiles, G2HasNoCurvatureWhereItLeavesThePlate) {
  const auto arc = profile_from_the_plate(foot(Arc_profile(), 1e-4)),
             smooth = profile_from_the_plate(foot(G2_profile(), 1e-4));
  ASSERT_GE(arc.size(), 10u);
  ASSERT_GE(smooth.size(), 10u);
  EXPECT_NEAR(end_curvature(arc), 1, 0.05) << "the measure itself";
  EXPECT_LT(std::abs(end_curvature(smooth)), 0.05);
}

/// A ball in a plane corner with a sphere, whose curvature a G2 profile continues.
TEST(Fillet_profiles, G2ContinuesTheCurvatureOfASphere) {
  const double big = 20;
  for (const auto& [profile, expected] :
       {std::pair<Profile, double>(Arc_profile(), 1), std::pair<Profile, double>(G2_profile(), -r / big)}) {
    Fillet_options options = options_of(r, 1e-4);
    options.profile = profile;
    const Blended b = blend(plate(50, 10), sphere(big, 5, {0.01, 0.02, 5}), Boolean_operation::union_, options);
    ASSERT_TRUE(b.outcome.ok());
    // In the half-plane of a profile, from the contact on the sphere: the polar angle about the sphere's centre, and how
    // far above the sphere the profile runs. A height h over an arc s means 2 h / s^2 more curvature than the sphere's.
    const Point_3 centre(0.01, 0.02, 5);
    const double spine_height = r - 5;  // over the sphere's centre
    const double contact = std::asin(spine_height / (big + r));
    std::vector<In_section> points;
    for (const Point_3& p : blend_points(b.mesh, b.outcome)) {
      const double rho = std::hypot(p.x() - centre.x(), p.y() - centre.y()), z = p.z() - centre.z();
      points.push_back({big * (contact - std::atan2(z, rho)), std::hypot(rho, z) - big});
    }
    // h = a s^2 + b s^3 + c s^4 near the contact, by least squares.
    Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
    Eigen::Vector3d sums = Eigen::Vector3d::Zero();
    for (const auto& [s, h] : points) {
      if (s < 0.05 * r || s > 0.5 * r) continue;
      const Eigen::Vector3d powers{s * s, s * s * s, s * s * s * s};
      products += powers * powers.transpose();
      sums += h * powers;
    }
    const double curvature = 2 * r * products.ldlt().solve(sums)[0] - r / big;
    EXPECT_NEAR(curvature, expected, 0.1);
  }
}

TEST(Fillet_profiles, FollowScale) {
  for (const Profile& profile : std::vector<Profile>{chamfer_profile(), G2_profile(), Conic_profile{2}}) {
    const double change = foot(profile, 2e-3).change;
    for (const double scale : {1e-3, 1e6})
      EXPECT_NEAR(foot(profile, 2e-3, scale).change / std::pow(scale, 3), change, 1e-3 * change) << scale;
  }
}

TEST(Fillet_profiles, EachCurveMayHaveItsOwn) {
  Blend_mesh sharp;
  ASSERT_TRUE(unchecked::corefine_and_fillet(plate(50, 10), cylinder(R, sides, -20, 40), Boolean_operation::union_,
                                             sharp, options_of(0))
                  .ok());
  const std::vector<Edge_blend> blends{{creases_at_height(sharp, 0), 3, chamfer_profile()},
                                       {creases_at_height(sharp, 40), 2, Arc_profile()}};
  // The plate's own border is no crease at these heights.
  std::vector<Edge> foot_edges;
  for (const Edge e : blends[0].edges)
    if (!is_convex_edge(e, sharp)) foot_edges.push_back(e);
  Blend_mesh out;
  const Fillet_outcome outcome =
      unchecked::fillet_edges(sharp, {{foot_edges, 3, chamfer_profile()}, blends[1]}, out, options_of(1));
  ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
  EXPECT_TRUE(validate(out).ok());
  const double expected = ring_volume(4.5, R + 1) - rim_volume(R, 2);
  EXPECT_NEAR(volume_of(out) - volume_of(sharp), expected, 0.01 * ring_volume(4.5, R + 1));
}

// How finely the ball's way is sampled. A chamfer has one row between its rims: one vertex per ball position.

std::vector<Point_3> middles(const Blended& b) {
  std::vector<Point_3> points;
  for (const Point_3& p : blend_points(b.mesh, b.outcome))
    if (std::abs(p.z() - r / 2) < 0.05 * r) points.push_back(p);
  std::sort(points.begin(), points.end(),
            [](const Point_3& p, const Point_3& q) { return std::atan2(p.y(), p.x()) < std::atan2(q.y(), q.x()); });
  return points;
}

double step(const std::vector<Point_3>& points, std::size_t i) {
  return std::sqrt(CGAL::squared_distance(points[i], points[(i + 1) % points.size()]));
}

TEST(Fillet_sampling, SamplesAreSpreadByArcLength) {
  for (const std::size_t samples : {40, 100}) {
    Fillet_options options = options_of(r);
    options.profile = chamfer_profile();
    options.samples = samples;
    const Blended b = blend(plate(50, 10), cylinder(R, sides, -5, 40), Boolean_operation::union_, options);
    ASSERT_TRUE(b.outcome.ok());
    const std::vector<Point_3> points = middles(b);
    EXPECT_NEAR(static_cast<double>(points.size()), static_cast<double>(samples), 0.2 * static_cast<double>(samples));
    const double mean = 2 * pi * (R + r / 2) / static_cast<double>(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_NEAR(step(points, i), mean, 0.5 * mean) << points[i];
  }
}

TEST(Fillet_sampling, SamplesAreSpreadOverTheSpineHoweverShortTheCurve) {
  // The ball's way is six times as long as the curve that it blends.
  const double small = 1;
  Fillet_options options = options_of(r);
  options.profile = chamfer_profile();
  options.samples = 40;
  const Blended b = blend(plate(50, 10), cylinder(small, sides, -5, 40), Boolean_operation::union_, options);
  ASSERT_TRUE(b.outcome.ok());
  const std::vector<Point_3> points = middles(b);
  EXPECT_NEAR(static_cast<double>(points.size()), 40, 8);
}

constexpr double half_length = 24, half_width = 10;  // of an elliptic pillar

Blend_mesh elliptic_pillar() {
  std::vector<std::pair<double, double>> outline;
  for (int i = 0; i < 400; ++i)
    outline.emplace_back(half_length * std::cos(2 * pi * (i + 0.5) / 400),
                         half_width * std::sin(2 * pi * (i + 0.5) / 400));
  return prism(outline, -5, 30);
}

/// Point of the curve at a distance outside the ellipse.
Point_3 beside_ellipse(double t, double distance, double z) {
  const double nx = half_width * std::cos(t), ny = half_length * std::sin(t), n = std::hypot(nx, ny);
  return {half_length * std::cos(t) + distance * nx / n, half_width * std::sin(t) + distance * ny / n, z};
}

struct Sampled {
  std::vector<Point_3> points;  // in the middles of the profiles
  double deviation = 0;         // of their polyline from the exact curve
  double longest_at_ends = 0, longest_at_sides = 0;
};

Sampled sample_ellipse(std::size_t samples, double chord_ratio) {
  Fillet_options options = options_of(r);
  options.profile = chamfer_profile();
  options.samples = samples;
  options.chord_ratio = chord_ratio;
  const Blended b = blend(plate(50, 10), elliptic_pillar(), Boolean_operation::union_, options);
  EXPECT_TRUE(b.outcome.ok());
  Sampled sampled;
  sampled.points = middles(b);
  const std::size_t n = sampled.points.size();
  for (int k = 0; k < 2000; ++k) {
    const Point_3 p = beside_ellipse(2 * pi * k / 2000, r / 2, r / 2);
    double nearest = 1e9;
    for (std::size_t i = 0; i < n; ++i)
      nearest = std::min(nearest,
                         CGAL::squared_distance(p, Kernel::Segment_3(sampled.points[i], sampled.points[(i + 1) % n])));
    sampled.deviation = std::max(sampled.deviation, std::sqrt(nearest));
  }
  for (std::size_t i = 0; i < n; ++i) {
    const double x = std::abs(sampled.points[i].x());
    if (x > 0.95 * (half_length + r / 2))
      sampled.longest_at_ends = std::max(sampled.longest_at_ends, step(sampled.points, i));
    if (x < 0.5 * half_length) sampled.longest_at_sides = std::max(sampled.longest_at_sides, step(sampled.points, i));
  }
  return sampled;
}

TEST(Fillet_sampling, ChordRatioDividesWhereTheSpineTurns) {
  const Sampled plain = sample_ellipse(20, 0), coarse = sample_ellipse(20, 0.05), fine = sample_ellipse(20, 0.015);
  EXPECT_LT(plain.points.size(), coarse.points.size() + 1);
  EXPECT_LT(coarse.points.size(), fine.points.size());
  EXPECT_LT(fine.longest_at_ends, 0.7 * fine.longest_at_sides);
  EXPECT_LT(fine.longest_at_ends, 0.7 * plain.longest_at_ends);
  EXPECT_LT(coarse.deviation, 0.8 * plain.deviation);
  EXPECT_LT(fine.deviation, 0.5 * coarse.deviation);
}

TEST(Fillet_sampling, ToleranceHoldsWithoutSamples) {
  Fillet_options options = options_of(r, 2e-3);
  const Sampled sampled = sample_ellipse(0, 0);
  EXPECT_LT(sampled.deviation, 2 * options.chord_tolerance * r);
}

}  // namespace
}  // namespace cgal_blend::test
