// SPDX-License-Identifier: GPL-3.0-or-later
// Tessellated transitions: closed forms, topology by counting, rings kept, and what moves the shape.
#include "openings.h"
#include "slab_tessellation.h"

#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace cgal_blend::test {
namespace {

using Circles = std::vector<Circle>;
using Directed_edge = std::pair<std::size_t, std::size_t>;

Hermite_transition between(const Circles& low, const Circles& high, double height,
                           const Transition_options& options = {}) {
  return {{sections_of(low), sections_of(high)}, height, options};
}

std::size_t ring_vertices(const Hermite_transition& psi) {
  std::size_t count = 0;
  for (const std::size_t side : {0, 1})
    for (const Ring& ring : psi.rings(side)) count += ring.size();
  return count;
}

std::map<Directed_edge, int> directed_edges(const Slab_tessellation& t) {
  std::map<Directed_edge, int> edges;
  for (const auto& f : t.triangles)
    for (std::size_t i = 0; i < 3; ++i) ++edges[{f[i], f[(i + 1) % 3]}];
  return edges;
}

/// Vertices - edges + faces; each edge counted from its lesser end, or from its only face.
long euler_characteristic(const Slab_tessellation& t) {
  const auto edges = directed_edges(t);
  const auto count = std::count_if(edges.begin(), edges.end(), [&](const auto& e) {
    const auto [a, b] = e.first;
    return a < b || edges.count({b, a}) == 0;
  });
  return static_cast<long>(t.points.size()) - static_cast<long>(count) + static_cast<long>(t.triangles.size());
}

Blend_mesh mesh_of_tessellation(const Slab_tessellation& t) {
  std::vector<Corner_indices> faces(t.triangles.begin(), t.triangles.end());
  return mesh_of(t.points, faces);  // throws if it is no 2-manifold
}

/// Least angle of the facets; of those that touch a ring in `second`.
std::pair<double, double> least_angles(const Hermite_transition& psi, const Slab_tessellation& t) {
  const std::size_t rings = ring_vertices(psi);
  std::pair<double, double> least{180, 180};
  for (const auto& f : t.triangles) {
    double& of_kind = *std::min_element(f.begin(), f.end()) < rings ? least.second : least.first;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector_3 u = t.points[f[(i + 1) % 3]] - t.points[f[i]], v = t.points[f[(i + 2) % 3]] - t.points[f[i]];
      const double sine = std::sqrt(CGAL::cross_product(u, v).squared_length());
      of_kind = std::min(of_kind, std::atan2(sine, u * v) * 180 / pi);
    }
  }
  return least;
}

void expect_rings_kept(const Hermite_transition& psi, const Slab_tessellation& t) {
  const auto edges = directed_edges(t);
  std::size_t v = 0, borders = 0;
  for (const std::size_t side : {0, 1})
    for (const Ring& ring : psi.rings(side)) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        EXPECT_EQ(t.points[v + i], Point_3(ring[i].x(), ring[i].y(), side == 0 ? 0 : psi.height()));
        const Directed_edge e{v + i, v + (i + 1) % ring.size()};
        EXPECT_EQ(edges.count(e) + edges.count({e.second, e.first}), 1U);
      }
      v += ring.size();
    }
  for (const auto& [e, uses] : edges) {
    EXPECT_EQ(uses, 1);
    borders += edges.count({e.second, e.first}) == 0;
  }
  EXPECT_EQ(borders, v);
}

void expect_valid(const Hermite_transition& psi, const Slab_tessellation& t, double least_angle = 20) {
  ASSERT_TRUE(t.diagnosis.ok()) << message(t.diagnosis);
  expect_rings_kept(psi, t);
  EXPECT_FALSE(CGAL::Polygon_mesh_processing::does_self_intersect(mesh_of_tessellation(t)));
  const auto [inner, at_rings] = least_angles(psi, t);
  EXPECT_GT(inner, least_angle);
  EXPECT_GT(at_rings, 10);
  for (std::size_t v = ring_vertices(psi); v < t.points.size(); ++v) {
    EXPECT_GT(t.points[v].z(), 0);
    EXPECT_LT(t.points[v].z(), psi.height());
  }
}

/// Normals point to where Psi grows; but for a few facets on the creases of distances, where it hardly does.
void expect_oriented(const Hermite_transition& psi, const Slab_tessellation& t) {
  std::size_t wrong = 0;
  for (const auto& f : t.triangles) {
    const Point_3 &a = t.points[f[0]], &b = t.points[f[1]], &c = t.points[f[2]];
    const Vector_3 n = CGAL::cross_product(b - a, c - a);
    const Vector_3 step = 0.05 * std::sqrt((b - a).squared_length() / n.squared_length()) * n;
    const Point_3 m = CGAL::centroid(a, b, c);
    wrong += psi(m + step) <= psi(m - step);
  }
  EXPECT_LE(100 * wrong, t.triangles.size());
}

double radius_error(const Slab_tessellation& t, const Circle& low, const Circle& high, double height) {
  double largest = 0;
  for (const Point_3& p : t.points)
    largest = std::max(largest, std::abs(std::hypot(p.x(), p.y()) - hermite_radius(low, high, height, p.z() / height)));
  return largest / std::max(low.radius, high.radius);
}

struct Cones {
  Circle low, high;
  double height;
};

std::vector<Cones> coaxial_cones(int n) {
  return {{{1, 0, 0, n}, {1, 0, 0, n}, 1},
          {{1, 0, 0, n, 0.3}, {0.6, 0, 0, n, -0.2}, 1.5},
          {{1, 0, 0, n, -0.5}, {1.3, 0, 0, n, 0.5}, 2},
          {{0.7, 0, 0, n, 0.8}, {1, 0, 0, n}, 1},
          {{1, 0, 0, n, 2}, {1, 0, 0, n, -2}, 0.5}};
}

TEST(Slab_tessellation, coaxial_cones_follow_the_closed_form) {
  for (const auto& [low, high, height] : coaxial_cones(64)) {
    const Hermite_transition psi = between({low}, {high}, height);
    const Slab_tessellation t = tessellate_slab(psi);
    expect_valid(psi, t);
    expect_oriented(psi, t);
    EXPECT_LT(radius_error(t, low, high, height), 0.005);
    EXPECT_EQ(euler_characteristic(t), 0);
  }
}

TEST(Slab_tessellation, coaxial_cones_converge_with_order_two) {
  for (std::size_t i = 0; i < 3; ++i) {
    std::vector<double> errors;
    for (const int n : {48, 96, 192}) {
      const auto [low, high, height] = coaxial_cones(n)[i];
      errors.push_back(radius_error(tessellate_slab(between({low}, {high}, height)), low, high, height));
    }
    EXPECT_GT(std::log2(errors[0] / errors[2]) / 2, 1.8) << i;
  }
}

TEST(Slab_tessellation, thin_plates_come_near_the_closed_form) {
  for (const auto& [low, high, height] : coaxial_cones(64)) {
    if (low.slope > 1) continue;  // bulges far beyond where the plates were fitted
    const Hermite_transition psi = between({low}, {high}, height, {rbf_opening()});
    const Slab_tessellation t = tessellate_slab(psi);
    expect_valid(psi, t);
    EXPECT_LT(radius_error(t, low, high, height), 0.02);
  }
}

TEST(Slab_tessellation, sampled_distances_come_near_the_closed_form) {
  const auto [low, high, height] = coaxial_cones(64)[1];
  const Hermite_transition psi = between({low}, {high}, height, {distance_grid_opening()});
  const Slab_tessellation t = tessellate_slab(psi);
  expect_valid(psi, t);
  EXPECT_LT(radius_error(t, low, high, height), 0.005);
}

struct Topology {
  std::string name;
  Circles low, high;
  long characteristic;  ///< for each piece 2 - 2 * tunnels - rings
};

/// Three rings about the axis.
Circles three(double turn, double slope) {
  Circles circles;
  for (const double a : {turn, turn + 2 * pi / 3, turn + 4 * pi / 3})
    circles.push_back({0.6, 0.72 * std::cos(a), 0.72 * std::sin(a), 48, slope});
  return circles;
}

std::vector<Topology> topologies() {
  const Circle wide{1.2, 0, 0, 40, 0.3};
  return {{"1-2", {{1, 0, 0, 40, 0.3}}, {{0.5, -0.8, 0, 32, 0.2}, {0.5, 0.8, 0, 32, 0.2}}, -1},
          {"1-3", {wide}, {{0.4, -0.8, 0, 40}, {0.4, 0.8, 0, 40}, {0.3, 0, 1, 32}}, -2},
          {"1-4", {wide}, {{0.4, -0.8, 0, 40}, {0.4, 0.8, 0, 40}, {0.3, 0, 1, 32}, {0.3, 0, -1, 32}}, -3},
          {"2-2 apart", {{0.4, -1, 0, 40}, {0.4, 1, 0, 40}}, {{0.3, -1, 0.1, 40}, {0.3, 1, 0.1, 40}}, 0},
          // The axis is outside at all heights, so that a tunnel remains about it; or it is inside halfway.
          {"2-2 crossed about a tunnel",
           {{0.6, -0.65, 0, 32}, {0.6, 0.65, 0, 32}},
           {{0.6, 0, -0.65, 32}, {0.6, 0, 0.65, 32}},
           -4},
          {"2-2 crossed",
           {{0.6, -0.65, 0, 48, 0.2}, {0.6, 0.65, 0, 48, 0.2}},
           {{0.6, 0, -0.65, 48, -0.2}, {0.6, 0, 0.65, 48, -0.2}},
           -2},
          {"3-3 about a tunnel", three(0, 0), three(pi / 3, 0), -6},
          {"3-3", three(0, 0.6), three(pi / 3, -0.6), -4},
          {"3-3 apart",
           {{0.5, -0.8, 0, 32}, {0.5, 0.8, 0, 32}, {0.4, 0, 1, 32}},
           {{0.5, -0.7, -0.4, 32}, {0.5, 0.7, -0.4, 32}, {0.4, 0, 0.8, 32}},
           0},
          {"tube into tube",
           {{1, 0, 0, 40, 0.2}, {0.8, 0, 0, 40, 0.2}},
           {{1.2, 0.1, 0, 40, 0.2}, {0.9, 0.1, 0, 40, 0.2}},
           0},
          {"tube with a core",
           {{1, 0, 0, 40}, {0.7, 0, 0, 32}, {0.3, 0, 0, 20}},
           {{1, 0, 0, 40}, {0.75, 0, 0, 32}, {0.25, 0, 0, 20}},
           0}};
}

TEST(Slab_tessellation, any_numbers_of_rings) {
  for (const Topology& c : topologies())
    for (const Opening_model& model : {distance_opening(), rbf_opening()}) {
      SCOPED_TRACE(c.name);
      const Hermite_transition psi = between(c.low, c.high, 1.5, {model});
      const Slab_tessellation t = tessellate_slab(psi);
      expect_valid(psi, t);
      expect_oriented(psi, t);
      EXPECT_EQ(euler_characteristic(t), c.characteristic);
    }
}

TEST(Slab_tessellation, says_where_openings_are_not_joined) {
  const Circles one{{0.5, 0, 0, 48}}, far{{0.5, 30, 0, 48}}, tube{{1, 0, 0, 64}, {0.5, 0, 0, 64}},
      disk{{0.9, 0.1, 0, 64}};
  for (const auto& [low, high] : {std::pair(one, far), std::pair(tube, disk), std::pair(disk, tube)}) {
    const Slab_tessellation t = tessellate_slab(between(low, high, 1.5));
    EXPECT_EQ(t.diagnosis.status, Status::openings_not_joined);
    ASSERT_TRUE(t.diagnosis.point.has_value());
    const bool at_end = t.diagnosis.point->z() == 0 || t.diagnosis.point->z() == 1.5;
    EXPECT_TRUE(at_end) << *t.diagnosis.point;
    EXPECT_TRUE(t.triangles.empty());
  }
}

/// Where the surface crosses the line x = y = 0.
double height_on_axis(const Slab_tessellation& t) {
  for (const auto& f : t.triangles) {
    const Point_3 &a = t.points[f[0]], &b = t.points[f[1]], &c = t.points[f[2]];
    const auto area = [](const Point_3& p, const Point_3& q) { return p.x() * q.y() - p.y() * q.x(); };
    const double u = area(b, c), v = area(c, a), w = area(a, b);
    if ((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0))
      return (u * a.z() + v * b.z() + w * c.z()) / (u + v + w);
  }
  return -1;
}

double saddle_height(const Transition_options& options) {
  const Circles two{{0.5, -0.8, 0, 48, 0}, {0.5, 0.8, 0, 48, 0}};
  return height_on_axis(tessellate_slab(between({{1, 0, 0, 64}}, two, 1.5, options)));
}

TEST(Slab_tessellation, eta_moves_the_saddle) {
  double previous = 2;
  for (const double shift : {-0.3, -0.1, 0.1, 0.3}) {
    Transition_options options;
    options.eta = {0.4 + shift, 0.6 + shift};
    const double height = saddle_height(options);
    EXPECT_GT(height, 0);
    EXPECT_LT(height, previous - 0.02) << "the faster the upper side comes in, the lower";
    previous = height;
  }
}

TEST(Slab_tessellation, weights_move_the_saddle) {
  double previous = 0;
  for (const double weight : {0.3, 1.0, 3.0}) {  // of the lower side, that keeps its shape the longer
    Transition_options options;
    options.weight = {weight, 1};
    const double height = saddle_height(options);
    EXPECT_GT(height, previous + 0.1);
    previous = height;
  }
}

TEST(Slab_tessellation, gaps_much_narrower_than_sides) {
  for (const double gap : {0.1, 0.05, 0.02}) {  // sides are 0.05
    const double x = 0.5 + gap / 2;
    const Hermite_transition psi = between({{0.5, -x}, {0.5, x}}, {{1.2, 0.1}}, 1.5);
    const Slab_tessellation t = tessellate_slab(psi);
    expect_valid(psi, t);
    EXPECT_EQ(euler_characteristic(t), -1);
  }
}

TEST(Slab_tessellation, rho_moves_the_saddle) {
  double previous = 2;
  for (const double rho : {0.02, 0.06, 0.2}) {  // beyond, points have to be moved in
    const double height = saddle_height({rbf_opening({rho})});
    EXPECT_GT(height, 0);
    EXPECT_LT(height, previous - 0.005);
    previous = height;
  }
}

/// Fourier coefficient of r(a) = cos(12 a) at a height, by least squares over the vertices near it.
double twelfth_harmonic(const Slab_tessellation& t, double z, double band) {
  double n = 0, c = 0, cc = 0, r = 0, rc = 0;
  for (const Point_3& p : t.points) {
    if (std::abs(p.z() - z) > band) continue;
    const double cosine = std::cos(12 * std::atan2(p.y(), p.x())), radius = std::hypot(p.x(), p.y());
    n += 1;
    c += cosine;
    cc += cosine * cosine;
    r += radius;
    rc += radius * cosine;
  }
  return (n * rc - c * r) / (n * cc - c * c);
}

TEST(Slab_tessellation, detail_fades_as_its_weight_does) {
  const double amplitude = 0.05, height = 1;
  const Hermite_transition psi({upright({wavy_ring(1, amplitude, 12, 240)}), upright({ring_of({1, 0, 0, 240})})},
                               height, {});
  const Slab_tessellation t = tessellate_slab(psi);
  expect_valid(psi, t);
  EXPECT_NEAR(twelfth_harmonic(t, 0, 1e-9), amplitude, 1e-3);
  EXPECT_NEAR(twelfth_harmonic(t, height, 1e-9), 0, 1e-6);
  double previous = amplitude;
  for (const double z : {0.2, 0.4, 0.6, 0.8}) {
    const double found = twelfth_harmonic(t, z, 0.02);
    EXPECT_NEAR(found, amplitude * hermite_basis(z)[0], 0.12 * amplitude) << z;
    EXPECT_LT(found, previous);
    previous = found;
  }
}

TEST(Slab_tessellation, facets_grade_from_a_coarse_ring_to_a_fine_one) {
  const Hermite_transition psi = between({{1, 0, 0, 16}}, {{1, 0, 0, 256}}, 2);
  const Slab_tessellation t = tessellate_slab(psi);
  expect_valid(psi, t);
  std::array<double, 8> sum{}, count{};
  for (const auto& f : t.triangles) {
    std::array<double, 3> length{};
    for (std::size_t i = 0; i < 3; ++i)
      length[i] = std::sqrt(CGAL::squared_distance(t.points[f[i]], t.points[f[(i + 1) % 3]]));
    const double z = CGAL::centroid(t.points[f[0]], t.points[f[1]], t.points[f[2]]).z();
    sum[std::min<std::size_t>(7, static_cast<std::size_t>(z * 4))] +=
        std::accumulate(length.begin(), length.end(), 0.0) / 3;
    ++count[std::min<std::size_t>(7, static_cast<std::size_t>(z * 4))];
    EXPECT_LT(*std::max_element(length.begin(), length.end()), 3 * *std::min_element(length.begin(), length.end()));
  }
  for (std::size_t i = 4; i < 8; ++i) {
    EXPECT_LT(sum[i] / count[i], 0.95 * sum[i - 1] / count[i - 1]);
    EXPECT_GT(sum[i] / count[i], 0.3 * sum[i - 1] / count[i - 1]);
  }
  EXPECT_LT(sum[7] / count[7], 5 * 2 * pi / 256);
}

double longest_edge(const Slab_tessellation& t) {
  double longest = 0;
  for (const auto& [e, uses] : directed_edges(t))
    longest = std::max(longest, std::sqrt(CGAL::squared_distance(t.points[e.first], t.points[e.second])));
  return longest;
}

TEST(Slab_tessellation, options_set_the_size_of_facets) {
  const Hermite_transition psi = between({{1}}, {{1}}, 3);
  const double of_rings = 2 * pi / 64;
  Slab_options options;
  EXPECT_LT(longest_edge(tessellate_slab(psi, options)), 2 * of_rings);
  options.grading = 4;
  const Slab_tessellation graded = tessellate_slab(psi, options);
  expect_valid(psi, graded);
  EXPECT_GT(longest_edge(graded), 2.5 * of_rings);
  EXPECT_LT(longest_edge(graded), 8 * of_rings);
  options = {};
  options.edge = of_rings / 3;
  const Slab_tessellation fine = tessellate_slab(psi, options);
  expect_valid(psi, fine);
  EXPECT_GT(fine.points.size(), 3 * tessellate_slab(psi).points.size());
}

/// Extra vertices on a ring's sides, from 1e-3 to 1/2 of a side away from its vertices.
Ring uneven(const Ring& ring) {
  Ring result;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    result.push_back(ring[i]);
    const double at = std::pow(10, -3 + 3 * std::fmod(0.618 * static_cast<double>(i), 1)) / 2;
    if (i % 5 == 0) result.push_back(ring[i] + at * (ring[(i + 1) % ring.size()] - ring[i]));
  }
  return result;
}

TEST(Slab_tessellation, short_sides_do_not_make_all_fine) {
  const Ring even = ring_of({1});
  const auto plain = tessellate_slab({{upright({even}), upright({even})}, 2, {}});
  const Hermite_transition psi({upright({uneven(even)}), upright({even})}, 2, {});
  const Slab_tessellation t = tessellate_slab(psi);
  ASSERT_TRUE(t.diagnosis.ok()) << message(t.diagnosis);
  expect_rings_kept(psi, t);
  EXPECT_FALSE(CGAL::Polygon_mesh_processing::does_self_intersect(mesh_of_tessellation(t)));
  EXPECT_GT(least_angles(psi, t).first, 20);
  EXPECT_LT(t.points.size(), 2 * plain.points.size());
}

TEST(Slab_tessellation, coarse_rings) {
  const Ring square{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}, triangle{{0.9, 0}, {-0.5, 0.8}, {-0.5, -0.8}};
  for (const double height : {0.05, 0.5, 3.0})
    for (const Opening_model& model : {distance_opening(), rbf_opening()}) {
      const Hermite_transition psi({upright({square}), upright({triangle})}, height, {model});
      const Slab_tessellation t = tessellate_slab(psi);
      ASSERT_TRUE(t.diagnosis.ok()) << message(t.diagnosis);
      expect_rings_kept(psi, t);
      EXPECT_FALSE(CGAL::Polygon_mesh_processing::does_self_intersect(mesh_of_tessellation(t)));
      EXPECT_EQ(euler_characteristic(t), 0);
    }
}

double area_of(const Slab_tessellation& t) {
  double sum = 0;
  for (const auto& f : t.triangles)
    sum += std::sqrt(
        CGAL::cross_product(t.points[f[1]] - t.points[f[0]], t.points[f[2]] - t.points[f[0]]).squared_length());
  return sum / 2;
}

TEST(Slab_tessellation, does_not_depend_on_scale_place_and_direction) {
  const Opening_sections low = sections_of({{1, 0, 0, 64, 0.3}});
  const Opening_sections high = sections_of({{0.5, -0.8, 0, 48, 0.2}, {0.5, 0.8, 0, 48, 0.2}});
  const double area = area_of(tessellate_slab({{low, high}, 1.5, {}}));
  struct Motion {
    double scale, turn, x;
  };
  for (const auto& [scale, turn, x] : {Motion{1e-3, 0, 0}, Motion{1e6, 0, 0}, Motion{1, 0.3, 0}, Motion{1, 2, 100}}) {
    const auto map = [s = scale * std::sin(turn), c = scale * std::cos(turn), x = x](const Point_2& p) {
      return Point_2(c * p.x() - s * p.y() + x, s * p.x() + c * p.y());
    };
    std::array<Opening_sections, 2> sides{mapped(low, map), mapped(high, map)};
    for (Opening_sections& side : sides) side.step *= scale;
    const Hermite_transition psi(sides, 1.5 * scale, {});
    const Slab_tessellation t = tessellate_slab(psi);
    expect_valid(psi, t);
    EXPECT_EQ(euler_characteristic(t), -1);
    EXPECT_NEAR(area_of(t) / (scale * scale), area, 0.002 * area);
  }
}

TEST(Slab_tessellation, is_deterministic) {
  const Hermite_transition psi = between({{1, 0, 0, 64, 0.3}}, {{0.5, -0.8}, {0.5, 0.8}}, 1.5, {rbf_opening()});
  const Slab_tessellation a = tessellate_slab(psi);
  const Slab_tessellation b =
      tessellate_slab(between({{1, 0, 0, 64, 0.3}}, {{0.5, -0.8}, {0.5, 0.8}}, 1.5, {rbf_opening()}));
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.triangles, b.triangles);
}

TEST(Slab_tessellation, can_be_stopped) {
  Slab_options options;
  options.progress = [](double) { return false; };
  const Slab_tessellation t = tessellate_slab(between({{1}}, {{1}}, 1), options);
  EXPECT_EQ(t.diagnosis.status, Status::cancelled);
  EXPECT_TRUE(t.triangles.empty());
}

}  // namespace
}  // namespace cgal_blend::test
