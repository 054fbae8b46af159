// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuse_assembly.h"

#include "mesh_formats.h"

#include <cstdint>
#include <utility>

namespace cgal_blend {

namespace {

using internal::Triangle;

/// Points and triangles of the output, numbered as `number_vertices` says.
class Sewing {
 public:
  Sewing(const std::array<Fuse_side, 2>& sides, std::size_t side_vertices) : sides_(sides), points_(side_vertices) {}

  Fused_mesh run(const Slab_tessellation& slab, const std::vector<Point_3>& inner) {
    add_kept();
    add_remnants();
    add_transition(slab, inner);
    const internal::Triangle_topology topology = internal::analyze_topology(points_.size(), triangles_);
    if (topology.manifold() && !topology.border_edge)
      fused_.mesh = internal::assemble(points_, triangles_, topology);
    else
      fused_.diagnosis = {Status::result_invalid, "the transition does not fit the openings", {}, {}};
    return std::move(fused_);
  }

 private:
  static std::uint32_t index(std::size_t i) { return static_cast<std::uint32_t>(i); }

  void add_kept() {
    for (const Fuse_side& side : sides_)
      for (const Fuse_part& part : side.parts) {
        std::vector<std::uint32_t> place(part.mesh->num_vertices(), 0);
        for (std::size_t i = 0; i < part.cut.vertices.size(); ++i) {
          const Vertex v = part.cut.vertices[i];
          place[v.idx()] = index(part.first_kept + i);
          points_[part.first_kept + i] = part.mesh->point(v);
        }
        for (std::size_t i = 0; i < part.cut.points.size(); ++i) points_[part.first_new + i] = part.cut.points[i];
        for (const Face f : part.cut.faces) {
          const Halfedge h = part.mesh->halfedge(f);
          const auto corner = [&](Halfedge e) { return place[part.mesh->source(e).idx()]; };
          triangles_.push_back({corner(h), corner(part.mesh->next(h)), corner(part.mesh->prev(h))});
        }
        fused_.part_end.push_back(triangles_.size());
      }
    fused_.kept_faces = triangles_.size();
  }

  void add_remnants() {
    for (const Fuse_side& side : sides_)
      for (const Fuse_part& part : side.parts)
        for (const auto& t : part.cut.remnants)
          triangles_.push_back(
              {index(part.output_index(t[0])), index(part.output_index(t[1])), index(part.output_index(t[2]))});
    fused_.old_faces = triangles_.size();
  }

  void add_transition(const Slab_tessellation& slab, const std::vector<Point_3>& inner) {
    std::vector<std::uint32_t> place;
    for (const Fuse_side& side : sides_)
      for (const auto& ring : side.rings)
        for (const std::size_t v : ring) place.push_back(index(v));
    for (const Point_3& p : inner) {
      place.push_back(index(points_.size()));
      points_.push_back(p);
    }
    fused_.new_vertices = inner.size();
    for (const auto& t : slab.triangles) triangles_.push_back({place[t[0]], place[t[1]], place[t[2]]});
  }

  const std::array<Fuse_side, 2>& sides_;
  std::vector<Point_3> points_;
  std::vector<Triangle> triangles_;
  Fused_mesh fused_;
};

}  // namespace

Fused_mesh sew(const std::array<Fuse_side, 2>& sides, std::size_t side_vertices, const Slab_tessellation& slab,
               const std::vector<Point_3>& inner) {
  return Sewing(sides, side_vertices).run(slab, inner);
}

}  // namespace cgal_blend
