// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_FLAT_REGIONS_H
#define CGAL_BLEND_SRC_FLAT_REGIONS_H

#include "base_surface.h"

#include <cstddef>
#include <vector>

namespace cgal_blend {

/// A plane through points that lie on it within rounding.
struct Fitted_plane {
  Vec point, normal;  ///< unit normal

  [[nodiscard]] double distance(const Point_3& p) const { return std::abs(normal.dot(to_vec(p) - point)); }
};

/// A connected set of faces that lie in one plane within rounding.
struct Flat_region {
  std::vector<Face> faces;
  std::vector<Vertex> vertices;  ///< each once
  Vec area_vector;               ///< outward; its length is twice the area
  Fitted_plane plane;
};

/// The flat regions of a mesh, found where they are asked for.
class Flat_regions {
 public:
  Flat_regions(const Blend_mesh& mesh, double tolerance);

  /// Number of the region that a face belongs to.
  [[nodiscard]] std::size_t region_of(Face face);

  [[nodiscard]] const Flat_region& operator[](std::size_t i) const { return regions_[i]; }
  [[nodiscard]] std::size_t size() const { return regions_.size(); }

 private:
  [[nodiscard]] Flat_region grow(Face seed) const;

  const Blend_mesh& mesh_;
  double tolerance_;
  std::vector<std::size_t> of_face_;
  std::vector<Flat_region> regions_;
};

}  // namespace cgal_blend

#endif
