// SPDX-License-Identifier: GPL-3.0-or-later
// Mapping of a blending region with exact ball positions: on the torus to rounding of the profiles' chords.
#include "blends.h"
#include "map_region.h"

#include <CGAL/boost/graph/iterator.h>
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <unordered_set>
#include <utility>
#include <vector>

namespace cgal_blend::test {
namespace {

constexpr double R = 15, r = 5;

/// A boss on a round plate with the blend at its foot, known exactly.
struct Foot {
  Blend_mesh mesh;
  std::vector<Vertex> curve;
  std::vector<Ball_position> positions;
  std::unordered_set<Vertex> between;

  explicit Foot(double step, std::size_t balls) : mesh(boss_on_plate(R, 40, 5, 30, step)) {
    std::vector<std::pair<double, Vertex>> by_azimuth;
    for (const Vertex v : mesh.vertices()) {
      const Point_3& p = mesh.point(v);
      const double rho = std::hypot(p.x(), p.y());
      const bool on_curve = p.z() == 0 && std::abs(rho - R) < 1e-9;
      if (on_curve) by_azimuth.emplace_back(std::atan2(p.y(), p.x()), v);
      if (on_curve || (p.z() == 0 && rho > R && rho < R + r - 1e-9) ||
          (p.z() > 0 && p.z() < r - 1e-9 && std::abs(rho - R) < 1e-9))
        between.insert(v);
    }
    std::sort(by_azimuth.begin(), by_azimuth.end());
    for (const auto& [azimuth, v] : by_azimuth) curve.push_back(v);
    for (std::size_t i = 0; i < balls; ++i) {
      const double around = -pi + 2 * pi * (static_cast<double>(i) + 0.5) / static_cast<double>(balls);
      const Vec out{std::cos(around), std::sin(around), 0};
      Ball_position p;
      p.center = (R + r) * out + Vec{0, 0, r};
      p.radius = r;
      p.contact = {R * out + Vec{0, 0, r}, (R + r) * out};  // anticlockwise: the boss is on the left, the plate right
      p.foot = {Surface_point{*mesh.faces().begin(), Vec::Constant(1.0 / 3)},
                Surface_point{*mesh.faces().begin(), Vec::Constant(1.0 / 3)}};
      positions.push_back(p);
    }
  }
  [[nodiscard]] Virtual_surface surface(const Profile& profile = Arc_profile()) const {
    const Base_surface base(mesh, {});
    return Virtual_surface(positions, {&base, &base}, profile);
  }
  [[nodiscard]] Region_mapping map(const Virtual_surface& surface, std::size_t attempt = 0) const {
    return map_region(mesh, curve, between, surface, positions, attempt);
  }
};

double off_torus(const Vec& p) { return distance_to_torus(to_point(p), {0, 0, r}, {0, 0, 1}, R + r, r); }

/// Height of the chords between ball positions over the circle that they stand on.
double chord_height(std::size_t balls) { return (R + r) * (1 - std::cos(pi / static_cast<double>(balls))); }

Blend_mesh moved(const Foot& foot, const Region_mapping& mapping) {
  Blend_mesh mesh = foot.mesh;
  for (const auto& [v, to] : mapping.border) mesh.point(v) = to_point(to);
  for (const auto& [v, to] : mapping.interior) mesh.point(v) = to_point(to);
  return mesh;
}

TEST(Map_region, InnerVerticesAreOnTheTorus) {
  for (const double step : {2.1, 1.05, 0.7})
    for (const std::size_t balls : {100, 4000}) {
      const Foot foot(step, balls);
      const Virtual_surface surface = foot.surface();
      const Region_mapping mapping = foot.map(surface);
      ASSERT_TRUE(mapping.diagnosis.ok()) << name(mapping.diagnosis.status);
      for (const auto& [v, to] : mapping.interior) EXPECT_LT(std::abs(off_torus(to)), 1.01 * chord_height(balls));
      for (const auto& [v, to] : mapping.border) EXPECT_LT(std::abs(off_torus(to)), 1.01 * chord_height(balls));
      EXPECT_TRUE(validate(moved(foot, mapping)).ok());
    }
}

TEST(Map_region, MovesEveryVertexBetweenTheLinkageCurvesAndNoOther) {
  const Foot foot(1.05, 400);
  const Region_mapping mapping = foot.map(foot.surface());
  ASSERT_TRUE(mapping.diagnosis.ok());
  std::set<Vertex> inner, border;
  for (const auto& [v, to] : mapping.interior) inner.insert(v);
  for (const auto& [v, to] : mapping.border) border.insert(v);
  EXPECT_EQ(inner, std::set<Vertex>(foot.between.begin(), foot.between.end()));
  std::set<Face> faces;
  for (const Vertex v : inner)
    for (const Face f : foot.mesh.faces_around_target(foot.mesh.halfedge(v))) faces.insert(f);
  EXPECT_EQ(faces, std::set<Face>(mapping.faces.begin(), mapping.faces.end()));
  EXPECT_EQ(faces.size(), mapping.faces.size());
  for (const Vertex v : border) {  // next to the inner ones, and not of them
    EXPECT_EQ(inner.count(v), 0u);
    bool touches = false;
    for (const Vertex w : foot.mesh.vertices_around_target(foot.mesh.halfedge(v))) touches = touches || inner.count(w);
    EXPECT_TRUE(touches);
  }
  // Those of the border stay on their side's surface, and near.
  for (const auto& [v, to] : mapping.border) {
    EXPECT_LT(std::min(std::abs(to.z()), std::abs(std::hypot(to.x(), to.y()) - R)), 1.01 * chord_height(400));
    EXPECT_LT((to - to_vec(foot.mesh.point(v))).norm(), 1.05);
  }
}

TEST(Map_region, SpreadsVerticesOverTheProfile) {
  // The mesh and the blend are symmetric under a turn, so is the image but for the cut; the angle seen from the spine
  // grows from layer to layer.
  const Foot foot(0.7, 2000);
  const Region_mapping mapping = foot.map(foot.surface());
  ASSERT_TRUE(mapping.diagnosis.ok());
  struct Layer {
    double low = 10, high = -10, azimuth = 0;
  };
  std::map<double, Layer> layers;  // by distance from the curve along the body, boss negative
  for (const auto& [v, to] : mapping.interior) {
    const Point_3& p = foot.mesh.point(v);
    const double layer = std::round(1e6 * (std::hypot(p.x(), p.y()) - R - p.z())) / 1e6;
    const double angle = std::atan2(R + r - std::hypot(to.x(), to.y()), r - to.z());  // 0 over the plate
    Layer& at = layers[layer];
    at.low = std::min(at.low, angle);
    at.high = std::max(at.high, angle);
    at.azimuth =
        std::max(at.azimuth, std::abs(std::remainder(std::atan2(to.y(), to.x()) - std::atan2(p.y(), p.x()), 2 * pi)));
  }
  ASSERT_GE(layers.size(), 11u);
  double last = pi / 2;
  for (const auto& [distance, layer] : layers) {
    EXPECT_LT(layer.high, last) << distance;
    last = layer.low;
    EXPECT_LT(layer.high - layer.low, 0.03) << distance;
    EXPECT_LT(layer.azimuth, 0.05) << "no layer turns about the boss";
  }
}

TEST(Map_region, KeepsCornersOfTheProfileOnTheCurve) {
  // The corner of the sharp profile is where the curve was: nothing moves off the body.
  const Foot foot(1.05, 2000);
  const Virtual_surface surface = foot.surface(sharp_profile());
  const Region_mapping mapping = foot.map(surface);
  ASSERT_TRUE(mapping.diagnosis.ok());
  std::set<Vertex> curve(foot.curve.begin(), foot.curve.end());
  for (const auto& [v, to] : mapping.interior) {
    const double on_boss = std::abs(std::hypot(to.x(), to.y()) - R), on_plate = std::abs(to.z());
    if (curve.count(v)) {
      EXPECT_LT(std::max(on_boss, on_plate), 2 * chord_height(2000));
    } else {
      EXPECT_LT(std::min(on_boss, on_plate), 2 * chord_height(2000));
    }
  }
}

TEST(Map_region, CoarsenessFallsWithRefinement) {
  std::vector<double> coarseness;
  for (const double step : {2.8, 1.4, 0.7}) {
    const Foot foot(step, 2000);
    const Region_mapping mapping = foot.map(foot.surface());
    ASSERT_TRUE(mapping.diagnosis.ok());
    EXPECT_LT(mapping.coarseness, step * step / (2 * r)) << "a chord's height over an arc of radius r, and some";
    coarseness.push_back(mapping.coarseness);
  }
  EXPECT_GT(order(coarseness[0], coarseness[1]), 1.3);
  EXPECT_GT(order(coarseness[1], coarseness[2]), 1.3);
}

TEST(Map_region, EveryAttemptIsOnTheSurface) {
  const Foot foot(1.05, 2000);
  const Virtual_surface surface = foot.surface();
  for (std::size_t attempt = 0; attempt < mapping_attempts; ++attempt) {
    const Region_mapping mapping = foot.map(surface, attempt);
    ASSERT_TRUE(mapping.diagnosis.ok());
    for (const auto& [v, to] : mapping.interior) EXPECT_LT(std::abs(off_torus(to)), 1.01 * chord_height(2000));
  }
}

TEST(Map_region, RefusesWhatIsNoAnnulus) {
  Foot foot(1.05, 400);
  const Virtual_surface surface = foot.surface();
  const auto status = [&] { return foot.map(surface).diagnosis.status; };
  // The region reaches over the top of the boss, and has no inner border.
  const std::unordered_set<Vertex> between = foot.between;
  for (const Vertex v : foot.mesh.vertices()) {
    const Point_3& p = foot.mesh.point(v);
    if (std::hypot(p.x(), p.y()) < R + 1e-9 && p.z() >= 0) foot.between.insert(v);
  }
  EXPECT_EQ(status(), Status::region_not_annular);
  // A vertex of the curve that stays where it is.
  foot.between = between;
  foot.between.erase(foot.curve[5]);
  EXPECT_EQ(status(), Status::region_not_annular);
  // A curve that is none.
  foot.between = between;
  std::swap(foot.curve[5], foot.curve[20]);
  EXPECT_EQ(status(), Status::region_not_annular);
  foot.curve.resize(2);
  EXPECT_EQ(status(), Status::region_not_annular);
}

}  // namespace
}  // namespace cgal_blend::test
