// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/boundary_models.h>
#include <cgal_blend/mesh_io.h>
#include <cgal_blend/surface_blend_fit.h>

#include "blend_boundaries.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;

/// An ellipse in a plane z = constant of the elliptic cylinder x^2 / a^2 + y^2 = 1.
Implicit_boundary ellipse(double a, double z) {
  const auto surface = [a](const auto& x, const auto& y, const auto&) {
    using T = std::decay_t<decltype(x)>;
    return x * x / T(a * a) + y * y - T(1.0);
  };
  const auto curve = [a, z](const auto& s) {
    using std::cos;
    using std::sin;
    using T = std::decay_t<decltype(s)>;
    const T angle = T(2 * CGAL_PI) * s;
    return std::array<T, 3>{T(a) * cos(angle), sin(angle), T(z)};
  };
  return {implicit_function(surface), space_curve(curve, true)};
}

Surface_blend make_blend(bool g2, double lambda = 0.3) {
  Surface_blend_options options;
  options.g2 = g2;
  options.correspondence.matching = Matching::parameter;
  options.sides[0].direction = lambda;
  options.sides[0].distance = Adjusting_function(Cosine_adjustment{0.5, 0.9});
  options.sides[1].distance = 0.7;
  options.on_fold = Fold_policy::ignore;
  const auto result = blend_surfaces(ellipse(2, 0), ellipse(1, 3), options);
  EXPECT_TRUE(result.ok()) << message(result.diagnosis);
  return *result.blend;
}

TEST(Surface_blend_fit, Keeps_the_tolerance) {
  for (const bool g2 : {false, true}) {
    const Surface_blend blend = make_blend(g2);
    std::size_t knots = 0;
    for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8}) {
      const auto surface = fit_bspline(blend, tolerance);
      ASSERT_TRUE(surface);
      EXPECT_EQ(surface->degree_t, g2 ? 5 : 3);
      EXPECT_LE(surface->error, tolerance);
      EXPECT_EQ(surface->control.size(), 2 * surface->knots.size());
      double worst = 0;
      for (int i = 0; i <= 500; ++i)
        for (int k = 0; k <= 7; ++k) {
          const double s = i / 500.0, t = k / 7.0;
          worst = std::max(worst, CGAL::squared_distance(surface->at(s, t), blend.at(s - (s == 1 ? 1 : 0), t)));
        }
      EXPECT_LT(std::sqrt(worst), 1.1 * tolerance);
      EXPECT_GE(surface->knots.size(), knots);
      knots = surface->knots.size();
      EXPECT_LT(surface->normal_error, 20 * std::pow(tolerance, 0.75));  // one order of derivative of four
    }
    EXPECT_GT(knots, 30u);  // fourth order: 10^6 in error is about 32 in knots
    EXPECT_LT(knots, 1500u);
  }
}

TEST(Surface_blend_fit, Writes_step_if_it_can) {
  const auto surface = fit_bspline(make_blend(false), 1e-4);
  const std::string path = (std::filesystem::temp_directory_path() / "cgal_blend_fit.step").string();
  std::filesystem::remove(path);
  if (!has_step()) {
    EXPECT_THROW(write_step(path, {*surface}), Mesh_io_error);
    EXPECT_FALSE(std::filesystem::exists(path));
    return;
  }
  write_step(path, {*surface, *surface});
  std::ifstream in(path);
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  std::filesystem::remove(path);
  EXPECT_EQ(text.rfind("ISO-10303-21;", 0), 0u);
  EXPECT_NE(text.find("AUTOMOTIVE_DESIGN"), std::string::npos);
  std::size_t faces = 0;
  for (std::size_t at = text.find("= B_SPLINE_SURFACE_WITH_KNOTS(''"); at != std::string::npos;
       at = text.find("= B_SPLINE_SURFACE_WITH_KNOTS(''", at + 1))
    ++faces;
  EXPECT_EQ(faces, 2u);
  EXPECT_THROW(write_step("/no/such/folder/x.step", {*surface}), Mesh_io_error);
}

}  // namespace
