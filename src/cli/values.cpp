// SPDX-License-Identifier: GPL-3.0-or-later
#include "values.h"

#include "failure.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace cgal_blend::cli {

namespace {

double parse_positive(const std::string& text) {
  const auto radius = parse_number(text);
  if (!radius) throw usage_failure("--radius: '" + text + "' is not a number");
  require_radius(*radius, "--radius");
  return *radius;
}

bool is_law(const std::string& text) { return text.find(':') != std::string::npos; }

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

Radius_law parse_radius(const std::string& text) {
  if (!is_law(text)) return parse_positive(text);
  std::vector<Piecewise_radius::Pair> pairs;
  for (const std::string& item : split(text, ",", true)) {
    const std::vector<std::string> pair = split(item, ":", true);
    if (pair.size() != 2) throw usage_failure("--radius: '" + item + "' is no pair FRACTION:RADIUS");
    const auto fraction = parse_number(pair[0]);
    if (!fraction) throw usage_failure("--radius: '" + pair[0] + "' is not a number");
    pairs.push_back({*fraction, parse_positive(pair[1])});
  }
  return make_law(pairs, "--radius");
}

std::vector<Radius_law> parse_radii(const std::string& text, std::size_t count) {
  const std::vector<std::string> items = split(text, ",", true);
  if (items.size() == 1 || is_law(text)) return std::vector<Radius_law>(count, parse_radius(text));
  std::vector<Radius_law> radii;
  for (const std::string& item : items) radii.emplace_back(parse_positive(item));
  if (radii.size() != count)
    throw usage_failure("--radius: " + std::to_string(radii.size()) + " radii for " + std::to_string(count) +
                        (count == 1 ? " boolean" : " booleans") +
                        "; give one for all, or one for each body after the first");
  return radii;
}

Radius_law make_law(const std::vector<Piecewise_radius::Pair>& pairs, const std::string& subject) {
  const Diagnosis diagnosis = Piecewise_radius::check(pairs);
  if (!diagnosis.ok()) throw usage_failure(subject + ": " + diagnosis.detail);
  return Piecewise_radius(pairs);
}

void require_radius(double radius, const std::string& subject) {
  if (!(std::isfinite(radius) && radius > 0)) throw usage_failure(subject + ": the radius must be greater than 0");
}

namespace {

std::vector<double> profile_numbers(const std::string& text, const std::string& subject) {
  std::vector<double> numbers;
  for (const std::string& part : split(text, ",", true)) {
    const auto number = parse_number(part);
    if (!number) throw usage_failure(subject + ": '" + part + "' is not a number");
    numbers.push_back(*number);
  }
  return numbers;
}

Profile conic_profile(const std::string& values, const std::string& subject) {
  if (values == "inf") return sharp_profile();
  const std::vector<double> numbers = profile_numbers(values, subject);
  if (numbers.size() != 1 || numbers[0] < 0)
    throw usage_failure(subject + ": conic:W0 takes one weight of 0 or more, or inf");
  return Conic_profile{numbers[0]};
}

Profile hermite_profile(const std::string& values, const std::string& subject) {
  const std::vector<double> numbers = profile_numbers(values, subject);
  if (numbers.size() != 2 || !(numbers[0] > 0) || !(numbers[1] > 0))
    throw usage_failure(subject + ": hermite:M1,M2 takes two speeds greater than 0");
  return Hermite_profile{numbers[0], numbers[1]};
}

Profile bspline_profile(const std::string& values, const std::string& subject) {
  std::vector<std::array<double, 2>> points;
  for (const std::string& pair : split(values, ";", true)) {
    const std::vector<double> numbers = profile_numbers(pair, subject);
    if (numbers.size() != 2) throw usage_failure(subject + ": '" + pair + "' is no control point X,Y");
    points.push_back({numbers[0], numbers[1]});
  }
  const std::size_t degree = std::min<std::size_t>(3, points.size() - 1);
  if (!Bspline_profile::is_valid(points, degree))
    throw usage_failure(subject + ": a B-spline needs two control points or more, from 0,0 to 1,1");
  return Bspline_profile(points, degree);
}

}  // namespace

Profile parse_profile(const std::string& text, const std::string& subject) {
  const std::size_t colon = text.find(':');
  const std::string word = text.substr(0, colon);
  if (colon == std::string::npos) {
    if (word == "arc") return Arc_profile();
    if (word == "chamfer") return chamfer_profile();
    if (word == "sharp") return sharp_profile();
    if (word == "g2") return G2_profile();
    if (word == "hermite") return Hermite_profile();
  } else {
    const std::string values = text.substr(colon + 1);
    if (word == "conic") return conic_profile(values, subject);
    if (word == "hermite") return hermite_profile(values, subject);
    if (word == "bspline") return bspline_profile(values, subject);
  }
  throw usage_failure(subject + ": unknown profile '" + text +
                      "'; known: arc, chamfer, conic:W0, sharp, g2, hermite[:M1,M2], bspline:X,Y;X,Y;...");
}

Blend_mode parse_mode(const std::string& mode) {
  if (mode == "stitch") return Blend_mode::stitch;
  if (mode == "map") return Blend_mode::map;
  throw usage_failure("--mode: unknown mode '" + mode + "'; known: stitch, map");
}

}  // namespace cgal_blend::cli
