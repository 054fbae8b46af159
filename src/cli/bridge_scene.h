// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_CLI_BRIDGE_SCENE_H
#define CGAL_BLEND_CLI_BRIDGE_SCENE_H

#include <cgal_blend/bridge.h>

#include <optional>
#include <string>
#include <vector>

namespace cgal_blend::cli {

struct Drag_request {
  double s = 0, t = 0;
  Point_3 target{0, 0, 0};
};

/// A bridge between two spots; or, with a further body, one around each curve in which that crosses what is there.
struct Bridge_step {
  Bridge bridge;
  std::optional<std::size_t> crossing;  ///< index of the body
  std::optional<Drag_request> drag;
  std::string where;  ///< for messages; may be empty
};

/// Bodies, and what is done with them in turn. Bodies that no step unites are there from the start.
struct Bridge_scene {
  std::vector<std::string> names;
  std::vector<Blend_mesh> bodies;
  std::vector<Bridge_step> steps;
};

/// Reads a scene of bodies and bridges; doc/bridge.md describes the format. Throws `Failure`.
[[nodiscard]] Bridge_scene read_bridge_scene(const std::string& path);

}  // namespace cgal_blend::cli

#endif
