// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_FLATTEN_DISK_H
#define CGAL_BLEND_SRC_FLATTEN_DISK_H

#include <cgal_blend/blend_mesh.h>

#include <optional>
#include <vector>

namespace cgal_blend {

using Point_2 = Kernel::Point_2;

enum class Flat_weights { conformal, mean_value, uniform };

/// Maps a disk into the plane with a given convex border; per vertex its place. Returns nothing if a face would fold
/// (exact orientation): conformal weights do so on obtuse faces; mean value weights only where faces are too thin for
/// their angles to be known; uniform weights do not.
/// \param border per vertex its place if it is a border vertex, counterclockwise; others are ignored
/// Source: Eck et al. (1995), Floater (2003), Tutte (1963).
[[nodiscard]] std::optional<std::vector<Point_2>> flatten_disk(Blend_mesh& disk, const std::vector<Point_2>& border,
                                                               Flat_weights weights);

}  // namespace cgal_blend

#endif
