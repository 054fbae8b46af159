// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/bridge.h>

#include "bridge_spheres.h"
#include "checks.h"
#include "graphs.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

// The geometry of bridges is tested elsewhere; here, that every mesh type gives what `Blend_mesh` gives.

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;

template <class Graph>
class Bridge_graphs : public testing::Test {};

using Graphs = testing::Types<CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>,
                              CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3>,
                              CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>,
                              CGAL::Polyhedron_3<CGAL::Exact_predicates_inexact_constructions_kernel>>;
TYPED_TEST_SUITE(Bridge_graphs, Graphs);

TYPED_TEST(Bridge_graphs, give_the_same_bridges) {
  const Two_spheres spheres;
  const Blend_mesh mesh = spheres.mesh(3);
  Blend_mesh expected;
  const Bridge_outcome outcome = unchecked::bridge(mesh, spheres.ends(), expected);
  ASSERT_TRUE(outcome.ok());
  const TypeParam graph = graph_of<TypeParam>(mesh);
  TypeParam out;
  const auto result = bridge(graph, spheres.ends(), out);
  ASSERT_TRUE(result.ok()) << message(result.diagnosis);
  EXPECT_TRUE(identical(blend_mesh_of(out), expected));
  ASSERT_EQ(result.bridge_faces.size(), 1u);
  EXPECT_EQ(result.bridge_faces[0].size(), outcome.bridge_faces[0].size());
  EXPECT_EQ(result.kept_faces, outcome.kept_faces);
  EXPECT_EQ(result.volume, outcome.volume);

  const TypeParam a = graph_of<TypeParam>(sphere(1, 3)), b = graph_of<TypeParam>(sphere(0.8, 3, {0, 0, 2.6}));
  TypeParam joined;
  ASSERT_TRUE(bridge_bodies(a, b, spheres.ends(), joined).ok());
  EXPECT_EQ(euler(blend_mesh_of(joined)), 2);
}

TEST(Bridge_graphs, check_their_input) {
  const Blend_mesh good = sphere(1, 2);
  Blend_mesh out = box({0, 0, 0}, {1, 1, 1});
  const Blend_mesh before = out;
  const auto inside_out_body = bridge_bodies(good, inside_out(sphere(0.8, 2, {0, 0, 3})), Two_spheres().ends(), out);
  EXPECT_EQ(inside_out_body.diagnosis.status, Status::input_misoriented);
  EXPECT_EQ(inside_out_body.diagnosis.detail.rfind("second body", 0), 0u) << inside_out_body.diagnosis.detail;
  const auto crossing = bridge(side_by_side(good, sphere(1, 2, {0, 0, 0.5})), Two_spheres().ends(), out);
  EXPECT_EQ(crossing.diagnosis.status, Status::input_self_intersecting);
  EXPECT_TRUE(identical(out, before));
}

}  // namespace
