// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_REGION_MESH_H
#define CGAL_BLEND_SRC_REGION_MESH_H

#include "base_surface.h"

#include <cgal_blend/geodesic_polar.h>

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace cgal_blend {

/// A part of a triangle mesh in compact arrays, whose edges can be divided: the pieces lie in the faces of the mesh, so
/// distances along the surface stay what they are. Numbers are dense and follow the order in which faces were added.
class Region_mesh {
 public:
  static constexpr std::int32_t unknown = -1;  ///< beyond an edge: faces that are not part of the region
  static constexpr std::int32_t border = -2;   ///< beyond an edge: nothing
  static constexpr std::int32_t seam = -3;     ///< beyond an edge: the region was cut there

  struct Triangle {
    std::array<std::int32_t, 3> corner;  ///< counter-clockwise seen from outside
    std::array<std::int32_t, 3>
        beyond;  ///< the triangle over the edge opposite of each corner, or `unknown`, `border` or `seam`
  };

  explicit Region_mesh(const Blend_mesh& mesh);

  /// Adds the faces that are connected with those already there, or with the first, by faces that pass the test.
  void grow(Face first, const std::function<bool(Face)>& belongs);

  /// Divides an edge, opposite of a corner slot of a triangle, at a share of the way from its corner slot + 1 to
  /// slot + 2, and the triangles on both sides; returns the new vertex.
  std::int32_t divide(std::int32_t triangle, int slot, double share, const Vec& at);

  /// Divides a triangle into three at a place inside; returns the new vertex.
  std::int32_t divide(std::int32_t triangle, const std::array<double, 3>& weights, const Vec& at);

  /// Flips edges within faces of the mesh that have been divided until they are Delaunay between edges that were cut. What
  /// has been divided so far is not divided any more, it is in pieces.
  void make_delaunay();

  /// Divides triangles from the first to be looked at on by their longest edges until no one that passes the test has an
  /// edge longer than a length (Rivara's longest-edge propagation: no angle is less than half the least one before).
  void refine(std::int32_t first, double length, const std::function<bool(const std::array<Vec, 3>&)>& belongs);

  /// The triangle to the left of an edge between two vertices, and the slot opposite of it; -1 if there is none.
  [[nodiscard]] std::pair<std::int32_t, int> edge(std::int32_t from, std::int32_t to) const;
  /// Separates the triangles on both sides of an edge; from now on the one given is at the edge's ends.
  void cut(std::int32_t triangle, int slot);

  [[nodiscard]] const Blend_mesh& mesh() const { return mesh_; }
  [[nodiscard]] const std::vector<Vec>& points() const { return points_; }
  [[nodiscard]] const std::vector<Triangle>& triangles() const { return triangles_; }
  [[nodiscard]] std::array<Vec, 3> corners(std::int32_t triangle) const;
  /// The least height of a triangle.
  [[nodiscard]] double height(std::int32_t triangle) const;
  /// Slot of a vertex among the corners of a triangle.
  [[nodiscard]] static int slot_of(const Triangle& triangle, std::int32_t vertex);
  /// The triangles around a vertex, counter-clockwise; of a border vertex from border to border.
  [[nodiscard]] std::vector<std::int32_t> star(std::int32_t vertex) const;
  /// Same, each passed to a function with the slot of the vertex, in no certain order.
  template <class Visitor>
  void for_star(std::int32_t vertex, const Visitor& visit) const;

  /// Marks the triangles that can be reached from those around a vertex over edges.
  [[nodiscard]] std::vector<char> connected_to(std::int32_t vertex) const;

  /// Number of a vertex of the mesh; -1 if it is not there.
  [[nodiscard]] std::int32_t local(Vertex v) const { return vertex_of_[v.idx()]; }
  [[nodiscard]] std::int32_t local(Face f) const { return triangle_of_[f.idx()]; }
  /// The face of the mesh that a triangle lies in; null for those of filled holes.
  [[nodiscard]] Face face(std::int32_t triangle) const { return faces_[triangle]; }

  /// A place in a triangle, with weights of its corners.
  struct Place {
    std::int32_t triangle = -1;
    std::array<double, 3> weights{};
  };
  /// The same place with respect to the face of the mesh.
  [[nodiscard]] Face_point in_face(const Place& place) const;
  /// The same place with respect to the triangle of the region; its triangle is -1 if the face is not there.
  [[nodiscard]] Place in_triangle(const Face_point& at) const;

  /// Adds a triangle that is in no face of the mesh, without neighbours.
  std::int32_t add(const std::array<std::int32_t, 3>& corners);
  std::int32_t add_point(const Vec& point);
  void join(std::int32_t triangle, int slot, std::int32_t other, int other_slot);

 private:
  /// A triangle, and if it was divided, by a new vertex: part i has that in place of corner i.
  struct Division {
    std::int32_t parent = -1;
    std::int32_t triangle = -1;                    ///< if it is whole
    std::array<std::int32_t, 3> part{-1, -1, -1};  ///< divisions; -1 where the new vertex is on the edge opposite of i
    std::array<double, 3> at{};                    ///< weights of the new vertex
    std::int32_t piece = -1;                       ///< of a face in pieces: which one
  };
  /// A triangle within a face: the weights of its corners there.
  using Piece = std::array<std::array<double, 3>, 3>;

  void put_into_pieces();
  void flip(std::int32_t triangle, int slot);
  [[nodiscard]] std::int32_t flippable(std::int32_t triangle, int slot) const;
  [[nodiscard]] bool is_delaunay(std::int32_t triangle, int slot, std::int32_t other) const;
  [[nodiscard]] Kernel::Point_2 in_plane(std::int32_t triangle, int slot) const;
  [[nodiscard]] std::int32_t start_of(Place& place) const;
  struct Longest {
    int slot;
    double squared_length;
    std::int32_t low, high;
    [[nodiscard]] bool less_than(const Longest& other) const;
  };

  std::int32_t add_face(Face f);
  std::int32_t add_vertex(Vertex v);
  std::int32_t root_of(std::int32_t triangle);
  void record(std::int32_t node, int slot, std::int32_t triangle);
  void replace_beyond(std::int32_t triangle, std::int32_t old, std::int32_t by);
  std::int32_t halve(std::int32_t triangle, int slot, std::int32_t vertex, double share);
  [[nodiscard]] Longest longest_edge(std::int32_t triangle) const;
  void divide_longest(std::int32_t triangle);

  const Blend_mesh& mesh_;
  std::vector<std::int32_t> vertex_of_, triangle_of_;  // by elements of the mesh
  std::vector<Vec> points_;
  std::vector<std::int32_t> triangle_at_;  // one at each vertex
  std::vector<Triangle> triangles_;
  std::vector<Face> faces_;
  std::vector<std::int32_t> leaf_;  // by triangle: its division; -1: a whole face
  std::vector<Division> divisions_;
  std::vector<Piece> pieces_;
  std::map<Face, std::vector<std::int32_t>> pieces_of_;  // of a face in pieces: their divisions
  std::vector<Halfedge> rim_;                            // halfedges of faces beyond the region
};

template <class Visitor>
void Region_mesh::for_star(std::int32_t vertex, const Visitor& visit) const {
  const std::int32_t first = triangle_at_[vertex];
  std::int32_t t = first;
  do {
    const Triangle& triangle = triangles_[t];
    const int slot = slot_of(triangle, vertex);
    visit(t, slot);
    t = triangle.beyond[(slot + 1) % 3];
  } while (t >= 0 && t != first);
  if (t == first) return;
  // Not all round: the rest, from the first on in the other direction.
  t = triangles_[first].beyond[(slot_of(triangles_[first], vertex) + 2) % 3];
  while (t >= 0) {
    const Triangle& triangle = triangles_[t];
    const int slot = slot_of(triangle, vertex);
    visit(t, slot);
    t = triangle.beyond[(slot + 2) % 3];
  }
}

inline int Region_mesh::slot_of(const Triangle& triangle, std::int32_t vertex) {
  return triangle.corner[0] == vertex ? 0 : triangle.corner[1] == vertex ? 1 : 2;
}

}  // namespace cgal_blend

#endif
