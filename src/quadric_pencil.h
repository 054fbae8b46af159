// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_QUADRIC_PENCIL_H
#define CGAL_BLEND_QUADRIC_PENCIL_H

#include "symmetric_form.h"

#include <string>
#include <utility>
#include <vector>

namespace cgal_blend {

/// The members c a - s b of a pencil of quadratic forms in `n` variables, and where they are singular.
struct Form_pencil {
  Surd_matrix a, b;                  ///< rational; b has the largest rank of all members
  Binary_form determinant;           ///< of c a - s b; all zero if every member is singular
  std::vector<Binary_form> factors;  ///< of the determinant, by multiplicity; none if that is zero
  Binary_form corank_2;              ///< the largest common factor of all minors of size n - 1
};

/// Returns the pencil that two rational forms span; they must not be proportional.
[[nodiscard]] Form_pencil make_pencil(const Surd_matrix& a, const Surd_matrix& b);

/// Returns the form c a - s b.
[[nodiscard]] Surd_matrix member(const Surd_matrix& a, const Surd_matrix& b, const Surd& c, const Surd& s);

[[nodiscard]] bool are_proportional(const Surd_matrix& a, const Surd_matrix& b);

/// Returns the Segre symbol, e.g. "[(11)11]", of a pencil with members of full rank.
[[nodiscard]] std::string segre_symbol(const Form_pencil& pencil);

/// Returns the determinant of c a - s b as a binary form.
[[nodiscard]] Binary_form pencil_determinant(const Surd_matrix& a, const Surd_matrix& b);

/// Returns the root of a linear form, or the real roots of a quadratic one, as pairs (c, s); a double root once.
[[nodiscard]] std::vector<std::pair<Surd, Surd>> exact_roots(const Binary_form& f);

}  // namespace cgal_blend

#endif
