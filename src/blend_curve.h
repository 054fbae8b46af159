// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_BLEND_CURVE_H
#define CGAL_BLEND_SRC_BLEND_CURVE_H

#include "base_surface.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace cgal_blend {

/// A blending curve as a polyline; edge i runs from points[i] to points[i + 1], or to points[0] at the end of a closed
/// curve. Side 0 is left of the curve, side 1 right of it, seen from outside the solid.
struct Blend_curve {
  bool closed = true;
  std::vector<Vec> points;  ///< one per edge; one more if open
  std::vector<std::array<Face, 2>> faces;  ///< per edge: the base face on either side
  bool convex = false;                     ///< true: the ball rolls inside the solid
  std::array<double, 2> overhang{};        ///< open: how far the ball rolls on beyond first and last point

  [[nodiscard]] std::size_t next(std::size_t i) const { return i + 1 == points.size() ? 0 : i + 1; }
};

/// Distance of a point from the segment a b.
[[nodiscard]] double off_segment(const Vec& a, const Vec& b, const Vec& p);

/// Nearest points on a closed polyline.
class Curve_locator {
 public:
  struct Nearest {
    std::size_t segment;
    double arc_length;  ///< from points[0] along the curve
    double squared_distance;
  };

  explicit Curve_locator(const std::vector<Vec>& closed_polyline);
  ~Curve_locator();
  Curve_locator(Curve_locator&&) noexcept;

  [[nodiscard]] Nearest nearest(const Vec& p) const;

  /// The same, faster where `hint` is a segment that is near.
  [[nodiscard]] Nearest nearest(const Vec& p, std::size_t hint) const;
  [[nodiscard]] double length() const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace cgal_blend

#endif
