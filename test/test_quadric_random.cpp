// SPDX-License-Identifier: GPL-3.0-or-later
#include "curve_counter.h"

// Pairs at random: nearly all smooth quartics, whose components are counted by an oracle of its own.

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;

Quadric_3 random_quadric(std::mt19937& random, int largest) {
  std::uniform_int_distribution<int> entry(-largest, largest);
  Integers coefficients{};
  while (std::all_of(coefficients.begin(), coefficients.end(), [](int c) { return c == 0; }))
    for (int& c : coefficients) c = entry(random);
  return quadric(coefficients);
}

class Random_pairs : public testing::TestWithParam<int> {};

TEST_P(Random_pairs, have_their_points_on_both) {
  std::mt19937 random(static_cast<unsigned>(GetParam()));
  const double box = 1000;
  for (int k = 0; k < 300; ++k) {
    const Quadric_3 a = random_quadric(random, GetParam()), b = random_quadric(random, GetParam());
    expect_sound(a, b, intersect_quadrics(a, b, {box}), box, 12);
    if (HasFailure()) FAIL() << "pair " << k;
  }
}

TEST_P(Random_pairs, have_as_many_components_as_the_oracle_counts) {
  std::mt19937 random(static_cast<unsigned>(GetParam()) + 1);
  int counted = 0;
  while (counted < 20) {
    const Quadric_3 a = random_quadric(random, GetParam()), b = random_quadric(random, GetParam());
    const Quadric_intersection result = intersect_quadrics(a, b, {1e9});
    if (result.segre != "[1111]") continue;
    const auto expected = Curve_counter(a, b).count();
    if (!expected) continue;
    ++counted;
    EXPECT_EQ(parts(result), *expected) << "pair " << counted;
  }
}

// With smaller coefficients many curves touch the plane at infinity, which breaks them, and which the oracle does not see.
INSTANTIATE_TEST_SUITE_P(Coefficients_up_to, Random_pairs, testing::Values(10, 100, 1000));

}  // namespace
