// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/creases.h>
#include <cgal_blend/curve_network.h>
#include <cgal_blend/polyline.h>
#include <cgal_blend/selection.h>

#include "shapes.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <sstream>

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;

using Polyhedron = CGAL::Polyhedron_3<Kernel>;

template <class Graph>
auto creases_of(const Graph& mesh, double angle = 40) {
  std::vector<typename boost::graph_traits<Graph>::edge_descriptor> found;
  for (auto e : edges(mesh))
    if (is_crease(e, mesh, angle)) found.push_back(e);
  return found;
}

/// What every network keeps to, whatever the edges.
template <class Graph, class Edges>
void expect_consistent(const Graph& mesh, const Curve_network<Graph>& network, const Edges& selected) {
  std::vector<typename boost::graph_traits<Graph>::edge_descriptor> used;
  for (std::size_t b = 0; b < network.branches.size(); ++b) {
    const auto& branch = network.branches[b];
    ASSERT_FALSE(branch.halfedges.empty());
    for (std::size_t i = 0; i < branch.halfedges.size(); ++i) {
      used.push_back(edge(branch.halfedges[i], mesh));
      if (i > 0) {
        EXPECT_EQ(target(branch.halfedges[i - 1], mesh), source(branch.halfedges[i], mesh));
      }
    }
    const auto first = source(branch.halfedges.front(), mesh), last = target(branch.halfedges.back(), mesh);
    if (branch.closed()) {
      EXPECT_EQ(first, last);
      continue;
    }
    EXPECT_EQ(network.nodes[branch.first_node].vertex, first);
    EXPECT_EQ(network.nodes[branch.last_node].vertex, last);
    for (const std::size_t n : {branch.first_node, branch.last_node})
      EXPECT_NE(std::count(network.nodes[n].branches.begin(), network.nodes[n].branches.end(), b), 0);
  }
  const std::set<typename boost::graph_traits<Graph>::edge_descriptor> once(used.begin(), used.end());
  EXPECT_EQ(once.size(), used.size()) << "no edge in two branches";
  EXPECT_EQ(once, (std::set<typename boost::graph_traits<Graph>::edge_descriptor>(selected.begin(), selected.end())));
}

bool same(const Curve_network<Blend_mesh>& a, const Curve_network<Blend_mesh>& b) {
  if (a.branches.size() != b.branches.size() || a.nodes.size() != b.nodes.size()) return false;
  for (std::size_t i = 0; i < a.branches.size(); ++i)
    if (a.branches[i].halfedges != b.branches[i].halfedges) return false;
  for (std::size_t i = 0; i < a.nodes.size(); ++i)
    if (a.nodes[i].vertex != b.nodes[i].vertex || a.nodes[i].branches != b.nodes[i].branches) return false;
  return true;
}

template <class Graph>
class Curve_networks : public testing::Test {
 protected:
  static Graph copied(const Blend_mesh& mesh) {
    Graph copy;
    CGAL::copy_face_graph(mesh, copy);
    return copy;
  }
};
using Graphs = testing::Types<Blend_mesh, Polyhedron>;
TYPED_TEST_SUITE(Curve_networks, Graphs);

TYPED_TEST(Curve_networks, RimsAreClosedBranches) {
  const auto mesh = this->copied(cylinder(5, 24, 0, 10));
  const auto selected = creases_of(mesh);
  const auto network = make_curve_network(mesh, selected);
  expect_consistent(mesh, network, selected);
  EXPECT_TRUE(network.nodes.empty());
  ASSERT_EQ(network.branches.size(), 2u);
  for (const auto& branch : network.branches) {
    EXPECT_TRUE(branch.closed());
    EXPECT_EQ(branch.halfedges.size(), 24u);
  }
  EXPECT_EQ(network.branches[0].halfedges[0], halfedge(selected[0], mesh))
      << "starts at the first edge, along its halfedge";
}

TYPED_TEST(Curve_networks, BoxHasEightCorners) {
  const auto mesh = this->copied(box({0, 0, 0}, {1, 1, 1}));
  const auto selected = creases_of(mesh);
  const auto network = make_curve_network(mesh, selected);
  expect_consistent(mesh, network, selected);
  EXPECT_EQ(network.branches.size(), 12u);
  ASSERT_EQ(network.nodes.size(), 8u);
  for (const auto& node : network.nodes) {
    EXPECT_EQ(node.branches.size(), 3u);
    EXPECT_FALSE(node.is_end());
  }
}

TYPED_TEST(Curve_networks, OpenBranchHasTwoEnds) {
  const auto mesh = this->copied(cylinder(5, 24, 0, 10));
  auto rim = make_curve_network(mesh, creases_of(mesh)).branches[0].halfedges;
  rim.resize(7);
  std::vector<typename boost::graph_traits<TypeParam>::edge_descriptor> selected;
  for (auto h : rim) selected.push_back(edge(h, mesh));
  const auto network = make_curve_network(mesh, selected);
  expect_consistent(mesh, network, selected);
  ASSERT_EQ(network.branches.size(), 1u);
  EXPECT_FALSE(network.branches[0].closed());
  EXPECT_EQ(network.branches[0].halfedges.size(), 7u);
  ASSERT_EQ(network.nodes.size(), 2u);
  EXPECT_TRUE(network.nodes[0].is_end() && network.nodes[1].is_end());
}

TEST(Curve_network, LoopsThroughOneVertex) {
  const Blend_mesh mesh = grid_box({0, 0, 0}, {4, 4, 4}, 4);
  // Two squares on the side z = 4 that share the corner (2, 2, 4): a figure of eight.
  const auto loop = [](double s) {
    return std::vector<Point_3>{{2, 2, 4}, {2 + s, 2, 4}, {2 + s, 2 + s, 4}, {2, 2 + s, 4}, {2, 2, 4}};
  };
  std::vector<Edge> selected = edges_of_polyline(mesh, loop(1)).edges;
  const std::vector<Edge> second = edges_of_polyline(mesh, loop(-1)).edges;
  selected.insert(selected.end(), second.begin(), second.end());
  ASSERT_EQ(selected.size(), 8u);
  const auto network = make_curve_network(mesh, selected);
  expect_consistent(mesh, network, selected);
  ASSERT_EQ(network.nodes.size(), 1u);
  EXPECT_EQ(network.nodes[0].branches, (std::vector<std::size_t>{0, 0, 1, 1}));
  ASSERT_EQ(network.branches.size(), 2u);
  EXPECT_FALSE(network.branches[0].closed()) << "a loop with a node";
}

TEST(Curve_network, OrderOfSelectionDoesNotMatter) {
  const Blend_mesh mesh = grid_box({0, 0, 0}, {4, 4, 4}, 4);
  std::vector<Edge> selected = creases_of(mesh);
  const auto expected = make_curve_network(mesh, selected);
  std::mt19937 random(1);
  for (int round = 0; round < 5; ++round) {
    std::shuffle(selected.begin(), selected.end(), random);
    selected.push_back(selected[round]);  // and repetitions count once
    EXPECT_TRUE(same(make_curve_network(mesh, selected), expected));
  }
}

TEST(Curve_network, EmptySelection) {
  const auto network = make_curve_network(box({0, 0, 0}, {1, 1, 1}), std::vector<Edge>());
  EXPECT_TRUE(network.branches.empty() && network.nodes.empty());
}

TEST(Curve_network, RemovedElementsAreNoObstacle) {
  Blend_mesh mesh = side_by_side(cylinder(1, 8, 0, 1), cylinder(5, 24, 10, 20));
  std::vector<Face> small;
  for (Face f : mesh.faces())
    if (mesh.point(mesh.target(mesh.halfedge(f))).z() < 5) small.push_back(f);
  for (Face f : small) CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
  ASSERT_TRUE(mesh.has_garbage());
  const auto selected = creases_of(mesh);
  const auto network = make_curve_network(mesh, selected);
  expect_consistent(mesh, network, selected);
  EXPECT_EQ(network.branches.size(), 2u);
}

TEST(Polyline, VerticesAlongEdges) {
  const Blend_mesh mesh = box({0, 0, 0}, {1, 1, 1});
  const auto chain = edges_of_polyline(mesh, std::vector<Vertex>{Vertex(0), Vertex(1), Vertex(3)});
  ASSERT_TRUE(chain.ok());
  ASSERT_EQ(chain.edges.size(), 2u);
  EXPECT_EQ(chain.edges[0], mesh.edge(mesh.halfedge(Vertex(0), Vertex(1))));
}

TEST(Polyline, NamesThePairThatIsNoEdge) {
  const Blend_mesh mesh = box({0, 0, 0}, {1, 1, 1});
  const auto chain = edges_of_polyline(mesh, std::vector<Vertex>{Vertex(0), Vertex(1), Vertex(6)});
  EXPECT_EQ(chain.diagnosis.status, Status::no_such_edge);
  EXPECT_TRUE(chain.edges.empty());
  EXPECT_NE(chain.diagnosis.detail.find("1 and 2"), std::string::npos) << chain.diagnosis.detail;
  EXPECT_EQ(*chain.diagnosis.point, Point_3(1, 0, 0));
  EXPECT_EQ(edges_of_polyline(mesh, std::vector<Vertex>{Vertex(0)}).diagnosis.status, Status::no_edges_selected);
  EXPECT_EQ(edges_of_polyline(mesh, std::vector<Vertex>{Vertex(0), Vertex(0)}).diagnosis.status, Status::no_such_edge);
}

TEST(Polyline, PointsMatchWithinSinglePrecision) {
  const double third = 1000.0 / 3;
  const Blend_mesh mesh = box({0, 0, 0}, {third, third, third});
  const double single = static_cast<float>(third);
  ASSERT_NE(single, third);
  EXPECT_EQ(edges_of_polyline(mesh, std::vector<Point_3>{{0, 0, 0}, {third, 0, 0}, {third, third, 0}}).edges.size(),
            2u);
  EXPECT_EQ(edges_of_polyline(mesh, std::vector<Point_3>{{0, 0, 0}, {single, 0, 0}, {single, single, 0}}).edges.size(),
            2u);
  const auto off = edges_of_polyline(mesh, std::vector<Point_3>{{0, 0, 0}, {third + 1, 0, 0}});
  EXPECT_EQ(off.diagnosis.status, Status::no_such_edge);
  EXPECT_EQ(*off.diagnosis.point, Point_3(third + 1, 0, 0));
}

TEST(Polyline, NearestVertexWins) {
  Blend_mesh mesh;
  for (const double x : {3e-6, 0.0, 1e-6, 10.0}) mesh.add_vertex(Point_3(x, 0, 0));
  const Vertex_locator<Blend_mesh> locate(mesh);
  EXPECT_EQ(locate(Point_3(1e-6, 0, 0)), Vertex(2)) << "an equal position goes first";
  EXPECT_EQ(locate(Point_3(2.6e-6, 0, 0)), Vertex(0));
  EXPECT_EQ(locate(Point_3(0, 5, 0)), std::nullopt);
  EXPECT_EQ(locate(Point_3(std::nan(""), 0, 0)), std::nullopt);
}

TEST(Polyline, WorksOnAPolyhedron) {
  Polyhedron mesh;
  CGAL::copy_face_graph(box({0, 0, 0}, {1, 1, 1}), mesh);
  EXPECT_EQ(edges_of_polyline(mesh, std::vector<Point_3>{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}}).edges.size(), 2u);
  EXPECT_FALSE(edges_of_polyline(mesh, std::vector<Point_3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 1}}).ok());
}

Selection parsed(const std::string& text) {
  std::istringstream in(text);
  return read_selection(in);
}

TEST(Selection, ReadsTheDemosFormat) {
  const Selection selection = parsed("1 2 3 \n7 \n0 1 1 5 \n");
  EXPECT_EQ(selection.vertices, (std::vector<std::size_t>{1, 2, 3}));
  EXPECT_EQ(selection.faces, (std::vector<std::size_t>{7}));
  EXPECT_EQ(selection.edges, (std::vector<std::array<std::size_t, 2>>{{0, 1}, {1, 5}}));
}

TEST(Selection, LineEndsAndMissingLines) {
  EXPECT_EQ(parsed("\r\n\r\n4 5\r\n6 7\r\n").edges.size(), 2u);
  EXPECT_TRUE(parsed("").edges.empty());
  EXPECT_EQ(parsed("3 4").vertices.size(), 2u);
}

TEST(Selection, RefusesWhatIsNoIndex) {
  for (const char* text :
       {"\n\n1 2 3\n", "\n\n1 -2\n", "\n\n1 2.5\n", "\n\nx y\n", "\n\n1 99999999999999999999\n", "OFF\n"})
    EXPECT_THROW((void)parsed(text), Mesh_io_error) << text;
  EXPECT_THROW((void)read_selection(std::string("no such file.selection.txt")), Mesh_io_error);
}

}  // namespace
