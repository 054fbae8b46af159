// SPDX-License-Identifier: GPL-3.0-or-later
#include "quadric_pair_file.h"

#include "failure.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>

namespace cgal_blend::cli {

namespace {

using Json = nlohmann::json;
using Rational = Quadric_3::Rational;

constexpr double most_samples = 1e6;

[[noreturn]] void refuse(const std::string& where, const std::string& what) {
  throw Failure(Exit::input, "input_unreadable", where + ": " + what);
}

/// Keeps integers that are too long for a machine word as strings, digit by digit.
class Exact_integers : public nlohmann::detail::json_sax_dom_parser<Json> {
 public:
  explicit Exact_integers(Json& json) : json_sax_dom_parser(json, false) {}

  bool number_float(double value, const std::string& text) {
    if (text.find_first_of(".eE") != std::string::npos) return json_sax_dom_parser::number_float(value, text);
    std::string digits = text;
    return string(digits);
  }
};

Json read_json(const std::string& path, const std::string& where) {
  std::ifstream in(path);
  if (!in) refuse(where, "cannot be opened");
  Json json;
  Exact_integers handler(json);
  if (!Json::sax_parse(in, &handler)) refuse(where, "is not JSON");
  return json;
}

bool is_whole(const std::string& text) {
  const std::size_t begin = !text.empty() && (text[0] == '-' || text[0] == '+') ? 1 : 0;
  return text.size() > begin && std::all_of(text.begin() + static_cast<std::ptrdiff_t>(begin), text.end(),
                                            [](unsigned char c) { return std::isdigit(c) != 0; });
}

Rational whole(const std::string& text) { return Rational(text[0] == '+' ? text.substr(1) : text); }

Rational read_fraction(const std::string& text, const std::string& where) {
  const std::size_t slash = text.find('/');
  const std::string above = text.substr(0, slash), below = slash == std::string::npos ? "1" : text.substr(slash + 1);
  if (!is_whole(above) || !is_whole(below)) refuse(where, "\"" + text + "\" is no fraction \"p/q\" of whole numbers");
  const Rational denominator = whole(below);
  if (denominator == 0) refuse(where, "\"" + text + "\" has the denominator 0");
  return whole(above) / denominator;
}

Rational read_coefficient(const Json& item, const std::string& where) {
  if (item.is_string()) return read_fraction(item.get<std::string>(), where);
  if (item.is_number_unsigned()) return whole(std::to_string(item.get<std::uint64_t>()));
  if (item.is_number_integer()) return whole(std::to_string(item.get<std::int64_t>()));
  if (!item.is_number()) refuse(where, item.dump() + " is neither a number nor a fraction \"p/q\"");
  const double value = item.get<double>();
  if (!std::isfinite(value)) refuse(where, "a coefficient is not finite");
  return Rational(value);
}

Quadric_3 read_quadric(const Json& json, const std::string& name, const std::string& file) {
  const std::string where = file + ", '" + name + "'";
  if (!json.contains(name)) refuse(file, "no '" + name + "'");
  const Json& list = json[name];
  if (!list.is_array() || list.size() != 10)
    refuse(where, "must be a list of the 10 coefficients of x2, y2, z2, xy, xz, yz, x, y, z, 1");
  Quadric_3::Coefficients coefficients;
  for (std::size_t k = 0; k < 10; ++k) coefficients[k] = read_coefficient(list[k], where);
  if (std::all_of(coefficients.begin(), coefficients.end(), [](const Rational& c) { return c == 0; }))
    refuse(where, "all coefficients are 0");
  return Quadric_3(coefficients);
}

double read_number(const Json& json, const char* name, double otherwise, const std::string& file) {
  if (!json.contains(name)) return otherwise;
  if (!json[name].is_number()) refuse(file, "'" + std::string(name) + "' is not a number");
  return json[name].get<double>();
}

}  // namespace

Quadric_pair read_quadric_pair(const std::string& path) {
  const std::string where = in_quotes(path);
  const Json json = read_json(path, where);
  if (!json.is_object()) refuse(where, "must be an object with lists 'a' and 'b'");
  Quadric_pair pair{read_quadric(json, "a", where), read_quadric(json, "b", where)};
  const double samples = read_number(json, "samples", static_cast<double>(pair.samples), where);
  if (!(samples >= 1 && samples <= most_samples) || samples != std::floor(samples))
    refuse(where, "'samples' must be a whole number from 1 to 1000000");
  pair.samples = static_cast<std::size_t>(samples);
  pair.box = read_number(json, "box", pair.box, where);
  if (!(std::isfinite(pair.box) && pair.box > 0)) refuse(where, "'box' must be a number greater than 0");
  return pair;
}

}  // namespace cgal_blend::cli
