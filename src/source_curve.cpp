// SPDX-License-Identifier: GPL-3.0-or-later
#include "source_curve.h"

#include "select_region.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <utility>

namespace cgal_blend {

namespace {

using Point_2 = Kernel::Point_2;

constexpr double least_weight = 1e-13;  // as for points: below it a place is on an edge or at a vertex
constexpr double snap = 1e-9;           // of an edge: a curve that passes a vertex by less runs through it

/// What a point lies on: three vertices of a face, two of an edge, or one, with weights.
using Support = std::vector<std::pair<Vertex, double>>;

Support support_of(const Blend_mesh& mesh, const Face_point& at) {
  Support support;
  Halfedge h = mesh.halfedge(at.face);
  for (const double weight : at.weights) {
    if (weight >= least_weight) support.emplace_back(mesh.target(h), weight);
    h = mesh.next(h);
  }
  return support;
}

/// A support with respect to a face; nothing if the face does not contain it.
std::optional<Face_point> in_face(const Blend_mesh& mesh, const Support& support, Face face) {
  Face_point at{face, {0, 0, 0}};
  std::size_t found = 0;
  Halfedge h = mesh.halfedge(face);
  for (double& weight : at.weights) {
    for (const auto& [v, share] : support)
      if (v == mesh.target(h)) {
        weight = share;
        ++found;
      }
    h = mesh.next(h);
  }
  if (found != support.size()) return std::nullopt;
  return at;
}

/// The faces that a point lies in.
std::vector<Face> faces_at(const Blend_mesh& mesh, const Face_point& at) {
  const Support support = support_of(mesh, at);
  std::vector<Face> faces;
  for (const Face f : mesh.faces_around_target(mesh.halfedge(support.front().first)))
    if (f != Blend_mesh::null_face() && in_face(mesh, support, f)) faces.push_back(f);
  return faces;
}

/// Where the straight way from p to q, unfolded over the edge of a halfedge of the face of p, crosses it: share from its
/// source on, and the length of the way.
std::pair<double, double> crossing(const Blend_mesh& mesh, Halfedge h, const Vec& p, const Vec& q) {
  const Vec s = to_vec(mesh.point(mesh.source(h))), e = to_vec(mesh.point(mesh.target(h))) - s;
  const double length = e.norm();
  const auto along = [&](const Vec& x) { return (x - s).dot(e) / length; };
  const auto across = [&](const Vec& x) { return (x - s).cross(e).norm() / length; };
  const double before = across(p), after = across(q);
  const double x = along(p) + (along(q) - along(p)) * (before + after > 0 ? before / (before + after) : 0.5);
  const double share = std::clamp(x / length, 0.0, 1.0);
  const Vec at = s + share * e;
  return {share, (at - p).norm() + (q - at).norm()};
}

/// Places where a step changes from face to face, each with the face that it goes on through, and the length of it.
struct Detour {
  double length = 0;
  Face start;
  std::vector<Curve_point> changes;
};

using Best = std::optional<Detour>;

void offer(Best& best, Detour detour) {
  if (!best || detour.length < best->length) best = std::move(detour);
}

Support on_edge(const Blend_mesh& mesh, Halfedge h, double share) {
  Support support;
  if (1 - share >= least_weight) support.emplace_back(mesh.source(h), 1 - share);
  if (share >= least_weight) support.emplace_back(mesh.target(h), share);
  return support;
}

/// The way over an edge that the faces of both ends share.
void cross_edge(const Blend_mesh& mesh, Face from, Face to, const Vec& p, const Vec& q, Best& best) {
  for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(from))) {
    if (mesh.face(mesh.opposite(h)) != to) continue;
    const auto [share, length] = crossing(mesh, h, p, q);
    offer(best, {length, from, {{*in_face(mesh, on_edge(mesh, h, share), to), to}}});
  }
}

/// The way through the faces around a vertex that both faces have, counter-clockwise or clockwise, unfolded; through the
/// vertex if that is no longer.
void pass_vertex(const Blend_mesh& mesh, Halfedge at, Face to, const Vec& p, const Vec& q, bool counter_clockwise,
                 Best& best) {
  const Vec origin = to_vec(mesh.point(mesh.target(at)));
  const auto edge_beyond = [&](Halfedge h) {
    return counter_clockwise ? h : mesh.next(h);
  };  // of the face of h, at its target
  const auto far_end = [&](Halfedge h) {
    return to_vec(mesh.point(counter_clockwise ? mesh.source(h) : mesh.target(mesh.next(h))));
  };
  std::vector<std::pair<Halfedge, double>> spokes;
  Vec last = p - origin;
  double angle = 0;
  Halfedge h = at;  // into the vertex, of the face that the way is in
  while (mesh.face(h) != to) {
    const Vec spoke = far_end(h) - origin;
    angle += angle_between(last, spoke);
    spokes.emplace_back(edge_beyond(h), angle);
    last = spoke;
    h = counter_clockwise ? mesh.prev(mesh.opposite(h)) : mesh.opposite(mesh.next(h));
    if (mesh.is_border(h)) return;
  }
  angle += angle_between(last, q - origin);
  const double rp = (p - origin).norm(), rq = (q - origin).norm();
  if (angle >= pi) return;
  Detour detour{std::sqrt(rp * rp + rq * rq - 2 * rp * rq * std::cos(angle)), mesh.face(at), {}};
  for (const auto& [edge, turned] : spokes) {
    const double radius = rp * rq * std::sin(angle) / (rp * std::sin(turned) + rq * std::sin(angle - turned));
    const Vec e = to_vec(mesh.point(mesh.target(edge))) - to_vec(mesh.point(mesh.source(edge)));
    const double part = std::min(1.0, radius / e.norm());
    const Face next = mesh.face(mesh.opposite(edge));
    const Support support = on_edge(mesh, edge, counter_clockwise ? 1 - part : part);
    detour.changes.push_back({*in_face(mesh, support, next), next});
  }
  offer(best, std::move(detour));
}

/// The shortest way from one point to another in a neighbouring face, over an edge or past a vertex of both.
Best detour_between(const Blend_mesh& mesh, const Face_point& a, const Face_point& b) {
  const Vec p = to_vec(position(mesh, a)), q = to_vec(position(mesh, b));
  const std::vector<Face> from = faces_at(mesh, a), to = faces_at(mesh, b);
  Best best;
  for (const Face f : from)
    for (const Face g : to) cross_edge(mesh, f, g, p, q, best);
  if (best) return best;
  for (const Face f : from)
    for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f)))
      for (const Face g : to) {
        const Support vertex{{mesh.target(h), 1}};
        const auto in_both = in_face(mesh, vertex, g);
        if (!in_both) continue;
        for (const bool counter_clockwise : {false, true}) pass_vertex(mesh, h, g, p, q, counter_clockwise, best);
        const Vec at = to_vec(mesh.point(mesh.target(h)));
        offer(best, {(at - p).norm() + (q - at).norm(), f, {{*in_both, g}}});
      }
  return best;
}

/// Inserts a curve step by step.
class Cut {
 public:
  explicit Cut(Region_mesh& region) : region_(region) {}

  /// Appends the vertices between two, and the second, along the segment between them within a face.
  bool connect(std::int32_t from, std::int32_t to, const Face_point& target) {
    constexpr int most_steps = 100000;
    const Point_2 q(target.weights[1], target.weights[2]);
    for (int step = 0; from != to; ++step) {
      if (step == most_steps) return false;
      const std::int32_t next = advance(from, to, q, target.face);
      if (next < 0) return false;
      vertices_.push_back(next);
      from = next;
    }
    return true;
  }

  [[nodiscard]] const std::vector<std::int32_t>& vertices() const { return vertices_; }

 private:
  /// A corner in the plane of a face: two of its weights.
  [[nodiscard]] Point_2 place(std::int32_t triangle, int slot) const {
    Region_mesh::Place at{triangle, {0, 0, 0}};
    at.weights[slot] = 1;
    const Face_point p = region_.in_face(at);
    return {p.weights[1], p.weights[2]};
  }

  /// The next vertex on the way; an edge that is crossed is divided.
  std::int32_t advance(std::int32_t from, std::int32_t to, const Point_2& q, Face face) {
    std::vector<std::int32_t> star;
    for (const std::int32_t t : region_.star(from))
      if (region_.face(t) == face) star.push_back(t);
    for (const std::int32_t t : star)
      for (const std::int32_t v : region_.triangles()[t].corner)
        if (v == to) return to;
    for (const std::int32_t t : star) {
      const auto corner = region_.triangles()[t].corner;
      const int slot = Region_mesh::slot_of(region_.triangles()[t], from), i = (slot + 1) % 3, j = (slot + 2) % 3;
      const Point_2 p = place(t, slot), a = place(t, i), b = place(t, j);
      const bool past_a = CGAL::orientation(p, a, q) != CGAL::RIGHT_TURN,
                 before_b = CGAL::orientation(p, q, b) != CGAL::RIGHT_TURN;
      if (!past_a || !before_b || CGAL::orientation(a, b, q) == CGAL::LEFT_TURN) continue;
      const double to_a = std::abs(CGAL::area(p, q, a)), to_b = std::abs(CGAL::area(p, q, b));
      const double share = to_a / (to_a + to_b);
      if (share < snap) return corner[i];
      if (share > 1 - snap) return corner[j];
      const Vec at = (1 - share) * region_.points()[corner[i]] + share * region_.points()[corner[j]];
      return region_.divide(t, slot, share, at);
    }
    return -1;
  }

  Region_mesh& region_;
  std::vector<std::int32_t> vertices_;
};

/// Divides the edges from one vertex of the curve to another, so that no triangle has all its corners on the curve.
void divide_shortcuts(Region_mesh& region, const std::vector<std::int32_t>& chain) {
  const std::unordered_set<std::int32_t> on_curve(chain.begin(), chain.end());
  for (const std::int32_t v : chain)
    for (bool found = true; found;) {
      found = false;
      for (const std::int32_t t : region.star(v)) {
        const int slot = Region_mesh::slot_of(region.triangles()[t], v), last = (slot + 2) % 3;
        const std::int32_t w = region.triangles()[t].corner[(slot + 1) % 3];
        if (region.triangles()[t].beyond[last] < 0 || !on_curve.count(w)) continue;
        region.divide(t, last, 0.5, 0.5 * (region.points()[v] + region.points()[w]));
        found = true;
        break;
      }
    }
}

}  // namespace

std::optional<std::vector<Curve_point>> complete_curve(const Blend_mesh& mesh, const std::vector<Face_point>& points) {
  std::vector<Curve_point> curve;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Face_point &a = points[i], &b = points[(i + 1) % points.size()];
    const std::vector<Face> from = faces_at(mesh, a), to = faces_at(mesh, b);
    const auto common = std::find_first_of(from.begin(), from.end(), to.begin(), to.end());
    if (common != from.end()) {
      curve.push_back({a, *common});
      continue;
    }
    const Best detour = detour_between(mesh, a, b);
    if (!detour) return std::nullopt;
    curve.push_back({a, detour->start});
    curve.insert(curve.end(), detour->changes.begin(), detour->changes.end());
  }
  return curve;
}

Diagnosis cut_along(Region_mesh& region, const std::vector<Curve_point>& curve, std::int32_t& first) {
  Diagnosis diagnosis;
  const Blend_mesh& mesh = region.mesh();
  Cut cut(region);
  first = insert_place(region, curve.front().at);
  std::int32_t from = first;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const std::size_t next = (i + 1) % curve.size();
    const std::int32_t to = next == 0 ? first : insert_place(region, curve[next].at);
    const auto target = in_face(mesh, support_of(mesh, curve[next].at), curve[i].step);
    CGAL_assertion(target.has_value());
    if (!cut.connect(from, to, *target)) {
      diagnosis.status = Status::curve_crosses_itself;
      diagnosis.point = to_point(region.points()[from]);
      return diagnosis;
    }
    from = to;
  }
  const std::vector<std::int32_t>& chain = cut.vertices();
  std::unordered_set<std::int32_t> seen;
  for (const std::int32_t v : chain) {
    if (seen.insert(v).second && chain.size() > 2) continue;
    diagnosis.status = Status::curve_crosses_itself;
    diagnosis.point = to_point(region.points()[v]);
    return diagnosis;
  }
  std::vector<std::pair<std::int32_t, int>> left;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const auto edge = region.edge(chain[i], chain[(i + 1) % chain.size()]);
    if (edge.first < 0) {  // no face on the left, or divided by another part of the curve
      const bool at_border = region.edge(chain[(i + 1) % chain.size()], chain[i]).first >= 0;
      diagnosis.status = at_border ? Status::region_meets_border : Status::curve_crosses_itself;
      diagnosis.point = to_point(region.points()[chain[i]]);
      return diagnosis;
    }
    left.push_back(edge);
  }
  for (const auto& [triangle, slot] : left) region.cut(triangle, slot);
  region.make_delaunay();
  divide_shortcuts(region, chain);
  return diagnosis;
}

std::vector<std::int32_t> cut_vertices(const Region_mesh& region, std::int32_t first) {
  std::vector<std::int32_t> vertices;
  std::int32_t v = first;
  do {
    vertices.push_back(v);
    const auto& triangle = region.triangles()[region.star(v).front()];
    v = triangle.corner[(Region_mesh::slot_of(triangle, v) + 1) % 3];
  } while (v != first);
  return vertices;
}

}  // namespace cgal_blend
