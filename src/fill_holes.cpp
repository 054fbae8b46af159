// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill_holes.h"

#include "hole_surroundings.h"

#include <cstdint>
#include <map>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace cgal_blend {

namespace {

using Directed_edge = std::pair<std::int32_t, std::int32_t>;
using Open_edges = std::map<Directed_edge, std::pair<std::int32_t, int>>;  // triangle and slot by ends

/// Joins an edge of a triangle with the open one that runs the other way, or opens it.
void join(Region_mesh& region, Open_edges& open, std::int32_t triangle, int slot) {
  const auto& corner = region.triangles()[triangle].corner;
  const std::int32_t from = corner[(slot + 1) % 3], to = corner[(slot + 2) % 3];
  const auto other = open.find({to, from});
  if (other == open.end()) {
    open.emplace(Directed_edge{from, to}, std::pair{triangle, slot});
    return;
  }
  region.join(triangle, slot, other->second.first, other->second.second);
  open.erase(other);
}

Open_edges border_edges(const Region_mesh& region) {
  Open_edges open;
  for (std::int32_t t = 0; t < static_cast<std::int32_t>(region.triangles().size()); ++t) {
    const auto& [corner, beyond] = region.triangles()[t];
    for (int slot = 0; slot < 3; ++slot)
      if (beyond[slot] == Region_mesh::border)
        open.emplace(Directed_edge{corner[(slot + 1) % 3], corner[(slot + 2) % 3]}, std::pair{t, slot});
  }
  return open;
}

void fill_hole(Region_mesh& region, Halfedge hole) {
  const Blend_mesh& mesh = region.mesh();
  Hole_surroundings around(mesh, hole);
  const std::vector<Face> filling = around.fill();
  if (filling.empty()) return;
  std::unordered_set<Vertex> rim;
  for (const Halfedge h : mesh.halfedges_around_face(hole)) rim.insert(mesh.target(h));
  region.grow(mesh.face(mesh.opposite(hole)), [&](Face f) {
    for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
      if (rim.count(v)) return true;
    return false;
  });
  Open_edges open = border_edges(region);
  std::unordered_map<Vertex, std::int32_t> added;
  for (const Face f : filling) {
    std::array<std::int32_t, 3> corners{};
    int slot = 0;
    for (const Vertex v : around.copy().vertices_around_face(around.copy().halfedge(f))) {
      const Vertex original = around.original(v);
      if (original != Blend_mesh::null_vertex())
        corners[slot] = region.local(original);
      else if (const auto [place, is_new] = added.emplace(v, -1); is_new)
        corners[slot] = place->second = region.add_point(to_vec(around.copy().point(v)));
      else
        corners[slot] = place->second;
      ++slot;
    }
    const std::int32_t t = region.add(corners);
    for (int side = 0; side < 3; ++side) join(region, open, t, side);
  }
}

/// The halfedge of the hole at an edge of a triangle.
Halfedge hole_at(const Region_mesh& region, std::int32_t triangle, int slot) {
  const Blend_mesh& mesh = region.mesh();
  Halfedge h = mesh.prev(mesh.halfedge(region.face(triangle)));  // opposite of corner 0
  for (int i = 0; i < slot; ++i) h = mesh.next(h);
  return mesh.opposite(h);
}

}  // namespace

bool fill_holes(Region_mesh& region, const std::function<bool(const std::array<Vec, 3>&)>& belongs) {
  std::vector<Halfedge> holes;
  std::unordered_set<Halfedge> seen;
  for (std::int32_t t = 0; t < static_cast<std::int32_t>(region.triangles().size()); ++t)
    for (int slot = 0; slot < 3; ++slot) {
      if (region.triangles()[t].beyond[slot] != Region_mesh::border || !belongs(region.corners(t))) continue;
      const Halfedge hole = hole_at(region, t, slot);
      if (seen.count(hole)) continue;
      for (const Halfedge h : region.mesh().halfedges_around_face(hole)) seen.insert(h);
      holes.push_back(hole);
    }
  const std::size_t before = region.triangles().size();
  for (const Halfedge hole : holes) fill_hole(region, hole);
  return region.triangles().size() > before;
}

}  // namespace cgal_blend
