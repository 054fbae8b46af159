// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_BRIDGE_GRID_H
#define CGAL_BLEND_SRC_BRIDGE_GRID_H

#include "bridge_side.h"
#include "bridge_surface.h"

#include <array>
#include <vector>

namespace cgal_blend {

/// A bridge's surface, sampled: columns at parameters s, rows at t from 0 to 1.
class Bridge_grid {
 public:
  /// Chooses the columns. \param sides live as long as the grid
  Bridge_grid(const std::array<const Bridge_side*, 2>& sides, double turn, const Bridge_shape& shape,
              const Bridge_options& options);

  /// Turns the second end; rays of the first end that are needed again are kept.
  void turn_to(double turn, const Bridge_shape& shape);

  /// Evaluates all points, on rows that are chosen anew if the tolerance decides.
  void evaluate(const Bridge_shape& shape);

  [[nodiscard]] Bridge_column column(double s) const;
  /// The columns next to a parameter, and how far it is from the one to the other, in [0, 1].
  struct Between {
    std::size_t low, high;
    double part;
  };
  [[nodiscard]] Between between_columns(double s) const;
  /// Point of the surface on the ray of an end that starts in a vertex of its rim; of the other end's base surface it
  /// takes what is halfway between columns, which counts for little near the rim.
  /// \param s parameter of the bridge; `place` of the vertex
  [[nodiscard]] Vec point_from_rim(std::size_t end, double s, double t, const Vec& place) const;
  [[nodiscard]] const std::vector<double>& s() const { return s_; }
  [[nodiscard]] const std::vector<double>& t() const { return t_; }
  /// Row by row, t().size() x s().size().
  [[nodiscard]] const std::vector<Point_3>& points() const { return points_; }
  [[nodiscard]] double turn() const { return turn_; }
  /// Larger of the contacts' sizes.
  [[nodiscard]] double size() const { return size_; }
  [[nodiscard]] const Bridge_side& side(std::size_t end) const { return *sides_[end]; }

 private:
  void choose_columns(const Bridge_shape& shape);
  [[nodiscard]] const Bridge_ray* ray_before(double s) const;
  void choose_rows(const Bridge_shape& shape);
  [[nodiscard]] bool fine_enough(double from, double to, const Bridge_shape& shape) const;

  std::array<const Bridge_side*, 2> sides_;
  double turn_, size_, tolerance_;
  std::size_t segments_, rows_;  // asked for; 0: by the tolerance
  std::vector<double> s_, t_;
  std::vector<Bridge_column> columns_;
  std::vector<double> s_before_;  // before the last turn, with the first end's rays
  std::vector<Bridge_column> columns_before_;
  std::vector<Point_3> points_;
  Bridge_shape shape_;  // of the points
};

}  // namespace cgal_blend

#endif
