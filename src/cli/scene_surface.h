// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_CLI_SCENE_SURFACE_H
#define CGAL_BLEND_CLI_SCENE_SURFACE_H

#include "scene_values.h"

#include <cgal_blend/boundary_curve.h>
#include <cgal_blend/trimmed_surface.h>

#include <functional>
#include <string>

namespace cgal_blend::cli {

/// A boundary curve and the end of the surface that it is.
struct Scene_curve {
  Boundary_curve curve;
  int slot = 0;
};

/// A surface of a scene: how it is trimmed, and how a curve on it is read.
struct Scene_surface {
  Trimmed_surface trimmed;
  std::function<Scene_curve(const Scene_value& side)> curve;
};

/// Reads a surface. \param folder that of the scene, for names of mesh files
[[nodiscard]] Scene_surface read_scene_surface(const Scene_value& json, const std::string& folder);

}  // namespace cgal_blend::cli

#endif
