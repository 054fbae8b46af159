// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_QUADRIC_MATRIX_H
#define CGAL_BLEND_QUADRIC_MATRIX_H

#include "symmetric_form.h"

#include <cgal_blend/quadric.h>

namespace cgal_blend {

/// Returns the 4 x 4 matrix in coordinates (x, y, z, w) of a positive multiple of the polynomial; its entries are
/// integers without a common factor.
[[nodiscard]] Surd_matrix quadric_matrix(const Quadric_3& quadric);

/// Returns the coefficients of the polynomial x^T m x, w = 1, for rational entries.
[[nodiscard]] Quadric_3::Coefficients coefficients_of(const Surd_matrix& m);

/// Divides the entries by their common factor and clears denominators; all rational, not all 0.
void make_primitive(Surd_matrix& m);

}  // namespace cgal_blend

#endif
