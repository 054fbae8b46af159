// SPDX-License-Identifier: GPL-3.0-or-later
#include "binary_form.h"

#include "polynomial_roots.h"

#include <CGAL/assertions.h>

#include <algorithm>
#include <stdexcept>

namespace cgal_blend {

namespace {

// A form as a polynomial in s (c = 1), ascending, without leading zeros, and the multiplicity of the root c = 0.
struct Affine {
  Binary_form p;
  std::size_t at_infinity = 0;
};

Affine dehomogenize(const Binary_form& f) {
  Affine result{f, 0};
  while (!result.p.empty() && result.p.back().is_zero()) {
    result.p.pop_back();
    ++result.at_infinity;
  }
  return result;
}

Binary_form homogenize(Binary_form p, std::size_t at_infinity) {
  p.resize(p.size() + at_infinity);
  return p;
}

void make_monic(Binary_form& p) {
  const Surd factor = Surd(1) / p.back();
  for (Surd& a : p) a = a * factor;
}

// Polynomial division with remainder; g has no leading zeros.
std::pair<Binary_form, Binary_form> divide(Binary_form f, const Binary_form& g) {
  Binary_form q(f.size() >= g.size() ? f.size() - g.size() + 1 : 1);
  while (f.size() >= g.size()) {
    const std::size_t shift = f.size() - g.size();
    q[shift] = f.back() / g.back();
    for (std::size_t k = 0; k + 1 < g.size(); ++k) f[k + shift] -= q[shift] * g[k];
    f.pop_back();
  }
  return {q, dehomogenize(f).p};
}

Binary_form gcd(Binary_form f, Binary_form g) {
  while (!g.empty()) {
    make_monic(g);
    Binary_form r = divide(f, g).second;
    f = std::move(g);
    g = std::move(r);
  }
  make_monic(f);
  return f;
}

Binary_form derivative(const Binary_form& p) {
  Binary_form d;
  for (std::size_t k = 1; k < p.size(); ++k) d.push_back(p[k] * Surd(static_cast<int>(k)));
  return d;
}

Binary_form minus(Binary_form f, const Binary_form& g) {
  f.resize(std::max(f.size(), g.size()));
  for (std::size_t k = 0; k < g.size(); ++k) f[k] -= g[k];
  return dehomogenize(f).p;
}

// Yun's algorithm; p has no leading zeros and a degree above 0.
std::vector<Binary_form> squarefree(const Binary_form& p) {
  const Binary_form d = derivative(p), g = gcd(p, d);
  Binary_form b = divide(p, g).first;
  Binary_form rest = minus(divide(d, g).first, derivative(b));
  std::vector<Binary_form> factors;
  while (b.size() > 1) {
    const Binary_form a = gcd(b, rest);
    factors.push_back(a);
    b = divide(b, a).first;
    rest = minus(rest.empty() ? rest : divide(rest, a).first, derivative(b));
  }
  return factors;
}

// Real roots of a quadratic polynomial, by the exact sign of its discriminant.
std::vector<std::pair<Real, int>> quadratic_roots(const Binary_form& p) {
  const Surd discriminant = p[1] * p[1] - Surd(4) * p[0] * p[2];
  const int sign = discriminant.sign();
  const Real a = p[2].to_real(), b = p[1].to_real();
  if (sign < 0) return {};
  if (sign == 0) return {{-b / (2 * a), 2}};
  const Real root = sqrt(discriminant.to_real());
  const Real q = b < 0 ? Real(root - b) / 2 : Real(-root - b) / 2;
  std::vector<std::pair<Real, int>> roots{{q / a, 1}, {p[0].to_real() / q, 1}};
  std::sort(roots.begin(), roots.end());
  return roots;
}

std::vector<std::pair<Real, int>> roots_by_factors(const Binary_form& p) {
  const std::vector<Binary_form> factors = squarefree(p);
  std::vector<std::pair<Real, int>> roots;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    if (factors[i].size() < 2) continue;
    const int multiplicity = static_cast<int>(i) + 1;
    if (factors[i].size() == 3) {
      for (const auto& root : quadratic_roots(factors[i])) roots.emplace_back(root.first, multiplicity);
      continue;
    }
    const auto found = certified_real_roots(to_real(factors[i]), Patience::long_enough);
    if (!found) throw std::range_error("the roots of a polynomial are too close to each other");
    for (const Real& root : *found) roots.emplace_back(root, multiplicity);
  }
  std::sort(roots.begin(), roots.end());
  return roots;
}

std::vector<std::pair<Real, int>> affine_roots(Binary_form p) {
  int at_zero = 0;  // these roots are taken out: approximations near 0 are never relatively good
  while (p.size() > 1 && p.front().is_zero()) {
    p.erase(p.begin());
    ++at_zero;
  }
  std::vector<std::pair<Real, int>> roots;
  if (p.size() == 2) {
    roots.emplace_back(-p[0].to_real() / p[1].to_real(), 1);
  } else if (p.size() == 3) {
    roots = quadratic_roots(p);
  } else if (p.size() > 3) {
    if (const auto simple = certified_real_roots(to_real(p), Patience::brief))
      for (const Real& root : *simple) roots.emplace_back(root, 1);
    else
      roots = roots_by_factors(p);
  }
  if (at_zero > 0) roots.emplace_back(0, at_zero);
  std::sort(roots.begin(), roots.end());
  return roots;
}

Direction direction_at(const Real& t) {
  if (abs(t) <= 1) return {1, t};
  return t > 0 ? Direction{1 / t, 1} : Direction{-1 / t, -1};
}

}  // namespace

bool is_zero(const Binary_form& f) {
  return std::all_of(f.begin(), f.end(), [](const Surd& a) { return a.is_zero(); });
}

Binary_form sum(const Binary_form& f, const Binary_form& g) {
  CGAL_precondition(f.size() == g.size());
  Binary_form h = f;
  for (std::size_t k = 0; k < g.size(); ++k) h[k] += g[k];
  return h;
}

Binary_form product(const Binary_form& f, const Binary_form& g) {
  Binary_form h(f.size() + g.size() - 1);
  for (std::size_t i = 0; i < f.size(); ++i)
    for (std::size_t k = 0; k < g.size(); ++k) h[i + k] += f[i] * g[k];
  return h;
}

Binary_form scaled(const Binary_form& f, const Surd& factor) {
  Binary_form h = f;
  for (Surd& a : h) a = a * factor;
  return h;
}

Binary_form common_factor(const Binary_form& f, const Binary_form& g) {
  if (is_zero(f)) return g;
  if (is_zero(g)) return f;
  const Affine a = dehomogenize(f), b = dehomogenize(g);
  return homogenize(gcd(a.p, b.p), std::min(a.at_infinity, b.at_infinity));
}

Binary_form quotient(const Binary_form& f, const Binary_form& g) {
  if (is_zero(f)) return Binary_form(f.size() - g.size() + 1);
  const Affine a = dehomogenize(f), b = dehomogenize(g);
  return homogenize(divide(a.p, b.p).first, a.at_infinity - b.at_infinity);
}

std::vector<Binary_form> squarefree_factors(const Binary_form& f) {
  CGAL_precondition(!is_zero(f));
  const Affine a = dehomogenize(f);
  std::vector<Binary_form> factors;
  if (a.p.size() > 1)
    factors = certified_real_roots(to_real(a.p), Patience::brief) ? std::vector<Binary_form>{a.p} : squarefree(a.p);
  if (a.at_infinity == 0) return factors;
  factors.resize(std::max(factors.size(), a.at_infinity), Binary_form{Surd(1)});
  factors[a.at_infinity - 1].resize(factors[a.at_infinity - 1].size() + 1);
  return factors;
}

std::vector<Real> to_real(const Binary_form& f) {
  std::vector<Real> result;
  for (const Surd& a : f) result.push_back(a.to_real());
  return result;
}

Real value(const std::vector<Real>& f, const Direction& at) {
  Real sum = 0, power = 1;
  for (std::size_t k = f.size(); k-- > 0;) {
    Real term = f[k] * power;  // c^(n - k) so far
    for (std::size_t i = 0; i < k; ++i) term *= at.s;
    sum += term;
    power *= at.c;
  }
  return sum;
}

std::vector<Form_root> real_roots(const Binary_form& f) {
  const Affine a = dehomogenize(f);
  CGAL_precondition(!a.p.empty());
  std::vector<Form_root> roots;
  for (const auto& [t, multiplicity] : affine_roots(a.p)) roots.push_back({direction_at(t), multiplicity});
  if (a.at_infinity > 0) roots.push_back({{0, 1}, static_cast<int>(a.at_infinity)});
  return roots;
}

std::vector<Direction> approximate_real_roots(const std::vector<Real>& f) {
  std::vector<Real> p = f;
  std::vector<Direction> roots;
  while (!p.empty() && p.back() == 0) p.pop_back();
  if (p.empty()) return {};
  if (p.size() < f.size()) roots.push_back({0, 1});
  const Real near_axis("1e-30");
  for (const Complex_root& z : complex_roots(p))
    if (abs(z.im) <= near_axis * (1 + abs(z.re))) roots.push_back(direction_at(z.re));
  return roots;
}

}  // namespace cgal_blend
