// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.h"
#include "failure.h"
#include "job.h"
#include "paths.h"
#include "quadric_pair_file.h"

#include <cgal_blend/quadric_intersection.h>

#include <fstream>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>

namespace cgal_blend::cli {

namespace {

struct Intersection_command_options {
  std::string input, curves;
  Output_options output;
};

Json point_json(const Quadric_3::Point_3& p) { return Json{p.x(), p.y(), p.z()}; }

Json component_json(const Intersection_curve& curve, std::size_t samples) {
  Json points = Json::array();
  for (const auto& p : curve.sample(samples)) points.push_back(point_json(p));
  return {{"closed", curve.is_closed()},
          {"isolated", curve.is_isolated()},
          {"degree", curve.degree()},
          {"multiplicity", curve.multiplicity()},
          {"points", points}};
}

Json intersection_json(const Quadric_intersection& intersection, std::size_t samples) {
  Json singular = Json::array(), components = Json::array();
  for (const auto& p : intersection.singular_points) singular.push_back(point_json(p));
  for (const Intersection_curve& curve : intersection.components) components.push_back(component_json(curve, samples));
  return {{"status", name(intersection.status)},
          {"type", intersection.type},
          {"segre", intersection.segre},
          {"singular_points", singular},
          {"components", components}};
}

Quadric_intersection intersect(const Quadric_pair& pair) {
  try {
    return intersect_quadrics(pair.a, pair.b, {pair.box});
  } catch (const std::range_error& error) {
    throw Failure(Exit::blend, name(Status::not_supported), std::string("too nearly degenerate: ") + error.what());
  }
}

void intersect(const Intersection_command_options& options, Report& report) {
  check_curves_path(options.curves, options.input);
  std::optional<Quadric_pair> pair;
  {
    const Timer timer(report.read);
    pair = read_quadric_pair(options.input);
  }
  report.input = {{"file", options.input}};
  const Quadric_intersection intersection = intersect(*pair);
  const std::string text = intersection_json(intersection, pair->samples).dump() + "\n";
  {
    const Timer timer(report.write);
    std::ofstream out(options.curves, std::ios::binary);
    if (!(out << text << std::flush))
      throw Failure(Exit::usage, "output_unwritable", "cannot write " + in_quotes(options.curves));
  }
  report.output = {{"file", options.curves},
                   {"status", name(intersection.status)},
                   {"type", intersection.type},
                   {"components", intersection.components.size()}};
  if (options.output.summary()) std::cout << options.curves << ": " << intersection.type << "\n";
}

}  // namespace

void add_intersect_quadrics_command(CLI::App& app, int& exit_status) {
  CLI::App* command = app.add_subcommand("intersect-quadrics", "Finds the curves that two quadrics have in common");
  const auto options = std::make_shared<Intersection_command_options>();
  command->add_option("IN", options->input, "Two quadrics: JSON with lists 'a' and 'b' of 10 coefficients")
      ->type_name("JSON")
      ->required();
  command->add_option("-o,--output", options->curves, "Curves to write, as JSON")->required()->type_name("OUT");
  add_report_options(*command, options->output);
  command->callback([=, &exit_status] {
    exit_status = run_job("intersect-quadrics", options->output, {options->input, options->curves},
                          [&](Report& report) { intersect(*options, report); });
  });
}

}  // namespace cgal_blend::cli
