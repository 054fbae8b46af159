// SPDX-License-Identifier: GPL-3.0-or-later
#include "propagate_chain.h"

#include "blends.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;

constexpr double smooth_angle = 40;

Edge edge_between(const Blend_mesh& mesh, const Point_3& p, const Point_3& q) {
  for (const Edge e : mesh.edges()) {
    const Point_3 &a = mesh.point(mesh.vertex(e, 0)), &b = mesh.point(mesh.vertex(e, 1));
    if ((a == p && b == q) || (a == q && b == p)) return e;
  }
  throw std::logic_error("no such edge");
}

Vertex vertex_at(const Blend_mesh& mesh, const Point_3& p) {
  return *std::find_if(mesh.vertices().begin(), mesh.vertices().end(), [&](Vertex v) { return mesh.point(v) == p; });
}

std::set<Edge> as_set(const std::vector<Edge>& edges) { return {edges.begin(), edges.end()}; }

std::set<Edge> grown(const Blend_mesh& mesh, Edge seed, double angle = smooth_angle) {
  const std::vector<Edge> edges = propagate_chains(mesh, {{{seed}, 0}}, angle).front().edges;
  EXPECT_EQ(as_set(edges).size(), edges.size()) << "each once";
  return as_set(edges);
}

/// Two straight sides of length 4 and half circles of radius 1 in `steps` steps.
std::vector<std::pair<double, double>> stadium(int steps) {
  std::vector<std::pair<double, double>> outline;
  for (const int side : {1, -1})
    for (int k = 0; k <= steps; ++k) {
      const double angle = pi * k / steps - pi / 2;
      outline.emplace_back(side * (2 + std::cos(angle)), side * std::sin(angle));
    }
  return outline;
}

TEST(Propagate_chain, One_edge_of_a_rim_stands_for_the_rim) {
  for (const Blend_mesh& mesh : {cylinder(1, 64, 0, 2), prism(stadium(18), 0, 2)}) {
    const std::vector<Edge> rim = creases_at_height(mesh, 2);
    for (std::size_t i = 0; i < rim.size(); i += 7) EXPECT_EQ(grown(mesh, rim[i]), as_set(rim));
    Fillet_options options = options_of(0.2);
    Blend_mesh expected, out, unchanged;
    ASSERT_TRUE(unchecked::fillet_edges(mesh, {{rim}}, expected, options).ok());
    EXPECT_FALSE(unchecked::fillet_edges(mesh, {{{rim[5]}}}, unchanged, options).ok() &&
                 identical(unchanged, expected));
    options.propagate = true;
    const Fillet_outcome outcome = unchecked::fillet_edges(mesh, {{{rim[5]}}}, out, options);
    ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
    EXPECT_TRUE(identical(out, expected));
    EXPECT_EQ(outcome.blends.front().edges, rim.size());
    EXPECT_NEAR(volume_of(out) - volume_of(mesh), volume_of(expected) - volume_of(mesh), 1e-15);
  }
}

TEST(Propagate_chain, Corners_end_it) {
  const Blend_mesh mesh = grid_box({0, 0, 0}, {4, 4, 4}, 4);
  std::set<Edge> side;
  for (int k = 0; k < 4; ++k) side.insert(edge_between(mesh, Point_3(k, 0, 4), Point_3(k + 1, 0, 4)));
  for (const Edge e : side) EXPECT_EQ(grown(mesh, e), side);
  Fillet_options options = options_of(0.25);
  Blend_mesh expected, out;
  ASSERT_TRUE(unchecked::fillet_edges(mesh, {{{side.begin(), side.end()}}}, expected, options).ok());
  options.propagate = true;
  ASSERT_TRUE(unchecked::fillet_edges(mesh, {{{*side.begin()}}}, out, options).ok());
  EXPECT_TRUE(identical(out, expected));
  const double closed_form = -4 * (1 - pi / 4) * 0.25 * 0.25;
  EXPECT_NEAR(volume_of(out) - 64, closed_form, 0.01 * std::abs(closed_form));
}

TEST(Propagate_chain, Turns_of_more_than_25_degrees_end_it) {
  for (const auto& [n, all] : {std::pair(12, false), std::pair(14, false), std::pair(15, true)}) {
    const Blend_mesh mesh = cylinder(1, n, 0, 2);
    const std::vector<Edge> rim = creases_at_height(mesh, 2);
    EXPECT_EQ(grown(mesh, rim.front()).size(), all ? rim.size() : 1) << n;
  }
}

TEST(Propagate_chain, Edges_that_are_smooth_end_it) {
  const Blend_mesh mesh = cylinder(1, 64, 0, 2, 3);
  const Edge seed = edge_between(mesh, Point_3(1, 0, 0.5), Point_3(1, 0, 1));
  EXPECT_EQ(grown(mesh, seed).size(), 1u) << "a line on the cylinder goes on, but is no crease";
}

/// A surface over the disk that is flat for y < 0, and slopes up or down from the x-axis for y > 0.
TEST(Propagate_chain, A_ridge_does_not_go_on_as_a_groove) {
  const int n = 64;
  std::vector<Point_3> points{{0, 0, 0}, {0, 0, -3}};
  std::vector<Corner_indices> triangles;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * pi * i / n, height = 2 * i < n ? -std::sin(2 * angle) / 2 : 0;
    points.emplace_back(i == 0       ? 1
                        : 2 * i == n ? -1
                                     : std::cos(angle),
                        i == 0 || 2 * i == n ? 0 : std::sin(angle), height);
    const std::size_t a = 2 + i, b = 2 + (i + 1) % n;
    triangles.push_back({0, a, b});
    triangles.push_back({1, b, a});
  }
  const Blend_mesh mesh = mesh_of(points, triangles);
  const Edge right = edge_between(mesh, points[0], {1, 0, 0}), left = edge_between(mesh, points[0], {-1, 0, 0});
  ASSERT_TRUE(is_crease(right, mesh, 30) && is_crease(left, mesh, 30));
  ASSERT_NE(is_convex_edge(right, mesh), is_convex_edge(left, mesh));
  EXPECT_EQ(grown(mesh, right, 30).count(left), 0u);
  EXPECT_EQ(grown(mesh, left, 30).count(right), 0u);
}

TEST(Propagate_chain, Chains_grow_up_to_each_other) {
  const Blend_mesh mesh = cylinder(1, 64, 0, 2);
  const std::vector<Edge> rim = creases_at_height(mesh, 2);
  const std::vector<Edge_blend> blends = propagate_chains(mesh, {{{rim[3]}, 0.1}, {{rim[20]}, 0.2}}, smooth_angle);
  ASSERT_EQ(blends.size(), 2u);
  EXPECT_EQ(blends[0].edges.size(), rim.size() - 1);
  EXPECT_EQ(blends[1].edges, std::vector<Edge>{rim[20]});
  EXPECT_EQ(as_set(blends[0].edges).count(rim[20]), 0u);
  EXPECT_EQ(blends[0].radius, 0.1);
}

TEST(Propagate_chain, A_radius_law_begins_at_the_new_end) {
  const Blend_mesh mesh = grid_box({0, 0, 0}, {4, 4, 4}, 4);
  const auto place = [](int k) { return Point_3(k, 0, 4); };
  std::vector<Edge> side;
  for (int k = 0; k < 4; ++k) side.push_back(edge_between(mesh, place(k), place(k + 1)));
  for (const auto& [chosen, whole] : {std::pair(1, 0), std::pair(3, 4)}) {
    Edge_blend seed{{side[1], side[2]}, 0}, all{side, 0};
    seed.law = all.law = Linear_radius{0.2, 0.4};
    seed.start = vertex_at(mesh, place(chosen));
    all.start = vertex_at(mesh, place(whole));
    EXPECT_EQ(propagate_chains(mesh, {seed}, smooth_angle).front().start, all.start);
    Fillet_options options = options_of(0);
    Blend_mesh expected, out;
    const Fillet_outcome explicitly = unchecked::fillet_edges(mesh, {all}, expected, options);
    ASSERT_TRUE(explicitly.ok()) << message(explicitly.diagnosis);
    options.propagate = true;
    ASSERT_TRUE(unchecked::fillet_edges(mesh, {seed}, out, options).ok());
    EXPECT_TRUE(identical(out, expected));
  }
}

}  // namespace
