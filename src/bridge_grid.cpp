// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge_grid.h"

#include <algorithm>
#include <cmath>

namespace cgal_blend {

namespace {

constexpr std::size_t fewest_columns = 16, fewest_rows = 4;
constexpr int most_halvings = 6;
constexpr std::array<double, 5> probes{0, 0.25, 0.5, 0.75, 1};  // rows at which columns are chosen
constexpr double contact_turn = 1;  // of the first facets against the contact's tangents, degrees
constexpr double nearest_row = 4;   // times the tolerance: rows nearer to each other could cross between columns

}  // namespace

Bridge_grid::Bridge_grid(const std::array<const Bridge_side*, 2>& sides, double turn, const Bridge_shape& shape,
                         const Bridge_options& options)
    : sides_(sides),
      turn_(turn),
      size_(std::max(sides[0]->size, sides[1]->size)),
      tolerance_(options.chord_tolerance * size_),
      segments_(options.segments),
      rows_(options.rows) {
  choose_columns(shape);
  evaluate(shape);
}

Bridge_column Bridge_grid::column(double s) const {
  s -= std::floor(s);
  const Bridge_ray* first = ray_before(s);
  return {{first ? *first : sides_[0]->ray(s), sides_[1]->ray(opposite_parameter(s, turn_))}};
}

const Bridge_ray* Bridge_grid::ray_before(double s) const {
  const auto found = std::lower_bound(s_before_.begin(), s_before_.end(), s);
  if (found == s_before_.end() || *found != s) return nullptr;
  return &columns_before_[static_cast<std::size_t>(found - s_before_.begin())].ray[0];
}

void Bridge_grid::turn_to(double turn, const Bridge_shape& shape) {
  turn_ = turn;
  s_before_ = std::move(s_);
  columns_before_ = std::move(columns_);
  s_.clear();
  columns_.clear();
  choose_columns(shape);
  t_.clear();
  evaluate(shape);
}

Bridge_grid::Between Bridge_grid::between_columns(double s) const {
  const auto above = static_cast<std::size_t>(std::upper_bound(s_.begin(), s_.end(), s) - s_.begin());
  const std::size_t n = s_.size(), low = (above + n - 1) % n, high = above % n;
  const double from = s_[low] > s ? s_[low] - 1 : s_[low], to = s_[high] <= s ? s_[high] + 1 : s_[high];
  return {low, high, (s - from) / (to - from)};
}

Vec Bridge_grid::point_from_rim(std::size_t end, double s, double t, const Vec& place) const {
  const double f = hartmann(t, shape_.mu, shape_.order);
  const std::array<double, 2> x{1 - t * (1 - shape_.lambda[0]), 1 - (1 - t) * (1 - shape_.lambda[1])};
  const auto [low, high, part] = between_columns(s);
  const Vec other =
      (1 - part) * columns_[low].ray[1 - end].point(x[1 - end]) + part * columns_[high].ray[1 - end].point(x[1 - end]);
  const double own = end == 0 ? s : opposite_parameter(s, turn_);
  const Vec base = sides_[end]->near_contact(own, x[end], place);
  return end == 0 ? Vec(f * base + (1 - f) * other) : Vec(f * other + (1 - f) * base);
}

void Bridge_grid::choose_columns(const Bridge_shape& shape) {
  const std::size_t n = segments_ > 0 ? segments_ : fewest_columns;
  const auto add = [&](double s, Bridge_column column) {
    s_.push_back(s);
    columns_.push_back(std::move(column));
  };
  const auto flat = [&](const Bridge_column& a, const Bridge_column& m, const Bridge_column& b) {
    return std::all_of(probes.begin(), probes.end(), [&](double t) {
      return (m.point(t, shape) - 0.5 * (a.point(t, shape) + b.point(t, shape))).norm() <= tolerance_;
    });
  };
  const auto halve = [&](auto& self, double from, double to, const Bridge_column& a, const Bridge_column& b,
                         int depth) -> void {
    const double middle = 0.5 * (from + to);
    if (segments_ == 0 && depth < most_halvings) {
      const Bridge_column m = column(middle);
      if (!flat(a, m, b)) {
        self(self, from, middle, a, m, depth + 1);
        self(self, middle, to, m, b, depth + 1);
        return;
      }
    }
    add(from, a);
  };
  const auto at = [&](std::size_t i) { return static_cast<double>(i) / static_cast<double>(n); };
  const Bridge_column first = column(0);
  Bridge_column before = first;
  for (std::size_t i = 0; i < n; ++i) {
    const Bridge_column next = i + 1 == n ? first : column(at(i + 1));
    halve(halve, at(i), at(i + 1), before, next, 0);
    before = next;
  }
}

bool Bridge_grid::fine_enough(double from, double to, const Bridge_shape& shape) const {
  const double middle = 0.5 * (from + to);
  const double cosine = std::cos(contact_turn * pi / 180);
  double longest = 0;
  bool fine = true;
  for (const Bridge_column& c : columns_) {
    const Vec a = c.point(from, shape), b = c.point(to, shape), m = c.point(middle, shape);
    const double length = (b - a).norm();
    longest = std::max(longest, length);
    fine = fine && (m - 0.5 * (a + b)).norm() <= tolerance_;
    if (from == 0) fine = fine && (b - a).dot(-c.ray[0].derivative(1).normalized()) >= cosine * length;
    if (to == 1) fine = fine && (b - a).dot(c.ray[1].derivative(1).normalized()) >= cosine * length;
    if (!fine && longest > 2 * nearest_row * tolerance_) return false;
  }
  return fine || longest <= 2 * nearest_row * tolerance_;
}

void Bridge_grid::choose_rows(const Bridge_shape& shape) {
  t_.clear();
  const std::size_t n = rows_ > 0 ? rows_ : fewest_rows;
  const auto halve = [&](auto& self, double from, double to, int depth) -> void {
    if (rows_ > 0 || depth == most_halvings || fine_enough(from, to, shape)) {
      t_.push_back(from);
      return;
    }
    self(self, from, 0.5 * (from + to), depth + 1);
    self(self, 0.5 * (from + to), to, depth + 1);
  };
  const auto at = [&](std::size_t i) { return static_cast<double>(i) / static_cast<double>(n); };
  for (std::size_t i = 0; i < n; ++i) halve(halve, at(i), at(i + 1), 0);
  t_.push_back(1);
}

void Bridge_grid::evaluate(const Bridge_shape& shape) {
  shape_ = shape;
  if (rows_ == 0 || t_.empty()) choose_rows(shape);
  points_.clear();
  points_.reserve(t_.size() * columns_.size());
  for (const double t : t_) {
    const double f = hartmann(t, shape.mu, shape.order);
    const double x = 1 - t * (1 - shape.lambda[0]), y = 1 - (1 - t) * (1 - shape.lambda[1]);
    for (const Bridge_column& c : columns_)
      points_.push_back(to_point(f * c.ray[0].point(x) + (1 - f) * c.ray[1].point(y)));
  }
}

}  // namespace cgal_blend
