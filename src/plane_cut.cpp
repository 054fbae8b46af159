// SPDX-License-Identifier: GPL-3.0-or-later
#include "plane_cut.h"

#include "plane_advice.h"
#include "ring_edges.h"
#include "section_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace cgal_blend {

namespace {

constexpr std::size_t none = static_cast<std::size_t>(-1);

/// The first vertex with a face that lies exactly on the plane.
std::optional<Vertex> vertex_on(const Blend_mesh& mesh, const Cut_plane& plane) {
  for (const Vertex v : mesh.vertices())
    if (!mesh.is_isolated(v) && side_of(plane, mesh.point(v)) == 0) return v;
  return std::nullopt;
}

// A vertex counts as met if an edge is cut nearer to it than this share of the edge,
constexpr double clearance = 1e-9;
// or than so many units in the last place of its coordinates: the rounded ring could cross itself there.
constexpr double clearance_in_ulps = 64;

/// The first vertex that the curves pass too close by for points in double.
std::optional<Vertex> vertex_met(const Blend_mesh& mesh, const Section_walk& walk,
                                 const std::vector<Section_walk::Curve>& curves) {
  for (const auto& curve : curves)
    for (const Halfedge h : curve.entries) {
      const Point_3 p = walk.point(h);
      const double edge = std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))));
      for (const Vertex v : {mesh.source(h), mesh.target(h)}) {
        const Point_3& q = mesh.point(v);
        const double size = std::max({std::abs(q.x()), std::abs(q.y()), std::abs(q.z())});
        const double least = clearance * edge + clearance_in_ulps * std::numeric_limits<double>::epsilon() * size;
        if (CGAL::squared_distance(p, q) < least * least) return v;
      }
    }
  return std::nullopt;
}

Diagnosis refusal(Status status, const Point_3& at) { return {status, "", at, std::nullopt}; }

/// Builds a cut: numbers what is kept, then divides faces.
class Divider {
 public:
  Divider(const Blend_mesh& mesh, const Section_walk& walk)
      : mesh_(mesh), walk_(walk), vertex_(mesh.num_vertices(), none), new_vertex_(mesh.num_edges(), none) {}

  Plane_cut run(const std::vector<Section_walk::Curve>& curves, bool tidy) {
    number_kept();
    for (const auto& curve : curves) add_ring(curve);
    for (const Face f : mesh_.faces()) divide(f);
    if (tidy) collapse_short_ring_edges(cut_, mesh_, std::move(normals_));
    return std::move(cut_);
  }

 private:
  void number_kept() {
    for (const Vertex v : mesh_.vertices())
      if (!mesh_.is_isolated(v) && walk_.below(v)) {
        vertex_[v.idx()] = cut_.vertices.size();
        cut_.vertices.push_back(v);
      }
  }

  void add_ring(const Section_walk::Curve& curve) {
    std::vector<std::size_t> ring;
    for (const Halfedge h : curve.entries) {
      new_vertex_[mesh_.edge(h).idx()] = cut_.vertices.size() + cut_.points.size();
      ring.push_back(new_vertex_[mesh_.edge(h).idx()]);
      cut_.points.push_back(walk_.point(h));
    }
    cut_.rings.push_back(std::move(ring));
  }

  void divide(Face f) {
    std::vector<std::size_t> corners;
    Halfedge h = mesh_.halfedge(f);
    for (int i = 0; i < 3; ++i, h = mesh_.next(h)) {
      if (walk_.below(mesh_.source(h))) corners.push_back(vertex_[mesh_.source(h).idx()]);
      if (walk_.crosses(h)) corners.push_back(new_vertex_[mesh_.edge(h).idx()]);
    }
    const bool whole =
        std::all_of(corners.begin(), corners.end(), [&](std::size_t v) { return v < cut_.vertices.size(); });
    if (corners.empty()) return;
    if (whole) {
      cut_.faces.push_back(f);
      return;
    }
    const auto p = [&](Halfedge e) { return mesh_.point(mesh_.target(e)); };
    const Vector_3 normal = CGAL::cross_product(p(mesh_.next(h)) - p(h), p(mesh_.next(mesh_.next(h))) - p(h));
    add_remnants(corners, normal);
  }

  void add_remnants(const std::vector<std::size_t>& c, const Vector_3& normal) {
    if (c.size() == 3) {
      cut_.remnants.push_back({c[0], c[1], c[2]});
      normals_.push_back(normal);
      return;
    }
    const bool first = CGAL::compare_distance(point(c[0]), point(c[2]), point(c[1]), point(c[3])) != CGAL::LARGER;
    cut_.remnants.push_back(first ? Indices{c[0], c[1], c[2]} : Indices{c[1], c[2], c[3]});
    cut_.remnants.push_back(first ? Indices{c[0], c[2], c[3]} : Indices{c[3], c[0], c[1]});
    normals_.insert(normals_.end(), 2, normal);
  }

  Point_3 point(std::size_t v) const {
    const std::size_t kept = cut_.vertices.size();
    return v < kept ? mesh_.point(cut_.vertices[v]) : cut_.points[v - kept];
  }

  using Indices = std::array<std::size_t, 3>;
  const Blend_mesh& mesh_;
  const Section_walk& walk_;
  Plane_cut cut_;
  std::vector<std::size_t> vertex_, new_vertex_;  // by vertex, by edge
  std::vector<Vector_3> normals_;
};

/// The borders of a mesh as loops of border halfedges, in the order of their first ones.
std::vector<std::vector<Halfedge>> borders(const Blend_mesh& mesh) {
  std::vector<std::vector<Halfedge>> found;
  std::vector<char> met(mesh.num_halfedges(), 0);
  for (const Halfedge start : mesh.halfedges()) {
    if (!mesh.is_border(start) || met[start.idx()]) continue;
    found.emplace_back();
    for (Halfedge h = start; !met[h.idx()]; h = mesh.next(h)) {
      met[h.idx()] = 1;
      found.back().push_back(h);
    }
  }
  return found;
}

/// The plane through the centroid of the borders' vertices, normal to the sum of their vector areas: border halfedges run
/// counter-clockwise around the side away from the mesh.
Cut_plane plane_of(const Blend_mesh& mesh, const std::vector<std::vector<Halfedge>>& loops) {
  const Point_3 origin = mesh.point(mesh.target(loops.front().front()));
  Vector_3 area(0, 0, 0), sum(0, 0, 0);
  double count = 0;
  for (const auto& loop : loops)
    for (const Halfedge h : loop) {
      const Vector_3 a = mesh.point(mesh.source(h)) - origin, b = mesh.point(mesh.target(h)) - origin;
      area = area + CGAL::cross_product(a, b);
      sum = sum + b;
      ++count;
    }
  const double length = std::sqrt(area.squared_length());
  return {origin + sum / count, length > 0 ? area / length : Vector_3(0, 0, 0)};
}

}  // namespace

std::vector<Section_loop> section(const Blend_mesh& mesh, const Cut_plane& plane) {
  const Section_walk walk(mesh, plane);
  std::vector<Section_loop> loops;
  for (const auto& curve : walk.curves()) {
    if (!curve.closed) continue;
    Section_loop loop;
    for (const Halfedge h : curve.entries) {
      const Point_3 p = walk.point(h);
      if (loop.empty() || loop.back() != p) loop.push_back(p);
    }
    while (loop.size() > 1 && loop.back() == loop.front()) loop.pop_back();
    if (loop.size() >= 3) loops.push_back(std::move(loop));
  }
  return loops;
}

Plane_cut cut(const Blend_mesh& mesh, const Cut_plane& plane, bool tidy) {
  Plane_cut result;
  if (const auto v = vertex_on(mesh, plane)) {
    result.diagnosis = plane_that_meets(mesh, plane, *v);
    return result;
  }
  const Section_walk walk(mesh, plane);
  const std::vector<Section_walk::Curve> curves = walk.curves();
  if (const auto v = vertex_met(mesh, walk, curves)) result.diagnosis = plane_that_meets(mesh, plane, *v);
  if (curves.empty()) result.diagnosis = plane_that_misses(mesh, plane);
  for (const auto& curve : curves)
    if (!curve.closed) result.diagnosis = refusal(Status::section_not_closed, walk.point(curve.entries.back()));
  return result.ok() ? Divider(mesh, walk).run(curves, tidy) : result;
}

Plane_cut take_holes(const Blend_mesh& mesh, Cut_plane& plane) {
  Plane_cut result;
  const auto loops = borders(mesh);
  if (loops.empty()) {
    result.diagnosis = {Status::section_not_closed, "there is no plane, and the mesh has no holes", {}, {}};
    return result;
  }
  plane = plane_of(mesh, loops);
  double extent = 0, worst = 0;
  Point_3 place = plane.point;
  for (const auto& loop : loops)
    for (const Halfedge h : loop) {
      const Vector_3 v = mesh.point(mesh.target(h)) - plane.point;
      extent = std::max(extent, std::sqrt(v.squared_length()));
      if (std::abs(v * plane.normal) > worst) place = mesh.point(mesh.target(h));
      worst = std::max(worst, std::abs(v * plane.normal));
    }
  if (plane.normal == CGAL::NULL_VECTOR || worst > planar_hole * extent) {
    result.diagnosis = refusal(Status::opening_not_planar, place);
    return result;
  }
  std::vector<std::size_t> index(mesh.num_vertices(), none);
  for (const Vertex v : mesh.vertices())
    if (!mesh.is_isolated(v)) {
      index[v.idx()] = result.vertices.size();
      result.vertices.push_back(v);
    }
  result.faces.assign(mesh.faces().begin(), mesh.faces().end());
  for (const auto& loop : loops) {
    result.rings.emplace_back();
    for (const Halfedge h : loop) result.rings.back().push_back(index[mesh.source(h).idx()]);
  }
  return result;
}

}  // namespace cgal_blend
