// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_checks.h"

#include "cell_marks.h"

#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace cgal_blend::internal {

namespace {

using Segment_3 = Kernel::Segment_3;
using Triangle_3 = Kernel::Triangle_3;
using Corners = std::array<Vertex, 3>;

Corners corners(const Blend_mesh& mesh, Face f) {
  const Halfedge h = mesh.halfedge(f);
  return {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))};
}

Triangle_3 triangle(const Blend_mesh& mesh, const Corners& c) {
  return {mesh.point(c[0]), mesh.point(c[1]), mesh.point(c[2])};
}

/// Turns the corners of both so that shared ones come first, in the same order; returns how many are shared.
int align_shared(Corners& a, Corners& b) {
  int shared = 0;
  for (int i = 0; i < 3; ++i) {
    const auto match = std::find(b.begin() + shared, b.end(), a[i]);
    if (match == b.end()) continue;
    std::iter_swap(b.begin() + shared, match);
    std::swap(a[shared], a[i]);
    ++shared;
  }
  return shared;
}

/// On which side of the line pq r lies, seen along a coordinate axis: 1, -1, or 0 where rounding leaves it open (the
/// bound is that of Shewchuk, Adaptive precision floating-point arithmetic, 1997).
int side_of_line(const Point_3& p, const Point_3& q, const Point_3& r, int axis) {
  const int x = axis == 0 ? 1 : 0, y = axis == 2 ? 1 : 2;
  const double left = (q[x] - p[x]) * (r[y] - p[y]), right = (q[y] - p[y]) * (r[x] - p[x]), det = left - right;
  const double error = 3.4e-16 * (std::abs(left) + std::abs(right)) + 1e-290;  // the latter for products that underflow
  return det > error ? 1 : det < -error ? -1 : 0;
}

/// True if, seen along the axis, some side of the first face has the first face on one side of its line and the second
/// on the other. They touch the line in common corners only, which come first.
bool side_separates(const std::array<const Point_3*, 3>& a, const std::array<const Point_3*, 3>& b, int shared,
                    int axis) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, opposite = (i + 2) % 3;
    if (opposite < shared) continue;  // a common corner would have to be on both sides
    const int inner = side_of_line(*a[i], *a[j], *a[opposite], axis);
    if (inner == 0) continue;
    bool beyond = true;
    for (int k = shared; k < 3 && beyond; ++k) beyond = side_of_line(*a[i], *a[j], *b[k], axis) == -inner;
    if (beyond) return true;
  }
  return false;
}

/// True only if two faces, with their common corners first, meet in nothing else: decided in doubles. Spares the faces of
/// one plane, of which a blend along a large one leaves thousands with overlapping boxes, the exact arithmetic.
bool clearly_apart(const std::array<const Point_3*, 3>& a, const std::array<const Point_3*, 3>& b, int shared) {
  const Vector_3 normal = CGAL::cross_product(*a[1] - *a[0], *a[2] - *a[0]);
  int axis = std::abs(normal.x()) > std::abs(normal.y()) ? 0 : 1;
  if (std::abs(normal.z()) > std::abs(normal[axis])) axis = 2;
  return side_separates(a, b, shared, axis) || side_separates(b, a, shared, axis);
}

/// True if two faces meet in more than the vertices that they share. Orientation plays no part.
bool faces_intersect(const Blend_mesh& mesh, Face f, Face g) {
  Corners a = corners(mesh, f), b = corners(mesh, g);
  const int shared = align_shared(a, b);
  const auto p = [&](Vertex v) -> const Point_3& { return mesh.point(v); };
  if (shared == 3) return true;
  if (clearly_apart({&p(a[0]), &p(a[1]), &p(a[2])}, {&p(b[0]), &p(b[1]), &p(b[2])}, shared)) return false;
  if (shared == 2)  // they overlap if folded flat onto each other
    return CGAL::coplanar(p(a[0]), p(a[1]), p(a[2]), p(b[2])) &&
           CGAL::coplanar_orientation(p(a[0]), p(a[1]), p(a[2]), p(b[2])) == CGAL::POSITIVE;
  if (shared == 1)  // if they meet elsewhere, then on a side opposite to the shared vertex
    return CGAL::do_intersect(triangle(mesh, a), Segment_3(p(b[1]), p(b[2]))) ||
           CGAL::do_intersect(triangle(mesh, b), Segment_3(p(a[1]), p(a[2])));
  return CGAL::do_intersect(triangle(mesh, a), triangle(mesh, b));
}

bool is_degenerate(const Blend_mesh& mesh, const Corners& c) {
  return CGAL::collinear(mesh.point(c[0]), mesh.point(c[1]), mesh.point(c[2]));
}

Face_pair ordered(Face f, Face g) { return f < g ? Face_pair(f, g) : Face_pair(g, f); }

void sort_unique(std::vector<Face_pair>& pairs) {
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

}  // namespace

std::vector<Face_pair> intersecting_pairs(const Blend_mesh& mesh) {
  std::vector<Face_pair> found;
  CGAL::Polygon_mesh_processing::self_intersections<CGAL::Sequential_tag>(mesh.faces(), mesh,
                                                                          std::back_inserter(found));
  // CGAL reports a degenerate face as a pair with itself.
  found.erase(std::remove_if(found.begin(), found.end(), [](const Face_pair& p) { return p.first == p.second; }),
              found.end());
  for (Face_pair& pair : found) pair = ordered(pair.first, pair.second);
  sort_unique(found);
  return found;
}

namespace {

CGAL::Bbox_3 bbox(const Blend_mesh& mesh, const Triangle& t) {
  return mesh.point(Vertex(t[0])).bbox() + mesh.point(Vertex(t[1])).bbox() + mesh.point(Vertex(t[2])).bbox();
}

using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, Face, CGAL::Box_intersection_d::ID_FROM_BOX_ADDRESS>;

struct Near_faces {
  std::vector<Box> changed, kept;
};

/// The box search moves pointers about faster than boxes, and must not copy boxes that are known by their address.
std::vector<const Box*> pointers(const std::vector<Box>& boxes) {
  std::vector<const Box*> result;
  result.reserve(boxes.size());
  for (const Box& box : boxes) result.push_back(&box);
  return result;
}

/// Boxes of the changed faces, and of those others that may meet one; without degenerate faces.
Near_faces find_near_faces(const Blend_mesh& mesh, const Face_table& table, const std::vector<char>& is_changed) {
  Near_faces near;
  std::vector<CGAL::Bbox_3> boxes;
  for (std::size_t i = 0; i < table.faces.size(); ++i) {
    if (!is_changed[table.faces[i]]) continue;
    boxes.push_back(bbox(mesh, table.triangles[i]));
    if (!is_degenerate(mesh, corners(mesh, table.faces[i]))) near.changed.emplace_back(boxes.back(), table.faces[i]);
  }
  if (boxes.empty()) return near;
  const Cell_marks marks(boxes, cells_for(table.faces.size()));
  for (std::size_t i = 0; i < table.faces.size(); ++i) {
    if (is_changed[table.faces[i]]) continue;
    const CGAL::Bbox_3 box = bbox(mesh, table.triangles[i]);
    if (marks.meets(box) && !is_degenerate(mesh, corners(mesh, table.faces[i])))
      near.kept.emplace_back(box, table.faces[i]);
  }
  return near;
}

}  // namespace

std::vector<Face_pair> intersecting_pairs(const Blend_mesh& mesh, const Face_table& table,
                                          const std::vector<Face>& changed) {
  std::vector<char> is_changed(mesh.num_faces(), 0);
  for (const Face f : changed) is_changed[f] = 1;
  const Near_faces near = find_near_faces(mesh, table, is_changed);
  std::vector<const Box*> fresh = pointers(near.changed), kept = pointers(near.kept);
  std::vector<Face_pair> found;
  const auto test = [&](const Box* a, const Box* b) {
    if (faces_intersect(mesh, a->info(), b->info())) found.push_back(ordered(a->info(), b->info()));
  };
  const std::ptrdiff_t cutoff = 2000;  // as in CGAL's own search for self-intersections
  CGAL::box_self_intersection_d(fresh.begin(), fresh.end(), test, cutoff);
  CGAL::box_intersection_d(fresh.begin(), fresh.end(), kept.begin(), kept.end(), test, cutoff);
  sort_unique(found);
  return found;
}

namespace {

/// Where a segment that meets the triangle passes through its plane; for coplanar ones some point of the segment.
Point_3 crossing(const Triangle_3& t, const Segment_3& side) {
  const Vector_3 normal = CGAL::cross_product(t[1] - t[0], t[2] - t[0]);
  const double from = normal * (side.source() - t[0]), to = normal * (side.target() - t[0]);
  if (from != to) return side.source() + std::clamp(from / (from - to), 0.0, 1.0) * (side.target() - side.source());
  for (const Point_3& end : {side.source(), side.target()})
    if (t.has_on(end)) return end;
  return CGAL::midpoint(side.source(), side.target());
}

/// A common point of face g with a side of face f between corners that g does not have.
std::optional<Point_3> crossing_of_sides(const Blend_mesh& mesh, const Corners& f, const Corners& g) {
  const auto in_g = [&](Vertex v) { return std::find(g.begin(), g.end(), v) != g.end(); };
  for (int i = 0; i < 3; ++i) {
    const Vertex u = f[i], v = f[(i + 1) % 3];
    if (in_g(u) || in_g(v)) continue;
    const Segment_3 side(mesh.point(u), mesh.point(v));
    if (CGAL::do_intersect(triangle(mesh, g), side)) return crossing(triangle(mesh, g), side);
  }
  return std::nullopt;
}

}  // namespace

Point_3 meeting_point(const Blend_mesh& mesh, Face_pair pair) {
  Corners a = corners(mesh, pair.first), b = corners(mesh, pair.second);
  if (const auto point = crossing_of_sides(mesh, a, b)) return *point;
  if (const auto point = crossing_of_sides(mesh, b, a)) return *point;
  if (align_shared(a, b) >= 2) return CGAL::midpoint(mesh.point(a[0]), mesh.point(a[1]));
  return CGAL::centroid(triangle(mesh, a));
}

}  // namespace cgal_blend::internal
