// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_CLI_PATHS_H
#define CGAL_BLEND_CLI_PATHS_H

#include "options.h"

#include <string>
#include <vector>

namespace cgal_blend::cli {

/// Throws `Failure` (usage) if the report could not be written where the options say, or would replace a mesh.
void check_report_path(const Output_options& output, const std::vector<std::string>& inputs);

/// Throws `Failure` (usage) if the mesh could not be written where the options say. Nothing is created.
void check_mesh_path(const Output_options& output);

/// Throws `Failure` (usage) if the curvature picture could not be written where the options say, or would replace
/// another file of the command.
void check_curvature_path(const Output_options& output, const std::vector<std::string>& inputs);

/// Throws `Failure` (usage) if curves could not be written to `path`, or would replace the input. Nothing is created.
void check_curves_path(const std::string& path, const std::string& input);

/// Throws `Failure` (usage) if a STEP file could not be written to `path`, or would replace another file of the command.
void check_step_path(const std::string& path, const std::vector<std::string>& others);

/// Throws `Failure` (usage) if labels of faces could not be written to `path`, or would replace another file.
void check_labels_path(const std::string& path, const std::vector<std::string>& others);

/// Throws `Failure` (usage) unless the name ends in .ply.
void require_ply(const std::string& path);

}  // namespace cgal_blend::cli

#endif
