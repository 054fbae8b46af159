// SPDX-License-Identifier: GPL-3.0-or-later
#include "segment_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cgal_blend {

namespace {

constexpr std::size_t run = 4;  // segments of a leaf

double distance(const Point_2& p, const Point_2& a, const Point_2& b) {
  const double dx = b.x() - a.x(), dy = b.y() - a.y(), px = p.x() - a.x(), py = p.y() - a.y();
  const double length2 = dx * dx + dy * dy;
  const double t = length2 > 0 ? std::clamp((px * dx + py * dy) / length2, 0.0, 1.0) : 0.0;
  // From the nearer end, so that a point on it has distance 0.
  if (t > 0.5) {
    const double qx = p.x() - b.x() + (1 - t) * dx, qy = p.y() - b.y() + (1 - t) * dy;
    return std::sqrt(qx * qx + qy * qy);
  }
  const double qx = px - t * dx, qy = py - t * dy;
  return std::sqrt(qx * qx + qy * qy);
}

}  // namespace

Segment_tree::Segment_tree(std::vector<Weighted_segment> segments, double slope)
    : segments_(std::move(segments)), slope_(slope) {
  if (segments_.empty()) return;
  std::size_t nodes = 1;
  while (nodes * run < 2 * segments_.size()) nodes *= 2;
  boxes_.resize(2 * nodes);
  build(0, 0, segments_.size());
}

void Segment_tree::build(std::size_t node, std::size_t first, std::size_t last) {
  const double infinity = std::numeric_limits<double>::infinity();
  Box box{infinity, infinity, -infinity, -infinity, infinity};
  for (std::size_t i = first; i < last; ++i) {
    const auto& [a, b, weight] = segments_[i];
    box = {std::min({box.xmin, a.x(), b.x()}), std::min({box.ymin, a.y(), b.y()}), std::max({box.xmax, a.x(), b.x()}),
           std::max({box.ymax, a.y(), b.y()}), std::min(box.weight, weight)};
  }
  if (node >= boxes_.size()) boxes_.resize(2 * node + 1);
  boxes_[node] = box;
  if (last - first <= run) return;
  const std::size_t middle = first + (last - first) / 2;
  build(2 * node + 1, first, middle);
  build(2 * node + 2, middle, last);
}

double Segment_tree::bound(std::size_t node, const Point_2& p) const {
  const Box& box = boxes_[node];
  const double dx = std::max({box.xmin - p.x(), 0.0, p.x() - box.xmax});
  const double dy = std::max({box.ymin - p.y(), 0.0, p.y() - box.ymax});
  return box.weight + slope_ * std::sqrt(dx * dx + dy * dy);
}

double Segment_tree::value(std::size_t segment, const Point_2& p) const {
  const auto& [a, b, weight] = segments_[segment];
  return weight + slope_ * distance(p, a, b);
}

void Segment_tree::query(std::size_t node, std::size_t first, std::size_t last, const Point_2& p, Best& best) const {
  if (last - first <= run) {
    for (std::size_t i = first; i < last; ++i)
      if (const double v = value(i, p); v < best.value) best = {v, i};
    return;
  }
  const std::size_t middle = first + (last - first) / 2, left = 2 * node + 1, right = 2 * node + 2;
  const double of_left = bound(left, p), of_right = bound(right, p);
  if (of_left <= of_right) {
    if (of_left < best.value) query(left, first, middle, p, best);
    if (of_right < best.value) query(right, middle, last, p, best);
  } else {
    if (of_right < best.value) query(right, middle, last, p, best);
    if (of_left < best.value) query(left, first, middle, p, best);
  }
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
