// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_SECTION_WALK_H
#define CGAL_BLEND_SRC_SECTION_WALK_H

#include <cgal_blend/cut_plane.h>

#include <algorithm>
#include <vector>

namespace cgal_blend {

/// Walks along the curves in which a plane cuts a mesh, from edge to edge. Vertices that are not below count as above.
class Section_walk {
 public:
  Section_walk(const Blend_mesh& mesh, const Cut_plane& plane) : mesh_(mesh), plane_(plane) {
    below_.resize(mesh.num_vertices(), 0);
    for (const Vertex v : mesh.vertices()) below_[v.idx()] = side_of(plane, mesh.point(v)) < 0;
  }

  [[nodiscard]] bool below(Vertex v) const { return below_[v.idx()] != 0; }
  [[nodiscard]] bool crosses(Halfedge h) const { return below(mesh_.source(h)) != below(mesh_.target(h)); }

  /// Where the plane cuts an edge, in the same way for both its halfedges.
  [[nodiscard]] Point_3 point(Halfedge h) const {
    const Halfedge up = below(mesh_.source(h)) ? h : mesh_.opposite(h);
    const Point_3 &a = mesh_.point(mesh_.source(up)), &b = mesh_.point(mesh_.target(up));
    const double from = (a - plane_.point) * plane_.normal, to = (b - plane_.point) * plane_.normal;
    const double t = from == to ? 0.5 : std::clamp(from / (from - to), 0.0, 1.0);
    return a + t * (b - a);
  }

  /// A curve as the halfedges over which it enters its faces: they run down through the plane.
  struct Curve {
    std::vector<Halfedge> entries;
    bool closed = true;
  };
  /// All curves, in the order of their first halfedges; counter-clockwise around the normal.
  [[nodiscard]] std::vector<Curve> curves() const;

 private:
  const Blend_mesh& mesh_;
  Cut_plane plane_;
  std::vector<char> below_;
};

inline std::vector<Section_walk::Curve> Section_walk::curves() const {
  std::vector<Curve> found;
  std::vector<char> met(mesh_.num_halfedges(), 0);
  for (const Halfedge start : mesh_.halfedges()) {
    if (met[start.idx()] || mesh_.is_border(start) || below(mesh_.source(start)) || !below(mesh_.target(start)))
      continue;
    Curve curve;
    for (Halfedge h = start; curve.closed && !met[h.idx()];) {
      met[h.idx()] = 1;
      curve.entries.push_back(h);
      Halfedge out = mesh_.next(h);
      if (!crosses(out)) out = mesh_.next(out);
      h = mesh_.opposite(out);
      curve.closed = !mesh_.is_border(h);
    }
    found.push_back(std::move(curve));
  }
  return found;
}

}  // namespace cgal_blend

#endif
