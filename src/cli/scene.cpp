// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene.h"

#include "failure.h"
#include "scene_surface.h"

#include <cgal_blend/sphere_hub.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace cgal_blend::cli {

namespace {

const std::vector<std::string> blend_keys{"distance", "direction", "flip", "matching", "reversed",
                                          "start",    "middle",    "g2",   "on_fold"};

std::vector<std::string> with_blend_keys(std::vector<std::string> keys) {
  keys.insert(keys.end(), blend_keys.begin(), blend_keys.end());
  return keys;
}

Adjusting_function read_distance(const Scene_value& json) {
  if (json.is_number()) return json.number();
  if (json.is_string()) {
    const Expression formula = json.formula({"s"});
    return Adjusting_function([formula](double s) { return formula(std::array<double, 1>{s}); });
  }
  json.allow({"pairs", "cosine"});
  if (json.has("cosine")) {
    const auto ends = json["cosine"].list(2);
    return Adjusting_function(Cosine_adjustment{ends[0].number(), ends[1].number()});
  }
  std::array<Quadratic_adjustment::Pair, 3> pairs;
  const auto items = json["pairs"].list(3);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto pair = items[i].list(2);
    pairs[i] = {pair[0].number(), pair[1].number()};
  }
  if (!Quadratic_adjustment::is_valid(pairs)) json["pairs"].refuse("three different parameters are needed");
  return Adjusting_function(Quadratic_adjustment(pairs));
}

/// One value for both sides, or a list of two.
template <class Use>
void for_both(const Scene_value& json, const Use& use) {
  if (!json.is_list()) {
    use(0, json);
    use(1, json);
    return;
  }
  const auto items = json.list(2);
  for (std::size_t side : {0, 1}) use(side, items[side]);
}

Matching read_matching(const Scene_value& json) {
  const std::string text = json.text();
  if (text == "parameter") return Matching::parameter;
  if (text == "arc_length") return Matching::arc_length;
  if (text == "least_twist") return Matching::least_twist;
  json.refuse("must be \"parameter\", \"arc_length\" or \"least_twist\"");
}

Fold_policy read_policy(const Scene_value& json) {
  const std::string text = json.text();
  if (text == "refuse") return Fold_policy::refuse;
  if (text == "shrink") return Fold_policy::shrink;
  json.refuse("must be \"refuse\" or \"shrink\"");
}

std::function<Point_3(double, const Point_3&)> read_middle(const Scene_value& json) {
  const auto f = json.formulas(3, {"s", "x", "y", "z"});
  return [f](double s, const Point_3& p) {
    const std::array<double, 4> values{s, p.x(), p.y(), p.z()};
    return Point_3(f[0](values), f[1](values), f[2](values));
  };
}

Surface_blend_options read_blend_options(const Scene_value& json) {
  Surface_blend_options options;
  if (json.has("distance"))
    for_both(json["distance"],
             [&](std::size_t side, const Scene_value& v) { options.sides[side].distance = read_distance(v); });
  if (json.has("direction"))
    for_both(json["direction"],
             [&](std::size_t side, const Scene_value& v) { options.sides[side].direction = v.number(); });
  if (json.has("flip"))
    for_both(json["flip"], [&](std::size_t side, const Scene_value& v) {
      if (!v.is_null()) options.sides[side].flip = v.boolean();
    });
  if (json.has("matching")) options.correspondence.matching = read_matching(json["matching"]);
  if (json.has("reversed")) options.correspondence.reversed = json["reversed"].boolean();
  if (json.has("start")) options.correspondence.start = json["start"].number();
  if (json.has("middle")) options.middle = read_middle(json["middle"]);
  if (json.has("g2")) options.g2 = json["g2"].boolean();
  if (json.has("on_fold")) options.on_fold = read_policy(json["on_fold"]);
  return options;
}

/// Reads a scene; surfaces by name first, so that blends can refer to them.
class Reader {
 public:
  Reader(const Scene_value& json, const std::string& folder) : json_(json) {
    json.allow({"surfaces", "blends", "hubs", "chord_tolerance", "capped", "thickness"});
    const Scene_value surfaces = json["surfaces"];
    for (const std::string& name : surfaces.keys()) {
      surfaces_.push_back(read_scene_surface(surfaces[name], folder));
      scene_.names.push_back(name);
      scene_.surfaces.push_back(surfaces_.back().trimmed);
    }
    read_body_options();
  }

  Scene run() {
    if (json_.has("blends"))
      for (const Scene_value& item : json_["blends"].list()) {
        item.allow(with_blend_keys({"first", "second"}));
        const Side a = read_side(item["first"]), b = read_side(item["second"]);
        add_blend(item, a, b);
      }
    if (json_.has("hubs"))
      for (const Scene_value& item : json_["hubs"].list()) add_hub(item);
    if (scene_.blends.empty()) json_.refuse("there is no blend");
    return std::move(scene_);
  }

 private:
  struct Side {
    std::size_t surface;
    Scene_curve curve;
  };

  void read_body_options() {
    Blend_body_options& body = scene_.body;
    if (json_.has("chord_tolerance")) body.chord_tolerance = json_["chord_tolerance"].number();
    if (!(body.chord_tolerance >= 1e-6 && body.chord_tolerance <= 0.1))
      json_["chord_tolerance"].refuse("must lie between 1e-6 and 0.1");
    if (json_.has("capped")) body.capped = json_["capped"].boolean();
    if (json_.has("thickness")) body.thickness = json_["thickness"].number();
    if (!(body.thickness >= 0)) json_["thickness"].refuse("must not be negative");
  }

  Side read_side(const Scene_value& json) {
    const std::string name = json["surface"].text();
    const auto found = std::find(scene_.names.begin(), scene_.names.end(), name);
    if (found == scene_.names.end()) json["surface"].refuse("there is no surface '" + name + "'");
    const std::size_t i = static_cast<std::size_t>(found - scene_.names.begin());
    return {i, surfaces_.at(i).curve(json)};
  }

  void add_blend(const Scene_value& json, const Side& a, const Side& b) {
    const auto result = blend_surfaces(a.curve.curve, b.curve.curve, read_blend_options(json));
    if (!result.ok()) throw Failure(result.diagnosis, json.where());
    scene_.blends.push_back({*result.blend, {a.surface, b.surface}, {a.curve.slot, b.curve.slot}});
    scene_.factors.push_back(result.factor);
  }

  void add_hub(const Scene_value& json) {
    json.allow(with_blend_keys({"curves", "centre", "radius", "spread"}));
    std::vector<Side> sides;
    std::vector<Boundary_curve> curves;
    for (const Scene_value& item : json["curves"].list()) {
      sides.push_back(read_side(item));
      curves.push_back(sides.back().curve.curve);
    }
    Sphere_hub_options options;
    if (json.has("centre")) options.centre = json["centre"].point();
    if (json.has("radius")) options.radius = json["radius"].number();
    if (json.has("spread")) options.spread = json["spread"].number();
    const Sphere_hub hub = sphere_between(curves, options);
    if (!hub.ok()) throw Failure(hub.diagnosis, json.where());
    const std::size_t sphere = scene_.surfaces.size();
    scene_.names.push_back("hub");
    scene_.surfaces.push_back(trimmed_quadric(hub.sphere));
    for (std::size_t i = 0; i < sides.size(); ++i) add_blend(json, sides[i], {sphere, {hub.circles[i], 0}});
  }

  Scene_value json_;
  std::vector<Scene_surface> surfaces_;
  Scene scene_;
};

}  // namespace

Scene read_scene(const std::string& path) {
  const std::string where = in_quotes(path);
  std::ifstream in(path);
  if (!in) throw Failure(Exit::input, "input_unreadable", where + ": cannot be opened");
  const nlohmann::json json = nlohmann::json::parse(in, nullptr, false);
  if (json.is_discarded()) throw Failure(Exit::input, "input_unreadable", where + ": is not JSON");
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return Reader(Scene_value(json, where), folder.empty() ? "." : folder).run();
}

}  // namespace cgal_blend::cli
