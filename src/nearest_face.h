// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_NEAREST_FACE_H
#define CGAL_BLEND_SRC_NEAREST_FACE_H

#include <cgal_blend/blend_mesh.h>

namespace cgal_blend {

struct Nearest_face {
  Face face;
  double distance = 0;  ///< length units
  double diagonal = 0;  ///< of the mesh's bounding box
};

/// Finds the face of a mesh that is nearest to a point, by a sweep over all: for a few points.
[[nodiscard]] Nearest_face nearest_face(const Blend_mesh& mesh, const Point_3& p);

}  // namespace cgal_blend

#endif
