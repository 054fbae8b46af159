// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_CLI_FAILURE_H
#define CGAL_BLEND_CLI_FAILURE_H

#include <cgal_blend/status.h>

#include <stdexcept>
#include <string>

namespace cgal_blend::cli {

/// Exit status of the program.
enum class Exit { ok = 0, usage = 2, input = 3, blend = 4, result = 5 };

/// A file name as messages show it.
inline std::string in_quotes(const std::string& path) { return "\"" + path + "\""; }

/// Ends a command: exit status, identifier for the report, and the line for the user.
struct Failure : std::runtime_error {
  Failure(Exit exit, std::string status, const std::string& text)
      : std::runtime_error(text), exit(exit), status(std::move(status)) {}

  /// `subject` names the file or the part of it that the diagnosis is about; may be empty.
  explicit Failure(const Diagnosis& diagnosis, const std::string& subject = "")
      : Failure(static_cast<Exit>(status_class(diagnosis.status)), name(diagnosis.status),
                (subject.empty() ? "" : subject + ": ") + message(diagnosis)) {}

  Exit exit;
  std::string status;
};

inline Failure usage_failure(const std::string& text) { return {Exit::usage, "invalid_parameter", text}; }

}  // namespace cgal_blend::cli

#endif
