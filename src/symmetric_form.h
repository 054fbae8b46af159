// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SYMMETRIC_FORM_H
#define CGAL_BLEND_SYMMETRIC_FORM_H

#include "binary_form.h"

#include <vector>

namespace cgal_blend {

using Surd_vector = std::vector<Surd>;
/// Symmetric matrix of a quadratic form, or any basis, as a list of rows or of vectors.
using Surd_matrix = std::vector<Surd_vector>;

// `sum`, `scaled` and `is_zero` of binary forms serve vectors too.
[[nodiscard]] Surd dot(const Surd_vector& x, const Surd_vector& y);
[[nodiscard]] Surd_vector product(const Surd_matrix& m, const Surd_vector& x);
[[nodiscard]] Surd bilinear(const Surd_matrix& m, const Surd_vector& x, const Surd_vector& y);
/// Returns f m + g n.
[[nodiscard]] Surd_matrix combination(const Surd& f, const Surd_matrix& m, const Surd& g, const Surd_matrix& n);
/// Returns the form in the coordinates of a basis of a subspace: entries m(basis[i], basis[j]).
[[nodiscard]] Surd_matrix restricted(const Surd_matrix& m, const Surd_matrix& basis);
/// Returns the vector with coordinates `x` in a basis.
[[nodiscard]] Surd_vector in_space(const Surd_matrix& basis, const Surd_vector& x);
/// Returns the `n` coordinate vectors.
[[nodiscard]] Surd_matrix identity(std::size_t n);

/// A basis in which a quadratic form is diagonal, the zeros last.
struct Diagonal_form {
  Surd_matrix basis;     ///< vectors
  Surd_vector diagonal;  ///< the form's values at them
  std::size_t rank = 0, positive = 0, negative = 0;

  /// Returns the vectors that span the kernel.
  [[nodiscard]] Surd_matrix kernel() const { return {basis.begin() + static_cast<std::ptrdiff_t>(rank), basis.end()}; }
  [[nodiscard]] bool is_definite() const { return rank == basis.size() && (positive == 0 || negative == 0); }
};

/// Diagonalizes by Lagrange's reduction, in the field of the entries.
[[nodiscard]] Diagonal_form diagonalize(const Surd_matrix& m);

/// Returns vectors that span the orthogonal complement of `rows`, in the field of the entries.
[[nodiscard]] Surd_matrix kernel(Surd_matrix rows, std::size_t dimension);

/// Returns coordinate vectors that complete independent vectors to a basis.
[[nodiscard]] Surd_matrix complement(const Surd_matrix& vectors, std::size_t dimension);

}  // namespace cgal_blend

#endif
