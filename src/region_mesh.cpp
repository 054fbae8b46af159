// SPDX-License-Identifier: GPL-3.0-or-later
#include "region_mesh.h"

#include <algorithm>

namespace cgal_blend {

Region_mesh::Region_mesh(const Blend_mesh& mesh)
    : mesh_(mesh),
      vertex_of_(mesh.number_of_vertices() + mesh.number_of_removed_vertices(), -1),
      triangle_of_(mesh.number_of_faces() + mesh.number_of_removed_faces(), -1) {}

std::int32_t Region_mesh::add_point(const Vec& point) {
  points_.push_back(point);
  triangle_at_.push_back(-1);
  return static_cast<std::int32_t>(points_.size() - 1);
}

std::int32_t Region_mesh::add_vertex(Vertex v) {
  std::int32_t& local = vertex_of_[v.idx()];
  if (local < 0) local = add_point(to_vec(mesh_.point(v)));
  return local;
}

std::int32_t Region_mesh::add(const std::array<std::int32_t, 3>& corners) {
  const auto t = static_cast<std::int32_t>(triangles_.size());
  triangles_.push_back({corners, {unknown, unknown, unknown}});
  faces_.emplace_back();
  leaf_.push_back(-1);
  for (const std::int32_t corner : corners) triangle_at_[corner] = t;
  return t;
}

void Region_mesh::join(std::int32_t triangle, int slot, std::int32_t other, int other_slot) {
  triangles_[triangle].beyond[slot] = other;
  triangles_[other].beyond[other_slot] = triangle;
}

/// Corner i is the target of the i-th halfedge, so the edge opposite of it is halfedge i + 2.
std::int32_t Region_mesh::add_face(Face f) {
  const Halfedge h0 = mesh_.halfedge(f), h1 = mesh_.next(h0), h2 = mesh_.next(h1);
  const std::int32_t t =
      add({add_vertex(mesh_.target(h0)), add_vertex(mesh_.target(h1)), add_vertex(mesh_.target(h2))});
  faces_[t] = f;
  triangle_of_[f.idx()] = t;
  const std::array<Halfedge, 3> opposite{mesh_.opposite(h2), mesh_.opposite(h0), mesh_.opposite(h1)};
  for (int slot = 0; slot < 3; ++slot) {
    const Face g = mesh_.face(opposite[slot]);
    if (g == Blend_mesh::null_face()) {
      triangles_[t].beyond[slot] = border;
      continue;
    }
    const std::int32_t u = triangle_of_[g.idx()];
    if (u < 0) {
      rim_.push_back(opposite[slot]);
      continue;
    }
    const Triangle& triangle = triangles_[u];
    int other = 0;  // the corner that is not shared
    while (triangle.corner[other] == triangles_[t].corner[(slot + 1) % 3] ||
           triangle.corner[other] == triangles_[t].corner[(slot + 2) % 3])
      ++other;
    join(t, slot, u, other);
  }
  return t;
}

void Region_mesh::grow(Face first, const std::function<bool(Face)>& belongs) {
  if (triangle_of_[first.idx()] < 0) add_face(first);
  std::vector<Halfedge> rejected;
  for (std::size_t i = 0; i < rim_.size(); ++i) {
    const Face f = mesh_.face(rim_[i]);
    if (triangle_of_[f.idx()] >= 0) continue;
    if (belongs(f))
      add_face(f);
    else
      rejected.push_back(rim_[i]);
  }
  rim_ = std::move(rejected);
}

std::array<Vec, 3> Region_mesh::corners(std::int32_t triangle) const {
  const auto& corner = triangles_[triangle].corner;
  return {points_[corner[0]], points_[corner[1]], points_[corner[2]]};
}

std::vector<std::int32_t> Region_mesh::star(std::int32_t vertex) const {
  const std::int32_t first = triangle_at_[vertex];
  std::int32_t t = first;
  for (;;) {  // clockwise to the border, or all round
    const std::int32_t before = triangles_[t].beyond[(slot_of(triangles_[t], vertex) + 2) % 3];
    if (before < 0 || before == first) break;
    t = before;
  }
  std::vector<std::int32_t> triangles;
  const std::int32_t start = t;
  do {
    triangles.push_back(t);
    t = triangles_[t].beyond[(slot_of(triangles_[t], vertex) + 1) % 3];
  } while (t >= 0 && t != start);
  return triangles;
}

std::pair<std::int32_t, int> Region_mesh::edge(std::int32_t from, std::int32_t to) const {
  std::pair<std::int32_t, int> found{-1, 0};
  for_star(from, [&](std::int32_t t, int slot) {
    if (triangles_[t].corner[(slot + 1) % 3] == to) found = {t, (slot + 2) % 3};
  });
  return found;
}

std::vector<char> Region_mesh::connected_to(std::int32_t vertex) const {
  std::vector<char> reached(triangles_.size(), 0);
  std::vector<std::int32_t> stack{triangle_at_[vertex]};
  reached[stack.back()] = 1;
  while (!stack.empty()) {
    const std::int32_t t = stack.back();
    stack.pop_back();
    for (const std::int32_t u : triangles_[t].beyond) {
      if (u < 0 || reached[u]) continue;
      reached[u] = 1;
      stack.push_back(u);
    }
  }
  return reached;
}

void Region_mesh::cut(std::int32_t triangle, int slot) {
  Triangle& first = triangles_[triangle];
  const std::int32_t other = first.beyond[slot];
  first.beyond[slot] = seam;
  triangle_at_[first.corner[(slot + 1) % 3]] = triangle_at_[first.corner[(slot + 2) % 3]] = triangle;
  if (other < 0) return;
  for (int i = 0; i < 3; ++i)
    if (triangles_[other].beyond[i] == triangle) triangles_[other].beyond[i] = seam;
}

std::int32_t Region_mesh::leaf_of(std::int32_t triangle) {
  if (leaf_[triangle] < 0) {
    leaf_[triangle] = static_cast<std::int32_t>(divisions_.size());
    divisions_.push_back({-1, {triangle, -1}, 0, 0});
  }
  return leaf_[triangle];
}

/// Of a triangle (a, b, c) with a in the slot and a new vertex m between b and c, the old one becomes (a, b, m), the
/// new one (a, m, c); both corners and weights keep their slots.
std::int32_t Region_mesh::halve(std::int32_t triangle, int slot, std::int32_t vertex, double share) {
  const int b = (slot + 1) % 3, c = (slot + 2) % 3;
  const auto half = static_cast<std::int32_t>(triangles_.size());
  triangles_.push_back(triangles_[triangle]);
  faces_.push_back(faces_[triangle]);
  Triangle &first = triangles_[triangle], &second = triangles_[half];
  const std::int32_t beyond = first.beyond[b];
  first.corner[c] = vertex;
  second.corner[b] = vertex;
  first.beyond[b] = half;
  second.beyond[c] = triangle;
  if (beyond >= 0)
    for (std::int32_t& back : triangles_[beyond].beyond)
      if (back == triangle) back = half;
  if (triangle_at_[second.corner[c]] == triangle) triangle_at_[second.corner[c]] = half;
  triangle_at_[vertex] = half;

  const std::int32_t node = leaf_of(triangle);
  const auto part = static_cast<std::int32_t>(divisions_.size());
  divisions_.push_back({node, {triangle, -1}, 0, 0});
  divisions_.push_back({node, {half, -1}, 0, 0});
  divisions_[node].part = {part, part + 1};
  divisions_[node].slot = slot;
  divisions_[node].share = share;
  leaf_[triangle] = part;
  leaf_.push_back(part + 1);
  return half;
}

std::int32_t Region_mesh::divide(std::int32_t triangle, int slot, double share, const Vec& at) {
  const std::int32_t other = triangles_[triangle].beyond[slot];
  const std::int32_t vertex = add_point(at);
  int other_slot = 0;
  if (other >= 0)
    while (triangles_[other].beyond[other_slot] != triangle ||
           triangles_[other].corner[(other_slot + 1) % 3] != triangles_[triangle].corner[(slot + 2) % 3])
      ++other_slot;
  const std::int32_t half = halve(triangle, slot, vertex, share);
  if (other < 0) return vertex;
  const std::int32_t other_half = halve(other, other_slot, vertex, 1 - share);
  join(triangle, slot, other_half, other_slot);
  join(half, slot, other, other_slot);
  return vertex;
}

bool Region_mesh::Longest::less_than(const Longest& other) const {
  if (squared_length != other.squared_length) return squared_length < other.squared_length;
  return low != other.low ? low < other.low : high < other.high;
}

Region_mesh::Longest Region_mesh::longest_edge(std::int32_t triangle) const {
  const auto& corner = triangles_[triangle].corner;
  Longest longest{0, -1, 0, 0};
  for (int slot = 0; slot < 3; ++slot) {
    const std::int32_t b = corner[(slot + 1) % 3], c = corner[(slot + 2) % 3];
    const Longest edge{slot, (points_[b] - points_[c]).squaredNorm(), std::min(b, c), std::max(b, c)};
    if (longest.less_than(edge)) longest = edge;
  }
  return longest;
}

/// Divides the edge at the end of the path from triangle to triangle over ever longer edges.
void Region_mesh::divide_longest(std::int32_t triangle) {
  for (;;) {
    const Longest edge = longest_edge(triangle);
    const std::int32_t next = triangles_[triangle].beyond[edge.slot];
    if (next < 0 || !edge.less_than(longest_edge(next))) {
      divide(triangle, edge.slot, 0.5, 0.5 * (points_[edge.low] + points_[edge.high]));
      return;
    }
    triangle = next;
  }
}

void Region_mesh::refine(std::int32_t first, double length,
                         const std::function<bool(const std::array<Vec, 3>&)>& belongs) {
  const double limit = length * length;
  for (std::int32_t t = first; t < static_cast<std::int32_t>(triangles_.size());)
    if (longest_edge(t).squared_length > limit && belongs(corners(t)))
      divide_longest(t);
    else
      ++t;
  // A triangle that was passed may have been divided since, but its parts are smaller, and new ones come at the end.
}

Face_point Region_mesh::in_face(const Place& place) const {
  std::array<double, 3> w = place.weights;
  std::int32_t child = leaf_[place.triangle];
  for (std::int32_t node = child < 0 ? -1 : divisions_[child].parent; node >= 0; node = divisions_[node].parent) {
    const Division& division = divisions_[node];
    const int b = (division.slot + 1) % 3, c = (division.slot + 2) % 3;
    if (child == division.part[0]) {
      w[b] += (1 - division.share) * w[c];
      w[c] *= division.share;
    } else {
      w[c] += division.share * w[b];
      w[b] *= 1 - division.share;
    }
    child = node;
  }
  return {faces_[place.triangle], w};
}

Region_mesh::Place Region_mesh::in_triangle(const Face_point& at) const {
  Place place{triangle_of_[at.face.idx()], at.weights};
  if (place.triangle < 0 || leaf_[place.triangle] < 0) return place;
  std::int32_t node = leaf_[place.triangle];
  while (divisions_[node].parent >= 0) node = divisions_[node].parent;
  auto& w = place.weights;
  while (divisions_[node].part[1] >= 0) {
    const Division& division = divisions_[node];
    const int b = (division.slot + 1) % 3, c = (division.slot + 2) % 3;
    const double s = division.share;
    const bool first = w[c] * (1 - s) <= w[b] * s;
    if (first) {
      w[b] = std::max(0.0, w[b] - w[c] * (1 - s) / s);
      w[c] /= s;
    } else {
      w[c] = std::max(0.0, w[c] - w[b] * s / (1 - s));
      w[b] /= 1 - s;
    }
    node = division.part[first ? 0 : 1];
  }
  place.triangle = divisions_[node].part[0];
  return place;
}

}  // namespace cgal_blend
