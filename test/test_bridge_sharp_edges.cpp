// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/bridge.h>

#include "bridge_spheres.h"
#include "checks.h"

#include <cgal_blend/validate.h>
#include <gtest/gtest.h>

// Contact curves that run along sharp edges of the mesh.

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;

TEST(Bridge_sharp_edges, may_be_followed_by_contacts) {
  // The side x = 0.5687 of the upper face is a side of the rectangle; rounding puts points on either face of the edges.
  const double a = 0.5687014935083683, b = 0.8877723434896072, spot = -0.036173318512232953;
  for (const int n : {1, 3, 7, 20}) {
    const Blend_mesh mesh = side_by_side(grid_box({-a, -b, -1.6}, {a, b, 0}, n), grid_box({-2, -2, 3}, {2, 2, 5}, 1));
    std::array<Bridge_end, 2> ends{end_at({spot, 0, 0}, 0), end_at({0, 0, 3}, 0.5)};
    ends[0].zero_direction = Vector_3(1, 0, 0);
    ends[0].curve = rectangle_curve(a - spot, b / 2, b / 10);
    Blend_mesh out;
    const Bridge_outcome outcome = unchecked::bridge(mesh, ends, out);
    ASSERT_TRUE(outcome.ok()) << n << ": " << message(outcome.diagnosis);
    EXPECT_TRUE(validate(out).ok()) << n;
    EXPECT_EQ(euler(out), 2) << n;
  }
}

}  // namespace
