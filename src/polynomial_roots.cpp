// SPDX-License-Identifier: GPL-3.0-or-later
#include "polynomial_roots.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace cgal_blend {

namespace {

const Real rounding("1e-116");    // of the coefficients and of one evaluation, relative to the sum of absolute terms
const Real well_found("1e-105");  // a step this small, relative to the root, ends the iteration
constexpr int most_steps_in_double = 200;
constexpr int few_steps = 8, many_steps = 1000;

template <class NT>
struct Complex {
  NT re = 0, im = 0;

  friend Complex operator+(const Complex& x, const Complex& y) { return {x.re + y.re, x.im + y.im}; }
  friend Complex operator-(const Complex& x, const Complex& y) { return {x.re - y.re, x.im - y.im}; }
  friend Complex operator*(const Complex& x, const Complex& y) {
    return {x.re * y.re - x.im * y.im, x.re * y.im + x.im * y.re};
  }
  friend Complex operator/(const Complex& x, const Complex& y) {
    const NT n = y.re * y.re + y.im * y.im;
    return {(x.re * y.re + x.im * y.im) / n, (x.im * y.re - x.re * y.im) / n};
  }
  [[nodiscard]] NT squared() const { return re * re + im * im; }
};

// Value and derivative by Horner's scheme.
template <class NT>
std::pair<Complex<NT>, Complex<NT>> evaluate(const std::vector<NT>& p, const Complex<NT>& z) {
  Complex<NT> f{p.back(), 0}, d;
  for (std::size_t k = p.size() - 1; k-- > 0;) {
    d = d * z + f;
    f = f * z + Complex<NT>{p[k], 0};
  }
  return {f, d};
}

// One step of Aberth's iteration for all roots; returns the largest relative step, squared.
template <class NT>
NT improve(const std::vector<NT>& p, std::vector<Complex<NT>>& z) {
  NT largest = 0;
  for (std::size_t i = 0; i < z.size(); ++i) {
    const auto [f, d] = evaluate(p, z[i]);
    if (f.squared() == 0) continue;
    Complex<NT> others;
    for (std::size_t j = 0; j < z.size(); ++j) {
      const Complex<NT> gap = z[i] - z[j];
      if (j != i && gap.squared() != 0) others = others + Complex<NT>{1, 0} / gap;
    }
    const Complex<NT> denominator = d - f * others;
    if (denominator.squared() == 0) continue;
    const Complex<NT> step = f / denominator;
    z[i] = z[i] - step;
    const NT size = z[i].squared();
    if (size > 0) largest = std::max<NT>(largest, step.squared() / size);
  }
  return largest;
}

// Starts on a circle that encloses the roots' geometric mean; the angles are in no symmetry with conjugation.
std::vector<Complex<long double>> first_guesses(const std::vector<long double>& p) {
  const std::size_t n = p.size() - 1;
  const long double mean = p[0] == 0 ? 1 : std::pow(std::abs(p[0] / p[n]), 1.0L / static_cast<long double>(n));
  std::vector<Complex<long double>> z;
  for (std::size_t k = 0; k < n; ++k) {
    const long double angle = 0.7L + 6.2831853L * static_cast<long double>(k) / static_cast<long double>(n);
    z.push_back({mean * std::cos(angle), mean * std::sin(angle)});
  }
  return z;
}

std::vector<Complex<Real>> find(const std::vector<Real>& p, int most_steps) {
  Real largest = 0;
  for (const Real& a : p) largest = std::max<Real>(largest, abs(a));
  std::vector<long double> rough;
  for (const Real& a : p) rough.push_back(static_cast<long double>(Real(a / largest)));
  std::vector<Complex<Real>> z;
  std::vector<Complex<long double>> guesses = first_guesses(rough);
  for (int k = 0; k < most_steps_in_double && improve(rough, guesses) > 1e-32L; ++k) {
  }
  for (const Complex<long double>& guess : guesses) {
    const bool finite = std::isfinite(guess.re) && std::isfinite(guess.im);
    z.push_back(
        {finite ? Real(guess.re) : Real(static_cast<double>(z.size()) + 0.5), finite ? Real(guess.im) : Real(1)});
  }
  const Real enough = well_found * well_found;
  for (int k = 0; k < most_steps && improve(p, z) > enough; ++k) {
  }
  return z;
}

Real radius_of_disk(const std::vector<Real>& p, const std::vector<Complex<Real>>& z, std::size_t i) {
  const Real size = sqrt(z[i].squared());
  Real terms = 0;
  for (std::size_t k = p.size(); k-- > 0;) terms = terms * size + abs(p[k]);
  Real denominator = abs(p.back());
  for (std::size_t j = 0; j < z.size(); ++j)
    if (j != i) denominator *= sqrt((z[i] - z[j]).squared());
  const Real numerator = sqrt(evaluate(p, z[i]).first.squared()) + rounding * terms;
  return static_cast<double>(z.size()) * numerator / denominator;  // infinite where two approximations coincide
}

}  // namespace

std::vector<Complex_root> complex_roots(const std::vector<Real>& p, Patience patience) {
  if (p.size() < 2) return {};
  const std::vector<Complex<Real>> z = find(p, patience == Patience::brief ? few_steps : many_steps);
  std::vector<Complex_root> roots;
  for (std::size_t i = 0; i < z.size(); ++i) roots.push_back({z[i].re, z[i].im, radius_of_disk(p, z, i)});
  return roots;
}

std::optional<std::vector<Real>> certified_real_roots(const std::vector<Real>& p, Patience patience) {
  const std::vector<Complex_root> roots = complex_roots(p, patience);
  std::vector<Real> real;
  for (std::size_t i = 0; i < roots.size(); ++i) {
    // A disk of three times the radius also holds the mirror image of any disk that meets the real axis: apart from all
    // others it has one root, which is real if the disk meets the axis, for its conjugate has no other place.
    for (std::size_t j = 0; j < roots.size(); ++j) {
      const Complex<Real> gap{roots[i].re - roots[j].re, roots[i].im - roots[j].im};
      const Real reach = 3 * (roots[i].radius + roots[j].radius);
      if (j != i && !(gap.squared() > reach * reach)) return std::nullopt;
    }
    if (abs(roots[i].im) <= roots[i].radius) real.push_back(roots[i].re);
  }
  std::sort(real.begin(), real.end());
  return real;
}

}  // namespace cgal_blend
