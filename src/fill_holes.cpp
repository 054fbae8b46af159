// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill_holes.h"

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <Eigen/SparseLU>

#include <cstdint>
#include <iterator>
#include <map>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace cgal_blend {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

constexpr int rings_around = 3;  // of faces; fairing with continuous tangents looks at two

/// The faces around a hole, as a mesh of their own.
class Surroundings {
 public:
  Surroundings(const Blend_mesh& mesh, Halfedge hole) : mesh_(mesh) {
    std::vector<Vertex> front;
    for (const Halfedge h : mesh.halfedges_around_face(hole)) front.push_back(mesh.target(h));
    for (int ring = 0; ring < rings_around; ++ring) front = add_faces_at(front);
  }

  /// Fills the hole; returns the new faces, none if that fails.
  [[nodiscard]] std::vector<Face> fill(Halfedge hole) {
    std::vector<Face> faces;
    if (failed_) return faces;
    const Halfedge h = copy_.halfedge(vertex_at(mesh_.source(hole)), vertex_at(mesh_.target(hole)));
    if (h == Blend_mesh::null_halfedge() || !copy_.is_border(h)) return faces;
    using Solver = CGAL::Eigen_solver_traits<Eigen::SparseLU<CGAL::Eigen_sparse_matrix<double>::EigenType>>;
    std::vector<Vertex> vertices;
    PMP::triangulate_refine_and_fair_hole(copy_, h, std::back_inserter(faces), std::back_inserter(vertices),
                                          PMP::parameters::sparse_linear_solver(Solver()));
    return faces;
  }

  [[nodiscard]] const Blend_mesh& copy() const { return copy_; }
  /// The vertex of the mesh that one of the copy stands for; null for one of the filling.
  [[nodiscard]] Vertex original(Vertex v) const { return v.idx() < originals_.size() ? originals_[v.idx()] : Vertex(); }

 private:
  Vertex vertex_at(Vertex v) {
    const auto [found, is_new] = copies_.emplace(v, Vertex());
    if (is_new) {
      found->second = copy_.add_vertex(mesh_.point(v));
      originals_.push_back(v);
    }
    return found->second;
  }

  std::vector<Vertex> add_faces_at(const std::vector<Vertex>& front) {
    std::vector<Vertex> reached;
    for (const Vertex v : front)
      for (const Face f : mesh_.faces_around_target(mesh_.halfedge(v))) {
        if (f == Blend_mesh::null_face() || !faces_.insert(f).second) continue;
        std::vector<Vertex> corners;
        for (const Vertex w : mesh_.vertices_around_face(mesh_.halfedge(f))) {
          corners.push_back(vertex_at(w));
          reached.push_back(w);
        }
        failed_ = failed_ || copy_.add_face(corners) == Blend_mesh::null_face();
      }
    return reached;
  }

  const Blend_mesh& mesh_;
  Blend_mesh copy_;
  std::unordered_map<Vertex, Vertex> copies_;
  std::vector<Vertex> originals_;
  std::unordered_set<Face> faces_;
  bool failed_ = false;
};

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
  Surroundings around(mesh, hole);
  const std::vector<Face> filling = around.fill(hole);
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
