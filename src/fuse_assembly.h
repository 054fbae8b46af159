// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_FUSE_ASSEMBLY_H
#define CGAL_BLEND_SRC_FUSE_ASSEMBLY_H

#include "fuse_sides.h"
#include "slab_tessellation.h"

#include <array>
#include <cstddef>
#include <vector>

namespace cgal_blend {

/// Two cut sides and the transition between their rings as one mesh.
struct Fused_mesh {
  Diagnosis diagnosis;                        ///< `result_invalid` if they do not fit together
  Blend_mesh mesh;                            ///< kept faces first, then parts of divided ones, then the transition
  std::size_t kept_faces = 0, old_faces = 0;  ///< faces that are kept whole, and with the parts of divided ones
  std::size_t new_vertices = 0;               ///< the last vertices: inside the transition
  std::vector<std::size_t> part_end;          ///< by mesh, lower ones first: where its kept faces end
};

/// Sews by shared vertices of the rings: these are the sides' own, whatever the slab says.
/// \param inner positions of the slab's vertices after those of the rings
[[nodiscard]] Fused_mesh sew(const std::array<Fuse_side, 2>& sides, std::size_t side_vertices,
                             const Slab_tessellation& slab, const std::vector<Point_3>& inner);

/// Checks all that is new, and meshes of the input that could meet each other; fills in volume, area, faces and tangency.
/// `blend_collides`: the transition meets a kept part; `sides_interpenetrate`: kept parts meet; `blend_folds`: a bent
/// transition meets itself; `plane_meets_vertex`: a part of a divided face has no area; `input_degenerate`,
/// `input_misoriented`: an open mesh was so; else `result_invalid`.
void finish(const std::array<Fuse_side, 2>& sides, const Fused_mesh& fused, bool bent, Fuse_outcome& outcome);

}  // namespace cgal_blend

#endif
