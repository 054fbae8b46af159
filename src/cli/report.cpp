// SPDX-License-Identifier: GPL-3.0-or-later
#include "report.h"

#include <fstream>
#include <iostream>

namespace cgal_blend::cli {

namespace {

Json point_json(const std::optional<Diagnosis::Point>& p) { return p ? Json{p->x(), p->y(), p->z()} : Json(); }

Json blend_json(const Blend_report& blend) {
  const Diagnosis& diagnosis = blend.diagnosis;
  Json json = {{"status", name(diagnosis.status)},
               {"message", message(diagnosis)},
               {"point", point_json(diagnosis.point)},
               {"edges", blend.edges},
               {"closed", blend.closed},
               {"convex", blend.convex},
               {"radius", blend.radius},
               {"max_radius", nullptr},
               {"radius_error", nullptr},
               {"tangency_deg", nullptr},
               {"loops", nullptr},
               {"flat_ends", nullptr},
               {"over_edges", nullptr},
               {"coarseness", nullptr}};
  if (diagnosis.max_radius) json["max_radius"] = *diagnosis.max_radius;
  if (diagnosis.ok()) {  // a curve that was left sharp has no such figures
    json["radius_error"] = blend.radius_error;
    json["tangency_deg"] = blend.tangency_deg;
    json["loops"] = blend.loops;
    json["flat_ends"] = blend.flat_ends;
    json["over_edges"] = blend.over_edges;
    if (blend.coarseness > 0) json["coarseness"] = blend.coarseness;  // mapped
  }
  return json;
}

}  // namespace

Json Report::json() const {
  Json json = {{"command", command}, {"status", status}, {"message", message}, {"input", input}};
  char letter = 'b';
  for (const Json& more : more_inputs) {
    if (!more.is_null()) json[std::string("input_") + letter] = more;
    ++letter;
  }
  json["output"] = output;
  if (!curvature.is_null()) json["curvature"] = curvature;
  json["blends"] = blends;
  json["timings_ms"] = {{"read", read},        {"check_input", check_input}, {"boolean", stages.boolean}, {"coarsen", stages.coarsen},
                        {"copy", stages.copy}, {"blend", stages.blend},      {"validate", stages.validate},
                        {"write", write}};
  return json;
}

Json input_json(const std::string& file, const Blend_mesh& mesh) {
  return {{"file", file}, {"vertices", mesh.number_of_vertices()}, {"faces", mesh.number_of_faces()}};
}

void add_flaws(const Flaw_counts& flaws, Json& entry) {
  entry["self_intersections"] = flaws.self_intersections;
  entry["degenerate_faces"] = flaws.degenerate_faces;
  entry["short_edges"] = flaws.short_edges;
}

Json blends_json(const std::vector<Blend_report>& blends) {
  Json json = Json::array();
  for (const Blend_report& blend : blends) json.push_back(blend_json(blend));
  return json;
}

Json output_json(const std::string& file, const Blend_mesh& mesh, const Fillet_outcome& outcome) {
  Json json = input_json(file, mesh);
  json["closed"] = true;  // the engine hands out nothing that fails its validation
  json["manifold"] = true;
  json["self_intersections"] = 0;
  json["volume"] = outcome.volume;
  json["area"] = outcome.area;
  json["blend_faces"] = outcome.blend_faces.size();
  json["kept_faces"] = outcome.kept_faces;
  json["untouched_share"] = static_cast<double>(outcome.kept_faces) / static_cast<double>(mesh.number_of_faces());
  return json;
}

Json validity_json(const std::string& file, const Validity_report& validity) {
  return {{"file", file},
          {"vertices", validity.vertices},
          {"faces", validity.faces},
          {"closed", validity.closed},
          {"manifold", validity.manifold},
          {"self_intersections", validity.self_intersections},
          {"volume", validity.volume},
          {"area", validity.area},
          {"finite", validity.finite},
          {"outward", validity.outward},
          {"components", validity.components},
          {"degenerate_faces", validity.degenerate_faces},
          {"short_edges", validity.short_edges}};
}

bool write_report(const Report& report, const std::string& path) {
  // A file name need not be valid UTF-8; the report must be.
  const std::string text = report.json().dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  if (path == "-") return static_cast<bool>(std::cout << text << std::flush);
  std::ofstream out(path, std::ios::binary);
  return static_cast<bool>(out << text << std::flush);
}

}  // namespace cgal_blend::cli
