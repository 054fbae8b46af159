// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_SEGMENT_TREE_H
#define CGAL_BLEND_SRC_SEGMENT_TREE_H

#include <cgal_blend/implicit_opening.h>

#include <array>
#include <cstddef>
#include <vector>

namespace cgal_blend {

/// A segment of the plane with the value that its cone starts from.
struct Weighted_segment {
  Point_2 source, target;
  double weight = 0;  ///< length units
};

/// The lower envelope of cones over segments, min_s (weight_s + slope * |p - s|), by a tree of boxes over runs of
/// consecutive segments: exact but for rounding wherever p is. With weights 0 and slope 1 it is the distance.
class Segment_tree {
 public:
  explicit Segment_tree(const std::vector<Weighted_segment>& segments, double slope = 1);

  /// Infinite without segments.
  [[nodiscard]] double operator()(const Point_2& p) const;
  [[nodiscard]] double least_weight() const { return least_weight_; }
  /// The index of a segment that attains the value.
  [[nodiscard]] std::size_t nearest(const Point_2& p) const;

 private:
  struct Box {
    double xmin, ymin, xmax, ymax, weight;
  };
  struct Segment {
    double x, y, dx, dy, inverse_length2, weight;
  };
  struct Best {
    double value;
    std::size_t segment;
  };

  void build(std::size_t node, std::size_t first, std::size_t last);
  void query(std::size_t node, std::size_t first, std::size_t last, const Point_2& p, Best& best) const;
  [[nodiscard]] double squared_distance(std::size_t node, const Point_2& p) const;
  [[nodiscard]] bool may_be_less(double weight, double squared, double value) const;

  std::vector<Segment> segments_;
  std::vector<Box> boxes_;  ///< a heap: the children of node n are 2n + 1 and 2n + 2
  double slope_, least_weight_;
};

/// The sides of rings, ring by ring, with weight 0.
[[nodiscard]] std::vector<Weighted_segment> sides_of(const std::vector<Ring>& rings);

/// Even-odd test: true where an odd number of rings surround a point, by exact predicates.
class Even_odd_test {
 public:
  explicit Even_odd_test(const std::vector<Ring>& rings);
  [[nodiscard]] bool operator()(const Point_2& p) const;

 private:
  [[nodiscard]] std::size_t row(double y) const;

  std::vector<std::array<Point_2, 2>> sides_;   ///< the lower end first
  std::vector<std::vector<std::size_t>> rows_;  ///< the sides that reach into each row of the rings' height
  double ymin_ = 0, ymax_ = 0;
};

}  // namespace cgal_blend

#endif
