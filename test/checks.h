// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_TEST_CHECKS_H
#define CGAL_BLEND_TEST_CHECKS_H

#include <cgal_blend/blend_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

// Oracles shared by the tests. They share no code with the library, and are plain rather than fast.

namespace cgal_blend::test {

using Face_corners = std::array<std::size_t, 3>;

/// Vertex indices of a face, beginning with the source of its halfedge.
inline Face_corners corners_of(const Blend_mesh& mesh, Face f) {
  const Halfedge h = mesh.halfedge(f);
  return {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))};
}

/// Same, turned so that the least index comes first: equal for faces that are the same but for the start.
inline Face_corners turned_corners_of(const Blend_mesh& mesh, Face f) {
  auto [a, b, c] = corners_of(mesh, f);
  if (b < a && b < c) return {b, c, a};
  if (c < a && c < b) return {c, a, b};
  return {a, b, c};
}

namespace detail {

using Long_vector = std::array<long double, 3>;

inline Long_vector difference(const Point_3& p, const Point_3& q) {
  return {static_cast<long double>(p.x()) - q.x(), static_cast<long double>(p.y()) - q.y(),
          static_cast<long double>(p.z()) - q.z()};
}

inline Long_vector cross(const Long_vector& a, const Long_vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline long double dot(const Long_vector& a, const Long_vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

}  // namespace detail

/// Enclosed volume by the divergence theorem, about the first vertex.
inline double volume_of(const Blend_mesh& mesh) {
  if (mesh.number_of_faces() == 0) return 0;
  const Point_3 origin = mesh.point(*mesh.vertices().begin());
  long double sum = 0;
  for (const Face f : mesh.faces()) {
    const auto [a, b, c] = corners_of(mesh, f);
    const auto p = detail::difference(mesh.point(Vertex(a)), origin),
               q = detail::difference(mesh.point(Vertex(b)), origin),
               r = detail::difference(mesh.point(Vertex(c)), origin);
    sum += detail::dot(p, detail::cross(q, r));
  }
  return static_cast<double>(sum / 6);
}

template <class Faces>
double area_of(const Blend_mesh& mesh, const Faces& faces) {
  long double sum = 0;
  for (const Face f : faces) {
    const auto [a, b, c] = corners_of(mesh, f);
    const auto n = detail::cross(detail::difference(mesh.point(Vertex(b)), mesh.point(Vertex(a))),
                                 detail::difference(mesh.point(Vertex(c)), mesh.point(Vertex(a))));
    sum += std::sqrt(detail::dot(n, n));
  }
  return static_cast<double>(sum / 2);
}

inline double area_of(const Blend_mesh& mesh) { return area_of(mesh, mesh.faces()); }

/// True if every directed edge occurs once and its opposite too: closed, consistently oriented, no crowded edge.
inline bool is_closed_by_counting(const Blend_mesh& mesh) {
  std::map<std::pair<std::size_t, std::size_t>, int> uses;
  for (const Face f : mesh.faces()) {
    const Face_corners v = corners_of(mesh, f);
    for (int i = 0; i < 3; ++i) ++uses[{v[i], v[(i + 1) % 3]}];
  }
  for (const auto& [edge, count] : uses) {
    const auto opposite = uses.find({edge.second, edge.first});
    if (count != 1 || opposite == uses.end() || opposite->second != 1) return false;
  }
  return !uses.empty();
}

/// True if the faces at every vertex form one fan, by growing it over shared edges.
inline bool has_single_fans(const Blend_mesh& mesh) {
  std::map<std::size_t, std::map<std::size_t, std::size_t>> wings;  // vertex -> (next corner -> previous corner)
  std::map<std::size_t, std::size_t> faces;
  for (const Face f : mesh.faces()) {
    const Face_corners v = corners_of(mesh, f);
    for (int i = 0; i < 3; ++i) {
      wings[v[i]][v[(i + 1) % 3]] = v[(i + 2) % 3];
      ++faces[v[i]];
    }
  }
  for (const auto& [vertex, wing] : wings) {
    std::size_t met = 0, at = wing.begin()->first;
    do {
      const auto next = wing.find(at);
      if (next == wing.end()) return false;  // open
      at = next->second;
      ++met;
    } while (at != wing.begin()->first && met <= faces[vertex]);
    if (met != faces[vertex]) return false;
  }
  return true;
}

/// True if every step of the loop is an edge of one triangle in its direction, and every other edge has two triangles.
inline bool fill_exactly(const std::vector<std::array<Vertex, 3>>& triangles, const std::vector<Vertex>& loop) {
  std::map<std::pair<Vertex, Vertex>, int> uses;
  for (const auto& t : triangles)
    for (int i = 0; i < 3; ++i) ++uses[{t[i], t[(i + 1) % 3]}];
  for (std::size_t i = 0; i < loop.size(); ++i) ++uses[{loop[(i + 1) % loop.size()], loop[i]}];
  return !uses.empty() && std::all_of(uses.begin(), uses.end(), [&](const auto& use) {
    const auto opposite = uses.find({use.first.second, use.first.first});
    return use.second == 1 && opposite != uses.end() && opposite->second == 1;
  });
}

/// Pairs of faces that meet outside of what they share. Every pair with overlapping boxes is tested on its own.
inline std::vector<std::pair<Face, Face>> crossing_faces_by_brute_force(const Blend_mesh& mesh) {
  using Triangle_3 = Kernel::Triangle_3;
  using Segment_3 = Kernel::Segment_3;
  std::vector<Face> faces(mesh.faces().begin(), mesh.faces().end());
  std::vector<CGAL::Bbox_3> boxes;
  const auto point = [&](std::size_t v) -> const Point_3& { return mesh.point(Vertex(v)); };
  const auto triangle = [&](const Face_corners& v) { return Triangle_3(point(v[0]), point(v[1]), point(v[2])); };
  for (const Face f : faces) boxes.push_back(triangle(corners_of(mesh, f)).bbox());

  const auto cross = [&](Face f, Face g) {
    const Face_corners a = corners_of(mesh, f), b = corners_of(mesh, g);
    std::vector<std::size_t> shared, only_a, only_b;
    const std::set<std::size_t> in_a(a.begin(), a.end()), in_b(b.begin(), b.end());
    for (const std::size_t v : a) (in_b.count(v) ? shared : only_a).push_back(v);
    for (const std::size_t v : b)
      if (!in_a.count(v)) only_b.push_back(v);
    if (shared.size() == 3) return true;
    if (shared.size() == 2) {  // folded onto each other, or not
      const Point_3 &p = point(shared[0]), &q = point(shared[1]), &r = point(only_a[0]), &s = point(only_b[0]);
      return CGAL::coplanar(p, q, r, s) && CGAL::coplanar_orientation(p, q, r, s) == CGAL::POSITIVE;
    }
    if (shared.size() == 1)
      return CGAL::do_intersect(triangle(a), Segment_3(point(only_b[0]), point(only_b[1]))) ||
             CGAL::do_intersect(triangle(b), Segment_3(point(only_a[0]), point(only_a[1])));
    return CGAL::do_intersect(triangle(a), triangle(b));
  };

  std::vector<std::pair<Face, Face>> found;
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (std::size_t j = i + 1; j < faces.size(); ++j)
      if (CGAL::do_overlap(boxes[i], boxes[j]) && cross(faces[i], faces[j])) found.emplace_back(faces[i], faces[j]);
  return found;
}

/// Smallest corner angle of any face, degrees.
inline double smallest_angle_deg(const Blend_mesh& mesh) {
  double smallest = 180;
  for (const Face f : mesh.faces()) {
    const Face_corners v = corners_of(mesh, f);
    for (int i = 0; i < 3; ++i) {
      const Point_3& p = mesh.point(Vertex(v[i]));
      const Vector_3 a = mesh.point(Vertex(v[(i + 1) % 3])) - p, b = mesh.point(Vertex(v[(i + 2) % 3])) - p;
      const double angle = std::atan2(std::sqrt(CGAL::cross_product(a, b).squared_length()), a * b);
      smallest = std::min(smallest, angle * 180 / 3.14159265358979323846);
    }
  }
  return smallest;
}

// Distances of a point to true surfaces; signed, positive outside.

inline double distance_to_plane(const Point_3& p, const Point_3& on_plane, const Vector_3& normal) {
  return (p - on_plane) * normal / std::sqrt(normal.squared_length());
}

inline double distance_to_sphere(const Point_3& p, const Point_3& centre, double radius) {
  return std::sqrt(CGAL::squared_distance(p, centre)) - radius;
}

inline double distance_to_axis(const Point_3& p, const Point_3& on_axis, const Vector_3& direction) {
  return std::sqrt(CGAL::cross_product(p - on_axis, direction).squared_length() / direction.squared_length());
}

inline double distance_to_cylinder(const Point_3& p, const Point_3& on_axis, const Vector_3& direction, double radius) {
  return distance_to_axis(p, on_axis, direction) - radius;
}

inline double distance_to_torus(const Point_3& p, const Point_3& centre, const Vector_3& axis, double major,
                                double minor) {
  const double height = distance_to_plane(p, centre, axis);
  return std::hypot(distance_to_axis(p, centre, axis) - major, height) - minor;
}

/// True if every face of `part`, by the positions of its corners bit for bit, is a face of `whole`, in the same order.
inline bool faces_kept_in_order(const Blend_mesh& part, const Blend_mesh& whole, const std::vector<Face>& kept) {
  const auto positions = [](const Blend_mesh& mesh, Face f) {
    std::array<Point_3, 3> p;
    const Face_corners v = corners_of(mesh, f);
    const std::size_t first =
        std::min_element(v.begin(), v.end(),
                         [&](std::size_t a, std::size_t b) { return mesh.point(Vertex(a)) < mesh.point(Vertex(b)); }) -
        v.begin();
    for (std::size_t i = 0; i < 3; ++i) p[i] = mesh.point(Vertex(v[(first + i) % 3]));
    return p;
  };
  auto at = whole.faces().begin();
  for (const Face f : kept) {
    while (at != whole.faces().end() && positions(whole, *at) != positions(part, f)) ++at;
    if (at == whole.faces().end()) return false;
    ++at;
  }
  return true;
}

/// True if vertices and faces are the same, in the same order, wherever the vertices lie.
inline bool same_connectivity(const Blend_mesh& a, const Blend_mesh& b) {
  if (a.number_of_vertices() != b.number_of_vertices() || a.number_of_faces() != b.number_of_faces()) return false;
  auto g = b.faces().begin();
  for (const Face f : a.faces())
    if (turned_corners_of(a, f) != turned_corners_of(b, *g++)) return false;
  return true;
}

/// True if two meshes have the same vertices, bit for bit, and the same faces, both in the same order.
inline bool identical(const Blend_mesh& a, const Blend_mesh& b) {
  if (!same_connectivity(a, b)) return false;
  auto v = b.vertices().begin();
  for (const Vertex u : a.vertices())
    if (a.point(u) != b.point(*v++)) return false;
  return true;
}

}  // namespace cgal_blend::test

#endif
