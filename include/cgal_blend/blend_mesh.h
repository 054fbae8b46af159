// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_BLEND_MESH_H
#define CGAL_BLEND_BLEND_MESH_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

namespace cgal_blend {

/// The kernel all engines work in: exact predicates, constructions in double.
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;

/// The one concrete mesh behind the facade; other mesh types are copied into it.
using Blend_mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Blend_mesh::Vertex_index;
using Halfedge = Blend_mesh::Halfedge_index;
using Edge = Blend_mesh::Edge_index;
using Face = Blend_mesh::Face_index;

}  // namespace cgal_blend

#endif
