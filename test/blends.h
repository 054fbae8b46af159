// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_TEST_BLENDS_H
#define CGAL_BLEND_TEST_BLENDS_H

#include "checks.h"
#include "shapes.h"

#include <cgal_blend/creases.h>
#include <cgal_blend/fillet.h>
#include <cgal_blend/validate.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

// Runs of the rolling ball that check what holds of every blend, and closed forms of what it adds or takes.

namespace cgal_blend::test {

inline Fillet_options options_of(double radius, double chord_tolerance = 2e-3) {
  Fillet_options options;
  options.radius = radius;
  options.chord_tolerance = chord_tolerance;
  return options;
}

/// Fillet at the foot of a boss, and round of a bore's rim: a square ring section less a quarter disk (Pappus).
inline double foot_volume(double R, double r) {
  return 2 * pi * (r * r * (R + r / 2) - pi * r * r / 4 * (R + r - 4 * r / (3 * pi)));
}

/// Round of a boss's top rim.
inline double rim_volume(double R, double r) {
  return 2 * pi * (r * r * (R - r / 2) - pi * r * r / 4 * (R - r + 4 * r / (3 * pi)));
}

inline std::vector<Point_3> blend_points(const Blend_mesh& mesh, const Fillet_outcome& outcome) {
  std::set<Vertex> vertices;
  for (const Face f : outcome.blend_faces)
    for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(f))) vertices.insert(v);
  std::vector<Point_3> points;
  for (const Vertex v : vertices) points.push_back(mesh.point(v));
  return points;
}

template <class Distance>
double largest(const std::vector<Point_3>& points, Distance distance) {
  double worst = 0;
  for (const Point_3& p : points) worst = std::max(worst, std::abs(distance(p)));
  return worst;
}

struct Blended {
  Blend_mesh mesh;
  Fillet_outcome outcome;
  double change = 0;  // of the volume, against the sharp body
};

inline Blended blend(const Blend_mesh& a, const Blend_mesh& b, Boolean_operation operation,
                     const Fillet_options& options) {
  Blend_mesh sharp;
  EXPECT_TRUE(unchecked::corefine_and_fillet(a, b, operation, sharp, options_of(0)).ok());
  Blended result;
  result.outcome = unchecked::corefine_and_fillet(a, b, operation, result.mesh, options);
  EXPECT_EQ(result.outcome.diagnosis.status, Status::ok) << message(result.outcome.diagnosis);
  if (!result.outcome.ok()) return result;
  EXPECT_TRUE(validate(result.mesh).ok());
  EXPECT_TRUE(is_closed_by_counting(result.mesh));
  result.change = volume_of(result.mesh) - volume_of(sharp);
  return result;
}

inline std::vector<Edge> creases_at_height(const Blend_mesh& mesh, double z) {
  std::vector<Edge> edges;
  for (const Edge e : mesh.edges())
    if (mesh.point(mesh.vertex(e, 0)).z() == z && mesh.point(mesh.vertex(e, 1)).z() == z && is_crease(e, mesh, 45))
      edges.push_back(e);
  return edges;
}

inline Blended blend_edges(const Blend_mesh& mesh, const std::vector<Edge>& edges, const Fillet_options& options) {
  Blended result;
  result.outcome = unchecked::fillet_edges(mesh, {{edges, options.radius}}, result.mesh, options);
  EXPECT_EQ(result.outcome.diagnosis.status, Status::ok) << message(result.outcome.diagnosis);
  if (!result.outcome.ok()) return result;
  EXPECT_TRUE(validate(result.mesh).ok());
  result.change = volume_of(result.mesh) - volume_of(mesh);
  return result;
}

/// Observed order of convergence. Taken of the distances of vertices: the volume's error soon is that of the arcs' chords,
/// two thirds of the chord tolerance on the fillet's section, whatever the operands' facets.
inline double order(double coarse_error, double fine_error) { return std::log2(coarse_error / fine_error); }

}  // namespace cgal_blend::test

#endif
