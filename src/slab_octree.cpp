// SPDX-License-Identifier: GPL-3.0-or-later
#include "slab_octree.h"

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>

namespace cgal_blend {

namespace {

constexpr double cell_over_edge = 2;  // side of a cell against the edges wanted; tetrahedra are about half as wide
constexpr std::int64_t most_units = std::int64_t{1} << 20;

}  // namespace

Slab_octree::Slab_octree(const Hermite_transition& psi, const Slab_sizing& sizing, const Contour_options& options)
    : sizing_(sizing), height_(psi.height()), fineness_(options.fineness), gap_(options.gap) {
  CGAL::Bbox_2 box;
  for (const std::size_t side : {0, 1})
    for (const Ring& ring : psi.rings(side))
      for (const Point_2& p : ring) box += p.bbox();
  const double width = std::max(box.xmax() - box.xmin(), box.ymax() - box.ymin()), margin = std::max(width, height_);
  const double side = std::min({cell_over_edge * sizing_.largest() / fineness_, width / 4, 4 * height_});
  const double cells_z = std::max(1.0, std::round(height_ / side));
  const double cells_x = std::ceil((width + 2 * margin) / side);
  const double smallest = cell_over_edge * sizing_.smallest() / fineness_;
  for (root_ = 2; side / static_cast<double>(root_ / 2) > smallest; root_ *= 2)
    if (static_cast<double>(2 * root_) * std::max(cells_x, cells_z) > static_cast<double>(most_units)) break;
  unit_ = side / static_cast<double>(root_);
  unit_z_ = 1 / (cells_z * static_cast<double>(root_));
  x_ = (box.xmin() + box.xmax() - cells_x * side) / 2;
  y_ = (box.ymin() + box.ymax() - cells_x * side) / 2;
  const std::int64_t across = static_cast<std::int64_t>(cells_x) * root_;
  limits_ = {across, across, static_cast<std::int64_t>(cells_z) * root_};
}

std::array<double, 2> Slab_octree::gaps(const Point_2& p) const {
  std::array<double, 2> gaps{};
  for (const std::size_t side : {0, 1}) gaps[side] = std::min(gap_ * sizing_.at_plane(side, p), height_ / 4);
  return gaps;
}

Point_3 Slab_octree::place(const Lattice_point& p) const {
  const Point_2 q(x_ + static_cast<double>(p[0]) * unit_, y_ + static_cast<double>(p[1]) * unit_);
  const auto [low, high] = gaps(q);
  return {q.x(), q.y(), low + static_cast<double>(p[2]) * unit_z_ * (height_ - low - high)};
}

bool Slab_octree::contains(const Lattice_point& p) const {
  for (std::size_t i = 0; i < 3; ++i)
    if (p[i] < 0 || p[i] >= limits_[i]) return false;
  return true;
}

bool Slab_octree::divided(const Lattice_cell& cell) const {
  if (cell.side <= 2 || !contains(cell.corner)) return false;
  const auto [entry, fresh] = divided_.try_emplace(key_of(cell.centre()), 0);  // no two cells share a centre
  if (fresh) entry->second = side_length(cell) > cell_over_edge / fineness_ * sizing_(place(cell.centre()));
  return entry->second != 0;
}

Lattice_cell Slab_octree::root_of(const Lattice_point& p) const {
  return {{p[0] / root_ * root_, p[1] / root_ * root_, p[2] / root_ * root_}, root_};
}

Lattice_cell Slab_octree::leaf_around(const Lattice_cell& cell) const {
  Lattice_cell leaf = root_of(cell.corner);
  while (leaf.side > cell.side && divided(leaf)) {
    leaf.side /= 2;
    for (std::size_t i = 0; i < 3; ++i) leaf.corner[i] = cell.corner[i] / leaf.side * leaf.side;
  }
  return leaf;
}

Lattice_cell Slab_octree::leaf_at_end(std::size_t end, const Point_2& p) const {
  const auto index = [](double x) { return static_cast<std::int64_t>(std::floor(x)); };
  const Lattice_point q{index((p.x() - x_) / unit_), index((p.y() - y_) / unit_), end == 0 ? 0 : limits_[2] - 1};
  return leaf_around({{q[0] / 2 * 2, q[1] / 2 * 2, q[2] / 2 * 2}, 2});
}

}  // namespace cgal_blend
