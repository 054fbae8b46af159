// SPDX-License-Identifier: GPL-3.0-or-later
// What geodesic polar coordinates cost, and what the cost grows with. See README.md.
#include "shapes.h"

#include <cgal_blend/geodesic_polar.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>

namespace cgal_blend::test {
namespace {

/// Radius of the cap of the unit sphere that has a number of the vertices of an even mesh.
double radius_of_cap(const Blend_mesh& mesh, double vertices) {
  return std::acos(1 - 2 * vertices / static_cast<double>(mesh.number_of_vertices()));
}

std::size_t covered(const Geodesic_polar& polar) {
  std::size_t count = 0;
  for (const Vertex v : polar.mesh().vertices())
    if (polar.covers(v) && polar(v).distance <= polar.radius()) ++count;
  return count;
}

/// A disk of a number of vertices on a sphere of 163 842 vertices (level 7) or 655 362 (level 8).
void coordinates(benchmark::State& state) {
  const Blend_mesh mesh = sphere(1, static_cast<int>(state.range(0)));
  const double radius = radius_of_cap(mesh, static_cast<double>(state.range(1)));
  std::size_t vertices = 0;
  for (auto _ : state) {
    const Geodesic_polar polar(mesh, {Face(0), {0.2, 0.3, 0.5}}, radius);
    state.PauseTiming();
    vertices = covered(polar);
    if (!polar.diagnosis().ok()) state.SkipWithError(message(polar.diagnosis()).c_str());
    state.ResumeTiming();
  }
  state.counters["vertices"] = static_cast<double>(vertices);
  state.counters["mesh"] = static_cast<double>(mesh.number_of_vertices());
}
BENCHMARK(coordinates)
    ->ArgNames({"level", "vertices"})
    ->Args({7, 1000})
    ->Args({7, 10000})
    ->Args({7, 100000})
    ->Args({8, 1000})
    ->Args({8, 100000})
    ->Unit(benchmark::kMillisecond);

/// Points in a disk of 100 000 vertices by their coordinates, along a spiral.
void locate(benchmark::State& state) {
  const Blend_mesh mesh = sphere(1, 7);
  const double radius = radius_of_cap(mesh, 100000);
  const Geodesic_polar polar(mesh, {Face(0), {0.2, 0.3, 0.5}}, radius);
  if (!polar.diagnosis().ok()) state.SkipWithError(message(polar.diagnosis()).c_str());
  double s = 0;
  for (auto _ : state) {
    s = std::fmod(s + 0.618034, 1);
    benchmark::DoNotOptimize(polar.locate({radius * std::sqrt(s), 100 * s}));
  }
}
BENCHMARK(locate)->Unit(benchmark::kNanosecond);

/// A coarse body, whose faces are divided for the purpose: all 12 triangles of a box.
void coordinates_on_coarse_faces(benchmark::State& state) {
  const Blend_mesh mesh = box({-1, -1, -1}, {1, 1, 1});
  for (auto _ : state) {
    const Geodesic_polar polar(mesh, {Face(0), {0.2, 0.3, 0.5}}, 0.5);
    if (!polar.diagnosis().ok()) state.SkipWithError(message(polar.diagnosis()).c_str());
  }
}
BENCHMARK(coordinates_on_coarse_faces)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace cgal_blend::test

BENCHMARK_MAIN();
