// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SURFACE_BLEND_FIT_H
#define CGAL_BLEND_SURFACE_BLEND_FIT_H

#include <cgal_blend/bspline_surface.h>
#include <cgal_blend/surface_blend.h>

#include <optional>

namespace cgal_blend {

/// Fits a B-spline surface to a blend: exact in t, piecewise cubic in s through position and derivative at the knots,
/// which are inserted where the error is too large.
/// \param tolerance largest distance at the same parameters, length units, > 0
/// Returns nothing if 2^14 spans a quarter do not do.
[[nodiscard]] std::optional<Bspline_surface> fit_bspline(const Surface_blend& blend, double tolerance);

}  // namespace cgal_blend

#endif
