// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_HOLE_SURROUNDINGS_H
#define CGAL_BLEND_SRC_HOLE_SURROUNDINGS_H

#include <cgal_blend/blend_mesh.h>

#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace cgal_blend {

/// The faces around a hole, as a mesh of their own in which the hole can be filled.
class Hole_surroundings {
 public:
  /// \param hole a border halfedge of it
  Hole_surroundings(const Blend_mesh& mesh, Halfedge hole);

  /// Fills the hole with triangles that go on smoothly from the faces around, about as large as these; returns them, none
  /// if that fails.
  [[nodiscard]] std::vector<Face> fill();

  [[nodiscard]] const Blend_mesh& copy() const { return copy_; }
  /// The vertex of the mesh that one of the copy stands for; null for one of the filling.
  [[nodiscard]] Vertex original(Vertex v) const { return v.idx() < originals_.size() ? originals_[v.idx()] : Vertex(); }

 private:
  Vertex vertex_at(Vertex v);
  std::vector<Vertex> add_faces_at(const std::vector<Vertex>& front);

  const Blend_mesh& mesh_;
  Halfedge hole_;
  Blend_mesh copy_;
  std::unordered_map<Vertex, Vertex> copies_;
  std::vector<Vertex> originals_;
  std::unordered_set<Face> faces_;
  bool failed_ = false;
};

}  // namespace cgal_blend

#endif
