// SPDX-License-Identifier: GPL-3.0-or-later
// Topology of tessellated transitions against counting voxels: it is that of Psi, or refused.
#include "slab_oracle.h"
#include "slab_tessellation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace cgal_blend::test {
namespace {

/// Vertices - edges + faces.
long euler_characteristic(const Slab_tessellation& t) {
  std::set<std::pair<std::size_t, std::size_t>> edges;
  for (const auto& f : t.triangles)
    for (std::size_t i = 0; i < 3; ++i) edges.insert(std::minmax(f[i], f[(i + 1) % 3]));
  return static_cast<long>(t.points.size()) - static_cast<long>(edges.size()) + static_cast<long>(t.triangles.size());
}

/// An ellipse whose axes change with z by the slope.
struct Ellipse {
  double x, y, a, b, turn, slope;

  [[nodiscard]] Ring ring(double dz) const {
    constexpr int vertices = 48;
    Ring result;
    for (int i = 0; i < vertices; ++i) {
      const double t = 2 * pi * i / vertices, u = (a + slope * dz) * std::cos(t), v = (b + slope * dz) * std::sin(t);
      result.emplace_back(x + u * std::cos(turn) - v * std::sin(turn), y + u * std::sin(turn) + v * std::cos(turn));
    }
    return result;
  }
  [[nodiscard]] double radius() const { return std::max(a, b); }
};

class Random_slab {
 public:
  explicit Random_slab(unsigned seed) : random_(seed) {}

  /// One to three ellipses near the axis, on walls that spread into the slab, so that most sides join.
  Opening_sections side(double bulge) {
    const std::size_t count = 1 + random_() % 3;
    std::vector<Ellipse> ellipses;
    for (int tries = 0; ellipses.size() < count; ++tries) {
      if (tries % 50 == 0) ellipses.clear();
      const Ellipse e{number(-0.6, 0.6), number(-0.6, 0.6), number(0.2, 0.5),
                      number(0.2, 0.5),  number(0, pi),     bulge * number(0.2, 1.2)};
      if (std::all_of(ellipses.begin(), ellipses.end(), [&](const Ellipse& f) {
            return std::hypot(e.x - f.x, e.y - f.y) > e.radius() + f.radius() + 0.02;
          }))
        ellipses.push_back(e);
    }
    const double step = 0.02;
    std::array<std::vector<Ring>, 3> rings;
    for (const Ellipse& e : ellipses)
      for (std::size_t i = 0; i < 3; ++i) rings[i].push_back(e.ring((static_cast<double>(i) - 1) * step));
    return {rings[1], rings[0], rings[2], step};
  }
  double number(double low, double high) {  // not a std distribution, whose numbers are the library's own affair
    return low + (high - low) * static_cast<double>(random_()) / static_cast<double>(std::mt19937::max());
  }

 private:
  std::mt19937 random_;
};

struct Shares {
  int right = 0, refused = 0, unclear = 0, wrong = 0;
};

Shares judge(const std::vector<unsigned>& seeds, const Opening_model& model) {
  constexpr std::size_t across = 200;
  Shares shares;
  for (const unsigned seed : seeds) {
    Random_slab random(seed);
    const Opening_sections low = random.side(1), high = random.side(-1);
    const double height = random.number(0.3, 1.5);
    const Slab_tessellation t = tessellate_slab({{low, high}, height, {model}});
    if (!t.diagnosis.ok()) {
      ++shares.refused;
      continue;
    }
    const auto expected = characteristic_by_voxels({low, high}, height, model, across);
    if (!expected) {
      ++shares.unclear;
    } else if (*expected == euler_characteristic(t)) {
      ++shares.right;
    } else {
      ++shares.wrong;
      ADD_FAILURE() << "seed " << seed << ": " << euler_characteristic(t) << " instead of " << *expected;
    }
  }
  return shares;
}

TEST(Slab_topology, is_that_of_the_function) {
  for (const Opening_model& model : {distance_opening(), rbf_opening()}) {
    const Shares shares = judge({2, 5}, model);
    EXPECT_GE(shares.right, 1);
  }
}

// Tunnels were lost or made up here.
TEST(Slab_topology, is_right_or_refused_where_tunnels_are_narrow) { judge({48}, distance_opening()); }

TEST(Slab_topology, oracle_counts_known_bodies) {
  // Two pillars; a saddle between one and two; a ring of six legs about a hole.
  const auto count = [](const std::vector<Circle>& low, const std::vector<Circle>& high) {
    return characteristic_by_voxels({sections_of(low), sections_of(high)}, 1.5, distance_opening(), 80);
  };
  EXPECT_EQ(count({{0.4, -1}, {0.4, 1}}, {{0.3, -1}, {0.3, 1}}), 0);
  EXPECT_EQ(count({{1}}, {{0.5, -0.8}, {0.5, 0.8}}), -1);
  EXPECT_EQ(count({{0.6, -0.65}, {0.6, 0.65}}, {{0.6, 0, -0.65}, {0.6, 0, 0.65}}), -4);
  EXPECT_EQ(count({{0.4}}, {{0.4, 1.5}}), 2);  // two caps
}

}  // namespace
}  // namespace cgal_blend::test
