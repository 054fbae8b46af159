// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_RUN_FRONTS_H
#define CGAL_BLEND_SRC_RUN_FRONTS_H

#include "geodesic_field.h"

#include <cstdint>
#include <queue>
#include <utility>
#include <vector>

namespace cgal_blend {

// A distance must fall by this share for its vertex to be visited again; of the order of the rounding errors of one step.
inline constexpr double least_gain = 4e-16;

// A vertex is visited so often at most; on irregular meshes dozens of times are usual. Fronts of a curve carry its
// curvature along, and where that is in disorder their distances could fall for ever.
inline constexpr int most_visits = 1000;

/// Carries distances from vertex to vertex, nearest first, and again from vertices whose distance falls once more.
/// \param step improves vertex k from the edge (i, j) that has it to its left, and says whether it did, from (i, j, k)
template <class Step>
void run_fronts(const Region_mesh& region, double limit, Geodesic_field& field, const Step& step) {
  using Entry = std::pair<double, std::int32_t>;
  const auto farther = [](const Entry& a, const Entry& b) { return a.first > b.first; };
  std::priority_queue<Entry, std::vector<Entry>, decltype(farther)> queue(farther);
  std::vector<int> visits(field.at.size(), 0);
  for (const std::int32_t v : field.seeds) queue.emplace(field.at[v].distance, v);
  while (!queue.empty() && queue.top().first <= limit) {
    const auto [distance, v] = queue.top();
    queue.pop();
    if (distance != field.at[v].distance || ++visits[v] > most_visits) continue;  // found shorter since
    region.for_star(v, [&](std::int32_t t, int slot) {
      const auto& corner = region.triangles()[t].corner;
      const std::int32_t own = corner[slot], next = corner[(slot + 1) % 3], last = corner[(slot + 2) % 3];
      if (step(own, next, last)) queue.emplace(field.at[last].distance, last);
      if (step(last, own, next)) queue.emplace(field.at[next].distance, next);
    });
  }
}

}  // namespace cgal_blend

#endif
