// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_RULED_QUADRIC_H
#define CGAL_BLEND_RULED_QUADRIC_H

#include "symmetric_form.h"

#include <optional>

namespace cgal_blend {

/// Doubly ruled quadric of a pencil: the points u0 v0 p + u0 v1 d1 + u1 v0 d2 + u1 v1 q. With numbers of one square root.
struct Ruled_quadric {
  Surd_vector p, d1, d2, q;
  Surd_matrix form;  ///< rational
};

struct Ruled_search {
  bool has_definite_member = false;      ///< then the pencil has no common real point
  std::optional<Ruled_quadric> quadric;  ///< nothing if no member is doubly ruled
};

/// Looks among the members between the singular ones for one that is doubly ruled and has a small rational point: through
/// every rational point goes one member, so the point is rounded, and the member follows.
/// \param determinant of the members c a - s b, not zero
/// \param is_central the member's section with the plane at infinity must be regular
/// Source: Dupont, Lazard, Lazard, Petitjean, Near-optimal parameterization of the intersection of quadrics I, section 5.
[[nodiscard]] Ruled_search find_ruled_quadric(const Surd_matrix& a, const Surd_matrix& b,
                                              const Binary_form& determinant, bool is_central);

}  // namespace cgal_blend

#endif
