// SPDX-License-Identifier: GPL-3.0-or-later
#include "near_faces.h"

#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace cgal_blend {

namespace {

using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, Face>;
using Corners = std::array<Point_3, 3>;

Corners corners(const Blend_mesh& mesh, Face f) {
  const Halfedge h = mesh.halfedge(f);
  return {mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h)))};
}

CGAL::Bbox_3 grown_box(const Corners& c, double by) {
  const CGAL::Bbox_3 box = c[0].bbox() + c[1].bbox() + c[2].bbox();
  return {box.xmin() - by, box.ymin() - by, box.zmin() - by, box.xmax() + by, box.ymax() + by, box.zmax() + by};
}

CGAL::Bbox_3 box_of(const Blend_mesh& mesh) {
  CGAL::Bbox_3 box;
  for (const Vertex v : mesh.vertices()) box += mesh.point(v).bbox();
  return box;
}

/// Boxes of the faces that meet a region.
std::vector<Box> boxes_within(const Blend_mesh& mesh, const CGAL::Bbox_3& region, double tolerance) {
  std::vector<Box> boxes;
  for (const Face f : mesh.faces()) {
    const CGAL::Bbox_3 box = grown_box(corners(mesh, f), tolerance);
    if (CGAL::do_overlap(box, region)) boxes.emplace_back(box, f);
  }
  return boxes;
}

std::vector<const Box*> pointers(const std::vector<Box>& boxes) {
  std::vector<const Box*> result;
  result.reserve(boxes.size());
  for (const Box& box : boxes) result.push_back(&box);
  return result;
}

template <class Visit>
void each_near_pair(const Blend_mesh& a, const Blend_mesh& b, double tolerance, const Visit& visit) {
  const std::vector<Box> of_a = boxes_within(a, box_of(b), tolerance), of_b = boxes_within(b, box_of(a), tolerance);
  std::vector<const Box*> p = pointers(of_a), q = pointers(of_b);
  const std::ptrdiff_t cutoff = 2000;  // as in CGAL's own search for intersections
  CGAL::box_intersection_d(
      p.begin(), p.end(), q.begin(), q.end(), [&](const Box* f, const Box* g) { visit(f->info(), g->info()); }, cutoff);
}

bool on_plane_of(const Corners& plane, const Corners& points, double tolerance) {
  const Vector_3 normal = CGAL::cross_product(plane[1] - plane[0], plane[2] - plane[0]);
  const double limit = tolerance * tolerance * normal.squared_length();
  return std::all_of(points.begin(), points.end(), [&](const Point_3& p) {
    const double height = normal * (p - plane[0]);
    return height * height <= limit;
  });
}

bool nearly_coplanar(const Corners& f, const Corners& g, double tolerance) {
  return on_plane_of(f, g, tolerance) || on_plane_of(g, f, tolerance);
}

bool exactly_coplanar(const Corners& f, const Corners& g) {
  return std::all_of(g.begin(), g.end(), [&](const Point_3& p) { return CGAL::coplanar(f[0], f[1], f[2], p); });
}

}  // namespace

double rounding_tolerance(const Blend_mesh& a, const Blend_mesh& b) {
  const CGAL::Bbox_3 box = box_of(a) + box_of(b);
  double largest = 0;
  for (int axis = 0; axis < 3; ++axis) largest = std::max({largest, std::abs(box.min(axis)), std::abs(box.max(axis))});
  return rounding_fraction * largest;
}

std::vector<std::pair<Face, Face>> near_faces(const Blend_mesh& a, const Blend_mesh& b, double tolerance) {
  std::vector<std::pair<Face, Face>> pairs;
  each_near_pair(a, b, tolerance, [&](Face f, Face g) { pairs.emplace_back(f, g); });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

bool nearly_coplanar(const Blend_mesh& a, Face f, const Blend_mesh& b, Face g, double tolerance) {
  return nearly_coplanar(corners(a, f), corners(b, g), tolerance);
}

bool coplanar_but_for_rounding(const Blend_mesh& a, const Blend_mesh& b) {
  const double tolerance = rounding_tolerance(a, b);
  bool found = false;
  each_near_pair(a, b, tolerance, [&](Face f, Face g) {
    if (found) return;
    const Corners of_a = corners(a, f), of_b = corners(b, g);
    found = nearly_coplanar(of_a, of_b, tolerance) && !exactly_coplanar(of_a, of_b);
  });
  return found;
}

}  // namespace cgal_blend
