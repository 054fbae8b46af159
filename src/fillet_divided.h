// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_FILLET_DIVIDED_H
#define CGAL_BLEND_SRC_FILLET_DIVIDED_H

#include "base_surface.h"
#include "fillet_stations.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace cgal_blend {

/// A mesh whose edges are divided where parts of curves begin and end, so that these parts are edges of it.
struct Divided_mesh {
  Blend_mesh mesh;                              ///< vertices and faces of the input are the first, in their order
  std::vector<std::uint32_t> origins;           ///< per face: which face of the input it is, or is a part of
  std::vector<Face> divided;                    ///< faces that are only a part, ascending
  std::vector<Edge_blend> blends;               ///< one per part of a curve that is not left sharp
  std::vector<Edge> creases;                    ///< what is left of curves of which a part is blended
  std::vector<std::array<Vertex, 2>> stations;  ///< per part: its ends as far as they are new, else null
  Base_surface::Edge_points edge_points;        ///< of all new vertices
};

/// Divides edges at the ends of parts, and the faces beside them, each from its opposite corner.
[[nodiscard]] Divided_mesh divide_at_stations(const Blend_mesh& mesh, const std::vector<Edge_blend>& blends,
                                              const std::vector<Blend_part>& parts, const Fillet_options& options);

}  // namespace cgal_blend

#endif
