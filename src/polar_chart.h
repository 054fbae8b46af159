// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_POLAR_CHART_H
#define CGAL_BLEND_SRC_POLAR_CHART_H

#include "geodesic_field.h"
#include "region_mesh.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace cgal_blend {

/// Which plane a region lies over.
enum class Chart_kind {
  disk,  ///< around a point: vertices at (d cos a, d sin a), so that the chart of a plane is exact
  band   ///< along a curve: vertices at (a, d), periodic in a, so that the chart along a straight line is exact
};

/// Height of triangles that may be turned over: coordinates are not certain by more than this there. Along a curve such
/// triangles are the rule, where it runs near vertices and edges.
[[nodiscard]] double thin_height(Chart_kind kind, double radius);

/// A region laid out by its polar coordinates; its triangles are straight in the plane of the chart.
class Polar_chart {
 public:
  using Point = Kernel::Point_2;

  Polar_chart(const Region_mesh& region, const Geodesic_field& field, Chart_kind kind, double radius, double limit);

  /// Where the chart stops to be one to one, and why.
  struct Bound {
    double fold;                                ///< distance of the nearest fold or overlap; infinite: none
    double border;                              ///< distance of the nearest border of the mesh; infinite: none
    std::int32_t fold_at = -1, border_at = -1;  ///< vertices there
  };
  [[nodiscard]] const Bound& bound() const { return bound_; }
  /// All of the disk of the radius is covered once.
  [[nodiscard]] bool is_one_to_one() const { return bound_.fold >= radius_ && bound_.border >= radius_; }

  [[nodiscard]] bool covers(std::int32_t triangle) const { return triangle >= 0 && used_[triangle]; }
  [[nodiscard]] Polar_point at(const Region_mesh::Place& place) const;
  [[nodiscard]] std::optional<Region_mesh::Place> locate(const Polar_point& at) const;

  /// Sorts the triangles into a grid for `locate`.
  void index();

 private:
  [[nodiscard]] bool is_reached(std::int32_t triangle) const;
  [[nodiscard]] double nearest(std::int32_t triangle) const;
  [[nodiscard]] bool is_upright(std::int32_t triangle) const;
  void find_folds();
  void find_rim();
  [[nodiscard]] bool is_upright_in_band(std::int32_t triangle) const;
  [[nodiscard]] std::array<Point, 3> corners(std::int32_t triangle) const;
  [[nodiscard]] std::array<int, 4> cells_around(std::int32_t triangle) const;
  template <class Visitor>
  void for_cells(const std::array<int, 4>& around, const Visitor& visit) const;
  [[nodiscard]] std::array<int, 2> cell(const Point& p) const;

  const Region_mesh& region_;
  const Geodesic_field& field_;
  Chart_kind kind_;
  double radius_, limit_;
  std::vector<Point> points_;  // by vertex
  std::vector<char> used_;     // by triangle
  Bound bound_;
  // Grid: the triangles that meet cell c are cell_triangles_[cell_begin_[c] .. cell_begin_[c + 1]).
  int cells_ = 0;  // in each direction
  std::vector<std::int32_t> cell_begin_, cell_triangles_;
};

}  // namespace cgal_blend

#endif
