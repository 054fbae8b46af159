// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.h"
#include "failure.h"
#include "job.h"

#include <cgal_blend/mesh_io.h>
#include <cgal_blend/validate.h>

#include <iomanip>
#include <iostream>
#include <memory>

namespace cgal_blend::cli {

namespace {

struct Check_options {
  std::string input;
  Output_options output;
};

void print(const Validity_report& r, const std::string& file) {
  const auto row = [](const char* what) -> std::ostream& {
    return std::cout << "  " << std::left << std::setw(22) << what;
  };
  const auto word = [](bool holds) { return holds ? "yes" : "no"; };
  std::cout << file << (r.ok() ? ": valid\n" : ": not valid\n");
  row("vertices") << r.vertices << "\n";
  row("faces") << r.faces << "\n";
  row("pieces") << r.components << "\n";
  row("finite coordinates") << word(r.finite) << "\n";
  row("closed") << word(r.closed) << "\n";
  row("manifold") << word(r.manifold) << "\n";
  row("oriented outward") << word(r.outward) << "\n";
  row("degenerate faces") << r.degenerate_faces << "\n";
  row("too short edges") << r.short_edges << "\n";
  row("self-intersections") << r.self_intersections << "\n";
  row("volume") << r.volume << "\n";
  row("area") << r.area << "\n";
}

void check(const Check_options& options, Report& report) {
  Blend_mesh mesh;
  {
    const Timer timer(report.read);
    mesh = read_mesh(options.input);
  }
  report.input = input_json(options.input, mesh);
  Validity_report validity;
  {
    const Timer timer(report.stages.validate);
    validity = validate(mesh);
  }
  // The mesh that was looked at stands where other commands report the mesh that they wrote: one format for all.
  report.output = validity_json(options.input, validity);
  if (options.output.summary()) print(validity, options.input);
  if (!validity.ok()) throw Failure(validity.diagnosis, in_quotes(options.input));
}

}  // namespace

void add_check_command(CLI::App& app, int& exit_status) {
  CLI::App* command = app.add_subcommand("check",
                                         "Reports whether a mesh is a valid solid: closed, manifold, oriented outward, "
                                         "not degenerate, not self-intersecting");
  const auto options = std::make_shared<Check_options>();
  command->add_option("IN", options->input, "Mesh to check")->type_name("MESH")->required();
  add_report_options(*command, options->output);
  CLI::Option* json = command->add_flag("--json", "Same as --report -");
  json->excludes("--report");
  command->callback([=, &exit_status] {
    if (json->count() > 0) options->output.report = "-";
    exit_status = run_job("check", options->output, {options->input}, [&](Report& report) { check(*options, report); });
  });
}

}  // namespace cgal_blend::cli
