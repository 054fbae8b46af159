// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/curvature.h>

#include "checks.h"
#include "shapes.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <vector>

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;
using Colour = std::array<unsigned char, 3>;

/// Curvatures in the order of the vertices.
template <class Graph>
std::vector<double> curvatures_of(const Graph& mesh) {
  std::unordered_map<typename boost::graph_traits<Graph>::vertex_descriptor, double> map;
  mean_curvature(mesh, boost::make_assoc_property_map(map));
  EXPECT_EQ(map.size(), num_vertices(mesh)) << "every vertex is written";
  std::vector<double> values;
  for (const auto v : vertices(mesh)) values.push_back(map.at(v));
  return values;
}

/// Largest distance of the curvatures from a closed form, over the vertices at which that is not NaN.
template <class Expected>
double worst_error(const Blend_mesh& mesh, const Expected& expected) {
  const std::vector<double> values = curvatures_of(mesh);
  double worst = 0;
  for (const Vertex v : mesh.vertices())
    if (const double wanted = expected(mesh.point(v)); !std::isnan(wanted))
      worst = std::max(worst, std::abs(values[v] - wanted));
  return worst;
}

constexpr double elsewhere = std::numeric_limits<double>::quiet_NaN();

double order(double coarse_error, double fine_error) { return std::log2(coarse_error / fine_error); }

template <class Graph>
class Curvature : public testing::Test {};

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Plain = CGAL::Simple_cartesian<double>;
using Graphs = testing::Types<Blend_mesh, CGAL::Polyhedron_3<Kernel>, CGAL::Surface_mesh<Exact::Point_3>,
                              CGAL::Polyhedron_3<Plain>>;
TYPED_TEST_SUITE(Curvature, Graphs);

TYPED_TEST(Curvature, OfASphere) {
  TypeParam mesh;
  CGAL::copy_face_graph(sphere(2, 3, {1, 2, 3}), mesh);
  for (const double value : curvatures_of(mesh)) EXPECT_NEAR(value, 0.5, 1e-3);
}

// Exact, as on the sphere: vertices on a cylinder, and mixed areas that are true Voronoi areas.
TEST(Curvature, OfACylinderBetweenItsRims) {
  const auto side = [](const Point_3& p) { return p.z() > 0 && p.z() < 20 ? 1 / (2 * 10.0) : elsewhere; };
  for (const int n : {16, 32, 128}) EXPECT_LT(worst_error(cylinder(10, n, 0, 20, n / 3), side), 1e-12) << n;
}

TEST(Curvature, OfATorusAtItsEquators) {
  constexpr double R = 3, r = 1;
  const auto equators = [](const Point_3& p) {
    if (std::abs(p.z()) > 1e-9) return elsewhere;
    const double rho = std::hypot(p.x(), p.y());
    return rho > R ? (1 / r + 1 / rho) / 2 : (1 / r - 1 / rho) / 2;
  };
  const auto everywhere = [](const Point_3& p) {
    const double rho = std::hypot(p.x(), p.y());
    return (1 / r + (rho - R) / (r * rho)) / 2;
  };
  std::vector<double> errors;
  for (const int n : {16, 32, 64}) errors.push_back(worst_error(torus(R, r, 3 * n, n), equators));
  EXPECT_LT(errors[2], 2e-3);
  EXPECT_GT(order(errors[0], errors[1]), 1.8);
  EXPECT_GT(order(errors[1], errors[2]), 1.8);
  EXPECT_LT(worst_error(torus(R, r, 192, 64), everywhere), 0.02);
}

TEST(Curvature, OfPlanesEdgesAndCorners) {
  const Blend_mesh mesh = grid_box({0, 0, 0}, {1, 1, 1}, 8);
  const std::vector<double> values = curvatures_of(mesh);
  for (const Vertex v : mesh.vertices()) {
    int sides = 0;
    for (int i = 0; i < 3; ++i) sides += mesh.point(v)[i] == 0 || mesh.point(v)[i] == 1;
    if (sides == 1)
      EXPECT_NEAR(values[v], 0, 1e-12);
    else
      EXPECT_GT(values[v], 1) << "creases and corners stand out";
  }
  const Blend_mesh bracket = l_bracket(4, 1, 2);
  EXPECT_LT(curvatures_of(inside_out(mesh))[0], 0);
  EXPECT_EQ(std::count_if(values.begin(), values.end(), [](double value) { return value < -1e-12; }), 0);
  EXPECT_GT(curvatures_of(bracket)[3], 0);
}

// At a crease between two planes the formula gives sin(half the angle) per area, so it grows with refinement.
TEST(Curvature, OfACreaseGrowsWithRefinement) {
  const auto at_an_edge = [](int n) {
    const Blend_mesh mesh = grid_box({0, 0, 0}, {1, 1, 1}, n);
    const std::vector<double> values = curvatures_of(mesh);
    for (const Vertex v : mesh.vertices())
      if (mesh.point(v) == Point_3(0.5, 0, 0)) return values[v];
    return elsewhere;
  };
  EXPECT_NEAR(at_an_edge(8), std::sqrt(0.5) * 8, 0.2 * 8);
  EXPECT_NEAR(at_an_edge(32) / at_an_edge(8), 4, 1e-9);
}

TEST(Curvature, ChangesSignWithTheOrientation) {
  const Blend_mesh mesh = torus(2, 0.7, 24, 12);
  std::vector<double> turned = curvatures_of(inside_out(mesh));
  const std::vector<double> values = curvatures_of(mesh);
  for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(turned[i], -values[i], 1e-12 * std::abs(values[i]));
}

TEST(Curvature, FollowsMotionAndScale) {
  const Blend_mesh mesh = torus(2, 0.7, 24, 12);
  const std::vector<double> values = curvatures_of(mesh);
  for (const double scale : {1e-3, 1.0, 1e6}) {
    const std::vector<double> moved =
        curvatures_of(transformed(mesh, placement({1, 2, 3}, 0.7, {scale, -scale, 5 * scale}, scale)));
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(scale * moved[i], values[i], 1e-9);
  }
}

TEST(Curvature, IsZeroAtBordersAndWithoutArea) {
  Blend_mesh fan =
      mesh_of({{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}});
  fan.add_vertex({5, 5, 5});
  const std::vector<double> values = curvatures_of(fan);
  EXPECT_GT(values[0], 0) << "the apex is no border vertex";
  for (std::size_t i = 1; i < values.size(); ++i) EXPECT_EQ(values[i], 0) << i;
  for (const double value : curvatures_of(
           mesh_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}})))
    EXPECT_EQ(value, 0);
}

TEST(Curvature, SkipsFacesWithoutArea) {
  // A vertex in the middle of an edge makes a face of no area; its neighbours' values stay finite.
  Blend_mesh mesh = mesh_of({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 0, 0}},
                            {{0, 2, 1}, {0, 1, 4}, {0, 4, 3}, {4, 1, 3}, {1, 2, 3}, {0, 3, 2}});
  for (const double value : curvatures_of(mesh)) EXPECT_GT(value, 0);
}

TEST(Curvature, OtherPointMap) {
  Blend_mesh mesh = sphere(1, 3);
  auto larger = mesh.add_property_map<Vertex, Point_3>("v:larger").first;
  for (const Vertex v : mesh.vertices()) larger[v] = CGAL::ORIGIN + 4 * (mesh.point(v) - CGAL::ORIGIN);
  auto values = mesh.add_property_map<Vertex, double>("v:curvature").first;
  mean_curvature(mesh, values, CGAL::parameters::vertex_point_map(larger));
  for (const Vertex v : mesh.vertices()) EXPECT_NEAR(values[v], 0.25, 1e-3);
}

TEST(Colour_scale, BlueOverWhiteToRed) {
  const Colour red = colour_scale(2, 2), blue = colour_scale(-2, 2), white{255, 255, 255};
  EXPECT_EQ(colour_scale(0, 2), white);
  EXPECT_GT(red[0], red[2]);
  EXPECT_GT(blue[2], blue[0]);
  EXPECT_EQ(colour_scale(1e300, 2), red);
  EXPECT_EQ(colour_scale(-std::numeric_limits<double>::infinity(), 2), blue);
  EXPECT_EQ(colour_scale(elsewhere, 2), white);
  for (double value = 0; value < 2; value += 0.1) {
    EXPECT_GE(colour_scale(value, 2)[1], colour_scale(value + 0.1, 2)[1]) << "ever less white";
    EXPECT_GE(colour_scale(-value, 2)[1], colour_scale(-value - 0.1, 2)[1]);
    EXPECT_EQ(colour_scale(value, 2), colour_scale(10 * value, 20));
  }
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(colour_scale(1, 2)[i], (255 + red[i]) / 2.0, 0.5);
  EXPECT_EQ(colour_scale(0, 0), white);
  EXPECT_EQ(colour_scale(1e-9, 0), red);
}

TEST(Colour_scale, LimitLeavesExtremesOut) {
  std::vector<double> values;
  for (int i = 1; i <= 100; ++i) values.push_back(i % 2 == 0 ? i : -i);
  EXPECT_EQ(robust_limit(values), 95);
  values[99] = 1e8;
  EXPECT_EQ(robust_limit(values), 95);
  values.insert(values.end(), 10000, 1e-9);  // flat parts, rounding and all
  EXPECT_EQ(robust_limit(values), 95);
  EXPECT_EQ(robust_limit({-3}), 3);
  EXPECT_EQ(robust_limit({0, 0}), 0);
  EXPECT_EQ(robust_limit({}), 0);
}

}  // namespace
