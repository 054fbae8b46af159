// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_SPINE_LOOPS_H
#define CGAL_BLEND_SRC_SPINE_LOOPS_H

#include "rolling_ball.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace cgal_blend {

/// A place where a closed spine crosses itself: the steps from positions `first` and `last` meet, and what lies between
/// them, first + 1 .. last (cyclic), is a loop that the ball cannot run through.
struct Spine_crossing {
  std::size_t first, last;
  Vec point;
};

/// Finds the crossing that cuts off the longest loop, up to some radii; nothing if the spine does not cross itself. Short
/// loops at the cusps of a long one go with it.
[[nodiscard]] std::optional<Spine_crossing> find_crossing(const std::vector<Ball_position>& positions, double radius);

/// Finds a place where a loop is missing already: the spine turns on the spot while a contact jumps over a part of its
/// surface that is curved more sharply than the ball (the offset is inverted there).
[[nodiscard]] std::optional<Spine_crossing> find_trimmed_loop(const std::vector<Ball_position>& positions,
                                                              const std::array<const Base_surface*, 2>& surfaces,
                                                              double radius);

/// Replaces the loop at a crossing: steps back from it on both sides, joins the two ends by a cubic Hermite curve,
/// smooths the joint without shrinking it, and takes the contacts of its positions from the nearest points of the base
/// surfaces. Returns nothing where too little would remain, or the joint has no contacts.
/// Source: Liu et al. (2005), section 4.3; Taubin, A signal processing approach to fair surface design (1995).
[[nodiscard]] std::optional<std::vector<Ball_position>> cut_loop(const std::vector<Ball_position>& positions,
                                                                 const Spine_crossing& crossing,
                                                                 const std::array<const Base_surface*, 2>& surfaces,
                                                                 double radius, double step);

}  // namespace cgal_blend

#endif
