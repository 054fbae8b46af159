// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_TEST_QUADRIC_CHECKS_H
#define CGAL_BLEND_TEST_QUADRIC_CHECKS_H

#include "quadric_pairs.h"

#include <gtest/gtest.h>

namespace cgal_blend::test {

/// Checks what holds of every component: points on both quadrics, chords that turn little, ends where they belong.
inline void expect_sound(const Quadric_3& a, const Quadric_3& b, const Quadric_intersection& result, double box,
                         std::size_t samples = 24) {
  for (const Intersection_curve& curve : result.components) {
    const auto points = curve.sample(samples);
    for (const auto& p : points) {
      ASSERT_TRUE(is_on(a, p)) << p;
      ASSERT_TRUE(is_on(b, p)) << p;
    }
    if (curve.is_isolated()) {
      EXPECT_EQ(points.size(), 1u);
      continue;
    }
    ASSERT_GE(points.size(), samples);
    const std::size_t n = points.size();
    for (std::size_t i = curve.is_closed() ? 0 : 1; i + (curve.is_closed() ? 0 : 1) < n; ++i)
      ASSERT_LT(angle_deg(points[i] - points[(i + n - 1) % n], points[(i + 1) % n] - points[i]), 25);
    if (curve.is_closed()) continue;
    for (const auto& end : {points.front(), points.back()}) {
      EXPECT_TRUE(is_near(result.singular_points, end, 1e-12) || std::abs(size(end) - box) < 1e-9 * box) << end;
    }
  }
}

}  // namespace cgal_blend::test

#endif
