// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_PHONG_TESSELLATION_H
#define CGAL_BLEND_SRC_PHONG_TESSELLATION_H

#include "base_surface.h"

#include <array>
#include <optional>
#include <vector>

namespace cgal_blend {

/// Halfedges of a face; their targets are its corners 0, 1, 2, in the order of `Surface_point`.
[[nodiscard]] inline std::array<Halfedge, 3> halfedges_of(Face face, const Blend_mesh& mesh) {
  const Halfedge h = mesh.halfedge(face);
  return {h, mesh.next(h), mesh.next(mesh.next(h))};
}

/// Curved triangle over three corners with unit normals (Boubekeur & Alexa 2008, Phong tessellation). Point and normal
/// along a side depend on its two ends only.
struct Phong_facet {
  std::array<Vec, 3> corner;
  std::array<Vec, 3> normal;

  [[nodiscard]] Vec point(const Vec& bary) const;
  [[nodiscard]] Vec unit_normal(const Vec& bary) const;

  /// Barycentric coordinates, of the nearest point of the flat triangle.
  [[nodiscard]] Vec nearest(const Vec& p) const;

  /// Barycentric coordinates, possibly outside of the triangle, at which p lies straight above or below the surface,
  /// along its normal there (Panozzo et al. 2013, Phong projection); null if Newton's method finds none from `start`.
  [[nodiscard]] std::optional<Vec> foot(const Vec& p, const Vec& start) const;
};

/// Unit normals of a closed mesh with curves: the average of the face normals around a vertex, weighted by angle; and,
/// at a curve, the average on one side of it.
class Corner_normals {
 public:
  /// \param on_curve indexed by edge
  Corner_normals(const Blend_mesh& mesh, const std::vector<bool>& on_curve);

  /// Normals of the same mesh after its vertices moved to where `moved` has them. As far as a crease along a curve has
  /// been smoothed out, the normals on its two sides are averaged, so that no crease is seen where there is none.
  Corner_normals(const Corner_normals& before, const Blend_mesh& moved);

  /// \return the normal at the target of h, seen from its face
  [[nodiscard]] const Vec& corner(Halfedge h) const { return corner_[h]; }
  [[nodiscard]] const Vec& vertex(Vertex v) const { return vertex_[v]; }

 private:
  void average(const Blend_mesh& positions);
  [[nodiscard]] Halfedge first_of_fan(Halfedge h) const;
  [[nodiscard]] Vec fan_normal(Halfedge first, const Blend_mesh& positions) const;

  const Blend_mesh* mesh_;
  const std::vector<bool>* on_curve_;
  std::vector<Vec> corner_, vertex_;
  std::vector<double> split_;  // by halfedge: angle between the normals on one side and on both, radians
};

}  // namespace cgal_blend

#endif
