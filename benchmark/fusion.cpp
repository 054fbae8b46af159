// SPDX-License-Identifier: GPL-3.0-or-later
// What the transition between two openings costs: fitting thin plates, and tessellating, at the sizes of the paper's tables
// 1 and 2 and far beyond.
#include "hermite_transition.h"
#include "openings.h"
#include "slab_tessellation.h"

#include <cgal_blend/implicit_opening.h>

#include <benchmark/benchmark.h>

#include <cmath>

namespace cgal_blend::test {
namespace {

void fit_thin_plate(benchmark::State& state) {
  const Ring ring = wavy_ring(1, 0.1, 5, static_cast<int>(state.range(0)));
  const Opening_model model = rbf_opening();
  for (auto _ : state) benchmark::DoNotOptimize(model({ring}));
}

/// Cones on circles, the edge length such that about so many vertices come out.
void tessellate(benchmark::State& state, const Opening_model& model) {
  const double wanted = static_cast<double>(state.range(0)), height = 0.5;
  Slab_options options;
  options.edge = 0.88 * std::sqrt(4 * pi * height / wanted);  // facets come out a little larger than wanted
  const int around = static_cast<int>(2 * pi / options.edge);
  const Circle low{1, 0, 0, around, 0.3}, high{0.8, 0, 0, around, -0.2};
  for (auto _ : state) {
    const Hermite_transition psi({sections_of({low}), sections_of({high})}, height, {model});
    const Slab_tessellation result = tessellate_slab(psi, options);
    if (!result.diagnosis.ok()) return state.SkipWithError(message(result.diagnosis).c_str());
    state.counters["vertices"] = static_cast<double>(result.points.size());
  }
}

void tessellate_distances(benchmark::State& state) { tessellate(state, distance_opening()); }
void tessellate_thin_plates(benchmark::State& state) { tessellate(state, rbf_opening()); }

// Table 2, and a large transition.
void transition_sizes(benchmark::internal::Benchmark* benchmark) {
  for (const int vertices : {1312, 2110, 2930, 4194, 5168, 50000}) benchmark->Arg(vertices);
  benchmark->Unit(benchmark::kMillisecond);
}

// Table 1, and a large opening.
BENCHMARK(fit_thin_plate)->Arg(30)->Arg(61)->Arg(102)->Arg(156)->Arg(213)->Arg(2000)->Unit(benchmark::kMillisecond);
BENCHMARK(tessellate_distances)->Apply(transition_sizes);
BENCHMARK(tessellate_thin_plates)->Apply(transition_sizes);

}  // namespace
}  // namespace cgal_blend::test

BENCHMARK_MAIN();
