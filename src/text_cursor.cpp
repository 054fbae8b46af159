// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_formats.h"

#include <charconv>
#include <limits>

namespace cgal_blend::internal {

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

bool contains(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

/// Value of a number that no double can hold: zero for tiny ones, infinite for huge ones.
double value_out_of_range(std::string_view token) {
  return contains(token, "e-") || contains(token, "E-") ? 0 : std::numeric_limits<double>::infinity();
}

}  // namespace

void Text_cursor::skip_blanks(bool over_lines) {
  while (position_ != end_) {
    if (is_blank(*position_)) {
      ++position_;
    } else if (*position_ == '#') {
      while (position_ != end_ && *position_ != '\n') ++position_;
    } else if (*position_ == '\\' && !over_lines) {
      const char* p = position_ + 1;
      while (p != end_ && is_blank(*p)) ++p;
      if (p == end_ || *p != '\n') return;
      position_ = p + 1;
      ++line_;
    } else if (*position_ == '\n' && over_lines) {
      ++position_;
      ++line_;
    } else {
      return;
    }
  }
}

std::string_view Text_cursor::take() {
  const char* begin = position_;
  while (position_ != end_ && !is_blank(*position_) && *position_ != '\n') ++position_;
  return {begin, static_cast<std::size_t>(position_ - begin)};
}

std::string_view Text_cursor::token() {
  skip_blanks(true);
  if (position_ == end_) fail("the file ends too early");
  return take();
}

std::string_view Text_cursor::token_on_line() {
  skip_blanks(false);
  if (position_ == end_ || *position_ == '\n') return {};
  return take();
}

void Text_cursor::skip_line() {
  while (position_ != end_ && *position_ != '\n') ++position_;
}

bool Text_cursor::at_end() {
  skip_blanks(true);
  return position_ == end_;
}

Point_3 Text_cursor::point() {
  const double x = number();
  const double y = number();
  const double z = number();
  return {x, y, z};
}

std::size_t Text_cursor::count() {
  const long long value = to_integer(token());
  if (value < 0) fail("a count is negative");
  return static_cast<std::size_t>(value);
}

std::uint32_t Text_cursor::index(std::size_t size) {
  const long long value = to_integer(token());
  if (value < 0 || static_cast<std::size_t>(value) >= size)
    fail("a face names vertex " + std::to_string(value) + " of " + std::to_string(size) + " vertices");
  return static_cast<std::uint32_t>(value);
}

double Text_cursor::to_number(std::string_view token) const {
  if (!token.empty() && token.front() == '+') token.remove_prefix(1);
  double value = 0;
  const char* const end = token.data() + token.size();
  const auto result = std::from_chars(token.data(), end, value);
  if (result.ec == std::errc::result_out_of_range) return value_out_of_range(token);
  if (result.ec == std::errc() && result.ptr == end) return value;
  // What old Windows programs write for numbers that are not finite, e.g. 1.#QNAN; also nan(ind).
  if (contains(token, "#") || contains(token, "nan")) return std::numeric_limits<double>::quiet_NaN();
  fail("\"" + std::string(token.substr(0, 30)) + "\" is not a number");
}

long long Text_cursor::to_integer(std::string_view token) const {
  long long value = 0;
  const auto result = std::from_chars(token.data(), token.data() + token.size(), value);
  if (result.ec != std::errc() || result.ptr != token.data() + token.size())
    fail("\"" + std::string(token.substr(0, 30)) + "\" is not a whole number");
  return value;
}

void Text_cursor::fail(const std::string& what) const {
  throw Malformed_file("line " + std::to_string(line_) + ": " + what);
}

}  // namespace cgal_blend::internal
