// SPDX-License-Identifier: GPL-3.0-or-later
#include "fillet_in_passes.h"

#include "ancestry.h"
#include "edge_finder.h"
#include "fillet_engine.h"
#include "fillet_radius.h"
#include "stopwatch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

namespace cgal_blend {

namespace {

// The search for the largest radius: downward, then by halving until two radii are so near.
constexpr std::array<double, 9> first_shares{0.98, 0.9, 0.75, 0.5, 0.25, 0.125, 0.0625, 0.03125, 0.015625};
constexpr double near_radii = 1.012;

// What the search may cost, over all curves: faces of the meshes that it goes through, and of the blends.
constexpr double most_faces = 400000;

struct Passes {
  Fillet_outcome outcome;
  std::vector<std::pair<std::size_t, Edge_blend>> refused;  // in the first pass, by the place of their report
};

Passes run_passes(const Fillet_body& body, const std::vector<Edge_blend>& blends, Blend_mesh& out,
                  const Fillet_options& options, bool thorough) {
  Fillet_pass pass = fillet_pass(body, blends, {}, out, options, thorough);
  Passes result{std::move(pass.outcome), std::move(pass.refused)};
  Fillet_outcome& whole = result.outcome;
  if (!whole.ok() || pass.later.empty()) return result;
  Ancestry ancestry(whole);
  std::vector<Later_blend::Step> creases;
  for (const Edge e : body.creases)
    creases.emplace_back(body.mesh->point(body.mesh->vertex(e, 0)), body.mesh->point(body.mesh->vertex(e, 1)));
  while (!pass.later.empty()) {
    Blend_mesh mesh = std::move(out);
    out.clear();
    const Edge_finder find(mesh);
    std::vector<Edge_blend> next;
    for (const Later_blend& later : pass.later) {
      Edge_blend blend{find(later.edges), later.radius, later.profile, later.law};
      if (later.law) blend.start = find.first(later.edges);
      if (!blend.edges.empty()) next.push_back(std::move(blend));  // else an earlier blend has taken it up
    }
    if (next.empty()) {
      out = std::move(mesh);
      break;
    }
    creases.insert(creases.end(), pass.creases.begin(), pass.creases.end());
    Earlier_blends earlier{find(creases), {}, pass.corners};
    for (const Face f : mesh.faces())
      if (ancestry.origins[f.idx()] == no_origin) earlier.faces.push_back(f);
    Fillet_body rest;
    rest.mesh = rest.base[0] = rest.base[1] = &mesh;
    pass = fillet_pass(rest, next, earlier, out, options, thorough);
    add(whole.times, pass.outcome.times);
    if (!pass.outcome.ok())  // what could have been made is not made either
      for (Blend_report& report : pass.outcome.blends)
        if (report.diagnosis.ok()) report.diagnosis = pass.outcome.diagnosis;
    whole.blends.insert(whole.blends.end(), pass.outcome.blends.begin(), pass.outcome.blends.end());
    if (!pass.outcome.ok()) {
      if (options.keep_going && pass.outcome.diagnosis.status != Status::cancelled) {
        out = std::move(mesh);  // with the blends so far
        break;
      }
      whole.diagnosis = pass.outcome.diagnosis;
      out.clear();
      return result;
    }
    ancestry.advance(pass.outcome, 0);
    whole.volume = pass.outcome.volume;
    whole.area = pass.outcome.area;
  }
  const Stopwatch copying;
  ancestry.put_kept_first(out);
  ancestry.describe_faces(whole);
  whole.times.copy += copying.milliseconds();
  return result;
}

/// Finds the largest radius for blends that are refused, by trial, with all of their radii in proportion.
class Radius_search {
 public:
  Radius_search(const Fillet_body& body, const Fillet_options& options)
      : body_(body), options_(options) {
    options_.keep_going = false;
    options_.progress = nullptr;
    progress_ = options.progress;
  }

  static bool may_help(Status status) {
    return status == Status::radius_exceeds_face || status == Status::radius_exceeds_curvature ||
           status == Status::no_rolling_ball || status == Status::blend_collides || status == Status::blends_overlap ||
           status == Status::corner;
  }

  /// The share of their radii at which all of the blends work; none if it is not found.
  std::optional<double> operator()(const std::vector<Edge_blend>& blends) {
    double works = 0, fails = 1;
    for (const double share : first_shares) {
      if (!may_try(blends, share)) return std::nullopt;
      if (fits(blends, share)) {
        works = share;
        break;
      }
      fails = share;
    }
    if (works == 0) return std::nullopt;
    while (fails > near_radii * works && may_try(blends, works)) {
      const double middle = (works + fails) / 2;
      (fits(blends, middle) ? works : fails) = middle;
    }
    return works;
  }

 private:
  bool may_try(const std::vector<Edge_blend>& blends, double share) {
    faces_left_ -= static_cast<double>(body_.mesh->number_of_faces());
    const double facet = 2 * std::sqrt(2 * options_.chord_tolerance);  // of the arc, in radii
    for (const Edge_blend& blend : blends) {
      double length = 0;
      for (const Edge e : blend.edges)
        length += std::sqrt(CGAL::squared_distance(body_.mesh->point(body_.mesh->vertex(e, 0)),
                                                   body_.mesh->point(body_.mesh->vertex(e, 1))));
      faces_left_ -= length / (6 * facet * share * radius_law_of(blend, options_).largest()) * 4 / facet;
    }
    return faces_left_ > 0 && (!progress_ || progress_(1));
  }

  bool fits(std::vector<Edge_blend> blends, double share) {
    for (Edge_blend& blend : blends) {
      const Radius_law law = radius_law_of(blend, options_);
      blend.radius = share * law.largest();
      if (!law.is_constant()) blend.law = law.scaled(share);
      else blend.law.reset();
    }
    Fillet_options options = options_;
    options.law.reset();
    Blend_mesh ignored;
    return run_passes(body_, blends, ignored, options, false).outcome.ok();
  }

  const Fillet_body& body_;
  Fillet_options options_;
  double faces_left_ = most_faces;
  std::function<bool(double)> progress_;
};

bool is_sharpened(const Edge_blend& blend, const Fillet_options& options) {
  return blend.profile.value_or(options.profile).is_sharp();
}

}  // namespace

Fillet_outcome fillet_in_passes(const Fillet_body& body, const std::vector<Edge_blend>& blends, Blend_mesh& out,
                                const Fillet_options& options, bool search_radius) {
  Passes result = run_passes(body, blends, out, options, true);
  Fillet_outcome& outcome = result.outcome;
  if (!search_radius) return std::move(outcome);
  Radius_search search(body, options);
  if (!outcome.ok()) {
    const bool sharpens = std::any_of(blends.begin(), blends.end(),
                                      [&](const Edge_blend& blend) { return is_sharpened(blend, options); });
    if (sharpens || !Radius_search::may_help(outcome.diagnosis.status)) return std::move(outcome);
    if (const auto share = search(blends))
      for (Blend_report& report : outcome.blends) {
        if (report.diagnosis.ok() || !Radius_search::may_help(report.diagnosis.status)) continue;
        report.diagnosis.max_radius = *share * report.radius;
        if (report.diagnosis.point == outcome.diagnosis.point) outcome.diagnosis.max_radius = *share * report.radius;
      }
    return std::move(outcome);
  }
  for (const auto& [place, blend] : result.refused) {
    Diagnosis& diagnosis = outcome.blends[place].diagnosis;
    if (!Radius_search::may_help(diagnosis.status) || is_sharpened(blend, options)) continue;
    if (const auto share = search({blend})) diagnosis.max_radius = *share * outcome.blends[place].radius;
  }
  return std::move(outcome);
}

}  // namespace cgal_blend
