// SPDX-License-Identifier: GPL-3.0-or-later
#include "quadric_matrix.h"

#include <CGAL/Gmpz.h>
#include <CGAL/number_utils.h>

namespace cgal_blend {

void make_primitive(Surd_matrix& m) {
  CGAL::Gmpz factor(0), denominator(1);
  for (const Surd_vector& row : m)
    for (const Surd& a : row) {
      const CGAL::Gmpz part = a.rational().denominator();
      denominator = denominator / CGAL::gcd(denominator, part) * part;
    }
  for (const Surd_vector& row : m)
    for (const Surd& a : row) factor = CGAL::gcd(factor, Rational(a.rational() * Rational(denominator)).numerator());
  const Rational scale(denominator, CGAL::abs(factor));
  for (Surd_vector& row : m) row = scaled(row, Surd(scale));
}

Surd_matrix quadric_matrix(const Quadric_3& quadric) {
  const Quadric_3::Coefficients& c = quadric.coefficients();
  const auto entry = [&](std::size_t k) { return Surd(c[k]); };
  const auto twice = [&](std::size_t k) { return Surd(Rational(2 * c[k])); };
  Surd_matrix m{{twice(0), entry(3), entry(4), entry(6)},
                {entry(3), twice(1), entry(5), entry(7)},
                {entry(4), entry(5), twice(2), entry(8)},
                {entry(6), entry(7), entry(8), twice(9)}};
  make_primitive(m);
  return m;
}

Quadric_3::Coefficients coefficients_of(const Surd_matrix& m) {
  const auto once = [&](std::size_t i) { return m[i][i].rational(); };
  const auto twice = [&](std::size_t i, std::size_t j) { return Rational(2 * m[i][j].rational()); };
  return {once(0),     once(1),     once(2),     twice(0, 1), twice(0, 2),
          twice(1, 2), twice(0, 3), twice(1, 3), twice(2, 3), once(3)};
}

}  // namespace cgal_blend
