// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_SLAB_TESSELLATION_H
#define CGAL_BLEND_SRC_SLAB_TESSELLATION_H

#include "hermite_transition.h"

#include <cgal_blend/status.h>

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace cgal_blend {

struct Slab_options {
  double edge = 0;          ///< edge length of the facets, length units; 0: that of the rings, graded between the sides
  double grading = 1;       ///< facets grow away from the rings up to this many times their edges, >= 1
  double least_angle = 20;  ///< what no facet away from the rings should fall below, degrees in [0, 30]
  std::function<bool(double)> progress;  ///< as in `Fillet_options`
};

/// A tessellated transition, in the common frame of the sides.
struct Slab_tessellation {
  Diagnosis diagnosis;  ///< `openings_not_joined` (with the place), `blend_folds`, `cancelled`
  /// First the vertices of the lower rings, ring by ring in their order at z = 0, then those of the upper ones at
  /// z = height, then new ones.
  std::vector<Point_3> points;
  /// Oriented so that normals point to where Psi is positive. Every edge of a ring is the edge of exactly one triangle,
  /// every other edge of two.
  std::vector<std::array<std::size_t, 3>> triangles;
};

/// Tessellates Psi = 0 between the planes: the rings are kept vertex for vertex, neither divided nor moved.
[[nodiscard]] Slab_tessellation tessellate_slab(const Hermite_transition& psi, const Slab_options& options = {});

}  // namespace cgal_blend

#endif
