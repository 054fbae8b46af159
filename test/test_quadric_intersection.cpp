// SPDX-License-Identifier: GPL-3.0-or-later
#include "quadric_checks.h"

#include <cmath>

// What designers intersect: cylinders, cones, spheres, paraboloids and planes, against closed forms.

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;
using Rational = Quadric_3::Rational;
using Vector = Quadric_3::Vector;

const Quadric_3 cylinder_z = Quadric_3::cylinder({0, 0, 0}, {0, 0, 1}, 1);
const Quadric_3 unit_sphere = Quadric_3::sphere({0, 0, 0}, 1);

Quadric_intersection sound(const Quadric_3& a, const Quadric_3& b, double box = 100) {
  const Quadric_intersection result = intersect_quadrics(a, b, {box});
  expect_sound(a, b, result, box);
  return result;
}

struct Case {
  const char* name;
  Quadric_3 a, b;
  const char* segre;
  const char* type;
  std::size_t singular_points;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

Quadric_3 cylinder_x(const Vector& through, const Rational& squared_radius) {
  return Quadric_3::cylinder(through, {1, 0, 0}, squared_radius);
}

const std::vector<Case> cases{
    {"unequal_cylinders", cylinder_z, cylinder_x({0, 0, 0}, 4), "[1111]", "smooth quartic: two closed loops", 0},
    {"equal_cylinders", cylinder_z, cylinder_x({0, 0, 0}, 1), "[(11)11]",
     "two conics crossing in two points: two closed loops", 2},
    {"cylinders_equal_but_for_1e-9", cylinder_z, cylinder_x({0, 0, 0}, Rational(1.000000001)), "[1111]",
     "smooth quartic: two closed loops", 0},
    {"cylinders_equal_but_for_an_ulp", cylinder_z, cylinder_x({0, 0, 0}, Rational(std::nextafter(1.0, 2.0))), "[1111]",
     "smooth quartic: two closed loops", 0},
    {"cylinders_equal_but_for_an_ulp_less", cylinder_z, cylinder_x({0, 0, 0}, Rational(std::nextafter(1.0, 0.0))),
     "[1111]", "smooth quartic: two closed loops", 0},
    {"skew_cylinders", cylinder_z, cylinder_x({0, 1, 0}, 1), "[1111]", "smooth quartic: one closed loop", 0},
    {"skew_cylinders_touching_inside", cylinder_z, cylinder_x({0, 1, 0}, 4), "[211]", "nodal quartic: one closed loop",
     1},
    {"skew_cylinders_touching_outside", cylinder_z, cylinder_x({0, 3, 0}, 4), "[211]", "isolated point", 1},
    {"skew_cylinders_apart", cylinder_z, cylinder_x({0, 4, 0}, 4), "[1111]", "empty", 0},
    {"parallel_cylinders", cylinder_z, Quadric_3::cylinder({1, 0, 0}, {0, 0, 1}, 1), "[111]",
     "two lines in parallel: two open arcs", 0},
    {"parallel_cylinders_touching", cylinder_z, Quadric_3::cylinder({3, 0, 0}, {0, 0, 1}, 4), "[21]",
     "double line: one open arc", 0},
    {"parallel_cylinders_apart", cylinder_z, Quadric_3::cylinder({4, 0, 0}, {0, 0, 1}, 4), "[111]", "empty", 0},
    {"coaxial_cylinders", cylinder_z, Quadric_3::cylinder({0, 0, 5}, {0, 0, 1}, 4), "[(11)1]", "empty", 0},
    {"cone_and_cylinder_coaxial", cylinder_z, Quadric_3::cone({0, 0, 0}, {0, 0, 1}, 1), "[(11)11]",
     "two conics not meeting: two closed loops", 0},
    {"cone_and_cylinder", Quadric_3::cone({0, 0, 0}, {0, 0, 1}, 1), cylinder_x({0, 0, 3}, 1), "[1111]",
     "smooth quartic: two closed loops", 0},
    {"cones_with_one_apex", Quadric_3::cone({1, 1, 1}, {0, 0, 1}, 1), Quadric_3::cone({1, 1, 1}, {1, 0, 0}, 1),
     "[(11)1]", "two double lines through one point: two open arcs", 1},
    {"cones_with_one_apex_and_nothing_else", Quadric_3::cone({1, 1, 1}, {0, 0, 1}, Rational(1, 4)),
     Quadric_3::cone({1, 1, 1}, {1, 0, 0}, Rational(1, 4)), "[111]", "isolated point", 1},
    {"sphere_and_cylinder", Quadric_3::sphere({0, 0, 0}, 4), cylinder_z, "[(11)11]",
     "two conics not meeting: two closed loops", 0},
    {"sphere_and_cylinder_touching_all_round", unit_sphere, cylinder_z, "[(111)1]", "double conic: one closed loop", 0},
    {"sphere_and_cone_through_the_apex", Quadric_3::sphere({1, 0, 0}, 1), Quadric_3::cone({0, 0, 0}, {0, 0, 1}, 1),
     "[211]", "nodal quartic: one closed loop", 1},
    {"sphere_and_cone_on_one_axis", Quadric_3::sphere({0, 0, 1}, 1), Quadric_3::cone({0, 0, 0}, {0, 0, 1}, 1),
     "[2(11)]", "conic and isolated point: one closed loop", 1},
    {"spheres", unit_sphere, Quadric_3::sphere({1, 0, 0}, 1), "[(11)11]", "conic: one closed loop", 0},
    {"spheres_touching", unit_sphere, Quadric_3::sphere({3, 0, 0}, 4), "[2(11)]", "isolated point", 1},
    {"spheres_apart", unit_sphere, Quadric_3::sphere({4, 0, 0}, 4), "[(11)11]", "empty", 0},
    {"spheres_with_one_centre", unit_sphere, Quadric_3::sphere({0, 0, 0}, 4), "[(111)1]", "empty", 0},
    {"spheres_touching_but_for_1e-9", unit_sphere, Quadric_3::sphere({3, 0, 0}, Rational(4.000000001)), "[(11)11]",
     "conic: one closed loop", 0},
    {"paraboloids_face_to_face", quadric({1, 1, 0, 0, 0, 0, 0, 0, -1, 0}), quadric({1, 1, 0, 0, 0, 0, 0, 0, 1, -1}),
     "[2(11)]", "conic: one closed loop", 0},
    {"paraboloids_crossed", quadric({1, 2, 0, 0, 0, 0, 0, 0, -1, 0}), quadric({2, 1, 0, 0, 0, 0, 0, 0, -1, 0}),
     "[(11)11]", "two conics crossing in one point: two open arcs", 1},
    {"planes_and_sphere", Quadric_3::planes({1, 0, 0, 0}, {0, 1, 0, 0}), unit_sphere, "[(11)11]",
     "two conics crossing in two points: two closed loops", 2},
    {"pairs_of_planes", Quadric_3::planes({1, 0, 0, 0}, {0, 1, 0, 0}), Quadric_3::planes({0, 0, 1, 0}, {1, 1, 1, -3}),
     "[(11)(11)]", "four lines crossing in four points: four open arcs", 4},
    {"planes", Quadric_3::plane({1, 0, 0, 0}), Quadric_3::plane({0, 1, 0, -1}), "[{3}]", "line: one open arc", 0},
    {"parallel_planes", Quadric_3::plane({1, 0, 0, 0}), Quadric_3::plane({1, 0, 0, -1}), "[2]", "empty", 0},
    // The line x = 0, y = z is a ruling of both, with other tangent planes: they meet again in the apex alone.
    {"cone_and_cylinder_sharing_a_ruling", quadric({1, 1, -1, 0, 0, 0, 0, 0, 0, 0}),
     quadric({1, 1, 1, 0, 0, -2, 2, 0, 0, 0}), "[22]", "twisted cubic and line crossing in one point: two open arcs",
     1},
    // The same ruling with the same tangent plane.
    {"cone_and_cylinder_touching_along_a_ruling", quadric({1, 1, -1, 0, 0, 0, 0, 0, 0, 0}),
     quadric({1, 0, 0, 0, 0, 0, 0, 2, -2, 0}), "[1{3}]", "conic and double line crossing in one point: two open arcs",
     1},
};

class Designs : public testing::TestWithParam<Case> {};

TEST_P(Designs, come_out_as_what_they_are) {
  const Quadric_intersection result = sound(GetParam().a, GetParam().b);
  EXPECT_EQ(result.segre, GetParam().segre);
  EXPECT_EQ(result.type, GetParam().type);
  EXPECT_EQ(result.singular_points.size(), GetParam().singular_points);
}

TEST_P(Designs, are_the_same_after_a_rigid_motion) {
  const Rational_motion motion({3, 1, -2, 1}, {Rational(1, 3), -2, 5});
  const Quadric_intersection before = intersect_quadrics(GetParam().a, GetParam().b, {1e4});
  const Quadric_intersection after = sound(GetParam().b.transformed(motion), GetParam().a.transformed(motion), 1e4);
  EXPECT_EQ(after.type, before.type);
  EXPECT_EQ(after.segre, before.segre);
  EXPECT_EQ(after.singular_points.size(), before.singular_points.size());
}

INSTANTIATE_TEST_SUITE_P(Pairs, Designs, testing::ValuesIn(cases), [](const auto& info) {
  std::string name = info.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(Quadric_intersection, of_sphere_and_cylinder_is_vivianis_curve) {
  // x = 1 + cos t, y = sin t, z = 2 sin(t / 2) on the sphere of radius 2.
  const Quadric_3 sphere = Quadric_3::sphere({0, 0, 0}, 4), cylinder = Quadric_3::cylinder({1, 0, 0}, {0, 0, 1}, 1);
  const Quadric_intersection result = sound(sphere, cylinder);
  EXPECT_EQ(result.segre, "[211]");
  ASSERT_EQ(result.components.size(), 1u);
  EXPECT_TRUE(result.components[0].is_closed());
  ASSERT_EQ(result.singular_points.size(), 1u);
  EXPECT_LT(CGAL::squared_distance(result.singular_points[0], Quadric_3::Point_3(2, 0, 0)), 1e-30);
  // Length by Simpson's rule on the closed form's speed, and of the component's polygon.
  const int n = 2000;
  double length = 0;
  for (int k = 0; k <= n; ++k) {
    const double t = 4 * 3.14159265358979323846 * k / n, c = std::cos(t / 2);
    length += std::sqrt(1 + c * c) * (k == 0 || k == n ? 1 : k % 2 == 1 ? 4 : 2);
  }
  length *= 4 * 3.14159265358979323846 / n / 3;
  const auto points = result.components[0].sample(4000);
  double polygon = 0;
  for (std::size_t k = 0; k < points.size(); ++k)
    polygon += std::sqrt(CGAL::squared_distance(points[k], points[(k + 1) % points.size()]));
  EXPECT_NEAR(polygon, length, 1e-4 * length);
}

TEST(Quadric_intersection, of_equal_cylinders_lies_in_two_planes) {
  const Quadric_intersection result = sound(cylinder_z, cylinder_x({0, 0, 0}, 1));
  ASSERT_EQ(result.components.size(), 2u);
  for (const Intersection_curve& curve : result.components) {
    EXPECT_EQ(curve.degree(), 2);
    const auto points = curve.sample(40);
    const double side = points[3].x() * points[3].z() > 0 ? 1 : -1;
    for (const auto& p : points) EXPECT_NEAR(p.x(), side * p.z(), 1e-15);
  }
}

TEST(Quadric_intersection, of_the_papers_cone_and_ellipsoid_is_two_loops) {
  const Quadric_intersection result =
      sound(quadric({-4, 9, 36, 0, 0, 0, 0, 0, 0, 0}), quadric({80, 80, 9, 128, 0, 0, 0, 0, 0, -144}));
  EXPECT_EQ(result.type, "smooth quartic: two closed loops");
}

TEST(Quadric_intersection, has_the_derivative_of_its_points_and_the_normals_of_the_surfaces) {
  const Quadric_3 a = quadric({1, 2, -3, 1, 0, 0, 2, 0, 0, -4}), b = quadric({2, -1, 1, 0, 1, 0, 0, 1, 0, -3});
  const Quadric_intersection result = sound(a, b);
  ASSERT_FALSE(result.components.empty());
  for (const Intersection_curve& curve : result.components)
    for (double s = 0.1; s < 0.95; s += 0.1) {
      const Curve_point p = curve.at(s);
      const double h = 1e-4;
      const auto difference = (curve.at(s + h).point - curve.at(s - h).point) / (2 * h);
      const double speed = std::sqrt(p.derivative.squared_length());
      EXPECT_LT(std::sqrt((difference - p.derivative).squared_length()), 1e-3 * speed);
      EXPECT_NEAR(p.normal_a.squared_length(), 1, 1e-15);
      EXPECT_NEAR(p.normal_a * p.derivative, 0, 1e-12 * speed);
      EXPECT_NEAR(p.normal_b * p.derivative, 0, 1e-12 * speed);
      EXPECT_LT(angle_deg(p.normal_a, a.gradient(p.point)), 1e-5);
      EXPECT_LT(angle_deg(p.normal_b, b.gradient(p.point)), 1e-5);
    }
}

TEST(Quadric_intersection, closes_with_its_tangent) {
  for (const Intersection_curve& curve : sound(cylinder_z, cylinder_x({0, 0, 0}, 4)).components) {
    ASSERT_TRUE(curve.is_closed());
    EXPECT_LT(CGAL::squared_distance(curve.at(0).point, curve.at(1).point), 1e-30);
    EXPECT_LT((curve.at(0).derivative - curve.at(1).derivative).squared_length(), 1e-24);
  }
}

struct Shared {
  Quadric_3 a, b;
  const char* status;
  const char* type;
};

class Shared_surfaces : public testing::TestWithParam<Shared> {};

TEST_P(Shared_surfaces, are_named) {
  const Quadric_intersection result = sound(GetParam().a, GetParam().b);
  EXPECT_STREQ(name(result.status), GetParam().status);
  EXPECT_EQ(result.type, GetParam().type);
}

INSTANTIATE_TEST_SUITE_P(
    All, Shared_surfaces,
    testing::Values(
        Shared{unit_sphere, mixed(unit_sphere, unit_sphere, -3, 1), "surface", "the same ellipsoid"},
        Shared{quadric({1, 1, 1, 0, 0, 0, 0, 0, 0, 1}), quadric({2, 2, 2, 0, 0, 0, 0, 0, 0, 2}), "empty", "empty"},
        Shared{quadric({1, 1, 0, 0, 0, 0, 0, 0, 0, 0}), quadric({2, 2, 0, 0, 0, 0, 0, 0, 0, 0}), "ok",
               "line: one open arc"},
        Shared{quadric({1, 2, 3, 0, 0, 0, 0, 0, 0, 0}), quadric({1, 2, 3, 0, 0, 0, 0, 0, 0, 0}), "ok",
               "isolated point"},
        Shared{Quadric_3::planes({1, 0, 0, 0}, {0, 1, 0, 0}), Quadric_3::planes({1, 0, 0, 0}, {0, 0, 1, -1}), "surface",
               "common plane, and line: one open arc"},
        Shared{Quadric_3::planes({1, 0, 0, 0}, {0, 1, 0, 0}), Quadric_3::planes({1, 0, 0, 0}, {1, 1, 0, 0}), "surface",
               "common plane"},
        Shared{Quadric_3::planes({1, 0, 0, 0}, {1, 0, 0, 0}), Quadric_3::plane({1, 0, 0, 0}), "surface",
               "common plane"},
        Shared{quadric({0, 0, 0, 0, 0, 0, 0, 0, 0, 1}), Quadric_3::plane({1, 0, 0, 0}), "empty", "empty"}));

struct Section {
  Integers coefficients;
  std::array<int, 4> plane;
  const char* type;
};

class Plane_sections : public testing::TestWithParam<Section> {};

TEST_P(Plane_sections, are_the_conics_that_they_are) {
  const Section& section = GetParam();
  const Quadric_3 q = quadric(section.coefficients);
  const Quadric_3::Plane plane{section.plane[0], section.plane[1], section.plane[2], section.plane[3]};
  const Quadric_intersection result = intersect(q, plane, {100});
  EXPECT_EQ(result.type, section.type);
  expect_sound(q, Quadric_3::plane(plane), result, 100);
}

INSTANTIATE_TEST_SUITE_P(
    All, Plane_sections,
    testing::Values(
        Section{{1, 1, -1, 0, 0, 0, 0, 0, 0, 0}, {0, 1, 3, -3}, "conic: one closed loop"},
        Section{{1, 1, -1, 0, 0, 0, 0, 0, 0, 0}, {0, 1, 1, -3}, "conic: one open arc"},
        Section{{1, 1, -1, 0, 0, 0, 0, 0, 0, 0}, {0, 3, 1, -3}, "conic: two open arcs"},
        Section{{1, 1, -1, 0, 0, 0, 0, 0, 0, 0}, {1, 0, 0, 0}, "two lines crossing in one point: two open arcs"},
        Section{{1, 1, -1, 0, 0, 0, 0, 0, 0, 0}, {0, 1, 1, 0}, "double line: one open arc"},
        Section{{1, 1, -1, 0, 0, 0, 0, 0, 0, 0}, {0, 1, 2, 0}, "isolated point"},
        Section{{1, 1, 0, 0, 0, 0, 0, 0, 0, -1}, {1, 0, 0, 0}, "two lines not meeting: two open arcs"},
        Section{{1, 1, 0, 0, 0, 0, 0, 0, 0, -1}, {1, 0, 0, -1}, "double line: one open arc"},
        Section{{1, 1, 0, 0, 0, 0, 0, 0, 0, -1}, {1, 0, 0, -2}, "empty"},
        Section{{0, 0, 0, 1, 0, 0, 0, 0, 0, 0}, {1, 0, 0, 0}, "common plane"},
        Section{{0, 0, 0, 1, 0, 0, 0, 0, 0, 0}, {1, 0, 0, -1}, "line: one open arc"},
        Section{{0, 0, 0, 1, 0, 0, 0, 0, -1, 0}, {0, 0, 1, 0}, "two lines crossing in one point: two open arcs"}));

TEST(Plane_section, of_a_cylinder_is_the_ellipse_with_the_axes_of_its_tilt) {
  const Quadric_intersection result = intersect(cylinder_z, {0, -1, 1, 0}, {});
  ASSERT_EQ(result.components.size(), 1u);
  double longest = 0, shortest = 9;
  for (const auto& p : result.components[0].sample(2000)) {
    longest = std::max(longest, std::sqrt(CGAL::squared_distance(p, Quadric_3::Point_3(0, 0, 0))));
    shortest = std::min(shortest, std::sqrt(CGAL::squared_distance(p, Quadric_3::Point_3(0, 0, 0))));
  }
  EXPECT_NEAR(longest, std::sqrt(2.0), 1e-5);
  EXPECT_NEAR(shortest, 1, 1e-5);
}

}  // namespace
