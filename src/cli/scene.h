// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_CLI_SCENE_H
#define CGAL_BLEND_CLI_SCENE_H

#include <cgal_blend/surface_blend_body.h>

#include <optional>
#include <string>
#include <vector>

namespace cgal_blend::cli {

/// What a scene file asks for, with all blends made.
struct Scene {
  std::vector<std::string> names;  ///< of the surfaces
  std::vector<Trimmed_surface> surfaces;
  std::vector<Body_blend> blends;
  std::vector<double> factors;  ///< per blend: what its distances were multiplied by
  Blend_body_options body;
};

/// Reads a scene of surfaces and blends; doc/surface_blend.md describes the format. Throws `Failure`: input for a file
/// that is not such a scene, blend for a blend that cannot be made.
[[nodiscard]] Scene read_scene(const std::string& path);

}  // namespace cgal_blend::cli

#endif
