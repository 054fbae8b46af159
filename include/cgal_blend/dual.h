// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_DUAL_H
#define CGAL_BLEND_DUAL_H

#include <array>
#include <cmath>
#include <cstddef>

namespace cgal_blend {

/// Number with its derivatives by `N` variables: forward-mode automatic differentiation, exact to rounding.
/// Nested (`Dual<N, Dual<N>>`) it carries second derivatives.
/// \tparam T double, or a dual number itself
template <std::size_t N, class T = double>
struct Dual {
  T value{};
  std::array<T, N> slope{};

  Dual() = default;
  Dual(double constant) : value(constant) {}  // NOLINT: numbers mix with dual numbers
  Dual(T v, const std::array<T, N>& d) : value(v), slope(d) {}

  /// Returns the variable of the given index, at a value.
  [[nodiscard]] static Dual variable(T value, std::size_t index) {
    Dual x;
    x.value = value;
    x.slope[index] = T(1.0);
    return x;
  }

  /// Returns f(*this) by the chain rule, given f and f' there.
  [[nodiscard]] Dual chained(T f, T derivative) const {
    Dual y;
    y.value = f;
    for (std::size_t i = 0; i < N; ++i) y.slope[i] = derivative * slope[i];
    return y;
  }

  friend Dual operator-(const Dual& a) { return a.chained(-a.value, T(-1.0)); }
  friend Dual operator+(const Dual& a, const Dual& b) {
    Dual y;
    y.value = a.value + b.value;
    for (std::size_t i = 0; i < N; ++i) y.slope[i] = a.slope[i] + b.slope[i];
    return y;
  }
  friend Dual operator-(const Dual& a, const Dual& b) { return a + (-b); }
  friend Dual operator*(const Dual& a, const Dual& b) {
    Dual y;
    y.value = a.value * b.value;
    for (std::size_t i = 0; i < N; ++i) y.slope[i] = a.slope[i] * b.value + a.value * b.slope[i];
    return y;
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    Dual y;
    y.value = a.value / b.value;
    for (std::size_t i = 0; i < N; ++i) y.slope[i] = (a.slope[i] - y.value * b.slope[i]) / b.value;
    return y;
  }
  friend Dual& operator+=(Dual& a, const Dual& b) { return a = a + b; }
  friend Dual& operator-=(Dual& a, const Dual& b) { return a = a - b; }
  friend Dual& operator*=(Dual& a, const Dual& b) { return a = a * b; }
};

template <std::size_t N, class T>
Dual<N, T> sqrt(const Dual<N, T>& x) {
  using std::sqrt;
  const T root = sqrt(x.value);
  return x.chained(root, T(0.5) / root);
}
template <std::size_t N, class T>
Dual<N, T> exp(const Dual<N, T>& x) {
  using std::exp;
  const T power = exp(x.value);
  return x.chained(power, power);
}
template <std::size_t N, class T>
Dual<N, T> log(const Dual<N, T>& x) {
  using std::log;
  return x.chained(log(x.value), T(1.0) / x.value);
}
template <std::size_t N, class T>
Dual<N, T> cos(const Dual<N, T>& x);
template <std::size_t N, class T>
Dual<N, T> sin(const Dual<N, T>& x) {
  using std::cos;
  using std::sin;
  return x.chained(sin(x.value), cos(x.value));
}
template <std::size_t N, class T>
Dual<N, T> cos(const Dual<N, T>& x) {
  using std::cos;
  using std::sin;
  return x.chained(cos(x.value), -sin(x.value));
}

/// Returns x to the power of a whole number, 0 to the power of 0 being 1.
template <class T>
T power(const T& x, int exponent) {
  if (exponent < 0) return T(1.0) / power(x, -exponent);
  T result(1.0), square = x;
  for (int e = exponent; e > 0; e /= 2) {
    if (e % 2 == 1) result = result * square;
    if (e > 1) square = square * square;
  }
  return result;
}

}  // namespace cgal_blend

#endif
