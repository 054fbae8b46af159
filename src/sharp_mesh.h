// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_SHARP_MESH_H
#define CGAL_BLEND_SRC_SHARP_MESH_H

#include "fillet_body.h"

#include <unordered_map>
#include <vector>

namespace cgal_blend {

/// A body as it is written without blends: the result of a boolean loses its edges of almost no length.
class Sharp_mesh {
 public:
  explicit Sharp_mesh(const Fillet_body& body);

  /// The vertices of a closed chain of halfedges of the body, as far as they are left.
  [[nodiscard]] std::vector<Vertex> curve(const Blend_mesh& body_mesh, const std::vector<Halfedge>& chain) const;

  Blend_mesh mesh;  ///< same indices as the body's, some marked as removed

 private:
  std::unordered_map<Vertex, Vertex> merged_;
};

}  // namespace cgal_blend

#endif
