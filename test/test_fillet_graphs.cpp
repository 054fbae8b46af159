// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/fillet.h>

#include "checks.h"
#include "graphs.h"
#include "shapes.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <vector>

// The geometry of blends is tested elsewhere; here, that every mesh type gives what `Blend_mesh` gives.

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using Cartesian = CGAL::Simple_cartesian<double>;

constexpr double boss_radius = 1, ball_radius = 0.2;

Blend_mesh boss() { return cylinder(boss_radius, 48, -0.5, 2); }

Fillet_options ball(double radius) {
  Fillet_options options;
  options.radius = radius;
  return options;
}

/// The edges of the upper rim of the boss.
template <class Graph>
std::vector<typename boost::graph_traits<Graph>::edge_descriptor> upper_rim(const Graph& graph) {
  const auto points = get(CGAL::vertex_point, graph);
  const auto on_rim = [&](auto v) {
    return get(points, v).z() == 2 && (get(points, v).x() != 0 || get(points, v).y() != 0);
  };
  std::vector<typename boost::graph_traits<Graph>::edge_descriptor> rim;
  for (const auto e : edges(graph))
    if (on_rim(source(e, graph)) && on_rim(target(e, graph))) rim.push_back(e);
  return rim;
}

template <class Graph>
class Fillet_graphs : public ::testing::Test {};

using Graphs = ::testing::Types<CGAL::Surface_mesh<Epick::Point_3>, CGAL::Surface_mesh<Epeck::Point_3>,
                                CGAL::Surface_mesh<Cartesian::Point_3>, CGAL::Polyhedron_3<Epick>,
                                CGAL::Polyhedron_3<Epeck>, CGAL::Polyhedron_3<Cartesian>>;
TYPED_TEST_SUITE(Fillet_graphs, Graphs);

TYPED_TEST(Fillet_graphs, A_boolean_with_blend_is_that_of_the_concrete_mesh) {
  Blend_mesh expected;
  const Fillet_outcome outcome =
      unchecked::corefine_and_fillet(plate(3, 1), boss(), Boolean_operation::union_, expected, ball(ball_radius));
  ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);

  const auto a = graph_of<TypeParam>(plate(3, 1)), b = graph_of<TypeParam>(boss());
  TypeParam out;
  const auto result = corefine_and_fillet(a, b, Boolean_operation::union_, out, ball(ball_radius));
  ASSERT_TRUE(result.ok()) << message(result.diagnosis);
  EXPECT_TRUE(identical(blend_mesh_of(out), expected));
  EXPECT_EQ(result.volume, outcome.volume);
  EXPECT_EQ(result.kept_faces, outcome.kept_faces);
  EXPECT_EQ(result.changed_faces.size(), outcome.changed_faces.size());
  EXPECT_EQ(result.blends.size(), 1u);

  // The descriptors are those of the output: the corners of blend faces lie on the torus of the ball's path.
  ASSERT_EQ(result.blend_faces.size(), outcome.blend_faces.size());
  const auto points = get(CGAL::vertex_point, out);
  for (const auto f : result.blend_faces)
    for (const auto v : vertices_around_face(halfedge(f, out), out)) {
      const auto& p = get(points, v);
      const Point_3 q(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
      EXPECT_NEAR(distance_to_torus(q, {0, 0, ball_radius}, {0, 0, 1}, boss_radius + ball_radius, ball_radius), 0,
                  0.01);
    }
}

TYPED_TEST(Fillet_graphs, Blended_edges_are_those_of_the_concrete_mesh) {
  const Blend_mesh concrete = boss();
  Blend_mesh expected;
  const Fillet_outcome outcome = unchecked::fillet_edges(concrete, {{upper_rim(concrete), 0}}, expected, ball(ball_radius));
  ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);

  auto graph = graph_of<TypeParam>(concrete);
  ASSERT_EQ(upper_rim(graph).size(), 48u);
  TypeParam out;
  const auto result = fillet_edges(graph, {{upper_rim(graph), ball_radius}}, out, Fillet_options());
  ASSERT_TRUE(result.ok()) << message(result.diagnosis);
  EXPECT_TRUE(identical(blend_mesh_of(out), expected));

  const auto in_place = fillet_edges(graph, {{upper_rim(graph), ball_radius}}, graph, Fillet_options());
  ASSERT_TRUE(in_place.ok());
  EXPECT_TRUE(identical(blend_mesh_of(graph), expected));
}

TYPED_TEST(Fillet_graphs, Points_may_live_in_maps) {
  using Vertex_descriptor = typename boost::graph_traits<TypeParam>::vertex_descriptor;
  auto graph = graph_of<TypeParam>(boss());
  const auto rim = upper_rim(graph);
  std::map<Vertex_descriptor, Epick::Point_3> tenfold, written;
  for (const auto v : vertices(graph)) {
    const auto& p = get(CGAL::vertex_point, graph, v);
    tenfold[v] = Epick::Point_3(10 * CGAL::to_double(p.x()), 10 * CGAL::to_double(p.y()), 10 * CGAL::to_double(p.z()));
  }
  TypeParam out;
  const auto result = fillet_edges(graph, {{rim, 10 * ball_radius}}, out, Fillet_options(),
                                   CGAL::parameters::vertex_point_map(boost::make_assoc_property_map(tenfold)),
                                   CGAL::parameters::vertex_point_map(boost::make_assoc_property_map(written)));
  ASSERT_TRUE(result.ok()) << message(result.diagnosis);
  EXPECT_EQ(written.size(), num_vertices(out));
  Blend_mesh expected;
  const Blend_mesh concrete = boss();
  ASSERT_TRUE(fillet_edges(concrete, {{upper_rim(concrete), ball_radius}}, expected, Fillet_options()).ok());
  EXPECT_NEAR(result.volume, 1000 * volume_of(expected), 1e-6 * result.volume);
}

TYPED_TEST(Fillet_graphs, A_bad_input_is_refused_by_name_and_the_output_left_alone) {
  Blend_mesh open = boss();
  CGAL::Euler::remove_face(open.halfedge(Face(0)), open);
  const auto good = graph_of<TypeParam>(plate(3, 1)), bad = graph_of<TypeParam>(open);
  auto out = graph_of<TypeParam>(sphere(1, 1));
  const auto result = corefine_and_fillet(good, bad, Boolean_operation::union_, out, ball(ball_radius));
  EXPECT_EQ(result.diagnosis.status, Status::input_not_closed);
  EXPECT_EQ(result.diagnosis.detail.rfind("second body: ", 0), 0u) << result.diagnosis.detail;
  EXPECT_TRUE(identical(blend_mesh_of(out), sphere(1, 1)));
  EXPECT_EQ(fillet_edges(bad, {{upper_rim(bad), 0}}, out, ball(ball_radius)).diagnosis.status,
            Status::input_not_closed);
}

TYPED_TEST(Fillet_graphs, The_check_of_the_input_can_be_left_out) {
  // A defect far from the blend, which only the check of the whole input would notice.
  const Blend_mesh crossing = side_by_side(box({8, 8, 8}, {10, 10, 10}), box({9, 9, 9}, {11, 11, 11}));
  const auto graph = graph_of<TypeParam>(side_by_side(boss(), crossing));
  TypeParam out;
  const auto checked = fillet_edges(graph, {{upper_rim(graph), 0}}, out, ball(ball_radius));
  EXPECT_EQ(checked.diagnosis.status, Status::input_self_intersecting);
  const auto trusted = fillet_edges(graph, {{upper_rim(graph), 0}}, out, {ball(ball_radius), Input_check::none});
  EXPECT_TRUE(trusted.ok()) << message(trusted.diagnosis);
}

TYPED_TEST(Fillet_graphs, A_series_of_booleans_is_that_of_the_concrete_mesh) {
  const Blend_mesh first = boss(), second = transformed(boss(), moved_by(-1.5, 0.1, 0.3));
  Blend_mesh expected;
  constexpr auto unite = Boolean_operation::union_, cut = Boolean_operation::difference;
  const Fillet_outcome outcome = unchecked::corefine_and_fillet_all(
      plate(4, 1), {{&first, unite, ball_radius}, {&second, cut, 0}}, expected, ball(0));
  ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
  const auto a = graph_of<TypeParam>(plate(4, 1)), b = graph_of<TypeParam>(first), c = graph_of<TypeParam>(second);
  const std::vector<Part_of<TypeParam>> parts{{&b, unite, ball_radius}, {&c, cut, 0}};
  TypeParam out;
  const auto result = corefine_and_fillet_all(a, parts, out, ball(0));
  ASSERT_TRUE(result.ok()) << message(result.diagnosis);
  EXPECT_TRUE(identical(blend_mesh_of(out), expected));
  EXPECT_EQ(result.kept_faces, outcome.kept_faces);

  Blend_mesh open = boss();
  CGAL::Euler::remove_face(open.halfedge(Face(0)), open);
  const auto bad = graph_of<TypeParam>(open);
  const std::vector<Part_of<TypeParam>> bad_parts{{&b, unite, 0}, {&bad, unite, 0}};
  const auto refused = corefine_and_fillet_all(a, bad_parts, out, ball(0));
  EXPECT_EQ(refused.diagnosis.status, Status::input_not_closed);
  EXPECT_EQ(refused.diagnosis.detail.rfind("part 2: ", 0), 0u) << refused.diagnosis.detail;
  EXPECT_TRUE(identical(blend_mesh_of(out), expected)) << "left as it was";
}

TEST(Fillet_graphs_mixed, Types_may_differ) {
  const auto a = graph_of<CGAL::Polyhedron_3<Epick>>(plate(3, 1));
  const auto b = graph_of<CGAL::Surface_mesh<Epeck::Point_3>>(boss());
  CGAL::Surface_mesh<Cartesian::Point_3> out;
  const auto result = corefine_and_fillet(a, b, Boolean_operation::union_, out, ball(0));
  ASSERT_TRUE(result.ok()) << message(result.diagnosis);
  EXPECT_TRUE(is_closed_by_counting(blend_mesh_of(out)));
  EXPECT_NEAR(result.volume, 36 + 2 * volume_of(cylinder(boss_radius, 48, 0, 1)), 1e-9);
}

}  // namespace
