// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_SURFACE_PATH_H
#define CGAL_BLEND_SRC_SURFACE_PATH_H

#include "base_surface.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace cgal_blend {

/// A vertex of a polyline on a mesh: on a vertex, on an edge, or inside a face of it.
struct Station {
  enum class Kind { vertex, edge, face };
  Kind kind;
  Face face;        ///< kind face: the face; else one of those it lies on
  Halfedge edge;    ///< kind edge: the smaller halfedge of the edge
  Vertex vertex;    ///< kind vertex
  Vec point;
};

/// A closed polyline on a mesh, each step within one closed face.
struct Surface_path {
  std::vector<Station> stations;
  std::vector<std::size_t> station_of;  ///< for each given point its station; non-decreasing
};

/// Joins points of a surface to a closed polyline on it: between consecutive points along the plane section through
/// both that contains the mean normal. Stations nearer than `snap` to a vertex or an edge are moved onto it, so that
/// no sliver is cut off. Returns nothing where a section does not arrive, with the index of the point not reached in `stuck`.
[[nodiscard]] std::optional<Surface_path> closed_path(const Base_surface& surface,
                                                      const std::vector<Surface_point>& points, double snap,
                                                      std::size_t& stuck);

}  // namespace cgal_blend

#endif
