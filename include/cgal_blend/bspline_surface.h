// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_BSPLINE_SURFACE_H
#define CGAL_BLEND_BSPLINE_SURFACE_H

#include <cgal_blend/blend_mesh.h>

#include <cstddef>
#include <string>
#include <vector>

namespace cgal_blend {

/// Tensor product B-spline surface, clamped, cubic in s with one derivative, and one Bezier span in t; by value.
struct Bspline_surface {
  std::vector<double> knots;                  ///< in s, ascending from 0 to 1; those between count twice
  std::vector<std::vector<Point_3>> control;  ///< 2 `knots.size()` rows along s, each of `degree_t` + 1 points along t
  int degree_t = 3;
  double error = 0;         ///< largest distance to what was fitted at the same parameters, as sampled, length units
  double normal_error = 0;  ///< largest angle between the normals along t = 0 and t = 1, as sampled, radians

  [[nodiscard]] Point_3 at(double s, double t) const;
};

/// Returns true if the library was built with Open CASCADE, so that `write_step` works.
[[nodiscard]] bool has_step() noexcept;

/// Writes surfaces to a STEP file (AP214, millimetres) as faces of one compound. The file appears whole or not at all.
/// Throws `Mesh_io_error`: unwritable, or unknown_format if `has_step()` is false.
void write_step(const std::string& path, const std::vector<Bspline_surface>& surfaces);

}  // namespace cgal_blend

#endif
