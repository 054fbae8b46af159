// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuse_bend.h"

#include <CGAL/Surface_mesh_deformation.h>

#include <cstdint>
#include <vector>

namespace cgal_blend {

namespace {

using Deformation = CGAL::Surface_mesh_deformation<Blend_mesh, CGAL::Default, CGAL::Default, CGAL::SRE_ARAP>;

constexpr int steps = 20;
// How much neighbouring rotations are drawn together, of the surface's area.
constexpr double smoothness = 0.02;

/// Vertices inside the transition, then its rings and their neighbours.
struct Region {
  std::vector<Vertex> inner, handles;
};

Region find_region(const Blend_mesh& mesh, std::size_t first_inner) {
  Region region;
  std::vector<char> met(mesh.num_vertices(), 0);
  for (std::size_t i = first_inner; i < mesh.num_vertices(); ++i) {
    met[i] = 1;
    region.inner.push_back(Vertex(static_cast<std::uint32_t>(i)));
  }
  const auto add_neighbours = [&](Vertex v) {
    for (const Vertex u : vertices_around_target(mesh.halfedge(v), mesh)) {
      if (met[u.idx()]) continue;
      met[u.idx()] = 1;
      region.handles.push_back(u);
    }
  };
  for (const Vertex v : region.inner) add_neighbours(v);
  const std::size_t rings = region.handles.size();
  for (std::size_t i = 0; i < rings; ++i) add_neighbours(region.handles[i]);
  return region;
}

Vector_3 normal(const Blend_mesh& mesh, Face f) {
  const Halfedge h = mesh.halfedge(f);
  const Point_3& p = mesh.point(mesh.source(h));
  return CGAL::cross_product(mesh.point(mesh.target(h)) - p, mesh.point(mesh.target(mesh.next(h))) - p);
}

/// True if a face at an inner vertex looks the other way than in the mesh that it was bent to at first.
bool turned_over(const Blend_mesh& now, const Blend_mesh& first, const std::vector<Vertex>& inner) {
  for (const Vertex v : inner)
    for (const Face f : faces_around_target(now.halfedge(v), now))
      if (!(normal(now, f) * normal(first, f) > 0)) return true;
  return false;
}

}  // namespace

void relax_bend(Blend_mesh& mesh, const std::vector<Point_3>& straight, std::size_t first_inner) {
  const Region region = find_region(mesh, first_inner);
  if (region.inner.empty()) return;
  Blend_mesh work = mesh;
  for (const Vertex v : work.vertices()) work.point(v) = straight[v.idx()];
  Deformation deformation(work);
  deformation.set_sre_arap_alpha(smoothness);
  for (const auto* part : {&region.inner, &region.handles}) {
    deformation.insert_roi_vertices(part->begin(), part->end());
    deformation.insert_control_vertices(part->begin(), part->end());
  }
  // The first bend is where iterations start from: all vertices are put there before they are let go.
  for (const auto* part : {&region.inner, &region.handles})
    for (const Vertex v : *part) deformation.set_target_position(v, mesh.point(v));
  deformation.deform(1, 0);
  for (const Vertex v : region.inner) deformation.erase_control_vertex(v);
  if (!deformation.preprocess()) return;
  const Blend_mesh first = mesh;
  for (int k = 0; k < steps; ++k) {
    deformation.deform(1, 0);
    if (turned_over(work, first, region.inner)) return;
    for (const Vertex v : region.inner) mesh.point(v) = work.point(v);
  }
}

}  // namespace cgal_blend
