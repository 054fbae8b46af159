// SPDX-License-Identifier: GPL-3.0-or-later
#include "ring_edges.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>

namespace cgal_blend {

namespace {

// A ring edge is compared with the longest of so many on either side: short edges come in bunches.
constexpr std::size_t neighbours = 4;
// Passes over all rings; each halves a bunch at least.
constexpr int passes = 8;
// A remnant must not turn further from its face than to this cosine, 10 degrees.
constexpr double least_cosine = 0.985;

class Ring_tidier {
 public:
  Ring_tidier(Plane_cut& cut, const Blend_mesh& mesh, std::vector<Vector_3> normals)
      : cut_(cut), mesh_(mesh), normals_(std::move(normals)), first_(cut.vertices.size()) {
    around_.resize(cut.points.size());
    for (std::size_t t = 0; t < cut.remnants.size(); ++t)
      for (const std::size_t v : cut.remnants[t])
        if (v >= first_) around_[v - first_].push_back(t);
    gone_.resize(cut.remnants.size(), 0);
  }

  void run() {
    bool changed = true;
    for (int k = 0; k < passes && changed; ++k) {
      changed = false;
      for (auto& ring : cut_.rings) changed = sweep(ring) || changed;
    }
    compact();
  }

 private:
  const Point_3& point(std::size_t v) const {
    return v < first_ ? mesh_.point(cut_.vertices[v]) : cut_.points[v - first_];
  }
  double length(const std::vector<std::size_t>& ring, std::size_t i) const {
    return std::sqrt(CGAL::squared_distance(point(ring[i]), point(ring[(i + 1) % ring.size()])));
  }
  double local_length(const std::vector<std::size_t>& ring, std::size_t i) const;
  bool sweep(std::vector<std::size_t>& ring);
  bool may_merge(std::size_t gone, std::size_t into) const;
  bool turns_over(std::size_t t, std::size_t gone, std::size_t into) const;
  std::set<std::size_t> linked(std::size_t v) const;
  void merge(std::size_t gone, std::size_t into);
  void compact();

  Plane_cut& cut_;
  const Blend_mesh& mesh_;
  std::vector<Vector_3> normals_;
  std::size_t first_;                             // index of the first new vertex
  std::vector<std::vector<std::size_t>> around_;  // remnants at a new vertex
  std::vector<char> gone_;                        // per remnant
};

double Ring_tidier::local_length(const std::vector<std::size_t>& ring, std::size_t i) const {
  double longest = 0;
  const std::size_t n = ring.size(), reach = std::min(neighbours, n / 2);
  for (std::size_t k = 0; k <= 2 * reach; ++k) longest = std::max(longest, length(ring, (i + n + k - reach) % n));
  return longest;
}

/// Merges the ends of short edges of one ring; true if there were any.
bool Ring_tidier::sweep(std::vector<std::size_t>& ring) {
  bool changed = false;
  for (std::size_t i = 0; i < ring.size() && ring.size() > 3; ++i) {
    if (!(length(ring, i) < short_ring_edge * local_length(ring, i))) continue;
    const std::size_t j = (i + 1) % ring.size();
    if (may_merge(ring[j], ring[i])) {
      merge(ring[j], ring[i]);
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(j));
    } else if (may_merge(ring[i], ring[j])) {
      merge(ring[i], ring[j]);
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      continue;
    }
    changed = true;
  }
  return changed;
}

std::set<std::size_t> Ring_tidier::linked(std::size_t v) const {
  std::set<std::size_t> found;
  for (const std::size_t t : around_[v - first_])
    if (!gone_[t]) found.insert(cut_.remnants[t].begin(), cut_.remnants[t].end());
  return found;
}

/// The link condition for a border edge: its ends share one neighbour, the corner of the remnant that vanishes.
bool Ring_tidier::may_merge(std::size_t gone, std::size_t into) const {
  const std::set<std::size_t> a = linked(gone), b = linked(into);
  std::vector<std::size_t> common;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
  if (common.size() != 3) return false;  // with the two ends themselves
  const auto& at = around_[gone - first_];
  return std::none_of(at.begin(), at.end(), [&](std::size_t t) { return !gone_[t] && turns_over(t, gone, into); });
}

bool Ring_tidier::turns_over(std::size_t t, std::size_t gone, std::size_t into) const {
  auto corners = cut_.remnants[t];
  if (std::find(corners.begin(), corners.end(), into) != corners.end()) return false;  // vanishes
  std::replace(corners.begin(), corners.end(), gone, into);
  const Point_3& p = point(corners[0]);
  const Vector_3 normal = CGAL::cross_product(point(corners[1]) - p, point(corners[2]) - p);
  return !(normal * normals_[t] >
           least_cosine * std::sqrt(normal.squared_length()) * std::sqrt(normals_[t].squared_length()));
}

void Ring_tidier::merge(std::size_t gone, std::size_t into) {
  for (const std::size_t t : around_[gone - first_]) {
    if (gone_[t]) continue;
    auto& corners = cut_.remnants[t];
    if (std::find(corners.begin(), corners.end(), into) != corners.end()) {
      gone_[t] = 1;
      continue;
    }
    std::replace(corners.begin(), corners.end(), gone, into);
    around_[into - first_].push_back(t);
  }
  around_[gone - first_].clear();
}

/// Drops remnants that have vanished and points that no ring has any more.
void Ring_tidier::compact() {
  std::vector<std::size_t> place(cut_.points.size(), 0);
  for (const auto& ring : cut_.rings)
    for (const std::size_t v : ring) place[v - first_] = 1;
  std::vector<Point_3> points;
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (place[i] == 0) continue;
    place[i] = first_ + points.size();
    points.push_back(cut_.points[i]);
  }
  const auto moved = [&](std::size_t v) { return v < first_ ? v : place[v - first_]; };
  std::vector<std::array<std::size_t, 3>> remnants;
  for (std::size_t t = 0; t < cut_.remnants.size(); ++t)
    if (const auto& c = cut_.remnants[t]; !gone_[t]) remnants.push_back({moved(c[0]), moved(c[1]), moved(c[2])});
  for (auto& ring : cut_.rings) std::transform(ring.begin(), ring.end(), ring.begin(), moved);
  cut_.points = std::move(points);
  cut_.remnants = std::move(remnants);
}

}  // namespace

void collapse_short_ring_edges(Plane_cut& cut, const Blend_mesh& mesh, std::vector<Vector_3> normals) {
  Ring_tidier(cut, mesh, std::move(normals)).run();
}

}  // namespace cgal_blend
