// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.h"
#include "failure.h"
#include "job.h"
#include "paths.h"
#include "progress.h"
#include "values.h"

#include <cgal_blend/fuse.h>
#include <cgal_blend/mesh_io.h>

#include <algorithm>
#include <array>
#include <deque>
#include <fstream>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cgal_blend::cli {

namespace {

struct Fuse_command {
  std::string lower, upper;  // as typed: files with commas
  std::optional<std::string> lower_plane, upper_plane, place_upper, implicit, eta, weight;
  std::optional<double> rho;
  double step = 0.2, edge = 0, grading = 1, least_angle = 20;
  std::string labels;
  Output_options output;

  [[nodiscard]] std::vector<std::string> inputs() const {
    std::vector<std::string> all = split(lower, ",", false);
    for (const std::string& file : split(upper, ",", false)) all.push_back(file);
    return all;
  }
};

std::vector<double> numbers(const std::string& text, std::size_t count, const std::string& flag) {
  const std::vector<std::string> words = split(text, ",", true);
  if (words.size() != count)
    throw usage_failure(flag + ": " + std::to_string(count) + " numbers with commas are needed, not " +
                        std::to_string(words.size()));
  std::vector<double> values;
  for (const std::string& word : words) {
    const auto number = parse_number(word);
    if (!number) throw usage_failure(flag + ": '" + word + "' is not a number");
    values.push_back(*number);
  }
  return values;
}

std::optional<Cut_plane> parse_plane(const std::optional<std::string>& text, const std::string& flag) {
  if (!text) return std::nullopt;
  const std::vector<double> v = numbers(*text, 6, flag);
  const Cut_plane plane{{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
  if (const Diagnosis bad = check(plane); !bad.ok()) throw usage_failure(flag + ": " + bad.detail);
  return plane;
}

/// The plane moves with what it cuts: its normal by the inverse transpose.
void place(const Transform& placement, std::optional<Cut_plane>& plane) {
  if (!placement || !plane) return;
  const auto inverse = placement->inverse();
  const Vector_3 n = plane->normal;
  const auto entry = [&](int k) { return inverse.m(0, k) * n.x() + inverse.m(1, k) * n.y() + inverse.m(2, k) * n.z(); };
  plane = Cut_plane{placement->transform(plane->point), {entry(0), entry(1), entry(2)}};
}

Opening_model model_of(const Fuse_command& command) {
  const std::string word = command.implicit.value_or(command.rho ? "rbf" : "sdf");
  if (command.rho && word != "rbf") throw usage_failure("--rho is the offset of --implicit rbf");
  if (word == "sdf") return distance_opening();
  if (word == "grid") return distance_grid_opening();
  if (word != "rbf") throw usage_failure("--implicit: unknown form '" + word + "'; known: rbf, sdf, grid");
  Rbf_options options;
  if (command.rho) options.rho = *command.rho;
  return rbf_opening(options);
}

Fuse_options options_of(const Fuse_command& command) {
  Fuse_options options;
  options.model = model_of(command);
  if (command.eta) {
    const std::vector<double> eta = numbers(*command.eta, 2, "--eta");
    for (const double value : eta)
      if (!(value >= 0 && value <= 1)) throw usage_failure("--eta: both values must lie between 0 and 1");
    options.eta = {eta[0], eta[1]};
  }
  if (command.weight) {
    const std::vector<double> weight = numbers(*command.weight, 2, "--weight");
    for (const double value : weight)
      if (!(value >= 1e-6 && value <= 1e6)) throw usage_failure("--weight: both values must lie between 1e-6 and 1e6");
    options.weight = {weight[0], weight[1]};
  }
  options.step = command.step;
  options.edge = command.edge;
  options.grading = command.grading;
  options.least_angle = command.least_angle;
  return options;
}

/// The meshes of both sides, read and checked.
struct Parts {
  std::deque<Blend_mesh> meshes;  // their addresses stay
  std::array<Fusion_side, 2> sides;
};

void read_side(const std::string& files, const Transform& placement, Fusion_side& side, Parts& parts, Report& report) {
  for (const std::string& file : split(files, ",", false)) {
    {
      const Timer timer(report.read);
      parts.meshes.push_back(read_mesh(file));
      cli::apply(placement, parts.meshes.back());
    }
    const Blend_mesh& mesh = parts.meshes.back();
    if (report.input.is_null())
      report.input = input_json(file, mesh);
    else
      report.more_inputs.push_back(input_json(file, mesh));
    const Timer timer(report.check_input);
    if (const Diagnosis bad = check_fusion_part(mesh, side.plane); !bad.ok()) throw Failure(bad, in_quotes(file));
    side.meshes.push_back(&mesh);
  }
}

Json fusion_json(const Fuse_outcome& outcome) {
  return {{"status", name(outcome.diagnosis.status)},
          {"rings", outcome.rings},
          {"one_sided", outcome.one_sided},
          {"angle_deg", outcome.angle},
          {"height", outcome.height},
          {"faces", outcome.transition_faces.size()},
          {"tangency_mean_deg", outcome.tangency_mean},
          {"tangency_deg", outcome.tangency_max},
          {"timings_ms",
           {{"cut", outcome.times.cut},
            {"openings", outcome.times.openings},
            {"tessellate", outcome.times.tessellate},
            {"assemble", outcome.times.assemble}}}};
}

void make_report(const Fuse_command& command, const Fuse_outcome& outcome, const Blend_mesh& mesh, Report& report) {
  Fillet_outcome as_blend;  // the entry of the output is the same for all commands
  as_blend.volume = outcome.volume;
  as_blend.area = outcome.area;
  as_blend.blend_faces = outcome.transition_faces;
  as_blend.kept_faces = outcome.kept_faces;
  report.output = output_json(command.output.mesh, mesh, as_blend);
  report.output["euler_characteristic"] = outcome.euler_characteristic;
}

/// One line per face: what it is a part of.
void write_labels(const std::string& path, const Fuse_outcome& outcome, const Blend_mesh& mesh) {
  std::ofstream out(path, std::ios::binary);
  const std::size_t transition = mesh.number_of_faces() - outcome.transition_faces.size();
  for (std::size_t i = 0; i < mesh.number_of_faces(); ++i)
    out << (i < outcome.kept_faces ? "kept" : i < transition ? "cut" : "transition") << '\n';
  if (!out.flush()) throw Failure(Exit::usage, "output_unwritable", "cannot write " + in_quotes(path));
}

Fuse_outcome fuse_with_progress(const Parts& parts, Fuse_options options, const Fuse_command& command,
                                Blend_mesh& out) {
  Progress_line line(!command.output.quiet);
  options.progress = [&line](double fraction) {
    line.show(fraction);
    return true;
  };
  return unchecked::fuse(parts.sides[0], parts.sides[1], out, options);
}

void print(const Fuse_command& command, const Fuse_outcome& outcome, const Blend_mesh& mesh) {
  std::cout << command.output.mesh << ": " << mesh.number_of_vertices() << " vertices, " << mesh.number_of_faces()
            << " faces, closed, manifold, no self-intersections; volume " << outcome.volume << ", area " << outcome.area
            << "\n  transition from " << outcome.rings[0] << " to " << outcome.rings[1] << " rings, "
            << outcome.transition_faces.size() << " faces, tangent within " << outcome.tangency_max << " degrees ("
            << outcome.tangency_mean << " on average)\n";
}

void fuse(const Fuse_command& command, Report& report) {
  if (!command.labels.empty()) {
    std::vector<std::string> others = command.inputs();
    others.insert(others.end(), {command.output.mesh, command.output.report});
    check_labels_path(command.labels, others);
  }
  const Fuse_options options = options_of(command);
  Parts parts;
  parts.sides[0].plane = parse_plane(command.lower_plane, "--lower-plane");
  parts.sides[1].plane = parse_plane(command.upper_plane, "--upper-plane");
  Transform placement;
  if (command.place_upper) placement = parse_transform(*command.place_upper, "--place-upper");
  place(placement, parts.sides[1].plane);
  read_side(command.lower, {}, parts.sides[0], parts, report);
  read_side(command.upper, placement, parts.sides[1], parts, report);
  Blend_mesh mesh;
  Fuse_outcome outcome;
  {
    const Timer timer(report.stages.blend);
    outcome = fuse_with_progress(parts, options, command, mesh);
  }
  report.stages.validate = outcome.times.validate;
  report.stages.blend -= outcome.times.validate;
  report.blends.push_back(fusion_json(outcome));
  if (!outcome.ok()) throw Failure(outcome.diagnosis);
  {
    const Timer timer(report.write);
    if (!command.labels.empty()) write_labels(command.labels, outcome, mesh);
    write_mesh(command.output.mesh, mesh);
  }
  make_report(command, outcome, mesh, report);
  if (command.output.summary()) print(command, outcome, mesh);
}

void add_planes(CLI::App& app, Fuse_command& o) {
  const auto set = [](std::optional<std::string>& to) { return [&to](const std::string& text) { to = text; }; };
  app.add_option("--lower", o.lower, "Meshes of the lower side, with commas")->type_name("MESH,...")->required();
  app.add_option("--upper", o.upper, "Meshes of the upper side, with commas")->type_name("MESH,...")->required();
  for (const bool low : {true, false}) {
    const std::string side = low ? "lower" : "upper";
    app.add_option_function<std::string>("--" + side + "-plane", set(low ? o.lower_plane : o.upper_plane),
                                         "Cuts the " + side +
                                             " meshes: a point, and a normal that points away from "
                                             "what is kept; without it their holes are joined")
        ->type_name("PX,PY,PZ,NX,NY,NZ");
  }
  app.add_option_function<std::string>("--place-upper", set(o.place_upper),
                                       "Places the upper meshes, and their plane with them: 12 numbers \"m00 m01 ... "
                                       "m23\", a 3 x 4 matrix row by row")
      ->type_name("MATRIX");
}

void add_shape(CLI::App& app, Fuse_command& o) {
  const auto set = [](std::optional<std::string>& to) { return [&to](const std::string& text) { to = text; }; };
  app.add_option_function<std::string>("--implicit", set(o.implicit),
                                       "Implicit form of the openings: sdf (signed distance), grid (the same, sampled) "
                                       "or rbf (thin plate spline) [sdf]")
      ->type_name("NAME");
  const auto read_rho = [&o](const std::string& text) {
    o.rho = parse_number(text);
    if (!o.rho || !(*o.rho > 0)) throw CLI::ValidationError("--rho", "'" + text + "' is not a number greater than 0");
  };
  app.add_option_function<std::string>("--rho", read_rho, "Offset of the constraints of rbf, length units")
      ->type_name("X");
  app.add_option_function<std::string>("--eta", set(o.eta),
                                       "The two free control values of w = eta(z), 0 to 1 [0.4,0.6: w = z]")
      ->type_name("A,B");
  app.add_option_function<std::string>(
         "--weight", set(o.weight),
         "Weights of the lower and the upper side: the heavier keeps its shape the longer "
         "[1,1]")
      ->type_name("A,B");
  add_number(app, "--step", o.step, 1e-3, 100, false,
             "Distance of the shifted sections, of the rings' mean edge [0.2]");
  add_number(app, "--edge", o.edge, 0, 1e300, true, "Edge length of the transition, length units [that of the rings]");
  add_number(app, "--grading", o.grading, 1, 100, false, "How many times larger facets grow away from the rings [1]");
  add_number(app, "--least-angle", o.least_angle, 0, 30, false,
             "What no angle of the transition away from the rings should fall below, degrees [20]");
  app.add_option("--labels", o.labels, "Also write what each face is: kept, cut or transition, one line per face")
      ->type_name("FILE");
}

}  // namespace

void add_fuse_command(CLI::App& app, int& exit_status) {
  CLI::App* command = app.add_subcommand("fuse", "Joins cut meshes by a smooth transition between their openings");
  const auto options = std::make_shared<Fuse_command>();
  add_planes(*command, *options);
  add_shape(*command, *options);
  add_mesh_output(*command, options->output);
  command->callback([=, &exit_status] {
    exit_status = run_job("fuse", options->output, options->inputs(), [&](Report& report) { fuse(*options, report); });
  });
}

}  // namespace cgal_blend::cli
