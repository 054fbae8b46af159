// SPDX-License-Identifier: GPL-3.0-or-later
// Parametrization of disks: linear precision, and no folds by exact predicates.
#include "flatten_disk.h"
#include "shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

namespace cgal_blend::test {
namespace {

/// Disk about the origin in rings of 6, 12, 18, ... faces' corners, with heights over it; the border is the unit circle.
struct Disk {
  Blend_mesh mesh;
  std::vector<Point_2> border;  // per vertex: its place in the plane
  std::vector<bool> is_border;
};

Disk make_disk(int rings, double jitter, double height, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Disk disk;
  std::vector<std::vector<Vertex>> ring(rings + 1);
  for (int k = 0; k <= rings; ++k)
    for (int i = 0; i < std::max(1, 6 * k); ++i) {
      const bool outer = k == rings;
      const double turn = 2 * pi * i / std::max(1, 6 * k), size = 1.0 / rings;
      const double x = k * size * std::cos(turn) + (outer ? 0 : jitter * size * uniform(random));
      const double y = k * size * std::sin(turn) + (outer ? 0 : jitter * size * uniform(random));
      const double z = outer ? 0 : height * size * uniform(random);
      ring[k].push_back(disk.mesh.add_vertex({x, y, z}));
      disk.border.emplace_back(x, y);
      disk.is_border.push_back(outer);
    }
  for (int k = 0; k < rings; ++k) {
    const std::size_t n = ring[k].size(), m = ring[k + 1].size();
    std::size_t i = 0, j = 0;
    while (i < (k == 0 ? 0 : n) || j < m) {  // whichever circle is behind goes on
      const Vertex a = ring[k][i % n], b = ring[k + 1][j % m];
      if (k > 0 && (2 * i + 1) * m < (2 * j + 1) * n) {
        disk.mesh.add_face(a, b, ring[k][++i % n]);
      } else {
        disk.mesh.add_face(a, b, ring[k + 1][++j % m]);
      }
    }
  }
  return disk;
}

bool is_upright(const Blend_mesh& mesh, const std::vector<Point_2>& flat) {
  for (const Face f : mesh.faces()) {
    const Halfedge h = mesh.halfedge(f);
    if (CGAL::orientation(flat[mesh.source(h)], flat[mesh.target(h)], flat[mesh.target(mesh.next(h))]) !=
        CGAL::LEFT_TURN)
      return false;
  }
  return true;
}

constexpr Flat_weights all_weights[] = {Flat_weights::conformal, Flat_weights::mean_value, Flat_weights::uniform};

TEST(Flatten_disk, FlatDisksStayAsTheyAre) {
  // Conformal and mean value weights reproduce linear functions; so do uniform ones on a symmetric mesh only.
  for (const double scale : {1e-6, 1.0, 1e6}) {
    Disk disk = make_disk(5, 0.25, 0, 1);
    ASSERT_TRUE(is_upright(disk.mesh, disk.border));
    for (const Vertex v : disk.mesh.vertices())
      disk.mesh.point(v) = CGAL::ORIGIN + scale * (disk.mesh.point(v) - CGAL::ORIGIN);
    for (const Flat_weights weights : {Flat_weights::conformal, Flat_weights::mean_value}) {
      const auto flat = flatten_disk(disk.mesh, disk.border, weights);
      ASSERT_TRUE(flat.has_value());
      for (const Vertex v : disk.mesh.vertices())
        EXPECT_LT(std::sqrt(CGAL::squared_distance((*flat)[v], disk.border[v])), 1e-12);
    }
    const auto uniform = flatten_disk(disk.mesh, disk.border, Flat_weights::uniform);
    ASSERT_TRUE(uniform.has_value());
    double moved = 0;
    for (const Vertex v : disk.mesh.vertices())
      moved = std::max(moved, std::sqrt(CGAL::squared_distance((*uniform)[v], disk.border[v])));
    EXPECT_GT(moved, 1e-3);
  }
}

TEST(Flatten_disk, UniformWeightsPutVerticesInTheMeanOfTheirNeighbours) {
  Disk disk = make_disk(4, 0.4, 2, 3);
  const auto flat = flatten_disk(disk.mesh, disk.border, Flat_weights::uniform);
  ASSERT_TRUE(flat.has_value());
  for (const Vertex v : disk.mesh.vertices()) {
    if (disk.is_border[v]) {
      EXPECT_EQ((*flat)[v], disk.border[v]);
      continue;
    }
    double x = 0, y = 0, n = 0;
    for (const Vertex w : disk.mesh.vertices_around_target(disk.mesh.halfedge(v))) {
      x += (*flat)[w].x();
      y += (*flat)[w].y();
      ++n;
    }
    EXPECT_NEAR((*flat)[v].x(), x / n, 1e-13);
    EXPECT_NEAR((*flat)[v].y(), y / n, 1e-13);
  }
}

TEST(Flatten_disk, ConformalWeightsFoldOnRoughDisksAndMeanValueWeightsDoNot) {
  int folded = 0, upright = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    Disk disk = make_disk(4, 0.3, seed <= 30 ? 0.3 : 3, seed);
    for (const Flat_weights weights : all_weights) {
      const auto flat = flatten_disk(disk.mesh, disk.border, weights);
      if (flat) {
        EXPECT_TRUE(is_upright(disk.mesh, *flat)) << seed;
        for (const Vertex v : disk.mesh.vertices()) EXPECT_TRUE(!disk.is_border[v] || (*flat)[v] == disk.border[v]);
      }
      EXPECT_TRUE(flat || weights == Flat_weights::conformal) << seed;
      if (weights == Flat_weights::conformal) ++(flat ? upright : folded);
    }
  }
  EXPECT_GE(folded, 5);
  EXPECT_GE(upright, 5);
}

TEST(Flatten_disk, ClosedMeshesAreNoDisks) {
  Blend_mesh closed = sphere(1, 1);
  for (const Flat_weights weights : all_weights)
    EXPECT_FALSE(flatten_disk(closed, std::vector<Point_2>(closed.number_of_vertices()), weights).has_value());
}

TEST(Flatten_disk, GivenBordersMayBeStraightInParts) {
  // A rectangle, as blends have them: several border vertices on each side.
  Blend_mesh grid;
  std::vector<Point_2> border;
  const int n = 6, m = 4;
  for (int j = 0; j <= m; ++j)
    for (int i = 0; i <= n; ++i) {
      grid.add_vertex({1.0 * i, std::cos(0.5 * j), std::sin(0.5 * j)});  // a piece of a cylinder
      border.emplace_back(0.7 * i, 0.3 * j);
    }
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) {
      const Vertex a(j * (n + 1) + i), b(a + 1), c(b + n + 1), d(a + n + 1);
      grid.add_face(a, b, c);
      grid.add_face(a, c, d);
    }
  for (const Flat_weights weights : {Flat_weights::conformal, Flat_weights::mean_value}) {
    const auto flat = flatten_disk(grid, border, weights);
    ASSERT_TRUE(flat.has_value());
    for (const Vertex v : grid.vertices())
      EXPECT_LT(std::sqrt(CGAL::squared_distance((*flat)[v], border[v])), 1e-12) << "the cylinder unrolled";
  }
}

}  // namespace
}  // namespace cgal_blend::test
