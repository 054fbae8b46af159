// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_CLI_SCENE_BODY_H
#define CGAL_BLEND_CLI_SCENE_BODY_H

#include "scene_values.h"

#include <cgal_blend/blend_mesh.h>

#include <string>

namespace cgal_blend::cli {

/// Makes a body of a scene: a mesh file, or a sphere, ellipsoid, torus or cylinder, placed. Throws `Failure`.
/// \param folder that file names are relative to
[[nodiscard]] Blend_mesh read_scene_body(const Scene_value& json, const std::string& folder);

}  // namespace cgal_blend::cli

#endif
