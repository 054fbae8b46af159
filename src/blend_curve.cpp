// SPDX-License-Identifier: GPL-3.0-or-later
#include "blend_curve.h"

#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>

#include <cmath>

namespace cgal_blend {

struct Curve_locator::Tree {
  using Segment = Kernel::Segment_3;
  using Iterator = std::vector<Segment>::const_iterator;
  using Primitive = CGAL::AABB_segment_primitive<Kernel, Iterator>;
  using Aabb_tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

  std::vector<Segment> segments;
  std::vector<double> start;  // arc length; one more than segments
  Aabb_tree tree;
};

Curve_locator::Curve_locator(const std::vector<Vec>& closed_polyline) : tree_(std::make_unique<Tree>()) {
  const std::size_t n = closed_polyline.size();
  tree_->segments.reserve(n);
  tree_->start.assign(1, 0);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec& a = closed_polyline[i];
    const Vec& b = closed_polyline[i + 1 == n ? 0 : i + 1];
    tree_->segments.emplace_back(to_point(a), to_point(b));
    tree_->start.push_back(tree_->start.back() + (b - a).norm());
  }
  tree_->tree.insert(tree_->segments.cbegin(), tree_->segments.cend());
  tree_->tree.build();
}

Curve_locator::~Curve_locator() = default;
Curve_locator::Curve_locator(Curve_locator&&) noexcept = default;

Curve_locator::Nearest Curve_locator::nearest(const Vec& p) const { return nearest(p, 0); }

Curve_locator::Nearest Curve_locator::nearest(const Vec& p, std::size_t hint) const {
  const Point_3 query = to_point(p);
  const auto guess = tree_->segments.cbegin() + static_cast<std::ptrdiff_t>(hint);
  const auto [point, primitive] = tree_->tree.closest_point_and_primitive(query, {guess->source(), guess});
  const auto segment = static_cast<std::size_t>(primitive - tree_->segments.cbegin());
  const double along = std::sqrt(CGAL::squared_distance(primitive->source(), point));
  return {segment, tree_->start[segment] + along, CGAL::squared_distance(query, point)};
}

double Curve_locator::length() const { return tree_->start.back(); }

}  // namespace cgal_blend
