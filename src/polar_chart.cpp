// SPDX-License-Identifier: GPL-3.0-or-later
#include "polar_chart.h"

#include <algorithm>
#include <cmath>

namespace cgal_blend {

namespace {

constexpr double infinite = Geodesic_field::infinite;
constexpr double rounding = 1e-9;  // of weights

/// Distance of a segment from the origin.
double distance_of(const Kernel::Point_2& p, const Kernel::Point_2& q) {
  const double ex = q.x() - p.x(), ey = q.y() - p.y(), squared = ex * ex + ey * ey;
  const double s = squared > 0 ? std::clamp(-(p.x() * ex + p.y() * ey) / squared, 0.0, 1.0) : 0;
  return std::hypot(p.x() + s * ex, p.y() + s * ey);
}

/// Outside of the box around a triangle: by comparisons only, cheaper than orientations.
bool is_beside(const Kernel::Point_2& p, const Kernel::Point_2& a, const Kernel::Point_2& b, const Kernel::Point_2& c) {
  return p.x() < std::min({a.x(), b.x(), c.x()}) || p.x() > std::max({a.x(), b.x(), c.x()}) ||
         p.y() < std::min({a.y(), b.y(), c.y()}) || p.y() > std::max({a.y(), b.y(), c.y()});
}

}  // namespace

double thin_height(Chart_kind kind, double radius) {
  constexpr double in_disk = 1e-5, in_band = 5e-4;
  return radius * (kind == Chart_kind::disk ? in_disk : in_band);
}

Polar_chart::Polar_chart(const Region_mesh& region, const Geodesic_field& field, Chart_kind kind, double radius,
                         double limit)
    : region_(region), field_(field), kind_(kind), radius_(radius), limit_(limit) {
  points_.reserve(field.at.size());
  for (const auto& [distance, angle] : field.at)
    if (!(distance <= limit))
      points_.emplace_back(0, 0);
    else if (kind == Chart_kind::disk)
      points_.emplace_back(distance * std::cos(angle), distance * std::sin(angle));
    else
      points_.emplace_back(angle, distance);
  find_folds();
  find_rim();
}

/// In a band relative to the first corner, so that triangles over angle 0 are whole.
std::array<Polar_chart::Point, 3> Polar_chart::corners(std::int32_t triangle) const {
  const auto& corner = region_.triangles()[triangle].corner;
  std::array<Point, 3> p{points_[corner[0]], points_[corner[1]], points_[corner[2]]};
  if (kind_ == Chart_kind::band)
    for (int i = 1; i < 3; ++i)
      if (std::abs(p[i].x() - p[0].x()) > pi) p[i] = {p[0].x() + turn(p[0].x(), p[i].x()), p[i].y()};
  return p;
}

bool Polar_chart::is_reached(std::int32_t triangle) const {
  const auto& corner = region_.triangles()[triangle].corner;
  return std::all_of(corner.begin(), corner.end(), [&](auto v) { return field_.at[v].distance <= limit_; });
}

double Polar_chart::nearest(std::int32_t triangle) const {
  const auto& [a, b, c] = region_.triangles()[triangle].corner;
  return std::min({field_.at[a].distance, field_.at[b].distance, field_.at[c].distance});
}

/// Also not round the band.
bool Polar_chart::is_upright_in_band(std::int32_t triangle) const {
  const auto [a, b, c] = corners(triangle);
  const auto [low, high] = std::minmax({a.x(), b.x(), c.x()});
  return high - low < pi && CGAL::orientation(a, b, c) == CGAL::LEFT_TURN;
}

/// Counter-clockwise, and not round the source unless it has a corner there.
bool Polar_chart::is_upright(std::int32_t triangle) const {
  if (kind_ == Chart_kind::band) return is_upright_in_band(triangle);
  const auto [a, b, c] = corners(triangle);
  if (CGAL::orientation(a, b, c) != CGAL::LEFT_TURN) return false;
  if (nearest(triangle) == 0) return true;
  const Point o(0, 0);
  return CGAL::orientation(a, b, o) == CGAL::RIGHT_TURN || CGAL::orientation(b, c, o) == CGAL::RIGHT_TURN ||
         CGAL::orientation(c, a, o) == CGAL::RIGHT_TURN;
}

/// Upright triangles cover each point as often as their rim winds around it, turned ones take away as often. So if no other than those of the source
/// cover the source, all is covered once that is nearer than the rim, whatever the region's topology.
void Polar_chart::find_folds() {
  bound_ = {infinite, infinite, -1, -1};
  const auto count = static_cast<std::int32_t>(region_.triangles().size());
  used_.assign(count, 0);
  std::vector<char> on_left;  // of the curve
  if (kind_ == Chart_kind::band) on_left = region_.connected_to(field_.fixed.front());
  for (std::int32_t t = 0; t < count; ++t) {
    if (!is_reached(t) || (!on_left.empty() && !on_left[t])) continue;
    used_[t] = 1;
    if (is_upright(t) || region_.height(t) < thin_height(kind_, radius_)) continue;
    used_[t] = 0;
    for (const std::int32_t v : region_.triangles()[t].corner) {
      if (field_.at[v].distance >= bound_.fold) continue;
      bound_.fold = field_.at[v].distance;
      bound_.fold_at = v;
    }
  }
  for (std::int32_t t = 0; t < count; ++t)
    if (used_[t] && nearest(t) >= bound_.fold) used_[t] = 0;
}

void Polar_chart::find_rim() {
  for (std::int32_t t = 0; t < static_cast<std::int32_t>(used_.size()); ++t) {
    if (!used_[t]) continue;
    const auto& [corner, beyond] = region_.triangles()[t];
    for (int slot = 0; slot < 3; ++slot) {
      if (covers(beyond[slot])) continue;
      const std::int32_t p = corner[(slot + 1) % 3], q = corner[(slot + 2) % 3];
      if (beyond[slot] == Region_mesh::seam) continue;  // the source
      const bool at_border = beyond[slot] == Region_mesh::border;
      const double distance =
          kind_ == Chart_kind::disk ? distance_of(points_[p], points_[q]) : std::min(points_[p].y(), points_[q].y());
      double& bound = at_border ? bound_.border : bound_.fold;
      if (distance >= bound) continue;
      bound = distance;
      (at_border ? bound_.border_at : bound_.fold_at) = p;
    }
  }
}

Polar_point Polar_chart::at(const Region_mesh::Place& place) const {
  const auto corner = corners(place.triangle);
  double x = 0, y = 0;
  for (int i = 0; i < 3; ++i) {
    x += place.weights[i] * corner[i].x();
    y += place.weights[i] * corner[i].y();
  }
  if (kind_ == Chart_kind::band) return {y, wrapped(x)};
  return {std::hypot(x, y), x == 0 && y == 0 ? 0 : wrapped(std::atan2(y, x))};
}

/// Column and row of a place; columns of a band are not wrapped.
std::array<int, 2> Polar_chart::cell(const Point& p) const {
  const auto at = [&](double share) {  // rounds down, without the call that std::floor is
    const double x = share * cells_;
    const int towards_zero = static_cast<int>(x);
    return towards_zero - (x < towards_zero ? 1 : 0);
  };
  const auto inside = [&](int i) { return std::clamp(i, 0, cells_ - 1); };
  if (kind_ == Chart_kind::band) return {at(p.x() / (2 * pi)), inside(at(p.y() / limit_))};
  return {inside(at((p.x() / limit_ + 1) / 2)), inside(at((p.y() / limit_ + 1) / 2))};
}

/// First and last columns and rows of the cells that the box around a triangle meets.
std::array<int, 4> Polar_chart::cells_around(std::int32_t triangle) const {
  const auto [a, b, c] = corners(triangle);
  const auto [x0, y0] = cell({std::min({a.x(), b.x(), c.x()}), std::min({a.y(), b.y(), c.y()})});
  const auto [x1, y1] = cell({std::max({a.x(), b.x(), c.x()}), std::max({a.y(), b.y(), c.y()})});
  return {x0, x1, y0, y1};
}

template <class Visitor>
void Polar_chart::for_cells(const std::array<int, 4>& around, const Visitor& visit) const {
  const auto [x0, x1, y0, y1] = around;
  for (int y = y0; y <= y1; ++y)
    for (int x = x0; x <= x1; ++x) visit(static_cast<std::size_t>(y) * cells_ + (x + cells_) % cells_);
}

void Polar_chart::index() {
  const auto count = static_cast<std::int32_t>(used_.size());
  cells_ = std::max(1, static_cast<int>(std::sqrt(0.5 * count)));
  cell_begin_.assign(static_cast<std::size_t>(cells_) * cells_ + 1, 0);
  std::vector<std::array<int, 4>> around(count);
  for (std::int32_t t = 0; t < count; ++t) {
    if (!used_[t]) continue;
    around[t] = cells_around(t);
    for_cells(around[t], [&](std::size_t c) { ++cell_begin_[c]; });
  }
  std::int32_t sum = 0;
  for (std::int32_t& begin : cell_begin_) begin = sum += begin;
  cell_triangles_.resize(sum);
  for (std::int32_t t = count; t-- > 0;)
    if (used_[t]) for_cells(around[t], [&](std::size_t c) { cell_triangles_[--cell_begin_[c]] = t; });
}

/// Strictly inside or on an edge by exact predicates. In a band corners and places are rounded where they are moved by a
/// turn, so there what is outside by a rounding error counts as inside, if nothing else contains it.
std::optional<Region_mesh::Place> Polar_chart::locate(const Polar_point& at) const {
  const double angle = wrapped(at.angle);
  const bool is_band = kind_ == Chart_kind::band;
  const Point place =
      is_band ? Point(angle, at.distance) : Point(at.distance * std::cos(angle), at.distance * std::sin(angle));
  const auto [column, row] = cell(place);
  const std::size_t c = static_cast<std::size_t>(row) * cells_ + (column + cells_) % cells_;
  std::optional<Region_mesh::Place> nearest;
  double least = -rounding;
  for (std::int32_t i = cell_begin_[c]; i < cell_begin_[c + 1]; ++i) {
    const std::int32_t t = cell_triangles_[i];
    const auto [a, b, d] = corners(t);
    const Point p = is_band ? Point(a.x() + turn(a.x(), place.x()), place.y()) : place;
    if (!is_band && is_beside(p, a, b, d)) continue;
    const bool inside = CGAL::orientation(a, b, p) != CGAL::RIGHT_TURN &&
                        CGAL::orientation(b, d, p) != CGAL::RIGHT_TURN &&
                        CGAL::orientation(d, a, p) != CGAL::RIGHT_TURN;
    if (!inside && !is_band) continue;
    const double whole = CGAL::area(a, b, d);
    if (!(whole > 0)) continue;
    std::array<double, 3> w{CGAL::area(b, d, p) / whole, CGAL::area(d, a, p) / whole, CGAL::area(a, b, p) / whole};
    const double lowest = std::min({w[0], w[1], w[2]});
    if (!inside && lowest < least) continue;
    least = lowest;
    for (double& weight : w) weight = std::max(weight, 0.0);
    const double sum = w[0] + w[1] + w[2];
    for (double& weight : w) weight /= sum;
    nearest = Region_mesh::Place{t, w};
    if (inside) break;
  }
  return nearest;
}

}  // namespace cgal_blend
