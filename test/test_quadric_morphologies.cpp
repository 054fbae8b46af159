// SPDX-License-Identifier: GPL-3.0-or-later
#include "quadric_checks.h"

// The real morphologies of regular pencils of quadrics in projective space, up to real projective maps and the choice of
// the two that span the pencil: every Segre symbol with the signs that its canonical form leaves free, and with real or
// complex roots. Each line is a canonical form with one of its variables at 1; what the curve is there follows by hand.

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;

struct Morphology {
  const char* segre;
  const char* what;  ///< the curves' names in the type, until the colon
  Parts parts;
  Integers a, b;
};

void PrintTo(const Morphology& m, std::ostream* out) { *out << m.segre << " " << m.what; }

const std::vector<Morphology> table{
    {"[1111]", "empty", {0, 0, 0}, {1, 1, 1, 0, 0, 0, 0, 0, 0, 1}, {1, 2, 3, 0, 0, 0, 0, 0, 0, 4}},
    {"[1111]", "smooth quartic", {2, 0, 0}, {1, -1, -1, 0, 0, 0, 0, 0, 0, 1}, {1, -2, -4, 0, 0, 0, 0, 0, 0, 3}},
    // two real roots: (x^2 + y^2)^2 / 4 + x^2 + 2 y^2 = 1
    {"[1111]", "smooth quartic", {1, 0, 0}, {1, 1, 0, 0, 0, 0, 0, 0, 2, 0}, {1, 2, 1, 0, 0, 0, 0, 0, 0, -1}},
    // no real root: each of two loops crosses the plane at infinity once
    {"[1111]", "smooth quartic", {0, 2, 0}, {0, 0, 0, 2, 0, 0, 0, 0, 2, 0}, {1, -1, 2, 0, 0, 0, 0, 0, 0, -2}},

    {"[211]", "nodal quartic", {1, 0, 0}, {1, 1, -1, 0, 0, 0, 0, 0, 0, 0}, {0, 0, -1, 0, 0, 0, 2, 0, 0, 0}},
    // y^2 = z^4 / 4 - z^2
    {"[211]",
     "quartic and isolated point",
     {0, 2, 1},
     {1, -1, -1, 0, 0, 0, 0, 0, 0, 0},
     {0, 0, -1, 0, 0, 0, 2, 0, 0, 0}},
    {"[211]", "isolated point", {0, 0, 1}, {1, 1, 1, 0, 0, 0, 0, 0, 0, 0}, {0, 0, -1, 0, 0, 0, 2, 0, 0, 0}},
    // complex simple roots: r^2 = -4 sin(2 theta) / cos^2(2 theta), two branches through the node
    {"[211]", "nodal quartic", {0, 2, 0}, {1, 0, 0, 0, 0, 2, 0, 0, 0, 0}, {0, 1, -1, 0, 0, 0, 2, 0, 0, 0}},

    // z = -y^3 / 8 and the z axis
    {"[22]",
     "twisted cubic and line crossing in one point",
     {0, 2, 0},
     {1, 0, 0, 0, 0, 2, 0, 0, 0, 0},
     {0, 1, 0, 0, 0, 0, 2, 0, 0, 0}},
    // (t, t^2, t^3) and its chord through t = i, -i
    {"[22]",
     "twisted cubic and line not meeting",
     {0, 2, 0},
     {0, 0, 0, -1, 0, 0, 0, 0, 1, 0},
     {-1, 1, 0, 0, -1, 0, 0, 1, 0, 0}},
    // (-t^4 / 2, t^2, t^3)
    {"[31]", "cuspidal quartic", {0, 2, 0}, {0, 0, 1, 2, 0, 0, 0, 0, 0, 0}, {0, 1, 0, 0, 0, 0, 2, 0, 0, 0}},
    // (-2 t^3, 2 t^2, t) and its tangent, the z axis
    {"[4]",
     "twisted cubic and line touching in one point",
     {0, 2, 0},
     {0, 1, 0, 0, 2, 0, 0, 0, 0, 0},
     {0, 0, 0, 0, 0, 2, 2, 0, 0, 0}},

    {"[(11)11]",
     "two conics crossing in two points",
     {2, 0, 0},
     {0, 1, -1, 0, 0, 0, 0, 0, 0, 0},
     {1, 2, -1, 0, 0, 0, 0, 0, 0, -1}},
    {"[(11)11]", "two conics not meeting", {2, 0, 0}, {0, 0, 1, 0, 0, 0, 0, 0, 0, -1}, {1, 1, 1, 0, 0, 0, 0, 0, 0, -2}},
    {"[(11)11]", "empty", {0, 0, 0}, {0, 0, 1, 0, 0, 0, 0, 0, 0, -1}, {1, 1, 2, 0, 0, 0, 0, 0, 0, -1}},
    {"[(11)11]", "two isolated points", {0, 0, 2}, {0, 1, 1, 0, 0, 0, 0, 0, 0, 0}, {1, 1, 2, 0, 0, 0, 0, 0, 0, -1}},
    {"[(11)11]", "empty", {0, 0, 0}, {0, 1, 1, 0, 0, 0, 0, 0, 0, 0}, {1, 1, 2, 0, 0, 0, 0, 0, 0, 1}},
    // complex simple roots: a plane with a conic, another without; then a circle and a hyperbola
    {"[(11)11]", "conic", {1, 0, 0}, {0, 0, 0, 0, 0, 0, 0, 0, 2, 0}, {1, 1, 1, 0, 0, 0, 0, 0, 0, -1}},
    {"[(11)11]",
     "two conics crossing in two points",
     {1, 2, 0},
     {0, 0, 0, 0, 0, 2, 0, 0, 0, 0},
     {1, 1, -1, 0, 0, 0, 0, 0, 0, -1}},

    {"[(111)1]", "double conic", {1, 0, 0}, {0, 0, 1, 0, 0, 0, 0, 0, 0, 0}, {1, 1, 1, 0, 0, 0, 0, 0, 0, -1}},
    {"[(111)1]", "empty", {0, 0, 0}, {0, 0, 1, 0, 0, 0, 0, 0, 0, 0}, {1, 1, 1, 0, 0, 0, 0, 0, 0, 1}},

    {"[(21)1]",
     "two conics touching in one point",
     {0, 2, 0},
     {1, -1, 0, 0, 0, 0, 0, 0, 0, 0},
     {0, 0, 1, 0, 0, 0, 2, 0, 0, 0}},
    {"[(21)1]", "isolated point", {0, 0, 1}, {1, 1, 0, 0, 0, 0, 0, 0, 0, 0}, {0, 0, 1, 0, 0, 0, 2, 0, 0, 0}},

    {"[2(11)]",
     "conic and two lines crossing in two points",
     {1, 2, 0},
     {1, 1, 0, 0, 0, 0, 0, 0, 0, -1},
     {0, 0, 0, 0, 2, 0, 0, 0, 0, 0}},
    {"[2(11)]", "isolated point", {0, 0, 1}, {1, 1, 1, 0, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0, 2, 0, 0, 0}},
    {"[2(11)]",
     "conic and isolated point",
     {1, 0, 1},
     {1, 1, 1, 0, 0, 0, 0, 0, -2, 0},
     {1, 1, -1, 0, 0, 0, 0, 0, 0, 0}},

    {"[(31)]",
     "conic and two lines crossing in one point",
     {0, 3, 0},
     {0, 0, 0, 2, 0, 0, 0, 0, 0, 0},
     {0, 1, -1, 0, 0, 0, 2, 0, 0, 0}},
    {"[(31)]", "conic", {0, 1, 0}, {0, 0, 0, 2, 0, 0, 0, 0, 0, 0}, {0, 1, 1, 0, 0, 0, 2, 0, 0, 0}},

    {"[(11)(11)]",
     "four lines crossing in two points",
     {0, 4, 0},
     {0, 1, -1, 0, 0, 0, 0, 0, 0, 0},
     {1, 0, 0, 0, 0, 0, 0, 0, 0, -1}},
    {"[(11)(11)]", "two isolated points", {0, 0, 2}, {0, 1, 1, 0, 0, 0, 0, 0, 0, 0}, {1, 0, 0, 0, 0, 0, 0, 0, 0, -1}},
    {"[(11)(11)]", "empty", {0, 0, 0}, {0, 1, 1, 0, 0, 0, 0, 0, 0, 0}, {1, 0, 0, 0, 0, 0, 0, 0, 0, 1}},
    // complex roots: x = -1, y = z and x = 1, y = -z
    {"[(11)(11)]",
     "two lines not meeting",
     {0, 2, 0},
     {0, 0, 0, 2, 0, 0, 0, 0, 2, 0},
     {1, -1, 1, 0, 0, 0, 0, 0, 0, -1}},

    {"[(22)]",
     "two lines and double line crossing in two points",
     {0, 3, 0},
     {1, -1, 0, 0, 0, 0, 0, 0, 0, 0},
     {0, 0, 0, 0, 0, 2, 2, 0, 0, 0}},
    {"[(22)]", "double line", {0, 1, 0}, {1, 1, 0, 0, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 2, 2, 0, 0, 0}},

    {"[(211)]",
     "two double lines crossing in one point",
     {0, 2, 0},
     {1, 0, 0, 0, 0, 0, 0, 0, 0, 0},
     {0, 1, -1, 0, 0, 0, 2, 0, 0, 0}},
    {"[(211)]", "isolated point", {0, 0, 1}, {1, 0, 0, 0, 0, 0, 0, 0, 0, 0}, {0, 1, 1, 0, 0, 0, 2, 0, 0, 0}},
};

class Morphologies : public testing::TestWithParam<Morphology> {
 protected:
  void expect(const Quadric_3& a, const Quadric_3& b) {
    const Morphology& m = GetParam();
    const double box = 50;
    const Quadric_intersection result = intersect_quadrics(a, b, {box});
    EXPECT_EQ(result.segre, m.segre);
    EXPECT_EQ(result.type.substr(0, result.type.find(':')), m.what);
    EXPECT_EQ(parts(result), m.parts);
    EXPECT_EQ(result.status == Intersection_status::empty, std::string(m.what) == "empty");
    expect_sound(a, b, result, box);
  }
};

TEST_P(Morphologies, are_told_apart) { expect(quadric(GetParam().a), quadric(GetParam().b)); }

TEST_P(Morphologies, do_not_depend_on_affine_coordinates_and_on_the_pair_of_the_pencil) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> factor(-3, 3);
  for (int trial = 0; trial < 8; ++trial) {
    const Affine_change change(random);
    const Quadric_3 a = change(quadric(GetParam().a)), b = change(quadric(GetParam().b));
    int f = 0, g = 0, h = 0, k = 0;
    while (f * k == g * h) f = factor(random), g = factor(random), h = factor(random), k = factor(random);
    expect(mixed(a, b, f, g), mixed(a, b, h, k));
    if (HasFailure()) FAIL() << "trial " << trial;
  }
}

INSTANTIATE_TEST_SUITE_P(Regular_pencils, Morphologies, testing::ValuesIn(table));

}  // namespace
