// SPDX-License-Identifier: GPL-3.0-or-later
#include "curve_counter.h"
#include "quadric_checks.h"

// Pairs at random: nearly all smooth quartics, whose components are counted by an oracle of its own.

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;

TEST(Degenerate_pairs, do_not_depend_on_affine_coordinates_and_on_the_pair_of_the_pencil) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> factor(-3, 3);
  const Intersection_options options{1e9};  // arcs that stay outside of the box are left out
  for (int k = 0; k < 500; ++k) {
    const Quadric_3 a = random_sparse_quadric(random), b = random_sparse_quadric(random);
    const Affine_change change(random);
    int f = 0, g = 0, h = 0, l = 0;
    while (f * l == g * h) f = factor(random), g = factor(random), h = factor(random), l = factor(random);
    const Quadric_intersection result = intersect_quadrics(a, b, options);
    if (result.segre == "[]" || result.segre == "[(1111)]") continue;  // of the same quadric a mixture may be 0
    const Quadric_intersection other =
        intersect_quadrics(mixed(change(a), change(b), f, g), mixed(change(a), change(b), h, l), options);
    EXPECT_EQ(other.type, result.type) << "pair " << k;
    EXPECT_EQ(other.segre, result.segre) << "pair " << k;
    EXPECT_EQ(other.singular_points.size(), result.singular_points.size()) << "pair " << k;
    expect_sound(a, b, intersect_quadrics(a, b, {100}), 100, 12);
    if (HasFailure()) FAIL() << "pair " << k;
  }
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
