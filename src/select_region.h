// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_SELECT_REGION_H
#define CGAL_BLEND_SRC_SELECT_REGION_H

#include "region_mesh.h"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace cgal_blend {

/// A closed polyline, or a point, in space, with boxes around ever smaller parts of it.
class Near_polyline {
 public:
  explicit Near_polyline(const std::vector<Vec>& points);

  /// Whether a triangle may be nearer than a distance: never false where it is, and of a single point exactly.
  [[nodiscard]] bool operator()(const std::array<Vec, 3>& triangle, double distance) const;

 private:
  [[nodiscard]] bool meets(std::size_t node, const CGAL::Bbox_3& box, double squared) const;

  std::vector<Vec> points_;
  std::vector<CGAL::Bbox_3> boxes_;  // a heap: the parts of node i are 2 i + 1 and 2 i + 2
};

/// What geodesics from a source can meet.
struct Selection {
  double length;            ///< of edges at most, after refinement; what meets the disk ends within one of it
  double limit;             ///< distance that the triangles are needed for: the radius and two lengths
  std::int32_t first_long;  ///< triangles before this one have no longer edges
};

/// Adds the triangles within a distance of a source to a region: straight lines are not longer than geodesics.
[[nodiscard]] Selection select_region(Region_mesh& region, Face first, const Near_polyline& near_source, double radius,
                                      bool fills_holes);

/// Makes a place a vertex of the region, and returns it.
[[nodiscard]] std::int32_t insert_place(Region_mesh& region, const Face_point& at);

}  // namespace cgal_blend

#endif
