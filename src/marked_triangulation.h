// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_MARKED_TRIANGULATION_H
#define CGAL_BLEND_SRC_MARKED_TRIANGULATION_H

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

namespace cgal_blend {

/// Constrained Delaunay triangulation with exact predicates whose vertices carry an `Info` and whose faces carry a mark.
/// Constraints that cross throw.
template <class Info, class Traits>
using Marked_triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Traits,
    CGAL::Triangulation_data_structure_2<
        CGAL::Triangulation_vertex_base_with_info_2<Info, Traits>,
        CGAL::Constrained_triangulation_face_base_2<Traits, CGAL::Triangulation_face_base_with_info_2<bool, Traits>>>,
    CGAL::No_constraint_intersection_requiring_constructions_tag>;

}  // namespace cgal_blend

#endif
