// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_FLATTEN_DISK_H
#define CGAL_BLEND_SRC_FLATTEN_DISK_H

#include <cgal_blend/blend_mesh.h>

#include <optional>
#include <vector>

namespace cgal_blend {

using Point_2 = Kernel::Point_2;

/// A flat image of a triangulated disk without folds.
struct Flat_disk {
  std::vector<Point_2> points;  ///< per vertex
  bool mean_value = false;      ///< the conformal weights folded it
};

/// Maps a disk into the plane with a given convex border: discrete conformal weights, mean value weights where those
/// fold it (exact orientation of every face). Returns nothing if both do.
/// \param border per vertex its place if it is a border vertex, counterclockwise; others are ignored
[[nodiscard]] std::optional<Flat_disk> flatten_disk(Blend_mesh& disk, const std::vector<Point_2>& border);

}  // namespace cgal_blend

#endif
