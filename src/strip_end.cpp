// SPDX-License-Identifier: GPL-3.0-or-later
#include "strip_end.h"

#include "refusal.h"

#include <Eigen/Geometry>

#include <CGAL/intersections.h>

#include <cgal_blend/creases.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_set>

namespace cgal_blend {

namespace {

constexpr double reach_in_radii = 4;       // around an end, besides what the wedge's contacts take
constexpr double widest_wedge = 10;        // contacts farther from the edge, in radii, are not looked for
constexpr double least_depth = 0.05;       // of a flat end's rows below the faces, in steps of rows on the chord
constexpr double straight_on = pi - 1e-6;  // face angles at a vertex above it: the rim does not leave the face

/// The sharp edges around the vertex that a halfedge points to, from its left side round to its right one, as halfedges
/// that point to the vertex; and the angle that the base faces take up on both sides.
struct Fan {
  std::vector<Halfedge> creases;
  std::array<double, 2> angle{};  // left, right
};

double corner_angle(const Blend_mesh& mesh, Halfedge h) {
  const Vec v = to_vec(mesh.point(mesh.target(h)));
  return angle_between(to_vec(mesh.point(mesh.source(h))) - v, to_vec(mesh.point(mesh.target(mesh.next(h)))) - v);
}

Fan fan_at(const Base_surface& surface, Halfedge into) {
  const Blend_mesh& mesh = surface.mesh();
  Fan fan;
  Halfedge h = into;
  double angle = 0;
  do {
    angle += corner_angle(mesh, h);
    const Halfedge next = mesh.opposite(mesh.next(h));
    if (next != into && !surface.crossable(next)) {
      if (fan.creases.empty()) fan.angle[0] = angle;
      fan.creases.push_back(next);
      angle = 0;
    }
    h = next;
  } while (h != into);
  fan.angle[1] = angle;
  return fan;
}

/// Distance from the edge to the contacts, over the radius, by the planes of its faces.
double contact_distance(const Base_surface& surface, Halfedge h) {
  const Blend_mesh& mesh = surface.mesh();
  const double c = surface.frame(mesh.face(h)).face_normal.dot(surface.frame(mesh.face(mesh.opposite(h))).face_normal);
  return std::min(widest_wedge, std::sqrt(std::max(0.0, 1 - c) / std::max(1e-12, 1 + c)));
}

/// Faces beyond an end: what hangs together with the faces between the borders of the two base faces, near the vertex.
std::vector<Face> faces_beyond(const Base_surface& surface, const Branch_end& end) {
  const Blend_mesh& mesh = surface.mesh();
  const Vec center = to_vec(mesh.point(end.vertex(mesh)));
  std::unordered_set<Edge> barrier;
  std::vector<Face> faces;
  std::unordered_set<Face> seen;
  const auto add = [&](Face f) {
    if (seen.insert(f).second) faces.push_back(f);
  };
  for (const auto& chain : end.border)
    for (const Halfedge h : chain) barrier.insert(mesh.edge(h));
  for (const auto& chain : end.border)
    for (const Halfedge h : chain) add(mesh.face(mesh.opposite(h)));
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(faces[i]))) {
      if (barrier.count(mesh.edge(h))) continue;
      const Vec a = to_vec(mesh.point(mesh.source(h))), b = to_vec(mesh.point(mesh.target(h)));
      if (off_segment(a, b, center) < end.reach) add(mesh.face(mesh.opposite(h)));
    }
  return faces;
}

/// Where rows cross the faces beyond an end.
class Row_cutter {
 public:
  Row_cutter(const Base_surface& surface, const Branch_end& end)
      : surface_(surface), faces_(faces_beyond(surface, end)) {
    for (const Face f : faces_) {
      const Base_surface::Frame& frame = surface.frame(f);
      triangles_.push_back({to_point(frame.corner[0]), to_point(frame.corner[1]), to_point(frame.corner[2])});
      boxes_.push_back(triangles_.back().bbox());
    }
  }

  [[nodiscard]] const std::vector<Face>& faces() const { return faces_; }

  /// The first crossing of a step.
  [[nodiscard]] std::optional<std::pair<Vec, Station>> cross(const Vec& a, const Vec& b) const {
    const Kernel::Segment_3 step(to_point(a), to_point(b));
    const CGAL::Bbox_3 box = step.bbox();
    std::optional<std::pair<Vec, Station>> first;
    double nearest = 2;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      if (!CGAL::do_overlap(box, boxes_[i]) || !CGAL::do_intersect(triangles_[i], step)) continue;
      const Base_surface::Frame& frame = surface_.frame(faces_[i]);
      const double from = frame.face_normal.dot(frame.corner[0] - a), rise = frame.face_normal.dot(b - a);
      const double t = rise == 0 ? 0 : std::clamp(from / rise, 0.0, 1.0);
      if (t >= nearest) continue;
      nearest = t;
      const Vec p = a + t * (b - a);
      const Surface_point at = surface_.locate(faces_[i], p);
      first = {surface_.position(at), station_at(surface_, at, 0)};
    }
    return first;
  }

 private:
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const Base_surface& surface_;
  std::vector<Face> faces_;
  std::vector<Kernel::Triangle_3> triangles_;
  std::vector<CGAL::Bbox_3> boxes_;
};

/// The faces beyond an end, continued tangentially over the borders of the base faces.
class Extension {
 public:
  Extension(const Base_surface& surface, const Branch_end& end) {
    const Blend_mesh& mesh = surface.mesh();
    for (const int side : {0, 1}) {
      if (end.inside[side] && end.border[side].size() > 1) {  // only the face at the vertex is of interest
        add(surface, mesh.opposite(end.border[side].front()));
        continue;
      }
      const bool outgoing = side == end.left();
      Halfedge before;
      for (const Halfedge h : end.border[side]) {
        const Halfedge o = mesh.opposite(h);
        if (before != Blend_mesh::null_halfedge()) {  // as far as the faces beyond are one surface
          const Halfedge a = outgoing ? mesh.prev(before) : before, b = outgoing ? o : mesh.prev(o);
          if (surface.fan(a) != surface.fan(b)) break;
        }
        add(surface, o);
        before = o;
      }
    }
  }

  /// Height of a point above the nearest of the planes, positive beyond them.
  [[nodiscard]] double height(const Vec& p) const {
    double nearest = -1, result = 0;
    for (const Piece& piece : pieces_) {
      const double distance = off_segment(piece.a, piece.b, p);
      if (nearest >= 0 && distance >= nearest) continue;
      nearest = distance;
      result = (p - piece.a).dot(piece.normal);
    }
    return result;
  }

  /// Sign of the height where the branch comes from.
  [[nodiscard]] double sign_before(const Vec& from) const { return height(from) < 0 ? -1 : 1; }

 private:
  struct Piece {
    Vec a, b, normal;
  };
  void add(const Base_surface& surface, Halfedge h) {
    const Blend_mesh& mesh = surface.mesh();
    pieces_.push_back({to_vec(mesh.point(mesh.source(h))), to_vec(mesh.point(mesh.target(h))),
                       surface.frame(mesh.face(h)).face_normal});
  }
  std::vector<Piece> pieces_;
};

class Strip_ender {
 public:
  Strip_ender(const Base_surface& surface, const Branch_end& end, const std::vector<Ball_position>& positions,
              const Virtual_surface& blend, const std::vector<double>& rows, std::size_t middle, double clear,
              double snap)
      : surface_(surface),
        end_(end),
        positions_(positions),
        blend_(blend),
        rows_(rows),
        middle_(middle),
        clear_(clear),
        snap_(snap) {}

  Strip_end_result run() {
    result_.end.hit.resize(rows_.size());
    result_.end.last.resize(rows_.size());
    const bool found = end_.kind == Branch_end::Kind::faces  ? (end_.fill ? find_in_extension() : find_on_faces())
                       : end_.kind == Branch_end::Kind::fade ? close_at_vertex()
                                                             : end_at_last();
    if (found) {
      result_.end.hit.front() = result_.end.rim[0].point;
      result_.end.hit.back() = result_.end.rim[1].point;
      drop_near();
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] std::size_t size() const { return positions_.size(); }
  /// Positions counted from the end inward.
  [[nodiscard]] std::size_t from_end(std::size_t i) const { return end_.end == 1 ? size() - 1 - i : i; }
  [[nodiscard]] Vec row_point(std::size_t row, std::size_t i) const { return blend_.on_profile(i, rows_[row]); }

  bool refuse(Status status, const Vec& at) {
    result_.diagnosis = refusal(status, at);
    return false;
  }

  bool end_at_last() {
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      result_.end.last[k] = from_end(1);
      result_.end.hit[k] = row_point(k, from_end(0));
    }
    const double snap = end_.snap(snap_);
    for (const int side : {0, 1}) {
      const Ball_position& last = positions_[from_end(0)];
      if (surface_.is_extension(last.foot[side].face)) return refuse(Status::radius_exceeds_face, last.contact[side]);
      std::optional<Station> border;  // a flat end may lie in the plane of a face beyond
      if (!end_.border[side].empty()) border = border_station_at(surface_, last.foot[side], snap);
      result_.end.rim[side] = border ? *border : station_at(surface_, last.foot[side], snap);
    }
    if (end_.kind == Branch_end::Kind::cap)
      for (const int side : {0, 1}) keep_below(side);
    return true;
  }

  /// The arc is tangent to interpolated normals. Where it begins outside of the face itself, a flat end would cross the
  /// face: its points are moved towards the chord between the contacts, by no more than they are above the face.
  void keep_below(int side) {
    const Ball_position& last = positions_[from_end(0)];
    const Vec& normal = surface_.frame(last.foot[side].face).face_normal;
    const double least = least_depth / static_cast<double>(rows_.size());
    for (std::size_t k = 1; k + 1 < rows_.size(); ++k) {
      Vec& p = result_.end.hit[k];
      const double part = static_cast<double>(k) / static_cast<double>(rows_.size() - 1);
      const Vec on_chord = (1 - part) * last.contact[0] + part * last.contact[1];
      const double depth = normal.dot(p - last.contact[side]), whole = normal.dot(on_chord - last.contact[side]);
      const double share = depth / whole;
      if (whole != 0 && share < least) p += (least - share) / (1 - share) * (on_chord - p);
    }
  }

  bool close_at_vertex() {
    const Blend_mesh& mesh = surface_.mesh();
    const Vertex v = end_.vertex(mesh);
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      result_.end.last[k] = from_end(0);
      result_.end.hit[k] = to_vec(mesh.point(v));
    }
    const Halfedge into = end_.into;
    const int left = end_.left();
    result_.end.rim[left] = station_at(surface_, mesh.face(into), v);
    result_.end.rim[1 - left] = station_at(surface_, mesh.face(mesh.opposite(into)), v);
    return true;
  }

  /// Where a rim leaves its base face.
  bool leave_base(int side) {
    for (std::size_t n = from_middle(); n-- > 0;) {
      const std::size_t i = from_end(n);
      const std::size_t before = end_.end == 1 ? i - 1 : i + 1;
      if (!surface_.is_extension(positions_[i].foot[side].face)) continue;
      if (surface_.is_extension(positions_[before].foot[side].face)) break;
      const auto station = leaving_station(surface_, positions_[before].foot[side], positions_[i].contact[side], snap_);
      if (!station) break;
      result_.end.rim[side] = *station;
      set_end(side == 0 ? 0 : rows_.size() - 1, before, station->point);
      return true;
    }
    return refuse(Status::radius_exceeds_face, positions_[from_end(0)].contact[side]);
  }

  /// Number of positions from the end to the middle, that excluded.
  [[nodiscard]] std::size_t from_middle() const { return end_.end == 1 ? size() - 1 - middle_ : middle_; }

  void set_end(std::size_t row, std::size_t last, const Vec& hit) {
    result_.end.last[row] = last;
    result_.end.hit[row] = hit;
  }

  bool find_on_faces() {
    for (const int side : {0, 1})
      if (!leave_base(side)) return false;
    const Row_cutter cutter(surface_, end_);
    std::vector<Station> stations{beyond(0)};
    for (std::size_t k = 1; k + 1 < rows_.size(); ++k) {
      std::optional<std::pair<Vec, Station>> hit;
      for (std::size_t n = from_middle(); n-- > 0 && !hit;) {
        const std::size_t i = from_end(n), before = end_.end == 1 ? i - 1 : i + 1;
        hit = cutter.cross(row_point(k, before), row_point(k, i));
        if (hit) set_end(k, before, hit->first);
      }
      if (!hit) return refuse(Status::radius_exceeds_face, row_point(k, from_end(0)));
      stations.push_back(hit->second);
    }
    stations.push_back(beyond(1));
    std::size_t stuck = 0;
    const std::unordered_set<Face> beyond_faces(cutter.faces().begin(), cutter.faces().end());
    const std::size_t last = result_.end.last[rows_.size() / 2];
    const Vec ruling = positions_[end_.end == 1 ? last + 1 : last - 1].center - positions_[last].center;
    result_.end.path = open_path(surface_, stations, {snap_ / 16, true, ruling, &beyond_faces}, stuck);
    if (!result_.end.path) return refuse(Status::no_rolling_ball, stations[stuck].point);
    for (std::size_t k = 0; k < rows_.size(); ++k)
      result_.end.hit[k] = result_.end.path->stations[result_.end.path->station_of[k]].point;
    return true;
  }

  /// The end of a rim as a station of the faces beyond.
  [[nodiscard]] Station beyond(int side) const {
    const Blend_mesh& mesh = surface_.mesh();
    Station s = result_.end.rim[side];
    for (const Halfedge h : end_.border[side]) {
      const bool there = s.kind == Station::Kind::edge ? mesh.edge(h) == mesh.edge(s.edge)
                                                       : mesh.target(h) == s.vertex || mesh.source(h) == s.vertex;
      if (there) s.face = mesh.face(mesh.opposite(h));
    }
    return s;
  }

  bool find_in_extension() {
    const Extension extension(surface_, end_);
    for (const int side : {0, 1})
      if (!end_.inside[side] && !leave_base(side)) return false;
    const double before_sign = extension.sign_before(positions_[middle_].center);
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      const bool rim = k == 0 || k + 1 == rows_.size();
      const int side = k == 0 ? 0 : 1;
      if (rim && !end_.inside[side]) continue;
      bool found = false;
      for (std::size_t n = from_middle(); n-- > 0 && !found;) {
        const std::size_t i = from_end(n), before = end_.end == 1 ? i - 1 : i + 1;
        const Vec a = row_point(k, before), b = row_point(k, i);
        const double ha = before_sign * extension.height(a), hb = before_sign * extension.height(b);
        if (hb > 0) continue;
        found = true;
        const double t = ha <= 0 ? 0 : ha / (ha - hb);
        set_end(k, before, a + t * (b - a));
        if (rim) {
          const Surface_point& foot = positions_[before].foot[side];
          if (surface_.is_extension(foot.face)) return refuse(Status::radius_exceeds_face, a);
          const Base_surface::Walk walk = surface_.walk(foot, t * (b - a));
          if (walk.blocked != Blend_mesh::null_halfedge() || surface_.is_extension(walk.end.face))
            return refuse(Status::radius_exceeds_face, a);
          result_.end.rim[side] = station_at(surface_, walk.end, snap_);
        }
      }
      if (!found) return refuse(Status::radius_exceeds_face, row_point(k, from_end(0)));
    }
    return true;
  }

  /// Positions so near to the end that they would make slivers go.
  void drop_near() {
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      std::size_t& last = result_.end.last[k];
      while (last != from_end(size() - 1) && (row_point(k, last) - result_.end.hit[k]).norm() < clear_)
        last = end_.end == 1 ? last - 1 : last + 1;
    }
  }

  const Base_surface& surface_;
  const Branch_end& end_;
  const std::vector<Ball_position>& positions_;
  const Virtual_surface& blend_;
  const std::vector<double>& rows_;
  std::size_t middle_;
  double clear_, snap_;
  Strip_end_result result_;
};

}  // namespace

Branch_end view_end(const Base_surface& surface, Halfedge into, int end, bool convex, double radius) {
  const Blend_mesh& mesh = surface.mesh();
  Branch_end e;
  e.end = end;
  e.into = into;
  const Vec at = to_vec(mesh.point(mesh.target(into)));
  e.direction = (at - to_vec(mesh.point(mesh.source(into)))).normalized();
  const double contact = contact_distance(surface, into);
  e.reach = (reach_in_radii + 2 * contact) * radius;
  const Fan fan = fan_at(surface, into);
  const int left = e.left();
  if (fan.creases.empty()) {
    e.kind = Branch_end::Kind::fade;
    return e;
  }
  if (fan.creases.size() == 1) {
    e.kind = Branch_end::Kind::cap;
    e.inside = {true, true};
    return e;
  }
  e.kind = Branch_end::Kind::faces;
  // creases point to the vertex; the one next to the left face has that face on its right.
  e.border[left] = surface.border_chain(mesh.opposite(fan.creases.front()), true, at, e.reach);
  e.border[1 - left] = surface.border_chain(fan.creases.back(), false, at, e.reach);
  e.inside[left] = fan.angle[0] > straight_on;
  e.inside[1 - left] = fan.angle[1] > straight_on;
  bool all_same = true;
  for (const Halfedge h : fan.creases) all_same = all_same && is_convex_edge(mesh.edge(h), mesh) == convex;
  e.fill = !all_same;
  // Where it is not known how the faces beyond would go on, they stay as they are.
  if (e.fill ? fan.creases.size() > 2 : e.inside[0] || e.inside[1]) {
    e.kind = Branch_end::Kind::cap;
    e.fill = false;
    e.inside = {true, true};
  }
  return e;
}

Strip_end_result end_strip(const Base_surface& surface, const Branch_end& branch_end,
                           const std::vector<Ball_position>& positions, const Virtual_surface& blend,
                           const std::vector<double>& rows, std::size_t middle, double clear, double snap) {
  return Strip_ender(surface, branch_end, positions, blend, rows, middle, clear, snap).run();
}

std::vector<Vertex> border_to_rim(const Blend_mesh& mesh, const Branch_end& end, int side, const Station& rim) {
  const bool outgoing = side == end.left();
  std::vector<Vertex> chain{end.vertex(mesh)};
  for (const Halfedge h : end.border[side]) {
    if (rim.kind == Station::Kind::edge && mesh.edge(rim.edge) == mesh.edge(h)) return chain;
    const Vertex next = outgoing ? mesh.target(h) : mesh.source(h);
    if (rim.kind == Station::Kind::vertex && rim.vertex == next) return chain;
    chain.push_back(next);
  }
  return {};
}

}  // namespace cgal_blend
