// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge_assembly.h"

#include "join_rows.h"
#include "refusal.h"
#include "stitching.h"
#include "stopwatch.h"

#include <cgal_blend/validate.h>

#include <algorithm>
#include <utility>

namespace cgal_blend {

namespace {

Bridge_cut begin_cut(const Blend_mesh& mesh, const std::vector<const Bridge_side*>& sides) {
  Bridge_cut cut;
  cut.mesh = mesh;
  for (const Bridge_side* side : sides) {
    cut.rims.push_back(side->rim);
    cut.diagnosis = add_rim_vertices(cut.mesh, {}, cut.rims.back());
    if (!cut.diagnosis.ok()) return cut;
  }
  return cut;
}

/// The cut's own refusals are in terms of rolling balls.
Diagnosis renamed(Diagnosis diagnosis, Status status) {
  diagnosis.status = status;
  return diagnosis;
}

template <class Item>
void append(std::vector<Item>& to, const std::vector<Item>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

/// The triangles of one bridge, on vertices of the mesh, to which it adds those between the contacts.
class Bridge_sewing {
 public:
  Bridge_sewing(Blend_mesh& mesh, const Bridge_grid& grid, const Rim& first, const Rim& second)
      : mesh_(mesh), grid_(grid) {
    Point_line before = line(first, grid.side(0).parameters, [](double s) { return s; });
    const std::size_t columns = grid.s().size();
    for (std::size_t row = 1; row + 1 < grid.t().size(); ++row) {
      Point_line inner{{}, grid.s()};
      for (std::size_t i = 0; i < columns; ++i)
        inner.vertices.push_back(add(mesh.add_vertex(grid.points()[row * columns + i])));
      join_rows(before, inner, true, 0, soup_);
      before = std::move(inner);
    }
    const Point_line last =
        line(second, grid.side(1).parameters, [&](double s) { return opposite_parameter(s, grid.turn()); });
    join_rows(before, last, true, 0, soup_);
  }

  [[nodiscard]] std::vector<Triangle> triangles() const {
    std::vector<Triangle> result;
    for (const auto& t : soup_.triangles)
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
        result.push_back({vertices_[t[0]], vertices_[t[1]], vertices_[t[2]]});
    return result;
  }

 private:
  std::size_t add(Vertex v) {
    vertices_.push_back(v);
    return soup_.add(mesh_.point(v));
  }

  template <class Parameter>
  Point_line line(const Rim& rim, const std::vector<double>& parameters, const Parameter& parameter) {
    Trim_curve curve;
    for (std::size_t i = 0; i < rim.vertices.size(); ++i) {
      curve.vertices.push_back(add(rim.vertices[i]));
      curve.parameters.push_back(parameter(parameters[i]));
    }
    return ascending(curve);
  }

  Blend_mesh& mesh_;
  const Bridge_grid& grid_;
  Triangle_soup soup_;
  std::vector<Vertex> vertices_;  // per point of the soup
};

/// Puts what is kept first and describes where the faces come from.
class Finisher {
 public:
  Finisher(const Bridge_body& body, const Blend_mesh& mesh, const Trimming& trimming)
      : body_(body), mesh_(mesh), trimming_(trimming), old_faces_(body.mesh->number_of_faces()) {}

  void run(Bridge_outcome& outcome, Blend_mesh& out) {
    std::vector<Face> faces, changed;
    for (const Face f : mesh_.faces()) (is_kept(f) ? faces : changed).push_back(f);
    outcome.kept_faces = faces.size();
    append(faces, changed);
    const std::vector<Vertex> vertices(mesh_.vertices().begin(), mesh_.vertices().end());
    Reordered result = reorder(mesh_, vertices, faces);
    for (const Face f : faces) outcome.origins.push_back(origin(f));
    for (auto& of_bridge : outcome.bridge_faces)
      for (Face& f : of_bridge) f = result.face_of[f.idx()];
    for (std::size_t i = outcome.kept_faces; i < faces.size(); ++i)
      outcome.changed_faces.push_back(Face(static_cast<std::uint32_t>(i)));
    const Stopwatch watch;
    const Validity_report report =
        body_.check_all ? validate(result.mesh) : validate_changes(result.mesh, outcome.changed_faces);
    outcome.times.validate = watch.milliseconds();
    outcome.diagnosis = report.diagnosis;
    outcome.volume = report.volume;
    outcome.area = report.area;
    out = std::move(result.mesh);
  }

 private:
  [[nodiscard]] bool is_kept(Face f) const { return f.idx() < old_faces_ && body_.cells.whole(f, mesh_); }

  [[nodiscard]] std::uint32_t origin(Face f) const {
    if (f.idx() < old_faces_) return body_.cells.cell(f);
    const std::size_t added = f.idx() - old_faces_;
    if (added >= trimming_.remnant_cells.size()) return no_origin;
    return body_.cells.cell(Face(trimming_.remnant_cells[added]));  // cut as a mesh of its own
  }

  const Bridge_body& body_;
  const Blend_mesh& mesh_;
  const Trimming& trimming_;
  std::size_t old_faces_;
};

}  // namespace

Bridge_cut cut_spots(const Blend_mesh& mesh, const std::array<const Bridge_side*, 2>& sides) {
  Bridge_cut cut = begin_cut(mesh, {sides[0], sides[1]});
  if (!cut.diagnosis.ok()) return cut;
  std::unordered_set<Face> gone;
  for (const Rim& rim : cut.rims) {
    Trimming part = trim(cut.mesh, {}, {rim}, {});
    if (!part.diagnosis.ok()) {
      cut.diagnosis = renamed(part.diagnosis, Status::curve_crosses_itself);
      return cut;
    }
    for (const Face f : part.removed)
      if (!gone.insert(f).second) {
        cut.diagnosis = refusal(Status::regions_overlap, to_vec(mesh.point(mesh.target(mesh.halfedge(f)))));
        return cut;
      }
    append(cut.trimming.removed, part.removed);
    append(cut.trimming.remnants, part.remnants);
    append(cut.trimming.remnant_cells, part.remnant_cells);
  }
  return cut;
}

Bridge_cut cut_strips(const Blend_mesh& mesh, const std::vector<const Bridge_side*>& sides,
                      const std::unordered_set<Edge>& curves) {
  Bridge_cut cut = begin_cut(mesh, sides);
  if (!cut.diagnosis.ok()) return cut;
  cut.trimming = trim(cut.mesh, {}, cut.rims, curves);
  if (!cut.trimming.diagnosis.ok()) cut.diagnosis = renamed(cut.trimming.diagnosis, Status::regions_overlap);
  return cut;
}

Bridge_outcome sew(const Bridge_body& body, const Bridge_cut& cut, const std::vector<const Bridge_grid*>& bridges,
                   Blend_mesh& out) {
  Bridge_outcome outcome;
  Blend_mesh work = cut.mesh;
  std::vector<Triangle> triangles = cut.trimming.remnants;
  std::vector<std::size_t> last{triangles.size()};
  for (std::size_t k = 0; k < bridges.size(); ++k) {
    append(triangles, Bridge_sewing(work, *bridges[k], cut.rims[2 * k], cut.rims[2 * k + 1]).triangles());
    last.push_back(triangles.size());
  }
  const Replacement replaced = replace_faces(work, cut.trimming.removed, triangles);
  if (replaced.conflict) {
    outcome.diagnosis = refusal(Status::regions_overlap, to_vec(work.point(*replaced.conflict)));
    return outcome;
  }
  for (std::size_t k = 0; k < bridges.size(); ++k)
    outcome.bridge_faces.emplace_back(replaced.faces.begin() + static_cast<std::ptrdiff_t>(last[k]),
                                      replaced.faces.begin() + static_cast<std::ptrdiff_t>(last[k + 1]));
  Finisher(body, work, cut.trimming).run(outcome, out);
  if (outcome.diagnosis.ok()) return outcome;
  const Status status = outcome.diagnosis.status;
  outcome.diagnosis.status =
      status == Status::input_self_intersecting ? Status::blend_collides : Status::result_invalid;
  outcome.diagnosis.detail.clear();
  out.clear();
  return outcome;
}

}  // namespace cgal_blend
