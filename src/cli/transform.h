// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_CLI_TRANSFORM_H
#define CGAL_BLEND_CLI_TRANSFORM_H

#include <cgal_blend/blend_mesh.h>

#include <CGAL/Aff_transformation_3.h>

#include <optional>
#include <string>

namespace cgal_blend::cli {

/// An affine placement; nothing: leave the mesh where it is.
using Transform = std::optional<CGAL::Aff_transformation_3<Kernel>>;

/// Reads the 12 numbers "m00 m01 ... m23", row by row, of a 3 x 4 matrix. Throws `Failure` (usage) for other counts,
/// numbers that are not finite, and matrices that flatten space; `option` begins the message.
[[nodiscard]] Transform parse_transform(const std::string& text, const std::string& option);

/// Places a mesh; a mirroring turns its faces around, so that a solid stays a solid.
void apply(const Transform& transform, Blend_mesh& mesh);

}  // namespace cgal_blend::cli

#endif
