// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_FILLET_PARTIAL_H
#define CGAL_BLEND_SRC_FILLET_PARTIAL_H

#include "fillet_body.h"
#include "fillet_stations.h"

#include <functional>
#include <vector>

namespace cgal_blend {

/// Blends edges of a body into the mesh of the result.
using Blend_engine = std::function<Fillet_outcome(const Fillet_body&, const std::vector<Edge_blend>&)>;

/// Blends parts of curves: divides the mesh where they begin and end, blends whole edges of that, and describes the
/// result as one of the mesh as it was. Where parts are left sharp, by `keep_going`, the mesh stays undivided.
/// \param flaws of the mesh; no face of one is divided, but the blend refused with its status
/// \param out that the engine fills
[[nodiscard]] Fillet_outcome fillet_partial(const Blend_mesh& mesh, const std::vector<Edge_blend>& blends,
                                            const std::vector<Flaw>& flaws, Blend_mesh& out,
                                            const Fillet_options& options, const Blend_engine& engine);

}  // namespace cgal_blend

#endif
