// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_SPINE_GUESS_H
#define CGAL_BLEND_SRC_SPINE_GUESS_H

#include "ball_solver.h"
#include "blend_curve.h"

#include <vector>

namespace cgal_blend {

/// How many guesses there are along a closed curve.
struct Guess_spacing {
  double step;            ///< about so far apart, length units
  std::size_t count = 0;  ///< so many, whatever the step; 0: as the step asks for
  std::array<double, 2> overhang{};  ///< open curves: how far to go on beyond the ends
};

/// First guesses of ball positions along a closed curve, evenly spaced, in the curve's direction: samples of the
/// closed intersection curve of the offset patches that goes round once with the blending curve. Empty if there is none.
[[nodiscard]] std::vector<Ball_guess> guess_from_offsets(const Ball_solver& solver, const Blend_curve& curve,
                                                         const Curve_locator& locator, const Guess_spacing& wanted);

/// The same from the curve alone, which may be open: at each sample the ball in the planar wedge of the two surfaces there.
[[nodiscard]] std::vector<Ball_guess> guess_from_wedges(const Ball_solver& solver, const Blend_curve& curve,
                                                        const Guess_spacing& wanted);

/// The same along the middle of a round: the feet stand as far from the curve as the ball is large, on the surfaces
/// beyond the round.
[[nodiscard]] std::vector<Ball_guess> guess_beyond_round(const Ball_solver& solver, const Blend_curve& curve,
                                                         const Guess_spacing& wanted);

/// How often a closed sequence of points goes round the curve, with sign.
[[nodiscard]] int turns_along(const std::vector<Vec>& points, const Curve_locator& locator);

}  // namespace cgal_blend

#endif
