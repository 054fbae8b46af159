// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.h"

#include <algorithm>
#include <iostream>
#include <string>

#ifndef CGAL_BLEND_VERSION
#define CGAL_BLEND_VERSION "(unknown version)"
#endif

namespace {

int usage_error(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');  // users and scripts get one line
  std::cerr << "cgal-blend: " << text << " (see cgal-blend --help)" << std::endl;
  return 2;
}

// CLI11 takes an unknown word in place of a subcommand for a missing subcommand.
bool is_unknown_subcommand(const CLI::App& app, const std::string& word) {
  const auto is_named_so = [&](const CLI::App* subcommand) { return subcommand->check_name(word); };
  return !word.empty() && word[0] != '-' && app.get_subcommands(is_named_so).empty();
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Rolling-ball blends on closed triangle meshes", "cgal-blend");
  app.footer(
      "Formats by extension: OFF, OBJ, PLY, STL. Exit status: 0 valid output written; 2 wrong usage or output not\n"
      "writable; 3 input unreadable or not a valid solid; 4 blend impossible or not supported there; 5 defect.\n"
      "Nothing is written unless the exit status is 0.");
  app.set_version_flag("--version", std::string("cgal-blend " CGAL_BLEND_VERSION));
  app.require_subcommand(1);
  int exit_status = 0;
  cgal_blend::cli::add_boolean_commands(app, exit_status);
  cgal_blend::cli::add_fillet_command(app, exit_status);
  cgal_blend::cli::add_check_command(app, exit_status);
  cgal_blend::cli::add_curvature_command(app, exit_status);
  cgal_blend::cli::add_intersect_quadrics_command(app, exit_status);
  cgal_blend::cli::add_quadrics_command(app, exit_status);
  cgal_blend::cli::add_fuse_command(app, exit_status);
  if (argc > 1 && is_unknown_subcommand(app, argv[1]))
    return usage_error("unknown subcommand '" + std::string(argv[1]) + "'");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ArgumentMismatch& error) {
    const std::string text = error.what();
    return usage_error(text.substr(0, text.find(':')) + " needs a value");
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    return usage_error(error.what());
  }
  return exit_status;
}
