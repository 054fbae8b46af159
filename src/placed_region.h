// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_PLACED_REGION_H
#define CGAL_BLEND_SRC_PLACED_REGION_H

#include "virtual_surface.h"

#include <cstddef>
#include <map>
#include <vector>

namespace cgal_blend {

/// Unit normal of a triangle.
[[nodiscard]] Vec face_normal(const Vec& a, const Vec& b, const Vec& c);
[[nodiscard]] Vec face_normal(const Blend_mesh& mesh, Face f);

/// A blending region with its inner vertices on the virtual surface, by their parameters. Faces that are large against
/// the ball may fold in space though their images in the parameter plane do not; vertices then slide on the surface.
class Placed_region {
 public:
  struct Place {
    double t, u;
    Vec point;
  };

  /// \param faces the region
  /// \param inner_index by vertex of the mesh: number of the inner vertex, below `inner`, or -1
  /// All are referred to, not copied.
  Placed_region(const Blend_mesh& mesh, const Virtual_surface& surface, const std::vector<Face>& faces,
                const std::vector<int>& inner_index, std::size_t inner)
      : mesh_(mesh), surface_(surface), faces_(faces), inner_index_(inner_index), places_(inner) {}

  /// Puts an inner vertex at S(t, u).
  void put(Vertex v, double t, double u) { at(v) = {t, u, surface_(t, u)}; }

  /// Moves a vertex of the border.
  void draw(Vertex v, const Vec& to) { border_.emplace(v, to); }

  /// Slides inner vertices until every face looks about the way that the surface does there, as far as that is possible.
  void untangle();

  [[nodiscard]] const Place& place(Vertex inner) const { return places_[inner_index_[inner.idx()]]; }
  [[nodiscard]] const std::map<Vertex, Vec>& border() const { return border_; }

  /// Largest distance of sample points of the surface from the plane triangles that stand for it.
  [[nodiscard]] double coarseness() const;

 private:
  /// The mean of a face's inner vertices.
  struct Mean_place {
    double t = 0, u = 0;
    Vec point = Vec::Zero();
    int inner = 0;
  };

  [[nodiscard]] bool is_inner(Vertex v) const { return inner_index_[v.idx()] >= 0; }
  [[nodiscard]] Place& at(Vertex inner) { return places_[inner_index_[inner.idx()]]; }
  [[nodiscard]] Vec position(Vertex v) const;
  [[nodiscard]] Mean_place mean_place(Face f) const;
  [[nodiscard]] Vec wanted_normal(Face f) const;
  [[nodiscard]] double uprightness(Face f) const;
  [[nodiscard]] double tangle(Vertex v) const;
  bool slide(Vertex v);

  const Blend_mesh& mesh_;
  const Virtual_surface& surface_;
  const std::vector<Face>& faces_;
  const std::vector<int>& inner_index_;
  std::vector<Place> places_;
  std::map<Vertex, Vec> border_;
};

}  // namespace cgal_blend

#endif
