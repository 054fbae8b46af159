// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_BRIDGE_UNION_H
#define CGAL_BLEND_SRC_BRIDGE_UNION_H

#include "bridge_assembly.h"

#include <unordered_set>
#include <vector>

namespace cgal_blend {

/// Two bodies united, with the curves in which they cross.
struct Bridge_union {
  Diagnosis diagnosis;
  Blend_mesh mesh;
  std::vector<std::uint32_t> origins;  ///< per face: that it is a part of; those of the second body count on
  std::vector<bool> whole;             ///< per face: it is all of its origin
  std::vector<bool> of_second;         ///< per face: it is of the second body
  std::unordered_set<Edge> curves;
  std::vector<std::vector<Halfedge>>
      loops;  ///< the curves, with the first body on their left, from the vertex of least
              ///< index on
};

/// Unites two bodies and chains the curves; edges of almost no length are collapsed, so that there are coordinates.
/// Refuses what booleans refuse, `operands_disjoint`, `operands_touch`, and curves that meet (`corner`).
[[nodiscard]] Bridge_union unite(const Blend_mesh& a, const Blend_mesh& b);

}  // namespace cgal_blend

#endif
