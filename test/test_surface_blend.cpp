// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/boundary_models.h>
#include <cgal_blend/surface_blend.h>

#include "blend_boundaries.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;

constexpr double two_pi = 6.283185307179586;

template <class T>
T square(const T& x) {
  return x * x;
}

const auto ellipsoid = [](const auto& x, const auto& y, const auto& z) {
  using T = std::decay_t<decltype(x)>;
  return square(x) / T(4.0) + square(y) / T(9.0) + square(z) - T(1.0);
};
const auto cylinder = [](const auto& x, const auto& y, const auto&) {
  using T = std::decay_t<decltype(x)>;
  return square(x - T(0.3)) + square(y) - T(1.0);
};

Normal_field normals_of_ellipsoid() {
  return [](const Point_3& p) { return Vector_3(p.x() / 4, p.y() / 9, p.z()); };
}
Normal_field normals_of_cylinder() {
  return [](const Point_3& p) { return Vector_3(p.x() - 0.3, p.y(), 0); };
}

/// The section of the ellipsoid with z = 1/2.
Implicit_boundary ellipsoid_section() {
  const auto curve = [](const auto& s) {
    using std::cos;
    using std::sin;
    using T = std::decay_t<decltype(s)>;
    const T a = T(two_pi) * s;
    const double scale = std::sqrt(0.75);
    return std::array<T, 3>{T(2 * scale) * cos(a), T(3 * scale) * sin(a), T(0.5)};
  };
  return {implicit_function(ellipsoid), space_curve(curve, true)};
}

/// The section of the cylinder with z = 3 + x / 2.
Implicit_boundary cylinder_section() {
  const auto curve = [](const auto& s) {
    using std::cos;
    using std::sin;
    using T = std::decay_t<decltype(s)>;
    const T a = T(two_pi) * (T(0.4) - s);  // against the other curve, from another start
    const T x = T(0.3) + cos(a);
    return std::array<T, 3>{x, sin(a), T(3.0) + T(0.5) * x};
  };
  return {implicit_function(cylinder), space_curve(curve, true)};
}

TEST(Surface_blend, Is_tangent_to_both_surfaces) {
  for (const double lambda : {0.0, 0.4, -0.7})
    for (const Matching matching : {Matching::parameter, Matching::arc_length, Matching::least_twist}) {
      Surface_blend_options options;
      options.sides[0].direction = lambda;
      options.sides[1].direction = -lambda / 2;
      options.correspondence.matching = matching;
      options.on_fold = Fold_policy::ignore;
      const auto result = blend_surfaces(ellipsoid_section(), cylinder_section(), options);
      ASSERT_TRUE(result.ok()) << message(result.diagnosis);
      EXPECT_LT(worst_tangency(*result.blend, 0, normals_of_ellipsoid()), 1e-7);
      EXPECT_LT(worst_tangency(*result.blend, 1, normals_of_cylinder()), 1e-7);
    }
}

TEST(Surface_blend, Pairs_nearest_points) {
  const auto result = blend_surfaces(ellipsoid_section(), cylinder_section());
  ASSERT_TRUE(result.ok()) << message(result.diagnosis);
  EXPECT_TRUE(result.blend->parameter_map(1).is_reversed());
  // Both curves are symmetric to y = 0, so pairs on that plane stay on it.
  EXPECT_NEAR(result.blend->at(0, 1).y(), 0, 1e-3);
  EXPECT_GT(result.blend->at(0, 1).x(), 0);
}

// Paper 004, section 3.3: a helicoid and a cubic surface, all distances 1 with vectors that are not normalized.
TEST(Surface_blend, Reproduces_the_closed_polynomial) {
  const auto helicoid = [](const auto& alpha, const auto& v) {
    using std::cos;
    using std::sin;
    using T = std::decay_t<decltype(v)>;
    return std::array<T, 3>{v * sin(alpha), v * cos(alpha), T(2.0) + alpha};
  };
  // The iso-curve alpha = 0 with v running: u is v here.
  const auto turned = [=](const auto& u, const auto& v) { return helicoid(v, u); };
  const Iso_curve_boundary first(parametric_patch(turned, {0, 4, 0, 3}, false), 0);
  const auto cubic = [](const auto& x, const auto& y, const auto& z) {
    using T = std::decay_t<decltype(x)>;
    return x * x * x + y + z * z + T(4.0) * z + T(5.0);
  };
  const double k = std::cbrt(21.0) - std::cbrt(17.0);
  const auto u_of = [k](double s) { return -std::cbrt(21.0) + k * s; };
  const auto curve = [k](const auto& s) {
    using T = std::decay_t<decltype(s)>;
    const T u = T(-std::cbrt(21.0)) + T(k) * s;
    return std::array<T, 3>{u, T(-17.0) - u * u * u, T(2.0)};
  };
  const Implicit_boundary second(implicit_function(cubic), space_curve(curve, false));

  Surface_blend_options options;
  options.correspondence.matching = Matching::parameter;
  options.sides[0].distance = Adjusting_function([](double s) { return std::sqrt(16 * s * s + 1); });
  options.sides[1].distance = Adjusting_function([=](double s) {
    const double u = u_of(s);
    return std::sqrt(square(24 * k * u * u) + square(8 * k) + square(k * (9 * u * u * u * u + 1)));
  });
  options.sides[0].flip = true;
  options.sides[1].flip = false;
  options.on_fold = Fold_policy::ignore;
  const auto result = blend_surfaces(first, second, options);
  ASSERT_TRUE(result.ok()) << message(result.diagnosis);
  for (int i = 0; i <= 20; ++i)
    for (int j = 0; j <= 20; ++j) {
      const double s = i / 20.0, t = j / 20.0, r = 1 - t, u = u_of(s);
      const Point_3 expected(
          -12 * t * r * r * s + 3 * t * t * r * (u + 24 * k * u * u) + t * t * t * u,
          4 * r * r * r * s + 12 * t * r * r * s + 3 * t * t * r * (-17 - u * u * u + 8 * k) -
              t * t * t * (17 + u * u * u),
          2 * r * r * r + 3 * t * r * r * (2 - 1) + 3 * t * t * r * (2 - k * (9 * u * u * u * u + 1)) + 2 * t * t * t);
      EXPECT_LT(std::sqrt(CGAL::squared_distance(result.blend->at(s, t), expected)), 1e-12 * 21) << s << " " << t;
    }
}

TEST(Surface_blend, Continues_curvature) {
  Surface_blend_options options;
  options.g2 = true;
  options.on_fold = Fold_policy::ignore;
  for (const bool with_middle : {false, true}) {
    if (with_middle)
      options.middle = [](double s, const Point_3&) {
        return Point_3(1.6 * std::cos(two_pi * s), 2 * std::sin(two_pi * s), 1.8);
      };
    const auto result = blend_surfaces(ellipsoid_section(), cylinder_section(), options);
    ASSERT_TRUE(result.ok()) << message(result.diagnosis);
    EXPECT_LT(worst_tangency(*result.blend, 0, normals_of_ellipsoid()), 1e-7);
    for (int i = 0; i < 40; ++i) {
      const double s = i / 40.0;
      // Normal curvature along t of a curve in the blend, against that of the surfaces: n . II / |grad|.
      const auto measure = [&](int side) {
        const auto f = [&](double x) { return result.blend->at(s, side == 0 ? x : 1 - x); };
        return one_sided_derivatives(f, 0.05);
      };
      const auto [d0, dd0] = measure(0);
      const Vector_3 g = normals_of_ellipsoid()(result.blend->at(s, 0)) * 2;
      const double curvature = dd0 * g / std::sqrt(g.squared_length()) / d0.squared_length();
      const double expected = -2 * (d0.x() * d0.x() / 4 + d0.y() * d0.y() / 9 + d0.z() * d0.z()) /
                              std::sqrt(g.squared_length()) / d0.squared_length();
      EXPECT_NEAR(curvature, expected, 1e-7 * std::abs(expected) + 1e-8);
      const auto [d1, dd1] = measure(1);
      const Vector_3 n = normals_of_cylinder()(result.blend->at(s, 1));
      EXPECT_NEAR(dd1 * n, -(d1.x() * d1.x() + d1.y() * d1.y()), 1e-7 * d1.squared_length());
    }
  }
}

TEST(Surface_blend, Refuses_by_name) {
  const auto cone =
      implicit_function([](const auto& x, const auto& y, const auto& z) { return x * x + y * y - z * z; });
  const auto through_apex = space_curve(
      [](const auto& s) {
        using T = std::decay_t<decltype(s)>;
        return std::array<T, 3>{T(2.0) * s - T(1.0), T(0.0), T(2.0) * s - T(1.0)};
      },
      false);
  const Implicit_boundary ruling(cone, through_apex);
  EXPECT_EQ(blend_surfaces(ruling, ruling).diagnosis.status, Status::singular_boundary);
  EXPECT_EQ(blend_surfaces(ruling, cylinder_section()).diagnosis.status, Status::curves_do_not_correspond);
  EXPECT_EQ(blend_surfaces(cylinder_section(), cylinder_section()).diagnosis.status, Status::curves_do_not_correspond);
  Surface_blend_options options;
  options.sides[0].distance = -1;
  EXPECT_EQ(blend_surfaces(ellipsoid_section(), cylinder_section(), options).diagnosis.status,
            Status::invalid_parameter);
  options.sides[0].distance = 60;
  const auto folded = blend_surfaces(ellipsoid_section(), cylinder_section(), options);
  EXPECT_EQ(folded.diagnosis.status, Status::blend_folds);
  EXPECT_GT(folded.factor, 0);
  EXPECT_LT(folded.factor, 1);
  options.on_fold = Fold_policy::shrink;
  const auto shrunk = blend_surfaces(ellipsoid_section(), cylinder_section(), options);
  ASSERT_TRUE(shrunk.ok());
  EXPECT_FALSE(find_fold(*shrunk.blend));
  EXPECT_TRUE(find_fold(shrunk.blend->scaled(1.06)));
}

}  // namespace
