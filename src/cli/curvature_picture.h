// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_CLI_CURVATURE_PICTURE_H
#define CGAL_BLEND_CLI_CURVATURE_PICTURE_H

#include "report.h"

#include <optional>
#include <string>

namespace cgal_blend::cli {

/// Writes a mesh as PLY, coloured by its mean curvature on a scale from -limit to limit (default: `robust_limit`).
/// Returns the `curvature` entry of the report; throws `Mesh_io_error`.
[[nodiscard]] Json write_curvature_picture(const std::string& path, const Blend_mesh& mesh,
                                           std::optional<double> limit = {});

}  // namespace cgal_blend::cli

#endif
