// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_CURVE_RING_H
#define CGAL_BLEND_SRC_CURVE_RING_H

#include "base_surface.h"

#include <array>
#include <cstddef>
#include <unordered_set>
#include <vector>

namespace cgal_blend {

/// The faces around a closed curve of mesh edges: an annulus with inner vertices, and a border on either side. Side 0 is
/// left of the curve, side 1 right of it.
class Curve_ring {
 public:
  explicit Curve_ring(const Blend_mesh& mesh);

  /// Collects the vertices among `between` that hang together with the curve, and all faces at them.
  /// \return false if these form no annulus around the curve
  bool collect(const std::vector<Vertex>& curve, const std::unordered_set<Vertex>& between);

  [[nodiscard]] const std::vector<Vertex>& inner() const { return inner_; }
  [[nodiscard]] const std::vector<int>& inner_index() const { return inner_index_; }  ///< by vertex; -1: not inner
  [[nodiscard]] const std::vector<Face>& faces() const { return faces_; }             ///< in order

  /// Halfedges of the ring along a border, in their own direction.
  [[nodiscard]] const std::vector<Halfedge>& border(int side) const { return borders_[side]; }

  [[nodiscard]] bool is_inner(Vertex v) const { return inner_index_[v.idx()] >= 0; }
  [[nodiscard]] bool inside(Halfedge h) const { return in_ring(mesh_.face(h)); }
  [[nodiscard]] bool on_border(Halfedge h) const { return inside(h) && !inside(mesh_.opposite(h)); }
  [[nodiscard]] double length(Halfedge h) const;

  /// The shortest path of halfedges over inner vertices, from the fan of faces behind one border halfedge to that behind
  /// the other; each edge costs its length and `hop` more, so that three vertices of one face are never on it. Empty if
  /// there is none.
  [[nodiscard]] std::vector<Halfedge> shortest_path(const std::array<Halfedge, 2>& ends, double hop) const;

  /// Calls for every halfedge inside the ring that ends where a border halfedge does, in the same fan.
  template <class Function>
  void for_fan(Halfedge border, const Function& call) const {
    for (Halfedge h = border; inside(mesh_.opposite(mesh_.next(h)));) {
      h = mesh_.opposite(mesh_.next(h));
      call(h);
    }
  }

 private:
  bool collect_inner(const std::vector<Vertex>& curve, const std::unordered_set<Vertex>& between);
  bool collect_faces(const std::vector<Vertex>& curve);
  bool collect_borders();
  void add_inner(Vertex v);
  [[nodiscard]] int side(Face f) const { return side_[f.idx()]; }
  [[nodiscard]] bool in_ring(Face f) const { return side(f) >= 0; }
  [[nodiscard]] bool is_enclosed(Vertex v) const;
  [[nodiscard]] bool touches_inner(Face f) const;
  [[nodiscard]] Halfedge next_on_border(Halfedge h) const;

  const Blend_mesh& mesh_;
  std::vector<Vertex> inner_;
  std::vector<int> inner_index_;
  std::vector<Face> faces_;
  std::vector<signed char> side_;  // by face of the mesh: side of the curve, or -1 outside the ring
  std::array<std::vector<Halfedge>, 2> borders_;
};

}  // namespace cgal_blend

#endif
