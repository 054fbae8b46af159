// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_RBF_CONSTRAINTS_H
#define CGAL_BLEND_SRC_RBF_CONSTRAINTS_H

#include <cgal_blend/implicit_opening.h>

#include <cstddef>
#include <vector>

namespace cgal_blend {

/// What a function of an opening has to attain. Three in a row for every vertex of the rings: at the vertex (0), inside
/// (-rho) and outside (+rho) of it, on the bisector of the ring's normals.
struct Rbf_constraint {
  Point_2 point;
  double value;
};

/// Offset points that would come too near to another ring, or to another part of their own, are moved in until the
/// place at twice their distance is clear too; their value shrinks with their distance.
[[nodiscard]] std::vector<Rbf_constraint> rbf_constraints(const std::vector<Ring>& rings, double rho);

[[nodiscard]] double mean_edge(const std::vector<Ring>& rings);

}  // namespace cgal_blend

#endif
