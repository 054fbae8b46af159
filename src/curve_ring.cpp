// SPDX-License-Identifier: GPL-3.0-or-later
#include "curve_ring.h"

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <functional>
#include <map>
#include <queue>
#include <unordered_map>
#include <utility>

namespace cgal_blend {

Curve_ring::Curve_ring(const Blend_mesh& mesh)
    : mesh_(mesh),
      inner_index_(mesh.number_of_vertices() + mesh.number_of_removed_vertices(), -1),
      side_(mesh.number_of_faces() + mesh.number_of_removed_faces(), -1) {}

bool Curve_ring::collect(const std::vector<Vertex>& curve, const std::unordered_set<Vertex>& between) {
  return collect_inner(curve, between) && collect_faces(curve) && collect_borders();
}

/// Inner vertices hang together with the curve; others between the linkage curves are left where they are.
bool Curve_ring::collect_inner(const std::vector<Vertex>& curve, const std::unordered_set<Vertex>& between) {
  for (const Vertex v : curve)
    if (between.count(v)) add_inner(v);
  if (inner_.size() != curve.size() || curve.size() < 3) return false;
  for (std::size_t i = 0; i < inner_.size(); ++i)
    for (const Vertex v : mesh_.vertices_around_target(mesh_.halfedge(inner_[i])))
      if (between.count(v)) add_inner(v);
  return true;
}

void Curve_ring::add_inner(Vertex v) {
  if (is_inner(v)) return;
  inner_index_[v.idx()] = static_cast<int>(inner_.size());
  inner_.push_back(v);
}

/// All faces at inner vertices, by the side of the curve that they lie on.
bool Curve_ring::collect_faces(const std::vector<Vertex>& curve) {
  const auto add = [&](Face f, int side) {
    if (in_ring(f) || !touches_inner(f)) return;
    side_[f.idx()] = static_cast<signed char>(side);
    faces_.push_back(f);
  };
  std::unordered_set<Edge> curve_edges;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const Halfedge h = mesh_.halfedge(curve[i], curve[(i + 1) % curve.size()]);
    if (h == Blend_mesh::null_halfedge()) return false;
    curve_edges.insert(mesh_.edge(h));
    add(mesh_.face(h), 0);
    add(mesh_.face(mesh_.opposite(h)), 1);
  }
  for (std::size_t i = 0; i < faces_.size(); ++i)
    for (const Halfedge h : mesh_.halfedges_around_face(mesh_.halfedge(faces_[i]))) {
      if (curve_edges.count(mesh_.edge(h))) continue;
      const Face other = mesh_.face(mesh_.opposite(h));
      if (in_ring(other) && side(other) != side(faces_[i])) return false;
      add(other, side(faces_[i]));
    }
  std::sort(faces_.begin(), faces_.end());
  for (const Face f : faces_)  // a vertex in the midst of the region moves with it
    for (const Vertex v : mesh_.vertices_around_face(mesh_.halfedge(f)))
      if (!is_inner(v) && is_enclosed(v)) add_inner(v);
  // Nothing that an inner vertex touches may have been left out.
  for (const Vertex v : inner_)
    for (const Face f : mesh_.faces_around_target(mesh_.halfedge(v)))
      if (!in_ring(f)) return false;
  return true;
}

bool Curve_ring::is_enclosed(Vertex v) const {
  for (const Face f : mesh_.faces_around_target(mesh_.halfedge(v)))
    if (!in_ring(f)) return false;
  return true;
}

bool Curve_ring::touches_inner(Face f) const {
  for (const Vertex v : mesh_.vertices_around_face(mesh_.halfedge(f)))
    if (is_inner(v)) return true;
  return false;
}

/// The border halfedge after one that lies in the region.
Halfedge Curve_ring::next_on_border(Halfedge h) const {
  Halfedge g = mesh_.next(h);
  while (inside(mesh_.opposite(g))) g = mesh_.next(mesh_.opposite(g));
  return g;
}

/// One loop on either side, and the Euler characteristic of an annulus.
bool Curve_ring::collect_borders() {
  std::unordered_set<Halfedge> seen;
  for (const Face f : faces_)
    for (const Halfedge h : mesh_.halfedges_around_face(mesh_.halfedge(f))) {
      if (!on_border(h) || seen.count(h)) continue;
      std::vector<Halfedge>& loop = borders_[static_cast<std::size_t>(side(f))];
      if (!loop.empty()) return false;
      Halfedge g = h;
      do {
        if (side(mesh_.face(g)) != side(f) || !seen.insert(g).second) return false;
        loop.push_back(g);
        g = next_on_border(g);
      } while (g != h);
    }
  if (borders_[0].empty() || borders_[1].empty()) return false;
  const std::size_t border = borders_[0].size() + borders_[1].size();
  const std::size_t edges = (3 * faces_.size() + border) / 2;
  return inner_.size() + border + faces_.size() == edges;  // each border halfedge stands for one vertex
}

/// Dijkstra over inner vertices, from the fan of faces behind one border halfedge to that behind the other.
std::vector<Halfedge> Curve_ring::shortest_path(const std::array<Halfedge, 2>& ends, double hop) const {
  std::map<Vertex, Halfedge> last;  // edges into the second end
  for_fan(ends[1], [&](Halfedge h) {
    if (is_inner(mesh_.source(h))) last.emplace(mesh_.source(h), h);
  });
  std::unordered_map<Vertex, std::pair<double, Halfedge>> best;
  using Item = std::pair<double, Halfedge>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  for_fan(ends[0], [&](Halfedge h) { queue.push({length(h) + hop, mesh_.opposite(h)}); });
  Vertex arrived;
  double shortest = 0;
  while (!queue.empty()) {
    const auto [far, h] = queue.top();
    queue.pop();
    if (arrived != Blend_mesh::null_vertex() && far >= shortest) break;
    const Vertex v = mesh_.target(h);
    if (!is_inner(v) || !best.emplace(v, Item{far, h}).second) continue;
    if (const auto end = last.find(v); end != last.end()) {
      const double total = far + length(end->second) + hop;
      if (arrived == Blend_mesh::null_vertex() || total < shortest) {
        shortest = total;
        arrived = v;
      }
    }
    for (const Halfedge g : mesh_.halfedges_around_target(h)) queue.push({far + length(g) + hop, mesh_.opposite(g)});
  }
  if (arrived == Blend_mesh::null_vertex()) return {};
  std::vector<Halfedge> path{last.at(arrived)};
  for (Vertex v = arrived; is_inner(v); v = mesh_.source(path.back())) path.push_back(best.at(v).second);
  std::reverse(path.begin(), path.end());
  return path;
}

double Curve_ring::length(Halfedge h) const {
  return (to_vec(mesh_.point(mesh_.target(h))) - to_vec(mesh_.point(mesh_.source(h)))).norm();
}

}  // namespace cgal_blend
