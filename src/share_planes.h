// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_SHARE_PLANES_H
#define CGAL_BLEND_SRC_SHARE_PLANES_H

#include <cgal_blend/blend_mesh.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace cgal_blend {

using Exact_point = CGAL::Exact_predicates_exact_constructions_kernel::Point_3;

/// Two bodies with exact coordinates.
struct Shared_planes {
  std::array<std::vector<Exact_point>, 2> points;  ///< by vertex
  std::vector<std::pair<Vertex, Vertex>> common;   ///< vertices of the first and the second body in the same place
};

/// Moves the vertices of two bodies, within rounding (`rounding_fraction`), so that what touches within rounding touches
/// exactly: flat sides that lie in one plane get one exact plane, vertices that lie on a vertex, an edge or a face of the
/// other body get a place there. The flat sides of each body that take part become exactly flat.
/// \returns nothing if the contacts contradict each other
[[nodiscard]] std::optional<Shared_planes> share_planes(const Blend_mesh& a, const Blend_mesh& b);

}  // namespace cgal_blend

#endif
