// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_TEST_POLAR_CHECKS_H
#define CGAL_BLEND_TEST_POLAR_CHECKS_H

#include "shapes.h"

#include <cgal_blend/geodesic_polar.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <vector>

// Inputs and measures shared by the tests of geodesic polar coordinates.

namespace cgal_blend::test {

/// A vertex as a place of a face.
inline Face_point at_vertex(const Blend_mesh& mesh, Vertex v) {
  Face_point at{mesh.face(mesh.halfedge(v)), {0, 0, 0}};
  for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
    if (!mesh.is_border(h)) at.face = mesh.face(h);
  Halfedge h = mesh.halfedge(at.face);
  for (double& weight : at.weights) {
    weight = mesh.target(h) == v ? 1 : 0;
    h = mesh.next(h);
  }
  return at;
}

inline double distance_between(const Point_3& p, const Point_3& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

/// The vertex nearest to a point.
inline Vertex vertex_near(const Blend_mesh& mesh, const Point_3& p) {
  return *std::min_element(mesh.vertices().begin(), mesh.vertices().end(), [&](Vertex v, Vertex w) {
    return CGAL::squared_distance(mesh.point(v), p) < CGAL::squared_distance(mesh.point(w), p);
  });
}

/// The face whose middle is nearest to a point.
inline Face face_near(const Blend_mesh& mesh, const Point_3& p) {
  return *std::min_element(mesh.faces().begin(), mesh.faces().end(), [&](Face f, Face g) {
    return CGAL::squared_distance(position(mesh, {f}), p) < CGAL::squared_distance(position(mesh, {g}), p);
  });
}

/// A random place inside a face.
inline Face_point random_place(const Blend_mesh& mesh, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0.01, 1);
  Face_point at{Face(static_cast<unsigned>(random() % mesh.number_of_faces())),
                {uniform(random), uniform(random), uniform(random)}};
  const double sum = at.weights[0] + at.weights[1] + at.weights[2];
  for (double& weight : at.weights) weight /= sum;
  return at;
}

/// Square [-1, 1]^2 of n x n jittered cells with diagonals either way, and edges flipped at random where the result is
/// still a triangulation: far from Delaunay, with obtuse and needle-like triangles.
inline Blend_mesh irregular_square(int n, unsigned seed, bool flips) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> jitter(-0.45, 0.45);
  Blend_mesh mesh;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const double x = i + (i > 0 && i < n ? jitter(random) : 0), y = j + (j > 0 && j < n ? jitter(random) : 0);
      mesh.add_vertex({2 * x / n - 1, 2 * y / n - 1, 0});
    }
  const auto is_left = [&](Vertex a, Vertex b, Vertex c) {
    const Point_3 &p = mesh.point(a), &q = mesh.point(b), &r = mesh.point(c);
    return CGAL::orientation(Kernel::Point_2(p.x(), p.y()), Kernel::Point_2(q.x(), q.y()),
                             Kernel::Point_2(r.x(), r.y())) == CGAL::LEFT_TURN;
  };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const Vertex a(j * (n + 1) + i), b(a + 1), c(b + n + 1), d(a + n + 1);
      if (is_left(a, b, c) && is_left(a, c, d)) {
        mesh.add_face(a, b, c);
        mesh.add_face(a, c, d);
      } else {
        mesh.add_face(a, b, d);
        mesh.add_face(b, c, d);
      }
    }
  for (std::size_t k = 0; flips && k < 2 * mesh.number_of_edges(); ++k) {
    const Halfedge h = mesh.halfedge(Edge(static_cast<unsigned>(random() % mesh.number_of_edges())));
    if (mesh.is_border(h) || mesh.is_border(mesh.opposite(h))) continue;
    const Vertex a = mesh.source(h), b = mesh.target(h), c = mesh.target(mesh.next(h)),
                 d = mesh.target(mesh.next(mesh.opposite(h)));
    if (is_left(d, b, c) && is_left(c, a, d)) CGAL::Euler::flip_edge(h, mesh);
  }
  return mesh;
}

/// Errors of coordinates against a formula, over vertices that are covered and not farther than the radius.
struct Polar_errors {
  std::size_t count = 0;
  double mean = 0, worst = 0;  ///< of distances, relative to the true ones
  double absolute = 0;         ///< worst of distances
  double angle = 0;            ///< worst of angles, radians, not nearer than `from`
};

inline Polar_errors errors(
    const Geodesic_polar& polar, double from, const std::function<Polar_point(const Point_3&)>& truth,
    const std::function<bool(const Point_3&)>& counts = [](const Point_3&) { return true; }) {
  Polar_errors errors;
  for (const Vertex v : polar.mesh().vertices()) {
    if (!polar.covers(v) || !counts(polar.mesh().point(v))) continue;
    const Polar_point is = polar(v), should = truth(polar.mesh().point(v));
    if (should.distance == 0 || is.distance > polar.radius()) continue;
    const double error = std::abs(is.distance - should.distance);
    ++errors.count;
    errors.absolute = std::max(errors.absolute, error);
    errors.mean += error / should.distance;
    errors.worst = std::max(errors.worst, error / should.distance);
    if (should.distance >= from)
      errors.angle = std::max(errors.angle, std::abs(std::remainder(is.angle - should.angle, 2 * pi)));
  }
  errors.mean /= static_cast<double>(std::max<std::size_t>(1, errors.count));
  return errors;
}

}  // namespace cgal_blend::test

#endif
