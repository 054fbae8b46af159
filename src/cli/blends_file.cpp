// SPDX-License-Identifier: GPL-3.0-or-later
#include "edge_choice.h"
#include "failure.h"
#include "values.h"

#include <nlohmann/json.hpp>

#include <fstream>

namespace cgal_blend::cli {

namespace {

using Json = nlohmann::json;

[[noreturn]] void malformed(const std::string& where, const std::string& what) {
  throw Failure(Exit::input, "input_unreadable", where + ": " + what);
}

bool is_point(const Json& item) {
  return item.is_array() && item.size() == 3 && item[0].is_number() && item[1].is_number() && item[2].is_number();
}

void read_polyline(const Json& polyline, const std::string& where, Blend_request& request) {
  if (!polyline.is_array()) malformed(where, "'polyline' must be a list of vertex indices or of points");
  for (const Json& item : polyline) {
    if (item.is_number_unsigned())
      request.vertices.push_back(item.get<std::size_t>());
    else if (is_point(item))
      request.points.emplace_back(item[0].get<double>(), item[1].get<double>(), item[2].get<double>());
    else
      malformed(where, item.dump() + " in 'polyline' is neither a vertex index nor a point [x, y, z]");
  }
  if (!request.vertices.empty() && !request.points.empty())
    malformed(where, "'polyline' mixes vertex indices and points");
}

bool is_pair(const Json& item) {
  return item.is_array() && item.size() == 2 && item[0].is_number() && item[1].is_number();
}

Radius_law read_radius(const Json& radius, const std::string& where) {
  if (radius.is_array()) {
    std::vector<Piecewise_radius::Pair> pairs;
    for (const Json& item : radius) {
      if (!is_pair(item))
        throw usage_failure(where + ": " + item.dump() + " in 'radius' is no pair [fraction, radius]");
      pairs.push_back({item[0].get<double>(), item[1].get<double>()});
    }
    return make_law(pairs, where);
  }
  if (!radius.is_number()) throw usage_failure(where + ": the radius " + radius.dump() + " is not a number");
  require_radius(radius.get<double>(), where);
  return radius.get<double>();
}

double read_fraction(const Json& fraction, const std::string& where, const std::string& key) {
  if (!fraction.is_number()) throw usage_failure(where + ": '" + key + "' must be a number");
  const double value = fraction.get<double>();
  if (!(value >= 0 && value <= 1)) throw usage_failure(where + ": '" + key + "' must lie between 0 and 1");
  return value;
}

Blend_request read_request(const Json& json, const std::string& where) {
  Blend_request request;
  if (!json.is_object() || !json.contains("polyline")) malformed(where, "no 'polyline'");
  read_polyline(json["polyline"], where, request);
  if (json.contains("radius")) request.radius = read_radius(json["radius"], where);
  if (json.contains("profile")) {
    if (!json["profile"].is_string()) malformed(where, "'profile' must be a word");
    request.profile = parse_profile(json["profile"].get<std::string>(), where);
  }
  if (json.contains("from")) request.from = read_fraction(json["from"], where, "from");
  if (json.contains("to")) request.to = read_fraction(json["to"], where, "to");
  return request;
}

}  // namespace

std::vector<Blend_request> read_blends(const std::string& path) {
  std::ifstream in(path);
  if (!in) malformed(in_quotes(path), "cannot be opened");
  const Json json = Json::parse(in, nullptr, false);
  if (json.is_discarded()) malformed(in_quotes(path), "is not JSON");
  if (!json.is_object() || !json.contains("blends") || !json["blends"].is_array())
    malformed(in_quotes(path), "must be an object with a list 'blends'");
  std::vector<Blend_request> requests;
  for (const Json& item : json["blends"])
    requests.push_back(read_request(item, in_quotes(path) + ", blend " + std::to_string(requests.size() + 1)));
  return requests;
}

}  // namespace cgal_blend::cli
