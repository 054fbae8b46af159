// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_CLI_REPORT_H
#define CGAL_BLEND_CLI_REPORT_H

#include <cgal_blend/blend_mesh.h>
#include <cgal_blend/fillet.h>
#include <cgal_blend/validate.h>

#include <nlohmann/json.hpp>

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

namespace cgal_blend::cli {

using Json = nlohmann::ordered_json;

/// Flaws of the input that were accepted; the output has the same.
struct Flaw_counts {
  std::size_t self_intersections = 0, degenerate_faces = 0, short_edges = 0;

  [[nodiscard]] bool any() const { return self_intersections + degenerate_faces + short_edges > 0; }
};

/// What `--report` writes; filled in as a command goes on, complete also when it ends early.
/// Numbers that are not finite come out as null.
struct Report {
  std::string command;
  std::string status = name(Status::ok);
  std::string message = describe(Status::ok);
  Json input, output;             ///< null until known
  std::vector<Json> more_inputs;  ///< of the second body and further ones, null until known
  Flaw_counts accepted;           ///< none unless asked for
  Json curvature;                 ///< null if nobody asked
  Json blends = Json::array();
  double read = 0, check_input = 0, write = 0;  ///< milliseconds
  Stage_times stages;

  [[nodiscard]] Json json() const;
};

[[nodiscard]] Json input_json(const std::string& file, const Blend_mesh& mesh);
/// Adds the counts to the entry of a mesh.
void add_flaws(const Flaw_counts& flaws, Json& entry);

[[nodiscard]] Json blends_json(const std::vector<Blend_report>& blends);

/// The `output` entry for a mesh that the engine has validated.
[[nodiscard]] Json output_json(const std::string& file, const Blend_mesh& mesh, const Fillet_outcome& outcome);

/// The `output` entry for a mesh that has been checked.
[[nodiscard]] Json validity_json(const std::string& file, const Validity_report& validity);

/// Writes the report to a file or, for "-", to standard output; returns false if that fails.
[[nodiscard]] bool write_report(const Report& report, const std::string& path);

/// Adds the time of its own life to a number of milliseconds.
class Timer {
 public:
  explicit Timer(double& milliseconds) : milliseconds_(milliseconds) {}
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;
  ~Timer() { milliseconds_ += std::chrono::duration<double, std::milli>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  double& milliseconds_;
  Clock::time_point start_ = Clock::now();
};

}  // namespace cgal_blend::cli

#endif
