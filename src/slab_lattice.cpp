// SPDX-License-Identifier: GPL-3.0-or-later
#include "slab_lattice.h"

#include "slab_octree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace cgal_blend {

namespace {

/// A square face of the octree, as small as the smaller of its two cells: corners counterclockwise seen from outside.
struct Square {
  std::array<Lattice_point, 4> corners;
  Lattice_cell beyond;  ///< the cell of the same size on the other side
};

Lattice_point middle(const Lattice_point& a, const Lattice_point& b) {
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}

/// The square of side `s` with least corner `p` across an axis, facing up or down the axis.
Square square(const Lattice_point& p, std::int64_t s, std::size_t axis, bool up) {
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  Square result{{p, p, p, p}, {p, s}};
  result.corners[1][u] += s;
  result.corners[2][u] += s;
  result.corners[2][v] += s;
  result.corners[3][v] += s;
  if (!up) std::swap(result.corners[1], result.corners[3]);
  if (!up) result.beyond.corner[axis] -= s;
  return result;
}

class Contour {
 public:
  Contour(const Hermite_transition& psi, const Slab_sizing& cells, const Contour_options& options)
      : psi_(psi), options_(options), octree_(psi, cells, options) {}

  Slab_contour run() {
    for (const std::size_t side : {0, 1})
      for (const Ring& ring : psi_.rings(side)) seed(side, ring);
    while (!waiting_.empty() && !result_.escape) {
      const Lattice_cell cell = waiting_.back();
      waiting_.pop_back();
      march(cell);
      if (seen_.size() > options_.most_cells) {
        result_.escape = octree_.place(cell.centre());
        result_.exhausted = true;
      }
    }
    result_.cells = seen_.size();
    return std::move(result_);
  }

 private:
  struct Sample {
    std::size_t id;
    double value;
  };

  /// Queues the cells over a ring and those around them: the surface has moved a little at the end of the lattice.
  void seed(std::size_t side, const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point_2 a = ring[i], b = ring[(i + 1) % ring.size()];
      for (double t = 0; t < 1;) {
        const Lattice_cell cell = octree_.leaf_at_end(side, a + t * (b - a));
        for (const std::int64_t x : {-1, 0, 1})
          for (const std::int64_t y : {-1, 0, 1}) wait({cell.at(x * cell.side, y * cell.side, 0), cell.side});
        t += octree_.side_length(cell) / std::sqrt(CGAL::squared_distance(a, b));
      }
    }
  }

  /// Queues the leaf around a cell, or those within it.
  void wait(const Lattice_cell& cell) {
    if (!octree_.contains(cell.corner)) return;
    const Lattice_cell leaf = octree_.leaf_around(cell);
    if (octree_.divided(leaf)) {
      const std::int64_t half = leaf.side / 2;
      for (int i = 0; i < 8; ++i) wait({leaf.at(i & 1 ? half : 0, i & 2 ? half : 0, i & 4 ? half : 0), half});
    } else if (seen_.insert(key_of(leaf.centre())).second) {
      waiting_.push_back(leaf);
    }
  }

  const Sample& sample(const Lattice_point& p) {
    const auto [entry, fresh] = samples_.try_emplace(key_of(p));
    if (fresh) {
      places_.push_back(octree_.place(p));
      height_of_.push_back(p[2]);
      entry->second = {places_.size() - 1, psi_(places_.back())};
    }
    return entry->second;
  }

  std::vector<Square> faces_of(const Lattice_cell& cell) const {
    std::vector<Square> faces;
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const bool up : {false, true}) {
        Lattice_point p = cell.corner;
        if (up) p[axis] += cell.side;
        const Square whole = square(p, cell.side, axis, up);
        if (!octree_.divided(whole.beyond)) {
          faces.push_back(whole);
          continue;
        }
        const std::int64_t half = cell.side / 2;
        for (const std::int64_t i : {std::int64_t{0}, half})
          for (const std::int64_t j : {std::int64_t{0}, half}) {
            Lattice_point q = p;
            q[(axis + 1) % 3] += i;
            q[(axis + 2) % 3] += j;
            faces.push_back(square(q, half, axis, up));
          }
      }
    return faces;
  }

  /// True if one of the four cells around an edge of its length is divided: then the edge's middle is a vertex.
  bool edge_divided(const Lattice_point& a, const Lattice_point& b) const {
    std::size_t axis = 0;
    while (a[axis] == b[axis]) ++axis;
    const std::int64_t side = std::abs(a[axis] - b[axis]);
    Lattice_point low = std::min(a, b);
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const std::int64_t i : {std::int64_t{0}, side})
      for (const std::int64_t j : {std::int64_t{0}, side}) {
        Lattice_point corner = low;
        corner[u] -= i;
        corner[v] -= j;
        if (octree_.divided({corner, side})) return true;
      }
    return false;
  }

  void march(const Lattice_cell& cell) {
    const Lattice_point centre = cell.centre();
    for (const Square& face : faces_of(cell)) {
      const Lattice_point face_centre = middle(face.corners[0], face.corners[2]);
      bool below = false, above = false;
      const auto note = [&](const Lattice_point& p) { (sample(p).value < 0 ? below : above) = true; };
      note(face_centre);
      for (std::size_t i = 0; i < 4; ++i) {
        const Lattice_point &a = face.corners[i], &b = face.corners[(i + 1) % 4];
        note(a);
        if (edge_divided(a, b)) {
          const Lattice_point m = middle(a, b);
          note(m);
          cut({a, m, face_centre, centre});
          cut({m, b, face_centre, centre});
        } else {
          cut({a, b, face_centre, centre});
        }
      }
      if (below && above) leave_through(face);
    }
  }

  void leave_through(const Square& face) {
    const Lattice_point& p = face.beyond.corner;
    if (octree_.contains(p)) return wait(face.beyond);
    if (p[2] >= 0 && p[2] < octree_.top()) result_.escape = octree_.place(face.corners[0]);
  }

  /// The part of the surface in a tetrahedron whose first three corners run counterclockwise seen against the fourth.
  void cut(const std::array<Lattice_point, 4>& tetrahedron) {
    std::array<Sample, 4> s{};
    for (std::size_t i = 0; i < 4; ++i) s[i] = sample(tetrahedron[i]);
    std::array<std::size_t, 4> order{0, 1, 2, 3};
    const auto negative = [&](std::size_t i) { return s[i].value < 0; };
    const auto inside = std::count_if(order.begin(), order.end(), negative);
    if (inside == 0 || inside == 4) return;
    std::stable_partition(order.begin(), order.end(), negative);
    bool odd = false;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) odd ^= order[i] > order[j];
    if (odd) std::swap(order[inside == 3 ? 0 : 2], order[inside == 3 ? 1 : 3]);
    const auto at = [&](std::size_t i, std::size_t j) { return crossing(s[order[i]], s[order[j]]); };
    if (inside == 1) {
      add(at(0, 1), at(0, 3), at(0, 2));
    } else if (inside == 3) {
      add(at(0, 3), at(2, 3), at(1, 3));
    } else {
      const std::size_t a = at(0, 2), b = at(0, 3), c = at(1, 3), d = at(1, 2);
      add(a, c, b);
      add(a, d, c);
    }
  }

  void add(std::size_t a, std::size_t b, std::size_t c) { result_.triangles.push_back({a, b, c}); }

  std::size_t crossing(const Sample& below, const Sample& above) {
    const std::uint64_t key = static_cast<std::uint64_t>(below.id) << 32 | above.id;
    const auto [entry, fresh] = crossings_.try_emplace(key, result_.points.size());
    if (fresh) {
      result_.points.push_back(zero_between(places_[below.id], below.value, places_[above.id], above.value));
      result_.border.push_back(border(height_of_[below.id], height_of_[above.id]));
    }
    return entry->second;
  }

  /// Not too near the ends, or the triangles there have no area. Linear interpolation alone would leave the vertices of
  /// coarse cells so far from the surface that no projection finds back.
  Point_3 zero_between(const Point_3& p, double at_p, const Point_3& q, double at_q) const {
    const Vector_3 d = q - p;
    double low = 0, high = 1, t = at_p / (at_p - at_q);
    const double enough = 0.01 * std::min(-at_p, at_q);
    for (int i = 0; i < (options_.topology_only ? 0 : 8); ++i) {
      const double value = psi_(p + t * d);
      if (std::abs(value) <= enough) break;
      (value < 0 ? low : high) = t;
      (value < 0 ? at_p : at_q) = value;
      t = i % 3 == 2 ? (low + high) / 2 : low + (high - low) * at_p / (at_p - at_q);
    }
    return p + std::clamp(t, 0.02, 0.98) * d;
  }

  Slab_contour::Border border(std::int64_t a, std::int64_t b) const {
    if (a != b) return Slab_contour::Border::none;
    if (a == 0) return Slab_contour::Border::lower;
    return a == octree_.top() ? Slab_contour::Border::upper : Slab_contour::Border::none;
  }

  const Hermite_transition& psi_;
  const Contour_options& options_;
  Slab_octree octree_;
  std::vector<Lattice_cell> waiting_;
  std::unordered_set<std::uint64_t> seen_;
  std::unordered_map<std::uint64_t, Sample> samples_;
  std::unordered_map<std::uint64_t, std::size_t> crossings_;
  std::vector<Point_3> places_;
  std::vector<std::int64_t> height_of_;  ///< of the places, in units of the lattice
  Slab_contour result_;
};

}  // namespace

Slab_contour contour_slab(const Hermite_transition& psi, const Slab_sizing& cells, const Contour_options& options) {
  return Contour(psi, cells, options).run();
}

}  // namespace cgal_blend
