// SPDX-License-Identifier: GPL-3.0-or-later
#include "pass_engine.h"

#include "fillet_radius.h"
#include "refusal.h"
#include "stopwatch.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

namespace cgal_blend {

namespace {

// Views that are tried in the search for the largest radius.
constexpr std::size_t quick_levels = 4;

// Edges that bend the other way count as rounded if they make up less than this share of a curve.
constexpr double rounding_share = 1e-9;

}  // namespace

Pass_engine::Pass_engine(const Fillet_body& body, const Fillet_options& options, bool thorough,
                         const Earlier_blends& earlier)
    : earlier_(earlier),
      creases_(earlier.creases.begin(), earlier.creases.end()),
      blend_faces_(earlier.faces.begin(), earlier.faces.end()),
      body_(body),
      options_(options),
      levels_(thorough ? smoothings.size() : quick_levels) {
  creases_.insert(body.creases.begin(), body.creases.end());
}

Fillet_pass Pass_engine::run(const std::vector<Edge_blend>& blends, Blend_mesh& out) {
  Stopwatch watch;
  Fillet_pass pass;
  Fillet_outcome& outcome = pass.outcome;
  outcome.diagnosis = prepare(blends);
  if (!given_up_.empty()) {
    pass.flat_corners = given_up_;
    pass.again = true;
    return pass;
  }
  while (outcome.diagnosis.ok()) {
    outcome.diagnosis = roll_all();
    pass.again = options_.keep_going && refused_at_corner();
    if (!outcome.diagnosis.ok() || pass.again) break;
    Fillet_assembly assembly = assemble();
    if (assembly.diagnosis.ok()) {
      outcome = std::move(assembly.outcome);
      pass.later = std::move(assembly.later);
      pass.creases = std::move(assembly.creases);
      pass.corners = std::move(assembly.corners);
      out = std::move(assembly.mesh);
      break;
    }
    outcome.diagnosis = escalate(assembly.blame, assembly.diagnosis);
  }
  if (!outcome.ok() && outcome.diagnosis.status != Status::cancelled)
    pass.again = options_.keep_going && refused_at_corner();
  if (!outcome.ok()) out.clear();
  if (!pass.again) blame_edges();
  for (const Fillet_job& job : jobs_) {
    if (job.between) {
      if (!job.report.diagnosis.ok()) pass.flat_corners.push_back(job.between->corner);
      continue;
    }
    if (pass.again && job.report.diagnosis.ok()) continue;
    if (job.waits && job.report.diagnosis.ok() && outcome.ok()) continue;
    if (!job.report.diagnosis.ok()) pass.refused.push_back({outcome.blends.size(), blend_of(job)});
    outcome.blends.push_back(job.report);
  }
  outcome.times = aside_;
  outcome.times.blend = watch.milliseconds() - aside_.copy - aside_.validate;
  return pass;
}

Diagnosis Pass_engine::prepare(const std::vector<Edge_blend>& blends) {
  for (const Edge_blend& blend : blends) creases_.insert(blend.edges.begin(), blend.edges.end());
  for (const Edge_blend& blend : joined(blends)) {
    const Radius_law law = radius_law_of(blend, options_);
    if (Diagnosis bad = law.check(); !bad.ok()) return bad;
    const Curve_network<Blend_mesh> network = chain(blend.edges, law.largest());
    const Branch_laws radii = laws_along(*body_.mesh, network, blend, options_);
    if (!radii.diagnosis.ok()) return radii.diagnosis;
    for (std::size_t k = 0; k < network.branches.size(); ++k) {
      const Branch<Blend_mesh>& branch = network.branches[k];
      Fillet_job job;
      job.law = radii.laws[k];
      job.halfedges = branch.halfedges;
      job.own_profile = blend.profile;
      job.profile = blend.profile.value_or(options_.profile);
      job.report.edges = branch.halfedges.size();
      job.report.radius = job.law->largest();
      job.report.closed = job.curve.closed = branch.closed();
      if (!branch.closed())
        job.ends = {network.nodes[branch.first_node].vertex, network.nodes[branch.last_node].vertex};
      job.report.diagnosis = branch.closed() || body_.own_surface ? make_curve(job) : node_refusal(network, branch);
      jobs_.push_back(std::move(job));
    }
  }
  if (jobs_.empty()) return {Status::no_edges_selected, "", {}, {}};
  for (std::size_t i = 0; i < jobs_.size(); ++i)
    if (!jobs_[i].report.closed)
      for (const int end : {0, 1}) nodes_[jobs_[i].ends[end]].push_back({i, end});
  for (Fillet_job& job : jobs_)
    if (!job.report.closed && job.report.diagnosis.ok()) job.report.diagnosis = refuse_open(job);
  if (body_.own_surface) {
    resume_corners();
    set_order();
  }
  return first_refusal();
}

Base_surface::Options Pass_engine::open_surface_options(std::size_t level) const {
  Base_surface::Options options;
  options.smooth_angle = std::min(options_.smooth_angle, open_angles[level]);
  options.edge_points = &body_.edge_points;
  return options;
}

bool Pass_engine::wants_the_same(const Edge_blend& a, const Edge_blend& b) {
  const auto is_plain = [](const Edge_blend& blend) { return !blend.profile && !blend.law && !blend.start; };
  return is_plain(a) && is_plain(b) && a.radius == b.radius;
}

std::vector<Edge_blend> Pass_engine::joined(const std::vector<Edge_blend>& blends) const {
  if (!body_.own_surface) return blends;
  std::vector<std::size_t> group(blends.size());
  std::iota(group.begin(), group.end(), std::size_t{0});
  const auto root = [&](std::size_t i) {
    while (group[i] != i) i = group[i];
    return i;
  };
  std::unordered_map<Vertex, std::vector<std::size_t>> at;  // which blends have an edge there
  for (std::size_t i = 0; i < blends.size(); ++i)
    for (const Edge e : blends[i].edges)
      for (const int end : {0, 1}) {
        std::vector<std::size_t>& here = at[body_.mesh->vertex(e, end)];
        for (const std::size_t k : here) {
          if (!wants_the_same(blends[k], blends[i])) continue;
          const std::size_t a = root(i), b = root(k);
          group[std::max(a, b)] = std::min(a, b);
        }
        if (here.empty() || here.back() != i) here.push_back(i);
      }
  std::vector<Edge_blend> result;
  std::map<std::size_t, std::size_t> place;
  for (std::size_t i = 0; i < blends.size(); ++i) {
    const auto [into, is_new] = place.emplace(root(i), result.size());
    if (is_new)
      result.push_back(blends[i]);
    else
      result[into->second].edges.insert(result[into->second].edges.end(), blends[i].edges.begin(),
                                        blends[i].edges.end());
  }
  return result;
}

Curve_network<Blend_mesh> Pass_engine::chain(const std::vector<Edge>& edges, double radius) const {
  if (!body_.own_surface) return make_curve_network(*body_.mesh, edges);
  const Base_surface surface(*body_.mesh, surface_options(smoothings[0], radius), &creases_, &blend_faces_);
  return make_curve_network(*body_.mesh, edges,
                            [&](Halfedge in, Halfedge out) { return is_one_curve(surface, in, out); });
}

Base_surface::Options Pass_engine::surface_options(const Smoothing& how, double radius) const {
  Base_surface::Options options;
  options.smooth_angle = std::max(options_.smooth_angle, how.smooth_angle);
  options.shortest_crease = how.shortest_crease * radius;
  options.smoothing_passes = how.passes;
  options.edge_points = &body_.edge_points;
  return options;
}

Diagnosis Pass_engine::refuse_open(const Fillet_job& job) const {
  const Vec at = to_vec(body_.mesh->point(job.ends[0]));
  Diagnosis diagnosis;
  if (options_.mode == Blend_mode::map) {
    diagnosis = refusal(Status::open_branch, at);
    diagnosis.detail = "the map mode needs closed curves";
  } else if (job.profile.is_sharp()) {
    diagnosis = refusal(Status::open_branch, at);
    diagnosis.detail = "sharpening needs closed curves";
  }
  return diagnosis;
}

Diagnosis Pass_engine::node_refusal(const Curve_network<Blend_mesh>& network, const Branch<Blend_mesh>& branch) const {
  for (const std::size_t n : {branch.first_node, branch.last_node})
    if (!network.nodes[n].is_end()) return refusal(Status::corner, to_vec(body_.mesh->point(network.nodes[n].vertex)));
  return refusal(Status::open_branch, to_vec(body_.mesh->point(network.nodes[branch.first_node].vertex)));
}

Diagnosis Pass_engine::make_curve(Fillet_job& job) const {
  const Blend_mesh& mesh = *body_.mesh;
  double ridge = 0, groove = 0;  // how much of the curve bends outward, and how much inward
  Vec turn = Vec::Zero();        // where it bends the other way
  for (const Halfedge h : job.halfedges) {
    const Face left = mesh.face(h), right = mesh.face(mesh.opposite(h));
    const std::array<int, 2> operand{body_.cells.operand(left), body_.cells.operand(right)};
    if (job.curve.points.empty()) job.operand = operand;
    const Vec at = to_vec(mesh.point(mesh.source(h)));
    if (operand != job.operand) return refusal(Status::corner, at);
    job.curve.points.push_back(at);
    job.curve.faces.push_back({body_.cells.base_face(left), body_.cells.base_face(right)});
    const double bend = bend_at(job, to_vec(mesh.point(mesh.target(h))) - at);
    (bend > 0 ? ridge : groove) += std::abs(bend);
    if ((bend > 0) != (ridge > groove)) turn = at;
  }
  if (!job.curve.closed) job.curve.points.push_back(to_vec(mesh.point(mesh.target(job.halfedges.back()))));
  if (!(ridge + groove > 0)) return refusal(Status::edge_is_smooth, job.curve.points.front());
  if (std::min(ridge, groove) > rounding_share * (ridge + groove)) return refusal(Status::mixed_convexity, turn);
  job.curve.convex = job.report.convex = ridge > groove;
  return {};
}

double Pass_engine::bend_at(const Fillet_job& job, const Vec& edge) const {
  std::array<Vec, 2> n;
  for (int side = 0; side < 2; ++side) {
    const Blend_mesh& base = *body_.base[job.operand[side]];
    const Halfedge h = base.halfedge(job.curve.faces.back()[side]);
    const Vec a = to_vec(base.point(base.source(h))), b = to_vec(base.point(base.target(h)));
    n[side] = (b - a).cross(to_vec(base.point(base.target(base.next(h)))) - a).stableNormalized();
    if (body_.reversed[job.operand[side]]) n[side] = -n[side];
  }
  return n[0].cross(n[1]).dot(edge);
}

std::optional<Vec> Pass_engine::find_corner(const Fillet_job& job, const Vec& at) {
  std::optional<Vec> nearest;
  for (std::size_t i = 0; i < job.curve.points.size(); ++i)
    for (int side = 0; side < 2; ++side) {
      if (!job.curve.closed && i + 2 >= job.curve.points.size()) continue;
      const Base_surface& surface = base_surface(job, side);
      const Vec& place = job.curve.points[job.curve.next(i)];
      const Face before = job.curve.faces[i][side], after = job.curve.faces[job.curve.next(i)][side];
      if (before == after || (nearest && (place - at).norm() >= (*nearest - at).norm())) continue;
      const Blend_mesh& base = surface.mesh();
      for (const Halfedge h : base.halfedges_around_face(base.halfedge(before)))
        if (base.face(base.opposite(h)) == after && !surface.crossable(h)) nearest = place;
    }
  return nearest;
}

const Base_surface& Pass_engine::base_surface(const Fillet_job& job, int side) {
  const int operand = job.operand[side];
  const bool round = job.profile.is_sharp();
  std::unique_ptr<Base_surface>& surface =
      surfaces_[{job.level, operand, job.report.radius, round, kind_of_rolling(job)}];
  if (!surface) {
    Base_surface::Options options = surface_options(smoothings[job.level], job.report.radius);
    options.reversed = body_.reversed[operand];
    options.area_weights = round;
    set_rolling(job, options);
    surface = std::make_unique<Base_surface>(*body_.base[operand], options, body_.own_surface ? &creases_ : nullptr,
                                             body_.own_surface ? &blend_faces_ : nullptr);
  }
  return *surface;
}

void Pass_engine::set_rolling(const Fillet_job& job, Base_surface::Options& options) {
  options.rolling_radius = job.over_edges ? job.report.radius : 0;
  options.ball_inside = job.curve.convex;
}

Diagnosis Pass_engine::first_refusal() const {
  const Fillet_job* refused = nullptr;
  bool some = false;
  for (const Fillet_job& job : jobs_) {
    if (job.report.diagnosis.ok())
      some = some || (!job.waits && !job.between);
    else if (!refused)
      refused = &job;
  }
  if (!refused || (options_.keep_going && some)) return {};
  return refused->report.diagnosis;
}

}  // namespace cgal_blend
