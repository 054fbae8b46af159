// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_TOPOLOGY_DEFECTS_H
#define CGAL_BLEND_SRC_TOPOLOGY_DEFECTS_H

#include <cgal_blend/blend_mesh.h>
#include <cgal_blend/status.h>

#include "triangle_topology.h"

#include <functional>
#include <vector>

namespace cgal_blend::internal {

using Point_of_vertex = std::function<Point_3(std::uint32_t)>;

/// Names what keeps triangles from being a manifold, and the first place; `ok` if nothing does. Holes are no obstacle.
[[nodiscard]] Diagnosis manifold_defect(const Triangle_topology& topology, const std::vector<Triangle>& triangles,
                                        const Point_of_vertex& point);

/// Names the first edge with one face; `ok` if there is none.
[[nodiscard]] Diagnosis closedness_defect(const Triangle_topology& topology, const std::vector<Triangle>& triangles,
                                          const Point_of_vertex& point);

}  // namespace cgal_blend::internal

#endif
