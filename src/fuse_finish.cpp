// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuse_assembly.h"
#include "placed_region.h"

#include <cgal_blend/validate.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace cgal_blend {

namespace {

/// Judges a fused mesh by kinds of its faces.
class Inspector {
 public:
  Inspector(const std::array<Fuse_side, 2>& sides, const Fused_mesh& fused, bool bent)
      : sides_(sides), fused_(fused), mesh_(fused.mesh), bent_(bent) {}

  /// True if a mesh had holes: its orientation has not been checked by itself.
  [[nodiscard]] bool has_open_part() const {
    for (const Fuse_side& side : sides_)
      for (const Fuse_part& part : side.parts)
        if (!CGAL::is_closed(*part.mesh)) return true;
    return false;
  }

  [[nodiscard]] std::vector<Face> faces(std::size_t from, std::size_t to) const {
    std::vector<Face> result;
    for (std::size_t i = from; i < to; ++i) result.push_back(Face(static_cast<std::uint32_t>(i)));
    return result;
  }

  [[nodiscard]] std::vector<Face> faces_to_check() const;
  [[nodiscard]] Diagnosis in_terms_of_fusion(Validity_report report) const;
  void measure_tangency(Fuse_outcome& outcome) const;

 private:
  [[nodiscard]] bool is_transition(Face f) const { return f.idx() >= fused_.old_faces; }
  [[nodiscard]] CGAL::Bbox_3 box(Face f) const {
    CGAL::Bbox_3 sum;
    for (const Vertex v : vertices_around_face(mesh_.halfedge(f), mesh_)) sum += mesh_.point(v).bbox();
    return sum;
  }
  [[nodiscard]] Status kind(const Flaw& flaw) const;

  const std::array<Fuse_side, 2>& sides_;
  const Fused_mesh& fused_;
  const Blend_mesh& mesh_;
  bool bent_;
};

/// All that is new, and faces of each mesh within the bounding boxes of the meshes before it.
std::vector<Face> Inspector::faces_to_check() const {
  std::vector<Face> chosen;
  std::vector<CGAL::Bbox_3> before;
  std::size_t begin = 0;
  for (const std::size_t end : fused_.part_end) {
    CGAL::Bbox_3 whole;
    for (const Face f : faces(begin, end)) {
      const CGAL::Bbox_3 b = box(f);
      whole += b;
      if (std::any_of(before.begin(), before.end(),
                      [&](const CGAL::Bbox_3& other) { return CGAL::do_overlap(b, other); }))
        chosen.push_back(f);
    }
    before.push_back(whole);
    begin = end;
  }
  const std::vector<Face> fresh = faces(fused_.kept_faces, mesh_.number_of_faces());
  chosen.insert(chosen.end(), fresh.begin(), fresh.end());
  return chosen;
}

Status Inspector::kind(const Flaw& flaw) const {
  const bool first = is_transition(flaw.faces[0]), second = is_transition(flaw.faces[1]);
  if (flaw.status == Status::input_degenerate) {
    if (flaw.faces[0].idx() < fused_.kept_faces) return flaw.status;  // of an open mesh
    return first ? Status::result_invalid : Status::plane_meets_vertex;
  }
  if (first && second) return bent_ ? Status::blend_folds : Status::result_invalid;
  return first || second ? Status::blend_collides : Status::sides_interpenetrate;
}

Diagnosis Inspector::in_terms_of_fusion(Validity_report report) const {
  if (report.ok()) return {};
  Diagnosis diagnosis = std::move(report.diagnosis);
  diagnosis.detail =
      std::string(describe(diagnosis.status)) + (diagnosis.detail.empty() ? "" : ": " + diagnosis.detail);
  if (report.flaws.empty()) {
    // What is wrong with an open mesh as a whole is seen only when its holes are closed.
    const bool of_input = diagnosis.status == Status::input_misoriented && has_open_part();
    if (of_input) diagnosis.detail.clear();
    if (!of_input) diagnosis.status = Status::result_invalid;
    return diagnosis;
  }
  diagnosis.status = kind(report.flaws.front());
  if (status_class(diagnosis.status) != Status_class::result) diagnosis.detail.clear();
  return diagnosis;
}

void Inspector::measure_tangency(Fuse_outcome& outcome) const {
  double sum = 0, count = 0;
  for (std::size_t i = fused_.old_faces; i < mesh_.number_of_faces(); ++i) {
    const Face f(static_cast<std::uint32_t>(i));
    for (const Halfedge h : halfedges_around_face(mesh_.halfedge(f), mesh_)) {
      const Face other = mesh_.face(mesh_.opposite(h));
      if (is_transition(other)) continue;
      const double angle = angle_between(face_normal(mesh_, f), face_normal(mesh_, other)) * 180 / CGAL_PI;
      sum += angle;
      ++count;
      outcome.tangency_max = std::max(outcome.tangency_max, angle);
    }
  }
  outcome.tangency_mean = count > 0 ? sum / count : 0;
}

}  // namespace

void finish(const std::array<Fuse_side, 2>& sides, const Fused_mesh& fused, bool bent, Fuse_outcome& outcome) {
  const Inspector inspector(sides, fused, bent);
  const Blend_mesh& mesh = fused.mesh;
  Validity_report report =
      inspector.has_open_part() ? validate(mesh) : validate_changes(mesh, inspector.faces_to_check());
  outcome.volume = report.volume;
  outcome.area = report.area;
  outcome.diagnosis = inspector.in_terms_of_fusion(std::move(report));
  if (!outcome.ok()) return;
  outcome.kept_faces = fused.kept_faces;
  outcome.changed_faces = inspector.faces(fused.kept_faces, mesh.number_of_faces());
  outcome.transition_faces = inspector.faces(fused.old_faces, mesh.number_of_faces());
  outcome.euler_characteristic = static_cast<long>(mesh.number_of_vertices()) -
                                 static_cast<long>(mesh.number_of_edges()) + static_cast<long>(mesh.number_of_faces());
  inspector.measure_tangency(outcome);
}

}  // namespace cgal_blend
