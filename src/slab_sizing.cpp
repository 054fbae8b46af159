// SPDX-License-Identifier: GPL-3.0-or-later
#include "slab_sizing.h"

#include "ring_clearance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cgal_blend {

namespace {

// Where rings are too coarse to tell the shape: so many edges over the height and around each ring at least.
constexpr double edges_over_height = 2, edges_around = 16;

/// Sides of a ring with the edge length wanted at each; coarse ones are capped.
std::vector<Weighted_segment> wanted(const std::vector<Ring>& rings, double height, const Slab_options& options) {
  std::vector<Weighted_segment> result;
  for (const Ring& ring : rings) {
    std::vector<Weighted_segment> sides = sides_of({ring});
    double sum = 0, squares = 0;
    for (Weighted_segment& s : sides) {
      s.weight = std::sqrt(CGAL::squared_distance(s.source, s.target));
      sum += s.weight;
      squares += s.weight * s.weight;
    }
    // The mean by length: short sides are many, but cover little.
    const double cap =
        options.edge > 0 ? options.edge : std::min({squares / sum, sum / edges_around, height / edges_over_height});
    for (Weighted_segment& s : sides) s.weight = std::min(s.weight, cap);
    result.insert(result.end(), sides.begin(), sides.end());
  }
  return result;
}

/// Half the sides' lengths, negated.
std::vector<Weighted_segment> least_wanted(const std::vector<Ring>& rings) {
  std::vector<Weighted_segment> sides = sides_of(rings);
  for (Weighted_segment& s : sides) s.weight = -std::sqrt(CGAL::squared_distance(s.source, s.target)) / 2;
  return sides;
}

/// Pieces of the rings at which less than `reach` is clear on one side or the other.
std::vector<Weighted_segment> narrow(const std::vector<Ring>& rings, double reach, double widths) {
  const Ring_clearance clearance(rings);
  std::vector<Weighted_segment> result;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const bool left_inside = interior_on_left(rings, r);
    for (const auto& [a, b, weight] : sides_of({rings[r]})) {
      const auto d = b - a;
      const double length = std::sqrt(d.squared_length()), pieces = std::ceil(length / (2 * reach));
      const Kernel::Vector_2 left(-d.y() / length, d.x() / length);
      for (double k = 0; k < pieces; ++k) {
        const Point_2 middle = a + (k + 0.5) / pieces * d;
        const double clear =
            std::min(clearance(middle, left, left_inside, reach), clearance(middle, -left, !left_inside, reach));
        if (clear < reach) result.push_back({a + k / pieces * d, a + (k + 1) / pieces * d, 2 * widths * clear});
      }
    }
  }
  return result;
}

}  // namespace

Slab_sizing::Slab_sizing(const Hermite_transition& psi, const Slab_options& options, double growth, double decline,
                         double gaps)
    : upper_{Segment_tree(wanted(psi.rings(0), psi.height(), options), growth),
             Segment_tree(wanted(psi.rings(1), psi.height(), options), growth)},
      lower_{Segment_tree(least_wanted(psi.rings(0)), decline), Segment_tree(least_wanted(psi.rings(1)), decline)},
      growth_(growth),
      decline_(decline),
      height_(psi.height()),
      smallest_(std::numeric_limits<double>::infinity()),
      largest_(0) {
  for (const std::size_t side : {0, 1})
    for (const Weighted_segment& s : wanted(psi.rings(side), height_, options)) {
      smallest_ = std::min(smallest_, s.weight);
      largest_ = std::max(largest_, s.weight);
    }
  largest_ *= std::max(1.0, options.grading);
  if (!(gaps > 0)) return;
  for (const std::size_t side : {0, 1}) {
    gaps_.emplace_back(narrow(psi.rings(side), largest_ / 2, gaps), growth);
    smallest_ = std::min(smallest_, gaps_.back().least_weight());
  }
}

void Slab_sizing::halve_at(const Point_3& p) {
  // A place close to one that is fine already would add nothing but time.
  const double size = (*this)(p);
  for (const auto& [place, least] : finer_)
    if (least < 0.75 * size && CGAL::squared_distance(p, place) < size * size) return;
  finer_.emplace_back(p, size / 2);
  smallest_ = std::min(smallest_, size / 2);
}

double Slab_sizing::gap(const Point_2& p, double size) const {
  for (const Segment_tree& tree : gaps_)
    if (tree.least_weight() < size) size = std::min(size, tree(p));
  return size;
}

double Slab_sizing::at_plane(std::size_t side, const Point_2& p) const {
  return gap(p, std::max(std::min(largest_, upper_[side](p)), -lower_[side](p)));
}

double Slab_sizing::operator()(const Point_3& p) const {
  const Point_2 q(p.x(), p.y());
  const std::array<double, 2> distance{p.z(), height_ - p.z()};
  double size = largest_;
  for (const std::size_t side : {0, 1})
    if (const double away = growth_ * distance[side]; upper_[side].least_weight() + away < size)
      size = std::min(size, upper_[side](q) + away);
  for (const std::size_t side : {0, 1})
    if (const double away = decline_ * distance[side]; - lower_[side].least_weight() - away > size)
      size = std::max(size, -lower_[side](q) - away);
  size = gap(q, size);
  for (const auto& [place, least] : finer_)
    if (least < size) size = std::min(size, least + growth_ * std::sqrt(CGAL::squared_distance(p, place)));
  return size;
}

}  // namespace cgal_blend
