// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge_curve.h"
#include "bridge_run.h"
#include "commands.h"
#include "failure.h"
#include "job.h"
#include "paths.h"
#include "values.h"

#include <cgal_blend/filled_mesh.h>
#include <cgal_blend/mesh_io.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <memory>

namespace cgal_blend::cli {

namespace {

constexpr double any = 1e300;  // bounds of numbers that the engine judges

struct End_texts {
  std::optional<std::string> at, radius, curve, zero;
  double lambda = Bridge_end().lambda;
};

struct Command_options {
  std::string a, b, scene, labels;
  std::string shape_option;  // any one of those given that scenes have entries for
  std::optional<std::string> transform, drag;
  std::array<End_texts, 2> ends;
  bool cross = false;
  double order = Bridge_options().order, segments = 0, rows = 0;
  Bridge_options bridge;
  Output_options output;
};

char letter(std::size_t end) { return end == 0 ? 'a' : 'b'; }

std::string flag(const std::string& name, std::size_t end) { return "--" + name + "-" + letter(end); }

std::vector<double> parse_numbers(const std::string& text, std::size_t count, const std::string& subject) {
  const std::vector<std::string> parts = split(text, ", \t", false);
  if (parts.size() != count)
    throw usage_failure(subject + ": " + std::to_string(count) + " numbers are needed, not '" + text + "'");
  std::vector<double> numbers;
  for (const std::string& part : parts) {
    const auto number = parse_number(part);
    if (!number) throw usage_failure(subject + ": '" + part + "' is not a number");
    numbers.push_back(*number);
  }
  return numbers;
}

Bridge_end read_end(const Command_options& options, std::size_t k) {
  const End_texts& texts = options.ends[k];
  Bridge_end end;
  if (!options.cross) {
    if (!texts.at) throw usage_failure(flag("at", k) + " is needed: the spot where the bridge ends");
    const auto at = parse_numbers(*texts.at, 3, flag("at", k));
    end.spot = {at[0], at[1], at[2]};
  } else if (texts.at || texts.zero) {
    throw usage_failure("--cross takes the intersection curve in place of spots and directions");
  }
  std::optional<double> radius;
  if (texts.radius) {
    radius = end.radius = parse_numbers(*texts.radius, 1, flag("radius", k))[0];
    if (!(*radius > 0)) throw usage_failure(flag("radius", k) + ": the radius must be greater than 0");
  }
  if (texts.curve)
    end.curve = parse_curve(*texts.curve, radius, flag("curve", k));
  else if (!radius)
    throw usage_failure(flag("radius", k) + " or " + flag("curve", k) + " is needed");
  if (texts.zero) {
    const auto zero = parse_numbers(*texts.zero, 3, flag("zero", k));
    end.zero_direction = Vector_3(zero[0], zero[1], zero[2]);
  }
  end.lambda = texts.lambda;
  return end;
}

Drag_request parse_drag(const std::string& text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) throw usage_failure("--drag: must be S,T:X,Y,Z, not '" + text + "'");
  const auto place = parse_numbers(text.substr(0, colon), 2, "--drag"),
             to = parse_numbers(text.substr(colon + 1), 3, "--drag");
  if (!(place[1] >= 0 && place[1] <= 1)) throw usage_failure("--drag: T must lie between 0 and 1");
  return {place[0], place[1], {to[0], to[1], to[2]}};
}

/// All that the command line says but for the meshes.
Bridge_step read_step(const Command_options& options) {
  Bridge_step step;
  for (std::size_t k = 0; k < 2; ++k) step.bridge.ends[k] = read_end(options, k);
  step.bridge.options = options.bridge;
  step.bridge.options.order = static_cast<int>(options.order);
  step.bridge.options.segments = static_cast<std::size_t>(options.segments);
  step.bridge.options.rows = static_cast<std::size_t>(options.rows);
  if (options.drag) step.drag = parse_drag(*options.drag);
  if (options.cross && options.b.empty()) throw usage_failure("--cross needs a second body");
  if (options.cross && options.drag) throw usage_failure("--cross: there is no drag around an intersection");
  if (options.cross) step.crossing = 1;
  return step;
}

void check_body(const Blend_mesh& body, bool holes_allowed, const std::string& name) {
  const Diagnosis bad = check_but_for_holes(body, holes_allowed, "; --fill-holes accepts holes within contact curves");
  if (!bad.ok()) throw Failure(bad, name);
}

Blend_mesh read_body(const std::string& path, const Command_options& options, Json& entry, Report& report,
                     const Transform& placement = {}) {
  Blend_mesh mesh = read_placed(path, entry, report, placement);
  const Timer timer(report.check_input);
  check_body(mesh, options.bridge.fill_holes, in_quotes(path));
  return mesh;
}

Bridge_scene read_bodies(const Command_options& options, Report& report) {
  Bridge_scene scene;
  scene.steps.push_back(read_step(options));
  if (options.transform && options.b.empty()) throw usage_failure("--transform-b: there is no second body");
  Transform placement;
  if (options.transform) placement = parse_transform(*options.transform, "--transform-b");
  scene.names.emplace_back("A");
  scene.bodies.push_back(read_body(options.a, options, report.input, report));
  if (options.b.empty()) return scene;
  report.more_inputs.resize(1);
  scene.names.emplace_back("B");
  scene.bodies.push_back(read_body(options.b, options, report.more_inputs[0], report, placement));
  return scene;
}

Bridge_scene read_scene_file(const Command_options& options, Report& report) {
  if (!options.a.empty()) throw usage_failure("--scene takes the place of A and B");
  if (!options.shape_option.empty())
    throw usage_failure("--scene: " + options.shape_option + " must be given in the scene file");
  report.input = {{"file", options.scene}};
  Bridge_scene scene;
  {
    const Timer timer(report.read);
    scene = read_bridge_scene(options.scene);
  }
  const Timer timer(report.check_input);
  for (Bridge_step& step : scene.steps) step.bridge.options.fill_holes = options.bridge.fill_holes;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    check_body(scene.bodies[i], options.bridge.fill_holes, "body '" + scene.names[i] + "'");
  return scene;
}

Json output_json(const std::string& file, const Bridged_mesh& bridged) {
  Json json = input_json(file, bridged.mesh);
  const auto count = [&](auto is) { return std::count_if(bridged.labels.begin(), bridged.labels.end(), is); };
  json["closed"] = true;  // the engine hands out nothing that fails its validation
  json["manifold"] = true;
  json["self_intersections"] = 0;
  json["volume"] = bridged.volume;
  json["area"] = bridged.area;
  json["blend_faces"] = count([](const auto& label) { return label.is_bridge; });
  json["kept_faces"] = count([](const auto& label) { return label.kept; });
  return json;
}

void make(const Command_options& options, Report& report) {
  if (options.a.empty() && options.scene.empty()) throw usage_failure("A is needed, or --scene");
  if (!options.labels.empty())
    check_labels_path(options.labels,
                      {options.a, options.b, options.scene, options.output.mesh, options.output.report});
  const Bridge_scene scene = options.scene.empty() ? read_bodies(options, report) : read_scene_file(options, report);
  const Bridged_mesh bridged = make_bridges(scene, report);
  {
    const Timer timer(report.write);
    if (!options.labels.empty()) write_bridge_labels(options.labels, scene, bridged);
    write_mesh(options.output.mesh, bridged.mesh);
  }
  report.output = output_json(options.output.mesh, bridged);
  if (options.output.summary())
    std::cout << options.output.mesh << ": " << bridged.mesh.number_of_vertices() << " vertices, "
              << bridged.mesh.number_of_faces() << " faces, closed, manifold, no self-intersections; volume "
              << bridged.volume << ", area " << bridged.area << ", " << report.blends.size() << " bridges\n";
}

void add_text(CLI::App& command, const std::string& name, std::optional<std::string>& value, const std::string& type,
              const std::string& help) {
  command
      .add_option_function<std::string>(
          name, [&value](const std::string& text) { value = text; }, help)
      ->type_name(type);
}

void add_end(CLI::App& command, std::size_t k, End_texts& end) {
  const std::string which = k == 0 ? "first" : "second";
  add_text(command, flag("at", k), end.at, "X,Y,Z", "Spot of the " + which + " end, on the mesh");
  add_text(command, flag("radius", k), end.radius, "R", "Radius of the contact circle along the surface");
  add_text(command, flag("curve", k), end.curve, "CURVE",
           "Contact curve: circle, ellipse:A,B, rect:A,B[,CORNER], star:DEPTH,ARMS, cross:A,B[,CORNER], or a file of "
           "lines \"ANGLE DISTANCE\" [circle]");
  add_text(command, flag("zero", k), end.zero, "X,Y,Z", "Direction of angle 0 of the curve");
  add_number(command, flag("lambda", k), end.lambda, -any, any, false,
             "How far the surface is followed inwards, in [0, 1): 0 up to the spot [0.5]");
}

void add_shape(CLI::App& command, Command_options& o) {
  add_number(command, "--mu", o.bridge.mu, -any, any, false,
             "In (0, 1): towards 1 the bridge follows the first end longer [0.5]");
  add_number(command, "--order", o.order, -1e6, 1e6, false, "1, 2 or 3: order of contact with both ends [2]", true);
  add_number(command, "--twist", o.bridge.twist_deg, -1e6, 1e6, false, "Turns the ends against each other [0]")
      ->type_name("DEG");
  add_text(command, "--drag", o.drag, "S,T:X,Y,Z", "Chooses both lambdas so that the point (S,T) comes to (X,Y,Z)");
  add_number(command, "--segments", o.segments, 0, 1e6, false, "Facets around the bridge, 0: by the tolerance [0]",
             true);
  add_number(command, "--rows", o.rows, 0, 1e6, false, "Facets along the bridge, 0: by the tolerance [0]", true);
  add_number(command, "--chord-tolerance", o.bridge.chord_tolerance, 1e-5, 0.1, false,
             "Largest distance of the facets, as a fraction of the larger contact's radius [0.002]");
  add_number(command, "--smooth-angle", o.bridge.smooth_angle, 0, 180, true,
             "Faces whose normals differ by less belong to one smooth surface [40]")
      ->type_name("DEG");
}

}  // namespace

void add_bridge_command(CLI::App& app, int& exit_status) {
  CLI::App* command = app.add_subcommand("bridge", "Joins two spots of one body, or of two, by a smooth tube");
  const auto options = std::make_shared<Command_options>();
  command->add_option("A", options->a, "Body, or first body")->type_name("MESH");
  command->add_option("B", options->b, "Second body")->type_name("MESH");
  add_mesh_output(*command, options->output);
  command->add_option("--scene", options->scene, "Bodies and bridges, as JSON, instead of A and B")->type_name("JSON");
  command->add_option("--labels", options->labels, "Also write what each face is a part of, one line per face")
      ->type_name("FILE");
  const std::size_t for_scenes = command->get_options().size();
  add_text(*command, "--transform-b", options->transform, "MATRIX",
           "Places B: 12 numbers \"m00 m01 ... m23\", a 3 x 4 matrix row by row");
  command->add_flag("--cross", options->cross,
                    "Unite A and B, which cross, and bridge at the radii from their intersection curves");
  for (std::size_t k = 0; k < 2; ++k) add_end(*command, k, options->ends[k]);
  add_shape(*command, *options);
  const std::vector<CLI::Option*> all = command->get_options();
  command->add_flag("--fill-holes", options->bridge.fill_holes,
                    "Meshes may have holes, each within a contact curve; spots may lie within the openings");
  command->callback([=, &exit_status] {
    for (std::size_t i = for_scenes; i < all.size(); ++i)
      if (all[i]->count() > 0) options->shape_option = all[i]->get_name();
    std::vector<std::string> inputs;
    for (const std::string& file : {options->a, options->b, options->scene})
      if (!file.empty()) inputs.push_back(file);
    exit_status = run_job("bridge", options->output, inputs, [&](Report& report) { make(*options, report); });
  });
}

}  // namespace cgal_blend::cli
