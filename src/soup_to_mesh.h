// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_SOUP_TO_MESH_H
#define CGAL_BLEND_SRC_SOUP_TO_MESH_H

#include <cgal_blend/trimmed_surface.h>

#include <optional>

namespace cgal_blend {

/// Turns triangles about so that neighbours agree; false if an edge has more than two, or the surface has one side only.
[[nodiscard]] bool orient(Triangle_soup& soup);

/// Fills a closed, nearly planar polygon of the soup with triangles of a part; false if it is not simple as seen along
/// its normal, or not planar to `planarity` of its extent.
[[nodiscard]] bool fill(const std::vector<std::size_t>& rim, int part, Triangle_soup& soup);

inline constexpr double planarity = 1e-6;

/// Makes a plate of an oriented sheet: a copy on either side at half the thickness along the normals of its vertices,
/// and sides of a part along its border.
void thicken(double thickness, int side_part, Triangle_soup& soup);

/// Returns the mesh of an oriented soup, faces in order, points without triangles left out; nothing if it is not manifold.
[[nodiscard]] std::optional<Blend_mesh> to_mesh(const Triangle_soup& soup);

/// Reverses all triangles.
void reverse(Triangle_soup& soup);

/// Returns the enclosed volume, cubic length units; negative if oriented inward.
[[nodiscard]] double signed_volume(const Triangle_soup& soup);

}  // namespace cgal_blend

#endif
