// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_STOPWATCH_H
#define CGAL_BLEND_SRC_STOPWATCH_H

#include <chrono>

namespace cgal_blend {

/// Wall-clock time since construction.
class Stopwatch {
 public:
  [[nodiscard]] double milliseconds() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace cgal_blend

#endif
