// SPDX-License-Identifier: GPL-3.0-or-later
// The implicit transition against the closed form of coaxial cones, at its planes and between.
#include "hermite_transition.h"
#include "openings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

namespace cgal_blend::test {
namespace {

const Circle low{1, 0, 0, 512, 0.3}, high{0.6, 0, 0, 512, -0.2};

Hermite_transition transition(const Transition_options& options = {}, double height = 1.5) {
  return {{sections_of({low}), sections_of({high})}, height, options};
}

TEST(Hermite_transition, coaxial_cones_follow_the_closed_form) {
  for (const double height : {0.1, 1.5, 7.0}) {
    const Hermite_transition psi = transition({}, height);
    for (double w = 0; w <= 1; w += 0.05)
      for (const double r : {0.8, 1.1, 1.4})
        EXPECT_NEAR(psi({r * std::cos(1), r * std::sin(1), w * height}), r - hermite_radius(low, high, height, w),
                    1e-4 * (1 + height));
  }
}

TEST(Hermite_transition, vanishes_on_its_rings) {
  for (const Opening_model& model : {distance_opening(), rbf_opening()}) {
    const Hermite_transition psi({sections_of({{1, 0.3, 0}}), sections_of({{0.5, 0, 0.7}, {0.4, 0, -0.7}})}, 2,
                                 {model});
    const double edge = 2 * pi / 64;
    for (const std::size_t side : {0, 1})
      for (const Ring& ring : psi.rings(side))
        for (const Point_2& p : ring) EXPECT_NEAR(psi({p.x(), p.y(), side == 0 ? 0.0 : 2.0}), 0, 0.01 * edge);
  }
}

TEST(Hermite_transition, is_tangent_to_the_kept_sides_whatever_the_height) {
  for (const double height : {0.2, 1.0, 5.0}) {
    const Hermite_transition psi = transition({}, height);
    const double step = 1e-6 * height;
    EXPECT_NEAR((psi({1, 0, step}) - psi({1, 0, 0})) / step, -low.slope, 1e-3);
    EXPECT_NEAR((psi({0.6, 0, height}) - psi({0.6, 0, height - step})) / step, -high.slope, 1e-3);
  }
}

/// de Casteljau's construction, whose abscissae are equidistant.
double eta(double a, double b, double t) {
  std::vector<double> c{0, 0.2, a, b, 0.8, 1};
  for (; c.size() > 1; c.pop_back())
    for (std::size_t i = 0; i + 1 < c.size(); ++i) c[i] = (1 - t) * c[i] + t * c[i + 1];
  return c.front();
}

TEST(Hermite_transition, eta_bends_the_height) {
  for (const auto& [a, b] : {std::pair(0.4, 0.6), std::pair(0.1, 0.3), std::pair(0.7, 0.9), std::pair(0.0, 1.0)}) {
    Transition_options options;
    options.eta = {a, b};
    const Hermite_transition psi = transition(options);
    for (double t = 0; t <= 1; t += 0.1)
      EXPECT_NEAR(psi({1.2, 0, t * 1.5}), 1.2 - hermite_radius(low, high, 1.5, eta(a, b, t)), 1e-3);
    const double step = 1e-6;
    EXPECT_NEAR((psi({1, 0, step}) - psi({1, 0, 0})) / step, -low.slope, 1e-3);  // slope 1 at the ends, always
  }
}

TEST(Hermite_transition, one_sided_slopes) {
  const auto slope_at_ring = [](const Hermite_transition& psi, std::size_t side) {
    const double step = 1e-6;
    return side == 0 ? (psi({1, 0, step}) - psi({1, 0, 0})) / step : (psi({1, 0, 1}) - psi({1, 0, 1 - step})) / step;
  };
  // A wall that bends at the plane: slope 0.4 below, 0.1 above.
  const auto bent = [] {
    Opening_sections s = sections_of({{1, 0, 0, 512, 0.4}});
    s.above = std::vector<Ring>{ring_of({1, 0, 0, 512, 0.1}, 0.02)};
    return s;
  };
  struct Case {
    Opening_sections side;
    std::size_t kept;
    double slope;
    bool one_sided;
  };
  std::vector<Case> cases;
  cases.push_back({bent(), 0, 0.25, false});
  Opening_sections s = bent();
  s.above.reset();
  cases.push_back({s, 0, 0.4, true});
  cases.push_back({s, 1, 0.4, true});  // all there is
  s = bent();
  s.below = std::vector<Ring>{};
  cases.push_back({s, 0, 0.1, true});
  s = bent();
  s.above->push_back(ring_of({0.5, 9, 9}));
  cases.push_back({s, 0, 0.4, true});
  cases.push_back({s, 1, 0.4, true});  // the kept section has another ring, the other has not
  s = bent();
  s.below->push_back(ring_of({0.5, 9, 9}));
  cases.push_back({s, 1, 0.1, true});
  s = bent();
  s.below.reset();
  s.above.reset();
  cases.push_back({s, 0, 0, true});
  for (const Case& c : cases) {
    std::array<Opening_sections, 2> sides{sections_of({{1, 0, 0, 512}}), sections_of({{1, 0, 0, 512}})};
    sides[c.kept] = c.side;
    const Hermite_transition psi(sides, 1, {});
    EXPECT_NEAR(slope_at_ring(psi, c.kept), -c.slope, 1e-3) << &c - cases.data();
    EXPECT_EQ(psi.one_sided(c.kept), c.one_sided) << &c - cases.data();
    EXPECT_FALSE(psi.one_sided(1 - c.kept));
  }
}

}  // namespace
}  // namespace cgal_blend::test
