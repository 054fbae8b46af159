// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_BRIDGE_ASSEMBLY_H
#define CGAL_BLEND_SRC_BRIDGE_ASSEMBLY_H

#include "bridge_grid.h"

#include <cstdint>
#include <unordered_set>
#include <vector>

namespace cgal_blend {

/// A mesh cut along the contact curves of bridges, but not changed yet.
struct Bridge_cut {
  Diagnosis diagnosis;    ///< `curve_crosses_itself`, `regions_overlap`; located
  Blend_mesh mesh;        ///< with the rims' vertices; may be taken out, see `take_mesh`
  std::vector<Rim> rims;  ///< two per bridge, with their vertices
  Trimming trimming;
};

/// Cuts around two spots, whose regions must have no face in common.
[[nodiscard]] Bridge_cut cut_spots(const Blend_mesh& mesh, const std::array<const Bridge_side*, 2>& sides);

/// Cuts on both sides of edges; what lies between goes.
[[nodiscard]] Bridge_cut cut_strips(const Blend_mesh& mesh, const std::vector<const Bridge_side*>& sides,
                                    const std::unordered_set<Edge>& curves);

/// Which faces of which input the faces of the mesh at hand are.
struct Bridge_body {
  const Blend_mesh* mesh = nullptr;
  std::vector<std::uint32_t> origins;  ///< per face of the mesh; empty: it is the input itself
  std::vector<bool> whole;             ///< per face of the mesh: it is all of its origin
  bool check_all = false;              ///< not only what is new has to be checked
};

/// Takes the mesh with the rims' vertices out of a cut, or makes it anew if it was taken out before: most cuts are sewn
/// once, which saves a copy.
[[nodiscard]] Blend_mesh take_mesh(Bridge_cut& cut, const Blend_mesh& uncut);

/// Sews bridges in where the mesh was cut, and checks the result.
/// \param work the mesh with the rims' vertices
/// \param bridges in the order of the rims
[[nodiscard]] Bridge_outcome sew(const Bridge_body& body, const Bridge_cut& cut, Blend_mesh work,
                                 const std::vector<const Bridge_grid*>& bridges, Blend_mesh& out);

}  // namespace cgal_blend

#endif
