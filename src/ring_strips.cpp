// SPDX-License-Identifier: GPL-3.0-or-later
#include "ring_strips.h"

#include "segment_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cgal_blend {

namespace {

using Border = Slab_contour::Border;
using Loop = std::vector<std::size_t>;
constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// The borders of an oriented surface, in the direction of their triangles.
std::vector<Loop> border_loops(const Slab_contour& contour) {
  // A border edge has both ends at an end of the lattice, but an edge across a dent may too: twins cancel.
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for (const auto& t : contour.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      if (const std::size_t a = t[i], b = t[(i + 1) % 3];
          contour.border[a] != Border::none && contour.border[a] == contour.border[b])
        edges.emplace_back(a, b);
  std::sort(edges.begin(), edges.end());
  std::vector<std::size_t> next(contour.points.size(), none);
  for (const auto& [a, b] : edges)
    if (!std::binary_search(edges.begin(), edges.end(), std::pair(b, a))) next[a] = b;
  std::vector<Loop> loops;
  for (std::size_t v = 0; v < next.size(); ++v) {
    if (next[v] == none) continue;
    Loop loop;
    for (std::size_t w = v; w != none && next[w] != none;) {
      loop.push_back(w);
      w = std::exchange(next[w], none);
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

/// The sides of a ring with their arc lengths.
struct Measured_ring {
  std::size_t first_vertex = 0;  ///< in the joined mesh
  std::vector<double> arc;       ///< of the vertices; one more for the whole
};

/// The rings of a side, and where a point is along them.
class Ring_places {
 public:
  Ring_places(const std::vector<Ring>& rings, std::size_t first_vertex) : sides_(sides_of(rings)), tree_(sides_) {
    for (const Ring& ring : rings) {
      Measured_ring measured{first_vertex, {0}};
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const double side = std::sqrt(CGAL::squared_distance(ring[i], ring[(i + 1) % ring.size()]));
        measured.arc.push_back(measured.arc.back() + side);
        place_.emplace_back(rings_.size(), i);
      }
      first_vertex += ring.size();
      rings_.push_back(std::move(measured));
    }
  }

  struct Place {
    std::size_t ring;
    double arc;
  };
  [[nodiscard]] Place nearest(const Point_2& p) const {
    const std::size_t side = tree_.nearest(p);
    const auto& [ring, i] = place_[side];
    const auto d = sides_[side].target - sides_[side].source;
    const double t = std::clamp((p - sides_[side].source) * d / d.squared_length(), 0.0, 1.0);
    const auto& arc = rings_[ring].arc;
    return {ring, arc[i] + t * (arc[i + 1] - arc[i])};
  }
  [[nodiscard]] const std::vector<Measured_ring>& rings() const { return rings_; }

 private:
  std::vector<Weighted_segment> sides_;
  Segment_tree tree_;
  std::vector<std::pair<std::size_t, std::size_t>> place_;  ///< of the sides: ring and index in it
  std::vector<Measured_ring> rings_;
};

/// A closed sequence of vertices with increasing places on a ring of a given length.
struct Row {
  std::vector<std::size_t> vertices;
  std::vector<double> places;
};

/// Unwraps places around a ring; returns the turns made (1 or -1 for a loop that runs along it once).
int unwrap(std::vector<double>& places, double length) {
  const double first = places.front();
  double turned = 0;
  double previous = first;
  for (std::size_t i = 1; i <= places.size(); ++i) {
    const double raw = i < places.size() ? places[i] : first;
    const double step = std::remainder(raw - previous, length);
    previous = raw;
    turned += step;
    if (i < places.size()) places[i] = first + turned;
  }
  return static_cast<int>(std::lround(turned / length));
}

/// Levels steps back, so that places increase.
void level(std::vector<double>& places, double length) {
  double highest = *std::max_element(places.begin(), places.end()) - length;
  for (double& p : places) p = highest = std::max(p, highest);
}

/// The ring's vertices from the place `from` on, once around.
Row ring_row(const Measured_ring& ring, bool reversed, double from) {
  const std::size_t n = ring.arc.size() - 1;
  const double length = ring.arc.back();
  std::vector<std::pair<double, std::size_t>> row;
  for (std::size_t i = 0; i < n; ++i) {
    const double raw = (reversed ? -ring.arc[i] : ring.arc[i]) - from;
    row.emplace_back(from + raw - std::floor(raw / length) * length, ring.first_vertex + i);
  }
  std::sort(row.begin(), row.end());
  Row result;
  for (const auto& [place, vertex] : row) {
    result.vertices.push_back(vertex);
    result.places.push_back(place);
  }
  return result;
}

/// Triangles between two rows that run side by side, each once around; every step takes the shorter diagonal as
/// measured along the ring. `border` runs as its triangles have it.
void zip(const Row& border, const Row& ring, double length, std::vector<std::array<std::size_t, 3>>& triangles) {
  const std::size_t m = border.vertices.size(), n = ring.vertices.size();
  const auto place = [length](const Row& row, std::size_t i) {
    const std::size_t size = row.places.size();
    return row.places[i % size] + static_cast<double>(i / size) * length;
  };
  for (std::size_t i = 0, k = 0; i < m || k < n;) {
    const double along_border = std::abs(place(border, i + 1) - place(ring, k));
    const double along_ring = std::abs(place(border, i) - place(ring, k + 1));
    if (k == n || (i < m && along_border <= along_ring)) {
      triangles.push_back({border.vertices[(i + 1) % m], border.vertices[i % m], ring.vertices[k % n]});
      ++i;
    } else {
      triangles.push_back({border.vertices[i % m], ring.vertices[k % n], ring.vertices[(k + 1) % n]});
      ++k;
    }
  }
}

class Joiner {
 public:
  Joiner(const Hermite_transition& psi, const Slab_contour& contour) : contour_(contour) {
    for (const std::size_t side : {0, 1}) {
      places_.emplace_back(psi.rings(side), result_.points.size());
      for (const Ring& ring : psi.rings(side))
        for (const Point_2& p : ring) result_.points.emplace_back(p.x(), p.y(), side == 0 ? 0 : psi.height());
    }
    offset_ = result_.points.size();
    result_.points.insert(result_.points.end(), contour.points.begin(), contour.points.end());
    for (const auto& [a, b, c] : contour.triangles)
      result_.triangles.push_back({a + offset_, b + offset_, c + offset_});
  }

  Joined_rings run() {
    std::array<std::vector<char>, 2> met{std::vector<char>(places_[0].rings().size()),
                                         std::vector<char>(places_[1].rings().size())};
    for (const Loop& loop : border_loops(contour_)) {
      const std::size_t side = contour_.border[loop.front()] == Border::lower ? 0 : 1;
      const std::optional<std::size_t> ring = join(loop, side);
      if (!ring || std::exchange(met[side][*ring], 1)) return refuse(contour_.points[loop.front()]);
    }
    for (const std::size_t side : {0, 1})
      for (std::size_t r = 0; r < met[side].size(); ++r)
        if (!met[side][r]) return refuse(result_.points[places_[side].rings()[r].first_vertex]);
    return std::move(result_);
  }

 private:
  Joined_rings refuse(const Point_3& where) {
    result_.gap = where;
    return std::move(result_);
  }

  /// Returns the ring that a loop was joined to, if it runs around one, once.
  std::optional<std::size_t> join(Loop loop, std::size_t side) {
    Row border;
    std::optional<std::size_t> ring;
    for (const std::size_t v : loop) {
      const auto place = places_[side].nearest({contour_.points[v].x(), contour_.points[v].y()});
      if (ring && *ring != place.ring) return std::nullopt;
      ring = place.ring;
      border.vertices.push_back(v + offset_);
      border.places.push_back(place.arc);
    }
    const Measured_ring& measured = places_[side].rings()[*ring];
    const double length = measured.arc.back();
    const int turns = unwrap(border.places, length);
    if (std::abs(turns) != 1) return std::nullopt;
    if (turns < 0)
      for (double& p : border.places) p = -p;
    level(border.places, length);
    zip(border, ring_row(measured, turns < 0, border.places.front()), length, result_.triangles);
    return ring;
  }

  const Slab_contour& contour_;
  std::vector<Ring_places> places_;
  std::size_t offset_ = 0;
  Joined_rings result_;
};

}  // namespace

Joined_rings join_rings(const Hermite_transition& psi, const Slab_contour& contour) {
  return Joiner(psi, contour).run();
}

}  // namespace cgal_blend
