// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_CLI_QUADRIC_PAIR_FILE_H
#define CGAL_BLEND_CLI_QUADRIC_PAIR_FILE_H

#include <cgal_blend/quadric.h>

#include <cstddef>
#include <string>

namespace cgal_blend::cli {

/// Two quadrics and what is wanted of their intersection.
struct Quadric_pair {
  Quadric_3 a, b;
  std::size_t samples = 64;  ///< points per component at least
  double box = 1000;         ///< unbounded arcs end where the largest coordinate is this
};

/// Reads `{"a": [x2, y2, z2, xy, xz, yz, x, y, z, 1], "b": [...], "samples": N, "box": R}`; the last two may be left out.
/// Coefficients are integers, decimals, which stand for the nearest double, or strings "p" and "p/q". Throws `Failure`
/// (input) for anything else.
[[nodiscard]] Quadric_pair read_quadric_pair(const std::string& path);

}  // namespace cgal_blend::cli

#endif
