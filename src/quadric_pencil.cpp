// SPDX-License-Identifier: GPL-3.0-or-later
#include "quadric_pencil.h"

#include <CGAL/assertions.h>

#include <array>
#include <optional>

namespace cgal_blend {

namespace {

using Form_matrix = std::vector<std::vector<Binary_form>>;  // entries of one degree

Form_matrix without(const Form_matrix& m, std::size_t row, std::size_t column) {
  Form_matrix minor;
  for (std::size_t i = 0; i < m.size(); ++i) {
    if (i == row) continue;
    minor.emplace_back();
    for (std::size_t j = 0; j < m.size(); ++j)
      if (j != column) minor.back().push_back(m[i][j]);
  }
  return minor;
}

// Laplace's expansion by the first row.
Binary_form determinant(const Form_matrix& m) {
  if (m.size() == 1) return m[0][0];
  std::optional<Binary_form> result;
  for (std::size_t j = 0; j < m.size(); ++j) {
    const Binary_form term = scaled(product(m[0][j], determinant(without(m, 0, j))), j % 2 == 0 ? 1 : -1);
    result = result ? sum(*result, term) : term;
  }
  return *result;
}

Form_matrix members(const Surd_matrix& a, const Surd_matrix& b) {
  Form_matrix m(a.size(), std::vector<Binary_form>(a.size()));
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < a.size(); ++j) m[i][j] = {a[i][j], -b[i][j]};
  return m;
}

Binary_form common_factor_of_minors(const Form_matrix& m) {
  Binary_form common(m.size());
  for (std::size_t i = 0; i < m.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      const Binary_form minor = determinant(without(m, i, j));
      if (!is_zero(minor)) common = is_zero(common) ? minor : common_factor(common, minor);
      if (common.size() == 1) return common;
    }
  return common;
}

// Where members are singular, in how many ways; counted at the root with multiplicity m, as a symbol without commas.
std::string blocks(int multiplicity, std::size_t corank, std::size_t degree_of_minors) {
  if (corank == 1) return std::to_string(multiplicity);
  if (multiplicity == 2) return "(11)";
  if (multiplicity == 3) return corank == 2 ? "(21)" : "(111)";
  if (corank == 2) return degree_of_minors == 1 ? "(31)" : "(22)";
  return corank == 3 ? "(211)" : "(1111)";
}

std::size_t degree(const Binary_form& f) { return f.size() - 1; }

}  // namespace

Surd_matrix member(const Surd_matrix& a, const Surd_matrix& b, const Surd& c, const Surd& s) {
  return combination(c, a, -s, b);
}

bool are_proportional(const Surd_matrix& a, const Surd_matrix& b) {
  std::optional<std::pair<Surd, Surd>> ratio;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      if (!ratio && !(a[i][j].is_zero() && b[i][j].is_zero())) ratio = {a[i][j], b[i][j]};
      if (ratio && !(a[i][j] * ratio->second - b[i][j] * ratio->first).is_zero()) return false;
    }
  return true;
}

Binary_form pencil_determinant(const Surd_matrix& a, const Surd_matrix& b) { return determinant(members(a, b)); }

Form_pencil make_pencil(const Surd_matrix& a, const Surd_matrix& b) {
  // Of these members, more than there are roots, one has the largest rank; a and it span the pencil.
  constexpr std::array<std::array<int, 2>, 6> choices{{{0, -1}, {1, -1}, {1, 1}, {2, -1}, {1, -2}, {2, 1}}};
  Form_pencil pencil;
  pencil.a = a;
  std::size_t largest = 0;
  for (const auto& [c, s] : choices) {
    const Surd_matrix choice = member(a, b, c, s);
    const std::size_t rank = diagonalize(choice).rank;
    if (rank <= largest) continue;
    largest = rank;
    pencil.b = choice;
    if (rank == a.size()) break;
  }
  pencil.determinant = pencil_determinant(pencil.a, pencil.b);
  if (!is_zero(pencil.determinant)) pencil.factors = squarefree_factors(pencil.determinant);
  const bool is_simple = pencil.factors.size() == 1;
  pencil.corank_2 = is_simple ? Binary_form{Surd(1)} : common_factor_of_minors(members(pencil.a, pencil.b));
  return pencil;
}

std::string segre_symbol(const Form_pencil& pencil) {
  CGAL_precondition(!pencil.factors.empty());
  std::string multiple, grouped;  // roots with one block, with several
  for (std::size_t i = pencil.factors.size(); i-- > 1;) {
    const Binary_form& factor = pencil.factors[i];
    if (degree(factor) == 0) continue;
    const Binary_form shared = common_factor(factor, pencil.corank_2);
    for (std::size_t k = 0; k < degree(factor) - degree(shared); ++k) multiple += std::to_string(i + 1);
    if (degree(shared) == 0) continue;
    const std::size_t rank =
        degree(shared) > 1 ? pencil.a.size() - 2 : diagonalize(member(pencil.a, pencil.b, shared[1], -shared[0])).rank;
    for (std::size_t k = 0; k < degree(shared); ++k)
      grouped += blocks(static_cast<int>(i) + 1, pencil.a.size() - rank, degree(pencil.corank_2));
  }
  return "[" + multiple + grouped + std::string(degree(pencil.factors[0]), '1') + "]";
}

std::vector<std::pair<Surd, Surd>> exact_roots(const Binary_form& f) {
  if (f.size() == 2) return {{f[1], -f[0]}};
  CGAL_precondition(f.size() == 3 && !is_zero(f));
  if (f[0].is_zero() && f[2].is_zero()) return {{1, 0}, {0, 1}};
  if (f[2].is_zero()) {  // c (f0 c + f1 s)
    if (f[1].is_zero()) return {{0, 1}};
    return {{0, 1}, {f[1], -f[0]}};
  }
  const Surd discriminant = f[1] * f[1] - Surd(4) * f[0] * f[2];
  if (discriminant.sign() < 0) return {};
  const Surd twice = f[2] + f[2];
  if (discriminant.is_zero()) return {{twice, -f[1]}};
  const Surd root = sqrt(discriminant);
  return {{twice, -f[1] - root}, {twice, root - f[1]}};
}

}  // namespace cgal_blend
