// SPDX-License-Identifier: GPL-3.0-or-later
// Radii along a curve, against lines, parabolas and the cosine.
#include <cgal_blend/radius_law.h>

#include "shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace cgal_blend::test {
namespace {

using Pairs = std::vector<Piecewise_radius::Pair>;
constexpr auto smooth = Piecewise_radius::Interpolation::smooth;
constexpr auto linear = Piecewise_radius::Interpolation::linear;

std::vector<double> fractions(int count = 200) {
  std::vector<double> s;
  for (int k = 0; k <= count; ++k) s.push_back(static_cast<double>(k) / count);
  return s;
}

/// One-sided differences of first order.
double slope_after(const Radius_law& law, double s, double h = 1e-6) { return (law(s + h) - law(s)) / h; }
double slope_before(const Radius_law& law, double s, double h = 1e-6) { return (law(s) - law(s - h)) / h; }

/// Steep, flat, and turning; with values at both ends, at one, and at none.
const std::vector<Pairs> lists{{{0, 2}, {0.5, 4}, {1, 2}},
                               {{0, 1}, {0.1, 1.01}, {0.15, 5}, {0.6, 5.2}, {0.7, 0.5}, {1, 1}},
                               {{0, 3}, {0.3, 3}, {0.5, 1}, {0.8, 1}, {1, 3}},
                               {{0, 2}, {0.2, 3}, {0.9, 7}},
                               {{0.1, 2}, {0.2, 3}, {1, 7}},
                               {{0.25, 2}, {0.75, 3}},
                               {{0, 2}, {0.5, 9}},
                               {{0.5, 9}, {1, 2}}};

TEST(Radius_law, IsAConstant) {
  for (const Radius_law& law :
       {Radius_law(2.5), Radius_law(2.5).with_period(), Radius_law(Linear_radius{2.5, 2.5}),
        Radius_law(Piecewise_radius({{0, 2.5}, {0.4, 2.5}})), Radius_law([](double) { return 2.5; })}) {
    EXPECT_TRUE(law.check().ok());
    EXPECT_TRUE(law.is_constant());
    EXPECT_TRUE(law.is_periodic());
    EXPECT_EQ(law.smallest(), 2.5);
    EXPECT_EQ(law.largest(), 2.5);
    for (const double s : fractions()) EXPECT_EQ(law(s), 2.5);
  }
  EXPECT_EQ(Radius_law(3)(0.5), 3) << "whole numbers too";
}

TEST(Radius_law, GrowsLinearly) {
  const Radius_law law = Linear_radius{1, 4};
  for (const double s : fractions()) EXPECT_NEAR(law(s), 1 + 3 * s, 1e-14);
  EXPECT_EQ(law(0), 1);
  EXPECT_EQ(law(1), 4);
  EXPECT_EQ(law(-0.1), 1);
  EXPECT_EQ(law(1.1), 4);
  EXPECT_EQ(law.smallest(), 1);
  EXPECT_EQ(law.largest(), 4);
  EXPECT_FALSE(law.is_constant());
  EXPECT_FALSE(law.is_periodic());
}

TEST(Radius_law, GoesThroughItsValues) {
  for (const Pairs& pairs : lists)
    for (const auto interpolation : {smooth, linear}) {
      const Radius_law law = Piecewise_radius(pairs, interpolation);
      ASSERT_TRUE(law.check().ok());
      for (const auto& [s, radius] : pairs) {
        EXPECT_NEAR(law(s), radius, 1e-14);
        if (law.is_periodic()) {
          EXPECT_NEAR(law.with_period()(s), radius, 1e-14);
        }
      }
      EXPECT_EQ(law(0), pairs.front()[1]) << "held on to the ends";
      EXPECT_EQ(law(1), pairs.back()[1]);
    }
}

TEST(Radius_law, IsMonotoneBetweenItsValuesSoThatTheyAreItsBounds) {
  for (const Pairs& pairs : lists)
    for (const auto interpolation : {smooth, linear}) {
      const Radius_law law = Piecewise_radius(pairs, interpolation);
      for (std::size_t i = 0; i + 1 < pairs.size(); ++i)
        for (const Radius_law& on : {law, law.is_periodic() ? law.with_period() : law}) {
          const double rise = pairs[i + 1][1] - pairs[i][1];
          double last = pairs[i][1];
          for (const double u : fractions()) {
            const double radius = on(std::min((1 - u) * pairs[i][0] + u * pairs[i + 1][0], 1 - 1e-15));
            EXPECT_GE((radius - last) * (rise < 0 ? -1 : 1), -1e-13);
            last = radius;
          }
        }
      const auto below = [](const auto& a, const auto& b) { return a[1] < b[1]; };
      EXPECT_EQ(law.smallest(), (*std::min_element(pairs.begin(), pairs.end(), below))[1]);
      EXPECT_EQ(law.largest(), (*std::max_element(pairs.begin(), pairs.end(), below))[1]);
      for (const double s : fractions(999)) {
        EXPECT_TRUE(law(s) >= law.smallest() && law(s) <= law.largest());
        if (!law.is_periodic()) continue;
        const double round = law.with_period()(s);
        EXPECT_TRUE(round >= law.smallest() && round <= law.largest());
      }
    }
}

TEST(Radius_law, IsSmoothWhereItsPiecesMeet) {
  for (const Pairs& pairs : lists) {
    const Radius_law law = Piecewise_radius(pairs);
    for (const auto& [s, radius] : pairs) {
      const double steepest = 1e4;  // of the second derivative: slopes of the lists over widths of their intervals
      if (s > 0 && s < 1) {
        EXPECT_NEAR(slope_after(law, s), slope_before(law, s), 1e-6 * steepest) << s;
      }
      if (law.is_periodic()) {
        EXPECT_NEAR(slope_after(law.with_period(), s), slope_before(law.with_period(), s), 1e-6 * steepest) << s;
      }
    }
  }
  const Radius_law broken = Piecewise_radius({{0, 2}, {0.5, 4}, {1, 2}}, linear);
  EXPECT_NEAR(slope_before(broken, 0.5), 4, 1e-6) << "the measure itself";
  EXPECT_NEAR(slope_after(broken, 0.5), -4, 1e-6);
}

TEST(Radius_law, IsTheLineOrTheParabolaThatGoesThroughItsValues) {
  const Radius_law line = Piecewise_radius({{0, 1}, {0.2, 1.4}, {0.7, 2.4}, {1, 3}});
  const Radius_law two = Piecewise_radius({{0, 1}, {1, 3}});
  const Radius_law parabola = Piecewise_radius({{0, 2}, {0.5, 4}, {1, 2}});
  const Radius_law half = Piecewise_radius({{0, 1}, {0.3, 1.09}, {0.6, 1.36}, {1, 2}});
  for (const double s : fractions()) {
    EXPECT_NEAR(line(s), 1 + 2 * s, 1e-14);
    EXPECT_NEAR(two(s), 1 + 2 * s, 1e-14);
    EXPECT_NEAR(parabola(s), 2 + 8 * s * (1 - s), 1e-14);
    EXPECT_NEAR(half(s), 1 + s * s, 1e-14);
  }
}

TEST(Radius_law, ConvergesToASmoothFunctionOnAClosedCurve) {
  const auto wave = [](double s) { return 3 + std::cos(2 * pi * (s - 0.05)); };
  const auto error = [&](int count) {
    Pairs pairs;
    for (int k = 0; k < count; ++k) pairs.push_back({(k + 0.5) / count, wave((k + 0.5) / count)});
    const Radius_law law = Radius_law(Piecewise_radius(pairs)).with_period();
    double worst = 0;
    for (const double s : fractions(1000)) worst = std::max(worst, std::abs(law(s) - wave(s)));
    return worst;
  };
  EXPECT_LT(error(40), 0.02);
  EXPECT_GT(std::log2(error(40) / error(80)), 1.8) << "of second order where it turns, of third elsewhere";
}

TEST(Radius_law, GoesRoundAClosedCurve) {
  for (const Pairs& pairs : lists) {
    const Radius_law law = Piecewise_radius(pairs);
    const bool differs = pairs.front()[0] == 0 && pairs.back()[0] == 1 && pairs.front()[1] != pairs.back()[1];
    ASSERT_EQ(law.is_periodic(), !differs);
    if (differs) continue;
    const Radius_law round = law.with_period();
    EXPECT_NEAR(round(0), round(1), 1e-14);
    EXPECT_NEAR(slope_after(round, 0), slope_before(round, 1), 0.01);
    for (const double s : fractions())
      for (const double turns : {-2, -1, 1, 5}) EXPECT_NEAR(round(s + turns), round(s), 1e-11);
  }
  // Between the last value and the first the place of s = 0 is nothing special.
  const Radius_law law = Radius_law(Piecewise_radius({{0.25, 2}, {0.75, 3}}, linear)).with_period();
  EXPECT_NEAR(law(0), 2.5, 1e-14);
  EXPECT_NEAR(law(0.9), 2.7, 1e-14);
  EXPECT_NEAR(law(0.1), 2.3, 1e-14);
  // A value at one end is that of the other.
  for (const Pairs& pairs : {Pairs{{0, 2}, {0.5, 4}}, Pairs{{0.5, 4}, {1, 2}}, Pairs{{0, 2}, {0.5, 4}, {1, 2}}}) {
    const Radius_law round = Radius_law(Piecewise_radius(pairs)).with_period();
    for (const double s : fractions()) {
      EXPECT_NEAR(round(s), round(1 - s), 1e-13);
      EXPECT_NEAR(round(s), 3 - std::cos(2 * pi * s), 0.03);
    }
  }
}

TEST(Radius_law, KnowsWhetherItCanGoRound) {
  EXPECT_TRUE(Radius_law(1.0).is_periodic());
  EXPECT_TRUE(Radius_law([](double s) { return 2 + std::sin(2 * pi * s); }).is_periodic());
  EXPECT_FALSE(Radius_law([](double s) { return 2 + std::sin(s); }).is_periodic());
  EXPECT_FALSE(Radius_law(Piecewise_radius({{0, 2}, {0.5, 4}, {1, 2.1}})).is_periodic());
}

TEST(Radius_law, IsScaledReversedAndShifted) {
  std::vector<Radius_law> laws{Linear_radius{1, 4}, [](double s) { return 2 + std::sin(2 * pi * s); }};
  for (const Pairs& pairs : lists) laws.emplace_back(Piecewise_radius(pairs));
  for (const Radius_law& law : laws) {
    const Radius_law half = law.scaled(0.5), third = half.scaled(2.0 / 3);
    EXPECT_EQ(half.smallest(), 0.5 * law.smallest());
    EXPECT_NEAR(third.largest(), law.largest() / 3, 1e-15 * law.largest());
    EXPECT_EQ(half.is_constant(), law.is_constant());
    for (const double s : fractions()) {
      EXPECT_EQ(half(s), 0.5 * law(s));
      EXPECT_NEAR(law.reversed()(s), law(1 - s), 1e-13);
      EXPECT_NEAR(law.reversed().reversed()(s), law(s), 1e-13);
      EXPECT_NEAR(law.scaled(2).reversed()(s), 2 * law(1 - s), 1e-13);
      if (!law.is_periodic()) continue;
      const Radius_law round = law.with_period(), on = round.shifted(0.3);
      EXPECT_NEAR(law.reversed().with_period()(s), round(1 - s), 1e-11);
      EXPECT_NEAR(on(s), round(s + 0.3), 1e-11);
      EXPECT_NEAR(on.shifted(-0.5)(s), round(s - 0.2), 1e-11);
      EXPECT_NEAR(on.reversed()(s), round(0.3 - s), 1e-11) << "law of the curve, not of the place";
      EXPECT_NEAR(round.reversed().shifted(0.3)(s), round(-s - 0.3), 1e-11);
    }
  }
}

TEST(Radius_law, IsRestrictedToAPartOfTheCurve) {
  const Radius_law law = Radius_law(Linear_radius{1, 3}).scaled(10).restricted(0.25, 0.75);
  EXPECT_EQ(law.smallest(), 15);
  EXPECT_EQ(law.largest(), 25);
  EXPECT_FALSE(law.is_periodic());
  for (const double s : fractions()) {
    EXPECT_NEAR(law(s), 15 + 10 * s, 1e-13);
    EXPECT_NEAR(law.reversed()(s), 25 - 10 * s, 1e-13);
    EXPECT_NEAR(law.restricted(0.5, 0)(s), 20 - 5 * s, 1e-13);
  }
  EXPECT_EQ(law(1.5), 25) << "held on to its own ends";
  const Radius_law round = Radius_law(Piecewise_radius({{0, 1}, {0.25, 1.5}, {0.5, 3}})).with_period();
  for (const double s : fractions()) {
    EXPECT_NEAR(round.restricted(0.75, 1.25)(s), round(0.75 + s / 2), 1e-12);
    EXPECT_NEAR(round.restricted(0.25, -0.25)(s), round(0.25 - s / 2), 1e-12);
    EXPECT_NEAR(round.shifted(0.1).reversed().restricted(0.5, 1)(s), round(0.6 - s / 2), 1e-12);
  }
  EXPECT_TRUE(Radius_law(Piecewise_radius({{0, 2}, {0.5, 2}, {1, 3}})).restricted(0, 0.5).is_constant());
}

TEST(Radius_law, TakesAnyFunction) {
  const Radius_law law = [](double s) { return 2 + std::cos(4 * pi * s); };
  EXPECT_TRUE(law.check().ok());
  EXPECT_NEAR(law.smallest(), 1, 1e-4);
  EXPECT_NEAR(law.largest(), 3, 1e-4);
  EXPECT_FALSE(law.is_constant());
  EXPECT_NEAR(law(0.125), 2, 1e-14);
}

/// A user's own with all that is optional.
struct Bulge {
  double height;
  double operator()(double s) const { return 1 + height * 4 * s * (1 - s); }
  [[nodiscard]] std::array<double, 2> bounds() const { return {1, 1 + height}; }
  [[nodiscard]] Diagnosis check() const {
    if (height >= 0) return {};
    return {Status::invalid_parameter, "the bulge must not be a dent", {}, {}};
  }
};

TEST(Radius_law, AsksTheModelWhatItKnows) {
  EXPECT_EQ(Radius_law(Bulge{0.7}).largest(), 1.7);
  EXPECT_TRUE(Radius_law(Bulge{0.7}).check().ok());
  EXPECT_EQ(Radius_law(Bulge{-0.5}).check().detail, "the bulge must not be a dent");
}

void expect_refused(const Radius_law& law, const std::string& word) {
  const Diagnosis diagnosis = law.check();
  EXPECT_EQ(diagnosis.status, Status::invalid_parameter) << word;
  EXPECT_NE(diagnosis.detail.find(word), std::string::npos) << diagnosis.detail;
}

TEST(Radius_law, RefusesWhatMakesNone) {
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -1.0, nan, infinity}) {
    expect_refused(bad, "greater than 0");
    expect_refused(Linear_radius{1, bad}, "greater than 0");
    expect_refused(Linear_radius{bad, 1}, "greater than 0");
    expect_refused(Piecewise_radius({{0, 1}, {0.5, bad}, {1, 1}}), "greater than 0");
    expect_refused([bad](double s) { return s == 0.5 ? bad : 1; }, "greater than 0");
  }
  expect_refused(Piecewise_radius({}), "two pairs");
  expect_refused(Piecewise_radius({{0, 1}}), "two pairs");
  expect_refused(Piecewise_radius({{-0.1, 1}, {1, 1}}), "between 0 and 1");
  expect_refused(Piecewise_radius({{0, 1}, {1.1, 1}}), "between 0 and 1");
  expect_refused(Piecewise_radius({{0, 1}, {nan, 2}}), "between 0 and 1");
  expect_refused(Piecewise_radius({{0.5, 1}, {0.2, 2}}), "ascend");
  expect_refused(Piecewise_radius({{0.5, 1}, {0.5, 2}}), "ascend");
  EXPECT_TRUE(std::isnan(Radius_law(Piecewise_radius({}))(0.5))) << "no law, but no crash";
}

}  // namespace
}  // namespace cgal_blend::test
