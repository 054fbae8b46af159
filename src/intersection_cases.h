// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_INTERSECTION_CASES_H
#define CGAL_BLEND_INTERSECTION_CASES_H

#include "intersection_builder.h"
#include "quadric_pencil.h"

#include <string>

namespace cgal_blend {

// The cases of the intersection of two quadrics. Each takes the rational 4 x 4 matrices of both and adds what is real and
// affine to the builder.

/// Returns the points of a conic of inertia (2, 1) or (1, 2): three vectors, factors of c^2, c s, s^2.
[[nodiscard]] Surd_matrix parametrize_conic(const Diagonal_form& conic);

struct Plane_section {
  bool has_curve = false, is_smooth_conic = false;
};
/// Adds the section of a quadric and a plane that is no part of it.
/// \param basis three points that span the plane
/// \param multiplicity of the plane
/// \param is_alone if not, singular points on the line of the first two are left to the caller
Plane_section add_plane_section(Intersection_builder& builder, const Surd_matrix& quadric, const Surd_matrix& basis,
                                int multiplicity, bool is_alone);

/// Adds the intersection of a quadric and a quadric of rank 1 or 2; they share no plane.
void add_planes(Intersection_builder& builder, const Surd_matrix& planes, const Surd_matrix& quadric);

/// Adds the intersection of two quadrics that are both singular in a common point; returns the Segre symbol.
/// \param apexes spans the common kernel
std::string add_cones(Intersection_builder& builder, const Surd_matrix& a, const Surd_matrix& b,
                      const Surd_matrix& apexes);

/// Adds a quartic with a node, a cusp or an isolated point; `cone` is the member of rank 3 with its apex there.
void add_singular_quartic(Intersection_builder& builder, const Surd_matrix& cone, const Surd_matrix& quadric);

/// Adds a twisted cubic and a line. The pencil's determinant is the square of `half`, up to a factor.
void add_cubic_and_line(Intersection_builder& builder, const Form_pencil& pencil, const Binary_form& half);

/// Adds a smooth quartic.
void add_smooth_quartic(Intersection_builder& builder, const Form_pencil& pencil);

/// Adds the two real lines of a pencil whose two members of rank 2 are complex.
void add_skew_lines(Intersection_builder& builder, const Form_pencil& pencil);

}  // namespace cgal_blend

#endif
