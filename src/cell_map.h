// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_CELL_MAP_H
#define CGAL_BLEND_SRC_CELL_MAP_H

#include <cgal_blend/blend_mesh.h>

#include <array>
#include <cstdint>
#include <vector>

namespace cgal_blend {

/// Which face of which base surface each face of the mesh at hand is a part of. The parts of one base face form a
/// *cell*: they lie in one plane and are retriangulated together. For a mesh that is its own base surface, each face is
/// a cell; for the result of a boolean, cells are the remnants of the operands' faces.
class Cell_map {
 public:
  using Cell = std::uint32_t;

  /// A mesh that is its own base surface.
  Cell_map() = default;

  /// The result of a boolean of meshes with these numbers of faces. `cell_of_face[f]` counts the faces of the second
  /// operand after those of the first; `vertex_of[k][v]` is what became of vertex v of operand k, if it is there still.
  Cell_map(std::array<std::size_t, 2> faces, std::vector<Cell> cell_of_face,
           std::array<std::vector<Vertex>, 2> vertex_of);

  [[nodiscard]] Cell cell(Face face) const { return identity_ ? face.idx() : cell_of_face_[face.idx()]; }
  [[nodiscard]] Cell cell(int operand, Face base) const;
  [[nodiscard]] std::vector<Face> faces(Cell cell) const;
  [[nodiscard]] Vertex vertex(int operand, Vertex base) const { return identity_ ? base : vertex_of_[operand][base.idx()]; }
  [[nodiscard]] int operand(Face face) const;
  [[nodiscard]] Face base_face(Face face) const;

  /// True if the vertex is a vertex of a base surface.
  [[nodiscard]] bool is_original(Vertex v) const { return identity_ || (v.idx() < original_.size() && original_[v.idx()]); }

  /// True if the face is a whole face of its base surface, with the same vertices.
  [[nodiscard]] bool whole(Face face, const Blend_mesh& mesh) const;

 private:
  bool identity_ = true;
  std::size_t first_faces_ = 0;
  std::vector<Cell> cell_of_face_;
  std::vector<std::uint32_t> start_;  // faces of cell c are members_[start_[c]] .. members_[start_[c + 1]]
  std::vector<Face> members_;
  std::array<std::vector<Vertex>, 2> vertex_of_;
  std::vector<bool> original_;        // per vertex: it is a vertex of an operand
};

}  // namespace cgal_blend

#endif
