// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/correspondence.h>

#include <CGAL/assertions.h>

#include <boost/math/interpolators/pchip.hpp>

#include <algorithm>
#include <cmath>

namespace cgal_blend {

struct Parameter_map::Interpolant {
  boost::math::interpolators::pchip<std::vector<double>> cubic;
};

namespace {

/// Nodes of the period before and after, so that the interpolant has one derivative where it closes.
void extend(std::vector<double>& s, std::vector<double>& values) {
  const std::size_t n = s.size() - 1, more = std::min<std::size_t>(n, 3);
  const double period = values.back() - values.front();
  std::vector<double> wide_s, wide_values;
  for (std::size_t i = n - more; i < n; ++i) {
    wide_s.push_back(s[i] - 1);
    wide_values.push_back(values[i] - period);
  }
  wide_s.insert(wide_s.end(), s.begin(), s.end());
  wide_values.insert(wide_values.end(), values.begin(), values.end());
  for (std::size_t i = 1; i <= more; ++i) {
    wide_s.push_back(s[i] + 1);
    wide_values.push_back(values[i] + period);
  }
  s = std::move(wide_s);
  values = std::move(wide_values);
}

/// The interpolation wants four nodes or more; the middle of a chord keeps it monotone.
void fill_up(std::vector<double>& s, std::vector<double>& values) {
  while (s.size() < 4)
    for (std::size_t i = s.size() - 1; i > 0; --i) {
      s.insert(s.begin() + static_cast<std::ptrdiff_t>(i), (s[i - 1] + s[i]) / 2);
      values.insert(values.begin() + static_cast<std::ptrdiff_t>(i), (values[i - 1] + values[i]) / 2);
    }
}

}  // namespace

Parameter_map::Parameter_map(const std::vector<double>& s, const std::vector<double>& values, bool closed)
    : reversed_(values.back() < values.front()), closed_(closed), first_(values.front()) {
  CGAL_precondition(s.size() == values.size() && s.size() >= 2);
  std::vector<double> nodes = s, ordinates = values;
  if (closed) extend(nodes, ordinates);
  fill_up(nodes, ordinates);
  interpolant_ = std::make_shared<const Interpolant>(
      Interpolant{boost::math::interpolators::pchip<std::vector<double>>(std::move(nodes), std::move(ordinates))});
}

double Parameter_map::raw(double s) const { return interpolant_ ? interpolant_->cubic(s) : s; }

Parameter_map::Value Parameter_map::operator()(double s) const {
  if (!interpolant_) return {s, 1};
  const double x = raw(s), slope = interpolant_->cubic.prime(s);
  return {closed_ && (x < 0 || x > 1) ? x - std::floor(x) : std::clamp(x, 0.0, 1.0), slope};
}

double Parameter_map::inverse(double parameter) const {
  if (!interpolant_) return parameter;
  double target = parameter;
  if (closed_) {  // into the interval that the map covers
    target = reversed_ ? parameter - std::ceil(parameter - first_) : parameter - std::floor(parameter - first_);
    if (target == (reversed_ ? first_ - 1 : first_ + 1)) return 0;
  }
  double low = 0, high = 1;
  for (int step = 0; step < 60; ++step) {
    const double middle = (low + high) / 2;
    ((raw(middle) < target) != reversed_ ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace cgal_blend
