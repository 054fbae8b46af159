// SPDX-License-Identifier: GPL-3.0-or-later
#include "boolean.h"
#include "checks.h"
#include "coarse_level.h"
#include "shapes.h"
#include "stopwatch.h"

#include <cgal_blend/curve_network.h>
#include <cgal_blend/mesh_io.h>
#include <cgal_blend/validate.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace cgal_blend::test {
namespace {

struct Curved_mesh {
  Blend_mesh mesh;
  std::vector<std::vector<Edge>> curves;
};

Curved_mesh union_of(const Blend_mesh& a, const Blend_mesh& b) {
  Boolean_result result = compute_boolean(a, b, Boolean_operation::union_);
  Curved_mesh out;
  const auto network = make_curve_network(result.mesh, result.curves);
  for (const auto& branch : network.branches) {
    std::vector<Edge>& edges = out.curves.emplace_back();
    for (const Halfedge h : branch.halfedges) edges.push_back(result.mesh.edge(h));
  }
  out.mesh = std::move(result.mesh);
  return out;
}

constexpr double offset = 0.6;  // of the centres of both spheres, of radius 1, from the origin along x

Blend_mesh sphere_aside(double x, int level, double angle) {
  return transformed(sphere(1, level), placement({1, 2, 3}, angle, {x, 0, 0}));
}

/// Two spheres that cross in a circle about the x-axis, so that nothing falls together.
Curved_mesh sphere_pair(int level) {
  return union_of(sphere_aside(-offset, level, 0.3), sphere_aside(offset, level, 1.1));
}

/// A cylinder across a box: two circles.
Curved_mesh crossed_box() {
  const Blend_mesh rod = transformed(cylinder(0.5, 96, -2, 2, 40), placement({0, 1, 0}, 0.2));
  return union_of(grid_box({-1, -1, -1}, {1, 1, 1}, 24), rod);
}

Blend_mesh mapped(Blend_mesh mesh, const std::function<Point_3(const Point_3&)>& map) {
  for (const Vertex v : mesh.vertices()) mesh.point(v) = map(mesh.point(v));
  return mesh;
}

/// The fine mesh with what the coarse level makes of moved coarse vertices.
Blend_mesh restored(Blend_mesh fine, const Coarse_level& level, const Blend_mesh& moved) {
  for (const auto& [v, p] : level.restore(moved)) fine.point(v) = p;
  return fine;
}

double distance(const Point_3& p, const Point_3& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

/// True if the edges form one closed chain that passes no vertex twice.
bool is_loop(const std::vector<Edge>& edges, const Blend_mesh& mesh) {
  std::map<std::size_t, int> uses;
  for (const Edge e : edges)
    for (const int end : {0, 1}) ++uses[mesh.vertex(e, end)];
  for (const auto& [vertex, count] : uses)
    if (count != 2) return false;
  const auto network = make_curve_network(mesh, edges);
  return network.branches.size() == 1 && network.branches.front().closed();
}

std::set<Point_3> places(const std::vector<Edge>& edges, const Blend_mesh& mesh) {
  std::set<Point_3> points;
  for (const Edge e : edges)
    for (const int end : {0, 1}) points.insert(mesh.point(mesh.vertex(e, end)));
  return points;
}

void expect_same_curves(const Curved_mesh& fine, const Coarse_level& level) {
  ASSERT_EQ(level.curves().size(), fine.curves.size());
  for (std::size_t i = 0; i < fine.curves.size(); ++i) {
    EXPECT_TRUE(is_loop(level.curves()[i], level.mesh()));
    EXPECT_GE(level.curves()[i].size(), 16U);
    EXPECT_LT(level.curves()[i].size(), fine.curves[i].size());
    const std::set<Point_3> before = places(fine.curves[i], fine.mesh), after = places(level.curves()[i], level.mesh());
    EXPECT_TRUE(std::includes(before.begin(), before.end(), after.begin(), after.end()));
  }
}

void expect_sound(const Coarse_level& level) {
  EXPECT_TRUE(validate(level.mesh()).ok()) << message(validate(level.mesh()).diagnosis);
  EXPECT_TRUE(is_closed_by_counting(level.mesh()));
  EXPECT_TRUE(has_single_fans(level.mesh()));
  EXPECT_TRUE(crossing_faces_by_brute_force(level.mesh()).empty());
  EXPECT_FALSE(level.mesh().has_garbage());
}

TEST(CoarseLevel, KeepsCurvesAsLoopsOfTheirVertices) {
  for (const Curved_mesh& fine : {sphere_pair(5), crossed_box()}) {
    const Coarse_level level(fine.mesh, fine.curves, 1500);
    EXPECT_LT(level.mesh().number_of_faces(), 1600U);
    expect_same_curves(fine, level);
    expect_sound(level);
  }
}

TEST(CoarseLevel, KeepsTheShape) {
  const Curved_mesh fine = sphere_pair(5);
  double before = 1;
  for (const std::size_t faces : {400, 1600, 6400}) {
    const Coarse_level level(fine.mesh, fine.curves, faces);
    const double lost = std::abs(volume_of(level.mesh()) / volume_of(fine.mesh) - 1);
    EXPECT_LT(lost, before / 2) << faces;
    before = lost;
  }
  EXPECT_LT(before, 2e-3);
}

TEST(CoarseLevel, LeavesAMeshAloneThatIsCoarseAlready) {
  const Curved_mesh fine = sphere_pair(3);
  const Coarse_level level(fine.mesh, fine.curves, fine.mesh.number_of_faces() + 10);
  EXPECT_TRUE(identical(level.mesh(), fine.mesh));
  const auto turn = placement({1, 0, 1}, 0.5, {1, 2, 3});
  const Blend_mesh moved = transformed(level.mesh(), turn);
  EXPECT_TRUE(identical(restored(fine.mesh, level, moved), moved));
}

TEST(CoarseLevel, KeepsTheEndsOfOpenCurves) {
  Curved_mesh fine = sphere_pair(5);
  std::vector<Edge>& curve = fine.curves.front();
  curve.resize(curve.size() / 2);
  const auto ends = [](const std::vector<Edge>& edges, const Blend_mesh& mesh) {
    std::set<Point_3> points;
    const auto network = make_curve_network(mesh, edges);
    EXPECT_EQ(network.branches.size(), 1U);
    for (const auto& node : network.nodes) points.insert(mesh.point(node.vertex));
    return points;
  };
  const Coarse_level level(fine.mesh, fine.curves, 1500);
  expect_sound(level);
  EXPECT_LT(level.curves().front().size(), curve.size() / 2);
  EXPECT_EQ(ends(level.curves().front(), level.mesh()), ends(curve, fine.mesh));
}

TEST(CoarseLevel, RestoresNothingWhereNothingMoved) {
  const Curved_mesh fine = sphere_pair(5);
  const Coarse_level level(fine.mesh, fine.curves, 1500);
  EXPECT_TRUE(level.restore(level.mesh()).empty());
}

TEST(CoarseLevel, MovesRigidlyWithTheCoarseMesh) {
  for (const Curved_mesh& fine : {sphere_pair(5), crossed_box()})
    for (const std::size_t faces : {500, 3000}) {
      const Coarse_level level(fine.mesh, fine.curves, faces);
      const auto motion = placement({3, -1, 2}, 2.1, {1, 2, -3});
      const auto moved = level.restore(transformed(level.mesh(), motion));
      EXPECT_EQ(moved.size(), fine.mesh.number_of_vertices());
      double worst = 0;
      for (const auto& [v, p] : moved) worst = std::max(worst, distance(p, motion.transform(fine.mesh.point(v))));
      EXPECT_LT(worst, 1e-12) << faces;
    }
}

TEST(CoarseLevel, MovesCommonVerticesExactly) {
  const Curved_mesh fine = sphere_pair(5);
  const Coarse_level level(fine.mesh, fine.curves, 1500);
  const auto bend = [](const Point_3& p) { return Point_3(p.x(), p.y() + 0.1 * p.x() * p.x(), p.z()); };
  const Blend_mesh moved = mapped(level.mesh(), bend), result = restored(fine.mesh, level, moved);
  std::map<Point_3, Vertex> fine_vertices;
  for (const Vertex v : fine.mesh.vertices()) fine_vertices[fine.mesh.point(v)] = v;
  std::size_t met = 0;
  for (const Vertex v : level.mesh().vertices()) {
    const auto found = fine_vertices.find(level.mesh().point(v));
    if (found == fine_vertices.end()) continue;
    ++met;
    EXPECT_EQ(result.point(found->second), moved.point(v));
  }
  EXPECT_GE(met, level.curves().front().size());
}

TEST(CoarseLevel, FollowsASmoothDeformationCloserOnFinerLevels) {
  const Curved_mesh fine = sphere_pair(6);
  const auto bump = [](const Point_3& p) {
    const double s = std::exp(-4 * CGAL::squared_distance(p, Point_3(1.3, 0.7, 0)));
    return p + s * Vector_3(0.3, 0.2, 0.1);
  };
  double before = 1;
  for (const std::size_t faces : {500, 2000, 8000}) {
    const Coarse_level level(fine.mesh, fine.curves, faces);
    const Blend_mesh result = restored(fine.mesh, level, mapped(level.mesh(), bump));
    double worst = 0;
    for (const Vertex v : fine.mesh.vertices())
      worst = std::max(worst, distance(result.point(v), bump(fine.mesh.point(v))));
    EXPECT_LT(worst, before / 2) << faces;
    before = worst;
  }
  EXPECT_LT(before, 5e-3);
}

/// The rolling-ball blend of both spheres, by a ball of radius 1: the torus that its centre runs along.
struct Rolled_spheres {
  double ball = 1, major = std::sqrt(4 - offset * offset), contact = offset / 2, reach = std::asin(offset / 2);

  [[nodiscard]] Point_3 blended(const Point_3& p) const {
    if (std::abs(p.x()) >= contact) return p;
    const double angle = reach * p.x() / contact, radius = major - ball * std::cos(angle);
    const double scale = radius / std::hypot(p.y(), p.z());
    return {ball * std::sin(angle), scale * p.y(), scale * p.z()};
  }
  [[nodiscard]] double deviation(const Point_3& p) const {
    if (std::abs(p.x()) < contact) return distance_to_torus(p, {0, 0, 0}, {1, 0, 0}, major, ball);
    return distance_to_sphere(p, {p.x() < 0 ? -offset : offset, 0, 0}, 1);
  }
};

/// Largest angle between faces, degrees, slivers apart: they show any error of position large.
double sharpest_angle(const Blend_mesh& mesh, double least_height) {
  const auto area_normal = [&](Halfedge h) {
    const auto [a, b, c] = corners_of(mesh, mesh.face(h));
    const Point_3& p = mesh.point(Vertex(a));
    return CGAL::cross_product(mesh.point(Vertex(b)) - p, mesh.point(Vertex(c)) - p);
  };
  double largest = 0;
  for (const Edge e : mesh.edges()) {
    const Halfedge h = mesh.halfedge(e);
    const Vector_3 n = area_normal(h), m = area_normal(mesh.opposite(h));
    const double length = distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
    if (std::sqrt(std::min(n.squared_length(), m.squared_length())) < least_height * length) continue;
    largest = std::max(largest, std::atan2(std::sqrt(CGAL::cross_product(n, m).squared_length()), n * m));
  }
  return largest * 180 / pi;
}

TEST(CoarseLevel, CarriesABlendToTheFineMesh) {
  const Curved_mesh fine = sphere_pair(6);
  const Rolled_spheres rolled;
  EXPECT_GT(sharpest_angle(fine.mesh, 5e-3), 70);
  double before = 1;
  for (const std::size_t faces : {1000, 4000, 16000}) {
    const Coarse_level level(fine.mesh, fine.curves, faces);
    const Blend_mesh result =
        restored(fine.mesh, level, mapped(level.mesh(), [&](const Point_3& p) { return rolled.blended(p); }));
    EXPECT_TRUE(validate(result).ok());
    double worst = 0;
    for (const Vertex v : result.vertices()) worst = std::max(worst, std::abs(rolled.deviation(result.point(v))));
    EXPECT_LT(worst, before / 2.5) << faces;
    before = worst;
    EXPECT_LT(sharpest_angle(result, 5e-3), faces < 4000 ? 25 : faces < 16000 ? 10 : 5) << faces;
  }
  EXPECT_LT(before, 1e-3);
}

TEST(CoarseLevel, ChangesOnlyWhatIsNearAndFadesOut) {
  const Curved_mesh fine = sphere_pair(6);
  const Coarse_level level(fine.mesh, fine.curves, 2000);
  Blend_mesh moved = level.mesh();
  Vertex tip = *moved.vertices().begin();
  for (const Vertex v : moved.vertices())
    if (moved.point(v).x() > moved.point(tip).x()) tip = v;
  const Point_3 at = moved.point(tip);
  moved.point(tip) = at + Vector_3(0.1, 0, 0);
  const Blend_mesh result = restored(fine.mesh, level, moved);
  const auto change = [&](Vertex v) { return result.point(v) - fine.mesh.point(v); };
  double reach = 0, steepest = 0;
  for (const Vertex v : fine.mesh.vertices())
    if (change(v) != CGAL::NULL_VECTOR) reach = std::max(reach, distance(fine.mesh.point(v), at));
  for (const Edge e : fine.mesh.edges()) {
    const Vertex v = fine.mesh.vertex(e, 0), w = fine.mesh.vertex(e, 1);
    const double length = distance(fine.mesh.point(v), fine.mesh.point(w));
    steepest = std::max(steepest, std::sqrt((change(v) - change(w)).squared_length()) / length);
  }
  EXPECT_GT(reach, 0.1);
  EXPECT_LT(reach, 0.5);  // two rings of coarse faces
  EXPECT_LT(steepest, 2);
}

TEST(CoarseLevel, DoesNotTakeTheOtherSideOfAThinWallForItsOwn) {
  const Curved_mesh fine{grid_box({0, 0, 0}, {1, 1, 0.01}, 40), {}};
  const Coarse_level level(fine.mesh, {}, 400);
  expect_sound(level);
  const auto is_upper = [](const Point_3& p) {
    return p.z() > 0.00999 && std::abs(p.x() - 0.5) < 0.3 && std::abs(p.y() - 0.5) < 0.3;
  };
  const Blend_mesh moved =
      mapped(level.mesh(), [&](const Point_3& p) { return is_upper(p) ? p + Vector_3(0, 0, 0.02) : p; });
  const Blend_mesh result = restored(fine.mesh, level, moved);
  for (const Vertex v : fine.mesh.vertices()) {
    const Point_3& p = fine.mesh.point(v);
    if (p.z() == 0) {
      EXPECT_EQ(result.point(v), p);
    } else if (p.z() == 0.01 && std::abs(p.x() - 0.5) < 0.1 && std::abs(p.y() - 0.5) < 0.1) {
      EXPECT_NEAR(result.point(v).z(), 0.03, 1e-3);
    }
  }
}

TEST(CoarseLevel, PassesOverVerticesWithoutFaces) {
  Curved_mesh fine = sphere_pair(4);
  const Vertex lonely = fine.mesh.add_vertex({5, 5, 5});
  const Coarse_level level(fine.mesh, fine.curves, 500);
  const auto moved = level.restore(transformed(level.mesh(), moved_by(1, 0, 0)));
  EXPECT_EQ(moved.size(), fine.mesh.number_of_vertices());
  EXPECT_EQ(moved.back(), std::make_pair(lonely, Point_3(6, 5, 5)));
}

TEST(CoarseLevel, DoesTheSameAtEverySize) {
  const Curved_mesh fine = sphere_pair(5);
  const auto bend = [](const Point_3& p) { return Point_3(p.x(), p.y() + 0.1 * p.x() * p.x(), p.z()); };
  const Coarse_level level(fine.mesh, fine.curves, 1000);
  const Blend_mesh bent = mapped(level.mesh(), bend), result = restored(fine.mesh, level, bent);
  for (const double size : {std::pow(2, -10), std::pow(2, 20)}) {  // scaling by powers of two is exact
    const auto scaled = [&](const Blend_mesh& mesh) {
      return transformed(mesh, placement({0, 0, 1}, 0, {0, 0, 0}, size));
    };
    const Coarse_level other(scaled(fine.mesh), fine.curves, 1000);
    EXPECT_TRUE(identical(other.mesh(), scaled(level.mesh()))) << size;
    EXPECT_EQ(other.curves(), level.curves()) << size;
    EXPECT_TRUE(identical(restored(scaled(fine.mesh), other, scaled(bent)), scaled(result))) << size;
  }
}

TEST(CoarseLevel, GivesTheSameBytesAgain) {
  const Curved_mesh fine = crossed_box();
  const Coarse_level a(fine.mesh, fine.curves, 900), b(fine.mesh, fine.curves, 900);
  EXPECT_TRUE(identical(a.mesh(), b.mesh()));
  EXPECT_EQ(a.curves(), b.curves());
  const Blend_mesh moved = transformed(a.mesh(), placement({0, 0, 1}, 0.1));
  EXPECT_EQ(a.restore(moved), b.restore(moved));
}

/// Prints how long it takes.
void report(const std::string& name, const Curved_mesh& fine, const Coarse_level& level) {
  const Blend_mesh moved = transformed(level.mesh(), moved_by(1, 0, 0));
  Stopwatch watch;
  const std::size_t restored_vertices = level.restore(moved).size();
  const double restoring = watch.milliseconds();
  EXPECT_EQ(restored_vertices, fine.mesh.number_of_vertices());
  std::cout << name << ": " << fine.mesh.number_of_faces() << " -> " << level.mesh().number_of_faces()
            << " faces, decimation " << level.milliseconds().decimation << " ms, encoding "
            << level.milliseconds().encoding << " ms, restoring " << restoring << " ms\n";
}

TEST(CoarseLevel, TakesTwoHundredFiftyThousandFaces) {
  const Blend_mesh ring = transformed(torus(1, 0.4, 600, 270), placement({1, 1, 0}, 0.4));
  const Curved_mesh fine = union_of(ring, sphere_aside(1.2, 4, 0.2));
  const Coarse_level level(fine.mesh, fine.curves, 2000);
  report("ring and sphere", fine, level);
  expect_same_curves(fine, level);
  expect_sound(level);
}

TEST(CoarseLevel, TakesAScan) {
  const std::string file = std::string(CGAL_BLEND_SHARED) + "/data/models/nefertiti_bust.off";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "models are not at hand";
  const Blend_mesh bust = read_mesh(file);
  CGAL::Bbox_3 box;
  for (const Vertex v : bust.vertices()) box += bust.point(v).bbox();
  const double height = box.zmax() - box.zmin();
  const Point_3 base((box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2, box.zmin());
  const Curved_mesh fine = union_of(bust, sphere(0.3 * height, 5, base));
  const Coarse_level level(fine.mesh, fine.curves, 3000);
  report("bust and sphere", fine, level);
  expect_same_curves(fine, level);
  expect_sound(level);
}

}  // namespace
}  // namespace cgal_blend::test
