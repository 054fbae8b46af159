// SPDX-License-Identifier: GPL-3.0-or-later
#include "curve_arc.h"

#include <algorithm>
#include <cmath>

namespace cgal_blend::internal {

namespace {

// A point found in extended precision stands if both surfaces pass it this close, relative to its coordinates, ...
constexpr long double near_surface = 2e-17L;
// ... and cross at an angle of this sine or more; else the point is found in many digits.
constexpr long double crossing_sine = 1e-4L;

using Vector = std::array<long double, 3>;

Surface_coefficients rounded(const Quadric_3& quadric) {
  Real largest = 0;
  for (const auto& a : quadric.coefficients()) largest = std::max<Real>(largest, abs(to_real(a)));
  Surface_coefficients result;
  for (std::size_t k = 0; k < 10; ++k)
    result[k] = static_cast<long double>(Real(to_real(quadric.coefficients()[k]) / largest));
  return result;
}

long double value(const Surface_coefficients& c, const Vector& p) {
  const auto [x, y, z] = p;
  return (c[0] * x + c[3] * y + c[4] * z + c[6]) * x + (c[1] * y + c[5] * z + c[7]) * y + (c[2] * z + c[8]) * z + c[9];
}

Vector gradient(const Surface_coefficients& c, const Vector& p) {
  const auto [x, y, z] = p;
  return {2 * c[0] * x + c[3] * y + c[4] * z + c[6], c[3] * x + 2 * c[1] * y + c[5] * z + c[7],
          c[4] * x + c[5] * y + 2 * c[2] * z + c[8]};
}

long double length(const Vector& v) { return std::hypot(v[0], v[1], v[2]); }

Vector cross(const Vector& x, const Vector& y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}

template <class NT>
NT part(const Real& x) {
  return static_cast<NT>(x);
}

// The parameter at s, with derivative: spherical interpolation between the unit vectors on either side.
template <class NT>
std::array<Dual<NT>, 2> parameter(const Curve_arc& arc, double s) {
  const std::size_t half = s < 0.5 ? 0 : 1;
  const long double t = 2 * static_cast<long double>(s) - static_cast<long double>(half), h = arc.half_angle;
  const Direction &from = arc.through[half], &to = arc.through[half + 1];
  const Dual<NT> u{NT(std::sin((1 - t) * h)), NT(-2 * h * std::cos((1 - t) * h))};
  const Dual<NT> v{NT(std::sin(t * h)), NT(2 * h * std::cos(t * h))};
  return {part<NT>(from.c) * u + part<NT>(to.c) * v, part<NT>(from.s) * u + part<NT>(to.s) * v};
}

template <class NT>
struct Affine_point {
  std::array<NT, 3> at, derivative;
};

template <class NT>
Affine_point<NT> evaluate(const Curve_arc& arc, double s) {
  const auto [c, d] = parameter<NT>(arc, s);
  const Projective<Dual<NT>> x = arc.curve->at(c, d);
  Affine_point<NT> result;
  for (std::size_t i = 0; i < 3; ++i) {
    const Dual<NT> coordinate = x[i] / x[3];
    result.at[i] = coordinate.value;
    result.derivative[i] = coordinate.slope;
  }
  return result;
}

bool stands(const Curve_arc& arc, const Affine_point<long double>& p) {
  const Vector na = gradient(arc.coefficients_a, p.at), nb = gradient(arc.coefficients_b, p.at);
  const long double a = length(na), b = length(nb);
  const long double reach = near_surface * std::max({std::abs(p.at[0]), std::abs(p.at[1]), std::abs(p.at[2])});
  return std::isfinite(length(p.derivative)) && std::abs(value(arc.coefficients_a, p.at)) <= reach * a &&
         std::abs(value(arc.coefficients_b, p.at)) <= reach * b && length(cross(na, nb)) >= crossing_sine * a * b;
}

template <class NT>
Curve_point rounded(const Affine_point<NT>& p) {
  const auto number = [](const NT& x) { return static_cast<double>(x); };
  Curve_point result;
  result.point = {number(p.at[0]), number(p.at[1]), number(p.at[2])};
  result.derivative = {number(p.derivative[0]), number(p.derivative[1]), number(p.derivative[2])};
  return result;
}

Curve_point::Vector_3 unit_normal(const Surface_coefficients& c, const Curve_point::Point_3& p) {
  const Vector v = gradient(c, {p.x(), p.y(), p.z()});
  const long double size = length(v);
  if (!(size > 0)) return {0, 0, 0};
  return {static_cast<double>(v[0] / size), static_cast<double>(v[1] / size), static_cast<double>(v[2] / size)};
}

}  // namespace

Curve_arc::Curve_arc(const Quadric_3& a, const Quadric_3& b)
    : a(a), b(b), coefficients_a(rounded(a)), coefficients_b(rounded(b)) {}

void Curve_arc::set_range(const Real& begin, const Real& end) {
  const Real half = (end - begin) / 2;
  for (std::size_t k = 0; k < 3; ++k) {
    const Real angle = begin + static_cast<int>(k) * half;
    through[k] = {cos(angle), sin(angle)};
  }
  half_angle = static_cast<long double>(half);
}

Curve_point Curve_arc::at(double s) const {
  Curve_point result;
  if (!curve) {
    result.point = isolated_point;
    result.derivative = {0, 0, 0};
  } else if ((s == 0 && has_cusp[0]) || (s == 1 && has_cusp[1])) {
    result = rounded(evaluate<Real>(*this, s));
    result.derivative = {0, 0, 0};
  } else {
    const Affine_point<long double> p = evaluate<long double>(*this, s);
    result = stands(*this, p) ? rounded(p) : rounded(evaluate<Real>(*this, s));
  }
  result.normal_a = unit_normal(coefficients_a, result.point);
  result.normal_b = unit_normal(coefficients_b, result.point);
  return result;
}

}  // namespace cgal_blend::internal
