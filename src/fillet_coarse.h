// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_FILLET_COARSE_H
#define CGAL_BLEND_SRC_FILLET_COARSE_H

#include "fillet_body.h"

#include <vector>

namespace cgal_blend {

/// Blends a decimated version of a body (`Fillet_options::coarse_faces`) and carries the result over to the body itself,
/// whose connectivity stays. Refusals are those of the coarse blend, and `region_too_coarse` if the decimated body is no
/// valid solid.
/// Source: Liu et al. (2005), section 6.3 and Fig. 16.
[[nodiscard]] Fillet_outcome fillet_coarse(const Fillet_body& body, const std::vector<Edge_blend>& blends,
                                           Blend_mesh& out, const Fillet_options& options);

}  // namespace cgal_blend

#endif
