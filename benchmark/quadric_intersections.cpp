// SPDX-License-Identifier: GPL-3.0-or-later
// Intersects quadrics with coefficients at random, and checks every component; see README.md.
// Usage: cgal_blend_quadric_intersections [PAIRS [LARGEST_COEFFICIENT [PAIRS_TO_COUNT [SEED]]]]; exit status 1 if a check fails.
#include "curve_counter.h"

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;

constexpr double box = 1000;
constexpr std::size_t samples = 24;

struct Tally {
  std::vector<double> milliseconds;
  double worst_residual = 0, largest_turn = 0;
  std::size_t points = 0, exceptions = 0, counted = 0, miscounted = 0, not_followed = 0;
  double sampling = 0;  // milliseconds

  [[nodiscard]] double quantile(double share) {
    std::sort(milliseconds.begin(), milliseconds.end());
    return milliseconds[static_cast<std::size_t>(share * static_cast<double>(milliseconds.size() - 1))];
  }
};

// Milliseconds of the processor, which other programs do not lengthen.
double now() { return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// |F| / |grad F| in units of the box.
double residual(const Quadric_3& q, const Quadric_3::Point_3& p) {
  return std::abs(q.value(p)) / std::sqrt(q.gradient(p).squared_length()) / box;
}

void check(const Quadric_3& a, const Quadric_3& b, const Quadric_intersection& result, Tally& tally) {
  for (const Intersection_curve& curve : result.components) {
    const double start = now();
    const auto points = curve.sample(samples);
    tally.sampling += now() - start;
    tally.points += points.size();
    const std::size_t n = points.size();
    for (std::size_t i = 0; i < n; ++i) {
      if (is_near(result.singular_points, points[i], 1e-3)) continue;
      tally.worst_residual = std::max({tally.worst_residual, residual(a, points[i]), residual(b, points[i])});
      if (curve.is_isolated() || (!curve.is_closed() && (i == 0 || i + 1 == n))) continue;
      const double turn = angle_deg(points[i] - points[(i + n - 1) % n], points[(i + 1) % n] - points[i]);
      if (!(turn <= tally.largest_turn)) tally.largest_turn = turn;
    }
  }
}

// Against the oracle, without a box that arcs could miss.
void count(const Quadric_3& a, const Quadric_3& b, Tally& tally) {
  const Quadric_intersection result = intersect_quadrics(a, b, {1e9});
  if (result.segre != "[1111]") return;
  const auto expected = Curve_counter(a, b).count();
  if (!expected) {
    ++tally.not_followed;
    return;
  }
  ++tally.counted;
  if (parts(result) == *expected) return;
  ++tally.miscounted;
  for (const Quadric_3* q : {&a, &b})
    for (const auto& c : q->coefficients()) std::printf("%g ", CGAL::to_double(c));
  std::printf(": differs from the oracle\n");
}

}  // namespace

int main(int argc, char** argv) {
  const int pairs = argc > 1 ? std::atoi(argv[1]) : 10000, largest = argc > 2 ? std::atoi(argv[2]) : 10;
  const int to_count = argc > 3 ? std::atoi(argv[3]) : 500;
  std::mt19937 random(argc > 4 ? static_cast<unsigned>(std::atoi(argv[4])) : 1);
  Tally tally;
  for (int k = 0; k < pairs; ++k) {
    const Quadric_3 a = random_quadric(random, largest), b = random_quadric(random, largest);
    try {
      const double start = now();
      const Quadric_intersection result = intersect_quadrics(a, b, {box});
      tally.milliseconds.push_back(now() - start);
      check(a, b, result, tally);
      if (tally.counted < static_cast<std::size_t>(to_count)) count(a, b, tally);
    } catch (const std::exception& error) {
      ++tally.exceptions;
      std::printf("pair %d: %s\n", k, error.what());
    }
  }
  if (tally.milliseconds.empty()) return 1;
  std::printf("intersection: median %.2f ms, 90 %% %.2f ms, longest %.2f ms; sampling %.1f us a point, %zu points\n",
              tally.quantile(0.5), tally.quantile(0.9), tally.quantile(1),
              1000 * tally.sampling / static_cast<double>(std::max<std::size_t>(1, tally.points)), tally.points);
  std::printf("largest |F| / |grad F| %.2g of the box, largest turn %.1f degrees, exceptions %zu\n",
              tally.worst_residual, tally.largest_turn, tally.exceptions);
  std::printf("components counted by the oracle: %zu, different: %zu, not followed: %zu\n", tally.counted,
              tally.miscounted, tally.not_followed);
  const bool is_right =
      tally.exceptions + tally.miscounted == 0 && tally.worst_residual < 1e-12 && tally.largest_turn < 25;
  return is_right ? 0 : 1;
}
