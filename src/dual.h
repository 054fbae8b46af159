// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_DUAL_H
#define CGAL_BLEND_DUAL_H

#include <cmath>

namespace cgal_blend {

/// A number with its derivative by one parameter.
template <class NT>
struct Dual {
  NT value = 0, slope = 0;

  friend Dual operator+(const Dual& x, const Dual& y) { return {NT(x.value + y.value), NT(x.slope + y.slope)}; }
  friend Dual operator-(const Dual& x, const Dual& y) { return {NT(x.value - y.value), NT(x.slope - y.slope)}; }
  friend Dual operator-(const Dual& x) { return {NT(-x.value), NT(-x.slope)}; }
  friend Dual operator*(const Dual& x, const Dual& y) {
    return {NT(x.value * y.value), NT(x.slope * y.value + x.value * y.slope)};
  }
  friend Dual operator*(const NT& factor, const Dual& x) { return {NT(factor * x.value), NT(factor * x.slope)}; }
  friend Dual operator/(const Dual& x, const Dual& y) {
    const NT quotient = x.value / y.value;
    return {quotient, NT((x.slope - quotient * y.slope) / y.value)};
  }
  /// `x` must be > 0 for the derivative to exist; of 0 and less the root is 0, with derivative 0.
  friend Dual sqrt(const Dual& x) {
    using std::sqrt;
    if (!(x.value > 0)) return {};
    const NT root = sqrt(x.value);
    return {root, NT(x.slope / (2 * root))};
  }
};

}  // namespace cgal_blend

#endif
