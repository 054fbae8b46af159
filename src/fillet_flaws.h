// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_FILLET_FLAWS_H
#define CGAL_BLEND_SRC_FILLET_FLAWS_H

#include <cgal_blend/fillet.h>
#include <cgal_blend/validate.h>

#include <string>
#include <vector>

// Flaws of the input that are accepted as long as no blend meets them: which does. All answer with the status of the
// first such flaw, its faces and its place, or `ok`.

namespace cgal_blend {

/// Names a flaw; `where` goes into the detail.
[[nodiscard]] Diagnosis flaw_diagnosis(const Blend_mesh& mesh, const Flaw& flaw, const std::string& where);

/// Names a flaw of a face with a corner on an edge to be blended.
[[nodiscard]] Diagnosis flaw_at_edges(const Blend_mesh& mesh, const std::vector<Flaw>& flaws,
                                      const std::vector<Edge_blend>& blends);

/// Takes the curves that have such an edge out of the blends, and blends without edges altogether.
/// \returns the reports of the curves that are gone, refused for their flaws
[[nodiscard]] std::vector<Blend_report> leave_out_flawed_curves(const Blend_mesh& mesh, const std::vector<Flaw>& flaws,
                                                                std::vector<Edge_blend>& blends,
                                                                const Fillet_options& options);

/// Names a flaw of a face that a blend of `mesh` has not kept.
[[nodiscard]] Diagnosis flaw_in_changes(const Blend_mesh& mesh, const std::vector<Flaw>& flaws,
                                        const Fillet_outcome& outcome);

/// Names the flaw that may be the reason of a refusal: one near its place, where the status is one that a flaw can cause.
[[nodiscard]] Diagnosis flaw_near_refusal(const Blend_mesh& mesh, const std::vector<Flaw>& flaws,
                                          const std::vector<Edge_blend>& blends, const Fillet_options& options,
                                          const Diagnosis& refusal);

}  // namespace cgal_blend

#endif
