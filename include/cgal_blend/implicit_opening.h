// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_IMPLICIT_OPENING_H
#define CGAL_BLEND_IMPLICIT_OPENING_H

#include <cgal_blend/blend_mesh.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace cgal_blend {

using Point_2 = Kernel::Point_2;

/// A closed polygon in the plane of an opening; the first vertex is not repeated. Neither direction counts.
using Ring = std::vector<Point_2>;

/// A function of the plane of an opening: negative inside, positive outside, zero on the rings. Inside is what an odd number
/// of rings surround.
using Planar_function = std::function<double(const Point_2&)>;

/// The concept of an implicit opening: makes the function of rings that neither cross nor touch.
using Opening_model = std::function<Planar_function(const std::vector<Ring>&)>;

/// Signed distance to the rings, exact but for rounding.
/// Source: Jin et al., Mesh fusion using functional blending on topologically incompatible sections (2006), section 3.1.
[[nodiscard]] Opening_model distance_opening();

/// Signed distance sampled on a regular grid, bilinear between its nodes.
/// \param cells along the longer side of the rings' bounding box, enlarged by a half on all sides; >= 8
[[nodiscard]] Opening_model distance_grid_opening(std::size_t cells = 256);

struct Rbf_options {
  double rho = 0;  ///< value and distance of the offset points, length units, > 0; 0: half the mean edge of the rings
  double tolerance =
      1e-2;  ///< largest value at the vertices of the rings, of the mean edge; centres are added until it
             ///< is met, so that large openings stay tractable
};

/// Thin plate spline through the vertices of the rings (value 0) and points inside (-rho) and outside (+rho).
/// Source: ibid., section 3.1; Turk and O'Brien, Modelling with implicit surfaces that interpolate (2001).
[[nodiscard]] Opening_model rbf_opening(const Rbf_options& options = {});

}  // namespace cgal_blend

#endif
