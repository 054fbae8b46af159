// SPDX-License-Identifier: GPL-3.0-or-later
#include "pass_engine.h"

#include "blend_strip.h"
#include "map_region.h"
#include "refusal.h"

#include <algorithm>

namespace cgal_blend {

namespace {

// A blend whose vertices are farther off the ball than this, in radii, is none. Rims on facets that are rough at the
// scale of the ball come near it; on smooth surfaces the error is below 1 %.
constexpr double worst_radius_error = 0.25;

// Nor is one that leaves the facets at such angles, degrees: then the smoothed normals are those of no surface here.
constexpr double worst_tangency = 60;

constexpr double worst_mean_tangency = 15;

// Nor one whose facets turn against each other by such angles, degrees, from one step of the ball to the next.
constexpr double worst_twist = 60;

// Positions that the rims cannot be led through may be left out, up to this share.
constexpr double spare_positions = 0.2;

// The view in which corners are looked for.
constexpr std::size_t corner_level = 1;

// A rim keeps this far from vertices and edges that it does not run through.
constexpr double snap_of_radius = 0.01;

constexpr double snap_of_facet = 0.1;

bool status_is_of_mapping(Status status) {
  return status == Status::region_not_annular || status == Status::parametrization_folds ||
         status == Status::region_too_coarse;
}

}  // namespace

std::size_t Pass_engine::levels_of(const Fillet_job& job) const {
  return job.profile.is_sharp() ? 1 : job.curve.closed ? levels_ : open_angles.size();
}

Diagnosis Pass_engine::roll_all() {
  for (std::size_t i = 0; i < jobs_.size(); ++i) {
    Fillet_job& job = jobs_[i];
    if (job.rolled || job.waits || job.swallowed || !job.report.diagnosis.ok()) continue;
    progress_ = static_cast<double>(i) / static_cast<double>(jobs_.size());
    if (is_cancelled()) return {Status::cancelled, "", {}, {}};
    for (; job.level < levels_of(job); ++job.level) {
      const Diagnosis diagnosis = roll(job, i);
      job.rolled = diagnosis.ok();
      if (job.rolled) break;
      if (!job.first_failure) job.first_failure = diagnosis;
      // Smoother views would only hide that the ball does not fit.
      if (!options_.mend_spine && diagnosis.status == Status::radius_exceeds_curvature) break;
    }
    if (!job.rolled) refuse(job);
    if (job.report.diagnosis.status == Status::radius_exceeds_face) roll_over_edges(job, i);
  }
  return first_refusal();
}

void Pass_engine::roll_over_edges(Fillet_job& job, std::size_t index) {
  if (options_.mode == Blend_mode::map || job.profile.is_sharp() || job.over_edges || job.between) return;
  job.over_edges = true;
  job.level = 0;  // smoother views would round the edges off
  job.report.over_edges = job.rolled = roll(job, index).ok();
  if (job.rolled) job.report.diagnosis = {};
}

Diagnosis Pass_engine::roll(Fillet_job& job, std::size_t index) {
  if (!job.curve.closed) return roll_to_ends(job, index);
  const std::array<const Base_surface*, 2> surfaces{&base_surface(job, 0), &base_surface(job, 1)};
  const double radius = job.report.radius;
  Sampling steps = sampling(options_.chord_tolerance);
  const double snap = radius * std::min(snap_of_radius, snap_of_facet * steps.finest);
  steps.spacing = std::min(steps.coarsest, steps.finest * smoothings[job.level].coarsening);
  steps.samples = options_.samples;
  steps.chord_ratio = options_.chord_ratio;
  steps.mend_loops = options_.mend_spine;
  const Curve_kind kind = job.profile.is_sharp() ? Curve_kind::round : Curve_kind::crease;
  Ball_path path = roll_ball(surfaces, job.curve, kind, *job.law, steps);
  if (!path.diagnosis.ok()) return path.diagnosis;
  job.positions = std::move(path.positions);
  job.report.loops = path.loops;
  const Diagnosis laid = lay_rims(job, index, surfaces, snap);
  if (!laid.ok()) return laid;
  job.surface.emplace(job.positions, surfaces, job.profile);
  return judge(job);
}

Diagnosis Pass_engine::roll_to_ends(Fillet_job& job, std::size_t index) {
  const double radius = job.report.radius;
  Open_branch& branch = job.open.emplace();
  Base_surface::Options view = open_surface_options(job.level);
  set_rolling(job, view);
  branch.surface = std::make_unique<Base_surface>(*body_.mesh, view, &creases_, &blend_faces_);
  branch.between_balls = job.between.has_value();
  job.report.flat_ends = 0;
  for (const int end : {0, 1}) view_end_of(job, index, end);
  Sampling steps = sampling(options_.chord_tolerance);
  steps.samples = options_.samples;
  steps.chord_ratio = options_.chord_ratio;
  Open_roll roll =
      roll_open(branch, job.curve, *job.law, job.profile, options_.chord_tolerance, steps, open_snap(radius));
  if (!roll.diagnosis.ok()) return roll.diagnosis;
  job.positions = std::move(roll.positions);
  job.surface = std::move(roll.surface);
  job.rims = std::move(roll.rims);
  for (Rim& rim : job.rims) rim.blend = index;
  return judge(job);
}

void Pass_engine::view_end_of(Fillet_job& job, std::size_t index, int end) {
  Open_branch& branch = *job.open;
  Branch_end& e = branch.ends[end];
  const Blend_corner* corner = ball_at(job, index, end);
  if (corner) branch.place[end] = place_in_corner(*corner, {index, end});
  const bool is_complete = corner && std::none_of(corner->branches.begin(), corner->branches.end(), [&](const auto& b) {
                             return b.first != Blend_corner::no_branch && jobs_[b.first].waits;
                           });
  if (!is_complete) {
    branch.through[end] = corner;
    e = view_end(*branch.surface, into({index, end}), end, job.curve.convex, job.report.radius);
    job.report.flat_ends += e.kind == Branch_end::Kind::cap ? 1 : 0;
    return;
  }
  e.kind = Branch_end::Kind::ball;
  e.end = end;
  branch.corner[end] = corner;
  if (job.between) {
    e.direction = (end == 1 ? 1 : -1) * (job.curve.points[1] - job.curve.points[0]).normalized();
    return;
  }
  e.into = into({index, end});
  e.direction =
      (to_vec(body_.mesh->point(body_.mesh->target(e.into))) - to_vec(body_.mesh->point(body_.mesh->source(e.into))))
          .normalized();
}

const Blend_corner* Pass_engine::ball_at(const Fillet_job& job, std::size_t index, int end) const {
  const Vertex v = job.ends[end];
  if (job.between) return &corners_.at(v)[job.between->ball[end]];
  const auto resumed = resumed_.find(v);
  if (resumed != resumed_.end()) return &corners_.at(resumed->second).front();
  if (!rest_.at(v)) return nullptr;
  const std::pair<std::size_t, int> branch(index, end);
  for (const Blend_corner& corner : corners_.at(rest_.corner_of.at(v)))
    if (std::find(corner.branches.begin(), corner.branches.end(), branch) != corner.branches.end()) return &corner;
  return nullptr;
}

double Pass_engine::open_snap(double radius) const {
  return radius * std::min(snap_of_radius, snap_of_facet * sampling(options_.chord_tolerance).finest);
}

Diagnosis Pass_engine::folded(const Fillet_job& job, const Vec& at) {
  return refusal(job.report.loops > 0 ? Status::radius_exceeds_curvature : Status::no_rolling_ball, at);
}

Diagnosis Pass_engine::lay_rims(Fillet_job& job, std::size_t index, const std::array<const Base_surface*, 2>& surfaces,
                                double snap) const {
  const auto fewest = static_cast<std::size_t>((1 - spare_positions) * static_cast<double>(job.positions.size()));
  for (int side = 0; side < 2;) {
    std::vector<Surface_point> feet;
    for (const Ball_position& p : job.positions) feet.push_back(p.foot[side]);
    std::size_t stuck = 0;
    auto rim = closed_path(*surfaces[side], feet, snap, stuck);
    if (rim) {
      job.rims[side] = {surfaces[side], job.operand[side], std::move(*rim), side == 0, index, {}};
      ++side;
      continue;
    }
    const Vec at = job.positions[stuck].contact[side];
    if (job.positions.size() <= std::max<std::size_t>(fewest, 4)) return refusal(Status::no_rolling_ball, at);
    job.positions.erase(job.positions.begin() + static_cast<std::ptrdiff_t>(stuck));
    side = 0;  // the rims share their positions
  }
  return {};
}

Diagnosis Pass_engine::judge(Fillet_job& job) {
  const Strip_quality quality = measure_rims(job.positions, {&job.rims[0], &job.rims[1]});
  job.report.radius_error = quality.radius_error;
  job.report.tangency_deg = quality.tangency_deg;
  if (quality.radius_error > worst_radius_error || quality.tangency_deg > worst_tangency ||
      quality.mean_tangency_deg > worst_mean_tangency)
    return refusal(Status::no_rolling_ball, quality.worst);
  std::size_t first = 0, past = job.positions.size();
  if (job.open) {  // beyond the ends the ball may roll as it likes
    const std::array<Strip_end, 2>& ends = job.open->strip_ends;
    first = *std::min_element(ends[0].last.begin(), ends[0].last.end());
    past = *std::max_element(ends[1].last.begin(), ends[1].last.end()) + 1;
  }
  if (const auto twist = job.surface->find_twist(worst_twist * pi / 180, first, past)) return folded(job, *twist);
  if (!job.profile.is_arc()) job.report.tangency_deg = measure_tangency(*job.surface);
  return {};
}

void Pass_engine::blame_edges() {
  for (const Fillet_job& job : jobs_)
    if (job.between && !job.report.diagnosis.ok())
      for (const auto& [i, end] : rest_.corners.at(job.between->corner).branches)
        if (jobs_[i].report.diagnosis.ok()) jobs_[i].report.diagnosis = job.report.diagnosis;
}

bool Pass_engine::refused_at_corner() const {
  if (std::any_of(jobs_.begin(), jobs_.end(),
                  [](const Fillet_job& job) { return job.between && !job.report.diagnosis.ok(); }))
    return true;
  for (const auto& [v, node] : nodes_) {
    const auto refused = std::count_if(node.begin(), node.end(),
                                       [&](const auto& branch) { return !jobs_[branch.first].report.diagnosis.ok(); });
    if (refused > 0 && refused < static_cast<std::ptrdiff_t>(node.size())) return true;
  }
  return false;
}

Diagnosis Pass_engine::escalate(std::size_t blame, const Diagnosis& diagnosis) {
  Fillet_job& job = jobs_[blame];
  if (!job.first_failure) job.first_failure = diagnosis;
  job.rolled = false;
  // Slanted attempts would take the vertices of the curve off a profile's corners.
  const std::size_t attempts = job.profile.kinks().empty() ? mapping_attempts : straight_attempts;
  if (diagnosis.status == Status::region_too_coarse && ++job.attempt < attempts) {
    job.rolled = true;
    return first_refusal();
  }
  // Another view of the surfaces changes the ball's way, but not the mesh that has to follow it.
  const bool mesh_is_to_blame = status_is_of_mapping(diagnosis.status);
  if (mesh_is_to_blame) job.first_failure = diagnosis;
  if (mesh_is_to_blame || job.over_edges || ++job.level == levels_of(job)) refuse(job);
  return first_refusal();
}

void Pass_engine::refuse(Fillet_job& job) {
  job.level = corner_level;
  job.report.diagnosis = *job.first_failure;
  const auto at = job.first_failure->point;
  if (status_is_of_mapping(job.first_failure->status)) return;
  if (const auto corner = find_corner(job, at ? to_vec(*at) : job.curve.points.front()))
    job.report.diagnosis = refusal(Status::corner, *corner);
}

Edge_blend Pass_engine::blend_of(const Fillet_job& job) const {
  Edge_blend blend{{}, job.report.radius, job.own_profile};
  for (const Halfedge h : job.halfedges) blend.edges.push_back(body_.mesh->edge(h));
  if (job.law && !job.law->is_constant()) {
    blend.law = job.law;
    blend.start = body_.mesh->source(job.halfedges.front());
  }
  return blend;
}

}  // namespace cgal_blend
