// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_BOOLEAN_H
#define CGAL_BLEND_SRC_BOOLEAN_H

#include "cell_map.h"

#include <cgal_blend/boolean_operation.h>
#include <cgal_blend/status.h>

#include <optional>
#include <vector>

namespace cgal_blend {

/// The sharp result of a boolean with all that blending its curves needs to know about the operands.
struct Boolean_result {
  Diagnosis diagnosis;
  Blend_mesh mesh;
  Cell_map cells;
  std::vector<Edge> curves;  ///< edges where the operands' surfaces cross or touch at an angle
  bool coplanar = false;     ///< some faces of the operands lie in a common plane and overlap
  bool contact = false;      ///< the surfaces have a point in common
};

/// Computes a boolean by CGAL's corefinement. The operands are closed, outward oriented, without self-intersections.
/// Geometric failures are named in the diagnosis; the result's validity is for the caller to check.
[[nodiscard]] Boolean_result compute_boolean(const Blend_mesh& a, const Blend_mesh& b, Boolean_operation operation);

/// Computes a boolean of bodies whose faces are coplanar but for rounding, by exact arithmetic on bodies that touch exactly
/// (`share_planes`). Vertices of `b` within rounding of one of `a` are moved there; all others keep their places.
/// \returns nothing if the bodies do not allow of that
[[nodiscard]] std::optional<Boolean_result> compute_boolean_on_shared_planes(const Blend_mesh& a, Blend_mesh& b,
                                                                             Boolean_operation operation);

}  // namespace cgal_blend

#endif
