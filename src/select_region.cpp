// SPDX-License-Identifier: GPL-3.0-or-later
#include "select_region.h"

#include "fill_holes.h"

#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cmath>

namespace cgal_blend {

namespace {

// Edges are at most this share of the radius, so that triangles do not reach far out of the disk.
constexpr double longest_edge = 0.125;
// A place with a weight below this is on the edge or at the vertex: it moves by less than the coordinates' accuracy.
constexpr double least_weight = 1e-13;

std::array<Vec, 3> corners_of(const Blend_mesh& mesh, Face face) {
  const Halfedge h = mesh.halfedge(face);
  const Halfedge g = mesh.next(h);
  return {to_vec(mesh.point(mesh.target(h))), to_vec(mesh.point(mesh.target(g))),
          to_vec(mesh.point(mesh.target(mesh.next(g))))};
}

double squared_longest(const std::array<Vec, 3>& c) {
  return std::max({(c[1] - c[0]).squaredNorm(), (c[2] - c[1]).squaredNorm(), (c[0] - c[2]).squaredNorm()});
}

bool meets_ball(const std::array<Vec, 3>& c, const Vec& centre, double radius) {
  const double nearest =
      std::min({(c[0] - centre).squaredNorm(), (c[1] - centre).squaredNorm(), (c[2] - centre).squaredNorm()});
  if (nearest <= radius * radius) return true;
  if (std::sqrt(nearest) > radius + std::sqrt(squared_longest(c))) return false;
  return CGAL::squared_distance(to_point(centre), Kernel::Triangle_3(to_point(c[0]), to_point(c[1]), to_point(c[2]))) <=
         radius * radius;
}

CGAL::Bbox_3 box_of(const Vec& p) { return {p.x(), p.y(), p.z(), p.x(), p.y(), p.z()}; }

double squared_distance(const CGAL::Bbox_3& a, const CGAL::Bbox_3& b) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const double gap = std::max({0.0, a.min(i) - b.max(i), b.min(i) - a.max(i)});
    sum += gap * gap;
  }
  return sum;
}

}  // namespace

Near_polyline::Near_polyline(const std::vector<Vec>& points) : points_(points) {
  std::size_t leaves = 1;
  while (leaves < points.size()) leaves *= 2;
  boxes_.resize(2 * leaves - 1);
  for (std::size_t i = 0; i < points.size(); ++i)
    boxes_[leaves - 1 + i] = box_of(points[i]) + box_of(points[(i + 1) % points.size()]);
  for (std::size_t i = leaves - 1; i-- > 0;) boxes_[i] = boxes_[2 * i + 1] + boxes_[2 * i + 2];
}

bool Near_polyline::operator()(const std::array<Vec, 3>& triangle, double distance) const {
  if (points_.size() == 1) return meets_ball(triangle, points_.front(), distance);
  return meets(0, box_of(triangle[0]) + box_of(triangle[1]) + box_of(triangle[2]), distance * distance);
}

bool Near_polyline::meets(std::size_t node, const CGAL::Bbox_3& box, double squared) const {
  if (!(squared_distance(boxes_[node], box) <= squared)) return false;
  if (2 * node + 1 >= boxes_.size()) return true;
  return meets(2 * node + 1, box, squared) || meets(2 * node + 2, box, squared);
}

Selection select_region(Region_mesh& region, Face first, const Near_polyline& near_source, double radius,
                        bool fills_holes) {
  const Blend_mesh& mesh = region.mesh();
  double squared = squared_longest(corners_of(mesh, first));
  region.grow(first, [&](Face f) {
    const auto c = corners_of(mesh, f);
    if (!near_source(c, radius)) return false;
    squared = std::max(squared, squared_longest(c));
    return true;
  });
  Selection selection{};
  const bool all_short = std::sqrt(squared) <= longest_edge * radius;
  selection.length = all_short ? std::sqrt(squared) : longest_edge * radius;
  selection.limit = radius + 2 * selection.length;
  selection.first_long = all_short ? static_cast<std::int32_t>(region.triangles().size()) : 0;
  const auto grow = [&] {
    region.grow(first, [&](Face f) { return near_source(corners_of(mesh, f), selection.limit); });
  };
  grow();
  while (fills_holes && fill_holes(region, [&](const auto& c) { return near_source(c, selection.limit); })) grow();
  return selection;
}

std::int32_t insert_place(Region_mesh& region, const Face_point& at) {
  Region_mesh::Place place = region.in_triangle(at);
  auto& w = place.weights;
  const Vec point = to_vec(position(region.mesh(), at));
  const int most = static_cast<int>(std::max_element(w.begin(), w.end()) - w.begin());
  const int b = (most + 1) % 3, c = (most + 2) % 3;
  if (w[b] < least_weight && w[c] < least_weight) return region.triangles()[place.triangle].corner[most];
  const int least = w[b] < w[c] ? b : c;
  if (w[least] < least_weight) {
    const double first = w[(least + 1) % 3], last = w[(least + 2) % 3];
    return region.divide(place.triangle, least, last / (first + last), point);
  }
  return region.divide(place.triangle, w, point);
}

}  // namespace cgal_blend
