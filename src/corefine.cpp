// SPDX-License-Identifier: GPL-3.0-or-later
#include "corefinement_visitor.h"

namespace cgal_blend {

bool corefine(std::array<Blend_mesh, 2>& operands, Boolean_operation operation, Blend_mesh& out, Edge_marks marks,
              Corefinement_record& record) {
  return corefine_points<Blend_mesh::Property_map<Vertex, Point_3>>({&operands[0], &operands[1]},
                                                                    {operands[0].points(), operands[1].points()},
                                                                    operation, out, out.points(), marks, record);
}

}  // namespace cgal_blend
