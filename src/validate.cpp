// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/validate.h>

#include "mesh_checks.h"
#include "topology_defects.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace cgal_blend {

namespace {

using internal::Components;
using internal::Face_pair;
using internal::Face_table;
using internal::Triangle;
using internal::Triangle_topology;

std::string text(std::size_t i) { return std::to_string(i); }

/// Collects findings of one run; the first one becomes the diagnosis.
class Inspection {
 public:
  explicit Inspection(const Blend_mesh& mesh, Flaw_policy policy = Flaw_policy::refuse) : mesh_(mesh), policy_(policy) {
    report_.vertices = mesh.number_of_vertices();
    report_.faces = mesh.number_of_faces();
  }

  Validity_report whole();
  Validity_report changes(const std::vector<Face>& changed);

 private:
  void note(const Diagnosis& diagnosis);
  void note(Status status, std::string detail, std::optional<Point_3> point = {});
  void note_flaw(Status status, std::string detail, const Point_3& point);
  [[nodiscard]] const Point_3& point(std::uint32_t v) const { return mesh_.point(Vertex(v)); }

  bool tabulate();
  bool check_finite(const Face_table& faces);
  void check_topology(const Face_table& faces, const Triangle_topology& t);
  void check_linkage(const Face_table& faces, const Triangle_topology& t);
  [[nodiscard]] double diagonal() const;
  void check_size(const Face_table& faces);
  void check_intersections(const std::vector<Face_pair>& pairs);
  void check_orientation(const Components& components, const internal::Orientation_doubts& doubts);
  void measure(const Components& components);
  [[nodiscard]] bool sound() const { return report_.closed && report_.manifold; }

  const Blend_mesh& mesh_;
  Flaw_policy policy_;
  Face_table table_;
  Validity_report report_;
};

void Inspection::note(const Diagnosis& diagnosis) {
  if (report_.diagnosis.ok()) report_.diagnosis = diagnosis;
}

void Inspection::note(Status status, std::string detail, std::optional<Point_3> point) {
  Diagnosis diagnosis;
  diagnosis.status = status;
  diagnosis.detail = std::move(detail);
  diagnosis.point = point;
  note(diagnosis);
}

void Inspection::note_flaw(Status status, std::string detail, const Point_3& point) {
  if (policy_ == Flaw_policy::refuse) note(status, std::move(detail), point);
}

/// Fills the table of faces; false if there are none, or one is no triangle.
bool Inspection::tabulate() {
  if (report_.faces == 0) {
    note(Status::input_empty, "");
    return false;
  }
  table_.faces.reserve(report_.faces);
  table_.triangles.reserve(report_.faces);
  for (const Face f : mesh_.faces()) {
    const Halfedge h = mesh_.halfedge(f);
    const Halfedge second = mesh_.next(h), third = mesh_.next(second);
    if (mesh_.next(third) != h) {
      note(Status::input_degenerate, "face " + text(f) + " is not a triangle", mesh_.point(mesh_.target(h)));
      return false;
    }
    table_.faces.push_back(f);
    table_.triangles.push_back({mesh_.source(h), mesh_.target(h), mesh_.target(second)});
  }
  return true;
}

bool Inspection::check_finite(const Face_table& faces) {
  for (const Triangle& t : faces.triangles)
    for (const std::uint32_t v : t)
      for (int k = 0; k < 3; ++k)
        if (!std::isfinite(point(v)[k])) {
          note(Status::input_not_finite, "vertex " + text(v));
          return false;
        }
  report_.finite = true;
  return true;
}

/// Judges the surface by vertex indices alone, as a reader of the written file would see it.
void Inspection::check_topology(const Face_table& faces, const Triangle_topology& t) {
  const auto point_of = [this](std::uint32_t v) { return point(v); };
  note(internal::manifold_defect(t, faces.triangles, point_of));
  note(internal::closedness_defect(t, faces.triangles, point_of));
  report_.manifold = t.manifold();
  report_.closed = !t.border_edge && !t.repeated_corner;
  if (sound()) check_linkage(faces, t);
}

/// The halfedges must say what the indices say; anything else is a broken data structure.
void Inspection::check_linkage(const Face_table& faces, const Triangle_topology& t) {
  for (std::uint32_t f = 0; f < faces.faces.size(); ++f) {
    Halfedge h = mesh_.halfedge(faces.faces[f]);
    for (std::uint32_t c = 3 * f; c < 3 * f + 3; ++c, h = mesh_.next(h)) {
      const std::uint32_t twin = t.twin[c];
      const bool linked = twin == Triangle_topology::none || mesh_.face(mesh_.opposite(h)) == faces.faces[twin / 3];
      if (linked && mesh_.face(h) == faces.faces[f] && mesh_.prev(mesh_.next(h)) == h) continue;
      report_.manifold = false;
      return note(Status::input_not_manifold, "face " + text(faces.faces[f]) + " is not linked to its neighbours",
                  mesh_.point(mesh_.target(h)));
    }
  }
}

double Inspection::diagonal() const {
  CGAL::Bbox_3 box;
  for (const Triangle& t : table_.triangles)
    for (const std::uint32_t v : t) box += point(v).bbox();
  return std::hypot(box.x_span(), box.y_span(), box.z_span());
}

/// Faces without area, and edges without length beside the whole.
void Inspection::check_size(const Face_table& faces) {
  const double shortest = shortest_edge_fraction * diagonal();
  std::set<std::pair<std::uint32_t, std::uint32_t>> short_edges;  // hardly ever holds anything
  for (std::size_t f = 0; f < faces.faces.size(); ++f) {
    const Triangle& t = faces.triangles[f];
    bool is_flaw = false;
    if (CGAL::collinear(point(t[0]), point(t[1]), point(t[2]))) {
      is_flaw = true;
      ++report_.degenerate_faces;
      note_flaw(Status::input_degenerate, "face " + text(faces.faces[f]) + " has no area", point(t[0]));
    }
    for (int i = 0; i < 3; ++i) {
      const auto [u, v] = std::minmax({t[i], t[(i + 1) % 3]});
      if (!(CGAL::squared_distance(point(u), point(v)) < shortest * shortest)) continue;
      is_flaw = true;
      short_edges.insert({u, v});
      note_flaw(Status::input_degenerate,
                "edge between vertices " + text(u) + " and " + text(v) + " has almost no length", point(u));
    }
    if (is_flaw) report_.flaws.push_back({Status::input_degenerate, {faces.faces[f], faces.faces[f]}});
  }
  report_.short_edges = short_edges.size();
}

void Inspection::check_intersections(const std::vector<Face_pair>& pairs) {
  report_.intersections_checked = true;
  report_.self_intersections = pairs.size();
  if (pairs.empty()) return;
  for (const auto& [f, g] : pairs) report_.flaws.push_back({Status::input_self_intersecting, {f, g}});
  std::string detail = "faces " + text(pairs[0].first) + " and " + text(pairs[0].second);
  if (pairs.size() > 1) detail += ", the first of " + text(pairs.size()) + " pairs";
  note_flaw(Status::input_self_intersecting, detail, internal::meeting_point(mesh_, pairs[0]));
}

void Inspection::check_orientation(const Components& components, const internal::Orientation_doubts& doubts) {
  const std::size_t bad = internal::misoriented_component(mesh_, table_, components, doubts);
  report_.outward = bad == components.count;
  if (report_.outward) return;
  const auto first = std::find(components.of_face.begin(), components.of_face.end(), bad);
  const Face f(static_cast<std::uint32_t>(first - components.of_face.begin()));
  const char* what = components.count == 1 ? "it is inside out" : "the piece with face ";
  note(Status::input_misoriented, components.count == 1 ? what : what + text(f) + " is inside out",
       mesh_.point(mesh_.source(mesh_.halfedge(f))));
}

void Inspection::measure(const Components& components) {
  long double area = 0, volume = 0;
  for (const Triangle& t : table_.triangles)
    area += std::sqrt(CGAL::squared_area(point(t[0]), point(t[1]), point(t[2])));
  for (const double part : components.volume) volume += part;
  report_.components = components.count;
  report_.area = static_cast<double>(area);
  report_.volume = report_.closed ? static_cast<double>(volume) : 0;
}

Validity_report Inspection::whole() {
  if (!tabulate() || !check_finite(table_)) return report_;
  check_topology(table_, internal::analyze_topology(mesh_.num_vertices(), table_.triangles));
  check_size(table_);
  const Components components = internal::find_components(mesh_, table_);
  measure(components);
  if (!report_.manifold) return report_;
  check_intersections(internal::intersecting_pairs(mesh_));
  if (!report_.ok()) return report_;
  internal::Orientation_doubts doubts;
  for (const Flaw& flaw : report_.flaws) {
    const std::uint32_t c = components.of_face[flaw.faces[0]], d = components.of_face[flaw.faces[1]];
    if (c != d) doubts.crossing.insert(std::minmax(c, d));
  }
  check_orientation(components, doubts);
  return report_;
}

/// Which vertices belong to changed faces.
std::vector<char> mark_vertices(const Blend_mesh& mesh, const std::vector<Face>& changed) {
  std::vector<char> marks(mesh.num_vertices(), 0);
  for (const Face f : changed)
    for (const Vertex v : vertices_around_face(mesh.halfedge(f), mesh)) marks[v] = 1;
  return marks;
}

/// Per piece: whether it has a face of old, which vouches for its orientation.
std::vector<char> find_old_components(const Components& components, const Face_table& table,
                                      const std::vector<char>& is_changed) {
  std::vector<char> has_old(components.count, 0);
  for (const Face f : table.faces)
    if (!is_changed[f]) has_old[components.of_face[f]] = 1;
  return has_old;
}

Validity_report Inspection::changes(const std::vector<Face>& changed) {
  if (!tabulate()) return report_;
  const std::vector<char> touched = mark_vertices(mesh_, changed);
  std::vector<char> is_changed(mesh_.num_faces(), 0);
  for (const Face f : changed) is_changed[f] = 1;
  Face_table around, fresh;
  for (std::size_t i = 0; i < table_.faces.size(); ++i) {
    const Triangle& t = table_.triangles[i];
    if (!touched[t[0]] && !touched[t[1]] && !touched[t[2]]) continue;
    around.faces.push_back(table_.faces[i]);
    around.triangles.push_back(t);
    if (!is_changed[table_.faces[i]]) continue;
    fresh.faces.push_back(table_.faces[i]);
    fresh.triangles.push_back(t);
  }
  if (!check_finite(fresh)) return report_;
  check_topology(around, internal::analyze_topology(mesh_.num_vertices(), around.triangles, touched));
  check_size(fresh);
  const Components components = internal::find_components(mesh_, table_);
  measure(components);
  if (!report_.manifold) return report_;
  check_intersections(internal::intersecting_pairs(mesh_, table_, changed));
  if (!report_.ok()) return report_;
  internal::Orientation_doubts doubts;
  doubts.vouched_for = find_old_components(components, table_, is_changed);
  check_orientation(components, doubts);
  return report_;
}

}  // namespace

Validity_report validate(const Blend_mesh& mesh, Flaw_policy policy) { return Inspection(mesh, policy).whole(); }

Validity_report validate_changes(const Blend_mesh& mesh, const std::vector<Face>& changed) {
  return Inspection(mesh).changes(changed);
}

}  // namespace cgal_blend
