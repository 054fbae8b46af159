// SPDX-License-Identifier: GPL-3.0-or-later
#include "segment_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cgal_blend {

namespace {

constexpr std::size_t run = 4;  // segments of a leaf

}  // namespace

Segment_tree::Segment_tree(const std::vector<Weighted_segment>& segments, double slope)
    : slope_(slope), least_weight_(std::numeric_limits<double>::infinity()) {
  segments_.reserve(segments.size());
  for (const auto& [a, b, weight] : segments) {
    const double dx = b.x() - a.x(), dy = b.y() - a.y(), length2 = dx * dx + dy * dy;
    segments_.push_back({a.x(), a.y(), dx, dy, length2 > 0 ? 1 / length2 : 0, weight});
    least_weight_ = std::min(least_weight_, weight);
  }
  if (!segments_.empty()) build(0, 0, segments_.size());
}

void Segment_tree::build(std::size_t node, std::size_t first, std::size_t last) {
  const double infinity = std::numeric_limits<double>::infinity();
  Box box{infinity, infinity, -infinity, -infinity, infinity};
  for (std::size_t i = first; i < last; ++i) {
    const Segment& s = segments_[i];
    // Both ends, rounded as in the distance below.
    box = {std::min({box.xmin, s.x, s.x + s.dx}), std::min({box.ymin, s.y, s.y + s.dy}),
           std::max({box.xmax, s.x, s.x + s.dx}), std::max({box.ymax, s.y, s.y + s.dy}),
           std::min(box.weight, s.weight)};
  }
  if (node >= boxes_.size()) boxes_.resize(2 * node + 1);
  boxes_[node] = box;
  if (last - first <= run) return;
  const std::size_t middle = first + (last - first) / 2;
  build(2 * node + 1, first, middle);
  build(2 * node + 2, middle, last);
}

double Segment_tree::squared_distance(std::size_t node, const Point_2& p) const {
  const Box& box = boxes_[node];
  const double dx = std::max({box.xmin - p.x(), 0.0, p.x() - box.xmax});
  const double dy = std::max({box.ymin - p.y(), 0.0, p.y() - box.ymax});
  return dx * dx + dy * dy;
}

/// weight + slope * distance < value, without a root.
bool Segment_tree::may_be_less(double weight, double squared, double value) const {
  const double rest = value - weight;
  return rest > 0 && slope_ * slope_ * squared < rest * rest;
}

void Segment_tree::query(std::size_t node, std::size_t first, std::size_t last, const Point_2& p, Best& best) const {
  if (last - first <= run) {
    for (std::size_t i = first; i < last; ++i) {
      const Segment& s = segments_[i];
      const double px = p.x() - s.x, py = p.y() - s.y;
      const double t = std::clamp((px * s.dx + py * s.dy) * s.inverse_length2, 0.0, 1.0);
      const double qx = px - t * s.dx, qy = py - t * s.dy, squared = qx * qx + qy * qy;
      if (may_be_less(s.weight, squared, best.value)) best = {s.weight + slope_ * std::sqrt(squared), i};
    }
    return;
  }
  const std::size_t middle = first + (last - first) / 2, left = 2 * node + 1, right = 2 * node + 2;
  const double of_left = squared_distance(left, p), of_right = squared_distance(right, p);
  const auto visit = [&](std::size_t child, double squared, std::size_t from, std::size_t to) {
    if (may_be_less(boxes_[child].weight, squared, best.value)) query(child, from, to, p, best);
  };
  if (of_left <= of_right) visit(left, of_left, first, middle);
  visit(right, of_right, middle, last);
  if (of_left > of_right) visit(left, of_left, first, middle);
}

double Segment_tree::operator()(const Point_2& p) const {
  Best best{std::numeric_limits<double>::infinity(), 0};
  query(0, 0, segments_.size(), p, best);
  return best.value;
}

std::size_t Segment_tree::nearest(const Point_2& p) const {
  Best best{std::numeric_limits<double>::infinity(), 0};
  query(0, 0, segments_.size(), p, best);
  return best.segment;
}

std::vector<Weighted_segment> sides_of(const std::vector<Ring>& rings) {
  std::vector<Weighted_segment> sides;
  for (const Ring& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) sides.push_back({ring[i], ring[(i + 1) % ring.size()], 0});
  return sides;
}

Even_odd_test::Even_odd_test(const std::vector<Ring>& rings) {
  const double infinity = std::numeric_limits<double>::infinity();
  ymin_ = infinity;
  ymax_ = -infinity;
  for (const auto& [a, b, weight] : sides_of(rings)) {
    sides_.push_back(a.y() <= b.y() ? std::array{a, b} : std::array{b, a});
    ymin_ = std::min(ymin_, sides_.back()[0].y());
    ymax_ = std::max(ymax_, sides_.back()[1].y());
  }
  rows_.resize(std::max<std::size_t>(1, sides_.size()));
  for (std::size_t i = 0; i < sides_.size(); ++i)
    for (std::size_t r = row(sides_[i][0].y()); r <= row(sides_[i][1].y()); ++r) rows_[r].push_back(i);
}

std::size_t Even_odd_test::row(double y) const {
  const double rows = static_cast<double>(rows_.size());
  return static_cast<std::size_t>(std::clamp((y - ymin_) / (ymax_ - ymin_) * rows, 0.0, rows - 1));
}

bool Even_odd_test::operator()(const Point_2& p) const {
  if (!(p.y() >= ymin_ && p.y() < ymax_)) return false;
  bool inside = false;
  for (const std::size_t i : rows_[row(p.y())]) {
    const auto& [low, high] = sides_[i];
    if (low.y() > p.y() || high.y() <= p.y()) continue;  // half open: a ray through a vertex counts once
    if (low.x() < p.x() && high.x() < p.x()) continue;
    if ((low.x() > p.x() && high.x() > p.x()) || CGAL::left_turn(low, high, p)) inside = !inside;
  }
  return inside;
}

}  // namespace cgal_blend
