// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_FILLET_IN_PASSES_H
#define CGAL_BLEND_SRC_FILLET_IN_PASSES_H

#include "fillet_body.h"

#include <vector>

namespace cgal_blend {

/// Blends edges of a body; see `fillet_edges`. Where the blends at a corner have an order, those that come later are
/// those of the mesh that the earlier ones leave, and roll over these. The faces of the bases that are kept come first
/// in `out`, in their order.
/// \param search tell the largest radius that works for blends that are refused, which takes many tries
[[nodiscard]] Fillet_outcome fillet_in_passes(const Fillet_body& body, const std::vector<Edge_blend>& blends,
                                              Blend_mesh& out, const Fillet_options& options, bool search = true);

}  // namespace cgal_blend

#endif
