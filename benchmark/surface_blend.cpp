// SPDX-License-Identifier: GPL-3.0-or-later
// What a blend between two quadrics costs once their curves are known: 100 x 30 points, as when a parameter is moved.
#include <cgal_blend/boundary_models.h>
#include <cgal_blend/quadric_intersection.h>
#include <cgal_blend/surface_blend_body.h>
#include <cgal_blend/surface_blend_fit.h>

#include <benchmark/benchmark.h>

#include <array>
#include <stdexcept>

namespace cgal_blend {
namespace {

using Coefficients = std::array<double, 10>;

const Quadric_3 along_x(Coefficients{0, 1, 1, 0, 0, 0, 0, 0, 0, -1}),
    along_y(Coefficients{1, 0, 1, 0, 0, 0, 0, 0, 0, -1});
const Quadric_3 cutter(Coefficients{4, 9, 0, 0, 0, 0, 0, 0, 0, -36});

Boundary_curve curve_on(const Quadric_3& quadric, int axis, double sign, bool planar) {
  Quadric_3::Plane plane{0, 0, 0, Quadric_3::Rational(-2 * sign)};
  plane[static_cast<std::size_t>(axis)] = 1;
  const auto section = planar ? intersect(quadric, plane) : intersect_quadrics(quadric, cutter);
  for (const auto& component : section.components)
    if (component.at(0.3).point[axis] * sign > 0)
      return Implicit_boundary(implicit_function(quadric), space_curve_of(component));
  throw std::runtime_error("no such curve");
}

struct Pair {
  explicit Pair(bool planar) : first(curve_on(along_x, 0, -1, planar)), second(curve_on(along_y, 1, 1, planar)) {}
  Boundary_curve first, second;
};

Surface_blend_options options_of(double distance, Fold_policy policy) {
  Surface_blend_options options;
  for (Blend_side_options& side : options.sides) side.distance = distance;
  options.on_fold = policy;
  return options;
}

/// The distances are moved; the pairing of the curves stays.
void move_distance(benchmark::State& state) {
  const Pair pair(state.range(0) == 0);
  const Correspondence pairing = correspond(pair.first, pair.second);
  double distance = 0.5;
  for (auto _ : state) {
    const Surface_blend blend(pair.first, pair.second, pairing, options_of(distance += 1e-6, Fold_policy::ignore));
    benchmark::DoNotOptimize(blend.sample(100, 30));
  }
}

/// The curves are paired anew.
void pair_and_sample(benchmark::State& state) {
  const Pair pair(state.range(0) == 0);
  for (auto _ : state)
    benchmark::DoNotOptimize(
        blend_surfaces(pair.first, pair.second, options_of(0.6, Fold_policy::ignore)).blend->sample(100, 30));
}

/// With the check for folds.
void pair_and_check(benchmark::State& state) {
  const Pair pair(state.range(0) == 0);
  for (auto _ : state) {
    const auto result = blend_surfaces(pair.first, pair.second, options_of(0.6, Fold_policy::refuse));
    if (!result.ok()) return state.SkipWithError(message(result.diagnosis).c_str());
  }
}

void fit(benchmark::State& state) {
  const Pair pair(state.range(0) == 0);
  const auto result = blend_surfaces(pair.first, pair.second, options_of(0.6, Fold_policy::ignore));
  for (auto _ : state) benchmark::DoNotOptimize(fit_bspline(*result.blend, 1e-4));
}

/// The whole body, trimmed, capped and checked.
void make_body(benchmark::State& state) {
  const Pair pair(state.range(0) == 0);
  const auto result = blend_surfaces(pair.first, pair.second, options_of(0.6, Fold_policy::ignore));
  for (auto _ : state) {
    const Blend_body body = make_blend_body(
        {trimmed_quadric(along_x, {{-1, 0, 0, -5}}), trimmed_quadric(along_y, {{0, 1, 0, -5}})}, {{*result.blend}});
    if (!body.ok()) return state.SkipWithError(message(body.diagnosis).c_str());
    state.counters["faces"] = static_cast<double>(body.mesh.number_of_faces());
  }
}

// 0: plane sections; 1: sections with a quadric.
BENCHMARK(move_distance)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(pair_and_sample)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(pair_and_check)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(fit)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(make_body)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace cgal_blend

BENCHMARK_MAIN();
