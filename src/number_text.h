// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_NUMBER_TEXT_H
#define CGAL_BLEND_SRC_NUMBER_TEXT_H

#include <charconv>
#include <string>

namespace cgal_blend {

/// A number as messages show it: six digits, whatever the locale.
inline std::string number_text(double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 6);
  return std::string(buffer, end.ptr);
}

}  // namespace cgal_blend

#endif
