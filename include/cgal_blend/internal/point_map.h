// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_INTERNAL_POINT_MAP_H
#define CGAL_BLEND_INTERNAL_POINT_MAP_H

#include <cgal_blend/status.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

namespace cgal_blend::internal {

/// Returns the vertex point map among the named parameters, or the mesh's own.
template <class Graph, class NamedParameters>
auto point_map(const Graph& mesh, const NamedParameters& np) {
  return CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
                                            CGAL::get_const_property_map(CGAL::vertex_point, mesh));
}

/// Returns a point of any kernel as the reports give it.
template <class Point>
Diagnosis::Point to_double_point(const Point& p) {
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
}

}  // namespace cgal_blend::internal

#endif
