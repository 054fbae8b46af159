// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_SURFACE_BLEND_TESSELLATION_H
#define CGAL_BLEND_SRC_SURFACE_BLEND_TESSELLATION_H

#include <cgal_blend/surface_blend.h>
#include <cgal_blend/trimmed_surface.h>

#include <array>

namespace cgal_blend {

/// Adds the triangles of a blend to a soup, within the tolerance, and returns what its two surfaces are to be trimmed by.
/// Curves that are chains of edges of a mesh are met in the vertices of the chain alone.
[[nodiscard]] std::array<Trim_curve, 2> tessellate(const Surface_blend& blend, const Tessellation_options& options,
                                                   Triangle_soup& soup);

}  // namespace cgal_blend

#endif
