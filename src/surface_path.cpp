// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_path.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace cgal_blend {

namespace {

constexpr int longest_section = 100000;  // faces
constexpr double widest_detour = 0.5;    // of a section, over the distance of its ends
constexpr double detour_of_corner = 3;   // the same where it may cross sharp edges
constexpr double flat_of_snap = 1e-6;    // vertices nearer to a section lie in it
constexpr std::size_t no_point = static_cast<std::size_t>(-1);

/// A station under construction, with the given point that it stands for, if any.
struct Draft : Station {
  std::size_t point_index = no_point;
};

Draft on_edge(const Blend_mesh& mesh, Halfedge h, const Vec& at) {
  return {{Station::Kind::edge, mesh.face(h), std::min(h, mesh.opposite(h)), Vertex(), at}, no_point};
}

Draft on_vertex(const Blend_mesh& mesh, const Draft& draft, Vertex v) {
  Draft moved = draft;
  moved.kind = Station::Kind::vertex;
  moved.vertex = v;
  moved.point = to_vec(mesh.point(v));
  return moved;
}

/// A point of a surface; where a ball turns over an edge, that edge is where it touches.
Draft draft_at(const Base_surface& surface, const Surface_point& at, std::size_t index = no_point) {
  const Halfedge edge = surface.band_edge(at.face);
  Draft draft{{Station::Kind::face, at.face, Halfedge(), Vertex(), surface.position(at)}, index};
  if (edge == Blend_mesh::null_halfedge()) return draft;
  draft = on_edge(surface.mesh(), edge, draft.point);
  draft.point_index = index;
  return draft;
}

bool same_place(const Draft& a, const Draft& b, double snap) {
  if (a.kind != b.kind) return false;
  if (a.kind == Station::Kind::vertex) return a.vertex == b.vertex;
  if (a.kind == Station::Kind::edge) return a.edge == b.edge && (a.point - b.point).norm() < snap;
  return a.face == b.face && (a.point - b.point).norm() < snap;
}

/// How a section is followed from one point to the next.
struct Way {
  bool leaves_edge = false;  ///< not by the edge that it starts on
  double ahead = 1;          ///< 1 or -1: sets out towards the next point, or away from it
  double detour = widest_detour;
};

class Path_builder {
 public:
  Path_builder(const Base_surface& surface, const Path_rules& rules)
      : surface_(surface),
        mesh_(surface.mesh()),
        snap_(rules.snap),
        cross_creases_(rules.cross_creases),
        bends_(rules.cross_creases || surface.rolls()),
        within_(rules.within) {}

  /// Appends the edges crossed between two stations; false if the section misses the second. A station on an edge or a
  /// vertex is in all faces there: where the path runs along edges, rounding decides on which side of them.
  bool trace(const Draft& from, const Draft& to, const Vec& normal, std::vector<Draft>& out) const {
    const std::vector<Face> starts = faces_at(from), ends = faces_at(to);
    if (std::find_first_of(starts.begin(), starts.end(), ends.begin(), ends.end()) != starts.end()) return true;
    const std::size_t size = out.size();
    // Round an acute corner the way on may be farther back than the place that it starts from.
    constexpr std::array<Way, 3> ways{{{}, {true, 1, detour_of_corner}, {true, -1, detour_of_corner}}};
    for (const Way& way : ways)
      if (&way == &ways.front() || bends_)
        for (const Face start : starts) {
          Halfedge entered;
          if (way.leaves_edge && from.kind == Station::Kind::edge)
            entered = mesh_.face(from.edge) == start ? from.edge : mesh_.opposite(from.edge);
          if (trace_from(start, entered, ends, from.point, to.point, normal, way, out)) return true;
          out.resize(size);
        }
    return false;
  }

  /// Moves a station onto a vertex or an edge that it nearly lies on.
  Draft snapped(Draft draft) const {
    if (draft.kind == Station::Kind::edge) {
      const double s = distance_to(draft, mesh_.source(draft.edge)), t = distance_to(draft, mesh_.target(draft.edge));
      if (std::min(s, t) < snap_)
        return on_vertex(mesh_, draft, s < t ? mesh_.source(draft.edge) : mesh_.target(draft.edge));
      return draft;
    }
    if (draft.kind == Station::Kind::vertex) return draft;
    Halfedge nearest;
    Vec foot = Vec::Zero();
    double best = snap_;
    for (const Halfedge h : mesh_.halfedges_around_face(mesh_.halfedge(draft.face))) {
      if (distance_to(draft, mesh_.target(h)) < snap_) return on_vertex(mesh_, draft, mesh_.target(h));
      const Vec s = to_vec(mesh_.point(mesh_.source(h))), e = to_vec(mesh_.point(mesh_.target(h))) - s;
      const Vec p = s + std::clamp((draft.point - s).dot(e) / e.squaredNorm(), 0.0, 1.0) * e;
      if ((p - draft.point).norm() >= best) continue;
      best = (p - draft.point).norm();
      nearest = h;
      foot = p;
    }
    if (nearest == Blend_mesh::null_halfedge() || !may_cross(nearest)) return draft;
    Draft moved = on_edge(mesh_, nearest, foot);
    moved.point_index = draft.point_index;
    return snapped(moved);
  }

  [[nodiscard]] double snap() const { return snap_; }

  /// A sharp edge of a face, or an end of one, that a point lies on.
  [[nodiscard]] std::optional<Draft> on_border(Face face, const Vec& p) const {
    for (const Halfedge h : mesh_.halfedges_around_face(mesh_.halfedge(face))) {
      const Vec s = to_vec(mesh_.point(mesh_.source(h))), e = to_vec(mesh_.point(mesh_.target(h))) - s;
      const Vec foot = s + std::clamp((p - s).dot(e) / e.squaredNorm(), 0.0, 1.0) * e;
      if ((p - to_vec(mesh_.point(mesh_.target(h)))).norm() < snap_ && at_sharp_edge(mesh_.target(h)))
        return on_vertex(mesh_, {{Station::Kind::face, face, Halfedge(), Vertex(), p}, no_point}, mesh_.target(h));
      if (!may_cross(h) && (p - foot).norm() < snap_) return snapped(on_edge(mesh_, h, foot));
    }
    return std::nullopt;
  }

  /// The first sharp edge on the way from a point inside towards another.
  [[nodiscard]] std::optional<Draft> leave(Face face, const Vec& a, const Vec& b, const Vec& normal) const {
    std::vector<Draft> crossed;
    if (!trace_from(face, Halfedge(), {}, a, b, normal, {}, crossed)) return std::nullopt;
    return crossed.back();
  }

 private:
  [[nodiscard]] bool may_cross(Halfedge h) const {
    return cross_creases_ || surface_.crossable(h) || surface_.rolls_over(h);
  }

  [[nodiscard]] bool at_sharp_edge(Vertex v) const {
    const auto around = mesh_.halfedges_around_target(mesh_.halfedge(v));
    return std::any_of(around.begin(), around.end(), [&](Halfedge h) { return !may_cross(h); });
  }

  /// The smooth faces that a station belongs to, first the one that it was found in.
  [[nodiscard]] std::vector<Face> faces_at(const Draft& draft) const {
    std::vector<Face> faces;
    const auto add = [&](Face f) {
      if (!within_ || within_->count(f)) faces.push_back(f);
    };
    add(draft.face);
    if (draft.kind == Station::Kind::edge)
      for (const Halfedge h : {draft.edge, mesh_.opposite(draft.edge)})
        if (mesh_.face(h) != draft.face) add(mesh_.face(h));
    if (draft.kind == Station::Kind::vertex) {
      Halfedge corner = mesh_.halfedge(draft.face);
      while (mesh_.target(corner) != draft.vertex) corner = mesh_.next(corner);
      const Halfedge fan = surface_.fan(corner);
      for (const Halfedge h : mesh_.halfedges_around_target(corner))
        if (h != corner && (bends_ || surface_.fan(h) == fan)) add(mesh_.face(h));
    }
    return faces;
  }

  /// \param entered an edge that the section does not leave the first face by; may be null
  bool trace_from(Face face, Halfedge entered, const std::vector<Face>& ends, const Vec& a, const Vec& b,
                  const Vec& normal, const Way& way, std::vector<Draft>& out) const {
    const Vec plane = (b - a).cross(normal).stableNormalized();
    const auto height = [&](Vertex v) {  // zero counts as above: consistent at each vertex
      const double h = (to_vec(mesh_.point(v)) - a).dot(plane);
      return std::abs(h) < flat_of_snap * snap_ ? 0 : h;
    };
    const auto crossing = [&](Halfedge h, double hs, double ht) -> Vec {
      const double t = hs / (hs - ht);
      return (1 - t) * to_vec(mesh_.point(mesh_.source(h))) + t * to_vec(mesh_.point(mesh_.target(h)));
    };
    const double distance = (b - a).squaredNorm();
    for (int step = 0; step < longest_section; ++step) {
      Halfedge exit;
      Vec at = a;
      double progress = -distance;
      for (const Halfedge h : mesh_.halfedges_around_face(mesh_.halfedge(face))) {
        if (h == entered) continue;
        const double hs = height(mesh_.source(h)), ht = height(mesh_.target(h));
        if ((hs >= 0) == (ht >= 0)) continue;
        const Vec x = crossing(h, hs, ht);
        const double ahead = (x - a).dot(b - a);
        const double sign = step == 0 ? way.ahead : 1;
        if (exit != Blend_mesh::null_halfedge() && sign * ahead <= sign * progress) continue;
        exit = h;
        at = x;
        progress = ahead;
      }
      if (exit == Blend_mesh::null_halfedge()) return false;
      if (!may_cross(exit)) {
        if (ends.empty()) out.push_back(on_edge(mesh_, exit, at));
        return ends.empty();
      }
      if (within_ && !within_->count(mesh_.face(mesh_.opposite(exit)))) return false;
      if (progress > (1 + way.detour) * distance || progress < -way.detour * distance) return false;
      out.push_back(on_edge(mesh_, exit, at));
      entered = mesh_.opposite(exit);
      face = mesh_.face(entered);
      if (std::find(ends.begin(), ends.end(), face) != ends.end()) return true;
    }
    return false;
  }

  [[nodiscard]] double distance_to(const Draft& draft, Vertex v) const {
    return (draft.point - to_vec(mesh_.point(v))).norm();
  }

  const Base_surface& surface_;
  const Blend_mesh& mesh_;
  double snap_;
  bool cross_creases_;
  bool bends_;  // over sharp edges
  const std::unordered_set<Face>* within_;
};

/// Merges neighbours that fell together and takes out spikes a-b-a; the given points move along.
void tidy(std::vector<Draft>& path, std::vector<std::size_t>& owner, double snap, bool closed = true) {
  // owner[k]: index into path of the station that stands for given point k.
  for (bool changed = true; changed && path.size() > (closed ? 3 : 2);) {
    changed = false;
    const std::size_t n = path.size();
    std::vector<std::size_t> into(n);
    for (std::size_t i = 0; i < n; ++i) into[i] = i;
    std::vector<bool> gone(n, false);
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t before = (i + n - 1) % n, after = (i + 1) % n;
      if (gone[i] || gone[before] || (!closed && i == 0)) continue;
      const bool repeated = same_place(path[before], path[i], snap);
      const bool spike = (closed || i + 1 < n) && !gone[after] && after != before &&
                         path[before].kind != Station::Kind::face && same_place(path[before], path[after], snap);
      if (!repeated && !spike) continue;
      if (repeated && path[i].point_index != no_point && path[before].point_index == no_point &&
          path[i].kind != Station::Kind::vertex)
        path[before].point = path[i].point;  // keep the exact contact rather than a crossing
      if (path[before].point_index == no_point) path[before].point_index = path[i].point_index;
      gone[i] = changed = true;
      into[i] = before;
    }
    if (!changed) break;
    std::vector<std::size_t> renumbered(n);
    std::vector<Draft> kept;
    for (std::size_t i = 0; i < n; ++i)
      if (!gone[i]) {
        renumbered[i] = kept.size();
        kept.push_back(path[i]);
      }
    for (std::size_t& o : owner) o = renumbered[into[o]];
    path = std::move(kept);
  }
}

}  // namespace

std::optional<Surface_path> closed_path(const Base_surface& surface, const std::vector<Surface_point>& points,
                                        double snap, std::size_t& stuck, bool cross_creases) {
  const Path_builder builder(surface, {snap, cross_creases});
  std::vector<Draft> given, drafts;
  for (std::size_t i = 0; i < points.size(); ++i) given.push_back(builder.snapped(draft_at(surface, points[i], i)));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t next = (i + 1) % points.size();
    drafts.push_back(given[i]);
    // Along a sharp edge all faces may lie on the side of the plane where its own points count: then the other way round.
    const Vec normal = surface.normal(points[i]) + surface.normal(points[next]);
    if (!builder.trace(given[i], given[next], normal, drafts) &&
        !(cross_creases && builder.trace(given[i], given[next], -normal, drafts))) {
      stuck = next;
      return std::nullopt;
    }
  }
  std::vector<std::size_t> owner(points.size());
  for (std::size_t i = 0; i < drafts.size(); ++i) {
    if (drafts[i].point_index != no_point) owner[drafts[i].point_index] = i;
    drafts[i] = builder.snapped(drafts[i]);
  }
  tidy(drafts, owner, snap);
  Surface_path path;
  for (const Draft& draft : drafts) path.stations.push_back(draft);
  path.station_of = std::move(owner);
  return path;
}

std::optional<Surface_path> open_path(const Base_surface& surface, const std::vector<Station>& points,
                                      const Path_rules& rules, std::size_t& stuck) {
  const Path_builder builder(surface, rules);
  std::vector<Draft> given, drafts;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Draft draft{points[i], i};
    const bool is_end = i == 0 || i + 1 == points.size();
    given.push_back(is_end ? draft : builder.snapped(draft));
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    drafts.push_back(given[i]);
    if (i + 1 == points.size()) break;
    const Vec normal = surface.frame(given[i].face).face_normal + surface.frame(given[i + 1].face).face_normal;
    const bool ruled = !rules.ruling.isZero() && builder.trace(given[i], given[i + 1], rules.ruling, drafts);
    if (!ruled && !builder.trace(given[i], given[i + 1], normal, drafts)) {
      stuck = i + 1;
      return std::nullopt;
    }
  }
  const auto is_shared = [&](const Vec& p) {
    return (p - points.front().point).norm() < rules.shared_ends[0] ||
           (p - points.back().point).norm() < rules.shared_ends[1];
  };
  std::vector<std::size_t> owner(points.size());
  for (std::size_t i = 0; i < drafts.size(); ++i) {
    if (drafts[i].point_index != no_point) owner[drafts[i].point_index] = i;
    if (i > 0 && i + 1 < drafts.size() && !is_shared(drafts[i].point)) drafts[i] = builder.snapped(drafts[i]);
  }
  const Draft last = drafts.back();
  tidy(drafts, owner, rules.snap, false);
  static_cast<Station&>(drafts.back()) = last;  // merged or not, ends stay where they are
  Surface_path path;
  path.closed = false;
  for (const Draft& draft : drafts) path.stations.push_back(draft);
  path.station_of = std::move(owner);
  return path;
}

std::optional<Station> leaving_station(const Base_surface& surface, const Surface_point& inside, const Vec& outside,
                                       double snap) {
  if (const Halfedge edge = surface.band_edge(inside.face); edge != Blend_mesh::null_halfedge()) {  // over its end
    const Blend_mesh& mesh = surface.mesh();
    const Vertex s = mesh.source(edge), t = mesh.target(edge);
    const bool forward = (outside - to_vec(mesh.point(t))).norm() < (outside - to_vec(mesh.point(s))).norm();
    return station_at(surface, mesh.face(edge), forward ? t : s);
  }
  const Path_builder builder(surface, {snap});
  if (const auto there = builder.on_border(inside.face, surface.position(inside))) return *there;
  const auto draft = builder.leave(inside.face, surface.position(inside), outside, surface.normal(inside));
  if (!draft) return std::nullopt;
  return builder.snapped(*draft);
}

std::optional<Station> border_station_at(const Base_surface& surface, const Surface_point& at, double snap) {
  if (surface.band_edge(at.face) != Blend_mesh::null_halfedge()) return station_at(surface, at, snap);
  const auto draft = Path_builder(surface, {snap}).on_border(at.face, surface.position(at));
  return draft ? std::optional<Station>(*draft) : std::nullopt;
}

Station station_at(const Base_surface& surface, const Surface_point& at, double snap) {
  return Path_builder(surface, {snap}).snapped(draft_at(surface, at));
}

Station station_at(const Base_surface& surface, Face face, Vertex vertex) {
  return {Station::Kind::vertex, face, Halfedge(), vertex, to_vec(surface.mesh().point(vertex))};
}

}  // namespace cgal_blend
