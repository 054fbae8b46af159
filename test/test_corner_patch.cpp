// SPDX-License-Identifier: GPL-3.0-or-later
// Corners: loops of great circle arcs, and others, filled over the ball; areas and angles in closed form.
#include "checks.h"
#include "corner_patch.h"
#include "shapes.h"

#include <cgal_blend/validate.h>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace cgal_blend::test {
namespace {

/// On the unit sphere, degrees.
Vec at(double longitude, double latitude) {
  const double a = longitude * pi / 180, b = latitude * pi / 180;
  return {std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b)};
}

/// Points of the great circle arcs between directions, in steps of about the given size in radians.
std::vector<Vec> arcs(const std::vector<Vec>& corners, double step) {
  std::vector<Vec> points;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec a = corners[i].normalized(), b = corners[(i + 1) % corners.size()].normalized();
    const double angle = angle_between(a, b);
    const int n = std::max(1, static_cast<int>(std::lround(angle / step)));
    points.push_back(a);
    for (int k = 1; k < n; ++k)
      points.push_back(
          ((std::sin(angle * (n - k) / n) * a + std::sin(angle * k / n) * b) / std::sin(angle)).normalized());
  }
  return points;
}

/// A loop in a mesh, and what fills it.
struct Corner_patch {
  Blend_mesh mesh;
  std::vector<Vertex> loop;
  Vec center;
  std::vector<Triangle> triangles;

  /// \param points of the loop, relative to the centre
  Corner_patch(const std::vector<Vec>& points, double spacing, const Vec& center = Vec::Zero()) : center(center) {
    mesh.add_vertex({1e3, 0, 0});  // vertices of the loop need not be the first
    for (const Vec& p : points) loop.push_back(mesh.add_vertex(to_point(center + p)));
    triangles = tessellate_corner(mesh, center, loop, spacing);
  }

  [[nodiscard]] double distance(Vertex v) const { return (to_vec(mesh.point(v)) - center).norm(); }

  /// The triangles, and with a fan the faces that join the loop to the centre.
  [[nodiscard]] Blend_mesh surface(bool with_fan) const {
    std::vector<Point_3> points;
    std::vector<Corner_indices> faces;
    for (const Vertex v : mesh.vertices()) points.push_back(mesh.point(v));
    points.push_back(to_point(center));
    for (const Triangle& t : triangles) faces.push_back({t[0], t[1], t[2]});
    for (std::size_t i = 0; with_fan && i < loop.size(); ++i)
      faces.push_back({loop[(i + 1) % loop.size()], loop[i], points.size() - 1});
    return mesh_of(points, faces);
  }

  /// Solid angle seen from the centre. Source: Van Oosterom and Strackee (1983).
  [[nodiscard]] double solid_angle() const {
    double sum = 0;
    for (const Triangle& t : triangles) {
      std::array<Vec, 3> d;
      for (int i = 0; i < 3; ++i) d[i] = (to_vec(mesh.point(t[i])) - center).normalized();
      sum += 2 * std::atan2(d[0].dot(d[1].cross(d[2])), 1 + d[0].dot(d[1]) + d[1].dot(d[2]) + d[2].dot(d[0]));
    }
    return sum;
  }
};

/// Area of a convex spherical polygon, counterclockwise, by the sum of its angles.
double area_of_polygon(const std::vector<Vec>& corners) {
  const std::size_t n = corners.size();
  double area = 2 * pi;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec &a = corners[(i + n - 1) % n], &b = corners[i], &c = corners[(i + 1) % n];
    area -= angle_between(a.cross(b), b.cross(c));
  }
  return area;
}

/// Everything that holds for any loop on the unit sphere.
void check(const std::vector<Vec>& points, double area, double spacing, double least_angle, const std::string& name) {
  SCOPED_TRACE(name);
  const Corner_patch patch(points, spacing);
  ASSERT_FALSE(patch.triangles.empty());
  EXPECT_TRUE(fill_exactly(patch.triangles, patch.loop));
  for (const Vertex v : patch.mesh.vertices())
    if (v != Vertex(0)) {
      EXPECT_NEAR(patch.distance(v), 1, 1e-12);
    }
  EXPECT_NEAR(patch.solid_angle(), area, 1e-9);
  EXPECT_GT(smallest_angle_deg(patch.surface(false)), least_angle);
  const Blend_mesh glued = patch.surface(true);
  EXPECT_TRUE(is_closed_by_counting(glued));
  EXPECT_TRUE(has_single_fans(glued));
  EXPECT_TRUE(validate(glued).ok()) << message(validate(glued).diagnosis);

  const Corner_patch turned({points.rbegin(), points.rend()}, spacing);
  EXPECT_TRUE(fill_exactly(turned.triangles, turned.loop));
  EXPECT_NEAR(turned.solid_angle(), -area, 1e-9);
  EXPECT_GT(smallest_angle_deg(turned.surface(false)), least_angle);
  EXPECT_TRUE(validate(inside_out(turned.surface(true))).ok());
}

const std::vector<Vec> octant{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

double step_for(double chord_tolerance) { return 2 * std::acos(1 - chord_tolerance); }

TEST(Corner_patch, FillsAnOctantWithOrderTwo) {
  const double r = 3;
  const Vec center{7, -5, 11};
  std::vector<double> errors;
  for (const double tolerance : {0.02, 0.002, 0.0002, 0.00002}) {
    const double step = step_for(tolerance);
    std::vector<Vec> points = arcs(octant, step);
    for (Vec& p : points) p *= r;
    const Corner_patch patch(points, r * step, center);
    ASSERT_TRUE(fill_exactly(patch.triangles, patch.loop)) << tolerance;
    for (const Triangle& t : patch.triangles)
      for (const Vertex v : t) EXPECT_NEAR(patch.distance(v), r, 1e-12 * center.norm());
    const Blend_mesh surface = patch.surface(false);
    EXPECT_GT(smallest_angle_deg(surface), 25) << tolerance;
    errors.push_back(pi * r * r / 2 - area_of(surface));
    EXPECT_GT(errors.back(), 0) << "chords lie inside";
  }
  // A tenth of the tolerance is a step shorter by the root of ten.
  for (std::size_t i = 1; i < errors.size(); ++i)
    EXPECT_NEAR(std::log10(errors[i - 1] / errors[i]) / std::log10(std::sqrt(10)), 2, 0.3);
  EXPECT_NEAR(std::log10(errors.front() / errors.back()) / std::log10(std::sqrt(1000)), 2, 0.1);
}

TEST(Corner_patch, IsRightForAnyNumberOfSegments) {
  for (int n = 1; n <= 20; ++n)
    check(arcs(octant, pi / 2 / n), pi / 2, 2 * std::sin(pi / 4 / n), 25, "octant in " + std::to_string(n));
}

TEST(Corner_patch, SpacesItsVertices) {
  const double step = step_for(0.002);
  for (const double spacing : {step / 4, step, 3 * step}) {
    const Corner_patch patch(arcs(octant, step), spacing);
    const Blend_mesh surface = patch.surface(false);
    double at_loop = 0, inside = 0;  // mean length of the edges that touch the loop, and of those near the middle
    int edges_at_loop = 0, edges_inside = 0;
    const std::size_t last = patch.loop.back();
    for (const Edge e : surface.edges()) {
      const std::size_t a = surface.vertex(e, 0), b = surface.vertex(e, 1);
      const Vec p = to_vec(surface.point(Vertex(a))), q = to_vec(surface.point(Vertex(b)));
      if ((a <= last) != (b <= last)) {
        at_loop += (p - q).norm();
        ++edges_at_loop;
      } else if (a > last && p.minCoeff() > 0.4) {
        inside += (p - q).norm();
        ++edges_inside;
      }
    }
    EXPECT_NEAR(at_loop / edges_at_loop / step, 1, 0.4) << spacing;
    ASSERT_GT(edges_inside, 0) << spacing;
    EXPECT_NEAR(inside / edges_inside / std::min(spacing, 2.2 * step), 1, 0.25) << spacing;
  }
}

TEST(Corner_patch, FillsPolygonsOfManyShapes) {
  const double step = step_for(0.002);
  const auto with_step = [&](const std::vector<Vec>& corners, double step, double least_angle,
                             const std::string& name) {
    check(arcs(corners, step), area_of_polygon(corners), step, least_angle, name);
  };
  const auto with = [&](const std::vector<Vec>& corners, double least_angle, const std::string& name) {
    with_step(corners, step, least_angle, name);
  };
  with({at(0, 20), at(90, 20), at(180, 20), at(270, 20)}, 25, "quadrilateral");
  with({at(0, 40), at(72, 40), at(144, 40), at(216, 40), at(288, 40)}, 25, "pentagon");
  with({at(0, 0), at(20, 0), at(0, 90)}, 15, "thin, 20 degrees");
  with({at(0, 0), at(20, 0), at(10, 50)}, 15, "thin and short");
  with({at(0, 0), at(5, 0), at(2.5, 40)}, 5, "very thin");
  with({at(0, 0), at(150, 0), at(280, 20)}, 25, "arcs of 150, 123 and 80 degrees");
  with({at(0, -60), at(150, -60), at(75, 60)}, 25, "two long arcs");
  with({at(0, 0), at(150, 0), at(75, 20)}, 15, "long and flat");
  for (const double latitude : {1.0, 0.1, 0.001})
    with({at(0, latitude), at(120, latitude), at(240, latitude)}, 25, "almost a hemisphere");
  with({at(0, 0), at(100, 0), at(0, 1e-6 + 60)}, 25, "a corner on the equator");
  with_step({at(0, 89.9), at(120, 89.9), at(240, 89.9)}, 1, 55, "one triangle");
  with_step({at(0, 89.9), at(90, 89.9), at(180, 89.9), at(270, 89.9)}, 1, 40, "two triangles");
  with_step({at(0, 80), at(90, 80), at(180, 80), at(270, 80)}, 0.1, 25, "small");
  with_step({at(0, 90 - 1e-5), at(130, 90 - 1e-5), at(240, 90 - 1e-5)}, 1e-7, 25, "tiny");
}

TEST(Corner_patch, FillsRandomConvexPolygons) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int trial = 0; trial < 60; ++trial) {
    const int n = 3 + trial % 5;
    std::vector<double> turns;
    for (int i = 0; i < n; ++i) turns.push_back(2 * pi * (i + 0.8 * uniform(random)) / n);
    // On an elliptic cone; a turned one, wide or narrow.
    const double a = std::tan(1.4 * uniform(random) + 0.1), b = a * (0.3 + 0.7 * uniform(random));
    const Eigen::Quaterniond turn =
        Eigen::Quaterniond(uniform(random) - 0.5, uniform(random) - 0.5, uniform(random) - 0.5, uniform(random) - 0.5)
            .normalized();
    std::vector<Vec> corners;
    for (const double t : turns) corners.push_back(turn * Vec(a * std::cos(t), b * std::sin(t), 1).normalized());
    const double step = 0.05 + 0.1 * uniform(random);
    const std::vector<Vec> points = arcs(corners, step);
    double least_angle = 180;
    for (int i = 0; i < n; ++i) {
      const Vec &before = corners[(i + n - 1) % n], &at = corners[i], &after = corners[(i + 1) % n];
      least_angle = std::min(least_angle, angle_between(at.cross(before), at.cross(after)) * 180 / pi);
    }
    check(points, area_of_polygon(corners), step, std::min(15.0, 0.5 * least_angle), "trial " + std::to_string(trial));
  }
}

TEST(Corner_patch, FillsLoopsThatAreNotConvex) {
  std::vector<Vec> points;
  for (int i = 0; i < 90; ++i) points.push_back(at(4 * i, 50 + 15 * std::sin(12 * pi * i / 90)));
  const Corner_patch patch(points, 0.06);
  ASSERT_TRUE(fill_exactly(patch.triangles, patch.loop));
  EXPECT_TRUE(validate(patch.surface(true)).ok());
  EXPECT_GT(smallest_angle_deg(patch.surface(false)), 20);
}

TEST(Corner_patch, InterpolatesDistances) {
  // Chamfers: straight lines between points of the axes, or at different distances.
  for (const Vec& size : {Vec{1, 1, 1}, Vec{1, 1.2, 0.8}}) {
    std::vector<Vec> points;
    const int n = 12;
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < n; ++k) {
        const int j = (i + 1) % 3;
        points.push_back((1 - 1.0 * k / n) * size[i] * Vec::Unit(i) + 1.0 * k / n * size[j] * Vec::Unit(j));
      }
    const Corner_patch patch(points, 0.1);
    ASSERT_TRUE(fill_exactly(patch.triangles, patch.loop));
    EXPECT_TRUE(validate(patch.surface(true)).ok());
    double least = 10, most = 0;
    for (const Vertex v : patch.loop) {
      least = std::min(least, patch.distance(v));
      most = std::max(most, patch.distance(v));
    }
    for (const Triangle& t : patch.triangles)
      for (int i = 0; i < 3; ++i) {
        EXPECT_GE(patch.distance(t[i]), least - 1e-12);
        EXPECT_LE(patch.distance(t[i]), most + 1e-12);
        const double step = (to_vec(patch.mesh.point(t[i])) - to_vec(patch.mesh.point(t[(i + 1) % 3]))).norm();
        EXPECT_LT(std::abs(patch.distance(t[i]) - patch.distance(t[(i + 1) % 3])), 0.9 * step) << "no cliffs";
      }
  }
}

TEST(Corner_patch, DoesNotDependOnSize) {
  const double step = step_for(0.002);
  const std::vector<Vec> points = arcs({at(0, 30), at(100, 10), at(200, 40), at(310, 20)}, step);
  const Corner_patch one(points, step);
  for (const double r : {1.0, 1.0 / 1024, 1024.0 * 1024}) {  // powers of two: the same bits
    std::vector<Vec> larger;
    for (const Vec& p : points) larger.emplace_back(r * p);
    const Corner_patch other(larger, r * step);
    EXPECT_EQ(one.triangles, other.triangles);
    for (const Triangle& t : one.triangles)
      for (const Vertex v : t) EXPECT_EQ(to_vec(other.mesh.point(v)), r * to_vec(one.mesh.point(v)));
  }
}

TEST(Corner_patch, RefusesWhatIsNoLoop) {
  const double step = 0.1;
  const auto refused = [&](const std::vector<Vec>& points) {
    for (const bool reversed : {false, true}) {
      Corner_patch patch(reversed ? std::vector<Vec>{points.rbegin(), points.rend()} : points, step);
      if (!patch.triangles.empty() || patch.mesh.number_of_vertices() != points.size() + 1) return false;
    }
    return true;
  };
  EXPECT_TRUE(refused({}));
  EXPECT_TRUE(refused({at(0, 0), at(10, 0)}));
  EXPECT_TRUE(refused({at(0, 0), at(10, 0), Vec::Zero()})) << "the centre";
  EXPECT_TRUE(refused({at(0, 0), at(10, 0), Vec{0, 0, std::numeric_limits<double>::quiet_NaN()}}));
  EXPECT_TRUE(refused({at(0, 0), at(10, 0), at(10, 0), at(0, 10)})) << "a step of no length";
  EXPECT_TRUE(refused({at(0, 0), at(10, 0), 2 * at(10, 0), at(0, 10)})) << "a step towards the centre";
  EXPECT_TRUE(refused(arcs({at(0, 0), at(120, 0), at(240, 0)}, step))) << "a great circle";
  EXPECT_TRUE(refused(arcs({at(0, 0), at(60, 40), at(60, 0), at(0, 60)}, step))) << "crosses itself";
  EXPECT_TRUE(refused(arcs({at(0, 0), at(40, 40), at(80, 0), at(80, 70), at(40, 40), at(0, 70)}, step))) << "touches";
  EXPECT_TRUE(refused(arcs({at(0, 0), at(40, 0), at(0, 40), at(40, 0)}, step))) << "there and back";
  std::vector<Vec> twice = arcs(octant, step);
  twice.insert(twice.end(), twice.begin(), twice.end());
  EXPECT_TRUE(refused(twice));
  std::vector<Vec> spiral;
  for (int i = 0; i < 100; ++i) spiral.push_back(at(7.2 * i, 30 + 0.4 * i));
  EXPECT_TRUE(refused(spiral)) << "twice around";
}

}  // namespace
}  // namespace cgal_blend::test
