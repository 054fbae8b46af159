// SPDX-License-Identifier: GPL-3.0-or-later
// g++ 12 takes CGAL's function objects, which hold nothing, for uninitialized.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include "corefinement_visitor.h"

namespace cgal_blend {

bool corefine_exactly(std::array<Exact_mesh, 2>& operands, Boolean_operation operation, Exact_mesh& out,
                      Edge_marks marks, Corefinement_record& record) {
  return corefine_points<Blend_mesh::Property_map<Vertex, Exact_point>>({&operands[0].mesh, &operands[1].mesh},
                                                                        {operands[0].points, operands[1].points},
                                                                        operation, out.mesh, out.points, marks, record);
}

}  // namespace cgal_blend
