// SPDX-License-Identifier: GPL-3.0-or-later
#include "paced_bend.h"

#include "rotated.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace cgal_blend {

namespace {

// Steps of height in which the reach of sections is recorded,
constexpr std::size_t coarse = 32;
// and in which turning is summed up.
constexpr std::size_t fine = 512;
// Sections count as reaching inwards by no less than this share of the farthest one: else all turning would be there.
constexpr double least_reach = 0.05;
// Shares of the height at either end over which turning sets in, gentle ones first: facets next to the rings show it.
constexpr double eases[] = {0.3, 0.2, 0.1, 0.05};
// Heights should not be shortened to less than this.
constexpr double good_advance = 0.15;

/// 0 to 1 with slopes 0.
double smooth_step(double t) { return t * t * (3 - 2 * t); }

/// Linear between values at equal steps of [0, 1].
double interpolated(const std::vector<double>& values, double t) {
  const double x = t * static_cast<double>(values.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(x), values.size() - 2);
  const double u = x - static_cast<double>(i);
  return (1 - u) * values[i] + u * values[i + 1];
}

}  // namespace

Paced_bend::Paced_bend(const Bend_ends& ends, const std::vector<Point_3>& points)
    : ends_(ends), inward_(CGAL::cross_product(ends.axis, ends.z)) {
  find_reach(points);
  double best = -1, chosen = eases[0];
  for (const double ease : eases) {
    set_pace(ease);
    const double least = least_advance(points);
    if (least > best || ease == eases[0]) {
      best = least;
      chosen = ease;
    }
    if (least >= good_advance) break;
  }
  set_pace(chosen);
  if (!(least_advance(points) > 0))
    fold_ = *std::find_if(points.begin(), points.end(), [&](const Point_3& p) { return !(advance(p) > 0); });
}

/// Place within its section, whose centre comes onto the curve.
Vector_3 Paced_bend::section(const Point_3& p) const {
  const double t = std::clamp(p.z() / ends_.height, 0.0, 1.0);
  return p.x() * ends_.x + p.y() * ends_.y - smooth_step(t) * ends_.offset;
}

void Paced_bend::find_reach(const std::vector<Point_3>& points) {
  reach_.assign(coarse + 1, 0);
  for (const Point_3& p : points) {
    const double at = std::clamp(p.z() / ends_.height, 0.0, 1.0) * coarse, reach = section(p) * inward_;
    for (std::size_t i = 0; i <= coarse; ++i)
      if (std::abs(static_cast<double>(i) - at) <= 1) reach_[i] = std::max(reach_[i], reach);
  }
  // Heights without a vertex lie within long facets.
  for (std::size_t i = 1; i < coarse; ++i)
    if (reach_[i] == 0) reach_[i] = reach_[i - 1];
  const double least = least_reach * *std::max_element(reach_.begin(), reach_.end());
  for (double& reach : reach_) reach = std::max(reach, least);
}

void Paced_bend::set_pace(double ease) {
  rate_.assign(fine + 1, 0);
  turn_.assign(fine + 1, 0);
  for (std::size_t i = 0; i <= fine; ++i) {
    const double t = static_cast<double>(i) / fine;
    rate_[i] = smooth_step(std::min(1.0, std::min(t, 1 - t) / ease)) / interpolated(reach_, t);
    if (i > 0) turn_[i] = turn_[i - 1] + (rate_[i - 1] + rate_[i]) / (2 * fine);
  }
  const double scale = ends_.angle / turn_.back();
  for (double& rate : rate_) rate *= scale;
  for (double& turn : turn_) turn *= scale;
}

/// The integral of the rate.
double Paced_bend::turn(double t) const {
  const std::size_t i = std::min(static_cast<std::size_t>(t * fine), fine - 1);
  const double u = t - static_cast<double>(i) / fine;
  return turn_[i] + u * (rate_[i] + u * fine * (rate_[i + 1] - rate_[i]) / 2);
}

/// How fast a point goes along its section's normal with height, as a share of the straight speed; sections pass through
/// each other where it is not positive.
double Paced_bend::advance(const Point_3& p) const {
  const double t = std::clamp(p.z() / ends_.height, 0.0, 1.0), angle = turn(t);
  const Vector_3 normal = rotated(ends_.z, ends_.axis, angle), last = rotated(ends_.z, ends_.axis, ends_.angle);
  const Vector_3 curve = 6 * t * (1 - t) * (ends_.centre[1] - ends_.centre[0]) +
                         ends_.height * ((1 - t) * (1 - 3 * t) * ends_.z + t * (3 * t - 2) * last);
  return (curve * normal - interpolated(rate_, t) * (section(p) * inward_)) / ends_.height;
}

double Paced_bend::least_advance(const std::vector<Point_3>& points) const {
  double least = 1;
  for (const Point_3& p : points) least = std::min(least, advance(p));
  return least;
}

Point_3 Paced_bend::operator()(const Point_3& p) const {
  const double t = std::clamp(p.z() / ends_.height, 0.0, 1.0);
  const Vector_3 last = rotated(ends_.z, ends_.axis, ends_.angle);
  const Vector_3 curve = smooth_step(t) * (ends_.centre[1] - ends_.centre[0]) +
                         ends_.height * t * (1 - t) * ((1 - t) * ends_.z - t * last);
  const Vector_3 beyond = (p.z() - t * ends_.height) * ends_.z;
  return ends_.centre[0] + curve + rotated(section(p) + beyond, ends_.axis, turn(t));
}

}  // namespace cgal_blend
