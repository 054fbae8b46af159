// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_FILLET_ENGINE_H
#define CGAL_BLEND_SRC_FILLET_ENGINE_H

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
  std::array<bool, 2> reversed{};           ///< the base's faces point into the solid
  bool own_surface = true;                  ///< the curves are edges of the base, which is smooth on either side only
};

/// Blends edges of a body; see `fillet_edges`. The faces of the bases that are kept come first in `out`, in their order.
[[nodiscard]] Fillet_outcome fillet_body(const Fillet_body& body, const std::vector<Edge_blend>& blends, Blend_mesh& out,
                                         const Fillet_options& options);

/// Puts a body into `out` as it is, faces in the same order as `fillet_body` has them, and checks it.
/// \param remnant_cells of the first faces that `mesh` has beyond those of the body; all others belong to no cell
[[nodiscard]] Fillet_outcome finish_body(const Fillet_body& body, const Blend_mesh& mesh,
                                         const std::vector<Cell_map::Cell>& remnant_cells, Blend_mesh& out);

}  // namespace cgal_blend

#endif
