// SPDX-License-Identifier: GPL-3.0-or-later
#include "values.h"

#include "failure.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace cgal_blend::cli {

namespace {

// A list "0:2,0.5:4,1:2" of arc-length fractions in [0,1] and radii.
bool is_radius_list(const std::string& text) {
  for (const std::string& item : split(text, ",", true)) {
    const std::vector<std::string> pair = split(item, ":", true);
    if (pair.size() != 2) return false;
    const auto fraction = parse_number(pair[0]), radius = parse_number(pair[1]);
    if (!fraction || !radius || *fraction < 0 || *fraction > 1 || *radius <= 0) return false;
  }
  return true;
}

bool is_conic(const std::string& profile) {
  const std::string prefix = "conic:";
  return profile.compare(0, prefix.size(), prefix) == 0 && parse_number(profile.substr(prefix.size())).has_value();
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::vector<std::string> split(const std::string& text, const char* separators, bool keep_empty) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find_first_of(separators, begin), text.size());
    if (keep_empty || end > begin) parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

double parse_radius(const std::string& text) {
  if (is_radius_list(text)) throw unsupported_failure("--radius: a radius that varies along the curve");
  const auto radius = parse_number(text);
  if (!radius) throw usage_failure("--radius: '" + text + "' is not a number");
  require_radius(*radius, "--radius");
  return *radius;
}

std::vector<double> parse_radii(const std::string& text, std::size_t count) {
  const std::vector<std::string> items = split(text, ",", true);
  if (items.size() == 1 || is_radius_list(text)) return std::vector<double>(count, parse_radius(text));
  std::vector<double> radii;
  for (const std::string& item : items) radii.push_back(parse_radius(item));
  if (radii.size() != count)
    throw usage_failure("--radius: " + std::to_string(radii.size()) + " radii for " + std::to_string(count) +
                        (count == 1 ? " boolean" : " booleans") +
                        "; give one for all, or one for each body after the first");
  return radii;
}

void require_radius(double radius, const std::string& subject) {
  if (!(std::isfinite(radius) && radius > 0)) throw usage_failure(subject + ": the radius must be greater than 0");
}

void require_arc_profile(const std::string& profile, const std::string& subject) {
  if (profile == "arc") return;
  if (profile == "chamfer" || profile == "sharp" || profile == "g2" || is_conic(profile))
    throw unsupported_failure(subject + ": the profile '" + profile + "'");
  throw usage_failure(subject + ": unknown profile '" + profile + "'; known: arc, chamfer, conic:W0, sharp, g2");
}

void require_stitch_mode(const std::string& mode) {
  if (mode == "stitch") return;
  if (mode == "map") throw unsupported_failure("--mode: 'map'");
  throw usage_failure("--mode: unknown mode '" + mode + "'; known: stitch, map");
}

}  // namespace cgal_blend::cli
