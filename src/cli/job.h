// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_CLI_JOB_H
#define CGAL_BLEND_CLI_JOB_H

#include "options.h"
#include "report.h"
#include "transform.h"

#include <functional>
#include <string>
#include <vector>

namespace cgal_blend::cli {

/// One run of a subcommand: checks the paths, runs the body, turns whatever it throws into an exit status, one line on
/// standard error and a report. Returns the exit status.
int run_job(const std::string& command, const Output_options& output, const std::vector<std::string>& inputs,
            const std::function<void(Report&)>& body);

/// Reads an input mesh and places it. Fills `entry` and the time.
[[nodiscard]] Blend_mesh read_placed(const std::string& path, Json& entry, Report& report,
                                     const Transform& placement = {});

/// Reads an input mesh, places it, and refuses it by name if it is not a valid solid. Fills `entry` and the times.
/// \param flaws receives the flaws of the mesh, which are no reason to refuse it then; null: they are
[[nodiscard]] Blend_mesh read_operand(const std::string& path, Json& entry, Report& report,
                                      const Transform& placement = {}, std::vector<Flaw>* flaws = nullptr);

/// Runs an engine with a progress line, then writes and reports its mesh; throws `Failure` if it refuses.
void blend_and_write(const std::function<Fillet_outcome(Blend_mesh&, const Fillet_options&)>& engine,
                     const Fillet_options& options, const Output_options& output, Report& report);

}  // namespace cgal_blend::cli

#endif
