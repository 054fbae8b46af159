// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_TEST_SHAPES_H
#define CGAL_BLEND_TEST_SHAPES_H

#include <cgal_blend/blend_mesh.h>

#include <CGAL/Aff_transformation_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

// Closed triangle meshes, oriented outward, with vertices on the true surface; and motions of them.

namespace cgal_blend::test {

inline constexpr double pi = 3.14159265358979323846;

using Placement = CGAL::Aff_transformation_3<Kernel>;
using Corner_indices = std::array<std::size_t, 3>;

/// Builds a mesh; throws where the faces do not fit together, so that a wrong shape cannot pass unnoticed.
inline Blend_mesh mesh_of(const std::vector<Point_3>& points, const std::vector<Corner_indices>& triangles) {
  Blend_mesh mesh;
  std::vector<Vertex> vertices;
  for (const Point_3& p : points) vertices.push_back(mesh.add_vertex(p));
  for (const Corner_indices& t : triangles)
    if (mesh.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]) == Blend_mesh::null_face())
      throw std::logic_error("a test shape has a face that does not fit");
  return mesh;
}

/// 8 vertices (bit 0 of the index: x, bit 1: y, bit 2: z), 12 faces.
inline Blend_mesh box(const Point_3& low, const Point_3& high) {
  std::vector<Point_3> points;
  for (int i = 0; i < 8; ++i)
    points.emplace_back(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(), i & 4 ? high.z() : low.z());
  return mesh_of(points, {{0, 2, 3},
                          {0, 3, 1},
                          {4, 5, 7},
                          {4, 7, 6},
                          {0, 1, 5},
                          {0, 5, 4},
                          {2, 6, 7},
                          {2, 7, 3},
                          {0, 4, 6},
                          {0, 6, 2},
                          {1, 3, 7},
                          {1, 7, 5}});
}

/// Box whose sides are grids of n x n squares of two triangles each: 12 n^2 faces.
inline Blend_mesh grid_box(const Point_3& low, const Point_3& high, int n) {
  std::map<std::array<int, 3>, std::size_t> index;
  std::vector<Point_3> points;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [place, is_new] = index.emplace(at, points.size());
    const auto along = [&](int k) { return at[k] == n ? high[k] : low[k] + at[k] * (high[k] - low[k]) / n; };
    if (is_new) points.emplace_back(along(0), along(1), along(2));
    return place->second;
  };
  std::vector<Corner_indices> triangles;
  for (int axis = 0; axis < 3; ++axis)
    for (const int side : {0, n})
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const auto at = [&](int u, int v) {
            std::array<int, 3> a{};
            a[axis] = side;
            a[(axis + 1) % 3] = side == 0 ? v : u;  // swapped on the far side, so that both look outward
            a[(axis + 2) % 3] = side == 0 ? u : v;
            return vertex(a);
          };
          triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
          triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
  return mesh_of(points, triangles);
}

/// Flat plate from (-a, -a, -thickness) to (a, a, 0): what a boss stands on.
inline Blend_mesh plate(double a, double thickness) { return box({-a, -a, -thickness}, {a, a, 0}); }

/// Right prism over an outline in the xy-plane, counter-clockwise and star-shaped seen from its first point. The caps
/// are fans from that point, without further vertices.
inline Blend_mesh prism(const std::vector<std::pair<double, double>>& outline, double z0, double z1) {
  const std::size_t n = outline.size();
  std::vector<Point_3> points;
  for (const double z : {z0, z1})
    for (const auto& [x, y] : outline) points.emplace_back(x, y, z);
  std::vector<Corner_indices> triangles;
  for (std::size_t i = 1; i + 1 < n; ++i) {
    triangles.push_back({0, i + 1, i});
    triangles.push_back({n, n + i, n + i + 1});
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    triangles.push_back({i, j, n + j});
    triangles.push_back({i, n + j, n + i});
  }
  return mesh_of(points, triangles);
}

/// L-shaped bracket, legs of length a and thickness t, height h: one concave edge, along z through (t, t).
inline Blend_mesh l_bracket(double a, double t, double h) {
  return prism({{t, t}, {t, a}, {0, a}, {0, 0}, {a, 0}, {a, t}}, 0, h);
}

/// Body of revolution about the z-axis in n steps: the outline runs from a point on the axis below to one on the axis
/// above, as (distance from the axis, height).
inline Blend_mesh turned(const std::vector<std::pair<double, double>>& outline, int n) {
  const std::size_t steps = n, circles = outline.size() - 2;
  std::vector<Point_3> points;
  for (std::size_t k = 1; k <= circles; ++k)
    for (std::size_t i = 0; i < steps; ++i) {
      const double angle = 2 * pi * i / steps;
      points.emplace_back(outline[k].first * std::cos(angle), outline[k].first * std::sin(angle), outline[k].second);
    }
  const std::size_t bottom = points.size(), top = bottom + 1, last = (circles - 1) * steps;
  points.emplace_back(0, 0, outline.front().second);
  points.emplace_back(0, 0, outline.back().second);
  std::vector<Corner_indices> triangles;
  for (std::size_t i = 0; i < steps; ++i) {
    const std::size_t j = (i + 1) % steps;
    triangles.push_back({bottom, j, i});
    triangles.push_back({top, last + i, last + j});
    for (std::size_t k = 0; k + 1 < circles; ++k) {
      const std::size_t a = k * steps, b = a + steps;
      triangles.push_back({a + i, a + j, b + j});
      triangles.push_back({a + i, b + j, b + i});
    }
  }
  return mesh_of(points, triangles);
}

/// Regular n-gon cylinder about the z-axis with its vertices on radius R; `rings` further circles in between. The caps
/// are fans about a vertex on the axis.
inline Blend_mesh cylinder(double radius, int n, double z0, double z1, int rings = 0) {
  std::vector<std::pair<double, double>> outline{{0, z0}};
  for (int k = 0; k <= rings; ++k) outline.emplace_back(radius, z0 + k * (z1 - z0) / (rings + 1));
  outline.emplace_back(radius, z1);
  outline.emplace_back(0, z1);
  return turned(outline, n);
}

/// Round plate of radius a below z = 0 with a boss of radius R on it, in steps of about `step` in all directions; the
/// boss meets the plate in one circle of edges at z = 0.
inline Blend_mesh boss_on_plate(double radius, double a, double thickness, double height, double step) {
  std::vector<std::pair<double, double>> outline{{0, -thickness}};
  const auto line_to = [&](double rho, double z) {
    const auto [rho0, z0] = outline.back();
    const int n = std::max(1, static_cast<int>(std::lround(std::hypot(rho - rho0, z - z0) / step)));
    for (int k = 1; k < n; ++k) outline.emplace_back(rho0 + k * (rho - rho0) / n, z0 + k * (z - z0) / n);
    outline.emplace_back(rho, z);
  };
  line_to(a, -thickness);
  line_to(a, 0);
  line_to(radius, 0);
  line_to(radius, height);
  line_to(0, height);
  return turned(outline, static_cast<int>(std::lround(2 * pi * radius / step)));
}

/// Cone about the z-axis: n-gon of radius R at z = 0, apex at z = height.
inline Blend_mesh cone(double radius, double height, int n) {
  const std::size_t sides = n;
  std::vector<Point_3> points;
  for (std::size_t i = 0; i < sides; ++i)
    points.emplace_back(radius * std::cos(2 * pi * i / sides), radius * std::sin(2 * pi * i / sides), 0);
  points.emplace_back(0, 0, 0);
  points.emplace_back(0, 0, height);
  std::vector<Corner_indices> triangles;
  for (std::size_t i = 0; i < sides; ++i) {
    const std::size_t j = (i + 1) % sides;
    triangles.push_back({sides, j, i});
    triangles.push_back({sides + 1, i, j});
  }
  return mesh_of(points, triangles);
}

/// Torus about the z-axis: centre circle of radius R in n_major steps, tube of radius r in n_minor steps.
inline Blend_mesh torus(double major, double minor, int n_major, int n_minor) {
  const std::size_t m = n_major, n = n_minor;
  std::vector<Point_3> points;
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const double u = 2 * pi * i / m, v = 2 * pi * j / n, rho = major + minor * std::cos(v);
      points.emplace_back(rho * std::cos(u), rho * std::sin(u), minor * std::sin(v));
    }
  std::vector<Corner_indices> triangles;
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const std::size_t a = i * n + j, b = (i + 1) % m * n + j, c = (i + 1) % m * n + (j + 1) % n,
                        d = i * n + (j + 1) % n;
      triangles.push_back({a, b, c});
      triangles.push_back({a, c, d});
    }
  return mesh_of(points, triangles);
}

/// Icosahedron split `level` times, all vertices on the sphere: 20 * 4^level faces.
inline Blend_mesh sphere(double radius, int level, const Point_3& centre = {0, 0, 0}) {
  const double g = (1 + std::sqrt(5.0)) / 2;
  std::vector<Vector_3> points = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                                  {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  std::vector<Corner_indices> triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                           {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                           {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                           {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (; level > 0; --level) {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
    const auto middle = [&](std::size_t i, std::size_t j) {
      const auto [place, is_new] = middles.emplace(std::minmax(i, j), points.size());
      if (is_new) points.push_back(points[i] + points[j]);
      return place->second;
    };
    std::vector<Corner_indices> finer;
    for (const auto& [a, b, c] : triangles) {
      const std::size_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    triangles = finer;
    for (Vector_3& p : points) p = p / std::sqrt(p.squared_length());
  }
  std::vector<Point_3> on_sphere;
  for (const Vector_3& p : points) on_sphere.push_back(centre + radius / std::sqrt(p.squared_length()) * p);
  return mesh_of(on_sphere, triangles);
}

/// Rotation about an axis through the origin (Rodrigues), then a uniform scaling, then a translation.
inline Placement placement(const Vector_3& axis, double angle, const Vector_3& translation = {0, 0, 0},
                           double scale = 1) {
  const Vector_3 a = axis / std::sqrt(axis.squared_length());
  const double c = std::cos(angle), s = std::sin(angle), d = 1 - c;
  const auto m = [&](double x) { return scale * x; };
  return {m(c + d * a.x() * a.x()),         m(d * a.x() * a.y() - s * a.z()),
          m(d * a.x() * a.z() + s * a.y()), translation.x(),
          m(d * a.y() * a.x() + s * a.z()), m(c + d * a.y() * a.y()),
          m(d * a.y() * a.z() - s * a.x()), translation.y(),
          m(d * a.z() * a.x() - s * a.y()), m(d * a.z() * a.y() + s * a.x()),
          m(c + d * a.z() * a.z()),         translation.z()};
}

inline Placement moved_by(double x, double y, double z) { return placement({0, 0, 1}, 0, {x, y, z}); }

inline Blend_mesh transformed(Blend_mesh mesh, const Placement& placement) {
  for (const Vertex v : mesh.vertices()) mesh.point(v) = placement.transform(mesh.point(v));
  return mesh;
}

/// Both meshes in one, the vertices and faces of `a` first; they are not cut where they cross.
inline Blend_mesh side_by_side(Blend_mesh a, const Blend_mesh& b) {
  std::vector<Vertex> copy(b.num_vertices());
  for (const Vertex v : b.vertices()) copy[v] = a.add_vertex(b.point(v));
  for (const Face f : b.faces()) {
    const Halfedge h = b.halfedge(f);
    a.add_face(copy[b.source(h)], copy[b.target(h)], copy[b.target(b.next(h))]);
  }
  return a;
}

/// Box from (0, 0, 0) to (4, 4, 4) with unit grids, and on its top a spike over the square from (1, 1) to (2, 2) whose tip
/// is folded down through its own side x = 1. Vertices and faces of the box come first, but for the square's two.
inline Blend_mesh box_with_folded_spike() {
  const Blend_mesh whole = grid_box({0, 0, 0}, {4, 4, 4}, 4);
  std::vector<Point_3> points;
  std::vector<Corner_indices> triangles;
  for (const Vertex v : whole.vertices()) points.push_back(whole.point(v));
  const auto in_square = [&](std::size_t v) {
    const Point_3& p = points[v];
    return p.z() == 4 && p.x() >= 1 && p.x() <= 2 && p.y() >= 1 && p.y() <= 2;
  };
  for (const Face f : whole.faces()) {
    const Halfedge h = whole.halfedge(f);
    const Corner_indices t{whole.source(h), whole.target(h), whole.target(whole.next(h))};
    if (!std::all_of(t.begin(), t.end(), in_square)) triangles.push_back(t);
  }
  std::array<std::size_t, 4> foot{}, head{};  // counter-clockwise seen from above
  const double corner[][2] = {{1, 1}, {2, 1}, {2, 2}, {1, 2}};
  for (std::size_t i = 0; i < 4; ++i) {
    const Point_3 place(corner[i][0], corner[i][1], 4);
    foot[i] = std::find(points.begin(), points.end(), place) - points.begin();
    head[i] = points.size();
    points.emplace_back(place.x(), place.y(), 5);
  }
  const std::size_t tip = points.size();
  points.emplace_back(0.5, 1.5, 4.5);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t j = (i + 1) % 4;
    triangles.insert(triangles.end(),
                     {{foot[i], foot[j], head[j]}, {foot[i], head[j], head[i]}, {head[i], head[j], tip}});
  }
  return mesh_of(points, triangles);
}

/// The same surface with a face without area along the edge between the vertices at two points; it is the last face, and
/// its further corner lies on a side of a neighbour.
inline Blend_mesh with_needle(const Blend_mesh& mesh, const Point_3& from, const Point_3& to) {
  std::vector<Point_3> points;
  std::vector<Corner_indices> triangles;
  for (const Vertex v : mesh.vertices()) points.push_back(mesh.point(v));
  const std::size_t a = std::find(points.begin(), points.end(), from) - points.begin(),
                    b = std::find(points.begin(), points.end(), to) - points.begin(), middle = points.size();
  points.push_back(CGAL::midpoint(from, to));
  for (const Face f : mesh.faces()) {
    const Halfedge h = mesh.halfedge(f);
    Corner_indices t{mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))};
    for (int turn = 0; turn < 3 && !(t[0] == a && t[1] == b); ++turn) std::rotate(t.begin(), t.begin() + 1, t.end());
    if (t[0] == a && t[1] == b) {
      triangles.push_back({a, middle, t[2]});
      triangles.push_back({middle, b, t[2]});
    } else {
      triangles.push_back(t);
    }
  }
  triangles.push_back({a, b, middle});
  return mesh_of(points, triangles);
}

/// The same surface with all faces turned over.
inline Blend_mesh inside_out(const Blend_mesh& mesh) {
  std::vector<Point_3> points;
  std::vector<Corner_indices> triangles;
  for (const Vertex v : mesh.vertices()) points.push_back(mesh.point(v));
  for (const Face f : mesh.faces()) {
    const Halfedge h = mesh.halfedge(f);
    triangles.push_back({mesh.source(h), mesh.target(mesh.next(h)), mesh.target(h)});
  }
  return mesh_of(points, triangles);
}

}  // namespace cgal_blend::test

#endif
