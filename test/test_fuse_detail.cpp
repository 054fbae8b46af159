// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks.h"
#include "fusion_checks.h"
#include "fusions.h"
#include "plane_cut.h"
#include "shapes.h"

#include <cgal_blend/fuse.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

// The detail of both ends fades into the transition, figure 7 of Jin et al.: fluted columns.

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;

struct Flutes {
  double radius, amplitude;
  int order;
};

/// A column with the section rho(theta) = radius + amplitude cos(order theta), of n sides.
Blend_mesh column(const Flutes& flutes, int n, double z0, double z1, int levels) {
  Blend_mesh mesh = frustum(1, 1, n, z0, z1, levels);
  for (const Vertex v : mesh.vertices()) {
    Point_3& p = mesh.point(v);
    const double r = std::hypot(p.x(), p.y());
    const double rho = flutes.radius + flutes.amplitude * std::cos(flutes.order * std::atan2(p.y(), p.x()));
    if (r > 0) p = Point_3(p.x() * rho, p.y() * rho, p.z());
  }
  return mesh;
}

/// The amplitude of one harmonic of the section at a height: the integral of rho cos(order theta), by the trapezoidal rule.
double amplitude(const Blend_mesh& mesh, double z, int order) {
  const auto loops = section(mesh, {{0, 0, z}, {0, 0, 1}});
  EXPECT_EQ(loops.size(), 1u);
  double sum = 0;
  for (std::size_t i = 0; i < loops.front().size(); ++i) {
    const Point_3 &p = loops.front()[i], &q = loops.front()[(i + 1) % loops.front().size()];
    const auto value = [&](const Point_3& a) {
      return std::hypot(a.x(), a.y()) * std::cos(order * std::atan2(a.y(), a.x()));
    };
    const double turn = std::atan2(p.x() * q.y() - p.y() * q.x(), p.x() * q.x() + p.y() * q.y());
    sum += (value(p) + value(q)) / 2 * turn;
  }
  return sum / pi;
}

TEST(Fuse, lets_the_detail_of_both_ends_fade) {
  const Flutes lower{1, 0.06, 8}, upper{0.8, 0.06, 5};
  const double height = 1.5;
  const Blend_mesh low = column(lower, 160, -1.1, 0.4, 5), high = column(upper, 120, height - 0.4, height + 1.1, 5);
  Blend_mesh out;
  const Fuse_outcome outcome = unchecked::fuse({{&low}, lower_plane}, {{&high}, upper_plane(height)}, out);
  expect_valid(outcome, out);
  EXPECT_NEAR(amplitude(out, -0.1, lower.order), lower.amplitude, 0.01 * lower.amplitude);
  EXPECT_NEAR(amplitude(out, height + 0.1, upper.order), upper.amplitude, 0.01 * upper.amplitude);
  constexpr int steps = 15;
  double last_low = 1.01 * lower.amplitude, last_high = 1.01 * upper.amplitude;
  for (int k = 1; k < steps; ++k) {
    // Where flutes are shallow, distances are rho - r to first order, and amplitudes those of the Hermite functional.
    const double w = static_cast<double>(k) / steps, f1 = (w - 1) * (w - 1) * (1 + 2 * w);
    const double from_low = amplitude(out, w * height, lower.order),
                 from_high = amplitude(out, (1 - w) * height, upper.order);
    EXPECT_LT(from_low, last_low) << w;
    EXPECT_LT(from_high, last_high) << w;
    EXPECT_NEAR(from_low, f1 * lower.amplitude, 0.15 * lower.amplitude) << w;
    EXPECT_NEAR(from_high, f1 * upper.amplitude, 0.15 * upper.amplitude) << w;
    last_low = from_low;
    last_high = from_high;
  }
}

}  // namespace
