// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_REAL_H
#define CGAL_BLEND_REAL_H

#include <CGAL/Gmpq.h>
#include <boost/multiprecision/mpfr.hpp>

namespace cgal_blend {

using Rational = CGAL::Gmpq;

/// Floating-point number of 120 decimal digits, on the stack. What is known to be nonzero exactly gets its sign here;
/// near-degenerate input given in doubles (differences of 1e-16, squared and cubed on the way) leaves digits to spare.
using Real =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<120, boost::multiprecision::allocate_stack>,
                                  boost::multiprecision::et_off>;

/// Returns the number rounded to nearest.
[[nodiscard]] inline Real to_real(const Rational& x) {
  Real result;
  mpfr_set_q(result.backend().data(), x.mpq(), MPFR_RNDN);
  return result;
}

/// Returns the rational number of `bits` >= 1 significant bits nearest to `x`.
[[nodiscard]] inline Rational round_to_bits(const Real& x, int bits) {
  mpfr_t rounded;
  mpfr_init2(rounded, bits);
  mpfr_set(rounded, x.backend().data(), MPFR_RNDN);
  Rational result;
  mpq_t exact;
  mpq_init(exact);
  mpfr_get_q(exact, rounded);
  result = Rational(exact);
  mpq_clear(exact);
  mpfr_clear(rounded);
  return result;
}

}  // namespace cgal_blend

#endif
