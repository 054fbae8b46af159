// SPDX-License-Identifier: GPL-3.0-or-later
#include "trim.h"

#include "cell_triangulation.h"
#include "refusal.h"

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

namespace cgal_blend {

namespace {

using Cell = Cell_map::Cell;
using Directed = std::pair<Vertex, Vertex>;

/// The faces of the base surface that a station lies on.
std::vector<Face> faces_at(const Blend_mesh& mesh, const Station& s) {
  switch (s.kind) {
    case Station::Kind::face: return {s.face};
    case Station::Kind::edge: return {mesh.face(s.edge), mesh.face(mesh.opposite(s.edge))};
    case Station::Kind::vertex: break;
  }
  std::vector<Face> faces;
  for (const Face f : mesh.faces_around_target(mesh.halfedge(s.vertex))) faces.push_back(f);
  return faces;
}

class Trimmer {
 public:
  Trimmer(const Blend_mesh& mesh, const Cell_map& cells, const std::vector<Rim>& rims,
          const std::unordered_set<Edge>& curves, const std::set<Directed>& filled)
      : mesh_(mesh), cells_(cells), rims_(rims), curves_(curves), filled_(filled) {}

  Trimming run() {
    for (const Rim& rim : rims_)
      if (!assign_segments(rim)) return fail();
    for (const Rim& rim : rims_)
      if (!assign_edge_stations(rim)) return fail();
    for (const auto& [cell, work] : work_)
      if (!work.segments.empty() && !cut(cell, work)) return fail();
    if (!flood()) return fail();
    for (const auto& [cell, work] : work_)
      if (work.segments.empty() && !divide(cell)) return fail();
    for (const auto& [h, stations] : on_edge_) {
      std::vector<Vertex>& chain = result_.divided[mesh_.edge(h)];
      for (const Directed& step : steps_of(h)) chain.push_back(step.first);
      chain.push_back(mesh_.target(h));
    }
    return std::move(result_);
  }

 private:
  /// What happens in one cell. A rim that touches the cell's border in a point, and does not enter, has no segment in it.
  struct Work {
    const Rim* rim = nullptr;        // any of those that cross the cell
    std::vector<Directed> segments;  // what is kept lies to their left
    std::set<Vertex> inner;          // rim vertices inside the cell
  };

  Trimming fail() {
    result_.removed.clear();
    result_.remnants.clear();
    result_.remnant_cells.clear();
    return std::move(result_);
  }

  bool refuse(Status status, const Vec& at) {
    result_.diagnosis = refusal(status, at);
    return false;
  }

  /// Sorts the steps of a rim into the cells that they run in; a step along an edge concerns both its cells.
  bool assign_segments(const Rim& rim) {
    const Blend_mesh& base = rim.surface->mesh();
    const std::size_t n = rim.path.stations.size();
    for (std::size_t i = 0; i + (rim.path.closed ? 0 : 1) < n; ++i) {
      const std::size_t j = (i + 1) % n;
      const Station &a = rim.path.stations[i], &b = rim.path.stations[j];
      bool found = false;
      for (const Face f : faces_at(base, a)) {
        const std::vector<Face> others = faces_at(base, b);
        if (std::find(others.begin(), others.end(), f) == others.end()) continue;
        Work& work = work_[cells_.cell(rim.operand, f)];
        work.rim = &rim;
        const Directed step{rim.vertices[i], rim.vertices[j]};
        work.segments.push_back(rim.keep_left ? step : Directed{step.second, step.first});
        found = true;
      }
      if (!found) return refuse(Status::no_rolling_ball, a.point);
    }
    for (std::size_t i = 0; i < n; ++i)
      for (const Face f : faces_at(base, rim.path.stations[i]))
        if (rim.path.stations[i].kind != Station::Kind::vertex) {
          Work& work = work_[cells_.cell(rim.operand, f)];
          work.rim = &rim;
          if (rim.path.stations[i].kind == Station::Kind::face) work.inner.insert(rim.vertices[i]);
        }
    return true;
  }

  [[nodiscard]] std::vector<Halfedge> boundary(Cell cell) const {
    std::vector<Halfedge> border;
    for (const Face f : cells_.faces(cell))
      for (const Halfedge h : mesh_.halfedges_around_face(mesh_.halfedge(f)))
        if (cells_.cell(mesh_.face(mesh_.opposite(h))) != cell) border.push_back(h);
    return border;
  }

  /// Finds the mesh edge that each edge station divides: base edges may be cut by other curves.
  bool assign_edge_stations(const Rim& rim) {
    const Blend_mesh& base = rim.surface->mesh();
    for (std::size_t i = 0; i < rim.path.stations.size(); ++i) {
      const Station& s = rim.path.stations[i];
      if (s.kind != Station::Kind::edge) continue;
      const Cell cell = cells_.cell(rim.operand, base.face(s.edge));
      const Cell across = cells_.cell(rim.operand, base.face(base.opposite(s.edge)));
      Halfedge nearest;
      double best = 0, at = 0;
      for (const Halfedge h : boundary(cell)) {
        if (cells_.cell(mesh_.face(mesh_.opposite(h))) != across) continue;
        const Halfedge g = std::min(h, mesh_.opposite(h));
        const Vec a = to_vec(mesh_.point(mesh_.source(g))), e = to_vec(mesh_.point(mesh_.target(g))) - a;
        const double t = (s.point - a).dot(e) / e.squaredNorm();
        const double distance = (a + std::clamp(t, 0.0, 1.0) * e - s.point).norm();
        if (nearest != Blend_mesh::null_halfedge() && distance >= best) continue;
        nearest = g;
        best = distance;
        at = t;
      }
      if (nearest == Blend_mesh::null_halfedge() || at <= 0 || at >= 1)  // the contact is not on the solid
        return refuse(Status::no_rolling_ball, s.point);
      on_edge_[nearest].insert({at, rim.vertices[i]});
    }
    return true;
  }

  /// An edge as directed steps, divided at the edge stations.
  [[nodiscard]] std::vector<Directed> steps_of(Halfedge h) const {
    std::vector<Vertex> chain{mesh_.source(h)};
    const auto found = on_edge_.find(std::min(h, mesh_.opposite(h)));
    if (found != on_edge_.end()) {
      for (const auto& [t, v] : found->second) chain.push_back(v);
      if (h != found->first) std::reverse(chain.begin() + 1, chain.end());
    }
    chain.push_back(mesh_.target(h));
    std::vector<Directed> steps;
    for (std::size_t i = 1; i < chain.size(); ++i) steps.push_back({chain[i - 1], chain[i]});
    return steps;
  }

  [[nodiscard]] bool is_kept(const Directed& step) const { return kept_steps_.count(step) != 0; }

  [[nodiscard]] std::vector<Directed> divided_boundary(Cell cell) const {
    std::vector<Directed> steps;
    for (const Halfedge h : boundary(cell)) {
      if (curves_.count(mesh_.edge(h))) continue;  // goes with the blend; nothing that is kept ends there
      for (const Directed& step : steps_of(h)) steps.push_back(step);
    }
    return steps;
  }

  bool cut(Cell cell, const Work& work) {
    const std::vector<Face> parts = cells_.faces(cell);
    touched_.insert(parts.begin(), parts.end());
    return replace(cell, parts, work.segments, work.inner);
  }

  /// What hangs together with a cell that is only touched decides whether it stays.
  bool divide(Cell cell) {
    const std::vector<Face> parts = cells_.faces(cell);
    const auto gone = std::count_if(parts.begin(), parts.end(), [&](Face f) { return dropped_.count(f) != 0; });
    if (gone == static_cast<std::ptrdiff_t>(parts.size())) return true;
    if (gone > 0) return refuse(Status::blends_overlap, corner_of(parts.front()));
    return replace(cell, parts, divided_boundary(cell), {});
  }

  bool replace(Cell cell, const std::vector<Face>& parts, const std::vector<Directed>& segments,
               const std::set<Vertex>& inner) {
    if (parts.empty()) return refuse(Status::no_rolling_ball, to_vec(mesh_.point(segments.front().first)));
    result_.removed.insert(result_.removed.end(), parts.begin(), parts.end());
    // The plane of the cell, oriented outward: that of the base face it is a part of.
    const Vec normal = work_.at(cell).rim->surface->frame(cells_.base_face(parts.front())).face_normal;
    const Cell_triangulation kept = triangulate_cell(mesh_, normal, divided_boundary(cell), segments, inner);
    if (kept.conflict) return refuse(Status::blends_overlap, to_vec(*kept.conflict));
    for (const auto& t : kept.triangles) {
      result_.remnants.push_back(t);
      result_.remnant_cells.push_back(cell);
      for (int i = 0; i < 3; ++i) kept_steps_.insert({t[i], t[(i + 1) % 3]});
    }
    return true;
  }

  [[nodiscard]] Vec corner_of(Face f) const { return to_vec(mesh_.point(mesh_.target(mesh_.halfedge(f)))); }

  /// Everything behind a part of a cut cell's border that no remnant uses goes, and what hangs together with it.
  bool flood() {
    std::vector<Face> stack;
    const auto drop = [&](Face f) {
      if (touched_.count(f) || !dropped_.insert(f).second) return;
      stack.push_back(f);
    };
    for (const Edge e : curves_)
      for (const Halfedge h : {mesh_.halfedge(e, 0), mesh_.halfedge(e, 1)}) drop(mesh_.face(h));
    for (const auto& [cell, work] : work_) {
      if (work.segments.empty()) continue;
      for (const Halfedge h : boundary(cell))
        for (const Directed& step : steps_of(h))
          if (!is_kept(step) && !filled_.count(step)) drop(mesh_.face(mesh_.opposite(h)));
    }
    while (!stack.empty()) {
      const Face f = stack.back();
      stack.pop_back();
      result_.removed.push_back(f);
      for (const Halfedge h : mesh_.halfedges_around_face(mesh_.halfedge(f))) {
        const Halfedge o = mesh_.opposite(h);
        const std::vector<Directed> steps = steps_of(h);
        const auto fills = std::count_if(steps.begin(), steps.end(), [&](const Directed& s) { return filled_.count(s); });
        if (fills == static_cast<std::ptrdiff_t>(steps.size())) continue;
        if (fills > 0) return refuse(Status::blends_overlap, to_vec(mesh_.point(mesh_.source(h))));
        drop(mesh_.face(o));
        for (const Directed& step : steps_of(o))
          if (is_kept(step))  // would leave a hole
            return refuse(Status::blends_overlap, to_vec(mesh_.point(mesh_.source(h))));
      }
    }
    return true;
  }

  const Blend_mesh& mesh_;
  const Cell_map& cells_;
  const std::vector<Rim>& rims_;
  const std::unordered_set<Edge>& curves_;
  const std::set<Directed>& filled_;
  std::map<Cell, Work> work_;
  std::map<Halfedge, std::set<std::pair<double, Vertex>>> on_edge_;  // curves that end there share their vertex
  std::unordered_set<Face> touched_, dropped_;
  std::set<Directed> kept_steps_;
  Trimming result_;
};

}  // namespace

Diagnosis add_rim_vertices(Blend_mesh& mesh, const Cell_map& cells, Rim& rim) {
  rim.vertices.resize(rim.path.stations.size(), Blend_mesh::null_vertex());
  for (std::size_t i = 0; i < rim.vertices.size(); ++i) {
    const Station& s = rim.path.stations[i];
    Vertex& v = rim.vertices[i];
    if (v != Blend_mesh::null_vertex()) continue;
    v = s.kind == Station::Kind::vertex ? cells.vertex(rim.operand, s.vertex) : mesh.add_vertex(to_point(s.point));
    if (v == Blend_mesh::null_vertex()) return refusal(Status::no_rolling_ball, s.point);
  }
  return {};
}

Trimming trim(const Blend_mesh& mesh, const Cell_map& cells, const std::vector<Rim>& rims,
              const std::unordered_set<Edge>& curves, const std::set<Directed>& filled) {
  return Trimmer(mesh, cells, rims, curves, filled).run();
}

}  // namespace cgal_blend
