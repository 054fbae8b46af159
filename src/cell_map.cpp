// SPDX-License-Identifier: GPL-3.0-or-later
#include "cell_map.h"

#include <utility>

namespace cgal_blend {

Cell_map::Cell_map(std::array<std::size_t, 2> faces, std::vector<Cell> cell_of_face,
                   std::array<std::vector<Vertex>, 2> vertex_of)
    : identity_(false), first_faces_(faces[0]), cell_of_face_(std::move(cell_of_face)),
      start_(faces[0] + faces[1] + 1, 0), members_(cell_of_face_.size()), vertex_of_(std::move(vertex_of)) {
  for (const Cell c : cell_of_face_) ++start_[c + 1];
  for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
  std::vector<std::uint32_t> fill(start_.begin(), start_.end() - 1);
  for (std::size_t f = 0; f < cell_of_face_.size(); ++f) members_[fill[cell_of_face_[f]]++] = Face(f);
  for (const auto& vertices : vertex_of_)
    for (const Vertex v : vertices) {
      if (v == Blend_mesh::null_vertex()) continue;
      if (original_.size() <= v.idx()) original_.resize(v.idx() + 1, false);
      original_[v.idx()] = true;
    }
}

Cell_map::Cell Cell_map::cell(int operand, Face base) const {
  return static_cast<Cell>(base.idx() + (operand == 1 && !identity_ ? first_faces_ : 0));
}

std::vector<Face> Cell_map::faces(Cell cell) const {
  if (identity_) return {Face(cell)};
  return {members_.begin() + start_[cell], members_.begin() + start_[cell + 1]};
}

int Cell_map::operand(Face face) const { return !identity_ && cell_of_face_[face.idx()] >= first_faces_ ? 1 : 0; }

Face Cell_map::base_face(Face face) const {
  return identity_ ? face : Face(static_cast<std::uint32_t>(cell(face) - (operand(face) == 1 ? first_faces_ : 0)));
}

bool Cell_map::whole(Face face, const Blend_mesh& mesh) const {
  if (identity_) return true;
  const Cell c = cell(face);
  if (start_[c + 1] - start_[c] != 1) return false;
  for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(face)))
    if (!is_original(v)) return false;
  return true;
}

}  // namespace cgal_blend
