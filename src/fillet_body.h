// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_FILLET_BODY_H
#define CGAL_BLEND_SRC_FILLET_BODY_H

#include "base_surface.h"
#include "cell_map.h"

#include <cgal_blend/fillet.h>

#include <array>
#include <vector>

namespace cgal_blend {

/// A mesh to be blended and the surfaces that it is made of: itself, or the operands of the boolean that it came from.
struct Fillet_body {
  const Blend_mesh* mesh = nullptr;
  Cell_map cells;
  std::array<const Blend_mesh*, 2> base{};
  std::array<bool, 2> reversed{};  ///< the base's faces point into the solid
  bool own_surface = true;         ///< the curves are edges of the base, which is smooth on either side only
  std::vector<Edge> creases;       ///< edges that count as sharp, besides those that are to be blended
  Base_surface::Edge_points edge_points;  ///< vertices where edges of the surface were divided
};

/// What became of a body, besides faces that are gone.
struct Body_changes {
  std::vector<Cell_map::Cell> remnant_cells;  ///< of the first faces beyond those of the body; others belong to no cell
  std::vector<Vertex> moved;                  ///< vertices of the body that have another position
};

/// Puts a changed body into `out` in the order of its bases, kept faces first, and checks what is new. Faces of moved
/// vertices keep their places, but count as new.
[[nodiscard]] Fillet_outcome finish_body(const Fillet_body& body, const Blend_mesh& mesh, const Body_changes& changes,
                                         Blend_mesh& out);

}  // namespace cgal_blend

#endif
