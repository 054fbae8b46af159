// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_REGION_TRIANGULATION_H
#define CGAL_BLEND_SRC_REGION_TRIANGULATION_H

#include <cgal_blend/blend_mesh.h>

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace cgal_blend {

/// Constrained Delaunay triangulation of a region of the plane between closed polygons, refined without touching them.
/// Predicates are exact. Vertices carry numbers of the caller's.
class Region_triangulation {
 public:
  using Point_2 = Kernel::Point_2;
  using Triangle = std::array<std::size_t, 3>;

  Region_triangulation();
  ~Region_triangulation();

  /// Adds a closed polygon; false if it crosses or touches what is there, or itself.
  [[nodiscard]] bool add_polygon(const std::vector<Point_2>& points, const std::vector<std::size_t>& ids);
  /// Adds a point; false if one is there.
  [[nodiscard]] bool add_point(const Point_2& point, std::size_t id);
  /// Marks what can be reached from the left side of the polygon added as the `index`-th one; its right side if `right`.
  void mark(std::size_t index, bool right);
  [[nodiscard]] bool is_bounded() const;
  [[nodiscard]] bool contains(const Point_2& point) const;
  /// Returns true if the region ends at the polygon.
  [[nodiscard]] bool ends_at(std::size_t index) const;

  /// Inserts circumcentres, or else midpoints of the longest edges, of triangles of the region that are bad or whose
  /// circumradius is more than sqrt(2) times the shortest edge, but none in the diametral circle of a polygon's edge.
  /// \param is_bad judges a triangle by its numbers
  /// \param add makes a vertex's number
  void refine(const std::function<bool(const Triangle&)>& is_bad,
              const std::function<std::size_t(const Point_2&)>& add);

  /// Returns the triangles of the region, counter-clockwise.
  [[nodiscard]] std::vector<Triangle> triangles() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cgal_blend

#endif
