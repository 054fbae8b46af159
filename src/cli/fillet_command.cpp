// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.h"
#include "edge_choice.h"
#include "failure.h"
#include "job.h"

#include <algorithm>
#include <memory>
#include <string>

namespace cgal_blend::cli {

namespace {

struct Fillet_command_options {
  std::string input;
  double sharp_angle = 0;
  Edge_choice choice;
  Output_options output;
  Ball_options ball;
};

/// Gives requests without a radius that of the command line.
void require_radius_for_all(const Fillet_command_options& o, const std::optional<Radius_law>& radius,
                            std::vector<Blend_request>& requests) {
  const auto has_radius = [](const Blend_request& request) { return request.radius.has_value(); };
  const bool from_file = !o.choice.blends_file.empty() && std::all_of(requests.begin(), requests.end(), has_radius);
  if (!radius && !from_file) throw usage_failure("--radius is required");
  for (Blend_request& request : requests)
    if (!has_radius(request)) request.radius = radius;
}

void fillet(const Fillet_command_options& o, Report& report) {
  o.choice.require_one();
  const Fillet_options options = o.ball.checked();
  std::vector<Blend_request> requests;
  if (!o.choice.blends_file.empty()) requests = read_blends(o.choice.blends_file);
  require_radius_for_all(o, options.law, requests);
  std::vector<Flaw> flaws;
  const Blend_mesh mesh = read_operand(o.input, report.input, report, {}, options.accept_flaws ? &flaws : nullptr);
  const std::vector<Edge_blend> blends = chosen_edges(o.choice, requests, mesh);
  const auto engine = [&](Blend_mesh& out, const Fillet_options& with) {
    return unchecked::fillet_edges(mesh, blends, flaws, out, with);
  };
  blend_and_write(engine, options, o.output, report);
}

}  // namespace

void add_fillet_command(CLI::App& app, int& exit_status) {
  CLI::App* command = app.add_subcommand("fillet", "Blends edges of one body with a rolling ball");
  const auto options = std::make_shared<Fillet_command_options>();
  command->add_option("IN", options->input, "Body")->type_name("MESH")->required();
  add_mesh_output(*command, options->output);
  add_curvature_output(*command, options->output);
  CLI::Option* angle = add_number(*command, "--sharp-angle", options->sharp_angle, 0, 180, true,
                                  "Blend every edge whose face normals differ by more than this");
  angle->type_name("DEG");
  command->add_option("--edges", options->choice.edges_file, "Blend the edges of a CGAL selection file")
      ->type_name("FILE");
  command
      ->add_option("--blends", options->choice.blends_file, "Blend the polylines of a JSON file, each with its radius")
      ->type_name("FILE");
  add_number(*command, "--from", options->choice.from, 0, 1, false,
             "Begin blends within their curves, at this fraction of the arc length [0]")
      ->type_name("F");
  add_number(*command, "--to", options->choice.to, 0, 1, false, "End blends at this fraction [1]")->type_name("F");
  add_ball_options(*command, options->ball);
  const auto propagate = [flags = &options->ball.fillet](const std::string& text) {
    if (text != "on" && text != "off")
      throw CLI::ValidationError("--propagate", "'" + text + "' is neither on nor off");
    flags->propagate = text == "on";
  };
  command
      ->add_option_function<std::string>("--propagate", propagate,
                                         "on: continue the chosen edges over those that go on smoothly [off]")
      ->type_name("on|off");
  command->add_flag("--accept-flaws", options->ball.fillet.accept_flaws,
                    "Accept self-intersections and degenerate faces of IN that the blends do not meet; they stay");
  command->callback([=, &exit_status] {
    if (angle->count() > 0) options->choice.sharp_angle = options->sharp_angle;
    exit_status =
        run_job("fillet", options->output, {options->input}, [&](Report& report) { fillet(*options, report); });
  });
}

}  // namespace cgal_blend::cli
