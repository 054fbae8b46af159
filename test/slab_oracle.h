// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_TEST_SLAB_ORACLE_H
#define CGAL_BLEND_TEST_SLAB_ORACLE_H

#include "openings.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

// The topology of a transition by counting voxels: owes nothing to contours, meshes or the transition's own code.

namespace cgal_blend::test {

/// Voxels of the slab where Psi < 0, with a margin of half the rings' extent. Psi is put together per column from the openings
/// and their slopes by the Hermite basis, so that fine grids cost little.
class Voxels {
 public:
  Voxels(const std::array<Opening_sections, 2>& sides, double height, const Opening_model& model, std::size_t across) {
    CGAL::Bbox_2 box;
    for (const Opening_sections& side : sides)
      for (const Ring& ring : side.rings)
        for (const Point_2& p : ring) box += p.bbox();
    const double extent = std::max(box.x_span(), box.y_span()), step = 2 * extent / static_cast<double>(across);
    n_ = {static_cast<long>((box.x_span() + extent) / step) + 2, static_cast<long>((box.y_span() + extent) / step) + 2,
          std::max(24L, static_cast<long>(height / step)) + 2};
    marks_.assign(static_cast<std::size_t>(n_[0] * n_[1] * n_[2]), 0);
    std::array<Planar_function, 6> f;
    for (std::size_t i = 0; i < 2; ++i) {
      f[i] = model(sides[i].rings);
      f[2 + i] = model(*sides[i].above);
      f[4 + i] = model(*sides[i].below);
    }
    for (long x = 1; x + 1 < n_[0]; ++x)
      for (long y = 1; y + 1 < n_[1]; ++y) {
        const Point_2 p(box.xmin() - extent / 2 + (static_cast<double>(x) - 0.47) * step,
                        box.ymin() - extent / 2 + (static_cast<double>(y) - 0.53) * step);
        std::array<double, 4> g{f[0](p), f[1](p)};
        for (std::size_t i = 0; i < 2; ++i) g[2 + i] = height * (f[2 + i](p) - f[4 + i](p)) / (2 * sides[i].step);
        for (long z = 1; z + 1 < n_[2]; ++z) {
          const auto h = hermite_basis((static_cast<double>(z) - 0.5) / static_cast<double>(n_[2] - 2));
          mark(x, y, z) = h[0] * g[0] + h[1] * g[1] + h[2] * g[2] + h[3] * g[3] < 0;
        }
      }
  }

  /// Characteristic of the surface that rings bound, none of them within another; nothing if it leaves the grid.
  /// The border of a body M is the surface S with the openings A glued in: 2 chi(M) = chi(S) + chi(A).
  std::optional<long> surface_characteristic(std::size_t rings) {
    if (!keep_what_planes_bound()) return std::nullopt;
    return 2 * body_characteristic() - static_cast<long>(rings);
  }

 private:
  char& mark(long x, long y, long z) { return marks_[static_cast<std::size_t>((x * n_[1] + y) * n_[2] + z)]; }

  /// Floods voxels of a kind from (x, y, z); diagonally too if asked to.
  void flood(std::array<long, 3> seed, char from, char to, bool diagonally) {
    std::vector<std::array<long, 3>> stack{seed};
    mark(seed[0], seed[1], seed[2]) = to;
    while (!stack.empty()) {
      const auto [x, y, z] = stack.back();
      stack.pop_back();
      for (long k = 0; k < 27; ++k) {
        const long i = k % 3 - 1, j = k / 3 % 3 - 1, l = k / 9 - 1;
        if (!diagonally && i * i + j * j + l * l != 1) continue;
        if (x + i < 0 || y + j < 0 || z + l < 0 || x + i >= n_[0] || y + j >= n_[1] || z + l >= n_[2]) continue;
        if (char& m = mark(x + i, y + j, z + l); m == from) {
          m = to;
          stack.push_back({x + i, y + j, z + l});
        }
      }
    }
  }

  /// Drops floating bodies and fills bubbles. Returns false if a body leaves the grid sideways.
  bool keep_what_planes_bound() {
    flood({0, 0, 0}, 0, 2, false);  // the outside, the layers beyond the planes included
    for (char& m : marks_)
      if (m == 0) m = 1;
    for (long x = 1; x + 1 < n_[0]; ++x)
      for (long y = 1; y + 1 < n_[1]; ++y)
        for (const long z : {1L, n_[2] - 2})
          if (mark(x, y, z) == 1) flood({x, y, z}, 1, 3, true);
    for (char& m : marks_) m = m == 3;
    for (long x = 1; x + 1 < n_[0]; ++x)
      for (long z = 1; z + 1 < n_[2]; ++z)
        if (mark(x, 1, z) || mark(x, n_[1] - 2, z)) return false;
    for (long y = 1; y + 1 < n_[1]; ++y)
      for (long z = 1; z + 1 < n_[2]; ++z)
        if (mark(1, y, z) || mark(n_[0] - 2, y, z)) return false;
    return true;
  }

  static long bit(unsigned mask, unsigned i) { return static_cast<long>(mask >> i & 1U); }

  /// Vertices - edges + squares - cubes of the closed voxels.
  long body_characteristic() {
    long sum = 0;
    for (long x = 1; x < n_[0]; ++x)
      for (long y = 1; y < n_[1]; ++y)
        for (long z = 1; z < n_[2]; ++z)
          for (unsigned free = 0; free < 8; ++free) {  // the axes along which the cell extends
            bool any = false;
            for (unsigned low = 0; low < 8 && !any; ++low)
              any = (low & free) == 0 && mark(x - bit(low, 0), y - bit(low, 1), z - bit(low, 2)) != 0;
            const bool odd = (free ^ free >> 1U ^ free >> 2U) & 1U;
            if (any) sum += odd ? -1 : 1;
          }
    return sum;
  }

  std::array<long, 3> n_{};
  std::vector<char> marks_;
};

/// Nothing where two grids disagree or where the body leaves them.
inline std::optional<long> characteristic_by_voxels(const std::array<Opening_sections, 2>& sides, double height,
                                                    const Opening_model& model, std::size_t across) {
  const std::size_t rings = sides[0].rings.size() + sides[1].rings.size();
  const auto coarse = Voxels(sides, height, model, across).surface_characteristic(rings);
  const auto fine = Voxels(sides, height, model, across * 3 / 2).surface_characteristic(rings);
  return coarse == fine ? fine : std::nullopt;
}

}  // namespace cgal_blend::test

#endif
