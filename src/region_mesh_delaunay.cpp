// SPDX-License-Identifier: GPL-3.0-or-later
#include "region_mesh.h"

#include <Eigen/Geometry>

#include <utility>

namespace cgal_blend {

/// Each triangle of a divided face becomes a piece of it, so that its corners may change.
void Region_mesh::put_into_pieces() {
  std::vector<Division> divisions;
  std::vector<std::int32_t> leaf(leaf_.size(), -1);
  for (std::int32_t t = 0; t < static_cast<std::int32_t>(triangles_.size()); ++t) {
    if (leaf_[t] < 0) continue;
    Piece piece;
    for (int corner = 0; corner < 3; ++corner) {
      Place place{t, {0, 0, 0}};
      place.weights[corner] = 1;
      piece[corner] = in_face(place).weights;
    }
    leaf[t] = static_cast<std::int32_t>(divisions.size());
    pieces_of_[faces_[t]].push_back(leaf[t]);
    divisions.emplace_back();
    divisions.back().triangle = t;
    divisions.back().piece = static_cast<std::int32_t>(pieces_.size());
    pieces_.push_back(piece);
  }
  divisions_ = std::move(divisions);
  leaf_ = std::move(leaf);
}

/// A corner in the plane of its face, without distortion but for rounding; the same for all triangles of the face.
Kernel::Point_2 Region_mesh::in_plane(std::int32_t triangle, int slot) const {
  const Halfedge h = mesh_.halfedge(faces_[triangle]);
  const Vec a = to_vec(mesh_.point(mesh_.target(h))), b = to_vec(mesh_.point(mesh_.target(mesh_.next(h)))),
            c = to_vec(mesh_.point(mesh_.source(h)));
  const Vec x = (b - a).stableNormalized(), y = (b - a).cross(c - a).cross(b - a).stableNormalized();
  const Vec p = points_[triangles_[triangle].corner[slot]] - a;
  return {p.dot(x), p.dot(y)};
}

/// The triangle beyond an edge if both are pieces of one face and convex together; else -1.
std::int32_t Region_mesh::flippable(std::int32_t triangle, int slot) const {
  const std::int32_t other = triangles_[triangle].beyond[slot];
  if (other < 0 || leaf_[triangle] < 0 || leaf_[other] < 0 || faces_[triangle] != faces_[other]) return -1;
  const std::int32_t b = triangles_[triangle].corner[(slot + 1) % 3];
  const int far = (slot_of(triangles_[other], b) + 1) % 3;
  const auto p = in_plane(triangle, slot), q = in_plane(triangle, (slot + 1) % 3),
             r = in_plane(triangle, (slot + 2) % 3), s = in_plane(other, far);
  const bool convex = CGAL::orientation(p, q, s) == CGAL::LEFT_TURN && CGAL::orientation(p, s, r) == CGAL::LEFT_TURN;
  return convex ? other : -1;
}

bool Region_mesh::is_delaunay(std::int32_t triangle, int slot, std::int32_t other) const {
  const std::int32_t b = triangles_[triangle].corner[(slot + 1) % 3];
  const int far = (slot_of(triangles_[other], b) + 1) % 3;
  return CGAL::side_of_oriented_circle(in_plane(triangle, 0), in_plane(triangle, 1), in_plane(triangle, 2),
                                       in_plane(other, far)) != CGAL::ON_POSITIVE_SIDE;
}

/// Of triangles (a, b, c) and (d, c, b), with a in the slot, makes (a, b, d) and (a, d, c), the first in its slots.
void Region_mesh::flip(std::int32_t triangle, int slot) {
  const std::int32_t other = triangles_[triangle].beyond[slot];
  Triangle &first = triangles_[triangle], &second = triangles_[other];
  const int b = (slot + 1) % 3, c = (slot + 2) % 3;
  const int other_b = slot_of(second, first.corner[b]), d = (other_b + 1) % 3, other_c = (other_b + 2) % 3;
  // Beyond the edges of the four sides.
  const std::int32_t over_ca = first.beyond[b], over_bd = second.beyond[other_c], over_dc = second.beyond[other_b];
  const std::int32_t vertex_b = first.corner[b], vertex_c = first.corner[c];
  first.corner[c] = second.corner[d];
  second.corner[other_b] = first.corner[slot];
  first.beyond[slot] = over_bd;
  first.beyond[b] = other;
  second.beyond[d] = over_ca;
  second.beyond[other_c] = triangle;
  second.beyond[other_b] = over_dc;
  replace_beyond(over_ca, triangle, other);
  replace_beyond(over_bd, other, triangle);
  if (triangle_at_[vertex_c] == triangle) triangle_at_[vertex_c] = other;
  if (triangle_at_[vertex_b] == other) triangle_at_[vertex_b] = triangle;
  Piece &piece = pieces_[divisions_[leaf_[triangle]].piece], &other_piece = pieces_[divisions_[leaf_[other]].piece];
  piece[c] = other_piece[d];
  other_piece[other_b] = piece[slot];
}

void Region_mesh::make_delaunay() {
  put_into_pieces();
  std::vector<std::int32_t> stack;
  for (const auto& [face, divisions] : pieces_of_)
    for (const std::int32_t division : divisions) stack.push_back(divisions_[division].triangle);
  while (!stack.empty()) {
    const std::int32_t t = stack.back();
    stack.pop_back();
    for (int slot = 0; slot < 3; ++slot) {
      const std::int32_t other = flippable(t, slot);
      if (other < 0 || is_delaunay(t, slot, other)) continue;
      flip(t, slot);
      stack.push_back(other);
      stack.push_back(t);
      break;
    }
  }
}

}  // namespace cgal_blend
