// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_RING_CLEARANCE_H
#define CGAL_BLEND_SRC_RING_CLEARANCE_H

#include "segment_tree.h"

#include <vector>

namespace cgal_blend {

/// How far one may go from a ring before other rings, or other parts of its own, are near.
class Ring_clearance {
 public:
  explicit Ring_clearance(const std::vector<Ring>& rings) : distance_(sides_of(rings)), inside_(rings) {}

  /// The first of reach, reach / 2, reach / 4, .. at which the place, and the one at twice the distance, are on the side
  /// asked for, and the latter is not much nearer to the rings than the former is: in a gap of width g between parallel
  /// walls at most g / 3.6, and at least half of that.
  /// \param p a point of a ring
  /// \param direction unit, across the ring at p
  /// \param inside the side of the ring that the direction points to
  [[nodiscard]] double operator()(const Point_2& p, const Kernel::Vector_2& direction, bool inside, double reach) const;

  [[nodiscard]] bool inside(const Point_2& p) const { return inside_(p); }

 private:
  [[nodiscard]] bool clear(const Point_2& p, const Kernel::Vector_2& direction, bool inside, double d) const;

  Segment_tree distance_;
  Even_odd_test inside_;
};

/// True if the interior of the opening is to the left of a ring as it runs.
[[nodiscard]] bool interior_on_left(const std::vector<Ring>& rings, std::size_t ring);

}  // namespace cgal_blend

#endif
