// SPDX-License-Identifier: GPL-3.0-or-later
#include "fillet_engine.h"

#include "blend_curve.h"
#include "blend_strip.h"
#include "corner_patch.h"
#include "fill_loop.h"
#include "fillet_radius.h"
#include "map_region.h"
#include "open_branch.h"
#include "refusal.h"
#include "rolling_ball.h"
#include "sharp_mesh.h"
#include "stitching.h"
#include "stopwatch.h"
#include "trim.h"

#include <Eigen/Geometry>

#include <cgal_blend/curve_network.h>
#include <cgal_blend/validate.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <tuple>
#include <unordered_set>
#include <utility>

namespace cgal_blend {

namespace {

/// Ways to see a rough surface as smooth, tried in turn. Whatever the normals are, the ball touches exactly; what suffers
/// is tangency to the facets, and that is reported.
struct Smoothing {
  double smooth_angle;     // at least this, degrees
  double shortest_crease;  // in radii
  int passes;              // over the normals
  double coarsening;       // of the steps between positions
};
constexpr std::array<Smoothing, 6> smoothings{
    {{0, 0, 0, 1}, {0, 2, 3, 1}, {50, 4, 6, 1.5}, {60, 6, 12, 2}, {75, 8, 24, 3}, {75, 12, 48, 4}}};

// Angles at open branches, degrees, as far as the options allow: where they end counts, so the strict view comes first.
constexpr std::array<double, 2> open_angles{25, 180};

// Views that are tried in the search for the largest radius, and its steps: downward, then between the last two.
constexpr std::size_t quick_levels = 4;
constexpr std::array<double, 8> radius_shares{0.98, 0.9, 0.75, 0.5, 0.25, 0.125, 0.0625, 0.03125};
constexpr int radius_bisections = 4;

// A blend whose vertices are farther off the ball than this, in radii, is none. Rims on facets that are rough at the
// scale of the ball come near it; on smooth surfaces the error is below 1 %.
constexpr double worst_radius_error = 0.25;

// Nor is one that leaves the facets at such angles, degrees: then the smoothed normals are those of no surface here.
constexpr double worst_tangency = 60;
constexpr double worst_mean_tangency = 15;

// Nor one whose facets turn against each other by such angles, degrees, from one step of the ball to the next.
constexpr double worst_twist = 60;

// Nor one whose strip is folded, with its rims: angle between neighbouring facets, degrees.
constexpr double worst_fold = 100;

// Positions that the rims cannot be led through may be left out, up to this share.
constexpr double spare_positions = 0.2;

// The view in which corners are looked for.
constexpr std::size_t corner_level = 1;

// Edges that bend the other way count as rounded if they make up less than this share of a curve.
constexpr double rounding_share = 1e-9;

// A rim keeps this far from vertices and edges that it does not run through.
constexpr double snap_of_radius = 0.01;
constexpr double snap_of_facet = 0.1;

bool status_is_of_mapping(Status status) {
  return status == Status::region_not_annular || status == Status::parametrization_folds ||
         status == Status::region_too_coarse;
}

bool may_fit_smaller(Status status) {
  return status == Status::radius_exceeds_face || status == Status::radius_exceeds_curvature ||
         status == Status::no_rolling_ball || status == Status::blend_collides;
}

/// One branch on its way to becoming a blend.
struct Job {
  std::vector<Halfedge> halfedges;
  Blend_report report;
  Blend_curve curve;
  std::array<int, 2> operand{};
  std::size_t level = 0;    // of smoothing
  std::size_t attempt = 0;  // at mapping
  bool rolled = false;
  std::optional<Diagnosis> first_failure;
  Profile profile;
  std::vector<Ball_position> positions;
  std::array<Rim, 2> rims;
  std::optional<Virtual_surface> surface;
  std::optional<Open_branch> open;
  std::array<Vertex, 2> ends;  // of an open branch
};

struct Assembly {
  Diagnosis diagnosis;
  std::size_t blame = 0;  ///< job that the diagnosis is about
  Fillet_outcome outcome;
  Blend_mesh mesh;
};

class Engine {
 public:
  /// \param thorough try every view of the surfaces, and find the largest radius that works where one is refused
  Engine(const Fillet_body& body, const Fillet_options& options, bool thorough = true)
      : body_(body), options_(options), thorough_(thorough), levels_(thorough ? smoothings.size() : quick_levels) {}

  Fillet_outcome run(const std::vector<Edge_blend>& blends, Blend_mesh& out) {
    Stopwatch watch;
    Fillet_outcome outcome;
    outcome.diagnosis = prepare(blends);
    while (outcome.diagnosis.ok()) {
      outcome.diagnosis = roll_all();
      if (!outcome.diagnosis.ok()) break;
      Assembly assembly = assemble();
      if (assembly.diagnosis.ok()) {
        outcome = std::move(assembly.outcome);
        out = std::move(assembly.mesh);
        break;
      }
      outcome.diagnosis = escalate(assembly.blame, assembly.diagnosis);
    }
    if (thorough_ && outcome.diagnosis.status != Status::cancelled) find_largest_radii(outcome);
    if (!outcome.ok()) out.clear();
    for (const Job& job : jobs_) outcome.blends.push_back(job.report);
    outcome.times = aside_;
    outcome.times.blend = watch.milliseconds() - aside_.copy - aside_.validate;
    return outcome;
  }

 private:
  // Preparation: from edges to curves with a base face on either side.

  Diagnosis prepare(const std::vector<Edge_blend>& blends) {
    for (const Edge_blend& blend : blends) creases_.insert(blend.edges.begin(), blend.edges.end());
    for (const Edge_blend& blend : joined(blends)) {
      const Radius_law law = radius_law_of(blend, options_);
      if (Diagnosis bad = law.check(); !bad.ok()) return bad;
      const Curve_network<Blend_mesh> network = chain(blend.edges, law.largest());
      const Branch_laws radii = laws_along(*body_.mesh, network, blend, options_);
      if (!radii.diagnosis.ok()) return radii.diagnosis;
      if (!law.is_constant()) return {Status::not_supported, "a radius that varies along the curve", {}, {}};
      for (const Branch<Blend_mesh>& branch : network.branches) {
        Job job;
        job.halfedges = branch.halfedges;
        job.profile = blend.profile.value_or(options_.profile);
        job.report.edges = branch.halfedges.size();
        job.report.radius = law.largest();
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
    for (Job& job : jobs_)
      if (!job.report.closed && job.report.diagnosis.ok()) job.report.diagnosis = refuse_open(job);
    return first_refusal();
  }

  /// Blends that meet and want the same are one, so that their curves run on into each other.
  [[nodiscard]] std::vector<Edge_blend> joined(const std::vector<Edge_blend>& blends) const {
    std::vector<Edge_blend> result;
    if (!body_.own_surface) return blends;
    std::vector<std::unordered_set<Vertex>> vertices;
    for (const Edge_blend& blend : blends) {
      std::unordered_set<Vertex> own;
      for (const Edge e : blend.edges)
        for (const Halfedge h : {body_.mesh->halfedge(e, 0), body_.mesh->halfedge(e, 1)}) own.insert(body_.mesh->target(h));
      std::size_t into = result.size();
      for (std::size_t k = 0; k < result.size() && into == result.size(); ++k) {
        if (result[k].radius != blend.radius || result[k].profile || blend.profile) continue;
        if (result[k].law || blend.law || result[k].start || blend.start) continue;
        if (std::any_of(own.begin(), own.end(), [&](Vertex v) { return vertices[k].count(v) != 0; })) into = k;
      }
      if (into == result.size()) {
        result.push_back(blend);
        vertices.push_back(std::move(own));
      } else {
        result[into].edges.insert(result[into].edges.end(), blend.edges.begin(), blend.edges.end());
        vertices[into].insert(own.begin(), own.end());
      }
    }
    return result;
  }

  /// Branches between corners: where the faces on one side meet in a sharp edge, two edges are no one curve.
  [[nodiscard]] Curve_network<Blend_mesh> chain(const std::vector<Edge>& edges, double radius) const {
    if (!body_.own_surface) return make_curve_network(*body_.mesh, edges);
    const Base_surface surface(*body_.mesh, surface_options(smoothings[0], radius), &creases_);
    const Blend_mesh& mesh = *body_.mesh;
    return make_curve_network(mesh, edges, [&](Halfedge in, Halfedge out) {
      // Left of `in` and of `out`, and right of them.
      return surface.fan(in) == surface.fan(mesh.prev(out)) &&
             surface.fan(mesh.prev(mesh.opposite(in))) == surface.fan(mesh.opposite(out));
    });
  }

  [[nodiscard]] Base_surface::Options surface_options(const Smoothing& how, double radius) const {
    return {std::max(options_.smooth_angle, how.smooth_angle), how.shortest_crease * radius, how.passes, false, false};
  }

  /// What no open branch can be, wherever it ends.
  [[nodiscard]] Diagnosis refuse_open(const Job& job) const {
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

  [[nodiscard]] Diagnosis node_refusal(const Curve_network<Blend_mesh>& network, const Branch<Blend_mesh>& branch) const {
    for (const std::size_t n : {branch.first_node, branch.last_node})
      if (!network.nodes[n].is_end())
        return refusal(Status::corner, to_vec(body_.mesh->point(network.nodes[n].vertex)));
    return refusal(Status::open_branch, to_vec(body_.mesh->point(network.nodes[branch.first_node].vertex)));
  }

  Diagnosis make_curve(Job& job) const {
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

  /// Signed bend of the last edge of a curve times its length, by the base faces: those of a boolean's result may be too
  /// thin to have a normal, and its edges too short to have a direction.
  [[nodiscard]] double bend_at(const Job& job, const Vec& edge) const {
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

  /// Where two consecutive edges of the curve border on base faces that meet in a sharp edge, three surfaces meet. Finds
  /// the nearest such place to `at`.
  [[nodiscard]] std::optional<Vec> find_corner(const Job& job, const Vec& at) {
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

  const Base_surface& base_surface(const Job& job, int side) {
    const int operand = job.operand[side];
    const bool round = job.profile.is_sharp();
    std::unique_ptr<Base_surface>& surface = surfaces_[{job.level, operand, job.report.radius, round}];
    if (!surface) {
      const Smoothing& how = smoothings[job.level];
      surface = std::make_unique<Base_surface>(
          *body_.base[operand],
          Base_surface::Options{std::max(options_.smooth_angle, how.smooth_angle),
                                how.shortest_crease * job.report.radius, how.passes, body_.reversed[operand], round},
          body_.own_surface ? &creases_ : nullptr);
    }
    return *surface;
  }

  // Rolling, and what to do about failures.

  /// A smoother view would blur the round that is to be sharpened into the surfaces beyond it.
  [[nodiscard]] std::size_t levels_of(const Job& job) const {
    return job.profile.is_sharp() ? 1 : job.curve.closed ? levels_ : open_angles.size();
  }

  [[nodiscard]] bool is_cancelled() const { return options_.progress && !options_.progress(progress_); }

  Diagnosis roll_all() {
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      Job& job = jobs_[i];
      if (job.rolled || !job.report.diagnosis.ok()) continue;
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
    }
    return first_refusal();
  }

  Diagnosis roll(Job& job, std::size_t index) {
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
    Ball_path path = roll_ball(surfaces, job.curve, kind, radius, steps);
    if (!path.diagnosis.ok()) return path.diagnosis;
    job.positions = std::move(path.positions);
    job.report.loops = path.loops;
    const Diagnosis laid = lay_rims(job, index, surfaces, snap);
    if (!laid.ok()) return laid;
    job.surface.emplace(job.positions, surfaces, radius, job.profile);
    return judge(job);
  }

  Diagnosis roll_to_ends(Job& job, std::size_t index) {
    const double radius = job.report.radius;
    Base_surface::Options options = surface_options(smoothings[0], radius);
    options.smooth_angle = std::min(options_.smooth_angle, open_angles[job.level]);
    Open_branch& branch = job.open.emplace();
    branch.surface = std::make_unique<Base_surface>(*body_.mesh, options, &creases_);
    for (const int end : {0, 1}) {
      const Halfedge into = end == 1 ? job.halfedges.back() : body_.mesh->opposite(job.halfedges.front());
      const std::vector<std::pair<std::size_t, int>>& node = nodes_.at(job.ends[end]);
      if (node.size() == 1) {
        const End_view view = view_end(*branch.surface, into, end, job.curve.convex, radius);
        if (!view.diagnosis.ok()) return view.diagnosis;
        branch.ends[end] = view.end;
        continue;
      }
      Blend_corner* corner = corner_at(job.ends[end], *branch.surface);
      if (!corner) return refusal(Status::corner, to_vec(body_.mesh->point(job.ends[end])));
      Branch_end& e = branch.ends[end];
      e.kind = Branch_end::Kind::ball;
      e.end = end;
      e.into = into;
      e.direction = (to_vec(body_.mesh->point(body_.mesh->target(into))) -
                     to_vec(body_.mesh->point(body_.mesh->source(into)))).normalized();
      branch.corner[end] = corner;
    }
    Sampling steps = sampling(options_.chord_tolerance);
    steps.samples = options_.samples;
    steps.chord_ratio = options_.chord_ratio;
    Open_roll roll =
        roll_open(branch, job.curve, radius, job.profile, options_.chord_tolerance, steps, open_snap(radius));
    if (!roll.diagnosis.ok()) return roll.diagnosis;
    job.positions = std::move(roll.positions);
    job.surface = std::move(roll.surface);
    job.rims = std::move(roll.rims);
    for (Rim& rim : job.rims) rim.blend = index;
    return judge(job);
  }

  [[nodiscard]] double open_snap(double radius) const {
    return radius * std::min(snap_of_radius, snap_of_facet * sampling(options_.chord_tolerance).finest) / 4;
  }

  /// The ball at rest where several branches meet, if all that meets there is to be blended alike.
  Blend_corner* corner_at(Vertex v, const Base_surface& surface) {
    const auto known = corners_.find(v);
    if (known != corners_.end()) return known->second.branches.empty() ? nullptr : &known->second;
    Blend_corner& corner = corners_[v];
    const Blend_mesh& mesh = *body_.mesh;
    const auto& node = nodes_.at(v);
    const Job& first = jobs_[node.front().first];
    for (const auto& [i, end] : node)
      if (!jobs_[i].report.diagnosis.ok() || jobs_[i].curve.convex != first.curve.convex ||
          jobs_[i].report.radius != first.report.radius)
        return nullptr;
    const auto into = [&](std::pair<std::size_t, int> branch) {
      const Job& job = jobs_[branch.first];
      return branch.second == 1 ? job.halfedges.back() : mesh.opposite(job.halfedges.front());
    };
    std::vector<std::vector<Halfedge>> sectors;
    std::vector<std::pair<std::size_t, int>> order;
    Halfedge h = into(node.front());
    do {
      const auto branch = std::find_if(node.begin(), node.end(), [&](const auto& b) { return into(b) == h; });
      if (branch == node.end()) return nullptr;  // an edge that stays sharp
      order.push_back(*branch);
      sectors.emplace_back();
      do {
        h = mesh.prev(mesh.opposite(h));
        sectors.back().push_back(h);
      } while (surface.crossable(h));
    } while (h != into(node.front()));
    const double radius = first.report.radius;
    auto ball = find_corner_ball(surface, sectors, first.curve.convex ? -radius : radius);
    if (!ball) return nullptr;
    corner = {v, std::move(order), std::move(sectors), std::move(*ball), {}};
    return &corner;
  }

  /// The refusal of a blend that is folded: by what joins a mended spine, or by rough surfaces.
  static Diagnosis folded(const Job& job, const Vec& at) {
    return refusal(job.report.loops > 0 ? Status::radius_exceeds_curvature : Status::no_rolling_ball, at);
  }

  Diagnosis lay_rims(Job& job, std::size_t index, const std::array<const Base_surface*, 2>& surfaces,
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

  /// What comes too far off the ball, or leaves the surfaces at an angle, is no blend.
  Diagnosis judge(Job& job) {
    const Strip_quality quality = measure_rims(job.positions, {&job.rims[0], &job.rims[1]}, job.report.radius);
    job.report.radius_error = quality.radius_error;
    job.report.tangency_deg = quality.tangency_deg;
    if (quality.radius_error > worst_radius_error || quality.tangency_deg > worst_tangency ||
        quality.mean_tangency_deg > worst_mean_tangency)
      return refusal(Status::no_rolling_ball, quality.worst);
    if (const auto twist = job.surface->find_twist(worst_twist * pi / 180)) return folded(job, *twist);
    if (!job.profile.is_arc()) job.report.tangency_deg = measure_tangency(*job.surface);
    return {};
  }

  /// Gives a blend that did not fit another try on a smoother surface, or refuses it.
  Diagnosis escalate(std::size_t blame, const Diagnosis& diagnosis) {
    Job& job = jobs_[blame];
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
    if (mesh_is_to_blame || ++job.level == levels_of(job)) refuse(job);
    return first_refusal();
  }

  /// The first failure is the one to tell: later ones come of ever cruder views. Failing at a corner has its own name;
  /// creases that are short against the ball make none.
  void refuse(Job& job) {
    job.level = corner_level;
    job.report.diagnosis = *job.first_failure;
    const auto at = job.first_failure->point;
    if (status_is_of_mapping(job.first_failure->status)) return;
    if (const auto corner = find_corner(job, at ? to_vec(*at) : job.curve.points.front()))
      job.report.diagnosis = refusal(Status::corner, *corner);
  }

  /// Fills in the largest radius that works for curves where a smaller ball may do: tried on each alone, to the end.
  /// Ends early if the caller cancels.
  void find_largest_radii(Fillet_outcome& outcome) {
    for (Job& job : jobs_) {
      if (job.profile.is_sharp() || !may_fit_smaller(job.report.diagnosis.status)) continue;
      const bool is_the_refusal = !outcome.diagnosis.ok() && outcome.diagnosis.point == job.report.diagnosis.point &&
                                  outcome.diagnosis.status == job.report.diagnosis.status;
      double works = 0, fails = job.report.radius;
      for (const double share : radius_shares) {
        if (is_cancelled()) return;
        const double radius = share * job.report.radius;
        if (fits(job, radius)) {
          works = radius;
          break;
        }
        fails = radius;
      }
      if (works == 0) continue;
      for (int i = 0; i < radius_bisections && !is_cancelled(); ++i) {
        const double middle = (works + fails) / 2;
        (fits(job, middle) ? works : fails) = middle;
      }
      job.report.diagnosis.max_radius = works;
      if (is_the_refusal) outcome.diagnosis.max_radius = works;
    }
  }

  [[nodiscard]] bool fits(const Job& job, double radius) const {
    Edge_blend blend{{}, radius, job.profile};
    for (const Halfedge h : job.halfedges) blend.edges.push_back(body_.mesh->edge(h));
    Fillet_options alone = options_;
    alone.keep_going = false;
    alone.progress = nullptr;
    Blend_mesh ignored;
    return Engine(body_, alone, false).run({blend}, ignored).ok();
  }

  /// `ok` as long as something can be written: all blends, or some of them if that is wanted.
  Diagnosis first_refusal() const {
    const Job* refused = nullptr;
    bool some = false;
    for (const Job& job : jobs_) {
      if (job.report.diagnosis.ok())
        some = true;
      else if (!refused)
        refused = &job;
    }
    if (!refused || (options_.keep_going && some)) return {};
    return refused->report.diagnosis;
  }

  // Assembly: cut, sew, put in order, check.

  Assembly assemble() {
    Assembly result;
    Stopwatch watch;
    Blend_mesh work = *body_.mesh;
    aside_.copy += watch.milliseconds();
    std::unordered_set<Edge> curves;
    std::vector<Rim> rims, cuts;
    std::set<std::pair<Vertex, Vertex>> filled;
    std::map<std::size_t, std::array<End_assembly, 2>> ends;
    add_corner_vertices(work);
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      Job& job = jobs_[i];
      if (!job.rolled) continue;
      result.blame = i;
      for (const Halfedge h : job.halfedges) curves.insert(work.edge(h));
      for (const int side : {0, 1}) {
        Rim rim = job.rims[side];
        if (job.open) share_corner_vertices(*job.open, side, rim);
        result.diagnosis = add_rim_vertices(work, body_.cells, rim);
        if (!result.diagnosis.ok()) return result;
        rims.push_back(std::move(rim));
      }
      if (!job.open) continue;
      const std::array<const Rim*, 2> own{&rims[rims.size() - 2], &rims[rims.size() - 1]};
      for (const int end : {0, 1}) {
        End_assembly& parts = ends[i][end];
        result.diagnosis = assemble_end(work, body_.cells, *job.open, end, job.curve.convex, own,
                                        open_snap(job.report.radius), parts);
        if (!result.diagnosis.ok()) return result;
        cuts.insert(cuts.end(), parts.cuts.begin(), parts.cuts.end());
        filled.insert(parts.filled.begin(), parts.filled.end());
      }
    }
    std::vector<Rim> all = rims;
    all.insert(all.end(), cuts.begin(), cuts.end());
    Trimming trimming = trim(work, body_.cells, all, curves, filled);
    if (!trimming.diagnosis.ok()) {
      result.diagnosis = trimming.diagnosis;
      result.blame = nearest_job(to_vec(*trimming.diagnosis.point));
      return result;
    }
    if (options_.mode == Blend_mode::map)
      map(work, trimming, result);
    else
      stitch(work, rims, ends, trimming, result);
    return result;
  }

  /// Where blends meet in a corner their rims meet, in the contacts of the ball at rest there.
  void add_corner_vertices(Blend_mesh& work) {
    for (auto& [v, corner] : corners_) {
      corner.contact.assign(corner.branches.size(), Blend_mesh::null_vertex());
      for (std::size_t k = 0; k < corner.branches.size(); ++k) {
        const auto [i, end] = corner.branches[k];
        if (!jobs_[i].rolled) continue;
        const Open_branch& branch = *jobs_[i].open;
        const Station& s = branch.strip_ends[end].rim[1 - branch.ends[end].left()];
        corner.contact[k] =
            s.kind == Station::Kind::vertex ? body_.cells.vertex(0, s.vertex) : work.add_vertex(to_point(s.point));
      }
    }
  }

  void share_corner_vertices(const Open_branch& branch, int side, Rim& rim) const {
    rim.vertices.assign(rim.path.stations.size(), Blend_mesh::null_vertex());
    for (const int end : {0, 1}) {
      const Blend_corner* corner = branch.corner[end];
      if (!corner) continue;
      const std::size_t k = place_in_corner(*corner, branch.ends[end]), n = corner->branches.size();
      const Vertex v = corner->contact[side == branch.ends[end].left() ? (k + n - 1) % n : k];
      (end == 0 ? rim.vertices.front() : rim.vertices.back()) = v;
    }
  }

  [[nodiscard]] std::size_t place_in_corner(const Blend_corner& corner, const Branch_end& end) const {
    std::size_t k = 0;
    const auto into = [&](std::pair<std::size_t, int> b) {
      const Job& job = jobs_[b.first];
      return b.second == 1 ? job.halfedges.back() : body_.mesh->opposite(job.halfedges.front());
    };
    while (into(corner.branches[k]) != end.into) ++k;
    return k;
  }

  void stitch(Blend_mesh& work, const std::vector<Rim>& rims,
              const std::map<std::size_t, std::array<End_assembly, 2>>& ends, Trimming& trimming, Assembly& result) {
    std::vector<Triangle> triangles = std::move(trimming.remnants);
    for (std::size_t k = 0; k < rims.size(); k += 2) {
      const Job& job = jobs_[rims[k].blend];
      std::array<const Strip_border*, 2> borders{};
      if (job.open)
        for (const int end : {0, 1}) borders[end] = &ends.at(rims[k].blend)[end].border;
      const std::vector<double> rows = job.open ? job.open->rows : job.surface->rows(options_.chord_tolerance);
      const Strip strip = tessellate_strip(work, *job.surface, {&rims[k], &rims[k + 1]}, rows, borders);
      if (const auto fold = find_fold(work, strip, worst_fold)) {
        result.diagnosis = folded(job, *fold);
        result.blame = rims[k].blend;
        return;
      }
      triangles.insert(triangles.end(), strip.triangles.begin(), strip.triangles.end());
    }
    for (const auto& [i, both] : ends)
      for (const End_assembly& end : both) {
        if (end.fill.empty()) continue;
        const auto fill = fill_loop(work, end.fill_normal, end.fill);
        if (!fill) {
          result.diagnosis = refusal(Status::blends_overlap, to_vec(work.point(end.fill.front())));
          result.blame = i;
          return;
        }
        triangles.insert(triangles.end(), fill->begin(), fill->end());
      }
    if (!fill_corners(work, ends, triangles, result)) return;
    const Replacement replacement = replace_faces(work, trimming.removed, triangles);
    if (replacement.conflict) {
      const Vec at = to_vec(work.point(*replacement.conflict));
      result.diagnosis = refusal(Status::blends_overlap, at);
      result.blame = nearest_job(at);
      return;
    }
    finish(work, {trimming.remnant_cells, {}}, result);
    if (!result.diagnosis.ok()) return;
    // New faces come last, in the order in which they were added.
    const std::size_t first = result.mesh.number_of_faces() - replacement.faces.size();
    for (std::size_t k = trimming.remnant_cells.size(); k < replacement.faces.size(); ++k)
      result.outcome.blend_faces.push_back(Face(static_cast<std::uint32_t>(first + k)));
  }

  /// The part of the ball at rest that is left between the strips.
  bool fill_corners(Blend_mesh& work, const std::map<std::size_t, std::array<End_assembly, 2>>& ends,
                    std::vector<Triangle>& triangles, Assembly& result) {
    for (const auto& [v, corner] : corners_) {
      std::vector<Vertex> loop;
      for (const auto& [i, end] : corner.branches) {
        if (!jobs_[i].rolled) break;
        std::vector<Vertex> arc = ends.at(i)[end].border.hit;
        if (jobs_[i].open->ends[end].left() == 1) std::reverse(arc.begin(), arc.end());
        loop.insert(loop.end(), arc.begin(), arc.end() - 1);
      }
      if (loop.empty()) continue;
      const std::size_t i = corner.branches.front().first;
      const double facet = sampling(options_.chord_tolerance).finest * jobs_[i].report.radius;
      const std::vector<Triangle> patch = tessellate_corner(work, corner.ball.center, loop, facet);
      if (patch.empty()) {
        result.diagnosis = refusal(Status::corner, to_vec(body_.mesh->point(v)));
        result.blame = i;
        return false;
      }
      triangles.insert(triangles.end(), patch.begin(), patch.end());
    }
    return true;
  }

  /// Moves the vertices that stitching would remove onto the blends.
  void map(const Blend_mesh& work, const Trimming& trimming, Assembly& result) {
    std::unordered_set<Vertex> between = vertices_between(work, trimming);
    Stopwatch watch;
    Sharp_mesh sharp(body_);
    aside_.copy += watch.milliseconds();
    Blend_mesh& target = sharp.mesh;
    std::map<Vertex, Vec> moves;
    std::unordered_set<Vertex> inner;
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      Job& job = jobs_[i];
      if (!job.rolled) continue;
      const std::vector<Vertex> curve = sharp.curve(*body_.mesh, job.halfedges);
      between.insert(curve.begin(), curve.end());
      const Region_mapping region = map_region(target, curve, between, *job.surface, job.positions, job.attempt);
      job.report.coarseness = region.coarseness / job.report.radius;
      result.diagnosis = region.diagnosis;
      result.blame = i;
      if (!result.diagnosis.ok()) return;
      for (const auto& [v, to] : region.interior) {
        if (!inner.insert(v).second) {
          result.diagnosis = refusal(Status::blends_overlap, to_vec(target.point(v)));
          return;
        }
        moves[v] = to;
      }
      for (const auto& [v, to] : region.border)
        if (!inner.count(v)) moves.emplace(v, to);
    }
    std::vector<Vertex> moved;
    for (const auto& [v, to] : moves) {
      target.point(v) = to_point(to);
      moved.push_back(v);
    }
    finish(target, {{}, moved}, result);
    if (result.diagnosis.ok()) result.outcome.blend_faces = result.outcome.changed_faces;
  }

  /// Vertices of the body that no face that stays, and no remnant of one, has as a corner.
  [[nodiscard]] std::unordered_set<Vertex> vertices_between(const Blend_mesh& work, const Trimming& trimming) const {
    const std::unordered_set<Face> removed(trimming.removed.begin(), trimming.removed.end());
    std::unordered_set<Vertex> kept, between;
    for (const Triangle& t : trimming.remnants) kept.insert(t.begin(), t.end());
    for (const Face f : trimming.removed)
      for (const Vertex v : work.vertices_around_face(work.halfedge(f))) {
        if (kept.count(v) || between.count(v)) continue;
        bool goes = true;
        for (const Face g : work.faces_around_target(work.halfedge(v))) goes = goes && removed.count(g) != 0;
        (goes ? between : kept).insert(v);
      }
    return between;
  }

  void finish(const Blend_mesh& work, const Body_changes& changes, Assembly& result) {
    result.outcome = finish_body(body_, work, changes, result.mesh);
    aside_.validate += result.outcome.times.validate;
    aside_.copy += result.outcome.times.copy;
    result.diagnosis = result.outcome.diagnosis;
    if (!result.diagnosis.ok()) {
      const Vec at = result.diagnosis.point ? to_vec(*result.diagnosis.point) : jobs_.front().curve.points.front();
      result.blame = nearest_job(at);
      if (options_.mode == Blend_mode::map)
        result.diagnosis = refusal(Status::region_too_coarse, at);
      else if (result.diagnosis.status == Status::input_self_intersecting)
        result.diagnosis = refusal(Status::blend_collides, at);
      else
        result.diagnosis.status = Status::result_invalid;
    }
  }

  [[nodiscard]] std::size_t nearest_job(const Vec& at) const {
    std::size_t nearest = 0;
    double best = -1;
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      if (!jobs_[i].rolled) continue;
      for (const Ball_position& p : jobs_[i].positions) {
        const double distance = (p.center - at).squaredNorm() / (jobs_[i].report.radius * jobs_[i].report.radius);
        if (best >= 0 && distance >= best) continue;
        best = distance;
        nearest = i;
      }
    }
    return nearest;
  }

  const Fillet_body& body_;
  const Fillet_options& options_;
  bool thorough_;
  std::size_t levels_;
  double progress_ = 0;
  std::unordered_set<Edge> creases_;
  std::map<std::tuple<std::size_t, int, double, bool>, std::unique_ptr<Base_surface>> surfaces_;
  std::vector<Job> jobs_;
  std::map<Vertex, std::vector<std::pair<std::size_t, int>>> nodes_;  // branches and their ends, by vertex
  std::map<Vertex, Blend_corner> corners_;                           // without branches: no ball is at rest there
  Stage_times aside_;  // what is no part of blending, over all tries
};

}  // namespace

Fillet_outcome fillet_body(const Fillet_body& body, const std::vector<Edge_blend>& blends, Blend_mesh& out,
                           const Fillet_options& options) {
  return Engine(body, options).run(blends, out);
}

}  // namespace cgal_blend
