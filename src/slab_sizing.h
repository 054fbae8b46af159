// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_SLAB_SIZING_H
#define CGAL_BLEND_SRC_SLAB_SIZING_H

#include "segment_tree.h"
#include "slab_tessellation.h"

#include <array>
#include <utility>
#include <vector>

namespace cgal_blend {

/// The edge length wanted at a point of the slab: that of the rings' sides on them, growing with the distance from them at a
/// bounded rate, so that a short side makes its surroundings fine and not the whole. Beside a side it is no less than half
/// of it, whatever is near: sides are not divided, and small facets there would be slivers.
class Slab_sizing {
 public:
  /// \param growth length per length away from short sides, > 0
  /// \param decline the same away from long ones
  /// \param gaps no more than about so many half widths of gaps and walls between the rings either, at all heights
  ///        there; 0: whatever their width
  Slab_sizing(const Hermite_transition& psi, const Slab_options& options, double growth, double decline, double gaps);

  [[nodiscard]] double operator()(const Point_3& p) const;
  /// Halves what is wanted at a place; it grows from there as it does from short sides.
  void halve_at(const Point_3& p);
  void forget_halvings() { finer_.clear(); }
  /// The same in the plane of a side, of its rings alone.
  [[nodiscard]] double at_plane(std::size_t side, const Point_2& p) const;
  [[nodiscard]] double smallest() const { return smallest_; }  ///< a bound
  [[nodiscard]] double largest() const { return largest_; }    ///< where no side is longer

 private:
  [[nodiscard]] double gap(const Point_2& p, double size) const;

  std::vector<std::pair<Point_3, double>> finer_;
  std::vector<Segment_tree> gaps_;     ///< bounds from above for all heights
  std::array<Segment_tree, 2> upper_;  ///< bounds from above
  std::array<Segment_tree, 2> lower_;  ///< bounds from below, negated
  double growth_, decline_, height_, smallest_, largest_;
};

}  // namespace cgal_blend

#endif
