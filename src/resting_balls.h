// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_RESTING_BALLS_H
#define CGAL_BLEND_SRC_RESTING_BALLS_H

#include "corner_balls.h"

#include <array>
#include <cstddef>
#include <map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace cgal_blend {

/// An open branch as the corners at its ends see it.
struct Corner_branch {
  std::array<Halfedge, 2> into;  ///< to the vertex at either end, from within; null if the branch is closed
  std::array<double, 2> radius{};
  std::vector<Vec> points;  ///< along the branch
  std::vector<Edge> edges;
  bool convex = false;
  bool refused = false;
};

/// The balls at rest in the corners of a network of branches.
struct Resting_balls {
  using Branch_end_index = std::pair<std::size_t, int>;  ///< branch, and which of its ends
  struct Corner {
    std::vector<Branch_end_index> branches;  ///< counterclockwise; the sector of the same index is right of each
    Corner_balls balls;
  };

  std::map<Vertex, Corner> corners;    ///< by one of their vertices; only those with balls
  std::map<Vertex, Vertex> corner_of;  ///< vertices at which branches meet, each with the key of its corner
  std::vector<bool> swallowed;         ///< branches of which the balls at their ends leave nothing
  std::map<Vertex, Vec> blocked;       ///< where balls would reach beyond a sharp edge

  /// The corner of a vertex, or null if no ball is at rest there.
  [[nodiscard]] const Corner* at(Vertex v) const;
};

/// Finds the balls at rest wherever branches meet that bend the same way, with one radius and no edge that stays sharp.
/// Where two balls have passed each other on the straight branch between them, its ends make one corner without it.
/// \param flat corners without balls, whatever meets there
[[nodiscard]] Resting_balls find_resting_balls(const Base_surface& surface, const std::vector<Corner_branch>& branches,
                                               const std::unordered_set<Vertex>& flat);

}  // namespace cgal_blend

#endif
