// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_JOIN_ROWS_H
#define CGAL_BLEND_SRC_JOIN_ROWS_H

#include <cgal_blend/trimmed_surface.h>

#include <cstddef>
#include <vector>

namespace cgal_blend {

/// Points of a soup along a curve, at ascending parameters from 0; to 1 if open, below 1 if closed.
struct Point_line {
  std::vector<std::size_t> vertices;
  std::vector<double> parameters;
};

/// Adds the triangles between two lines side by side, which may have different parameters: always the shorter diagonal,
/// as long as parameters do not run apart. A line of one vertex is a point.
void join_rows(const Point_line& a, const Point_line& b, bool closed, int part, Triangle_soup& soup);

/// Returns the line of a curve that may run the other way or begin elsewhere; parameters ascend from the vertex of the
/// least one.
[[nodiscard]] Point_line ascending(const Trim_curve& curve);

}  // namespace cgal_blend

#endif
