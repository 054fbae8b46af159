// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_BINARY_FORM_H
#define CGAL_BLEND_BINARY_FORM_H

#include "surd.h"

#include <utility>
#include <vector>

namespace cgal_blend {

/// Homogeneous polynomial of degree n in (c, s): n + 1 coefficients, the k-th that of c^(n - k) s^k.
using Binary_form = std::vector<Surd>;

/// Point of the projective line, with c > 0, or c = 0 and s > 0.
struct Direction {
  Real c, s;
};

struct Form_root {
  Direction at;
  int multiplicity;
};

[[nodiscard]] bool is_zero(const Binary_form& f);
/// Both of one degree.
[[nodiscard]] Binary_form sum(const Binary_form& f, const Binary_form& g);
[[nodiscard]] Binary_form product(const Binary_form& f, const Binary_form& g);
[[nodiscard]] Binary_form scaled(const Binary_form& f, const Surd& factor);
/// Returns the common factor of highest degree; not both may be zero.
[[nodiscard]] Binary_form common_factor(const Binary_form& f, const Binary_form& g);
/// Returns f / g, where g divides f.
[[nodiscard]] Binary_form quotient(const Binary_form& f, const Binary_form& g);
/// Returns pairwise coprime factors without multiple roots, the i-th having those of multiplicity i + 1; each is unique up
/// to a constant, and one of degree 0 where there are none. The form must not be zero.
[[nodiscard]] std::vector<Binary_form> squarefree_factors(const Binary_form& f);

[[nodiscard]] std::vector<Real> to_real(const Binary_form& f);
[[nodiscard]] Real value(const std::vector<Real>& f, const Direction& at);

/// Returns the real roots, ascending by angle in (-90, 90] degrees, with their multiplicities. Which are real, distinct
/// or multiple is decided exactly; positions are right to 1e-100. The form must not be zero.
[[nodiscard]] std::vector<Form_root> real_roots(const Binary_form& f);

/// Returns the real roots as far as numbers of this precision tell; for places, not for decisions.
[[nodiscard]] std::vector<Direction> approximate_real_roots(const std::vector<Real>& f);

}  // namespace cgal_blend

#endif
