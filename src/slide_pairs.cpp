// SPDX-License-Identifier: GPL-3.0-or-later
#include "slide_pairs.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace cgal_blend {

namespace {

using Step = std::pair<std::size_t, std::size_t>;
constexpr std::array<Step, 7> steps{{{1, 1}, {1, 2}, {2, 1}, {2, 3}, {3, 2}, {1, 3}, {3, 1}}};
constexpr int smoothing_passes = 8;

struct Cell {
  double cost = std::numeric_limits<double>::infinity();
  Step step{0, 0};
};

/// The cheapest staircase from (0, 0) to (n, n), where every step costs the distance of its end times its length.
std::vector<Step> cheapest_staircase(const std::vector<std::vector<double>>& distance) {
  const std::size_t n = distance.size() - 1;
  std::vector<std::vector<Cell>> table(n + 1, std::vector<Cell>(n + 1));
  table[0][0].cost = 0;
  for (std::size_t i = 0; i <= n; ++i)
    for (std::size_t j = 0; j <= n; ++j)
      for (const Step& step : steps) {
        if (step.first > i || step.second > j) continue;
        const double cost = table[i - step.first][j - step.second].cost +
                            distance[i][j] * static_cast<double>(step.first + step.second) / 2;
        if (cost < table[i][j].cost) table[i][j] = {cost, step};
      }
  std::vector<Step> path{{n, n}};
  while (path.back() != Step{0, 0}) {
    const auto [i, j] = path.back();
    const Step step = table[i][j].step;
    path.emplace_back(i - step.first, j - step.second);
  }
  std::reverse(path.begin(), path.end());
  return path;
}

/// Averages neighbours: steps between increasing values stay increasing.
void smooth(std::vector<double>& values) {
  const std::size_t n = values.size() - 1;
  for (int pass = 0; pass < smoothing_passes; ++pass) {
    const std::vector<double> old = values;
    for (std::size_t i = 1; i < n; ++i) values[i] = (old[i - 1] + 2 * old[i] + old[i + 1]) / 4;
  }
}

}  // namespace

Pairing equal_pairs(std::size_t spans) {
  Pairing pairing;
  for (std::size_t i = 0; i <= spans; ++i) pairing.s.push_back(static_cast<double>(i) / static_cast<double>(spans));
  pairing.first = pairing.second = pairing.s;
  return pairing;
}

Pairing slid_pairs(const std::vector<Point_3>& first, const std::function<Point_3(double)>& second, bool closed) {
  const std::size_t n = closed ? first.size() : first.size() - 1;
  const double spans = static_cast<double>(n);
  std::vector<Point_3> others;
  for (std::size_t j = 0; j <= n; ++j) others.push_back(second(static_cast<double>(j) / spans));
  std::vector<std::vector<double>> distance(n + 1, std::vector<double>(n + 1));
  for (std::size_t i = 0; i <= n; ++i)
    for (std::size_t j = 0; j <= n; ++j) distance[i][j] = CGAL::squared_distance(first[closed ? i % n : i], others[j]);
  Pairing pairing;
  for (const auto& [i, j] : cheapest_staircase(distance)) {
    pairing.first.push_back(static_cast<double>(i) / spans);
    pairing.second.push_back(static_cast<double>(j) / spans);
    pairing.s.push_back(static_cast<double>(i + j) / (2 * spans));
  }
  smooth(pairing.first);
  smooth(pairing.second);
  for (std::size_t k = 0; k < pairing.s.size(); ++k) pairing.s[k] = (pairing.first[k] + pairing.second[k]) / 2;
  return pairing;
}

}  // namespace cgal_blend
