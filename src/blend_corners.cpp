// SPDX-License-Identifier: GPL-3.0-or-later
#include "blend_corners.h"

namespace cgal_blend {

namespace {

/// The spine that comes into a ball between two of its sectors, and which of its ends that is.
std::pair<std::size_t, int> spine_into(const Corner_balls& balls, std::size_t ball, std::size_t left,
                                       std::size_t right) {
  for (std::size_t k = 0; k < balls.spines.size(); ++k) {
    const Corner_balls::Spine& spine = balls.spines[k];
    if (spine.ball[1] == ball && spine.sector[0] == left && spine.sector[1] == right) return {k, 1};
    if (spine.ball[0] == ball && spine.sector[0] == right && spine.sector[1] == left) return {k, 0};
  }
  CGAL_assertion(false);
  return {};
}

}  // namespace

std::vector<Blend_corner> blend_corners(const Corner_balls& balls,
                                        const std::vector<std::pair<std::size_t, int>>& branches,
                                        std::size_t first_spine) {
  std::vector<Blend_corner> corners;
  for (std::size_t b = 0; b < balls.balls.size(); ++b) {
    const std::vector<std::size_t>& sectors = balls.balls[b].sectors;
    Blend_corner& corner = corners.emplace_back();
    corner.ball = balls.balls[b].rest;
    for (std::size_t t = 0; t < sectors.size(); ++t) {
      const std::size_t left = sectors[(t + sectors.size() - 1) % sectors.size()], right = sectors[t];
      if (right == (left + 1) % branches.size()) {
        corner.branches.push_back(branches[right]);
      } else {
        const auto [spine, end] = spine_into(balls, b, left, right);
        corner.branches.emplace_back(first_spine + spine, end);
      }
    }
  }
  return corners;
}

}  // namespace cgal_blend
