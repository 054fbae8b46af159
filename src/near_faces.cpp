// SPDX-License-Identifier: GPL-3.0-or-later
#include "near_faces.h"

#include "cell_marks.h"

#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace cgal_blend {

namespace {

using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, Face, CGAL::Box_intersection_d::ID_FROM_BOX_ADDRESS>;
using Corners = std::array<Point_3, 3>;

Corners corners(const Blend_mesh& mesh, Face f) {
  const Halfedge h = mesh.halfedge(f);
  return {mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h)))};
}

struct Face_boxes {
  std::vector<Face> faces;
  std::vector<CGAL::Bbox_3> boxes;
};

Face_boxes grown_boxes(const Blend_mesh& mesh, double by) {
  Face_boxes result;
  result.faces.reserve(mesh.number_of_faces());
  result.boxes.reserve(mesh.number_of_faces());
  for (const Face f : mesh.faces()) {
    const Corners c = corners(mesh, f);
    const CGAL::Bbox_3 box = c[0].bbox() + c[1].bbox() + c[2].bbox();
    result.faces.push_back(f);
    result.boxes.emplace_back(box.xmin() - by, box.ymin() - by, box.zmin() - by, box.xmax() + by, box.ymax() + by,
                              box.zmax() + by);
  }
  return result;
}

/// Leaves those that may meet one of the others.
void sift(Face_boxes& all, const Face_boxes& others) {
  if (others.boxes.empty()) return;
  const internal::Cell_marks marks(others.boxes, internal::cells_for(others.boxes.size()));
  Face_boxes left;
  for (std::size_t i = 0; i < all.boxes.size(); ++i)
    if (marks.meets(all.boxes[i])) {
      left.faces.push_back(all.faces[i]);
      left.boxes.push_back(all.boxes[i]);
    }
  all = std::move(left);
}

CGAL::Bbox_3 box_of(const Blend_mesh& mesh) {
  CGAL::Bbox_3 box;
  for (const Vertex v : mesh.vertices()) box += mesh.point(v).bbox();
  return box;
}

std::vector<Box> labelled(const Face_boxes& faces) {
  std::vector<Box> boxes;
  boxes.reserve(faces.boxes.size());
  for (std::size_t i = 0; i < faces.boxes.size(); ++i) boxes.emplace_back(faces.boxes[i], faces.faces[i]);
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
  Face_boxes near_a = grown_boxes(a, tolerance), near_b = grown_boxes(b, tolerance);
  sift(near_b, near_a);
  sift(near_a, near_b);
  const std::vector<Box> of_a = labelled(near_a), of_b = labelled(near_b);
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
