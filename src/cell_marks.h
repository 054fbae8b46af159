// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_CELL_MARKS_H
#define CGAL_BLEND_SRC_CELL_MARKS_H

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace cgal_blend::internal {

/// So many cells along each axis are a few faces wide; more would cost more than they spare.
inline int cells_for(std::size_t faces) {
  return static_cast<int>(std::clamp(std::sqrt(static_cast<double>(faces)) / 4, 4.0, 128.0));
}

/// A coarse grid that counts given boxes per cell; tells in constant time whether another box meets a cell in use.
/// Boxes enter as the corners of a sum over cells and leave as sums, so that large ones cost no more than small ones.
class Cell_marks {
 public:
  Cell_marks(const std::vector<CGAL::Bbox_3>& boxes, int cells)
      : cells_(cells), size_(cells + 1), sums_(static_cast<std::size_t>(size_) * size_ * size_, 0) {
    for (const CGAL::Bbox_3& box : boxes) extent_ += box;
    for (int k = 0; k < 3; ++k) {
      const double width = extent_.max(k) - extent_.min(k);
      scale_[k] = width > 0 ? cells / width : 0;
    }
    for (const CGAL::Bbox_3& box : boxes) each_corner(box, [&](std::size_t at, int sign) { sums_[at] += sign; });
    sum_up();  // now the number of boxes per cell
    for (std::int32_t& sum : sums_) sum = sum > 0;
    shift();
    sum_up();  // now the number of cells in use, from the origin on
  }

  [[nodiscard]] bool meets(const CGAL::Bbox_3& box) const {
    if (!CGAL::do_overlap(box, extent_)) return false;
    std::int32_t used = 0;
    each_corner(box, [&](std::size_t at, int sign) { used -= sign * sums_[at]; });
    return used > 0;
  }

 private:
  [[nodiscard]] std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * size_ + y) * size_ + x;
  }

  [[nodiscard]] int cell(double x, int axis) const {
    return static_cast<int>(std::clamp((x - extent_.min(axis)) * scale_[axis], 0.0, cells_ - 1.0));
  }

  /// Visits the eight corners of a block of cells, the low one included and the high one beyond, with the signs that a
  /// block has in a sum over cells: + for the low corner, changing along every edge.
  template <class Visit>
  void each_corner(const CGAL::Bbox_3& box, Visit&& visit) const {
    int at[2][3];
    for (int k = 0; k < 3; ++k) {
      at[0][k] = cell(box.min(k), k);
      at[1][k] = cell(box.max(k), k) + 1;
    }
    for (int z = 0; z < 2; ++z)
      for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 2; ++x) visit(index(at[x][0], at[y][1], at[z][2]), (x + y + z) % 2 == 0 ? 1 : -1);
  }

  /// Moves all values one cell up along each axis: sums then exclude the cell that they stand at.
  void shift() {
    for (std::size_t i = sums_.size(), step = index(1, 1, 1); i-- > 0;) sums_[i] = i >= step ? sums_[i - step] : 0;
  }

  void sum_up() {
    const std::size_t steps[] = {1, static_cast<std::size_t>(size_), static_cast<std::size_t>(size_) * size_};
    for (int axis = 0; axis < 3; ++axis)
      for (int z = axis == 2; z < size_; ++z)
        for (int y = axis == 1; y < size_; ++y) {
          std::int32_t* row = &sums_[index(0, y, z)];
          for (int x = axis == 0; x < size_; ++x) row[x] += *(row + x - steps[axis]);
        }
  }

  int cells_, size_;  // one plane more than cells, for the sums
  std::vector<std::int32_t> sums_;
  CGAL::Bbox_3 extent_;
  double scale_[3];
};

}  // namespace cgal_blend::internal

#endif
