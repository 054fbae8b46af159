// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_CLI_PROGRESS_H
#define CGAL_BLEND_CLI_PROGRESS_H

#include <unistd.h>

#include <cstdio>

namespace cgal_blend::cli {

/// A line on standard error that shows how far the work is; only on a terminal, and gone when the work is done.
class Progress_line {
 public:
  explicit Progress_line(bool wanted) : shown_(wanted && ::isatty(STDERR_FILENO) != 0) {}
  Progress_line(const Progress_line&) = delete;
  Progress_line& operator=(const Progress_line&) = delete;
  ~Progress_line() {
    if (percent_ >= 0) std::fputs("\r\033[K", stderr);
  }

  void show(double fraction) {
    const int percent = static_cast<int>(100 * fraction);
    if (!shown_ || percent == percent_) return;
    percent_ = percent;
    std::fprintf(stderr, "\rcgal-blend: %3d %%", percent);
  }

 private:
  bool shown_;
  int percent_ = -1;
};

}  // namespace cgal_blend::cli

#endif
