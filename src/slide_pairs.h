// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_SLIDE_PAIRS_H
#define CGAL_BLEND_SRC_SLIDE_PAIRS_H

#include <cgal_blend/blend_mesh.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace cgal_blend {

/// Pairs of places on two curves, as strictly increasing functions of a common parameter; all three from 0 to 1.
struct Pairing {
  std::vector<double> s, first, second;
};

/// Returns pairs of equal fractions.
[[nodiscard]] Pairing equal_pairs(std::size_t spans);

/// Slides pairs along both curves so that the sum of squared distances is least, at relative speeds from 1/3 to 3, and
/// smooths what comes out. The first and last pair stay.
/// \param first points of the first curve at equal fractions; without the last one if `closed`
/// \param second the second curve at a fraction
/// Source: dynamic time warping, Sakoe, Chiba, IEEE Trans. ASSP 26 (1978), with slopes bounded by P = 1/2 of its table 1
/// extended to steps of three.
[[nodiscard]] Pairing slid_pairs(const std::vector<Point_3>& first,
                                 const std::function<Point_3(double fraction)>& second, bool closed);

}  // namespace cgal_blend

#endif
