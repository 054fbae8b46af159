// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_FILLET_BODY_H
#define CGAL_BLEND_SRC_FILLET_BODY_H

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
};

/// Puts a changed body into `out` in the order of its bases, kept faces first, and checks what is new.
/// \param moved vertices of the body that have another position in `mesh`; their faces keep their places
[[nodiscard]] Fillet_outcome finish_body(const Fillet_body& body, const Blend_mesh& mesh, Blend_mesh& out,
                                         const std::vector<Vertex>& moved = {});

}  // namespace cgal_blend

#endif
