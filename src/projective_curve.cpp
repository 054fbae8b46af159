// SPDX-License-Identifier: GPL-3.0-or-later
#include "projective_curve.h"

#include "polynomial_roots.h"

#include <cstddef>

namespace cgal_blend {

namespace {

template <class NT>
Dual<NT> dot(const Projective<NT>& plane, const Projective<Dual<NT>>& x) {
  return plane[0] * x[0] + plane[1] * x[1] + plane[2] * x[2] + plane[3] * x[3];
}

Real dot(const Projective<Real>& x, const Projective<Real>& y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2] + x[3] * y[3];
}

Projective<long double> rounded(const Projective<Real>& x) {
  Projective<long double> result;
  for (std::size_t i = 0; i < 4; ++i) result[i] = static_cast<long double>(x[i]);
  return result;
}

template <class NT>
Dual<NT> quadratic(const std::array<NT, 3>& f, const Dual<NT>& c, const Dual<NT>& s) {
  return c * (f[0] * c + f[1] * s) + f[2] * s * s;
}

Real bracket(const Direction& x, const Direction& y) { return x.c * y.s - x.s * y.c; }

using Form = std::vector<Real>;

Form times(const Form& f, const Form& g) {
  Form h(f.size() + g.size() - 1, Real(0));
  for (std::size_t i = 0; i < f.size(); ++i)
    for (std::size_t k = 0; k < g.size(); ++k) h[i + k] += f[i] * g[k];
  return h;
}

Form minus(Form f, const Form& g, const Real& factor = 1) {
  for (std::size_t k = 0; k < f.size(); ++k) f[k] -= factor * g[k];
  return f;
}

Form form(const std::array<Real, 3>& f) { return {f[0], f[1], f[2]}; }

// Divides by a linear form that is a factor, from the end that is stable.
Form without(const Form& f, const std::array<Real, 2>& line) {
  const std::size_t n = f.size() - 1;
  Form q(n);
  if (abs(line[0]) >= abs(line[1])) {
    for (std::size_t k = 0; k < n; ++k) q[k] = (f[k] - (k > 0 ? Real(line[1] * q[k - 1]) : Real(0))) / line[0];
  } else {
    for (std::size_t k = n; k-- > 0;) q[k] = (f[k + 1] - (k + 1 < n ? Real(line[0] * q[k + 1]) : Real(0))) / line[1];
  }
  return q;
}

// The plane in the coordinates of the rulings: v0 f(u) + v1 g(u).
struct Plane_on_rulings {
  Form f, g;
};

Plane_on_rulings on_rulings(const Ruled_section<Real>& s, const Projective<Real>& plane) {
  return {{dot(plane, s.p), dot(plane, s.d2)}, {dot(plane, s.d1), dot(plane, s.q)}};
}

}  // namespace

Rational_curve::Rational_curve(const std::vector<Projective<Real>>& coefficients) : coefficients_(coefficients) {
  Real largest = 0;
  for (const Projective<Real>& point : coefficients_)
    for (const Real& x : point) largest = std::max<Real>(largest, abs(x));
  for (Projective<Real>& point : coefficients_)
    for (Real& x : point) x /= largest;
  for (const Projective<Real>& point : coefficients_) rounded_.push_back(rounded(point));
}

namespace {

template <class NT>
Projective<Dual<NT>> evaluate_rational(const std::vector<Projective<NT>>& coefficients, const Dual<NT>& c,
                                       const Dual<NT>& s) {
  Projective<Dual<NT>> x;
  Dual<NT> power{NT(1), NT(0)};  // of s
  for (const Projective<NT>& point : coefficients) {
    for (std::size_t i = 0; i < 4; ++i) x[i] = x[i] * c + point[i] * power;
    power = power * s;
  }
  return x;
}

}  // namespace

Projective<Dual<long double>> Rational_curve::at(const Dual<long double>& c, const Dual<long double>& s) const {
  return evaluate_rational(rounded_, c, s);
}

Projective<Dual<Real>> Rational_curve::at(const Dual<Real>& c, const Dual<Real>& s) const {
  return evaluate_rational(coefficients_, c, s);
}

std::vector<Direction> Rational_curve::meets_plane(const Projective<Real>& plane) const {
  Form f;
  for (const Projective<Real>& point : coefficients_) f.push_back(dot(plane, point));
  return approximate_real_roots(f);
}

std::vector<Real> discriminant(const Ruled_section<Real>& s) {
  return minus(times(form(s.b), form(s.b)), times(form(s.a), form(s.c)));
}

Real sheet_in_plane(const Ruled_section<Real>& section, const Projective<Real>& plane, const Direction& u) {
  const Plane_on_rulings on = on_rulings(section, plane);
  const Real f = value(on.f, u), g = value(on.g, u);
  const Real a = value(form(section.a), u), b = value(form(section.b), u), c = value(form(section.c), u);
  return (c - a) * f * g + b * (f * f - g * g);
}

namespace {

/// Point x + i y of the upper half-plane.
struct Half_plane_point {
  Real x, y;
};

// The hyperbolic midpoint between the complex roots of a quartic without real ones: a pair of conjugate roots is a
// positive quadratic form, and with forms of one determinant for points, the midpoint is that of their sum.
Half_plane_point midpoint_of_roots(const Form& quartic) {
  Real a = 0, b = 0, c = 0;
  for (const Complex_root& z : complex_roots(quartic)) {
    if (z.im < 0) continue;
    a += 1 / z.im;
    b -= z.re / z.im;
    c += (z.re * z.re + z.im * z.im) / z.im;
  }
  return {-b / a, sqrt(a * c - b * b) / a};
}

}  // namespace

// Which parameters are even where the loop nearly meets another one is a matter of the discriminant's roots alone: they
// are brought into a symmetric position.
Quartic_loop::Quartic_loop(const Ruled_section<Real>& section, int sheet)
    : sheet_(sheet), exact_{section, {Real(1), Real(0)}, {Real(0), Real(1)}, discriminant(section), 1} {
  const Half_plane_point centre = midpoint_of_roots(exact_.rest);
  exact_.begin[1] = centre.x;
  exact_.end[1] = centre.y;
  round();
}

Quartic_loop::Quartic_loop(const Ruled_section<Real>& section, const Direction& begin, const Direction& end)
    : exact_{section, {begin.c, begin.s}, {end.c, end.s}, {}, bracket(begin, end)} {
  // [begin, u] and [u, end] vanish at the ends and are positive between.
  exact_.rest = without(without(discriminant(section), {-begin.s, begin.c}), {end.s, -end.c});
  const Real factor = sqrt(value(exact_.rest, begin) / value(exact_.rest, end));
  for (Real& x : exact_.end) x *= factor;
  for (Real& x : exact_.rest) x /= factor;
  exact_.extent *= factor;
  round();
}

void Quartic_loop::round() {
  const Ruled_section<Real>& s = exact_.section;
  rounded_.section.p = rounded(s.p);
  rounded_.section.d1 = rounded(s.d1);
  rounded_.section.d2 = rounded(s.d2);
  rounded_.section.q = rounded(s.q);
  for (std::size_t k = 0; k < 3; ++k) {
    rounded_.section.a[k] = static_cast<long double>(s.a[k]);
    rounded_.section.b[k] = static_cast<long double>(s.b[k]);
    rounded_.section.c[k] = static_cast<long double>(s.c[k]);
  }
  for (std::size_t k = 0; k < 2; ++k) {
    rounded_.begin[k] = static_cast<long double>(exact_.begin[k]);
    rounded_.end[k] = static_cast<long double>(exact_.end[k]);
  }
  for (const Real& x : exact_.rest) rounded_.rest.push_back(static_cast<long double>(x));
  rounded_.extent = static_cast<long double>(exact_.extent);
}

template <class NT>
Projective<Dual<NT>> Quartic_loop::evaluate(const Data<NT>& data, const Dual<NT>& c, const Dual<NT>& s) const {
  Dual<NT> u0, u1, root;
  if (sheet_ == 0) {
    // The discriminant is (c s [begin, end])^2 times the rest: the root is smooth where it changes its sign.
    u0 = data.begin[0] * c * c + data.end[0] * s * s;
    u1 = data.begin[1] * c * c + data.end[1] * s * s;
    root = data.extent * c * s * sqrt(quadratic<NT>({data.rest[0], data.rest[1], data.rest[2]}, u0, u1));
  } else {
    u0 = c;
    u1 = data.begin[1] * c + data.end[1] * s;
    const Dual<NT> high = quadratic<NT>({data.rest[0], data.rest[1], data.rest[2]}, u0, u1);
    const Dual<NT> low = data.rest[3] * u0 + data.rest[4] * u1;
    root = NT(sheet_) * sqrt(high * u0 * u0 + low * u1 * u1 * u1);
  }
  const Ruled_section<NT>& t = data.section;
  const Dual<NT> a = quadratic(t.a, u0, u1), b = quadratic(t.b, u0, u1), k = quadratic(t.c, u0, u1);
  // (root - b, a) and (k, -b - root) are one point; nothing cancels in the one chosen.
  const bool is_opposite = b.value * root.value <= 0;
  const Dual<NT> v0 = is_opposite ? root - b : k, v1 = is_opposite ? a : -b - root;
  Projective<Dual<NT>> x;
  for (std::size_t i = 0; i < 4; ++i) x[i] = v0 * (t.p[i] * u0 + t.d2[i] * u1) + v1 * (t.d1[i] * u0 + t.q[i] * u1);
  return x;
}

Projective<Dual<long double>> Quartic_loop::at(const Dual<long double>& c, const Dual<long double>& s) const {
  return evaluate(rounded_, c, s);
}

Projective<Dual<Real>> Quartic_loop::at(const Dual<Real>& c, const Dual<Real>& s) const {
  return evaluate(exact_, c, s);
}

std::vector<Direction> Quartic_loop::meets_plane(const Projective<Real>& plane) const {
  const Ruled_section<Real>& s = exact_.section;
  const Plane_on_rulings on = on_rulings(s, plane);
  // v = (g, -f) is on the curve.
  Form w = times(form(s.a), times(on.g, on.g));
  w = minus(w, times(form(s.b), times(on.f, on.g)), 2);
  w = minus(w, times(form(s.c), times(on.f, on.f)), -1);
  std::vector<Direction> parameters;
  for (const Direction& u : approximate_real_roots(w)) {
    const int sheet = sheet_in_plane(s, plane, u) < 0 ? -1 : 1;
    for (const Direction& at : parameter_of(u, sheet)) parameters.push_back(at);
  }
  return parameters;
}

bool Quartic_loop::is_between(const Direction& u) const {
  if (sheet_ != 0) return true;
  const Real tiny("1e-50");  // u may be an end of the interval
  const Real from_begin = bracket({exact_.begin[0], exact_.begin[1]}, u),
             to_end = bracket(u, {exact_.end[0], exact_.end[1]});
  return abs(from_begin) < tiny || abs(to_end) < tiny || (from_begin > 0) == (to_end > 0);
}

std::vector<Direction> Quartic_loop::parameter_of(const Direction& u, int sheet) const {
  if (sheet_ != 0) {
    if (sheet != sheet_) return {};
    return {{u.c, (u.s - exact_.begin[1] * u.c) / exact_.end[1]}};
  }
  const Direction begin{exact_.begin[0], exact_.begin[1]}, end{exact_.end[0], exact_.end[1]};
  Real from_begin = bracket(begin, u), to_end = bracket(u, end);
  if (sheet == 0)
    return abs(from_begin) < abs(to_end) ? std::vector<Direction>{{1, 0}} : std::vector<Direction>{{0, 1}};
  if (from_begin < 0 && to_end < 0) from_begin = -from_begin, to_end = -to_end;
  if (from_begin < 0 || to_end < 0) return {};
  return {{sqrt(to_end), sheet * sqrt(from_begin)}};
}

}  // namespace cgal_blend
