// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_POLYNOMIAL_ROOTS_H
#define CGAL_BLEND_POLYNOMIAL_ROOTS_H

#include "real.h"

#include <optional>
#include <vector>

namespace cgal_blend {

/// Root of a polynomial, real part and imaginary part, with the radius of a disk around it.
struct Complex_root {
  Real re, im, radius;
};

/// How long to look: a few steps suffice for roots that are well apart, multiple roots are never found well.
enum class Patience { brief, long_enough };

/// Returns approximations of all complex roots, with inclusion disks.
/// \param p coefficients, ascending, the last not zero, each with a relative error below 1e-110
/// Source: O. Aberth, Iteration methods for finding all zeros of a polynomial simultaneously, Math. Comp. 27 (1973);
/// disks: B. T. Smith, Error bounds for zeros of a polynomial based upon Gerschgorin's theorems, J. ACM 17 (1970).
[[nodiscard]] std::vector<Complex_root> complex_roots(const std::vector<Real>& p, Patience patience = Patience::brief);

/// Returns the real roots, ascending, if the disks prove that all complex roots are distinct; else nothing.
[[nodiscard]] std::optional<std::vector<Real>> certified_real_roots(const std::vector<Real>& p, Patience patience);

}  // namespace cgal_blend

#endif
