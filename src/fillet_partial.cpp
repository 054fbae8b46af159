// SPDX-License-Identifier: GPL-3.0-or-later
#include "fillet_partial.h"

#include "ancestry.h"
#include "edge_finder.h"
#include "fillet_divided.h"
#include "fillet_flaws.h"
#include "fillet_radius.h"
#include "stopwatch.h"

#include <cgal_blend/creases.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace cgal_blend {

namespace {

class Partial_fillet {
 public:
  Partial_fillet(const Blend_mesh& mesh, const std::vector<Edge_blend>& blends, const std::vector<Flaw>& flaws,
                 Blend_mesh& out, const Fillet_options& options, const Blend_engine& engine)
      : mesh_(mesh), blends_(blends), flaws_(flaws), out_(out), options_(options), engine_(engine) {}

  Fillet_outcome run() {
    Fillet_outcome outcome;
    Blend_parts found = find_parts(mesh_, blends_, options_);
    parts_ = std::move(found.parts);
    outcome.diagnosis = found.diagnosis.ok() ? leave_out_flawed() : found.diagnosis;
    while (outcome.ok()) {
      const Divided_mesh divided = divide_at_stations(mesh_, blends_, parts_, options_);
      outcome = blend(divided);
      if (!outcome.ok() || !leave_out_unused(divided, outcome)) break;
      out_.clear();
    }
    add_sharp_reports(outcome);
    return outcome;
  }

 private:
  /// Parts that would divide a face with a flaw.
  Diagnosis leave_out_flawed() {
    std::vector<bool> is_flawed(mesh_.number_of_faces(), false);
    for (const Flaw& flaw : flaws_)
      for (const Face f : flaw.faces) is_flawed[f.idx()] = true;
    Diagnosis first;
    bool some = false;
    for (Blend_part& part : parts_) {
      const Diagnosis flaw = part.whole ? Diagnosis{} : flaw_at_ends(part, is_flawed);
      some = some || flaw.ok();
      if (flaw.ok()) continue;
      if (first.ok()) first = flaw;
      part.left_sharp = true;
      sharp_.push_back(report_of(part, flaw));
    }
    return options_.keep_going && some ? Diagnosis{} : first;
  }

  [[nodiscard]] Diagnosis flaw_at_ends(const Blend_part& part, const std::vector<bool>& is_flawed) const {
    for (const Curve_station& s : part.ends) {
      if (s.part == 0) continue;
      for (const Halfedge h : {part.curve[s.edge], mesh_.opposite(part.curve[s.edge])}) {
        if (!is_flawed[mesh_.face(h).idx()]) continue;
        const auto is_here = [&](const Flaw& flaw) {
          return flaw.faces[0] == mesh_.face(h) || flaw.faces[1] == mesh_.face(h);
        };
        return flaw_diagnosis(mesh_, *std::find_if(flaws_.begin(), flaws_.end(), is_here), "where a blend would end");
      }
    }
    return {};
  }

  [[nodiscard]] Blend_report report_of(const Blend_part& part, const Diagnosis& diagnosis) const {
    Blend_report report;
    report.diagnosis = diagnosis;
    report.edges = std::min(part.ends[1].edge + (part.ends[1].part > 0 ? 1 : 0), part.curve.size()) - part.ends[0].edge;
    report.closed = false;
    report.convex = is_convex_edge(mesh_.edge(part.curve[part.ends[0].edge]), mesh_);
    report.radius = radius_law_of(blends_[part.blend], options_).largest();
    return report;
  }

  Fillet_outcome blend(const Divided_mesh& divided) {
    Fillet_outcome outcome;
    const Stopwatch watch;
    if (!divided.divided.empty()) outcome.diagnosis = check(divided);
    const double checking = watch.milliseconds();
    if (!outcome.ok()) return outcome;
    Fillet_body body;
    body.mesh = body.base[0] = body.base[1] = &divided.mesh;
    body.creases = divided.creases;
    body.edge_points = divided.edge_points;
    outcome = engine_(body, divided.blends);
    outcome.times.validate += checking;
    if (!outcome.ok() || divided.divided.empty()) return outcome;
    const Stopwatch copying;
    Fillet_outcome division;
    division.origins = divided.origins;
    division.changed_faces = divided.divided;
    Ancestry ancestry(division);
    ancestry.advance(outcome, 0);
    ancestry.put_kept_first(out_);
    ancestry.describe_faces(outcome);
    outcome.times.copy += copying.milliseconds();
    return outcome;
  }

  /// The engine takes the mesh to be valid, but new vertices are rounded.
  [[nodiscard]] static Diagnosis check(const Divided_mesh& divided) {
    Diagnosis diagnosis = validate_changes(divided.mesh, divided.divided).diagnosis;
    if (diagnosis.ok()) return diagnosis;
    diagnosis.status = Status::not_supported;
    diagnosis.detail = "a blend cannot end there within an edge, whose faces are too thin to be divided";
    return diagnosis;
  }

  /// Finds parts that are still sharp in a result; false if there are none that have divided the mesh in vain.
  bool leave_out_unused(const Divided_mesh& divided, Fillet_outcome& outcome) {
    const auto is_sharp = [](const Blend_report& report) { return !report.diagnosis.ok(); };
    if (std::none_of(outcome.blends.begin(), outcome.blends.end(), is_sharp)) return false;
    const Edge_finder find(out_);
    std::vector<bool> is_new(out_.number_of_faces(), false);
    for (const Face f : outcome.blend_faces) is_new[f.idx()] = true;
    const auto is_used = [&](Vertex v) {  // a blend that ends there leaves new faces
      const Vertex placed = find.vertex(divided.mesh.point(v));
      if (placed == Blend_mesh::null_vertex()) return true;
      const auto faces = out_.faces_around_target(out_.halfedge(placed));
      return std::any_of(faces.begin(), faces.end(), [&](Face f) { return is_new[f.idx()]; });
    };
    bool some = false;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      std::size_t stations = 0, used = 0;
      for (const Vertex v : divided.stations[i]) {
        if (v == Blend_mesh::null_vertex()) continue;
        ++stations;
        used += is_used(v) ? 1 : 0;
      }
      if (stations == 0 || used > 0) continue;
      parts_[i].left_sharp = some = true;
    }
    if (some) std::copy_if(outcome.blends.begin(), outcome.blends.end(), std::back_inserter(refused_), is_sharp);
    return some;
  }

  /// Reports of curves that are no longer tried, behind those of the last try.
  void add_sharp_reports(Fillet_outcome& outcome) {
    const auto is_listed = [&](const Blend_report& report) {
      return std::any_of(outcome.blends.begin(), outcome.blends.end(), [&](const Blend_report& other) {
        return other.diagnosis.status == report.diagnosis.status && other.diagnosis.point == report.diagnosis.point &&
               other.edges == report.edges && other.radius == report.radius;
      });
    };
    std::copy_if(refused_.begin(), refused_.end(), std::back_inserter(sharp_),
                 [&](const Blend_report& report) { return !is_listed(report); });
    outcome.blends.insert(outcome.blends.end(), sharp_.begin(), sharp_.end());
  }

  const Blend_mesh& mesh_;
  const std::vector<Edge_blend>& blends_;
  const std::vector<Flaw>& flaws_;
  Blend_mesh& out_;
  const Fillet_options& options_;
  const Blend_engine& engine_;
  std::vector<Blend_part> parts_;
  std::vector<Blend_report> sharp_;    // of parts that were not tried
  std::vector<Blend_report> refused_;  // of curves that were refused where the mesh was divided for them
};

}  // namespace

Fillet_outcome fillet_partial(const Blend_mesh& mesh, const std::vector<Edge_blend>& blends,
                              const std::vector<Flaw>& flaws, Blend_mesh& out, const Fillet_options& options,
                              const Blend_engine& engine) {
  return Partial_fillet(mesh, blends, flaws, out, options, engine).run();
}

}  // namespace cgal_blend
