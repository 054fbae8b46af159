// SPDX-License-Identifier: GPL-3.0-or-later
// What a blend costs beside the boolean before it, and what its cost grows with. See README.md for how to read it.
#include "shapes.h"

#include <cgal_blend/creases.h>
#include <cgal_blend/fillet.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace cgal_blend::test {
namespace {

constexpr double ball = 1;               // radius of all blends but those of (d)
constexpr double ball_on_fine_mesh = 6;  // wide against the faces

Fillet_options options_of(double radius) {
  Fillet_options options;
  options.radius = radius;
  return options;
}

/// Sharp union, for inputs; throws, so that nothing is measured on a wrong input.
Blend_mesh united(const Blend_mesh& a, const Blend_mesh& b) {
  Blend_mesh out;
  const Fillet_outcome outcome = unchecked::corefine_and_fillet(a, b, Boolean_operation::union_, out, options_of(0));
  if (!outcome.ok()) throw std::runtime_error(message(outcome.diagnosis));
  return out;
}

/// The fastest of the iterations of one benchmark, stage by stage: what else runs on the machine only adds. Its time is
/// that of the blend stage alone.
class Recorder {
 public:
  explicit Recorder(benchmark::State& state) : state_(state) {}

  /// Returns false, and ends the benchmark with the reason, if there is nothing to measure.
  bool add(const Fillet_outcome& outcome) {
    if (!outcome.ok()) {
      state_.SkipWithError(message(outcome.diagnosis).c_str());
      return false;
    }
    state_.SetIterationTime(outcome.times.blend / 1000);
    const auto keep_best = [this](double& best, double time) { best = runs_ == 0 ? time : std::min(best, time); };
    keep_best(best_.boolean, outcome.times.boolean);
    keep_best(best_.blend, outcome.times.blend);
    keep_best(best_.copy, outcome.times.copy);
    keep_best(best_.validate, outcome.times.validate);
    edges_ = 0;
    for (const Blend_report& blend : outcome.blends) edges_ += blend.edges;
    changed_ = outcome.changed_faces.size();
    ++runs_;
    return true;
  }

  [[nodiscard]] const Stage_times& best() const { return best_; }

  void write(std::size_t faces) {
    state_.counters["faces"] = static_cast<double>(faces);
    state_.counters["curve_edges"] = static_cast<double>(edges_);
    state_.counters["changed_faces"] = static_cast<double>(changed_);
    state_.counters["blend_ms"] = best().blend;
    state_.counters["copy_ms"] = best().copy;
    state_.counters["validate_ms"] = best().validate;
    state_.counters["validate_ratio"] = best().validate / best().blend;
  }

 private:
  benchmark::State& state_;
  Stage_times best_;
  std::size_t edges_ = 0, changed_ = 0;
  int runs_ = 0;
};

/// Ratio to the value of the first argument under the same name in this run.
double against_first(const std::string& name, std::int64_t argument, double value) {
  static std::map<std::string, std::pair<std::int64_t, double>> first;
  auto& [first_argument, first_value] = first.emplace(name, std::pair(argument, value)).first->second;
  if (argument == first_argument) first_value = value;  // repeated
  return value / first_value;
}

// (a) Blend against boolean, on meshes of a quarter of a million faces each.

std::pair<Blend_mesh, Blend_mesh> two_spheres() {
  return {sphere(30, 7), sphere(20, 7, {27.1, 3.7, 5.9})};  // 327 680 faces each, one curve
}

std::pair<Blend_mesh, Blend_mesh> two_tori() {
  const Placement place = placement({0.9, 0.2, 0.3}, 1.4, {21, 2, 3});
  return {torus(30, 10, 500, 250), transformed(torus(30, 10, 500, 250), place)};  // 250 000 faces each
}

void blend_against_boolean(benchmark::State& state, std::pair<Blend_mesh, Blend_mesh> (*make)()) {
  const auto [a, b] = make();
  Recorder recorder(state);
  for (auto _ : state) {
    Blend_mesh out;
    if (!recorder.add(unchecked::corefine_and_fillet(a, b, Boolean_operation::union_, out, options_of(ball)))) return;
  }
  recorder.write(a.number_of_faces() + b.number_of_faces());
  const Stage_times times = recorder.best();
  state.counters["boolean_ms"] = times.boolean;
  state.counters["ratio"] = times.blend / times.boolean;
}

// (b) The same curve on a growing mesh: a boss on a block whose sides are n x n squares of side 1.

constexpr double boss_radius = 5;

Blend_mesh boss_at(double x, double y) {
  return transformed(cylinder(boss_radius, 128, -4.3, 12, 15), moved_by(x, y, 0));
}

void blend_on_growing_mesh(benchmark::State& state) {
  const int n = static_cast<int>(state.range(0));
  const double a = n / 2.0;
  const Blend_mesh block = grid_box({-a, -a, -2 * a}, {a, a, 0}, n), boss = boss_at(0.3, 0.2);
  Recorder recorder(state);
  for (auto _ : state) {
    Blend_mesh out;
    if (!recorder.add(unchecked::corefine_and_fillet(block, boss, Boolean_operation::union_, out, options_of(ball))))
      return;
  }
  const std::size_t faces = block.number_of_faces() + boss.number_of_faces();
  recorder.write(faces);
  state.counters["faces_growth"] = against_first("b: faces", n, static_cast<double>(faces));
  state.counters["blend_growth"] = against_first("b: blend", n, recorder.best().blend);
}

// (c) Ever more curve on a mesh of nearly constant size: k x k bosses, united with the block beforehand.

std::vector<Edge> grooves(const Blend_mesh& mesh) {
  std::vector<Edge> edges;
  for (const Edge e : mesh.edges())
    if (is_crease(e, mesh, 45) && !is_convex_edge(e, mesh)) edges.push_back(e);
  return edges;
}

void blend_along_growing_curve(benchmark::State& state) {
  const int count = static_cast<int>(state.range(0)), n = 128;
  const double a = n / 2.0;
  Blend_mesh bosses;
  for (int i = 0; i < count; ++i)
    bosses = side_by_side(bosses, boss_at(-a + 16.3 + 32 * (i % 4), -a + 16.2 + 32 * (i / 4)));
  const Blend_mesh body = united(grid_box({-a, -a, -2 * a}, {a, a, 0}, n), bosses);
  const std::vector<Edge_blend> feet{{grooves(body), ball, {}}};
  Recorder recorder(state);
  for (auto _ : state) {
    Blend_mesh out;
    if (!recorder.add(unchecked::fillet_edges(body, feet, out, options_of(ball)))) return;
  }
  recorder.write(body.number_of_faces());
  state.counters["curve_growth"] = against_first("c: curve", count, count);
  state.counters["blend_growth"] = against_first("c: blend", count, recorder.best().blend);
}

// (e) Mapping at the paper's scale: about 1423 faces within 1.75 radii of the curve, a union of 10 240 faces.

void map_at_paper_scale(benchmark::State& state) {
  const Blend_mesh a = sphere(30, 4), b = sphere(22, 4, {27.1, 3.7, 5.9});
  Fillet_options options = options_of(2);
  options.mode = Blend_mode::map;
  Recorder recorder(state);
  for (auto _ : state) {
    Blend_mesh out;
    if (!recorder.add(unchecked::corefine_and_fillet(a, b, Boolean_operation::union_, out, options))) return;
  }
  recorder.write(a.number_of_faces() + b.number_of_faces());
}

// (d) Mapping the vertices of a quarter of a million faces, against mapping a coarse level and restoring the detail.

void coarse_level(benchmark::State& state) {
  const Blend_mesh body = united(sphere(30, 7), sphere(22, 6, {27.1, 3.7, 5.9}));  // 337k faces
  const std::vector<Edge_blend> seam{{grooves(body), ball_on_fine_mesh, {}}};
  Fillet_options options = options_of(ball_on_fine_mesh);
  options.mode = Blend_mode::map;
  options.coarse_faces = static_cast<std::size_t>(state.range(0));
  Recorder recorder(state);
  double coarsen = 0;
  for (auto _ : state) {
    Blend_mesh out;
    const Fillet_outcome outcome = unchecked::fillet_edges(body, seam, out, options);
    if (!recorder.add(outcome)) return;
    coarsen = outcome.times.coarsen;
  }
  recorder.write(body.number_of_faces());
  state.counters["coarsen_ms"] = coarsen;
  state.counters["blend_growth"] = against_first("d: blend", state.range(0), recorder.best().blend);
}

BENCHMARK_CAPTURE(blend_against_boolean, two_spheres, two_spheres)
    ->Iterations(3)
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime();
BENCHMARK_CAPTURE(blend_against_boolean, two_tori, two_tori)
    ->Iterations(3)
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime();
BENCHMARK(blend_on_growing_mesh)
    ->RangeMultiplier(2)
    ->Range(32, 256)
    ->Iterations(5)
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime();
BENCHMARK(map_at_paper_scale)->Iterations(40)->Unit(benchmark::kMillisecond)->UseManualTime();
BENCHMARK(coarse_level)->Arg(0)->Arg(4000)->Arg(2000)->Iterations(3)->Unit(benchmark::kMillisecond)->UseManualTime();
BENCHMARK(blend_along_growing_curve)
    ->RangeMultiplier(2)
    ->Range(1, 16)
    ->Iterations(5)
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime();

}  // namespace
}  // namespace cgal_blend::test

BENCHMARK_MAIN();
