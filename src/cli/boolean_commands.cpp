// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.h"
#include "job.h"

#include <memory>

namespace cgal_blend::cli {

namespace {

struct Boolean_options {
  std::string a, b, transform_b;
  Output_options output;
  Ball_options ball;
};

void add_command(CLI::App& app, int& exit_status, const std::string& word, Boolean_operation operation,
                 const std::string& help) {
  CLI::App* command = app.add_subcommand(word, help);
  const auto options = std::make_shared<Boolean_options>();
  command->add_option("A", options->a, "First body")->type_name("MESH")->required();
  command->add_option("B", options->b, "Second body")->type_name("MESH")->required();
  add_mesh_output(*command, options->output);
  add_curvature_output(*command, options->output);
  CLI::Option* transform = command->add_option("--transform-b", options->transform_b,
                                               "Places B: 12 numbers \"m00 m01 ... m23\", a 3 x 4 matrix row by row");
  transform->type_name("MATRIX");
  add_ball_options(*command, options->ball);
  command->callback([=, &exit_status] {
    const Boolean_options& o = *options;
    exit_status = run_job(word, o.output, {o.a, o.b}, [&](Report& report) {
      const Fillet_options fillet = o.ball.checked();
      const Transform placement = transform->count() > 0 ? parse_transform(o.transform_b) : Transform();
      const Blend_mesh a = read_operand(o.a, report.input, report);
      const Blend_mesh b = read_operand(o.b, report.input_b, report, placement);
      blend_and_write(
          [&](Blend_mesh& out, const Fillet_options& with) {
            return unchecked::corefine_and_fillet(a, b, operation, out, with);
          },
          fillet, o.output, report);
    });
  });
}

}  // namespace

void add_boolean_commands(CLI::App& app, int& exit_status) {
  const std::string tail = "; with --radius, blends the curve in which their surfaces meet";
  add_command(app, exit_status, "union", Boolean_operation::union_, "Unites A and B" + tail);
  add_command(app, exit_status, "intersection", Boolean_operation::intersection, "Keeps what A and B share" + tail);
  add_command(app, exit_status, "difference", Boolean_operation::difference, "Cuts B out of A" + tail);
}

}  // namespace cgal_blend::cli
