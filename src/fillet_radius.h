// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_FILLET_RADIUS_H
#define CGAL_BLEND_SRC_FILLET_RADIUS_H

#include <cgal_blend/curve_network.h>
#include <cgal_blend/fillet.h>

#include <vector>

namespace cgal_blend {

/// Returns the radius of a blend: its own law or radius, else those of the options; not checked.
[[nodiscard]] Radius_law radius_law_of(const Edge_blend& blend, const Fillet_options& options);

/// The radius of a blend along each branch of a network, or why there is none.
struct Branch_laws {
  Diagnosis diagnosis;  ///< `ok` or `invalid_parameter`
  /// s is the fraction of the branch's length from the source of its first halfedge on; periodic if the branch is closed.
  std::vector<Radius_law> laws;
};

/// Checks the radius of a blend, lays it along its curves, from the start that the blend names, and returns the part of
/// each branch: so it goes on over corners.
/// \param network of the edges of the blend; may have more nodes than the curves
[[nodiscard]] Branch_laws laws_along(const Blend_mesh& mesh, const Curve_network<Blend_mesh>& network,
                                     const Edge_blend& blend, const Fillet_options& options);

}  // namespace cgal_blend

#endif
