// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_SLAB_OCTREE_H
#define CGAL_BLEND_SRC_SLAB_OCTREE_H

#include "slab_lattice.h"

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace cgal_blend {

/// A place in an octree, in units of half a smallest cell.
using Lattice_point = std::array<std::int64_t, 3>;

/// Cell of an octree: its least corner and its side.
struct Lattice_cell {
  Lattice_point corner{};
  std::int64_t side = 0;

  [[nodiscard]] Lattice_point at(std::int64_t x, std::int64_t y, std::int64_t z) const {
    return {corner[0] + x, corner[1] + y, corner[2] + z};
  }
  [[nodiscard]] Lattice_point centre() const { return at(side / 2, side / 2, side / 2); }
  friend bool operator==(const Lattice_cell& a, const Lattice_cell& b) {
    return a.corner == b.corner && a.side == b.side;
  }
};

/// Packs a place into a key; each coordinate is in [0, 2^21).
[[nodiscard]] inline std::uint64_t key_of(const Lattice_point& p) {
  return static_cast<std::uint64_t>(p[0]) << 42 | static_cast<std::uint64_t>(p[1]) << 21 |
         static_cast<std::uint64_t>(p[2]);
}

/// An octree over the slab that is nowhere stored: a cell is divided if its centre's edge length says so. As that grows
/// slowly, cells that touch differ by one level at most. Its ends keep a gap from the planes that varies with the place.
class Slab_octree {
 public:
  Slab_octree(const Hermite_transition& psi, const Slab_sizing& sizing, const Contour_options& options);

  [[nodiscard]] Point_3 place(const Lattice_point& p) const;
  [[nodiscard]] bool contains(const Lattice_point& p) const;
  /// True if a cell of the tree's scheme is divided; cells outside are not.
  [[nodiscard]] bool divided(const Lattice_cell& cell) const;
  /// The leaf that holds a cell of the scheme, or, if that one is divided, the cell itself.
  [[nodiscard]] Lattice_cell leaf_around(const Lattice_cell& cell) const;
  /// The leaf at an end (0: lower, 1: upper) over a point of the plane.
  [[nodiscard]] Lattice_cell leaf_at_end(std::size_t end, const Point_2& p) const;
  /// Corner-to-corner size of a leaf there, length units.
  [[nodiscard]] double side_length(const Lattice_cell& cell) const { return static_cast<double>(cell.side) * unit_; }
  [[nodiscard]] std::int64_t top() const { return limits_[2]; }

 private:
  [[nodiscard]] Lattice_cell root_of(const Lattice_point& p) const;
  [[nodiscard]] std::array<double, 2> gaps(const Point_2& p) const;

  const Slab_sizing& sizing_;
  double height_, fineness_, gap_;
  double x_ = 0, y_ = 0;          ///< least corner
  double unit_ = 1, unit_z_ = 1;  ///< lengths of the units across and along the slab
  std::int64_t root_ = 2;         ///< side of the undivided cells
  Lattice_point limits_{};
  mutable std::unordered_map<std::uint64_t, char> divided_;
};

}  // namespace cgal_blend

#endif
