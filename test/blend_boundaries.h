// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_TEST_BLEND_BOUNDARIES_H
#define CGAL_BLEND_TEST_BLEND_BOUNDARIES_H

#include <cgal_blend/surface_blend.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

// Oracles for blends between surfaces: everything is measured on the points P(s, t) alone.

namespace cgal_blend::test {

using Normal_field = std::function<Vector_3(const Point_3&)>;

inline Vector_3 unit(const Vector_3& v) { return v / std::sqrt(v.squared_length()); }

/// Angle between two lines, radians in [0, pi / 2].
inline double line_angle(const Vector_3& a, const Vector_3& b) {
  return std::atan2(std::sqrt(CGAL::cross_product(a, b).squared_length()), std::abs(a * b));
}

/// Derivatives of a point function at 0, one-sided, from 9 points of a polynomial of degree 8: exact for polynomials.
/// \return first and second derivative
template <class F>
std::array<Vector_3, 2> one_sided_derivatives(const F& f, double h) {
  std::array<Point_3, 9> p;
  for (int i = 0; i < 9; ++i) p[i] = f(i * h);
  // Newton's forward differences: f' = sum (-1)^(k+1) D^k / k, f'' = sum c_k D^k with log(1 + D)^2.
  std::array<Vector_3, 9> d;
  for (int i = 0; i < 8; ++i) d[i] = p[i + 1] - p[i];
  Vector_3 first(0, 0, 0), second(0, 0, 0);
  const std::array<double, 9> c{0, 0, 1, -1, 11. / 12, -5. / 6, 137. / 180, -7. / 10, 363. / 560};
  for (int k = 1; k <= 8; ++k) {
    first = first + (k % 2 == 1 ? 1.0 : -1.0) / k * d[0];
    second = second + c[k] * d[0];
    for (int i = 0; i + 1 < 8; ++i) d[i] = d[i + 1] - d[i];
  }
  return {first / h, second / (h * h)};
}

/// Central difference of eighth order.
template <class F>
Vector_3 central_derivative(const F& f, double x, double h) {
  const std::array<double, 4> c{4. / 5, -1. / 5, 4. / 105, -1. / 280};
  Vector_3 sum(0, 0, 0);
  for (int k = 0; k < 4; ++k) sum = sum + c[k] * (f(x + (k + 1) * h) - f(x - (k + 1) * h));
  return sum / h;
}

/// Normal of the blend at one of its ends, from values of P alone.
inline Vector_3 measured_normal(const Surface_blend& blend, int side, double s) {
  const auto t_of = [&](double x) { return side == 0 ? x : 1 - x; };
  const auto wrapped = [&](double x) { return blend.is_closed() ? x - std::floor(x) : x; };
  const auto along_s = [&](double x) { return blend.at(wrapped(x), t_of(0)); };
  const auto along_t = [&](double x) { return blend.at(s, t_of(x)); };
  return CGAL::cross_product(central_derivative(along_s, s, 1e-4), one_sided_derivatives(along_t, 0.05)[0]);
}

/// Largest angle between the blend and the true surface along a boundary, radians.
inline double worst_tangency(const Surface_blend& blend, int side, const Normal_field& normal, int samples = 97) {
  double worst = 0;
  for (int i = 0; i < samples; ++i) {
    const double s = blend.is_closed() ? static_cast<double>(i) / samples : 0.001 + 0.998 * i / (samples - 1);
    worst = std::max(worst, line_angle(measured_normal(blend, side, s), normal(blend.at(s, side))));
  }
  return worst;
}

}  // namespace cgal_blend::test

#endif
