// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_SHARE_PLANES_H
#define CGAL_BLEND_SRC_SHARE_PLANES_H

#include "base_surface.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace cgal_blend {

using Exact_point = CGAL::Exact_predicates_exact_constructions_kernel::Point_3;

/// Coordinates along chosen directions.
struct Frame {
  Eigen::Matrix3d to_frame = Eigen::Matrix3d::Identity(), to_space = Eigen::Matrix3d::Identity();
  Vec origin = Vec::Zero();
};

/// Two bodies with exact coordinates.
struct Shared_planes {
  Frame frame;                                     ///< in which the coordinates are meant
  std::array<std::vector<Exact_point>, 2> points;  ///< by vertex
  std::vector<std::pair<Vertex, Vertex>> common;   ///< vertices of the first and the second body in the same place
};

/// Moves the vertices of two bodies, within rounding (`rounding_fraction`), so that what touches within rounding touches
/// exactly: flat sides that lie in one plane get one exact plane, vertices that lie on a vertex, an edge or a face of the
/// other body get a place there. The flat sides of each body that take part become exactly flat.
/// \returns nothing if the contacts contradict each other
/// The exact coordinates are those in a frame along planes that are shared, where they are short.
[[nodiscard]] std::optional<Shared_planes> share_planes(const Blend_mesh& a, const Blend_mesh& b);

/// Rounds a point with exact coordinates in a frame.
[[nodiscard]] Point_3 rounded(const Exact_point& p, const Frame& frame);

}  // namespace cgal_blend

#endif
