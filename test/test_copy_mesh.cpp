// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/internal/copy_mesh.h>

#include "checks.h"
#include "shapes.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <map>

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;
using CGAL::parameters::default_values;

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using Cartesian = CGAL::Simple_cartesian<double>;

template <class Graph>
class Copy_mesh : public ::testing::Test {};

using Graphs =
    ::testing::Types<CGAL::Surface_mesh<Epick::Point_3>, CGAL::Surface_mesh<Epeck::Point_3>,
                     CGAL::Surface_mesh<Cartesian::Point_3>, CGAL::Polyhedron_3<Epick>, CGAL::Polyhedron_3<Epeck>,
                     CGAL::Polyhedron_3<Cartesian>, CGAL::Polyhedron_3<Epick, CGAL::Polyhedron_items_with_id_3>>;
TYPED_TEST_SUITE(Copy_mesh, Graphs);

Blend_mesh awkward_mesh() {
  return transformed(torus(2, 0.7, 12, 8), placement({1, 2, 3}, 0.7, {1e3, -1e-3, 0.1}, 1.0 / 3));
}

TYPED_TEST(Copy_mesh, Round_trip_is_exact_and_keeps_order) {
  const Blend_mesh mesh = awkward_mesh();
  TypeParam graph;
  (void)internal::copy_out(mesh, graph, default_values());
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(graph));
  EXPECT_TRUE(CGAL::is_closed(graph));
  const internal::Mesh_copy<TypeParam> copy(graph, default_values());
  EXPECT_TRUE(copy.mesh().is_valid(false));
  EXPECT_TRUE(identical(copy.mesh(), mesh));
  for (const Face f : mesh.faces()) EXPECT_EQ(corners_of(copy.mesh(), f), corners_of(mesh, f));
}

TYPED_TEST(Copy_mesh, Descriptors_lead_there_and_back) {
  TypeParam graph;
  (void)internal::copy_out(awkward_mesh(), graph, default_values());
  const internal::Mesh_copy<TypeParam> copy(graph, default_values());
  std::uint32_t i = 0;
  for (const auto v : vertices(graph)) {
    EXPECT_EQ(copy.copy_of_vertex(v).idx(), i++);
    EXPECT_EQ(copy.original(copy.copy_of_vertex(v)), v);
  }
  i = 0;
  for (const auto f : faces(graph)) {
    EXPECT_EQ(copy.copy_of_face(f).idx(), i++);
    EXPECT_EQ(copy.original(copy.copy_of_face(f)), f);
  }
  const auto points = get(CGAL::vertex_point, graph);
  for (const auto e : edges(graph)) {
    const Edge c = copy.copy_of_edge(e);
    EXPECT_EQ(copy.original(c), e);
    EXPECT_EQ(copy.mesh().point(source(c, copy.mesh())).x(), CGAL::to_double(get(points, source(e, graph)).x()));
    EXPECT_EQ(copy.mesh().point(target(c, copy.mesh())).x(), CGAL::to_double(get(points, target(e, graph)).x()));
  }
}

TYPED_TEST(Copy_mesh, Copying_out_tells_what_became_of_each_element) {
  const Blend_mesh mesh = awkward_mesh();
  TypeParam graph;
  const auto maps = internal::copy_out(mesh, graph, default_values());
  const auto points = get(CGAL::vertex_point, graph);
  for (const Vertex v : mesh.vertices())
    EXPECT_EQ(CGAL::to_double(get(points, maps.vertices.at(v)).y()), mesh.point(v).y());
  for (const Halfedge h : mesh.halfedges()) {
    EXPECT_EQ(target(maps.halfedges.at(h), graph), maps.vertices.at(mesh.target(h)));
    EXPECT_EQ(face(maps.halfedges.at(h), graph), maps.faces.at(mesh.face(h)));
  }
}

TYPED_TEST(Copy_mesh, Uses_the_vertex_point_map_of_the_parameters) {
  using Vertex_descriptor = typename boost::graph_traits<TypeParam>::vertex_descriptor;
  TypeParam graph;
  (void)internal::copy_out(awkward_mesh(), graph, default_values());
  std::map<Vertex_descriptor, Epick::Point_3> elsewhere;
  double x = 0;
  for (const auto v : vertices(graph)) elsewhere[v] = Epick::Point_3(x++, 1, 2);
  const auto np = CGAL::parameters::vertex_point_map(boost::make_assoc_property_map(elsewhere));
  const internal::Mesh_copy<TypeParam> copy(graph, np);
  for (const Vertex v : copy.mesh().vertices()) EXPECT_EQ(copy.mesh().point(v), Point_3(v.idx(), 1, 2));

  std::map<Vertex_descriptor, Epick::Point_3> written;
  const auto out_np = CGAL::parameters::vertex_point_map(boost::make_assoc_property_map(written));
  const auto maps = internal::copy_out(copy.mesh(), graph, out_np);
  for (const Vertex v : copy.mesh().vertices()) EXPECT_EQ(written.at(maps.vertices.at(v)), Point_3(v.idx(), 1, 2));
}

TYPED_TEST(Copy_mesh, Keeps_holes_and_replaces_what_was_there) {
  Blend_mesh open = sphere(1, 2);
  CGAL::Euler::remove_face(open.halfedge(Face(7)), open);
  CGAL::Euler::remove_face(open.halfedge(Face(100)), open);
  TypeParam graph;
  (void)internal::copy_out(awkward_mesh(), graph, default_values());
  (void)internal::copy_out(open, graph, default_values());
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(graph));
  EXPECT_EQ(faces(graph).size(), open.number_of_faces());
  std::size_t border = 0;
  for (const auto h : halfedges(graph)) border += is_border(h, graph);
  EXPECT_EQ(border, 6u);
  const internal::Mesh_copy<TypeParam> copy(graph, default_values());
  EXPECT_TRUE(copy.mesh().is_valid(false));
  EXPECT_EQ(copy.mesh().number_of_faces(), open.number_of_faces());
}

TEST(Copy_mesh_of_surface_mesh, Skips_removed_elements) {
  Blend_mesh mesh = side_by_side(box({0, 0, 0}, {1, 1, 1}), awkward_mesh());
  for (std::uint32_t f = 0; f < 12; ++f) CGAL::Euler::remove_face(mesh.halfedge(Face(f)), mesh);
  ASSERT_TRUE(mesh.has_garbage());
  const internal::Mesh_copy<Blend_mesh> copy(mesh, default_values());
  EXPECT_FALSE(copy.mesh().has_garbage());
  EXPECT_TRUE(identical(copy.mesh(), awkward_mesh()));
  EXPECT_EQ(copy.original(Face(0)).idx(), 12u);
  EXPECT_EQ(copy.copy_of_vertex(Vertex(8)), Vertex(0));
}

TEST(Copy_mesh_of_surface_mesh, Keeps_vertices_without_faces_and_property_maps) {
  Blend_mesh mesh;
  mesh.add_vertex(Point_3(7, 7, 7));
  mesh = side_by_side(mesh, box({0, 0, 0}, {1, 1, 1}));
  Blend_mesh out;
  auto colour = out.add_property_map<Face, int>("f:colour", 5).first;
  (void)internal::copy_out(mesh, out, default_values());
  EXPECT_EQ(out.point(Vertex(0)), Point_3(7, 7, 7));
  EXPECT_TRUE(out.is_isolated(Vertex(0)));
  EXPECT_EQ(colour[Face(11)], 5);
}

TEST(Copy_mesh_of_exact_points, Equal_numbers_become_equal_doubles) {
  // One third, once directly and once the long way round: the lazy intervals differ, the numbers do not.
  const Epeck::FT third = Epeck::FT(1) / 3;
  Epeck::FT detour = third;
  for (int i = 1; i <= 200; ++i) detour = (detour * (i + 7) + i) / (i + 1);
  for (int i = 200; i >= 1; --i) detour = (detour * (i + 1) - i) / (i + 7);
  ASSERT_NE(CGAL::to_interval(third), CGAL::to_interval(detour));
  EXPECT_EQ(internal::rounded(third), internal::rounded(detour));
  EXPECT_NEAR(internal::rounded(detour), 1.0 / 3, 1e-16);
}

#ifndef CGAL_NO_PRECONDITIONS
#ifndef NDEBUG
TEST(Copy_mesh_of_surface_mesh, Refuses_faces_that_are_not_triangles) {
  Blend_mesh quad;
  const Vertex a = quad.add_vertex(Point_3(0, 0, 0)), b = quad.add_vertex(Point_3(1, 0, 0)),
               c = quad.add_vertex(Point_3(1, 1, 0)), d = quad.add_vertex(Point_3(0, 1, 0));
  quad.add_face(a, b, c, d);
  const auto behaviour = CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION);
  const auto handler = CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {});
  EXPECT_THROW(internal::Mesh_copy<Blend_mesh>(quad, default_values()), CGAL::Precondition_exception);
  CGAL::set_error_handler(handler);
  CGAL::set_error_behaviour(behaviour);
}
#endif
#endif

}  // namespace
