// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_formats.h"

#include <CGAL/enum.h>

#include <cmath>
#include <limits>

// Ear clipping rather than CGAL's triangulation of faces: that one prints warnings about polygons that cross
// themselves, and relies on preconditions that are compiled out where it matters.

namespace cgal_blend::internal {

namespace {

using Point_2 = Kernel::Point_2;

/// Sum of the cross products along a closed polygon: its area vector, twice.
Vector_3 area_vector(const std::vector<Point_3>& points, const std::uint32_t* polygon, std::size_t size) {
  const Point_3& origin = points[polygon[0]];
  Vector_3 sum(0, 0, 0);
  for (std::size_t i = 1; i + 1 < size; ++i)
    sum = sum + CGAL::cross_product(points[polygon[i]] - origin, points[polygon[i + 1]] - origin);
  return sum;
}

/// Corners in the coordinate plane that sees most of the polygon, from the side on which it runs counter-clockwise.
std::vector<Point_2> project(const std::vector<Point_3>& points, const std::uint32_t* polygon, std::size_t size) {
  const Vector_3 area = area_vector(points, polygon, size);
  int axis = 0;
  for (int k = 1; k < 3; ++k)
    if (std::abs(area[k]) > std::abs(area[axis])) axis = k;
  int u = (axis + 1) % 3, v = (axis + 2) % 3;
  if (area[axis] < 0) std::swap(u, v);
  std::vector<Point_2> projected;
  for (std::size_t i = 0; i < size; ++i) projected.emplace_back(points[polygon[i]][u], points[polygon[i]][v]);
  return projected;
}

/// Cuts one ear after another off a polygon, the one with the shortest cut first.
class Ear_clipper {
 public:
  explicit Ear_clipper(std::vector<Point_2> corners) : corners_(std::move(corners)), is_ear_(corners_.size()) {
    for (std::size_t i = 0; i < corners_.size(); ++i) left_.push_back(i);
    find_ears();
  }

  /// Calls `cut(i, j, k)` for every triangle, with indices of corners.
  template <class Cut>
  void clip(Cut&& cut) {
    while (left_.size() > 3) {
      std::size_t at = best_ear();
      if (at == left_.size()) {
        find_ears();  // a corner that stood in the way of an ear may be gone
        at = best_ear();
      }
      if (at == left_.size()) at = 1;  // no simple polygon; validation will judge what comes of it
      cut(left_[before(at)], left_[at], left_[after(at)]);
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(at));
      const std::size_t next = at % left_.size();
      for (const std::size_t i : {before(next), next}) is_ear_[left_[i]] = test_ear(i);
    }
    cut(left_[0], left_[1], left_[2]);
  }

 private:
  [[nodiscard]] std::size_t before(std::size_t i) const { return (i + left_.size() - 1) % left_.size(); }
  [[nodiscard]] std::size_t after(std::size_t i) const { return (i + 1) % left_.size(); }
  [[nodiscard]] const Point_2& corner(std::size_t i) const { return corners_[left_[i]]; }

  void find_ears() {
    for (std::size_t i = 0; i < left_.size(); ++i) is_ear_[left_[i]] = test_ear(i);
  }

  /// Convex, and no other corner in the way. One at the place of a corner of the ear (a bridge to a hole) is not.
  [[nodiscard]] bool test_ear(std::size_t i) const {
    const Point_2 &p = corner(before(i)), &q = corner(i), &r = corner(after(i));
    if (CGAL::orientation(p, q, r) != CGAL::LEFT_TURN) return false;
    for (const std::size_t other : left_) {
      const Point_2& x = corners_[other];
      if (x == p || x == q || x == r) continue;
      if (CGAL::orientation(p, q, x) != CGAL::RIGHT_TURN && CGAL::orientation(q, r, x) != CGAL::RIGHT_TURN &&
          CGAL::orientation(r, p, x) != CGAL::RIGHT_TURN)
        return false;
    }
    return true;
  }

  [[nodiscard]] std::size_t best_ear() const {
    std::size_t best = left_.size();
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < left_.size(); ++i) {
      if (!is_ear_[left_[i]]) continue;
      const double cut = CGAL::squared_distance(corner(before(i)), corner(after(i)));
      if (cut < shortest || best == left_.size()) {
        best = i;
        shortest = cut;
      }
    }
    return best;
  }

  std::vector<Point_2> corners_;
  std::vector<char> is_ear_;       // by corner
  std::vector<std::size_t> left_;  // corners not yet cut off, in order
};

}  // namespace

void triangulate_polygon(const std::vector<Point_3>& points, const std::uint32_t* polygon, std::size_t size,
                         std::vector<std::uint32_t>& triangles) {
  const auto cut = [&](std::size_t i, std::size_t j, std::size_t k) {
    triangles.insert(triangles.end(), {polygon[i], polygon[j], polygon[k]});
  };
  if (size == 3) return cut(0, 1, 2);
  Ear_clipper(project(points, polygon, size)).clip(cut);
}

}  // namespace cgal_blend::internal
