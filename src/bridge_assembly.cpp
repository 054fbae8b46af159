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

constexpr std::size_t fewest_guarded_rows = 4;  // of facets
constexpr double clearance = 2;                 // of rows from those at the contacts, over what these bulge
constexpr double spacing = 0.3;                 // least one of vertices next to a rim, over their distance from it

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

/// The triangles of one bridge, on vertices of the mesh, to which it adds those between the contacts. Rows next to a
/// contact have a vertex for each one of the rim, as far as there is room, on the same ray, so that their facets lean as
/// those of the mesh do.
class Bridge_sewing {
 public:
  Bridge_sewing(Blend_mesh& mesh, const Bridge_grid& grid, const Rim& first, const Rim& second)
      : mesh_(mesh), grid_(grid) {
    const std::size_t rows = grid.t().size() - 1;
    const bool guarded = rows >= fewest_guarded_rows;
    const std::array<Point_line, 2> rims{rim_line(0, first), rim_line(1, second)};
    std::vector<Point_line> lines{rims[0]}, guards;
    if (guarded) guards = {guard_line(0, rims[0], 1), guard_line(1, rims[1], rows - 1)};
    if (guarded) lines.push_back(guards[0]);
    for (std::size_t row = guarded ? 2 : 1; row + (guarded ? 1 : 0) < rows; ++row)
      if (!guarded || clear_of_guards(row)) lines.push_back(inner_line(row));
    if (guarded) lines.push_back(guards[1]);
    lines.push_back(rims[1]);
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) join_rows(lines[i], lines[i + 1], true, 0, soup_);
  }

  [[nodiscard]] std::vector<Triangle> triangles() const {
    std::vector<Triangle> result;
    for (const auto& t : soup_.triangles) result.push_back({vertices_[t[0]], vertices_[t[1]], vertices_[t[2]]});
    return result;
  }

 private:
  std::size_t add(Vertex v) {
    vertices_.push_back(v);
    return soup_.add(mesh_.point(v));
  }

  /// Vertices by ascending parameter of the bridge.
  Point_line rim_line(std::size_t end, const Rim& rim) {
    const std::vector<double>& parameters = grid_.side(end).parameters;
    Trim_curve curve;
    for (std::size_t i = 0; i < rim.vertices.size(); ++i) {
      curve.vertices.push_back(add(rim.vertices[i]));
      curve.parameters.push_back(end == 0 ? parameters[i] : opposite_parameter(parameters[i], grid_.turn()));
    }
    return ascending(curve);
  }

  /// Vertices on the rays of a rim's vertices; of those that are near each other against their way, the first.
  Point_line guard_line(std::size_t end, const Point_line& rim, std::size_t row) {
    Point_line result;
    std::vector<Vec> from;  // vertices of the rim that have one
    double way = 0;
    for (std::size_t i = 0; i < rim.vertices.size(); ++i) {
      const Vec place = to_vec(soup_.points[rim.vertices[i]]);
      if (!from.empty() && (place - from.back()).norm() < spacing * way) continue;
      const Vec p = grid_.point_from_rim(end, rim.parameters[i], grid_.t()[row], place);
      way = (p - place).norm();
      if (from.size() > 3 && (place - from.front()).norm() < spacing * way) break;  // round again
      bulge_[end] = std::max(bulge_[end], (p - on_chord(row, rim.parameters[i])).norm());
      result.vertices.push_back(add(mesh_.add_vertex(to_point(p))));
      result.parameters.push_back(rim.parameters[i]);
      from.push_back(place);
    }
    return result;
  }

  [[nodiscard]] Vec at(std::size_t row, std::size_t column) const {
    return to_vec(grid_.points()[row * grid_.s().size() + column]);
  }

  /// Point between the columns of a row.
  [[nodiscard]] Vec on_chord(std::size_t row, double s) const {
    const auto [low, high, part] = grid_.between_columns(s);
    return (1 - part) * at(row, low) + part * at(row, high);
  }

  /// False for rows so near to the rows at the contacts that their longer chords could cut through those.
  [[nodiscard]] bool clear_of_guards(std::size_t row) const {
    for (const std::size_t end : {0, 1})
      for (std::size_t i = 0; i < grid_.s().size(); ++i)
        if ((at(row, i) - at(end == 0 ? 1 : grid_.t().size() - 2, i)).norm() < clearance * bulge_[end]) return false;
    return true;
  }

  Point_line inner_line(std::size_t row) {
    Point_line result{{}, grid_.s()};
    const std::size_t columns = grid_.s().size();
    for (std::size_t i = 0; i < columns; ++i)
      result.vertices.push_back(add(mesh_.add_vertex(grid_.points()[row * columns + i])));
    return result;
  }

  Blend_mesh& mesh_;
  const Bridge_grid& grid_;
  Triangle_soup soup_;
  std::vector<Vertex> vertices_;   // per point of the soup
  std::array<double, 2> bulge_{};  // of the rows next to the contacts, over chords between columns
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
  [[nodiscard]] bool is_kept(Face f) const {
    return f.idx() < old_faces_ && (body_.whole.empty() || body_.whole[f.idx()]);
  }

  [[nodiscard]] std::uint32_t input_face(std::uint32_t face) const {
    return body_.origins.empty() ? face : body_.origins[face];
  }

  [[nodiscard]] std::uint32_t origin(Face f) const {
    if (f.idx() < old_faces_) return input_face(f.idx());
    const std::size_t added = f.idx() - old_faces_;
    return added < trimming_.remnant_cells.size() ? input_face(trimming_.remnant_cells[added]) : no_origin;
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

Blend_mesh take_mesh(Bridge_cut& cut, const Blend_mesh& uncut) {
  if (!cut.mesh.is_empty()) return std::exchange(cut.mesh, Blend_mesh());
  Blend_mesh mesh = uncut;
  for (const Rim& rim : cut.rims)
    for (std::size_t i = 0; i < rim.vertices.size(); ++i) {
      if (rim.path.stations[i].kind == Station::Kind::vertex) continue;
      const Vertex v = mesh.add_vertex(to_point(rim.path.stations[i].point));
      CGAL_assertion(v == rim.vertices[i]);
      CGAL_USE(v);
    }
  return mesh;
}

Bridge_outcome sew(const Bridge_body& body, const Bridge_cut& cut, Blend_mesh work,
                   const std::vector<const Bridge_grid*>& bridges, Blend_mesh& out) {
  Bridge_outcome outcome;
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
