// SPDX-License-Identifier: GPL-3.0-or-later
#include "collapse_short_edges.h"

#include <cgal_blend/validate.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace cgal_blend {

namespace {

double squared_limit(const Blend_mesh& mesh) {
  CGAL::Bbox_3 box;
  for (const Vertex v : mesh.vertices()) box += mesh.point(v).bbox();
  const double diagonal = std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
  return shortest_edge_fraction * shortest_edge_fraction * diagonal * diagonal;
}

/// True if moving the source of h onto its target keeps every other face at the source upright.
bool faces_stay(Halfedge h, const Blend_mesh& mesh) {
  const Vertex from = mesh.source(h);
  const Point_3 to = mesh.point(mesh.target(h));
  const Face left = mesh.face(h), right = mesh.face(mesh.opposite(h));
  for (const Halfedge g : mesh.halfedges_around_target(mesh.opposite(h))) {
    if (mesh.face(g) == left || mesh.face(g) == right) continue;
    const Point_3 &p = mesh.point(from), &q = mesh.point(mesh.target(mesh.next(g))), &r = mesh.point(mesh.source(g));
    if (CGAL::collinear(to, q, r)) return false;
    const Vector_3 before = CGAL::cross_product(q - p, r - p), after = CGAL::cross_product(q - to, r - to);
    if (!CGAL::collinear(p, q, r) && before * after < 0) return false;
  }
  return true;
}

/// True if the edge is shorter than the root of the limit.
bool shorter(Edge e, const Blend_mesh& mesh, double limit) {
  return CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))) < limit;
}

}  // namespace

bool has_short_edges(const Blend_mesh& mesh) {
  const double limit = squared_limit(mesh);
  const auto edges = mesh.edges();
  return std::any_of(edges.begin(), edges.end(), [&](Edge e) { return shorter(e, mesh, limit); });
}

std::vector<std::pair<Vertex, Vertex>> collapse_short_edges(Blend_mesh& mesh, const std::function<bool(Vertex)>& keep,
                                                            const std::function<bool(Edge)>& may_go) {
  const double limit = squared_limit(mesh);
  const auto is_short = [&](Edge e) { return shorter(e, mesh, limit) && may_go(e); };
  mesh.set_recycle_garbage(false);
  std::vector<std::pair<Vertex, Vertex>> merged;
  // Slivers between two short edges may stand in the way of one of them until the other is gone.
  for (bool collapsed = true; collapsed;) {
    collapsed = false;
    std::vector<Edge> edges;
    for (const Edge e : mesh.edges())
      if (is_short(e)) edges.push_back(e);
    for (const Edge e : edges) {
      if (mesh.is_removed(e) || !is_short(e) || !CGAL::Euler::does_satisfy_link_condition(e, mesh)) continue;
      Halfedge h = mesh.halfedge(e);
      if (keep(mesh.source(h)) && !keep(mesh.target(h))) h = mesh.opposite(h);
      if (!faces_stay(h, mesh)) h = mesh.opposite(h);
      if (!faces_stay(h, mesh)) continue;
      const Point_3 place = mesh.point(mesh.target(h));
      const std::array<Vertex, 2> ends{mesh.source(h), mesh.target(h)};
      const Vertex left = CGAL::Euler::collapse_edge(mesh.edge(h), mesh);
      mesh.point(left) = place;
      merged.emplace_back(ends[left == ends[0] ? 1 : 0], left);
      collapsed = true;
    }
  }
  return merged;
}

}  // namespace cgal_blend
