// SPDX-License-Identifier: GPL-3.0-or-later
#include "quadric_checks.h"

#include <cmath>

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;
using Rational = Quadric_3::Rational;

struct Typed {
  Quadric_type type;
  Integers coefficients;
  int rank;
};

void PrintTo(const Typed& t, std::ostream* out) { *out << describe(t.type); }

class Quadric_types : public testing::TestWithParam<Typed> {};

// Rank and inertia are invariants, so the type is that of the normal form, whatever the coordinates and the sign.
TEST_P(Quadric_types, are_those_of_the_normal_form_in_any_coordinates) {
  std::mt19937 random(1);
  const Quadric_3 normal_form = quadric(GetParam().coefficients);
  for (int trial = 0; trial < 10; ++trial) {
    const Quadric_3 changed = trial == 0 ? normal_form : Affine_change(random)(normal_form);
    EXPECT_EQ(changed.type(), GetParam().type);
    EXPECT_EQ(changed.rank(), GetParam().rank);
    EXPECT_EQ(mixed(changed, changed, -3, 1).type(), GetParam().type);
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, Quadric_types,
    testing::Values(Typed{Quadric_type::ellipsoid, {1, 2, 3, 0, 0, 0, 0, 0, 0, -1}, 4},
                    Typed{Quadric_type::empty, {1, 2, 3, 0, 0, 0, 0, 0, 0, 1}, 4},
                    Typed{Quadric_type::one_sheeted_hyperboloid, {1, 2, -3, 0, 0, 0, 0, 0, 0, -1}, 4},
                    Typed{Quadric_type::two_sheeted_hyperboloid, {1, 2, -3, 0, 0, 0, 0, 0, 0, 1}, 4},
                    Typed{Quadric_type::elliptic_paraboloid, {1, 2, 0, 0, 0, 0, 0, 0, -1, 0}, 4},
                    Typed{Quadric_type::hyperbolic_paraboloid, {1, -2, 0, 0, 0, 0, 0, 0, -1, 0}, 4},
                    Typed{Quadric_type::cone, {1, 2, -3, 0, 0, 0, 0, 0, 0, 0}, 3},
                    Typed{Quadric_type::point, {1, 2, 3, 0, 0, 0, 0, 0, 0, 0}, 3},
                    Typed{Quadric_type::elliptic_cylinder, {1, 2, 0, 0, 0, 0, 0, 0, 0, -1}, 3},
                    Typed{Quadric_type::empty, {1, 2, 0, 0, 0, 0, 0, 0, 0, 1}, 3},
                    Typed{Quadric_type::hyperbolic_cylinder, {1, -2, 0, 0, 0, 0, 0, 0, 0, -1}, 3},
                    Typed{Quadric_type::parabolic_cylinder, {1, 0, 0, 0, 0, 0, 0, 0, -1, 0}, 3},
                    Typed{Quadric_type::intersecting_planes, {1, -2, 0, 0, 0, 0, 0, 0, 0, 0}, 2},
                    Typed{Quadric_type::line, {1, 2, 0, 0, 0, 0, 0, 0, 0, 0}, 2},
                    Typed{Quadric_type::parallel_planes, {1, 0, 0, 0, 0, 0, 0, 0, 0, -1}, 2},
                    Typed{Quadric_type::empty, {1, 0, 0, 0, 0, 0, 0, 0, 0, 1}, 2},
                    Typed{Quadric_type::plane, {0, 0, 0, 0, 0, 0, 1, 0, 0, 0}, 2},
                    Typed{Quadric_type::double_plane, {1, 0, 0, 0, 0, 0, 0, 0, 0, 0}, 1},
                    Typed{Quadric_type::empty, {0, 0, 0, 0, 0, 0, 0, 0, 0, 1}, 1}));

TEST(Quadric, of_radii_that_differ_by_one_ulp_is_what_it_is) {
  // x^2 + y^2 - z^2 - c is a cone for c = 0 only.
  const double tiny = 1e-300;
  EXPECT_EQ(Quadric_3(std::array<double, 10>{1, 1, -1, 0, 0, 0, 0, 0, 0, -tiny}).type(),
            Quadric_type::one_sheeted_hyperboloid);
  EXPECT_EQ(Quadric_3(std::array<double, 10>{1, 1, -1, 0, 0, 0, 0, 0, 0, tiny}).type(),
            Quadric_type::two_sheeted_hyperboloid);
}

TEST(Quadric, from_shapes_vanishes_on_them) {
  const Quadric_3 sphere = Quadric_3::sphere({1, 2, 3}, 4);
  EXPECT_EQ(sphere.type(), Quadric_type::ellipsoid);
  for (double t = 0; t < 6; t += 0.5)
    EXPECT_NEAR(sphere.value({1 + 2 * std::cos(t), 2 + 2 * std::sin(t) * 0.6, 3 + 2 * std::sin(t) * 0.8}), 0, 1e-14);

  // Axis (1, 2, 2) / 3 through (1, 0, 0); (2, 1, -2) / 3 and (2, -2, 1) / 3 are orthogonal to it.
  const Quadric_3 cylinder = Quadric_3::cylinder({1, 0, 0}, {1, 2, 2}, 9);
  const Quadric_3 cone = Quadric_3::cone({1, 0, 0}, {1, 2, 2}, 4);
  EXPECT_EQ(cylinder.type(), Quadric_type::elliptic_cylinder);
  EXPECT_EQ(cone.type(), Quadric_type::cone);
  for (double t = 0; t < 6; t += 0.5)
    for (double h = -3; h < 4; h += 1.5) {
      const auto point = [&](double radius) {
        const double u = radius * std::cos(t) / 3, v = radius * std::sin(t) / 3, w = h / 3;
        return Quadric_3::Point_3(1 + 2 * u + 2 * v + w, u - 2 * v + 2 * w, -2 * u + v + 2 * w);
      };
      EXPECT_NEAR(cylinder.value(point(3)), 0, 1e-13);
      EXPECT_NEAR(cone.value(point(2 * h)), 0, 1e-12);
    }

  const Quadric_3 planes = Quadric_3::planes({1, 2, 3, 4}, {5, 6, 7, 8});
  EXPECT_EQ(planes.type(), Quadric_type::intersecting_planes);
  EXPECT_NEAR(planes.value({-4, 0, 0}), 0, 1e-15);
  EXPECT_NEAR(planes.value({0, -4.0 / 3, 0}), 0, 1e-15);
  EXPECT_EQ(Quadric_3::plane({1, 2, 3, 4}).type(), Quadric_type::plane);
}

TEST(Quadric, has_the_gradient_of_its_value) {
  const Quadric_3 q = quadric({1, -2, 3, 4, -5, 6, -7, 8, 9, 10});
  const Quadric_3::Point_3 p(0.3, -1.2, 2.1);
  const double h = 1e-3;  // central differences of a quadratic polynomial are exact
  const auto difference = [&](const Quadric_3::Vector_3& d) {
    return (q.value(p + h * d) - q.value(p - h * d)) / (2 * h);
  };
  EXPECT_NEAR(q.gradient(p).x(), difference({1, 0, 0}), 1e-11);
  EXPECT_NEAR(q.gradient(p).y(), difference({0, 1, 0}), 1e-11);
  EXPECT_NEAR(q.gradient(p).z(), difference({0, 0, 1}), 1e-11);
}

TEST(Rational_motion, is_orthogonal_exactly_and_moves_quadrics_with_their_points) {
  const Rational_motion motion({1, 2, -3, 4}, {5, -6, Rational(7, 2)});
  const auto& r = motion.rotation();
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      EXPECT_EQ(Rational(r[i][0] * r[j][0] + r[i][1] * r[j][1] + r[i][2] * r[j][2]), Rational(i == j ? 1 : 0));
  // A cylinder moved is the cylinder about the moved axis, coefficient by coefficient.
  Quadric_3::Vector axis{1, 2, 3}, point{4, 5, 6}, new_axis, new_point;
  for (std::size_t i = 0; i < 3; ++i) {
    new_axis[i] = r[i][0] * axis[0] + r[i][1] * axis[1] + r[i][2] * axis[2];
    new_point[i] = r[i][0] * point[0] + r[i][1] * point[1] + r[i][2] * point[2] + motion.translation()[i];
  }
  const Quadric_3 moved = Quadric_3::cylinder(point, axis, 7).transformed(motion);
  const Quadric_3 expected = Quadric_3::cylinder(new_point, new_axis, 7);
  for (std::size_t k = 0; k < 10; ++k) EXPECT_EQ(moved.coefficients()[k], expected.coefficients()[k]);
}

TEST(Rational_motion, nearest_to_a_rotation_in_doubles_is_within_rounding_of_it) {
  const double c = std::cos(0.7), s = std::sin(0.7);
  const std::array<std::array<double, 3>, 3> rotation{{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}};
  const Rational_motion motion = Rational_motion::nearest(rotation, {0.1, 0.2, 0.3});
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(motion.translation()[i], Rational(std::array<double, 3>{0.1, 0.2, 0.3}[i]));
    for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(CGAL::to_double(motion.rotation()[i][j]), rotation[i][j], 1e-15);
  }
  // A cylinder turned about its axis is the same, exactly.
  const Quadric_3 cylinder = Quadric_3::cylinder({0, 0, 0}, {0, 0, 1}, 2);
  EXPECT_EQ(cylinder.transformed(Rational_motion::nearest(rotation)).coefficients(), cylinder.coefficients());
}

}  // namespace
