// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/creases.h>

#include "shapes.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <gtest/gtest.h>

#include <unordered_map>

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;

template <class Graph>
Graph copied(const Blend_mesh& mesh) {
  Graph copy;
  CGAL::copy_face_graph(mesh, copy);
  return copy;
}

template <class Graph>
std::size_t number_of_creases(const Graph& mesh, double angle) {
  std::unordered_map<typename boost::graph_traits<Graph>::edge_descriptor, bool> marks;
  const std::size_t count = detect_creases(mesh, angle, boost::make_assoc_property_map(marks));
  std::size_t marked = 0;
  for (const auto& [edge, mark] : marks) marked += mark ? 1 : 0;
  EXPECT_EQ(marks.size(), num_edges(mesh)) << "every edge is written";
  EXPECT_EQ(marked, count);
  return count;
}

template <class Graph>
std::size_t number_of_edges(const Graph& mesh, CGAL::Sign convexity) {
  std::size_t count = 0;
  for (auto e : edges(mesh)) count += edge_convexity(e, mesh) == convexity ? 1 : 0;
  return count;
}

template <class Graph>
class Creases : public testing::Test {};

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Plain = CGAL::Simple_cartesian<double>;
using Graphs = testing::Types<Blend_mesh, CGAL::Polyhedron_3<Kernel>, CGAL::Surface_mesh<Exact::Point_3>,
                              CGAL::Surface_mesh<Plain::Point_3>, CGAL::Polyhedron_3<Plain>>;
TYPED_TEST_SUITE(Creases, Graphs);

TYPED_TEST(Creases, BoxHasTwelve) {
  const auto mesh = copied<TypeParam>(box({0, 0, 0}, {1, 2, 3}));
  EXPECT_EQ(number_of_creases(mesh, 1), 12u);
  EXPECT_EQ(number_of_creases(mesh, 89.999999), 12u);
  EXPECT_EQ(number_of_creases(mesh, 90), 0u) << "the angle is exclusive, and exact for right angles";
  EXPECT_EQ(number_of_creases(mesh, 120), 0u);
}

TYPED_TEST(Creases, ConvexConcaveFlat) {
  const auto bracket = copied<TypeParam>(l_bracket(4, 1, 2));
  EXPECT_EQ(number_of_edges(bracket, CGAL::NEGATIVE), 1u);
  EXPECT_EQ(number_of_edges(bracket, CGAL::POSITIVE), 17u);
  EXPECT_EQ(number_of_edges(bracket, CGAL::ZERO), num_edges(bracket) - 18u);
  std::size_t convex = 0;
  for (auto e : edges(bracket)) convex += is_convex_edge(e, bracket) ? 1 : 0;
  EXPECT_EQ(convex, 17u);
}

TEST(Creases, CylinderRimsAndFacets) {
  const Blend_mesh mesh = cylinder(10, 64, 0, 20);  // its facets turn by 5.625 degrees
  EXPECT_EQ(number_of_creases(mesh, 40), 128u);
  EXPECT_EQ(number_of_creases(mesh, 5.7), 128u);
  EXPECT_EQ(number_of_creases(mesh, 5.5), 192u);
}

// A ridge over a base, its slopes meeting at a known angle.
Blend_mesh ridge(double degrees) {
  const double half = degrees / 2 * pi / 180;
  return prism({{-std::cos(half), 0}, {std::cos(half), 0}, {0, std::sin(half)}}, 0, 1);
}

TEST(Creases, DecidedCloseToTheAngle) {
  for (const double angle : {0.01, 1.0, 25.0, 60.0, 90.0, 119.0}) {
    const Blend_mesh mesh = ridge(angle);
    const Edge top = mesh.edge(mesh.halfedge(Vertex(2), Vertex(5)));
    EXPECT_TRUE(is_crease(top, mesh, angle - 1e-6)) << angle;
    EXPECT_FALSE(is_crease(top, mesh, angle + 1e-6)) << angle;
  }
}

TEST(Creases, RigidMotionAndScale) {
  const Placement turn = placement({1, 2, 3}, 0.7, {100, -50, 7});
  for (const double scale : {1e-3, 1.0, 1e6}) {
    const Blend_mesh mesh = transformed(box({0, 0, 0}, {scale, scale, scale}), turn);
    EXPECT_EQ(number_of_creases(mesh, 89), 12u) << scale;
    EXPECT_EQ(number_of_creases(mesh, 91), 0u) << scale;
  }
}

TEST(Creases, NeedleFaces) {
  // Normals of such faces in floating point are noise; the decision is not.
  const Blend_mesh thin = box({0, 0, 0}, {1, 1e-12, 1});
  EXPECT_EQ(number_of_creases(thin, 89.9), 12u);
  EXPECT_EQ(number_of_creases(thin, 90), 0u);
}

TEST(Creases, ExactConvexity) {
  const double least = 1e-300;
  for (const double lift : {-least, 0.0, least}) {
    const Blend_mesh mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, -1, lift}}, {{0, 1, 2}, {1, 0, 3}});
    const Halfedge h = mesh.halfedge(Vertex(0), Vertex(1));
    EXPECT_EQ(edge_convexity(mesh.edge(h), mesh), lift < 0 ? CGAL::POSITIVE : lift > 0 ? CGAL::NEGATIVE : CGAL::ZERO);
  }
}

TEST(Creases, FoldedBackIsACrease) {
  const Blend_mesh mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, 2, 0}}, {{0, 1, 2}, {1, 0, 3}});
  EXPECT_EQ(number_of_creases(mesh, 179), 1u);
}

TEST(Creases, BordersAndFlatFacesHaveNone) {
  const Blend_mesh open = mesh_of({{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, 0, 1}}, {{0, 1, 2}, {1, 0, 3}});
  EXPECT_EQ(number_of_creases(open, 30), 1u);
  const Blend_mesh without_area = mesh_of({{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, 0, 0}}, {{0, 1, 2}, {1, 0, 3}});
  EXPECT_EQ(number_of_creases(without_area, 30), 0u);
}

TEST(Creases, OtherPointMap) {
  Blend_mesh mesh = box({0, 0, 0}, {1, 1, 1});
  auto sheared = mesh.add_property_map<Vertex, Point_3>("v:sheared").first;
  for (Vertex v : mesh.vertices()) {
    const Point_3& p = mesh.point(v);
    sheared[v] = Point_3(p.x() + p.z(), p.y(), p.z());
  }
  std::size_t count = 0;
  for (Edge e : mesh.edges()) count += is_crease(e, mesh, 95, CGAL::parameters::vertex_point_map(sheared)) ? 1 : 0;
  EXPECT_EQ(count, 2u) << "the two edges at which the sheared box is sharper than square";
}

}  // namespace
