// SPDX-License-Identifier: GPL-3.0-or-later
#include "decimation.h"

#include "base_surface.h"

#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cgal_blend {

namespace {

namespace SMS = CGAL::Surface_mesh_simplification;

constexpr double shape_weight = 1e-3;  // of edge lengths against distances: even triangles where it is flat
constexpr double curve_weight = 10;    // of distances to curves against distances to faces
constexpr double centring = 1e-3;      // pull towards the middle of the edge where the quadric has no unique minimum
constexpr double least_cosine = 0.5;   // a face turns by no more than 60 degrees in one step,
constexpr double least_quality = 0.1;  // and gets no flatter than this (1: equilateral), or than the flattest before
constexpr std::size_t no_node = static_cast<std::size_t>(-1);

/// Weighted sum of squared distances to planes and lines, x'Ax + 2b'x + c.
struct Quadric {
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Vec b = Vec::Zero();
  double c = 0;

  /// Adds the distance to `on` measured along the directions that the projection keeps.
  void add(const Eigen::Matrix3d& projection, const Vec& on, double weight) {
    const Vec moment = projection * on;
    a += weight * projection;
    b -= weight * moment;
    c += weight * on.dot(moment);
  }
  Quadric& operator+=(const Quadric& other) {
    a += other.a;
    b += other.b;
    c += other.c;
    return *this;
  }
  [[nodiscard]] double operator()(const Vec& x) const { return std::max(0.0, x.dot(a * x) + 2 * b.dot(x) + c); }
  [[nodiscard]] double weight() const { return a.trace(); }

  [[nodiscard]] Vec minimum_near(const Vec& x) const {
    const double pull = centring * weight();
    const Eigen::Matrix3d regular = a + pull * Eigen::Matrix3d::Identity();
    return x - regular.inverse() * (a * x + b);
  }
};

Quadric operator+(Quadric a, const Quadric& b) { return a += b; }

/// A vertex of a curve that is still there.
struct Curve_node {
  std::size_t curve;
  std::size_t previous = no_node, next = no_node;
};

using Profile = SMS::Edge_profile<Blend_mesh>;
using Placement = boost::optional<Point_3>;
using Cost = boost::optional<double>;

/// What the policies know of the vertices, indexed by vertex, in coordinates in which the mesh has size 1.
class Decimation {
 public:
  Decimation(const Blend_mesh& mesh, const std::vector<Vertex_chain>& curves, std::size_t faces);

  [[nodiscard]] Placement placement(const Profile& profile) const;
  [[nodiscard]] Cost cost(const Profile& profile, const Placement& placement) const;
  void before_collapse(const Profile& profile, const Placement& placement);
  void after_collapse(const Profile& profile, Vertex kept);

  /// The fine vertex at the place of v, or null.
  [[nodiscard]] Vertex origin(Vertex v) const { return origin_[v]; }
  [[nodiscard]] Vertex merged_into(Vertex v);

 private:
  void add_faces(const Blend_mesh& mesh);
  void add_curves(const Blend_mesh& mesh, const std::vector<Vertex_chain>& curves, double edge_length);
  void add_curve_edge(const Blend_mesh& mesh, Vertex v, Vertex w, double edge_length);
  [[nodiscard]] Placement placement_on_curve(const Profile& profile) const;
  void unlink(std::size_t node);
  [[nodiscard]] bool is_end(std::size_t node) const {
    return nodes_[node].previous == no_node || nodes_[node].next == no_node;
  }
  [[nodiscard]] Vec local(const Point_3& p) const { return (to_vec(p) - centre_) / size_; }
  [[nodiscard]] Point_3 global(const Vec& x) const { return to_point(centre_ + size_ * x); }

  Vec centre_;
  double size_, area_ = 0;
  std::vector<Quadric> quadrics_;
  std::vector<std::size_t> node_;
  std::vector<Vertex> origin_, parent_;
  std::vector<Curve_node> nodes_;
  std::vector<std::size_t> remaining_;  // per curve
  Vertex survivor_;                     // of the collapse under way: the end whose place is kept, if any
};

Decimation::Decimation(const Blend_mesh& mesh, const std::vector<Vertex_chain>& curves, std::size_t faces)
    : quadrics_(mesh.num_vertices()), node_(mesh.num_vertices(), no_node), origin_(mesh.num_vertices()) {
  CGAL::Bbox_3 box;
  for (const Vertex v : mesh.vertices()) box += mesh.point(v).bbox();
  const Vec low(box.xmin(), box.ymin(), box.zmin()), high(box.xmax(), box.ymax(), box.zmax());
  centre_ = (low + high) / 2;
  size_ = (high - low).norm();
  for (std::size_t i = 0; i < origin_.size(); ++i) origin_[i] = Vertex(i);
  parent_ = origin_;
  add_faces(mesh);
  const double face_area = area_ / std::max<std::size_t>(1, std::min<std::size_t>(faces, mesh.number_of_faces()));
  add_curves(mesh, curves, std::sqrt(4 / std::sqrt(3.0) * face_area));
}

void Decimation::add_faces(const Blend_mesh& mesh) {
  for (const Face f : mesh.faces()) {
    const Halfedge h = mesh.halfedge(f);
    const Vertex v[3] = {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))};
    const Vec p = local(mesh.point(v[0]));
    const Vec normal = (local(mesh.point(v[1])) - p).cross(local(mesh.point(v[2])) - p);
    const double area = normal.norm() / 2;
    if (!(area > 0)) continue;
    const Vec unit = normal / (2 * area);
    for (const Vertex corner : v) quadrics_[corner].add(unit * unit.transpose(), p, area);
    area_ += area;
  }
}

void Decimation::add_curves(const Blend_mesh& mesh, const std::vector<Vertex_chain>& curves, double edge_length) {
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const auto& [vertices, closed] = curves[i];
    const std::size_t first = nodes_.size(), count = vertices.size();
    remaining_.push_back(count);
    for (std::size_t k = 0; k < count; ++k) {
      const bool starts = k == 0, ends = k + 1 == count;
      CGAL_precondition(node_[vertices[k]] == no_node);
      node_[vertices[k]] = first + k;
      nodes_.push_back({i, starts ? (closed ? first + count - 1 : no_node) : first + k - 1,
                        ends ? (closed ? first : no_node) : first + k + 1});
      if (!ends || closed) add_curve_edge(mesh, vertices[k], vertices[ends ? 0 : k + 1], edge_length);
    }
  }
}

// The distance to the line of the edge. Its weight is an area, like that of faces: as if the edge were as wide as coarse
// edges are long.
void Decimation::add_curve_edge(const Blend_mesh& mesh, Vertex v, Vertex w, double edge_length) {
  const Vec p = local(mesh.point(v)), along = local(mesh.point(w)) - p;
  const double length = along.norm();
  if (!(length > 0)) return;
  const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - along * along.transpose() / (length * length);
  for (const Vertex end : {v, w}) quadrics_[end].add(across, p, curve_weight * length * edge_length);
}

Placement Decimation::placement(const Profile& profile) const {
  const bool first = node_[profile.v0()] != no_node, second = node_[profile.v1()] != no_node;
  if (first && second) return placement_on_curve(profile);
  if (first) return profile.p0();
  if (second) return profile.p1();
  const Quadric sum = quadrics_[profile.v0()] + quadrics_[profile.v1()];
  return global(sum.minimum_near((local(profile.p0()) + local(profile.p1())) / 2));
}

Placement Decimation::placement_on_curve(const Profile& profile) const {
  const std::size_t a = node_[profile.v0()], b = node_[profile.v1()];
  if (nodes_[a].next != b && nodes_[a].previous != b) return {};
  if (remaining_[nodes_[a].curve] <= least_curve_vertices) return {};
  if (is_end(a)) return is_end(b) ? Placement() : profile.p0();
  if (is_end(b)) return profile.p1();
  const Quadric sum = quadrics_[profile.v0()] + quadrics_[profile.v1()];
  return sum(local(profile.p0())) <= sum(local(profile.p1())) ? profile.p0() : profile.p1();
}

Cost Decimation::cost(const Profile& profile, const Placement& placement) const {
  if (!placement) return {};
  const Quadric sum = quadrics_[profile.v0()] + quadrics_[profile.v1()];
  const double length = (local(profile.p0()) - local(profile.p1())).squaredNorm();
  return sum(local(*placement)) + shape_weight * sum.weight() * length;
}

void Decimation::before_collapse(const Profile& profile, const Placement& placement) {
  survivor_ = Blend_mesh::null_vertex();
  if (*placement == profile.p0()) survivor_ = profile.v0();
  if (*placement == profile.p1()) survivor_ = profile.v1();
}

void Decimation::after_collapse(const Profile& profile, Vertex kept) {
  const Vertex gone = kept == profile.v0() ? profile.v1() : profile.v0();
  const Vertex lost = survivor_ == profile.v0() ? profile.v1() : profile.v0();
  quadrics_[kept] += quadrics_[gone];
  parent_[gone] = kept;
  const bool in_place = survivor_ != Blend_mesh::null_vertex();
  if (in_place && node_[lost] != no_node) unlink(node_[lost]);
  node_[kept] = in_place ? node_[survivor_] : no_node;
  origin_[kept] = in_place ? origin_[survivor_] : Blend_mesh::null_vertex();
}

void Decimation::unlink(std::size_t node) {
  const Curve_node& n = nodes_[node];
  if (n.previous != no_node) nodes_[n.previous].next = n.next;
  if (n.next != no_node) nodes_[n.next].previous = n.previous;
  --remaining_[n.curve];
}

Vertex Decimation::merged_into(Vertex v) {
  Vertex root = v;
  while (parent_[root] != root) root = parent_[root];
  while (parent_[v] != root) v = std::exchange(parent_[v], root);
  return root;
}

/// Quality: 1 for equilateral triangles, 0 for degenerate ones.
struct Shape {
  Vec normal;  // twice the area long
  double quality;
};
Shape shape(const Vec& p, const Vec& q, const Vec& r) {
  const Vec normal = (q - p).cross(r - p);
  const double edges = (q - p).squaredNorm() + (r - q).squaredNorm() + (p - r).squaredNorm();
  return {normal, edges > 0 ? 2 * std::sqrt(3.0) * normal.norm() / edges : 0};
}

/// Whether the faces that stay keep upright and in shape. The corner that moves is the second of each.
bool faces_stay(const Profile& profile, const Point_3& placement) {
  const Blend_mesh& mesh = profile.surface_mesh();
  const Vec to = to_vec(placement);
  double worst_before = 1, worst_after = 1;
  const auto& triangles = profile.triangles();
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Vec p = to_vec(mesh.point(triangles[i].v0)), q = to_vec(mesh.point(triangles[i].v1)),
              r = to_vec(mesh.point(triangles[i].v2));
    const Shape before = shape(p, q, r);
    worst_before = std::min(worst_before, before.quality);
    if (i < 2) continue;  // those at the edge go
    const Shape after = shape(p, to, r);
    if (before.normal.dot(after.normal) < least_cosine * before.normal.norm() * after.normal.norm()) return false;
    worst_after = std::min(worst_after, after.quality);
  }
  return worst_after > 0 && worst_after >= std::min(least_quality, worst_before);
}

// The policies that CGAL copies about; all share the state.
struct Get_placement {
  const Decimation* state;
  Placement operator()(const Profile& profile) const { return state->placement(profile); }
};
struct Get_cost {
  const Decimation* state;
  Cost operator()(const Profile& profile, const Placement& placement) const { return state->cost(profile, placement); }
};
struct Filter {
  Placement operator()(const Profile& profile, const Placement& placement) const {
    return placement && faces_stay(profile, *placement) ? placement : Placement();
  }
};
struct Visitor : SMS::internal::Dummy_visitor {
  Decimation* state;
  explicit Visitor(Decimation* s) : state(s) {}
  void OnCollapsing(const Profile& profile, const Placement& placement) const {
    state->before_collapse(profile, placement);
  }
  void OnCollapsed(const Profile& profile, Vertex kept) const { state->after_collapse(profile, kept); }
};

/// Copies what is left of the mesh.
Decimated_mesh compact(const Blend_mesh& mesh, Decimation& state, std::size_t fine_vertices) {
  Decimated_mesh out;
  out.merged_into.resize(fine_vertices);
  std::vector<Vertex> copy(fine_vertices);
  for (const Vertex v : mesh.vertices()) {
    copy[v] = out.mesh.add_vertex(mesh.point(v));
    out.origin.push_back(state.origin(v));
  }
  for (const Face f : mesh.faces()) {
    const Halfedge h = mesh.halfedge(f);
    out.mesh.add_face(copy[mesh.source(h)], copy[mesh.target(h)], copy[mesh.target(mesh.next(h))]);
    out.fine_face.push_back(f);
  }
  for (std::size_t i = 0; i < fine_vertices; ++i) out.merged_into[i] = copy[state.merged_into(Vertex(i))];
  return out;
}

}  // namespace

Decimated_mesh decimate(const Blend_mesh& fine, const std::vector<Vertex_chain>& curves, std::size_t faces) {
  Blend_mesh mesh = fine;
  Decimation state(mesh, curves, faces);
  SMS::edge_collapse(mesh, SMS::Count_stop_predicate<Blend_mesh>(faces + faces / 2 + 1),
                     CGAL::parameters::get_cost(Get_cost{&state})
                         .get_placement(Get_placement{&state})
                         .filter(Filter{})
                         .visitor(Visitor(&state)));
  Decimated_mesh out = compact(mesh, state, fine.num_vertices());
  for (const Vertex_chain& curve : curves) {
    Vertex_chain& left = out.curves.emplace_back();
    left.closed = curve.closed;
    for (const Vertex v : curve.vertices) {
      const Vertex w = out.merged_into[v];
      if (out.origin[w] == v) left.vertices.push_back(w);
    }
  }
  return out;
}

}  // namespace cgal_blend
