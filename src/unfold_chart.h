// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_UNFOLD_CHART_H
#define CGAL_BLEND_SRC_UNFOLD_CHART_H

#include "polar_chart.h"
#include "region_mesh.h"

namespace cgal_blend {

/// Moves vertices within the chart of polar coordinates where single triangles are turned over or flat, towards the
/// mean of their neighbours: angles first, then, where that does not do, places. Behind a vertex with more than a full
/// turn around it all geodesics have one angle, on a rough surface neighbours may overtake each other; folds that are
/// wider than a few triangles stay.
/// \param thin height of triangles that do not matter in a disk, length units
void unfold_chart(const Region_mesh& region, Chart_kind kind, double thin, double limit, Geodesic_field& field);

}  // namespace cgal_blend

#endif
