// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_CLI_OPTIONS_H
#define CGAL_BLEND_CLI_OPTIONS_H

#include <cgal_blend/fillet.h>

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace cgal_blend::cli {

/// Where results go; the same for every subcommand.
struct Output_options {
  std::string mesh;       ///< empty: the subcommand writes no mesh
  std::string report;     ///< empty: none; "-": standard output
  std::string curvature;  ///< coloured PLY of the result; empty: none
  bool quiet = false;

  [[nodiscard]] bool report_on_stdout() const { return report == "-"; }
  /// True if a summary for people belongs on standard output.
  [[nodiscard]] bool summary() const { return !quiet && !report_on_stdout(); }
};

/// The ball and what it leaves, as typed; one reading for every subcommand that blends.
struct Ball_options {
  std::optional<std::string> radius;
  std::string profile = "arc";
  std::string mode;  ///< empty: stitch
  double samples = 0;
  double coarse = 0;
  Fillet_options fillet;

  /// Returns the options of the engine, the radius as a law if one is given; throws `Failure` for what cannot be accepted.
  [[nodiscard]] Fillet_options checked() const;
  /// The same but for the radius, which is left out.
  [[nodiscard]] Fillet_options checked_but_radius() const;
  /// Returns one radius for each of `count` booleans, or none for any; throws `Failure`.
  [[nodiscard]] std::vector<std::optional<Radius_law>> checked_radii(std::size_t count) const;
};

void add_report_options(CLI::App& command, Output_options& options);
void add_mesh_output(CLI::App& command, Output_options& options,
                     const std::string& help = "Mesh to write: .off, .obj, .ply or .stl");
void add_curvature_output(CLI::App& command, Output_options& options);
void add_ball_options(
    CLI::App& command, Ball_options& options,
    const std::string& radius_help =
        "Radius of the ball, length units of the mesh; or FRACTION:RADIUS,FRACTION:RADIUS,... along each curve");

/// A numeric option that has to lie between two bounds, and be `whole` if that is asked for; the message names them.
CLI::Option* add_number(CLI::App& command, const std::string& flag, double& value, double low, double high, bool open,
                        const std::string& help, bool whole = false);

}  // namespace cgal_blend::cli

#endif
