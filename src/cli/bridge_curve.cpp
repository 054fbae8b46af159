// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge_curve.h"

#include "failure.h"
#include "values.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <vector>

namespace cgal_blend::cli {

namespace {

constexpr double rounding_of_corner = 0.25;  // of the largest that there is room for, if none is given

struct Curve_text {
  std::string word;
  std::vector<double> numbers;
};

std::optional<Curve_text> parse(const std::string& text) {
  const std::size_t colon = text.find(':');
  Curve_text result{text.substr(0, colon), {}};
  const std::vector<std::string> known{"circle", "ellipse", "rect", "star", "cross"};
  if (std::find(known.begin(), known.end(), result.word) == known.end()) return std::nullopt;
  if (colon == std::string::npos) return result;
  for (const std::string& part : split(text.substr(colon + 1), ",", true)) {
    const auto number = parse_number(part);
    if (!number) throw usage_failure("'" + part + "' in " + text + " is not a number");
    result.numbers.push_back(*number);
  }
  return result;
}

Polar_curve curve_through(const std::string& path) {
  const auto refuse = [&](const std::string& what) {
    return Failure(Exit::input, "input_unreadable", in_quotes(path) + ": " + what);
  };
  std::ifstream in(path);
  if (!in) throw refuse("cannot be opened");
  std::vector<Polar_point> points;
  for (std::string line; std::getline(in, line);) {
    const std::vector<std::string> words = split(line, " \t\r,", false);
    if (words.empty() || words[0][0] == '#') continue;
    const auto angle = parse_number(words[0]), distance = parse_number(words.back());
    if (words.size() != 2 || !angle || !distance) throw refuse("'" + line + "' is no line \"ANGLE DISTANCE\"");
    if (!(*distance > 0)) throw refuse("distances must be greater than 0");
    points.push_back({*distance, *angle * CGAL_PI / 180});
    if (points.size() > 1 && points.back().angle <= points[points.size() - 2].angle)
      throw refuse("the angles must ascend");
  }
  if (points.size() < 3) throw refuse("at least three points are needed");
  if (points.back().angle >= points.front().angle + 2 * CGAL_PI) throw refuse("the angles must ascend once around");
  return spline_curve(points);
}

/// The numbers of a shape with sides and rounded corners, checked.
std::vector<double> with_corner(const Curve_text& curve, double room, const std::string& subject) {
  std::vector<double> numbers = curve.numbers;
  if (numbers.size() == 2) numbers.push_back(rounding_of_corner * room);
  if (!(numbers[2] > 0 && numbers[2] <= room))
    throw usage_failure(subject + ": corners need a radius greater than 0 and not above " + std::to_string(room));
  return numbers;
}

}  // namespace

Polar_curve parse_curve(const std::string& text, std::optional<double> radius, const std::string& subject) {
  const auto curve = parse(text);
  if (!curve) return curve_through(text);
  const std::vector<double>& n = curve->numbers;
  const auto need = [&](bool fits, const std::string& what) {
    if (!fits) throw usage_failure(subject + ": " + text + ": " + what);
  };
  const bool takes_radius = curve->word == "circle" || curve->word == "star";
  if (takes_radius) need(radius.has_value(), "needs a radius");
  if (curve->word == "circle") {
    need(n.empty(), "takes no numbers");
    return circle_curve(*radius);
  }
  if (curve->word == "star") {
    need(n.size() == 2 && n[0] >= 0 && n[0] < 1 && n[1] >= 1 && n[1] <= 1000 && n[1] == std::floor(n[1]),
         "must be star:DEPTH,ARMS with a depth in [0, 1)");
    return star_curve(*radius, n[0], static_cast<int>(n[1]));
  }
  need(n.size() >= 2 && n.size() <= (curve->word == "ellipse" ? 2U : 3U) && n[0] > 0 && n[1] > 0,
       "needs two lengths greater than 0");
  if (curve->word == "ellipse") return ellipse_curve(n[0], n[1]);
  if (curve->word == "rect") {
    const auto all = with_corner(*curve, std::min(n[0], n[1]), subject);
    return rectangle_curve(all[0], all[1], all[2]);
  }
  need(n[1] < n[0], "the bars must be longer than wide");
  const auto all = with_corner(*curve, std::min(n[1], (n[0] - n[1]) / 2), subject);
  return cross_curve(all[0], all[1], all[2]);
}

}  // namespace cgal_blend::cli
