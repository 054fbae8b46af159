// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/bridge.h>

#include "bridge_assembly.h"
#include "bridge_union.h"
#include "stopwatch.h"

#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <deque>
#include <utility>

namespace cgal_blend {

namespace {

using Loop = std::vector<Halfedge>;

/// A chain of edges as a source, seen from the faces on its left; the other way round, from the other side.
std::vector<Face_point> source_of(const Blend_mesh& mesh, const Loop& loop, bool other_side) {
  std::vector<Face_point> points;
  const std::size_t n = loop.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Halfedge h = other_side ? mesh.opposite(loop[(2 * n - 1 - i) % n]) : loop[i];
    const Vertex v = mesh.source(h);
    Face_point at{mesh.face(h), {0, 0, 0}};
    Halfedge corner = mesh.halfedge(at.face);
    for (double& weight : at.weights) {
      weight = mesh.target(corner) == v ? 1 : 0;
      corner = mesh.next(corner);
    }
    points.push_back(at);
  }
  return points;
}

class Crossing_bridges {
 public:
  Crossing_bridges(const Bridge_union& sharp, const std::array<Bridge_end, 2>& ends, const Bridge_options& options)
      : sharp_(sharp), ends_(ends), options_(options), surface_(sharp.mesh, surface_options(options), &sharp.curves) {}

  Bridge_outcome run(Blend_mesh& out) {
    Bridge_outcome outcome;
    const Stopwatch watch;
    outcome.diagnosis = make();
    if (!outcome.ok()) return outcome;
    const double parametrize = watch.milliseconds();
    std::vector<const Bridge_side*> sides;
    std::vector<const Bridge_grid*> grids;
    for (const Bridge_side& side : sides_) sides.push_back(&side);
    for (const Bridge_grid& grid : grids_) grids.push_back(&grid);
    Bridge_cut cut = cut_strips(sharp_.mesh, sides, sharp_.curves);
    if (cut.diagnosis.ok())
      outcome = sew({&sharp_.mesh, sharp_.origins, sharp_.whole, true}, cut, take_mesh(cut, sharp_.mesh), grids, out);
    else
      outcome.diagnosis = cut.diagnosis;
    for (const Bridge_grid& grid : grids_) outcome.bridges.push_back(report(grid, outcome.diagnosis));
    outcome.times.parametrize = parametrize;
    outcome.times.trim = watch.milliseconds() - parametrize - outcome.times.validate;
    return outcome;
  }

 private:
  static Base_surface::Options surface_options(const Bridge_options& options) {
    Base_surface::Options result;
    result.smooth_angle = options.smooth_angle;
    return result;
  }

  Diagnosis make() {
    const Bridge_shape shape{{ends_[0].lambda, ends_[1].lambda}, options_.mu, options_.order};
    for (const Loop& loop : sharp_.loops) {
      for (std::size_t k : {0, 1}) {
        sides_.push_back(make_side(surface_, source_of(sharp_.mesh, loop, k == 1), ends_[k], options_));
        Diagnosis diagnosis = sides_.back().diagnosis;
        if (diagnosis.ok()) continue;
        diagnosis.detail =
            (k == 0 ? "first body" : "second body") + (diagnosis.detail.empty() ? "" : ": " + diagnosis.detail);
        if (!diagnosis.point) diagnosis.point = sharp_.mesh.point(sharp_.mesh.source(loop.front()));
        return diagnosis;
      }
      const std::array<const Bridge_side*, 2> pair{&sides_[sides_.size() - 2], &sides_.back()};
      grids_.emplace_back(pair, 0, shape, options_);  // both start at the same vertex, and run against each other
    }
    return {};
  }

  static Bridge_report report(const Bridge_grid& grid, const Diagnosis& diagnosis) {
    Bridge_report result;
    result.diagnosis = diagnosis;
    result.segments = grid.s().size();
    result.rows = grid.t().size() - 1;
    result.tangency_deg = std::max(grid.side(0).tangency_deg(), grid.side(1).tangency_deg());
    result.safe_radius = {grid.side(0).polar->safe_radius(), grid.side(1).polar->safe_radius()};
    return result;
  }

  const Bridge_union& sharp_;
  const std::array<Bridge_end, 2>& ends_;
  const Bridge_options& options_;
  Base_surface surface_;
  std::deque<Bridge_side> sides_;  // their addresses stay
  std::deque<Bridge_grid> grids_;
};

Bridge_outcome bridge_crossing(const Blend_mesh& a, const Blend_mesh& b, const std::array<Bridge_end, 2>& ends,
                               Blend_mesh& out, const Bridge_options& options) {
  Bridge_outcome outcome;
  const auto goes_on = [&](double done) {
    if (outcome.ok() && options.progress && !options.progress(done)) outcome.diagnosis.status = Status::cancelled;
    return outcome.ok();
  };
  outcome.diagnosis = check_options(ends, options);
  if (!goes_on(0)) return outcome;
  const Bridge_union sharp = unite(a, b);
  outcome.diagnosis = sharp.diagnosis;
  if (!goes_on(0.5)) return outcome;
  return Crossing_bridges(sharp, ends, options).run(out);
}

/// The same for bodies with holes, whose fillings must go as well.
Bridge_outcome bridge_filled(const Blend_mesh& a, const Blend_mesh& b, const std::array<Bridge_end, 2>& ends,
                             Blend_mesh& out, const Bridge_options& options) {
  const std::array<Filled_mesh, 2> filled{fill_mesh(a), fill_mesh(b)};
  Bridge_outcome outcome;
  outcome.diagnosis = filled[0].diagnosis.ok() ? filled[1].diagnosis : filled[0].diagnosis;
  if (outcome.ok()) outcome = bridge_crossing(filled[0].mesh, filled[1].mesh, ends, out, options);
  if (!outcome.ok()) return outcome;
  const std::size_t before = filled[0].mesh.number_of_faces(), moved = before - filled[0].own_faces;
  std::array<std::vector<std::uint32_t>, 2> origins;
  for (std::uint32_t& origin : outcome.origins) {
    if (origin == no_origin) continue;
    const bool second = origin >= before;
    origins[second ? 1 : 0].push_back(second ? origin - static_cast<std::uint32_t>(before) : origin);
    if (second) origin -= static_cast<std::uint32_t>(moved);
  }
  for (const std::size_t k : {0, 1}) {
    Diagnosis left = unchecked::check_fillings(filled[k], origins[k], {});
    if (left.ok()) continue;
    outcome = {};
    outcome.diagnosis = std::move(left);
    out.clear();
    break;
  }
  return outcome;
}

}  // namespace

namespace unchecked {

Bridge_outcome bridge_intersection(const Blend_mesh& a, const Blend_mesh& b, const std::array<Bridge_end, 2>& ends,
                                   Blend_mesh& out, const Bridge_options& options) {
  Blend_mesh result;  // `out` may be an operand
  const bool fills = options.fill_holes && !(CGAL::is_closed(a) && CGAL::is_closed(b));
  Bridge_outcome outcome =
      fills ? bridge_filled(a, b, ends, result, options) : bridge_crossing(a, b, ends, result, options);
  for (Bridge_report& report : outcome.bridges) report.lambda = {ends[0].lambda, ends[1].lambda};
  out = std::move(result);
  return outcome;
}

}  // namespace unchecked

}  // namespace cgal_blend
