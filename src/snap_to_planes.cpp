// SPDX-License-Identifier: GPL-3.0-or-later
#include "snap_to_planes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace cgal_blend {

namespace {

constexpr double rounding_units = 8;

/// Extents of the flat sides of a body, by the coordinate that they share; one map per axis.
using Flat_sides = std::array<std::map<double, CGAL::Bbox_3>, 3>;

Flat_sides flat_sides(const Blend_mesh& mesh) {
  Flat_sides sides;
  for (const Face f : mesh.faces()) {
    const Halfedge h = mesh.halfedge(f);
    const Point_3 &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h));
    const Point_3& r = mesh.point(mesh.target(mesh.next(h)));
    for (int axis = 0; axis < 3; ++axis)
      if (p[axis] == q[axis] && q[axis] == r[axis]) sides[axis][p[axis]] += p.bbox() + q.bbox() + r.bbox();
  }
  return sides;
}

double largest_coordinate(const Blend_mesh& mesh) {
  double largest = 0;
  for (const Vertex v : mesh.vertices())
    for (int axis = 0; axis < 3; ++axis) largest = std::max(largest, std::abs(mesh.point(v)[axis]));
  return largest;
}

bool within(const Point_3& p, const CGAL::Bbox_3& box, double tolerance) {
  for (int axis = 0; axis < 3; ++axis)
    if (p[axis] < box.min(axis) - tolerance || p[axis] > box.max(axis) + tolerance) return false;
  return true;
}

}  // namespace

std::size_t snap_to_planes(Blend_mesh& mesh, const Blend_mesh& other) {
  const Flat_sides sides = flat_sides(other);
  const double tolerance = rounding_units * std::numeric_limits<double>::epsilon() *
                           std::max(largest_coordinate(mesh), largest_coordinate(other));
  std::size_t moved = 0;
  for (const Vertex v : mesh.vertices()) {
    std::array<double, 3> at{mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()};
    for (int axis = 0; axis < 3; ++axis) {
      const auto side = sides[axis].lower_bound(at[axis] - tolerance);
      if (side == sides[axis].end() || side->first > at[axis] + tolerance || side->first == at[axis]) continue;
      if (within(mesh.point(v), side->second, tolerance)) at[axis] = side->first;
    }
    const Point_3 snapped(at[0], at[1], at[2]);
    if (snapped == mesh.point(v)) continue;
    mesh.point(v) = snapped;
    ++moved;
  }
  return moved;
}

}  // namespace cgal_blend
