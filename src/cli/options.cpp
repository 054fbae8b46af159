// SPDX-License-Identifier: GPL-3.0-or-later
#include "options.h"

#include "failure.h"
#include "values.h"

#include <cmath>

namespace cgal_blend::cli {

Fillet_options Ball_options::checked_but_radius() const {
  Fillet_options options = fillet;
  options.profile = parse_profile(profile, "--profile");
  options.mode = parse_mode(mode.empty() ? (coarse > 0 ? "map" : "stitch") : mode);
  options.coarse_faces = static_cast<std::size_t>(coarse);
  if (coarse > 0 && options.mode == Blend_mode::stitch)
    throw usage_failure("--coarse keeps the connectivity; it cannot be had with --mode stitch");
  options.samples = static_cast<std::size_t>(samples);
  return options;
}

Fillet_options Ball_options::checked() const {
  Fillet_options options = checked_but_radius();
  if (radius) options.law = parse_radius(*radius);
  return options;
}

std::vector<std::optional<Radius_law>> Ball_options::checked_radii(std::size_t count) const {
  if (!radius) return std::vector<std::optional<Radius_law>>(count);
  const std::vector<Radius_law> radii = parse_radii(*radius, count);
  return {radii.begin(), radii.end()};
}

void add_report_options(CLI::App& command, Output_options& options) {
  command.add_option("--report", options.report, "Write a report as JSON; '-' is standard output")->type_name("FILE");
  command.add_flag("--quiet", options.quiet, "No summary and no progress line");
}

void add_mesh_output(CLI::App& command, Output_options& options, const std::string& help) {
  command.add_option("-o,--output", options.mesh, help)->required()->type_name("OUT");
  add_report_options(command, options);
}

void add_curvature_output(CLI::App& command, Output_options& options) {
  command
      .add_option("--curvature", options.curvature,
                  "Also write the result coloured by mean curvature: blue concave, red convex")
      ->type_name("FILE.ply");
}

CLI::Option* add_number(CLI::App& command, const std::string& flag, double& value, double low, double high, bool open,
                        const std::string& help, bool whole) {
  const auto read = [=, &value](const std::string& text) {
    const auto number = parse_number(text);
    if (!number) throw CLI::ValidationError(flag, "'" + text + "' is not a number");
    if (whole && *number != std::floor(*number)) throw CLI::ValidationError(flag, text + " is not a whole number");
    const bool inside = open ? *number > low && *number < high : *number >= low && *number <= high;
    if (!inside) {
      const auto short_text = [](double x) { return CLI::detail::to_string(x); };
      throw CLI::ValidationError(flag, text + " is not between " + short_text(low) + " and " + short_text(high));
    }
    value = *number;
  };
  return command.add_option_function<std::string>(flag, read, help);
}

void add_ball_options(CLI::App& command, Ball_options& options, const std::string& radius_help) {
  const auto given = [&options](const std::string& text) { options.radius = text; };
  command.add_option_function<std::string>("--radius", given, radius_help)->type_name("R");
  command
      .add_option(
          "--profile", options.profile,
          "Cross-section of the blend: arc, chamfer, conic:W0, sharp, g2, hermite[:M1,M2] or bspline:X,Y;X,Y;...")
      ->capture_default_str()
      ->type_name("NAME");
  command
      .add_option("--mode", options.mode,
                  "How the blend is joined to the mesh: stitch (cut and sewn in) or map (connectivity kept, vertices "
                  "moved) [stitch]")
      ->type_name("NAME");
  add_number(command, "--coarse", options.coarse, 0, 1e9, false,
             "Blend the mesh decimated to about so many faces and restore the detail; implies --mode map; 0: off [0]",
             true)
      ->type_name("N");
  add_number(command, "--chord-tolerance", options.fillet.chord_tolerance, 1e-6, 0.3, false,
             "Largest distance between arc and facets, as a fraction of the radius [0.002]")
      ->type_name("F");
  add_number(command, "--samples", options.samples, 0, 1e6, false,
             "About so many profiles along each curve, 0: as the chord tolerance asks for [0]", true)
      ->type_name("N");
  add_number(command, "--chord-ratio", options.fillet.chord_ratio, 0, 1, false,
             "Divide steps of the ball whose chord height over length is larger, 0: by the chord tolerance [0]")
      ->type_name("F");
  add_number(command, "--smooth-angle", options.fillet.smooth_angle, 0, 180, true,
             "Faces whose normals differ by less belong to one smooth surface [40]")
      ->type_name("DEG");
  const auto leave = [&options](std::int64_t) { options.fillet.mend_spine = false; };
  command.add_flag_function("--no-mend", leave,
                            "Refuse where the ball's path crosses itself, instead of joining over the loop");
  command.add_flag("--keep-going", options.fillet.keep_going,
                   "Leave curves sharp that cannot be blended; blend the others");
}

}  // namespace cgal_blend::cli
