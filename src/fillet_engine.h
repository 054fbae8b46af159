// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_FILLET_ENGINE_H
#define CGAL_BLEND_SRC_FILLET_ENGINE_H

#include "edge_finder.h"
#include "fillet_body.h"

#include <array>
#include <optional>
#include <unordered_set>
#include <utility>
#include <vector>

namespace cgal_blend {

/// A blend that has to wait for others at its corners, in terms of the mesh that these leave.
struct Later_blend {
  using Step = Edge_finder::Step;  ///< ends of an edge of that mesh, if it is one still

  double radius = 0;
  std::optional<Radius_law> law;  ///< along what is left of the branch
  std::optional<Profile> profile;
  std::vector<Step> edges;
};

/// A corner with a ball at rest of which only the first branch could be blended: how it is to be finished.
struct Unfinished_corner {
  Point_3 center;
  std::vector<Point_3> chain;   ///< across the first blend where its ball is at rest, from left to right
  std::array<Point_3, 2> ends;  ///< of the rims of the first blend, where the branches left and right of it end now
};

/// Blends of one pass. Of several branches that meet in a corner without a ball at rest, one goes first; the others wait.
struct Fillet_pass {
  Fillet_outcome outcome;
  std::vector<Later_blend> later;
  std::vector<Later_blend::Step> creases;  ///< edges that count as sharp for them, whatever their angle
  std::vector<Unfinished_corner> corners;
  std::vector<std::pair<std::size_t, Edge_blend>> refused;  ///< by the place of their report
  std::vector<Vertex> flat_corners;                         ///< to be tried anew without balls at rest
  bool again = false;  ///< only refusals have been found: the rest is to be blended without them
};

/// What earlier passes have left on the mesh of a body.
struct Earlier_blends {
  std::vector<Edge> creases;  ///< edges that count as sharp
  std::vector<Face> faces;    ///< of the blends
  std::vector<Unfinished_corner> corners;
  std::unordered_set<Vertex> flat_corners = {};  ///< corners whose balls at rest have been tried in vain
};

/// Blends those edges of a body that need not wait; see `fillet_edges`. The faces of the bases that are kept come first
/// in `out`, in their order.
/// \param thorough try every view of rough surfaces, or only the first few
[[nodiscard]] Fillet_pass fillet_pass(const Fillet_body& body, const std::vector<Edge_blend>& blends,
                                      const Earlier_blends& earlier, Blend_mesh& out,
                                      const Fillet_options& options, bool thorough);

}  // namespace cgal_blend

#endif
