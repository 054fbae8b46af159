// SPDX-License-Identifier: GPL-3.0-or-later
#include "region_mesh.h"

#include <Eigen/Geometry>

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

double Region_mesh::height(std::int32_t triangle) const {
  const auto c = corners(triangle);
  const Vec p = c[1] - c[0], q = c[2] - c[0];
  const double longest = std::max({p.norm(), q.norm(), (q - p).norm()});
  return longest > 0 ? p.cross(q).norm() / longest : 0;
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

/// The division that a whole triangle is, ready to get parts.
std::int32_t Region_mesh::root_of(std::int32_t triangle) {
  if (leaf_[triangle] < 0) {
    leaf_[triangle] = static_cast<std::int32_t>(divisions_.size());
    divisions_.emplace_back();
  }
  divisions_[leaf_[triangle]].triangle = -1;
  return leaf_[triangle];
}

void Region_mesh::record(std::int32_t node, int slot, std::int32_t triangle) {
  const auto part = static_cast<std::int32_t>(divisions_.size());
  divisions_.emplace_back();
  divisions_[part].parent = node;
  divisions_[part].triangle = triangle;
  divisions_[node].part[slot] = part;
  leaf_[triangle] = part;
}

void Region_mesh::replace_beyond(std::int32_t triangle, std::int32_t old, std::int32_t by) {
  if (triangle < 0) return;
  for (std::int32_t& beyond : triangles_[triangle].beyond)
    if (beyond == old) beyond = by;
}

/// Of a triangle (a, b, c) with a in the slot and a new vertex m between b and c, the old one becomes (a, b, m), the
/// new one (a, m, c); corners keep their slots.
std::int32_t Region_mesh::halve(std::int32_t triangle, int slot, std::int32_t vertex, double share) {
  const int b = (slot + 1) % 3, c = (slot + 2) % 3;
  const auto half = static_cast<std::int32_t>(triangles_.size());
  triangles_.push_back(Triangle(triangles_[triangle]));
  faces_.push_back(Face(faces_[triangle]));
  leaf_.push_back(-1);
  Triangle &first = triangles_[triangle], &second = triangles_[half];
  replace_beyond(first.beyond[b], triangle, half);
  first.corner[c] = vertex;
  second.corner[b] = vertex;
  first.beyond[b] = half;
  second.beyond[c] = triangle;
  if (triangle_at_[second.corner[c]] == triangle) triangle_at_[second.corner[c]] = half;
  triangle_at_[vertex] = half;

  const std::int32_t node = root_of(triangle);
  divisions_[node].at[b] = 1 - share;
  divisions_[node].at[c] = share;
  record(node, c, triangle);
  record(node, b, half);
  return half;
}

/// Part i has the new vertex in place of corner i, and part j beyond its edge opposite of corner j.
std::int32_t Region_mesh::divide(std::int32_t triangle, const std::array<double, 3>& weights, const Vec& at) {
  const std::int32_t vertex = add_point(at);
  const Triangle whole = triangles_[triangle];
  const std::int32_t node = root_of(triangle);
  divisions_[node].at = weights;
  std::array<std::int32_t, 3> parts{triangle, 0, 0};
  for (int i = 1; i < 3; ++i) {
    parts[i] = static_cast<std::int32_t>(triangles_.size());
    triangles_.push_back(whole);
    faces_.push_back(Face(faces_[triangle]));
    leaf_.push_back(-1);
    replace_beyond(whole.beyond[i], triangle, parts[i]);
  }
  for (int i = 0; i < 3; ++i) {
    Triangle& part = triangles_[parts[i]];
    part.corner[i] = vertex;
    for (int j = 0; j < 3; ++j)
      if (j != i) part.beyond[j] = parts[j];
    record(node, i, parts[i]);
  }
  if (triangle_at_[whole.corner[0]] == triangle) triangle_at_[whole.corner[0]] = parts[1];
  triangle_at_[vertex] = triangle;
  return vertex;
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
    int slot = 0;
    while (division.part[slot] != child) ++slot;
    const double of_vertex = w[slot];
    for (int i = 0; i < 3; ++i) w[i] = (i == slot ? 0 : w[i]) + of_vertex * division.at[i];
    child = node;
  }
  if (child < 0 || divisions_[child].piece < 0) return {faces_[place.triangle], w};
  std::array<double, 3> whole{};
  const Piece& piece = pieces_[divisions_[child].piece];
  for (int corner = 0; corner < 3; ++corner)
    for (int i = 0; i < 3; ++i) whole[i] += w[corner] * piece[corner][i];
  return {faces_[place.triangle], whole};
}

/// The division that contains a place of a face, whose weights become those in it.
std::int32_t Region_mesh::start_of(Place& place) const {
  const auto pieces = pieces_of_.find(faces_[place.triangle]);
  if (pieces == pieces_of_.end()) {
    std::int32_t node = leaf_[place.triangle];
    while (divisions_[node].parent >= 0) node = divisions_[node].parent;
    return node;
  }
  const std::array<double, 3> at = place.weights;
  std::int32_t best = -1;
  double most = 0;  // of the least weight
  for (const std::int32_t node : pieces->second) {
    const Piece& p = pieces_[divisions_[node].piece];
    const auto area = [](const auto& a, const auto& b, const auto& c) {
      return (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]);
    };
    const double whole = area(p[0], p[1], p[2]);
    const std::array<double, 3> w{area(at, p[1], p[2]) / whole, area(p[0], at, p[2]) / whole,
                                  area(p[0], p[1], at) / whole};
    const double least = std::min({w[0], w[1], w[2]});
    if (best >= 0 && least <= most) continue;
    best = node;
    most = least;
    place.weights = w;
  }
  for (double& w : place.weights) w = std::max(w, 0.0);
  return best;
}

Region_mesh::Place Region_mesh::in_triangle(const Face_point& at) const {
  Place place{triangle_of_[at.face.idx()], at.weights};
  if (place.triangle < 0 || leaf_[place.triangle] < 0) return place;
  std::int32_t node = start_of(place);
  auto& w = place.weights;
  while (divisions_[node].triangle < 0) {
    const Division& division = divisions_[node];
    int slot = -1;  // of the part that contains the place: the new vertex takes no more than there is of any corner
    double of_vertex = 0;
    for (int i = 0; i < 3; ++i) {
      if (division.part[i] < 0 || (slot >= 0 && w[i] / division.at[i] >= of_vertex)) continue;
      of_vertex = w[i] / division.at[i];
      slot = i;
    }
    for (int i = 0; i < 3; ++i) w[i] = i == slot ? of_vertex : std::max(0.0, w[i] - of_vertex * division.at[i]);
    node = division.part[slot];
  }
  place.triangle = divisions_[node].triangle;
  return place;
}

}  // namespace cgal_blend
