// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.h"
#include "curvature_picture.h"
#include "failure.h"
#include "job.h"
#include "paths.h"
#include "values.h"

#include <cgal_blend/mesh_io.h>

#include <iostream>
#include <memory>
#include <optional>

namespace cgal_blend::cli {

namespace {

struct Curvature_options {
  std::string input;
  std::optional<std::string> limit;
  Output_options output;
};

std::optional<double> parse_limit(const std::optional<std::string>& text) {
  if (!text) return std::nullopt;
  const auto limit = parse_number(*text);
  if (!limit || !(*limit > 0)) throw usage_failure("--limit: '" + *text + "' is not a number greater than 0");
  return limit;
}

void curvature(const Curvature_options& options, Report& report) {
  require_ply(options.output.mesh);
  const std::optional<double> limit = parse_limit(options.limit);
  Blend_mesh mesh;
  {
    const Timer timer(report.read);
    mesh = read_mesh(options.input);
  }
  report.input = input_json(options.input, mesh);
  {
    const Timer timer(report.write);
    report.curvature = write_curvature_picture(options.output.mesh, mesh, limit);
  }
  report.output = input_json(options.output.mesh, mesh);
  if (options.output.summary())
    std::cout << options.output.mesh << ": mean curvature from " << report.curvature["min"] << " to "
              << report.curvature["max"] << ", colours from " << -report.curvature["limit"].get<double>()
              << " (blue) to " << report.curvature["limit"] << " (red)\n";
}

}  // namespace

void add_curvature_command(CLI::App& app, int& exit_status) {
  CLI::App* command = app.add_subcommand(
      "curvature", "Colours a mesh by its mean curvature: blue concave, white flat, red convex; the mesh may be open");
  const auto options = std::make_shared<Curvature_options>();
  command->add_option("IN", options->input, "Mesh to look at")->type_name("MESH")->required();
  add_mesh_output(*command, options->output, "Coloured mesh to write: .ply");
  const auto given = [options](const std::string& text) { options->limit = text; };
  command
      ->add_option_function<std::string>("--limit", given,
                                         "Curvature at which the colours end, 1/length [that of 95 % of the vertices]")
      ->type_name("X");
  command->callback([=, &exit_status] {
    exit_status =
        run_job("curvature", options->output, {options->input}, [&](Report& report) { curvature(*options, report); });
  });
}

}  // namespace cgal_blend::cli
