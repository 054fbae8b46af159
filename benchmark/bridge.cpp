// SPDX-License-Identifier: GPL-3.0-or-later
// What a bridge costs: evaluating it anew when its shape changes, a step of a drag, and all of it.
#include "shapes.h"

#include <cgal_blend/bridge.h>
#include <cgal_blend/mesh_io.h>

#include <benchmark/benchmark.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace cgal_blend {
namespace {

/// Two spheres of 20 * 4^level faces each.
Blend_mesh bodies(int level) {
  return test::side_by_side(test::sphere(1, level), test::sphere(0.8, level, {0.1, 0.2, 2.6}));
}

std::array<Bridge_end, 2> ends() {
  std::array<Bridge_end, 2> result;
  result[0].spot = {0, 0, 1};
  result[0].radius = 0.6;
  result[1].spot = {0.1, 0.2, 1.8};
  result[1].radius = 0.5;
  return result;
}

Bridge_options grid_of_64_by_32() {
  Bridge_options options;
  options.segments = 64;
  options.rows = 32;
  return options;
}

/// A lambda changes; 64 x 33 points are evaluated each time.
void change_shape(benchmark::State& state) {
  const Blend_mesh mesh = bodies(static_cast<int>(state.range(0)));
  Bridge_solver solver(mesh, ends(), grid_of_64_by_32());
  if (!solver.diagnosis().ok()) throw std::runtime_error(message(solver.diagnosis()));
  int step = 0;
  for (auto _ : state) {
    ++step;
    solver.set_lambda(step % 2, 0.2 + 0.001 * (step % 500));
    benchmark::DoNotOptimize(solver.points().data());
  }
}
BENCHMARK(change_shape)->Arg(5)->Arg(7)->Unit(benchmark::kMillisecond);

void change_twist(benchmark::State& state) {
  const Blend_mesh mesh = bodies(static_cast<int>(state.range(0)));
  Bridge_solver solver(mesh, ends(), grid_of_64_by_32());
  double degrees = 0;
  for (auto _ : state) {
    solver.set_twist(degrees += 1);
    benchmark::DoNotOptimize(solver.points().data());
  }
}
BENCHMARK(change_twist)->Arg(5)->Arg(7)->Unit(benchmark::kMillisecond);

/// One step of a drag: both lambdas are solved for, and the bridge is evaluated.
void drag_step(benchmark::State& state) {
  const Blend_mesh mesh = bodies(static_cast<int>(state.range(0)));
  Bridge_solver solver(mesh, ends(), grid_of_64_by_32());
  const Point_3 start = solver.point(0.3, 0.4);
  int step = 0;
  for (auto _ : state) {
    ++step;
    benchmark::DoNotOptimize(solver.drag(0.3, 0.4, start + 0.0005 * (step % 200) * Vector_3(1, 0.5, 0.3)).residual);
  }
}
BENCHMARK(drag_step)->Arg(5)->Arg(7)->Unit(benchmark::kMillisecond);

/// Coordinates, rays and contact curves.
void set_up(benchmark::State& state) {
  const Blend_mesh mesh = bodies(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    const Bridge_solver solver(mesh, ends(), grid_of_64_by_32());
    benchmark::DoNotOptimize(solver.points().data());
  }
}
BENCHMARK(set_up)->Arg(5)->Arg(7)->Unit(benchmark::kMillisecond);

/// The whole command, with the share that reading and writing have.
void read_bridge_write(benchmark::State& state) {
  const auto folder = std::filesystem::temp_directory_path();
  const std::string in = (folder / "cgal_blend_bridge_in.off").string(),
                    to = (folder / "cgal_blend_bridge_out.off").string();
  write_mesh(in, bodies(static_cast<int>(state.range(0))));
  double engine = 0, whole = 0;
  const auto seconds = [] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  };
  for (auto _ : state) {
    const double start = seconds();
    const Blend_mesh mesh = read_mesh(in);
    const double read = seconds();
    Blend_mesh out;
    const Bridge_outcome outcome = unchecked::bridge(mesh, ends(), out);
    if (!outcome.ok()) throw std::runtime_error(message(outcome.diagnosis));
    const double bridged = seconds();
    write_mesh(to, out);
    engine += bridged - read - outcome.times.validate / 1000;
    whole += seconds() - start;
  }
  state.counters["bridge_share"] = engine / whole;
  std::filesystem::remove(in);
  std::filesystem::remove(to);
}
BENCHMARK(read_bridge_write)->Arg(5)->Arg(7)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace cgal_blend

BENCHMARK_MAIN();
