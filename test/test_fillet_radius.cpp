// SPDX-License-Identifier: GPL-3.0-or-later
// Which radius a blend has at which vertex; how the ball rolls with it is tested elsewhere.
#include "fillet_radius.h"

#include "blends.h"

#include <CGAL/Polyhedron_3.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace cgal_blend::test {
namespace {

constexpr int sides = 32;

const Radius_law growing = Linear_radius{1, 3};
const Radius_law round_and_back = Piecewise_radius({{0, 1}, {0.25, 1.5}, {0.5, 3}});
const Radius_law different_at_the_ends = Piecewise_radius({{0, 1}, {1, 3}});

Blend_mesh pillar() { return cylinder(10, sides, 0, 20); }
std::vector<Edge> rim(const Blend_mesh& mesh) { return creases_at_height(mesh, 20); }

Branch_laws laws(const Blend_mesh& mesh, const Edge_blend& blend, const Fillet_options& options = {}) {
  return laws_along(mesh, make_curve_network(mesh, blend.edges), blend, options);
}

/// The halfedges of the only branch.
std::vector<Halfedge> chain(const Blend_mesh& mesh, const std::vector<Edge>& edges) {
  const Curve_network<Blend_mesh> network = make_curve_network(mesh, edges);
  EXPECT_EQ(network.branches.size(), 1u);
  return network.branches.front().halfedges;
}

TEST(Fillet_radius, IsTheNearestThatIsGiven) {
  Fillet_options options;
  options.radius = 1;
  EXPECT_EQ(radius_law_of({}, options)(0), 1);
  options.law = 2;
  EXPECT_EQ(radius_law_of({}, options)(0), 2);
  Edge_blend blend;
  blend.radius = 3;
  EXPECT_EQ(radius_law_of(blend, options)(0), 3);
  blend.law = 4;
  EXPECT_EQ(radius_law_of(blend, options)(0), 4);
}

TEST(Fillet_radius, BeginsAtTheFirstVertexOfAClosedBranch) {
  const Blend_mesh mesh = pillar();
  const Branch_laws result = laws(mesh, {rim(mesh), 0, {}, round_and_back});
  ASSERT_TRUE(result.diagnosis.ok());
  ASSERT_EQ(result.laws.size(), 1u);
  for (int k = 0; k <= sides; ++k) {
    const double s = static_cast<double>(k) / sides;
    EXPECT_NEAR(result.laws[0](s), round_and_back.with_period()(s), 1e-12);
  }
}

TEST(Fillet_radius, BeginsAtAnyVertexOfAClosedCurve) {
  const Blend_mesh mesh = pillar();
  const std::vector<Halfedge> halfedges = chain(mesh, rim(mesh));
  for (const int start : {0, 1, 7, sides - 1}) {
    const Branch_laws result = laws(mesh, {rim(mesh), 0, {}, round_and_back, mesh.source(halfedges[start])});
    ASSERT_TRUE(result.diagnosis.ok());
    for (int k = 0; k < sides; ++k) {
      const double s = static_cast<double>((k - start + sides) % sides) / sides;
      EXPECT_NEAR(result.laws[0](static_cast<double>(k) / sides), round_and_back.with_period()(s), 1e-12);
    }
  }
}

TEST(Fillet_radius, BeginsAtEitherEndOfAnOpenCurve) {
  const Blend_mesh mesh = pillar();
  std::vector<Edge> edges = rim(mesh);
  edges.resize(edges.size() / 2);
  const std::vector<Halfedge> halfedges = chain(mesh, edges);
  const Vertex first = mesh.source(halfedges.front()), last = mesh.target(halfedges.back());
  for (const double s : {0.0, 0.2, 0.5, 1.0}) {
    EXPECT_NEAR(laws(mesh, {edges, 0, {}, growing}).laws[0](s), 1 + 2 * s, 1e-14);
    EXPECT_NEAR(laws(mesh, {edges, 0, {}, growing, first}).laws[0](s), 1 + 2 * s, 1e-14);
    EXPECT_NEAR(laws(mesh, {edges, 0, {}, growing, last}).laws[0](s), 3 - 2 * s, 1e-14);
  }
}

/// A network with nodes where the curves have none.
TEST(Fillet_radius, GoesOnOverCorners) {
  const Blend_mesh mesh = box({0, 0, 0}, {3, 2, 1});
  std::vector<Edge> edges = creases_at_height(mesh, 1);
  const auto corners = make_curve_network(mesh, edges, [](Halfedge, Halfedge) { return false; });
  ASSERT_EQ(corners.branches.size(), 4u);
  const auto corner = [&](double x, double y) {
    for (const Vertex v : mesh.vertices())
      if (mesh.point(v) == Point_3(x, y, 1)) return v;
    return Vertex();
  };
  const std::vector<Vertex> along{corner(0, 0), corner(3, 0), corner(3, 2), corner(0, 2)};
  // Both ways round: the radius at the corners is that of their distance from the start, 1 + distance / 10.
  const Radius_law tent = Piecewise_radius({{0, 1}, {0.5, 1.5}, {1, 1}}, Piecewise_radius::Interpolation::linear);
  for (std::size_t start = 0; start < 4; ++start) {
    const Branch_laws result = laws_along(mesh, corners, {edges, 0, {}, tent, along[start]}, {});
    ASSERT_TRUE(result.diagnosis.ok());
    ASSERT_EQ(result.laws.size(), 4u);
    const auto radius_at = [&](Vertex v) {
      const double dx = std::abs(mesh.point(v).x() - mesh.point(along[start]).x());
      const double dy = std::abs(mesh.point(v).y() - mesh.point(along[start]).y());
      return 1 + (dx + dy) / 10;
    };
    for (std::size_t k = 0; k < 4; ++k) {
      const std::vector<Halfedge>& halfedges = corners.branches[k].halfedges;
      EXPECT_NEAR(result.laws[k](0), radius_at(mesh.source(halfedges.front())), 1e-12);
      EXPECT_NEAR(result.laws[k](1), radius_at(mesh.target(halfedges.back())), 1e-12);
    }
  }
  // An open curve over two corners.
  edges.pop_back();
  const auto cut = make_curve_network(mesh, edges, [](Halfedge, Halfedge) { return false; });
  const Branch<Blend_mesh> whole = make_curve_network(mesh, edges).branches.front();
  for (const bool backward : {false, true}) {
    const Vertex first = mesh.source(whole.halfedges.front()), last = mesh.target(whole.halfedges.back());
    const Branch_laws result = laws_along(mesh, cut, {edges, 0, {}, growing, backward ? last : first}, {});
    ASSERT_EQ(result.laws.size(), 3u);
    std::map<Vertex, std::vector<double>> radii;
    for (std::size_t k = 0; k < 3; ++k) {
      radii[mesh.source(cut.branches[k].halfedges.front())].push_back(result.laws[k](0));
      radii[mesh.target(cut.branches[k].halfedges.back())].push_back(result.laws[k](1));
    }
    EXPECT_NEAR(radii[backward ? last : first].front(), 1, 1e-12);
    EXPECT_NEAR(radii[backward ? first : last].front(), 3, 1e-12);
    for (const auto& [v, here] : radii) {
      EXPECT_EQ(here.size(), v == first || v == last ? 1u : 2u);
      EXPECT_NEAR(here.front(), here.back(), 1e-12);
    }
  }
}

TEST(Fillet_radius, RefusesAStartThatIsNone) {
  const Blend_mesh mesh = pillar();
  std::vector<Edge> edges = rim(mesh);
  Vertex elsewhere = mesh.vertex(edges.front(), 0);
  for (const Vertex v : mesh.vertices())
    if (mesh.point(v).z() == 0) elsewhere = v;
  const auto refused = [&](const std::vector<Edge>& curve, Vertex start) {
    const Branch_laws result = laws(mesh, {curve, 0, {}, 2.0, start});
    EXPECT_EQ(result.diagnosis.status, Status::invalid_parameter);
    ASSERT_TRUE(result.diagnosis.point);
    EXPECT_EQ(*result.diagnosis.point, mesh.point(start));
  };
  refused(edges, elsewhere);
  edges.resize(5);
  refused(edges, mesh.source(chain(mesh, edges)[2]));
}

TEST(Fillet_radius, OfAClosedCurveMustEndAsItBegins) {
  const Blend_mesh mesh = pillar();
  Blend_mesh out;
  for (const Radius_law& law : {growing, different_at_the_ends}) {
    const Fillet_outcome outcome = unchecked::fillet_edges(mesh, {{rim(mesh), 0, {}, law}}, out, {});
    EXPECT_EQ(outcome.diagnosis.status, Status::invalid_parameter);
    EXPECT_EQ(outcome.diagnosis.detail, "on a closed curve the radius must end as it begins");
    EXPECT_TRUE(out.is_empty());
  }
}

TEST(Fillet_radius, IsRefusedWhereItIsNone) {
  const Blend_mesh mesh = pillar(), boss = cylinder(3, sides, 10, 30);
  Blend_mesh out;
  Fillet_options options;
  for (const Radius_law& law : {Radius_law(-1.0), Radius_law(Piecewise_radius({{0, 1}, {0.5, 0}, {1, 1}}))}) {
    EXPECT_EQ(unchecked::fillet_edges(mesh, {{rim(mesh), 2, {}, law}}, out, {}).diagnosis.status,
              Status::invalid_parameter);
    options.law = law;
    EXPECT_EQ(unchecked::fillet_edges(mesh, {{rim(mesh)}}, out, options).diagnosis.status, Status::invalid_parameter);
    EXPECT_EQ(unchecked::corefine_and_fillet(mesh, boss, Boolean_operation::union_, out, options).diagnosis.status,
              Status::invalid_parameter);
  }
}

TEST(Fillet_radius, ThatDoesNotVaryIsThatOfTheNumber) {
  const Blend_mesh mesh = pillar(), boss = cylinder(3, sides, 10, 30);
  Blend_mesh by_number, by_law;
  ASSERT_TRUE(unchecked::fillet_edges(mesh, {{rim(mesh), 2}}, by_number, {}).ok());
  const Fillet_outcome outcome =
      unchecked::fillet_edges(mesh, {{rim(mesh), 0, {}, Piecewise_radius({{0, 2}, {0.5, 2}})}}, by_law, {});
  ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
  EXPECT_TRUE(identical(by_number, by_law));
  EXPECT_EQ(outcome.blends[0].radius, 2);

  constexpr auto unite = Boolean_operation::union_;
  ASSERT_TRUE(unchecked::corefine_and_fillet(mesh, boss, unite, by_number, options_of(1)).ok());
  Fillet_options options;
  options.law = 1;
  ASSERT_TRUE(unchecked::corefine_and_fillet(mesh, boss, unite, by_law, options).ok());
  EXPECT_TRUE(identical(by_number, by_law));
  options.law = 50;  // each part has its own
  ASSERT_TRUE(unchecked::corefine_and_fillet_all(mesh, {{&boss, unite, 0, 1.0}}, by_law, options).ok());
  EXPECT_TRUE(identical(by_number, by_law));
  ASSERT_TRUE(unchecked::corefine_and_fillet_all(mesh, {{&boss, unite, 1}}, by_law, options).ok());
  EXPECT_TRUE(identical(by_number, by_law));
}

/// Laws and starts reach the engine from meshes of any type: the refusal comes with the place of the start.
TEST(Fillet_radius, IsCarriedOverFromMeshesOfAnyType) {
  using Polyhedron = CGAL::Polyhedron_3<CGAL::Exact_predicates_inexact_constructions_kernel>;
  Polyhedron graph, out;
  (void)internal::copy_out(pillar(), graph, CGAL::parameters::default_values());
  Edge_blend_of<Polyhedron> blend;
  for (const auto e : edges(graph)) {
    const auto &a = source(e, graph)->point(), &b = target(e, graph)->point();
    if (a.z() == 20 && b.z() == 20 && std::hypot(a.x(), a.y()) > 9 && std::hypot(b.x(), b.y()) > 9)
      blend.edges.push_back(e);
  }
  ASSERT_EQ(blend.edges.size(), std::size_t(sides));
  blend.law = growing;
  blend.start = source(blend.edges[5], graph);
  const auto result = fillet_edges(graph, {blend}, out, Fillet_options());
  EXPECT_EQ(result.diagnosis.status, Status::invalid_parameter);
  ASSERT_TRUE(result.diagnosis.point);
  EXPECT_EQ(*result.diagnosis.point, (*blend.start)->point());
}

}  // namespace
}  // namespace cgal_blend::test
