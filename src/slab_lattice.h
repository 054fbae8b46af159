// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_SLAB_LATTICE_H
#define CGAL_BLEND_SRC_SLAB_LATTICE_H

#include "slab_sizing.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace cgal_blend {

/// A piece of the surface between the planes: an oriented 2-manifold whose borders lie a little inside the slab.
struct Slab_contour {
  enum class Border : unsigned char { none, lower, upper };

  std::vector<Point_3> points;
  std::vector<Border> border;  ///< per point: the end of the lattice that it lies on
  std::vector<std::array<std::size_t, 3>> triangles;
  std::optional<Point_3> escape;  ///< where the surface left the lattice sideways
  std::size_t cells = 0;          ///< that were marched through
  bool exhausted = false;         ///< it took more cells than it may; `escape` says where
};

/// Growth of cells with the distance from finer ones, per length: below what keeps the octree balanced, 0.19.
inline constexpr double cell_growth = 0.12;

struct Contour_options {
  double fineness = 1;  ///< cells are this many times smaller than the sizing asks for, >= 1
  double gap = 0.3;     ///< distance of the lattice from the planes, in edges wanted there, in (0, 1)
  std::size_t most_cells = 60'000;
  bool topology_only = false;  ///< vertices need not lie on the surface, only between points of both signs
};

/// Follows Psi = 0 from the rings through an octree of the slab by marching tetrahedra: parts that no ring leads to are
/// never met. Cells that share a face or an edge divide it alike, so that the surface is 2-manifold whatever Psi is.
/// \param cells sizes that grow and decline by no more than `cell_growth`; cells are about twice as wide
[[nodiscard]] Slab_contour contour_slab(const Hermite_transition& psi, const Slab_sizing& cells,
                                        const Contour_options& options);

}  // namespace cgal_blend

#endif
