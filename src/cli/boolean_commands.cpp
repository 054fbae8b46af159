// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.h"
#include "failure.h"
#include "job.h"

#include <array>
#include <deque>
#include <memory>
#include <optional>

namespace cgal_blend::cli {

namespace {

// Bodies have letters, A to H, in the options that place them and in the report.
constexpr std::size_t most_further_bodies = 7;

struct Boolean_options {
  std::string a, b;
  std::vector<std::string> further;  // C and on
  std::array<std::optional<std::string>, most_further_bodies> transforms;
  Output_options output;
  Ball_options ball;

  [[nodiscard]] std::vector<std::string> after_first() const {
    std::vector<std::string> all{b};
    all.insert(all.end(), further.begin(), further.end());
    return all;
  }
};

std::string transform_flag(std::size_t part) { return std::string("--transform-") + static_cast<char>('b' + part); }

std::vector<Transform> parse_transforms(const Boolean_options& o, std::size_t parts) {
  std::vector<Transform> placements(parts);
  for (std::size_t k = 0; k < o.transforms.size(); ++k) {
    if (!o.transforms[k]) continue;
    if (k >= parts) throw usage_failure(transform_flag(k) + ": there is no such body");
    placements[k] = parse_transform(*o.transforms[k], transform_flag(k));
  }
  return placements;
}

void compute(const Boolean_options& o, Boolean_operation operation, Report& report) {
  const std::vector<std::string> files = o.after_first();
  if (files.size() > most_further_bodies)
    throw usage_failure("at most " + std::to_string(most_further_bodies + 1) + " bodies, not " +
                        std::to_string(files.size() + 1));
  const Fillet_options fillet = o.ball.checked_but_radius();
  const std::vector<std::optional<Radius_law>> radii = o.ball.checked_radii(files.size());
  const std::vector<Transform> placements = parse_transforms(o, files.size());
  const Blend_mesh first = read_operand(o.a, report.input, report);
  std::deque<Blend_mesh> meshes;  // their addresses stay
  std::vector<Part> parts;
  report.more_inputs.resize(files.size());
  for (std::size_t k = 0; k < files.size(); ++k) {
    meshes.push_back(read_operand(files[k], report.more_inputs[k], report, placements[k]));
    parts.push_back({&meshes.back(), operation, 0, radii[k]});
  }
  blend_and_write(
      [&](Blend_mesh& out, const Fillet_options& with) {
        return unchecked::corefine_and_fillet_all(first, parts, out, with);
      },
      fillet, o.output, report);
}

void add_transforms(CLI::App& command, Boolean_options& options) {
  for (std::size_t k = 0; k < options.transforms.size(); ++k) {
    const auto given = [&options, k](const std::string& text) { options.transforms[k] = text; };
    CLI::Option* transform =
        command.add_option_function<std::string>(transform_flag(k), given,
                                                 "Places B: 12 numbers \"m00 m01 ... m23\", a 3 x 4 matrix row by row; "
                                                 "--transform-c ... --transform-h likewise");
    transform->type_name("MATRIX");
    if (k > 0) transform->group("");  // one line of help is enough
  }
}

void add_command(CLI::App& app, int& exit_status, const std::string& word, Boolean_operation operation,
                 const std::string& help) {
  CLI::App* command = app.add_subcommand(word, help);
  const auto options = std::make_shared<Boolean_options>();
  command->add_option("A", options->a, "First body")->type_name("MESH")->required();
  command->add_option("B", options->b, "Second body")->type_name("MESH")->required();
  command->add_option("C", options->further, "Further bodies, up to H: each is put to the result of those before")
      ->type_name("MESH");
  add_mesh_output(*command, options->output);
  add_curvature_output(*command, options->output);
  add_transforms(*command, *options);
  add_ball_options(*command, options->ball,
                   "Radius of the ball, length units of the mesh; or one per body after the first, with commas; or "
                   "FRACTION:RADIUS,FRACTION:RADIUS,... along each curve");
  command->callback([=, &exit_status] {
    std::vector<std::string> inputs = options->after_first();
    inputs.insert(inputs.begin(), options->a);
    exit_status = run_job(word, options->output, inputs, [&](Report& report) { compute(*options, operation, report); });
  });
}

}  // namespace

void add_boolean_commands(CLI::App& app, int& exit_status) {
  const std::string tail = "; with --radius, blends the curves in which their surfaces meet";
  add_command(app, exit_status, "union", Boolean_operation::union_, "Unites A, B and further bodies" + tail);
  add_command(app, exit_status, "intersection", Boolean_operation::intersection,
              "Keeps what A, B and further bodies share" + tail);
  add_command(app, exit_status, "difference", Boolean_operation::difference,
              "Cuts B and further bodies out of A" + tail);
}

}  // namespace cgal_blend::cli
