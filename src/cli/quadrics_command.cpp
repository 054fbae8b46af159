// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.h"
#include "failure.h"
#include "job.h"
#include "paths.h"
#include "scene.h"

#include <cgal_blend/mesh_io.h>
#include <cgal_blend/surface_blend_fit.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <memory>

namespace cgal_blend::cli {

namespace {

struct Quadrics_options {
  std::string scene, step, labels;
  double step_tolerance = 1e-4;
  Output_options output;
};

/// The steepest angle between a blend's true normals and its surfaces' ones; 0 but for rounding.
double tangency_deg(const Surface_blend& blend) {
  constexpr int samples = 64;
  double largest = 0;
  for (int i = 0; i < samples; ++i)
    for (const int side : {0, 1}) {
      const double s = (i + 0.5) / samples;
      const Vector_3 a = blend.normal(s, side), b = blend.boundary_point(side, s).normal;
      largest = std::max(largest, std::atan2(std::sqrt(CGAL::cross_product(a, b).squared_length()), std::abs(a * b)));
    }
  return largest * 180 / CGAL_PI;
}

std::size_t count_faces(const Blend_body& body, Face_label::Kind kind, std::size_t index) {
  return static_cast<std::size_t>(std::count_if(body.labels.begin(), body.labels.end(), [&](const Face_label& label) {
    return label.kind == kind && label.index == index;
  }));
}

Json blends_json(const Scene& scene, const Blend_body& body) {
  Json json = Json::array();
  for (std::size_t i = 0; i < scene.blends.size(); ++i) {
    const Body_blend& b = scene.blends[i];
    json.push_back({{"status", name(Status::ok)},
                    {"surfaces", {scene.names[b.surfaces[0]], scene.names[b.surfaces[1]]}},
                    {"closed", b.blend.is_closed()},
                    {"degree", b.blend.degree()},
                    {"faces", count_faces(body, Face_label::Kind::blend, i)},
                    {"distance_factor", scene.factors[i]},
                    {"tangency_deg", tangency_deg(b.blend)}});
  }
  return json;
}

std::vector<Bspline_surface> fitted(const Scene& scene, double relative_tolerance, Json& blends) {
  std::vector<Bspline_surface> surfaces;
  for (std::size_t i = 0; i < scene.blends.size(); ++i) {
    const Surface_blend& blend = scene.blends[i].blend;
    const auto& length = blend.correspondence().length;
    const auto surface = fit_bspline(blend, relative_tolerance * std::max(length[0], length[1]));
    if (!surface) throw Failure(Exit::blend, "not_supported", "a blend could not be fitted within --step-tolerance");
    blends[i]["step_error"] = surface->error;
    blends[i]["step_normal_error_deg"] = surface->normal_error * 180 / CGAL_PI;
    blends[i]["step_knots"] = surface->knots.size();
    surfaces.push_back(*surface);
  }
  return surfaces;
}

/// One line per face: what it is a part of.
void write_labels(const std::string& path, const Scene& scene, const Blend_body& body) {
  std::ofstream out(path, std::ios::binary);
  for (const Face_label& label : body.labels) {
    out << name(label.kind);
    if (label.kind == Face_label::Kind::surface) out << ' ' << scene.names[label.index];
    if (label.kind == Face_label::Kind::blend) out << ' ' << label.index + 1;
    out << '\n';
  }
  if (!out.flush()) throw Failure(Exit::usage, "output_unwritable", "cannot write " + in_quotes(path));
}

void check_paths(const Quadrics_options& options) {
  if (!options.labels.empty()) check_labels_path(options.labels, {options.scene, options.output.mesh, options.step});
  if (options.step.empty()) return;
  if (!has_step()) throw usage_failure("--step: this program was built without Open CASCADE, which STEP files need");
  check_step_path(options.step, {options.scene, options.output.mesh, options.output.report});
}

void make_report(const Quadrics_options& options, const Scene& scene, const Blend_body& body, Report& report) {
  report.output =
      body.closed ? validity_json(options.output.mesh, body.validity) : input_json(options.output.mesh, body.mesh);
  report.output["closed"] = body.closed;
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i)
    report.output["surface_faces"][scene.names[i]] = count_faces(body, Face_label::Kind::surface, i);
  report.output["cap_faces"] = count_faces(body, Face_label::Kind::cap, 0);
}

void blend_quadrics(const Quadrics_options& options, Report& report) {
  check_paths(options);
  report.input = {{"file", options.scene}};
  std::optional<Scene> scene;
  Blend_body body;
  {
    const Timer timer(report.stages.blend);
    scene = read_scene(options.scene);
    body = make_blend_body(scene->surfaces, scene->blends, scene->body);
  }
  if (!body.ok()) throw Failure(body.diagnosis);
  report.blends = blends_json(*scene, body);
  std::vector<Bspline_surface> surfaces;
  if (!options.step.empty()) surfaces = fitted(*scene, options.step_tolerance, report.blends);
  {
    const Timer timer(report.write);
    if (!options.step.empty()) write_step(options.step, surfaces);
    if (!options.labels.empty()) write_labels(options.labels, *scene, body);
    write_mesh(options.output.mesh, body.mesh);
  }
  make_report(options, *scene, body, report);
  if (options.output.summary())
    std::cout << options.output.mesh << ": " << body.mesh.number_of_vertices() << " vertices, "
              << body.mesh.number_of_faces() << " faces, " << (body.closed ? "closed" : "open") << ", "
              << scene->blends.size() << " blends\n";
}

}  // namespace

void add_quadrics_command(CLI::App& app, int& exit_status) {
  CLI::App* command =
      app.add_subcommand("quadrics", "Blends quadrics and other surfaces along curves, as a scene file describes");
  const auto options = std::make_shared<Quadrics_options>();
  command->add_option("SCENE", options->scene, "Surfaces and blends, as JSON")->type_name("JSON")->required();
  add_mesh_output(*command, options->output);
  command->add_option("--step", options->step, "Also write the blends as B-spline surfaces")->type_name("FILE.step");
  command->add_option("--labels", options->labels, "Also write what each face is a part of, one line per face")
      ->type_name("FILE");
  add_number(*command, "--step-tolerance", options->step_tolerance, 1e-9, 0.1, false,
             "Largest distance of the B-spline surfaces from the blends, of the longer curve's length");
  command->callback([=, &exit_status] {
    exit_status = run_job("quadrics", options->output, {options->scene},
                          [&](Report& report) { blend_quadrics(*options, report); });
  });
}

}  // namespace cgal_blend::cli
