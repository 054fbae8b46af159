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

/// The point where a step leaves one face for a neighbouring one, and both; the shortest such way.
struct Change {
  Face from, to;
  Support at;
};

std::optional<Change> change_of_face(const Blend_mesh& mesh, const Face_point& a, const Face_point& b) {
  const Vec p = to_vec(position(mesh, a)), q = to_vec(position(mesh, b));
  const std::vector<Face> from = faces_at(mesh, a), to = faces_at(mesh, b);
  std::optional<Change> best;
  double shortest = 0;
  const auto offer = [&](double length, Change change) {
    if (best && length >= shortest) return;
    shortest = length;
    best = std::move(change);
  };
  for (const Face f : from)
    for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      const Face g = mesh.face(mesh.opposite(h));
      if (g != Blend_mesh::null_face() && std::find(to.begin(), to.end(), g) != to.end()) {
        const auto [share, length] = crossing(mesh, h, p, q);
        Support support;
        if (1 - share >= least_weight) support.emplace_back(mesh.source(h), 1 - share);
        if (share >= least_weight) support.emplace_back(mesh.target(h), share);
        offer(length, {f, g, support});
      }
    }
  if (best) return best;
  for (const Face f : from)  // faces that share a vertex only
    for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
      for (const Face g : to)
        if (const Support support{{v, 1}}; in_face(mesh, support, g)) {
          const Vec at = to_vec(mesh.point(v));
          offer((at - p).norm() + (q - at).norm(), {f, g, support});
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

  void start(std::int32_t vertex) { vertices_.push_back(vertex); }
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
    const auto change = change_of_face(mesh, a, b);
    if (!change) return std::nullopt;
    curve.push_back({a, change->from});
    curve.push_back({*in_face(mesh, change->at, change->to), change->to});
  }
  return curve;
}

Diagnosis cut_along(Region_mesh& region, const std::vector<Curve_point>& curve, std::int32_t& first) {
  Diagnosis diagnosis;
  const Blend_mesh& mesh = region.mesh();
  Cut cut(region);
  std::vector<std::int32_t> vertices;
  for (const Curve_point& p : curve) vertices.push_back(insert_place(region, p.at));
  first = vertices.front();
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const std::size_t next = (i + 1) % curve.size();
    const auto target = in_face(mesh, support_of(mesh, curve[next].at), curve[i].step);
    CGAL_assertion(target.has_value());
    if (cut.connect(vertices[i], vertices[next], *target)) continue;
    diagnosis.status = Status::curve_crosses_itself;
    diagnosis.point = to_point(region.points()[vertices[i]]);
    return diagnosis;
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
    if (edge.first < 0) {
      diagnosis.status = Status::region_meets_border;
      diagnosis.point = to_point(region.points()[chain[i]]);
      return diagnosis;
    }
    left.push_back(edge);
  }
  for (const auto& [triangle, slot] : left) region.cut(triangle, slot);
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
