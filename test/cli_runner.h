// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_TEST_CLI_RUNNER_H
#define CGAL_BLEND_TEST_CLI_RUNNER_H

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>

namespace cgal_blend::test {

using Json = nlohmann::json;

/// Runs the program in a folder of its own, which is removed afterwards.
class Cli_runner : public testing::Test {
 protected:
  struct Run {
    int exit;  ///< -1: ended by a signal
    std::string out, err;
  };

  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "cgal_blend_cli_XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = name;
    std::filesystem::create_directory(folder_ / "work");
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /// Paths in the command are relative to the folder.
  Run run(const std::string& arguments) {
    const std::string out = (folder_ / "stdout").string(), err = (folder_ / "stderr").string();
    const std::string command = "cd '" + path("") + "' && '" CGAL_BLEND_CLI "' " + arguments + " >" + out + " 2>" + err;
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content(out), content(err)};
  }

  [[nodiscard]] std::string path(const std::string& file) const { return (folder_ / "work" / file).string(); }
  [[nodiscard]] std::string bytes(const std::string& file) const { return content(path(file)); }
  [[nodiscard]] Json json(const std::string& file) const { return Json::parse(bytes(file)); }
  void write(const std::string& file, const std::string& text) const {
    std::ofstream(path(file), std::ios::binary) << text;
  }

  using Files = std::map<std::string, std::string>;

  /// All files of the folder with their content.
  [[nodiscard]] Files files() const {
    Files all;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path("")))
      if (entry.is_regular_file()) all[entry.path().string()] = content(entry.path().string());
    return all;
  }

  /// Names of the files that are new, gone, or not what they were.
  [[nodiscard]] std::string changed_since(const Files& before) const {
    const Files now = files();
    std::string names;
    for (const auto& [name, text] : before)
      if (now.count(name) == 0 || now.at(name) != text) names += name + " ";
    for (const auto& [name, text] : now)
      if (before.count(name) == 0) names += name + " ";
    return names;
  }

 private:
  static std::string content(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }

  std::filesystem::path folder_;
};

}  // namespace cgal_blend::test

#endif
