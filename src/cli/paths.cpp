// SPDX-License-Identifier: GPL-3.0-or-later
#include "paths.h"

#include "failure.h"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace cgal_blend::cli {

namespace {

namespace fs = std::filesystem;

std::string lower_case_extension(const std::string& path) {
  std::string extension = fs::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return extension;
}

void require_mesh_extension(const std::string& path) {
  const std::string extension = lower_case_extension(path);
  const std::vector<std::string> known{".off", ".obj", ".ply", ".stl"};
  if (std::find(known.begin(), known.end(), extension) == known.end())
    throw usage_failure("cannot write " + in_quotes(path) +
                        ": unknown mesh format; the name must end in .off, .obj, .ply or .stl");
}

// Not even the superuser, who may write everything, replaces a file that was protected on purpose.
bool is_write_protected(const std::string& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  const fs::perms any_write = fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
  return fs::exists(status) &&
         ((status.permissions() & any_write) == fs::perms::none || ::access(path.c_str(), W_OK) != 0);
}

void require_writable(const std::string& path) {
  std::error_code ignored;
  const fs::path folder = fs::path(path).has_parent_path() ? fs::path(path).parent_path() : fs::path(".");
  const std::string prefix = "cannot write " + in_quotes(path) + ": ";
  if (!fs::is_directory(folder, ignored)) throw usage_failure(prefix + "the folder does not exist");
  if (fs::is_directory(path, ignored)) throw usage_failure(prefix + "it is a folder");
  if (::access(folder.c_str(), W_OK) != 0) throw usage_failure(prefix + "no permission to write in the folder");
  if (is_write_protected(path)) throw usage_failure(prefix + "it is write-protected");
}

bool same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  // Absolute first: of a name that is not there yet, without a folder, nothing is made canonical.
  return fs::weakly_canonical(fs::absolute(a), error) == fs::weakly_canonical(fs::absolute(b), error);
}

void require_other_file(const std::string& option, const std::string& path, const std::vector<std::string>& meshes) {
  for (const std::string& mesh : meshes)
    if (!mesh.empty() && same_file(path, mesh))
      throw usage_failure(option + " would replace the mesh " + in_quotes(mesh));
}

}  // namespace

void check_report_path(const Output_options& output, const std::vector<std::string>& inputs) {
  if (output.report.empty() || output.report_on_stdout()) return;
  require_writable(output.report);
  std::vector<std::string> meshes = inputs;
  meshes.push_back(output.mesh);
  meshes.push_back(output.curvature);
  require_other_file("--report", output.report, meshes);
}

void check_mesh_path(const Output_options& output) {
  if (output.mesh.empty()) return;
  require_mesh_extension(output.mesh);
  require_writable(output.mesh);
}

void check_curvature_path(const Output_options& output, const std::vector<std::string>& inputs) {
  if (output.curvature.empty()) return;
  require_ply(output.curvature);
  require_writable(output.curvature);
  std::vector<std::string> others = inputs;
  others.push_back(output.mesh);
  require_other_file("--curvature", output.curvature, others);
}

void check_curves_path(const std::string& path, const std::string& input) {
  require_writable(path);
  if (same_file(path, input)) throw usage_failure("--output would replace the input " + in_quotes(input));
}

void check_step_path(const std::string& path, const std::vector<std::string>& others) {
  const std::string extension = lower_case_extension(path);
  if (extension != ".step" && extension != ".stp")
    throw usage_failure("cannot write " + in_quotes(path) + ": the name must end in .step or .stp");
  require_writable(path);
  require_other_file("--step", path, others);
}

void check_labels_path(const std::string& path, const std::vector<std::string>& others) {
  require_writable(path);
  require_other_file("--labels", path, others);
}

void require_ply(const std::string& path) {
  if (lower_case_extension(path) != ".ply")
    throw usage_failure("cannot write " + in_quotes(path) +
                        ": curvature goes into PLY files; the name must end in .ply");
}

}  // namespace cgal_blend::cli
