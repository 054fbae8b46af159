// SPDX-License-Identifier: GPL-3.0-or-later
// The blend as a sequence of profiles: exact ball positions in, closed forms out.
#include "shapes.h"
#include "virtual_surface.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace cgal_blend::test {
namespace {

constexpr double R = 15, r = 5;

/// Balls around an upright cylinder of radius R + r, the left contact below the centre, the right one turned from there
/// towards the axis by an angle that changes from place to place. Base surfaces: the plane z = 0 and the cylinder.
class Ring {
 public:
  explicit Ring(std::size_t n, double least = pi / 2, double most = pi / 2) {
    for (std::size_t i = 0; i < n; ++i) {
      const double around = 2 * pi * static_cast<double>(i) / static_cast<double>(n);
      angles_.push_back(least + (most - least) * (1 - std::cos(around)) / 2);
      const Vec out{std::cos(around), std::sin(around), 0}, down{0, 0, -1};
      Ball_position p;
      p.center = (R + r) * out + Vec{0, 0, r};
      p.radius = r;
      p.contact = {p.center + r * down, p.center + r * (std::cos(angles_[i]) * down - std::sin(angles_[i]) * out)};
      p.foot = {nearest(floor_, p.contact[0]), nearest(pillar_, p.contact[1])};
      positions_.push_back(p);
    }
  }
  [[nodiscard]] Virtual_surface surface(const Profile& profile) const {
    return Virtual_surface(positions_, {&floor_, &pillar_}, profile);
  }
  [[nodiscard]] const Ball_position& position(std::size_t i) const { return positions_[i]; }
  [[nodiscard]] double angle(std::size_t i) const { return angles_[i]; }
  [[nodiscard]] std::size_t widest() const {
    return std::max_element(angles_.begin(), angles_.end()) - angles_.begin();
  }
  [[nodiscard]] std::size_t size() const { return positions_.size(); }

 private:
  static Surface_point nearest(const Base_surface& surface, const Vec& p) {
    Surface_point best;
    double least = std::numeric_limits<double>::max();
    for (const Face f : surface.mesh().faces()) {
      const Surface_point at = surface.locate(f, p);
      const double distance = (surface.position(at) - p).norm();
      if (distance < least) best = at;
      least = std::min(least, distance);
    }
    return best;
  }

  Blend_mesh floor_mesh_ = plate(50, 10), pillar_mesh_ = cylinder(R, 64, -5, 40);
  Base_surface floor_{floor_mesh_, {}}, pillar_{pillar_mesh_, {}};
  std::vector<Ball_position> positions_;
  std::vector<double> angles_;
};

struct Named {
  std::string name;
  Profile profile;
};

const std::vector<Named> profiles{
    {"arc", Arc_profile()},
    {"chamfer", chamfer_profile()},
    {"sharp", sharp_profile()},
    {"conic 0.4", Conic_profile{0.4}},
    {"conic 20", Conic_profile{20}},
    {"Hermite", Hermite_profile()},
    {"G2", G2_profile()},
    {"B-spline", Bspline_profile({{0, 0}, {0.4, 0}, {0.6, 0.5}, {1, 0.6}, {1, 1}})},
    {"polyline", Bspline_profile({{0, 0}, {0.5, 0}, {0.7, 0.2}, {1, 0.6}, {1, 1}}, 1)},
    {"one of seven steps",
     Bspline_profile({{0, 0}, {0.1, 0}, {0.2, 0}, {0.3, 0}, {0.31, 0.05}, {0.9, 0.9}, {1, 0.95}, {1, 1}}, 1)}};

double off_segment(const Vec& a, const Vec& b, const Vec& p) {
  const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - t * (b - a)).norm();
}

/// Largest distance of one profile from its polyline through rows.
double off_rows(const Virtual_surface& surface, std::size_t i, const std::vector<double>& rows) {
  double largest = 0;
  for (std::size_t k = 0; k + 1 < rows.size(); ++k)
    for (int j = 1; j < 100; ++j)
      largest = std::max(largest, off_segment(surface.on_profile(i, rows[k]), surface.on_profile(i, rows[k + 1]),
                                              surface.on_profile(i, rows[k] + (rows[k + 1] - rows[k]) * j / 100)));
  return largest;
}

TEST(Virtual_surface, InterpolatesItsProfilesAndIsRuledBetween) {
  const Ring ring(24, 1, 2);
  for (const auto& [name, profile] : profiles) {
    const Virtual_surface surface = ring.surface(profile);
    ASSERT_EQ(surface.size(), ring.size());
    double start = 0;
    for (std::size_t i = 0; i < surface.size(); ++i) {
      const std::size_t next = (i + 1) % surface.size();
      EXPECT_NEAR(surface.start(i), start, 1e-12 * surface.length());
      start += (ring.position(next).center - ring.position(i).center).norm();
      const auto& contact = ring.position(i).contact;
      EXPECT_LT((surface.on_profile(i, 0) - contact[0]).norm(), 1e-13 * R) << name;
      EXPECT_LT((surface.on_profile(i, 1) - contact[1]).norm(), 1e-13 * R) << name;
      for (const double u : {0.0, 0.21, 0.5, 0.83, 1.0}) {
        const Vec a = surface.on_profile(i, u), b = surface.on_profile(next, u);
        for (const double s : {0.0, 0.25, 0.75})
          for (const double laps : {-1, 0, 2}) {
            const double t = surface.start(i) + s * (surface.start(i + 1) - surface.start(i));
            EXPECT_LT((surface(t + laps * surface.length(), u) - ((1 - s) * a + s * b)).norm(), 1e-12 * R) << name;
          }
      }
    }
    EXPECT_NEAR(surface.length(), start, 1e-12 * start);
  }
}

TEST(Virtual_surface, LiesInThePlaneOfCentreAndContacts) {
  const Ring ring(12, 1, 2);
  for (const auto& [name, profile] : profiles)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const auto& [center, foot, contact, radius, across, fraction, mended] = ring.position(i);
      const Vec normal = (contact[0] - center).cross(contact[1] - center).normalized();
      for (const double u : {0.1, 0.5, 0.8})
        EXPECT_NEAR(normal.dot(ring.surface(profile).on_profile(i, u) - center), 0, 1e-12 * R) << name;
    }
}

TEST(Virtual_surface, ArcIsTheBallAtEvenAngles) {
  const Ring ring(12, 0.6, 2.6);
  const Virtual_surface surface = ring.surface(Arc_profile());
  for (std::size_t i = 0; i < ring.size(); ++i)
    for (const double u : {0.0, 0.125, 0.5, 0.7, 1.0}) {
      const Vec arm = surface.on_profile(i, u) - ring.position(i).center;
      EXPECT_NEAR(arm.norm(), r, 1e-12 * R);
      EXPECT_NEAR(std::acos(std::clamp(arm.z() / -r, -1.0, 1.0)), u * ring.angle(i), 1e-6);
    }
}

TEST(Virtual_surface, ApexIsOnBothTangentPlanes) {
  const Ring ring(12, 0.6, 2.6);
  const Virtual_surface surface = ring.surface(sharp_profile());
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto& [center, foot, contact, radius, across, fraction, mended] = ring.position(i);
    const Vec apex = surface.on_profile(i, 0.5);
    for (const int side : {0, 1}) EXPECT_NEAR((apex - contact[side]).dot(contact[side] - center), 0, 1e-10 * r * r);
  }
}

TEST(Virtual_surface, SpreadsParametersByLength) {
  constexpr int steps = 31;  // corners of profiles, at 1/2, fall into the middle of a step
  const Ring ring(12);
  std::vector<Named> all = profiles;
  all.push_back({"conic that is nearly sharp", Conic_profile{1e6}});
  for (const auto& [name, profile] : all) {
    const Virtual_surface surface = ring.surface(profile);
    std::vector<double> length{0};
    for (int k = 0; k < steps; ++k) {
      double step = 0;
      for (int j = 0; j < 50; ++j)
        step += (surface.on_profile(0, (k + (j + 1) / 50.0) / steps) - surface.on_profile(0, (k + j / 50.0) / steps))
                    .norm();
      length.push_back(step);
    }
    const double longest = *std::max_element(length.begin() + 1, length.end()),
                 shortest = *std::min_element(length.begin() + 1, length.end());
    EXPECT_LT(longest, 1.005 * shortest) << name;
  }
}

TEST(Virtual_surface, KnowsTheLengthOfProfiles) {
  const Ring ring(12, 1, 2);
  const Virtual_surface arc = ring.surface(Arc_profile()), chord = ring.surface(chamfer_profile()),
                        corner = ring.surface(sharp_profile());
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const double angle = ring.angle(i);
    EXPECT_NEAR(arc.profile_length(i), r * angle, 4e-3 * r * angle);  // of a few chords
    EXPECT_NEAR(chord.profile_length(i), 2 * r * std::sin(angle / 2), 1e-9 * r);
    EXPECT_NEAR(corner.profile_length(i), 2 * r * std::tan(angle / 2), 1e-9 * r);
  }
}

TEST(Virtual_surface, RowsOfAnArcAreAsManyAsTheToleranceAsksFor) {
  for (const double angle : {0.3, pi / 2, 2.7}) {
    const Ring ring(12, angle, angle);
    const Virtual_surface surface = ring.surface(Arc_profile());
    for (const double tolerance : {0.1, 2e-3, 1e-5}) {
      const std::vector<double> rows = surface.rows(tolerance);
      const auto facets = static_cast<double>(rows.size() - 1);
      // Of n even chords, in radii; flat arcs have the facets of a quarter circle.
      const auto height = [&](double n) { return 1 - std::cos(std::max(angle, pi / 2) / n / 2); };
      EXPECT_LE(height(facets), tolerance * (1 + 1e-6));
      EXPECT_TRUE(facets == 2 || height(facets - 1) > tolerance) << angle << ' ' << tolerance;
      for (std::size_t k = 0; k < rows.size(); ++k) EXPECT_NEAR(rows[k], static_cast<double>(k) / facets, 1e-15);
    }
  }
}

TEST(Virtual_surface, RowsKeepTheToleranceOfEveryProfile) {
  for (const auto& [least, most] : {std::pair(pi / 2, pi / 2), std::pair(0.5, 2.0), std::pair(1.2, 2.8)}) {
    const Ring ring(16, least, most);
    for (const auto& [name, profile] : profiles) {
      const Virtual_surface surface = ring.surface(profile);
      for (const double tolerance : {0.05, 2e-3, 1e-5}) {
        const std::vector<double> rows = surface.rows(tolerance);
        ASSERT_GE(rows.size(), 3u) << name;
        EXPECT_EQ(rows.front(), 0);
        EXPECT_EQ(rows.back(), 1);
        EXPECT_TRUE(std::adjacent_find(rows.begin(), rows.end(), std::greater_equal<>()) == rows.end()) << name;
        for (std::size_t i = 0; i < ring.size(); ++i)
          EXPECT_LE(off_rows(surface, i, rows), 1.1 * tolerance * r)
              << name << ' ' << tolerance << ", angle " << ring.angle(i) << " of " << least << " to " << most;
        // And there are not many more than needed: where every other one goes, the tolerance does not hold.
        std::vector<double> half;
        for (std::size_t k = 0; k < rows.size(); k += 2) half.push_back(rows[k]);
        if (half.back() != 1) half.push_back(1);
        if (rows.size() > 8 && surface.kinks().empty()) {
          EXPECT_GT(off_rows(surface, ring.widest(), half), tolerance * r) << name << ' ' << tolerance;
        }
      }
    }
  }
}

TEST(Virtual_surface, RowsMeetKinksExactly) {
  const Ring ring(16, 1, 2);
  for (const auto& [name, profile] : profiles) {
    const Virtual_surface surface = ring.surface(profile);
    const std::vector<double> rows = surface.rows(1e-3);
    ASSERT_EQ(surface.kinks().size(), profile.kinks().size()) << name;
    for (std::size_t k = 0; k < surface.kinks().size(); ++k) {
      EXPECT_TRUE(std::find(rows.begin(), rows.end(), surface.kinks()[k]) != rows.end()) << name;
      // The corner itself, by its place on the profile.
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const auto& [center, foot, contact, radius, across, fraction, mended] = ring.position(i);
        const double c = std::cos(ring.angle(i));
        const Vec apex = center + (contact[0] - center + contact[1] - center) / (1 + c);
        const Profile_point p = profile(profile.kinks()[k], {ring.angle(i), {}});
        const Vec corner = p.centre * center + p.contact_1 * contact[0] + p.apex * apex + p.contact_2 * contact[1];
        EXPECT_LT((surface.on_profile(i, surface.kinks()[k]) - corner).norm(), 1e-12 * R) << name;
      }
    }
  }
  // Straight pieces need no rows of their own.
  for (const Conic_profile& profile : {chamfer_profile(), sharp_profile()}) {
    const std::vector<double> rows = ring.surface(profile).rows(1e-6);
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_NEAR(rows[1], 0.5, 1e-14);
  }
}

TEST(Virtual_surface, ManyCloseKinksAllStay) {
  // Corners nearer to each other than the steps by which parameters are spread.
  const double tiny = 1e-4;
  const Profile profile =
      Bspline_profile({{0, 0}, {0.5, 0}, {0.5 + tiny, tiny}, {0.5 + 2 * tiny, 3 * tiny}, {1, 0.5}, {1, 1}}, 1);
  const Ring ring(12);
  const Virtual_surface surface = ring.surface(profile);
  const std::vector<double> rows = surface.rows(1e-5);
  EXPECT_TRUE(std::adjacent_find(rows.begin(), rows.end(), std::greater_equal<>()) == rows.end());
  for (const double kink : profile.kinks()) {
    const Profile_point p = profile(kink, {pi / 2, {}});
    const auto& [center, foot, contact, radius, across, fraction, mended] = ring.position(0);
    const Vec apex = contact[0] + contact[1] - center;
    const Vec corner = p.centre * center + p.contact_1 * contact[0] + p.apex * apex + p.contact_2 * contact[1];
    double nearest = r;
    for (const double row : rows) nearest = std::min(nearest, (surface.on_profile(0, row) - corner).norm());
    EXPECT_LT(nearest, 1e-12 * R) << kink;
  }
}

TEST(Virtual_surface, CornersInOnePlaceMakeOneRow) {
  const Profile profile = Bspline_profile({{0, 0}, {0, 0}, {0.5, 0.3}, {0.5, 0.3}, {1, 1}}, 1);
  const std::vector<double> rows = Ring(12).surface(profile).rows(1e-3);
  EXPECT_EQ(rows.size(), 3u);
  EXPECT_TRUE(std::adjacent_find(rows.begin(), rows.end(), std::greater_equal<>()) == rows.end());
}

TEST(Virtual_surface, EndAnglesAreThoseToTheBaseFaces) {
  const Ring ring(64);  // positions stand on the edges of the pillar, half a facet angle off its faces
  const Virtual_surface chord = ring.surface(chamfer_profile());
  for (std::size_t i = 0; i < ring.size(); i += 7) {
    EXPECT_NEAR(chord.end_angle(i, 0), 45, 1e-6) << "a chord's parameter starts slowly";
    EXPECT_NEAR(chord.end_angle(i, 1), 45, 0.1);
    for (const auto& [name, profile] : profiles) {
      if (name == "chamfer" || name == "polyline" || name == "sharp") continue;
      EXPECT_LT(ring.surface(profile).end_angle(i, 0), 0.02) << name;
      EXPECT_LT(ring.surface(profile).end_angle(i, 1), 0.02) << name;
    }
  }
}

}  // namespace
}  // namespace cgal_blend::test
