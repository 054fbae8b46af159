// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge_scene.h"

#include "bridge_curve.h"
#include "failure.h"
#include "scene_body.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace cgal_blend::cli {

namespace {

const std::vector<std::string> shape_keys{"mu",       "order", "twist",           "least_twist", "drag",
                                          "segments", "rows",  "chord_tolerance", "smooth_angle"};

std::vector<std::string> with_shape_keys(std::vector<std::string> keys) {
  keys.insert(keys.end(), shape_keys.begin(), shape_keys.end());
  return keys;
}

Bridge_end read_end(const Scene_value& json, bool has_spot, const std::string& folder) {
  if (has_spot)
    json.allow({"at", "radius", "curve", "lambda", "zero"});
  else
    json.allow({"radius", "curve", "lambda"});
  Bridge_end end;
  if (has_spot) end.spot = json["at"].point();
  std::optional<double> radius;
  if (json.has("radius")) radius = end.radius = json["radius"].number();
  if (json.has("curve")) {
    const std::string text = json["curve"].text();
    const bool is_file = std::filesystem::exists(std::filesystem::path(folder) / text);
    if (radius && !(*radius > 0)) json["radius"].refuse("must be greater than 0");
    end.curve = parse_curve(is_file ? (std::filesystem::path(folder) / text).string() : text, radius, json.where());
  } else if (!radius) {
    json.refuse("no 'radius' and no 'curve'");
  }
  if (json.has("lambda")) end.lambda = json["lambda"].number();
  if (json.has("zero")) end.zero_direction = json["zero"].vector();
  return end;
}

Drag_request read_drag(const Scene_value& json) {
  json.allow({"s", "t", "to"});
  return {json["s"].number(), json["t"].number(), json["to"].point()};
}

void read_shape(const Scene_value& json, Bridge_step& step) {
  Bridge_options& o = step.bridge.options;
  if (json.has("mu")) o.mu = json["mu"].number();
  if (json.has("order")) o.order = static_cast<int>(std::min<std::size_t>(json["order"].index(), 99));
  if (json.has("twist")) o.twist_deg = json["twist"].number();
  if (json.has("least_twist")) o.least_twist = json["least_twist"].boolean();
  if (json.has("segments")) o.segments = json["segments"].index();
  if (json.has("rows")) o.rows = json["rows"].index();
  if (json.has("chord_tolerance")) o.chord_tolerance = json["chord_tolerance"].number();
  if (json.has("smooth_angle")) o.smooth_angle = json["smooth_angle"].number();
  if (json.has("drag")) step.drag = read_drag(json["drag"]);
}

Bridge_step read_step(const Scene_value& json, const std::string& folder, const std::vector<std::string>& names) {
  Bridge_step step;
  step.where = json.where();
  json.allow(with_shape_keys({"ends", "cross"}));
  const auto ends = json["ends"].list(2);
  const bool crosses = json.has("cross");
  for (std::size_t k = 0; k < 2; ++k) step.bridge.ends[k] = read_end(ends[k], !crosses, folder);
  read_shape(json, step);
  if (!crosses) return step;
  if (step.drag) json["drag"].refuse("there is no drag around an intersection");
  const auto found = std::find(names.begin(), names.end(), json["cross"].text());
  if (found == names.end()) json["cross"].refuse("there is no body '" + json["cross"].text() + "'");
  step.crossing = static_cast<std::size_t>(found - names.begin());
  return step;
}

}  // namespace

Bridge_scene read_bridge_scene(const std::string& path) {
  const std::string where = in_quotes(path);
  std::ifstream in(path);
  if (!in) throw Failure(Exit::input, "input_unreadable", where + ": cannot be opened");
  const nlohmann::json content = nlohmann::json::parse(in, nullptr, false);
  if (content.is_discarded()) throw Failure(Exit::input, "input_unreadable", where + ": is not JSON");
  std::string folder = std::filesystem::path(path).parent_path().string();
  if (folder.empty()) folder = ".";
  const Scene_value json(content, where);
  json.allow({"bodies", "bridges"});
  Bridge_scene scene;
  const Scene_value bodies = json["bodies"];
  for (const std::string& name : bodies.keys()) {
    scene.names.push_back(name);
    scene.bodies.push_back(read_scene_body(bodies[name], folder));
  }
  if (scene.bodies.empty()) bodies.refuse("there is no body");
  for (const Scene_value& item : json["bridges"].list()) scene.steps.push_back(read_step(item, folder, scene.names));
  if (scene.steps.empty()) json["bridges"].refuse("there is no bridge");
  return scene;
}

}  // namespace cgal_blend::cli
