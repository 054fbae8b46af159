// SPDX-License-Identifier: GPL-3.0-or-later
#include "fillet_engine.h"

#include "ancestry.h"
#include "blend_corners.h"
#include "blend_curve.h"
#include "blend_strip.h"
#include "corner_patch.h"
#include "fill_loop.h"
#include "fillet_radius.h"
#include "map_region.h"
#include "open_branch.h"
#include "refusal.h"
#include "resting_balls.h"
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
#include <functional>
#include <map>
#include <memory>
#include <numeric>
#include <tuple>
#include <unordered_map>
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

// Views that are tried in the search for the largest radius.
constexpr std::size_t quick_levels = 4;

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
constexpr double sliver_of_facet = 0.15;  // height of triangles that do not count

// Positions that the rims cannot be led through may be left out, up to this share.
constexpr double spare_positions = 0.2;

// Radii of branches in a corner that are as near as this are the same.
constexpr double same_radius = 1e-9;

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

/// Balls of a corner, by their index there, that a branch without edges runs between.
struct Between_balls {
  Vertex corner;
  std::array<std::size_t, 2> ball;
};

/// One branch on its way to becoming a blend.
struct Job {
  std::vector<Halfedge> halfedges;
  Blend_report report;
  Blend_curve curve;
  std::array<int, 2> operand{};
  std::size_t level = 0;    // of smoothing
  std::size_t attempt = 0;  // at mapping
  bool rolled = false;
  bool over_edges = false;  // the ball rolls on over sharp edges that bend towards it
  std::optional<Diagnosis> first_failure;
  std::optional<Radius_law> law;  // along the branch
  Profile profile;
  std::optional<Profile> own_profile;  // if it is not that of the options
  std::vector<Ball_position> positions;
  std::array<Rim, 2> rims;
  std::optional<Virtual_surface> surface;
  std::optional<Open_branch> open;
  std::array<Vertex, 2> ends;  // of an open branch
  bool waits = false;          // for a later pass
  std::optional<Between_balls> between;  // a spine across a corner
  bool swallowed = false;                // by the balls at its ends, which leave nothing of it
};

struct Assembly {
  Diagnosis diagnosis;
  std::size_t blame = 0;  ///< job that the diagnosis is about
  Fillet_outcome outcome;
  Blend_mesh mesh;
  std::vector<Later_blend> later;
  std::vector<Later_blend::Step> creases;
  std::vector<Unfinished_corner> corners;
};

class Engine {
 public:
  /// \param thorough try every view of the surfaces
  Engine(const Fillet_body& body, const Fillet_options& options, bool thorough = true,
         const Earlier_blends& earlier = {})
      : earlier_(earlier), creases_(earlier.creases.begin(), earlier.creases.end()),
        blend_faces_(earlier.faces.begin(), earlier.faces.end()), body_(body), options_(options),
        levels_(thorough ? smoothings.size() : quick_levels) {
    creases_.insert(body.creases.begin(), body.creases.end());
  }

  Fillet_pass run(const std::vector<Edge_blend>& blends, Blend_mesh& out) {
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
      Assembly assembly = assemble();
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
    for (const Job& job : jobs_) {
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
      for (std::size_t k = 0; k < network.branches.size(); ++k) {
        const Branch<Blend_mesh>& branch = network.branches[k];
        Job job;
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
    for (Job& job : jobs_)
      if (!job.report.closed && job.report.diagnosis.ok()) job.report.diagnosis = refuse_open(job);
    if (body_.own_surface) {
      resume_corners();
      set_order();
    }
    return first_refusal();
  }

  /// Decides which branches have to wait. Where one goes first, the others roll over its end.
  void set_order() {
    const Base_surface surface(*body_.mesh, open_surface_options(0), &creases_, &blend_faces_);
    rest_balls(surface);
    std::map<Vertex, std::size_t> first;  // corners without a ball at rest: the branch that goes first
    for (const auto& [v, node] : nodes_) {
      if (node.size() == 1 || rest_.at(v)) continue;
      if (const auto refused = no_order(v, surface)) {
        for (const auto& [i, end] : node) jobs_[i].report.diagnosis = *refused;
        continue;
      }
      std::size_t convex = 0;
      for (const auto& [i, end] : node) convex += jobs_[i].curve.convex ? 1 : 0;
      const bool odd = 2 * convex < node.size();  // the convexity that is rarer there; concave if neither is
      const auto rank = [&](const std::pair<std::size_t, int>& branch) {
        const Job& job = jobs_[branch.first];
        const bool is_odd = job.curve.convex == odd;
        return std::tuple(!job.report.diagnosis.ok(), convex == 0 || convex == node.size() || is_odd ? 0 : 1,
                          -(*job.law)(branch.second), branch.first);
      };
      first[v] = std::min_element(node.begin(), node.end(), [&](const auto& a, const auto& b) {
                   return rank(a) < rank(b);
                 })->first;
    }
    for (bool changed = true; changed;) {
      changed = false;
      for (const auto& [v, node] : nodes_) {
        const auto winner = first.find(v);
        const bool all_wait = winner == first.end() && std::any_of(node.begin(), node.end(), [&](const auto& branch) {
                                return jobs_[branch.first].waits;
                              });
        for (const auto& [i, end] : node) {
          const bool waits = all_wait || (winner != first.end() && winner->second != i);
          changed = changed || (waits && !jobs_[i].waits);
          jobs_[i].waits = jobs_[i].waits || waits;
        }
      }
    }
    for (Job& job : jobs_)
      if (job.between)
        for (const auto& [i, end] : rest_.corners.at(job.between->corner).branches)
          job.waits = job.waits || jobs_[i].waits;
    const auto runs = [](const Job& job) { return !job.waits && job.report.diagnosis.ok(); };
    if (std::any_of(jobs_.begin(), jobs_.end(), runs)) return;
    // All wait for each other: one goes first, and the corners with a ball on its way are finished later.
    const auto may_start = [&](std::size_t i) {
      return std::all_of(jobs_[i].ends.begin(), jobs_[i].ends.end(), [&](Vertex v) {
        const auto winner = first.find(v);
        return winner != first.end() ? winner->second == i : nodes_.at(v).size() == 1 || nodes_.at(v).size() == 3;
      });
    };
    for (std::size_t i = 0; i < jobs_.size(); ++i)
      if (jobs_[i].waits && !jobs_[i].between && jobs_[i].report.diagnosis.ok() && may_start(i)) {
        jobs_[i].waits = false;
        return;
      }
    if (options_.keep_going) give_up_waiting_corners();
    if (!given_up_.empty()) return;
    for (Job& job : jobs_)
      if (job.waits && !job.between && job.report.diagnosis.ok())
        job.report.diagnosis = refusal(Status::corner, to_vec(body_.mesh->point(job.ends[0])));
  }

  /// Blends that would wait for each other for ever end flat at corners of four and more instead.
  void give_up_waiting_corners() {
    for (const auto& [v, corner] : rest_.corners) {
      const bool waits = std::any_of(corner.branches.begin(), corner.branches.end(),
                                     [&](const auto& branch) { return jobs_[branch.first].waits; });
      if (waits && corner.branches.size() > 3) given_up_.push_back(v);
    }
  }

  /// Why the blends at a corner without balls at rest cannot be made one after the other; nothing if they can.
  [[nodiscard]] std::optional<Diagnosis> no_order(Vertex v, const Base_surface& surface) const {
    const auto& node = nodes_.at(v);
    Diagnosis diagnosis = refusal(Status::corner, to_vec(body_.mesh->point(v)));
    if (node.size() == 2 && is_one_curve(surface, into(node[0]), body_.mesh->opposite(into(node[1])))) {
      diagnosis.detail = "the blends differ along one smooth curve; give it one radius that varies";
      return diagnosis;
    }
    // Blends that are to go on regardless end flat there.
    if (node.size() <= 3 || options_.keep_going) return std::nullopt;
    const auto blocked = rest_.blocked.find(v);
    if (blocked != rest_.blocked.end()) return refusal(Status::radius_exceeds_face, blocked->second);
    diagnosis.detail = "no balls at rest there touch all of the faces";
    return diagnosis;
  }

  /// True if the faces left of two consecutive edges are one smooth surface there, and so are those right of them.
  static bool is_one_curve(const Base_surface& surface, Halfedge in, Halfedge out) {
    const Blend_mesh& mesh = surface.mesh();
    return surface.fan(in) == surface.fan(mesh.prev(out)) &&
           surface.fan(mesh.prev(mesh.opposite(in))) == surface.fan(mesh.opposite(out));
  }

  [[nodiscard]] Halfedge into(const std::pair<std::size_t, int>& branch) const {
    const Job& job = jobs_[branch.first];
    return branch.second == 1 ? job.halfedges.back() : body_.mesh->opposite(job.halfedges.front());
  }

  /// Takes up the corners that an earlier pass has left: two branches and a blend that is there already.
  void resume_corners() {
    if (earlier_.corners.empty()) return;
    const Edge_finder find(*body_.mesh);
    const Base_surface surface(*body_.mesh, open_surface_options(0), &creases_, &blend_faces_);
    for (const Unfinished_corner& unfinished : earlier_.corners) {
      Blend_corner corner;
      std::array<std::vector<std::pair<std::size_t, int>>, 2> node;
      for (const int side : {0, 1}) {
        const auto end = nodes_.find(find.vertex(unfinished.ends[side]));
        if (end != nodes_.end()) node[side] = end->second;
      }
      for (const Point_3& p : unfinished.chain)
        if (const Vertex v = find.vertex(p); v != Blend_mesh::null_vertex()) corner.chain.push_back(v);
      if (node[0].size() != 1 || node[1].size() != 1 || corner.chain.size() != unfinished.chain.size()) continue;
      corner.branches = {{Blend_corner::no_branch, 0}, node[1].front(), node[0].front()};
      corner.ball.center = to_vec(unfinished.center);
      const double radius = (to_vec(body_.mesh->point(corner.chain.front())) - corner.ball.center).norm();
      const auto wants = [&](const std::pair<std::size_t, int>& b) {
        return std::abs((*jobs_[b.first].law)(b.second) - radius) <= same_radius * radius;
      };
      if (!wants(node[0].front()) || !wants(node[1].front())) continue;
      const auto third = third_foot(surface, corner, radius);
      if (!third) continue;
      corner.ball.foot = {point_at(surface, corner.chain.back()), *third, point_at(surface, corner.chain.front())};
      const Vertex key = body_.mesh->target(into(node[0].front()));
      corners_[key] = {std::move(corner)};
      for (const int side : {0, 1}) resumed_[body_.mesh->target(into(node[side].front()))] = key;
    }
  }

  /// A vertex as a point of a face that is of no blend.
  [[nodiscard]] Surface_point point_at(const Base_surface& surface, Vertex v) const {
    const Blend_mesh& mesh = *body_.mesh;
    Surface_point at;
    for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v))) {
      if (blend_faces_.count(mesh.face(h))) continue;
      const Base_surface::Frame& frame = surface.frame(mesh.face(h));
      at.face = mesh.face(h);
      for (int i = 0; i < 3; ++i) at.bary[i] = frame.halfedge[i] == h ? 1 : 0;
    }
    return at;
  }

  /// Where the ball at rest touches the faces between the two branches that are to come.
  [[nodiscard]] std::optional<Surface_point> third_foot(const Base_surface& surface, const Blend_corner& corner,
                                                        double radius) const {
    const Blend_mesh& mesh = *body_.mesh;
    const Face start = mesh.face(mesh.opposite(into(corner.branches[1])));
    Surface_point at{start, Vec::Constant(1.0 / 3)};
    for (int step = 0; step < 50; ++step) {  // towards the place below the centre
      const Vec normal = surface.normal(at);
      const Vec arm = corner.ball.center - surface.position(at);
      const Vec along = arm - arm.dot(normal) * normal;
      if (along.norm() < same_radius * radius) {
        if (std::abs(arm.norm() - radius) > 1e-6 * radius) break;
        return at;
      }
      at = surface.walk(at, along).end;
    }
    return std::nullopt;
  }

  [[nodiscard]] Base_surface::Options open_surface_options(std::size_t level) const {
    Base_surface::Options options;
    options.smooth_angle = std::min(options_.smooth_angle, open_angles[level]);
    options.edge_points = &body_.edge_points;
    return options;
  }

  static bool wants_the_same(const Edge_blend& a, const Edge_blend& b) {
    const auto is_plain = [](const Edge_blend& blend) { return !blend.profile && !blend.law && !blend.start; };
    return is_plain(a) && is_plain(b) && a.radius == b.radius;
  }

  /// Blends that meet and want the same are one, so that their curves run on into each other.
  [[nodiscard]] std::vector<Edge_blend> joined(const std::vector<Edge_blend>& blends) const {
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

  /// Branches between corners: where the faces on one side meet in a sharp edge, two edges are no one curve.
  [[nodiscard]] Curve_network<Blend_mesh> chain(const std::vector<Edge>& edges, double radius) const {
    if (!body_.own_surface) return make_curve_network(*body_.mesh, edges);
    const Base_surface surface(*body_.mesh, surface_options(smoothings[0], radius), &creases_, &blend_faces_);
    return make_curve_network(*body_.mesh, edges,
                              [&](Halfedge in, Halfedge out) { return is_one_curve(surface, in, out); });
  }

  [[nodiscard]] Base_surface::Options surface_options(const Smoothing& how, double radius) const {
    Base_surface::Options options;
    options.smooth_angle = std::max(options_.smooth_angle, how.smooth_angle);
    options.shortest_crease = how.shortest_crease * radius;
    options.smoothing_passes = how.passes;
    options.edge_points = &body_.edge_points;
    return options;
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
    std::unique_ptr<Base_surface>& surface = surfaces_[{job.level, operand, job.report.radius, round, kind_of_rolling(job)}];
    if (!surface) {
      Base_surface::Options options = surface_options(smoothings[job.level], job.report.radius);
      options.reversed = body_.reversed[operand];
      options.area_weights = round;
      set_rolling(job, options);
      surface = std::make_unique<Base_surface>(
          *body_.base[operand], options, body_.own_surface ? &creases_ : nullptr, body_.own_surface ? &blend_faces_ : nullptr);
    }
    return *surface;
  }

  static void set_rolling(const Job& job, Base_surface::Options& options) {
    options.rolling_radius = job.over_edges ? job.report.radius : 0;
    options.ball_inside = job.curve.convex;
  }

  /// How surfaces of jobs differ by `set_rolling`.
  static int kind_of_rolling(const Job& job) { return !job.over_edges ? 0 : job.curve.convex ? 1 : 2; }

  // Rolling, and what to do about failures.

  /// A smoother view would blur the round that is to be sharpened into the surfaces beyond it.
  [[nodiscard]] std::size_t levels_of(const Job& job) const {
    return job.profile.is_sharp() ? 1 : job.curve.closed ? levels_ : open_angles.size();
  }

  [[nodiscard]] bool is_cancelled() const { return options_.progress && !options_.progress(progress_); }

  Diagnosis roll_all() {
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      Job& job = jobs_[i];
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

  /// Where a face ends the ball may go on over its edge: along the edge, or to the face beyond.
  void roll_over_edges(Job& job, std::size_t index) {
    if (options_.mode == Blend_mode::map || job.profile.is_sharp() || job.over_edges || job.between) return;
    job.over_edges = true;
    job.level = 0;  // smoother views would round the edges off
    job.report.over_edges = job.rolled = roll(job, index).ok();
    if (job.rolled) job.report.diagnosis = {};
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
    Ball_path path = roll_ball(surfaces, job.curve, kind, *job.law, steps);
    if (!path.diagnosis.ok()) return path.diagnosis;
    job.positions = std::move(path.positions);
    job.report.loops = path.loops;
    const Diagnosis laid = lay_rims(job, index, surfaces, snap);
    if (!laid.ok()) return laid;
    job.surface.emplace(job.positions, surfaces, job.profile);
    return judge(job);
  }

  Diagnosis roll_to_ends(Job& job, std::size_t index) {
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

  /// Finds out what an open branch runs into.
  void view_end_of(Job& job, std::size_t index, int end) {
    Open_branch& branch = *job.open;
    Branch_end& e = branch.ends[end];
    const Blend_corner* corner = ball_at(job, index, end);
    if (corner) branch.place[end] = place_in_corner(*corner, {index, end});
    const bool is_complete =
        corner && std::none_of(corner->branches.begin(), corner->branches.end(), [&](const auto& b) {
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

  /// The ball at rest that a branch ends at, or null.
  [[nodiscard]] const Blend_corner* ball_at(const Job& job, std::size_t index, int end) const {
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

  [[nodiscard]] double open_snap(double radius) const {
    return radius * std::min(snap_of_radius, snap_of_facet * sampling(options_.chord_tolerance).finest);
  }

  /// Finds the balls at rest in all corners, and adds the branches between those of one corner.
  void rest_balls(const Base_surface& surface) {
    std::vector<Corner_branch> branches(jobs_.size());
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      const Job& job = jobs_[i];
      if (job.curve.closed) continue;
      for (const int end : {0, 1}) {
        branches[i].into[end] = into({i, end});
        branches[i].radius[end] = (*job.law)(end);
      }
      for (const Halfedge h : job.halfedges) branches[i].edges.push_back(body_.mesh->edge(h));
      branches[i].points = job.curve.points;
      branches[i].convex = job.curve.convex;
      branches[i].refused = !job.report.diagnosis.ok();
    }
    rest_ = find_resting_balls(surface, branches, earlier_.flat_corners);
    for (std::size_t i = 0; i < branches.size(); ++i) jobs_[i].swallowed = rest_.swallowed[i];
    for (const auto& [v, corner] : rest_.corners) {
      corners_[v] = blend_corners(corner.balls, corner.branches, jobs_.size());
      for (const Corner_balls::Spine& spine : corner.balls.spines)
        add_spine(v, corner.balls, spine, corner.branches.front());
    }
  }

  /// Adds the branch between two balls of a corner; `like` is one of those that meet there.
  void add_spine(Vertex v, const Corner_balls& balls, const Corner_balls::Spine& spine,
                 const std::pair<std::size_t, int>& like) {
    Job job;
    const Job& model = jobs_[like.first];
    job.between = {v, spine.ball};
    job.ends = {v, v};
    job.report.radius = (*model.law)(like.second);
    job.report.closed = job.curve.closed = false;
    job.report.convex = job.curve.convex = model.curve.convex;
    job.law = Radius_law(job.report.radius);
    job.profile = model.profile;
    for (const std::size_t ball : spine.ball) job.curve.points.push_back(balls.balls[ball].rest.center);
    jobs_.push_back(std::move(job));
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

  /// What fails between the balls of a corner fails for the branches that meet there.
  void blame_edges() {
    for (const Job& job : jobs_)
      if (job.between && !job.report.diagnosis.ok())
        for (const auto& [i, end] : rest_.corners.at(job.between->corner).branches)
          if (jobs_[i].report.diagnosis.ok()) jobs_[i].report.diagnosis = job.report.diagnosis;
  }

  /// True if a branch is refused on which others count in a corner: these are to be looked at anew without it.
  [[nodiscard]] bool refused_at_corner() const {
    if (std::any_of(jobs_.begin(), jobs_.end(),
                    [](const Job& job) { return job.between && !job.report.diagnosis.ok(); }))
      return true;
    for (const auto& [v, node] : nodes_) {
      const auto refused = std::count_if(node.begin(), node.end(), [&](const auto& branch) {
        return !jobs_[branch.first].report.diagnosis.ok();
      });
      if (refused > 0 && refused < static_cast<std::ptrdiff_t>(node.size())) return true;
    }
    return false;
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
    if (mesh_is_to_blame || job.over_edges || ++job.level == levels_of(job)) refuse(job);
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

  [[nodiscard]] Edge_blend blend_of(const Job& job) const {
    Edge_blend blend{{}, job.report.radius, job.own_profile};
    for (const Halfedge h : job.halfedges) blend.edges.push_back(body_.mesh->edge(h));
    if (job.law && !job.law->is_constant()) {
      blend.law = job.law;
      blend.start = body_.mesh->source(job.halfedges.front());
    }
    return blend;
  }

  // Assembly of what waits.

  /// Joins two branches over the end of a blend between them. Where their radii differ, the radius changes on the way.
  static void join_over(const Point_3& corner, const std::vector<Later_blend::Step>& over,
                        const std::array<std::reference_wrapper<Later_blend>, 2>& both) {
    Later_blend &a = both[0], &b = both[1];
    if (a.edges.empty() || b.edges.empty()) return;  // joined already, to each other or to others
    if (a.law || b.law || a.radius == b.radius) {
      a.edges.insert(a.edges.end(), over.begin(), over.end());
      return;
    }
    const auto touches = [&](const Later_blend::Step& s) { return s.first == corner || s.second == corner; };
    const auto turn = [](std::vector<Later_blend::Step>& steps) {
      std::reverse(steps.begin(), steps.end());
      for (Later_blend::Step& s : steps) std::swap(s.first, s.second);
    };
    if (touches(a.edges.front()) && !touches(a.edges.back())) turn(a.edges);
    if (touches(b.edges.back()) && !touches(b.edges.front())) turn(b.edges);
    const auto length = [&](const std::vector<Later_blend::Step>& steps) {
      double sum = 0;
      for (const Later_blend::Step& s : steps)
        if (!touches(s)) sum += std::sqrt(CGAL::squared_distance(s.first, s.second));
      return sum;
    };
    const double first = length(a.edges), middle = length(over), total = first + middle + length(b.edges);
    if (!(first > 0 && middle > 0 && total > first + middle)) return;
    a.law = Piecewise_radius(
        {{0, a.radius}, {first / total, a.radius}, {(first + middle) / total, b.radius}, {1, b.radius}});
    a.edges.insert(a.edges.end(), over.begin(), over.end());
    a.edges.insert(a.edges.end(), b.edges.begin(), b.edges.end());
    b.edges.clear();
  }

  /// The corner that a blend has passed, to be finished by the branches left and right of it.
  void add_unfinished(const Blend_mesh& work, std::size_t i, int end, const Strip_border& border,
                      const std::vector<Rim>& rims, Assembly& result) const {
    const Job& job = jobs_[i];
    const Open_branch& branch = *job.open;
    const std::size_t at = branch.passed[end];
    const auto rim = std::find_if(rims.begin(), rims.end(), [&](const Rim& r) { return r.blend == i; });
    Unfinished_corner corner;
    for (std::size_t k = 0; k < branch.rows.size(); ++k) {
      if (branch.strip_ends[0].last[k] > at || branch.strip_ends[1].last[k] < at) return;  // the end has swallowed it
      if (k == 0 || k + 1 == branch.rows.size()) {
        const Rim& side = *(rim + (k == 0 ? 0 : 1));
        corner.chain.push_back(work.point(side.vertices[side.path.station_of[at]]));
      } else {
        corner.chain.push_back(to_point(job.surface->on_profile(at, branch.rows[k])));
      }
    }
    corner.center = to_point(job.positions[at].center);
    corner.ends = {work.point(border.hit.front()), work.point(border.hit.back())};
    if (branch.ends[end].left() == 1) {
      std::reverse(corner.chain.begin(), corner.chain.end());
      std::swap(corner.ends[0], corner.ends[1]);
    }
    result.corners.push_back(std::move(corner));
  }

  /// The edges of a branch as they are by now, cut where rims cross them; those that are gone are left out later.
  void add_later(const Blend_mesh& work, const Trimming& trimming,
                 const std::map<std::size_t, std::array<End_assembly, 2>>& ends, const std::vector<Rim>& rims,
                 Assembly& result) const {
    std::set<std::pair<Vertex, Vertex>> filled;  // within faces that have grown
    for (const auto& [i, both] : ends)
      for (const End_assembly& end : both) filled.insert(end.filled.begin(), end.filled.end());
    std::map<std::size_t, std::size_t> place;  // of jobs in result.later
    const auto step = [&](Vertex a, Vertex b) { return Later_blend::Step(work.point(a), work.point(b)); };
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      const Job& job = jobs_[i];
      if (!job.waits || job.between || !job.report.diagnosis.ok()) continue;
      place[i] = result.later.size();
      Later_blend& later = result.later.emplace_back();
      if (job.law->is_constant())
        later.radius = job.report.radius;
      else
        later.law = job.law;
      later.profile = job.own_profile;
      for (const Halfedge h : job.halfedges) {
        const auto divided = trimming.divided.find(work.edge(h));
        const std::vector<Vertex> chain = divided != trimming.divided.end()
                                              ? divided->second
                                              : std::vector<Vertex>{work.source(h), work.target(h)};
        for (std::size_t k = 0; k + 1 < chain.size(); ++k)
          if (!filled.count({chain[k], chain[k + 1]}) && !filled.count({chain[k + 1], chain[k]}))
            later.edges.push_back(step(chain[k], chain[k + 1]));
      }
    }
    for (const auto& [i, both] : ends)
      for (const int end : {0, 1}) {
        const Branch_end& e = jobs_[i].open->ends[end];
        if (e.kind != Branch_end::Kind::faces) continue;
        // Which branches wait left and right of this one's end?
        std::array<std::optional<std::size_t>, 2> waiting;
        for (const auto& [k, other] : nodes_.at(jobs_[i].ends[end])) {
          if (!place.count(k)) continue;
          const Halfedge into =
              other == 1 ? jobs_[k].halfedges.back() : body_.mesh->opposite(jobs_[k].halfedges.front());
          for (const int side : {0, 1})
            if (body_.mesh->edge(e.border[side].front()) == body_.mesh->edge(into)) waiting[side] = k;
        }
        if (jobs_[i].open->through[end] && waiting[0] && waiting[1]) {
          add_unfinished(work, i, end, both[end].border, rims, result);
        } else if (waiting[0] && waiting[1]) {  // they go on into each other over the end of this one
          const Strip_border& border = both[end].border;
          std::vector<Vertex> chain{border.hit.front()};
          for (std::size_t k = 0; k + 1 < border.hit.size(); ++k) {
            chain.insert(chain.end(), border.between[k].begin(), border.between[k].end());
            chain.push_back(border.hit[k + 1]);
          }
          std::vector<Later_blend::Step> over;
          for (std::size_t k = 0; k + 1 < chain.size(); ++k)
            if (chain[k] != chain[k + 1]) over.push_back(step(chain[k], chain[k + 1]));
          join_over(work.point(jobs_[i].ends[end]), over, {result.later[place[*waiting[0]]], result.later[place[*waiting[1]]]});
        } else if (waiting[0] || waiting[1]) {  // a mitre: this one's surface cuts the other's
          const int side = waiting[0] ? 0 : 1;
          if (jobs_[*waiting[side]].curve.convex != jobs_[i].curve.convex) continue;
          const auto rim = std::find_if(rims.begin(), rims.end(), [&, i = i](const Rim& r) { return r.blend == i; }) + side;
          const Vec corner = to_vec(work.point(jobs_[i].ends[end]));
          for (std::size_t k = 0; k + 1 < rim->vertices.size(); ++k) {
            const Vec a = to_vec(work.point(rim->vertices[k])), b = to_vec(work.point(rim->vertices[k + 1]));
            if (off_segment(a, b, corner) < e.reach) result.creases.push_back(step(rim->vertices[k], rim->vertices[k + 1]));
          }
        }
      }
  }

  /// `ok` as long as something can be written: all blends, or some of them if that is wanted.
  Diagnosis first_refusal() const {
    const Job* refused = nullptr;
    bool some = false;
    for (const Job& job : jobs_) {
      if (job.report.diagnosis.ok())
        some = some || (!job.waits && !job.between);
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
      if (job.rolled || (job.swallowed && !job.waits))
        for (const Halfedge h : job.halfedges) curves.insert(work.edge(h));
      if (!job.rolled) continue;
      result.blame = i;
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
    for (const auto& [v, corners] : corners_)
      if (!corners.empty() && !corners.front().chain.empty()) add_chain(corners.front(), cuts);
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

  /// Cuts the blend of an earlier pass where its ball is at rest.
  void add_chain(const Blend_corner& corner, std::vector<Rim>& cuts) const {
    const std::size_t i = corner.branches.back().first;
    if (!jobs_[i].rolled || !jobs_[corner.branches[1].first].rolled) return;
    Rim cut;
    cut.surface = jobs_[i].open->surface.get();
    cut.path.closed = false;
    for (const Vertex w : corner.chain)
      cut.path.stations.push_back(station_at(*cut.surface, body_.mesh->face(body_.mesh->halfedge(w)), w));
    cut.keep_left = false;
    cut.blend = i;
    cut.vertices = corner.chain;
    cuts.push_back(std::move(cut));
  }

  /// Where blends meet in a corner their rims meet, in the contacts of the ball at rest there.
  void add_corner_vertices(Blend_mesh& work) {
    for (auto& [v, corners] : corners_)
      for (Blend_corner& corner : corners) add_contacts(work, corner);
  }

  void add_contacts(Blend_mesh& work, Blend_corner& corner) const {
    corner.contact.assign(corner.branches.size(), Blend_mesh::null_vertex());
    for (std::size_t k = 0; k < corner.branches.size(); ++k) {
      const auto [i, end] = corner.branches[k];
      if (i == Blend_corner::no_branch) {
        corner.contact[0] = corner.chain.back();
        continue;
      }
      if (!jobs_[i].rolled || !jobs_[i].open->corner[end]) continue;
      const Open_branch& branch = *jobs_[i].open;
      const Station& s = branch.strip_ends[end].rim[1 - branch.ends[end].left()];
      corner.contact[k] =
          s.kind == Station::Kind::vertex ? body_.cells.vertex(0, s.vertex) : work.add_vertex(to_point(s.point));
    }
  }

  void share_corner_vertices(const Open_branch& branch, int side, Rim& rim) const {
    rim.vertices.assign(rim.path.stations.size(), Blend_mesh::null_vertex());
    for (const int end : {0, 1}) {
      const Blend_corner* corner = branch.corner[end];
      if (!corner) continue;
      const std::size_t k = branch.place[end], n = corner->branches.size();
      const Vertex v = corner->contact[side == branch.ends[end].left() ? (k + n - 1) % n : k];
      (end == 0 ? rim.vertices.front() : rim.vertices.back()) = v;
    }
  }

  [[nodiscard]] static std::size_t place_in_corner(const Blend_corner& corner,
                                                   const std::pair<std::size_t, int>& branch) {
    return static_cast<std::size_t>(std::find(corner.branches.begin(), corner.branches.end(), branch) -
                                    corner.branches.begin());
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
      const double least = sliver_of_facet * sampling(options_.chord_tolerance).finest * job.report.radius;
      if (const auto fold = find_fold(work, strip, worst_fold, least)) {
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
    add_later(work, trimming, ends, rims, result);
    const Replacement replacement = replace_faces(work, trimming.removed, triangles);
    if (replacement.conflict) {
      const Vec at = to_vec(work.point(*replacement.conflict));
      result.diagnosis = refusal(Status::blends_overlap, at);
      result.blame = nearest_job(at);
      return;
    }
    finish(work, {trimming.remnant_cells, {}}, result);
    if (!result.diagnosis.ok()) return;
    const std::vector<std::uint32_t>& origins = result.outcome.origins;
    for (std::size_t f = 0; f < origins.size(); ++f)
      if (origins[f] == no_origin) result.outcome.blend_faces.push_back(Face(static_cast<std::uint32_t>(f)));
  }

  /// The parts of the balls at rest that are left between the strips.
  bool fill_corners(Blend_mesh& work, const std::map<std::size_t, std::array<End_assembly, 2>>& ends,
                    std::vector<Triangle>& triangles, Assembly& result) {
    for (const auto& [v, corners] : corners_)
      for (const Blend_corner& corner : corners) {
        const std::vector<Vertex> loop = loop_around(corner, ends);
        if (loop.empty()) continue;
        const std::size_t i = corner.branches.back().first;
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

  /// The arcs in which blends end at a ball at rest, one after the other; empty if not all are there.
  [[nodiscard]] std::vector<Vertex> loop_around(const Blend_corner& corner,
                                                const std::map<std::size_t, std::array<End_assembly, 2>>& ends) const {
    std::vector<Vertex> loop;
    for (const auto& [i, end] : corner.branches) {
      if (i == Blend_corner::no_branch) {
        loop.insert(loop.end(), corner.chain.begin(), corner.chain.end() - 1);
        continue;
      }
      if (!jobs_[i].rolled || !jobs_[i].open->corner[end]) return {};
      std::vector<Vertex> arc = ends.at(i)[end].border.hit;
      if (jobs_[i].open->ends[end].left() == 1) std::reverse(arc.begin(), arc.end());
      loop.insert(loop.end(), arc.begin(), arc.end() - 1);
    }
    return loop;
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

  Earlier_blends earlier_;
  std::unordered_set<Edge> creases_;  // those of earlier blends, and what is to be blended
  std::unordered_set<Face> blend_faces_;
  const Fillet_body& body_;
  const Fillet_options& options_;
  std::size_t levels_;
  double progress_ = 0;
  std::map<std::tuple<std::size_t, int, double, bool, int>, std::unique_ptr<Base_surface>> surfaces_;
  std::vector<Job> jobs_;
  std::map<Vertex, std::vector<std::pair<std::size_t, int>>> nodes_;  // branches and their ends, by vertex
  std::map<Vertex, Vertex> resumed_;  // ends of branches in corners of earlier passes: the key of these
  Resting_balls rest_;
  std::vector<Vertex> given_up_;                         // corners whose branches would wait for ever
  std::map<Vertex, std::vector<Blend_corner>> corners_;  // per corner a place for each of its balls
  Stage_times aside_;  // what is no part of blending, over all tries
};

}  // namespace

Fillet_pass fillet_pass(const Fillet_body& body, const std::vector<Edge_blend>& blends,
                        const Earlier_blends& earlier, Blend_mesh& out, const Fillet_options& options, bool thorough) {
  std::vector<Edge_blend> wanted = blends;
  Earlier_blends before = earlier;
  std::vector<std::pair<Blend_report, Edge_blend>> refused;
  Stage_times times;
  while (true) {
    Fillet_pass pass = Engine(body, options, thorough, before).run(wanted, out);
    add(times, pass.outcome.times);
    if (pass.again) {
      std::unordered_set<Edge> left_out;
      for (const auto& [place, blend] : pass.refused) {
        refused.emplace_back(pass.outcome.blends[place], blend);
        left_out.insert(blend.edges.begin(), blend.edges.end());
      }
      before.creases.insert(before.creases.end(), left_out.begin(), left_out.end());
      before.flat_corners.insert(pass.flat_corners.begin(), pass.flat_corners.end());
      for (Edge_blend& blend : wanted)
        blend.edges.erase(std::remove_if(blend.edges.begin(), blend.edges.end(),
                                         [&](Edge e) { return left_out.count(e) != 0; }),
                          blend.edges.end());
      wanted.erase(std::remove_if(wanted.begin(), wanted.end(),
                                  [](const Edge_blend& blend) { return blend.edges.empty(); }),
                   wanted.end());
      if (!wanted.empty()) continue;
      pass.outcome.blends.clear();
      pass.refused.clear();
      pass.outcome.diagnosis = refused.front().first.diagnosis;
    }
    for (const auto& [report, blend] : refused) {
      pass.refused.emplace_back(pass.outcome.blends.size(), blend);
      pass.outcome.blends.push_back(report);
    }
    pass.outcome.times = times;
    return pass;
  }
}

}  // namespace cgal_blend
