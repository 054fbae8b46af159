// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_formats.h"

#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>

namespace cgal_blend::internal {

namespace {

void append_fan(const std::uint32_t* polygon, std::size_t size, std::size_t apex,
                std::vector<std::uint32_t>& triangles) {
  for (std::size_t i = 1; i + 1 < size; ++i)
    triangles.insert(triangles.end(), {polygon[apex], polygon[(apex + i) % size], polygon[(apex + i + 1) % size]});
}

/// True if the two triangles on the diagonal from corner `apex` of a quadrangle look the same way.
bool splits_well(const std::vector<Point_3>& points, const std::uint32_t* quad, std::size_t apex) {
  const Point_3 &a = points[quad[apex]], &b = points[quad[apex + 1]], &c = points[quad[apex + 2]],
                &d = points[quad[(apex + 3) % 4]];
  return CGAL::cross_product(b - a, c - a) * CGAL::cross_product(c - a, d - a) > 0;
}

/// Apex of the fan: on the shorter diagonal, unless the quadrangle is reflex and that one lies outside.
std::size_t quad_apex(const std::vector<Point_3>& points, const std::uint32_t* quad) {
  const double diagonal_02 = CGAL::squared_distance(points[quad[0]], points[quad[2]]);
  const double diagonal_13 = CGAL::squared_distance(points[quad[1]], points[quad[3]]);
  const std::size_t apex = diagonal_02 <= diagonal_13 ? 0 : 1;
  return splits_well(points, quad, apex) || !splits_well(points, quad, 1 - apex) ? apex : 1 - apex;
}

}  // namespace

void triangulate_polygon(const std::vector<Point_3>& points, const std::uint32_t* polygon, std::size_t size,
                         std::vector<std::uint32_t>& triangles) {
  if (size == 3) return append_fan(polygon, size, 0, triangles);
  if (size == 4) return append_fan(polygon, size, quad_apex(points, polygon), triangles);
  Blend_mesh mesh;
  std::vector<Vertex> corners;
  for (std::size_t i = 0; i < size; ++i) corners.push_back(mesh.add_vertex(points[polygon[i]]));
  const Face face = mesh.add_face(corners);
  if (face == Blend_mesh::null_face() || !CGAL::Polygon_mesh_processing::triangulate_face(face, mesh))
    return append_fan(polygon, size, 0, triangles);  // no plane fits it; validation will judge
  for (const Face f : mesh.faces())
    for (const Vertex v : vertices_around_face(mesh.halfedge(f), mesh)) triangles.push_back(polygon[v]);
}

}  // namespace cgal_blend::internal
