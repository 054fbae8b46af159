// SPDX-License-Identifier: GPL-3.0-or-later
#include "symmetric_form.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace cgal_blend {

Surd_vector product(const Surd_matrix& m, const Surd_vector& x) {
  Surd_vector y;
  for (const Surd_vector& row : m) y.push_back(dot(row, x));
  return y;
}

Surd dot(const Surd_vector& x, const Surd_vector& y) {
  Surd sum;
  for (std::size_t i = 0; i < x.size(); ++i) sum += x[i] * y[i];
  return sum;
}

Surd bilinear(const Surd_matrix& m, const Surd_vector& x, const Surd_vector& y) { return dot(x, product(m, y)); }

Surd_matrix combination(const Surd& f, const Surd_matrix& m, const Surd& g, const Surd_matrix& n) {
  Surd_matrix result;
  for (std::size_t i = 0; i < m.size(); ++i) result.push_back(sum(scaled(m[i], f), scaled(n[i], g)));
  return result;
}

Surd_matrix restricted(const Surd_matrix& m, const Surd_matrix& basis) {
  Surd_matrix result(basis.size(), Surd_vector(basis.size()));
  for (std::size_t j = 0; j < basis.size(); ++j) {
    const Surd_vector image = product(m, basis[j]);
    for (std::size_t i = 0; i <= j; ++i) result[i][j] = result[j][i] = dot(basis[i], image);
  }
  return result;
}

Surd_vector in_space(const Surd_matrix& basis, const Surd_vector& x) {
  Surd_vector y(basis.front().size());
  for (std::size_t i = 0; i < basis.size(); ++i) y = sum(y, scaled(basis[i], x[i]));
  return y;
}

Surd_matrix identity(std::size_t n) {
  Surd_matrix result(n, Surd_vector(n));
  for (std::size_t i = 0; i < n; ++i) result[i][i] = 1;
  return result;
}

namespace {

// The state of Lagrange's reduction: the form in the basis found so far.
struct Reduction {
  Surd_matrix m, basis;

  void swap(std::size_t i, std::size_t j) {
    if (i == j) return;
    std::swap(m[i], m[j]);
    for (Surd_vector& row : m) std::swap(row[i], row[j]);
    std::swap(basis[i], basis[j]);
  }

  // Adds `factor` times the vector i to the vector k.
  void add(std::size_t i, std::size_t k, const Surd& factor) {
    basis[k] = sum(basis[k], scaled(basis[i], factor));
    m[k] = sum(m[k], scaled(m[i], factor));
    for (Surd_vector& row : m) row[k] += factor * row[i];
  }

  // Brings a vector on which the form does not vanish to place i; false if it vanishes on all that are left.
  bool find_pivot(std::size_t i) {
    for (std::size_t j = i; j < m.size(); ++j)
      if (!m[j][j].is_zero()) {
        swap(i, j);
        return true;
      }
    for (std::size_t j = i; j < m.size(); ++j)
      for (std::size_t k = j + 1; k < m.size(); ++k)
        if (!m[j][k].is_zero()) {
          add(k, j, 1);
          swap(i, j);
          return true;
        }
    return false;
  }
};

// Column of the first entry that is not zero, if any.
std::optional<std::size_t> leading(const Surd_vector& row) {
  const auto found = std::find_if(row.begin(), row.end(), [](const Surd& a) { return !a.is_zero(); });
  if (found == row.end()) return std::nullopt;
  return static_cast<std::size_t>(found - row.begin());
}

// Reduced row echelon form without zero rows; returns the leading columns.
std::vector<std::size_t> reduce(Surd_matrix& rows) {
  std::vector<std::size_t> columns;
  Surd_matrix reduced;
  for (Surd_vector row : rows) {
    for (std::size_t i = 0; i < reduced.size(); ++i) row = sum(row, scaled(reduced[i], -row[columns[i]]));
    const auto column = leading(row);
    if (!column) continue;
    row = scaled(row, Surd(1) / row[*column]);
    for (Surd_vector& other : reduced) other = sum(other, scaled(row, -other[*column]));
    reduced.push_back(row);
    columns.push_back(*column);
  }
  rows = std::move(reduced);
  return columns;
}

}  // namespace

Diagonal_form diagonalize(const Surd_matrix& m) {
  Reduction state{m, identity(m.size())};
  Diagonal_form result;
  while (result.rank < m.size() && state.find_pivot(result.rank)) {
    const std::size_t i = result.rank++;
    const Surd pivot = state.m[i][i];
    (pivot.sign() > 0 ? result.positive : result.negative) += 1;
    for (std::size_t k = i + 1; k < m.size(); ++k)
      if (!state.m[i][k].is_zero()) state.add(i, k, -state.m[i][k] / pivot);
  }
  for (std::size_t i = 0; i < m.size(); ++i) result.diagonal.push_back(i < result.rank ? state.m[i][i] : Surd());
  result.basis = std::move(state.basis);
  return result;
}

Surd_matrix kernel(Surd_matrix rows, std::size_t dimension) {
  const std::vector<std::size_t> columns = reduce(rows);
  Surd_matrix result;
  for (std::size_t free = 0; free < dimension; ++free) {
    if (std::find(columns.begin(), columns.end(), free) != columns.end()) continue;
    Surd_vector x(dimension);
    x[free] = 1;
    for (std::size_t i = 0; i < rows.size(); ++i) x[columns[i]] = -rows[i][free];
    result.push_back(x);
  }
  return result;
}

Surd_matrix complement(const Surd_matrix& vectors, std::size_t dimension) {
  Surd_matrix rows = vectors;
  const std::vector<std::size_t> columns = reduce(rows);
  Surd_matrix result;
  for (std::size_t i = 0; i < dimension; ++i)
    if (std::find(columns.begin(), columns.end(), i) == columns.end()) result.push_back(identity(dimension)[i]);
  return result;
}

}  // namespace cgal_blend
