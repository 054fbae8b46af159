// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_TEST_EDGE_BLENDS_H
#define CGAL_BLEND_TEST_EDGE_BLENDS_H

#include "blends.h"
#include "polytopes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <random>
#include <utility>
#include <vector>

// Blends of open edges: how tests name the edges, run the engine, and present the same body in other ways.

namespace cgal_blend::test {

/// Between two perpendicular faces and the arc that touches both: area, and distance of the centroid from either face.
inline double spandrel(double r) { return (1 - pi / 4) * r * r; }
inline double spandrel_centroid(double r) { return r * (5.0 / 6 - pi / 4) / (1 - pi / 4); }

/// Square boss of side 8 on a plate of side 20, tops at z = 6 and z = 0; or the same as a pit.
inline Blend_mesh boss_or_pit(bool pit) {
  Blend_mesh result;
  const Blend_mesh plate = box({-10, -10, -10}, {10, 10, 0});
  const Blend_mesh other = pit ? box({-4, -4, -6}, {4, 4, 3}) : box({-4, -4, -5}, {4, 4, 6});
  const auto outcome = unchecked::corefine_and_fillet(
      plate, other, pit ? Boolean_operation::difference : Boolean_operation::union_, result, options_of(0));
  EXPECT_TRUE(outcome.ok()) << message(outcome.diagnosis);
  return result;
}

/// Expects a radius to be refused by name with the largest radius that works, that this one does, and 1.02 times it does
/// not. Returns it.
inline std::optional<double> expect_largest_radius(const Blend_mesh& mesh, const std::vector<Edge>& edges, double radius,
                                                   const Fillet_options& options) {
  Blend_mesh out;
  const auto run = [&](double r) { return unchecked::fillet_edges(mesh, {{edges, r}}, out, options); };
  const Fillet_outcome refused = run(radius);
  EXPECT_FALSE(refused.ok());
  if (refused.ok()) return std::nullopt;
  EXPECT_EQ(status_class(refused.diagnosis.status), Status_class::blend) << message(refused.diagnosis);
  EXPECT_EQ(out.number_of_faces(), 0u);
  EXPECT_TRUE(refused.diagnosis.max_radius) << message(refused.diagnosis);
  if (!refused.diagnosis.max_radius) return std::nullopt;
  const double most = *refused.diagnosis.max_radius;
  const Fillet_outcome fits = run(most);
  EXPECT_TRUE(fits.ok()) << most << ": " << message(fits.diagnosis);
  EXPECT_TRUE(validate(out).ok());
  EXPECT_FALSE(run(1.02 * most).ok()) << "a larger ball than " << most << " fits";
  return most;
}

/// Edges with faces at more than a degree whose two ends fulfil a condition.
template <class Condition>
std::vector<Edge> edges_where(const Blend_mesh& mesh, Condition condition) {
  std::vector<Edge> edges;
  for (const Edge e : mesh.edges())
    if (is_crease(e, mesh, 1) && condition(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))))
      edges.push_back(e);
  return edges;
}

inline std::vector<Edge> all_creases(const Blend_mesh& mesh, double angle = 1) {
  std::vector<Edge> edges;
  for (const Edge e : mesh.edges())
    if (is_crease(e, mesh, angle)) edges.push_back(e);
  return edges;
}

/// Edges along the segment between two points.
inline std::vector<Edge> edges_along(const Blend_mesh& mesh, const Point_3& from, const Point_3& to) {
  const Vec3 a = vec3(from), d = vec3(to) - a;
  const auto on = [&](const Point_3& p) {
    const Vec3 q = vec3(p) - a;
    const double t = q.dot(d) / d.squaredNorm();
    return (q - t * d).norm() < 1e-9 * d.norm() && t > -1e-9 && t < 1 + 1e-9;
  };
  return edges_where(mesh, [&](const Point_3& p, const Point_3& q) { return on(p) && on(q); });
}

inline std::vector<Edge> joined(std::vector<Edge> a, const std::vector<Edge>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Blends that have to succeed; edges of several radii.
inline Blended blend_all(const Blend_mesh& mesh, const std::vector<Edge_blend>& blends, double chord_tolerance = 2e-3) {
  Blended result;
  for (const Edge_blend& b : blends) EXPECT_FALSE(b.edges.empty());
  result.outcome = unchecked::fillet_edges(mesh, blends, result.mesh, options_of(0, chord_tolerance));
  EXPECT_EQ(result.outcome.diagnosis.status, Status::ok) << message(result.outcome.diagnosis);
  if (!result.outcome.ok()) return result;
  const Validity_report report = validate(result.mesh);
  EXPECT_TRUE(report.ok()) << message(report.diagnosis);
  EXPECT_TRUE(is_closed_by_counting(result.mesh));
  result.change = volume_of(result.mesh) - volume_of(mesh);
  return result;
}

/// The volume changes by so much, to within a share of it.
inline void expect_change(const Blended& result, double expected, double share) {
  if (result.outcome.ok()) {
    EXPECT_NEAR(result.change, expected, share * std::abs(expected))
        << "off by a share of " << result.change / expected - 1;
  }
}

/// Every vertex of the blend lies on a surface whose distance function is given, to within a share of the radius, or on
/// the sharp body outside of it: on the rim of an end.
template <class Distance>
void expect_on(const Blended& result, double radius, double share, Distance distance) {
  if (result.outcome.ok()) {
    EXPECT_LT(largest(blend_points(result.mesh, result.outcome), distance), share * radius);
  }
}

// The same body in other ways.

/// Vertices and faces in another order, the corners of each face turned.
inline Blend_mesh shuffled(const Blend_mesh& mesh, unsigned seed) {
  std::mt19937 random(seed);
  const auto shuffle = [&](std::vector<std::size_t>& v) {
    for (std::size_t i = v.size(); i > 1; --i) std::swap(v[i - 1], v[random() % i]);
  };
  std::vector<std::size_t> place(mesh.number_of_vertices()), order(mesh.number_of_faces());
  std::iota(place.begin(), place.end(), std::size_t{0});
  std::iota(order.begin(), order.end(), std::size_t{0});
  shuffle(place);
  shuffle(order);
  std::vector<Point_3> points(place.size());
  for (const Vertex v : mesh.vertices()) points[place[v]] = mesh.point(v);
  std::vector<Corner_indices> triangles;
  for (const std::size_t f : order) {
    const Face_corners c = corners_of(mesh, Face(static_cast<std::uint32_t>(f)));
    const std::size_t k = random() % 3;
    triangles.push_back({place[c[k]], place[c[(k + 1) % 3]], place[c[(k + 2) % 3]]});
  }
  return mesh_of(points, triangles);
}

/// Mirror image in the plane x = 0, oriented outward again.
inline Blend_mesh mirrored(const Blend_mesh& mesh) {
  Blend_mesh image = inside_out(mesh);
  for (const Vertex v : image.vertices()) {
    const Point_3 p = image.point(v);
    image.point(v) = Point_3(-p.x(), p.y(), p.z());
  }
  return image;
}

/// A motion at random.
inline Placement random_motion(unsigned seed, double scale = 1) {
  std::mt19937 random(seed);
  const Vec3 axis = random_direction(random), shift = 20 * scale * random_direction(random);
  return placement({axis.x(), axis.y(), axis.z()}, 6.28 * (random() / 4294967296.0), {shift.x(), shift.y(), shift.z()},
                   scale);
}

/// Faces all of whose vertices are at least so far from a place.
template <class Distance>
std::vector<Face> faces_beyond(const Blend_mesh& mesh, double distance, Distance distance_of) {
  std::vector<Face> faces;
  for (const Face f : mesh.faces()) {
    bool far = true;
    for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
      far = far && distance_of(mesh.point(v)) >= distance;
    if (far) faces.push_back(f);
  }
  return faces;
}

}  // namespace cgal_blend::test

#endif
