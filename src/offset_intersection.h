// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_OFFSET_INTERSECTION_H
#define CGAL_BLEND_SRC_OFFSET_INTERSECTION_H

#include "base_surface.h"

#include <array>
#include <vector>

namespace cgal_blend {

/// A base patch: faces of a base surface, and the signed distance of its offset along the outward normals.
struct Base_patch {
  const Base_surface* surface = nullptr;
  std::vector<Face> faces;
  double distance = 0;
};

/// A point where the two offset patches meet, with its foot point on each base patch.
struct Offset_node {
  Vec point;
  std::array<Surface_point, 2> foot;
};

struct Offset_curve {
  std::vector<Offset_node> nodes;
  bool closed = false;
};

/// Intersects the offsets of two base patches (vertices moved along corner normals, connectivity kept), by CGAL's
/// corefinement with exact predicates; its visitor tells the face and the edge of each point. Curves that offsets
/// crossing themselves break up come out open. Deterministic.
/// Source: Liu et al. (2005), section 3.
[[nodiscard]] std::vector<Offset_curve> intersect_offsets(const Base_patch& first, const Base_patch& second);

}  // namespace cgal_blend

#endif
