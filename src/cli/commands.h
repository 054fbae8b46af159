// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_CLI_COMMANDS_H
#define CGAL_BLEND_CLI_COMMANDS_H

#include <CLI/CLI.hpp>

namespace cgal_blend::cli {

// Each adds its subcommands; the one on the command line runs while that is parsed and leaves its exit status.

void add_boolean_commands(CLI::App& app, int& exit_status);
void add_fillet_command(CLI::App& app, int& exit_status);
void add_check_command(CLI::App& app, int& exit_status);
void add_curvature_command(CLI::App& app, int& exit_status);
void add_intersect_quadrics_command(CLI::App& app, int& exit_status);
void add_quadrics_command(CLI::App& app, int& exit_status);
void add_fuse_command(CLI::App& app, int& exit_status);

}  // namespace cgal_blend::cli

#endif
