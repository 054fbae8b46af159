// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_OPEN_BRANCH_H
#define CGAL_BLEND_SRC_OPEN_BRANCH_H

#include "blend_corners.h"
#include "blend_strip.h"
#include "strip_end.h"

#include <array>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace cgal_blend {

/// An open branch on its way to becoming a strip.
struct Open_branch {
  std::unique_ptr<Base_surface> surface;  ///< of both sides, extended beyond the ends
  std::array<Branch_end, 2> ends;
  bool between_balls = false;  ///< of one corner: it has no edges
  std::array<const Blend_corner*, 2> corner{};
  std::array<std::size_t, 2> place{};           ///< among the branches of the corner
  std::array<const Blend_corner*, 2> through{};  ///< corners to be finished in a later pass: the ball at rest is on the way
  std::array<std::size_t, 2> passed{};           ///< ball position at which it is; none if it is `size()`
  std::vector<double> rows;
  std::array<Strip_end, 2> strip_ends;
};

/// Rolls the ball along an open branch to its ends, and finds how they are finished.
/// \param branch with its surface and the views of its ends
/// \param curve of a branch between two balls of one corner: the segment between their centres
struct Open_roll {
  Diagnosis diagnosis;
  std::vector<Ball_position> positions;
  std::optional<Virtual_surface> surface;
  std::array<Rim, 2> rims;
};
[[nodiscard]] Open_roll roll_open(Open_branch& branch, Blend_curve& curve, const Radius_law& law, const Profile& profile,
                                  double chord_tolerance, const Sampling& steps, double snap);

/// What the end of a strip adds to the mesh: curves to cut along, and triangles.
struct End_assembly {
  std::vector<Rim> cuts;
  std::set<std::pair<Vertex, Vertex>> filled;  ///< see `trim`
  Strip_border border;
  std::vector<Vertex> fill;                    ///< loop to be filled, if any
  Vec fill_normal = Vec::Zero();
};

/// Adds the vertices at one end of a strip, whose rims have theirs.
/// \param corner that the strip ends in; takes the border
[[nodiscard]] Diagnosis assemble_end(Blend_mesh& mesh, const Cell_map& cells, const Open_branch& branch, int end,
                                     bool convex, const std::array<const Rim*, 2>& rims, double snap,
                                     End_assembly& out);

}  // namespace cgal_blend

#endif
