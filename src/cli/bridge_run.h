// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_CLI_BRIDGE_RUN_H
#define CGAL_BLEND_CLI_BRIDGE_RUN_H

#include "bridge_scene.h"
#include "report.h"

#include <cstddef>
#include <string>
#include <vector>

namespace cgal_blend::cli {

/// The mesh that a scene leads to, with what each face is a part of.
struct Bridged_mesh {
  /// A body of the scene, or a bridge; or, on the way, what fills a hole.
  struct Label {
    bool is_bridge = false;
    std::size_t index = 0;
    bool kept = true;  ///< the face is one of the body's own
  };
  Blend_mesh mesh;
  std::vector<Label> labels;  ///< per face
  double volume = 0, area = 0;
};

/// Makes the bridges of a scene in turn, with their entries and the times in the report. Throws `Failure`.
[[nodiscard]] Bridged_mesh make_bridges(const Bridge_scene& scene, Report& report);

/// Writes one line per face: "body NAME" or "bridge N", from 1. Throws `Failure`.
void write_bridge_labels(const std::string& path, const Bridge_scene& scene, const Bridged_mesh& bridged);

}  // namespace cgal_blend::cli

#endif
