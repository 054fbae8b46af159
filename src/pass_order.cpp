// SPDX-License-Identifier: GPL-3.0-or-later
#include "pass_engine.h"

#include "corner_ball.h"
#include "corner_balls.h"
#include "edge_finder.h"
#include "refusal.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace cgal_blend {

namespace {

// Radii of branches in a corner that are as near as this are the same.
constexpr double same_radius = 1e-9;

}  // namespace

void Pass_engine::set_order() {
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
      const Fillet_job& job = jobs_[branch.first];
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
  for (Fillet_job& job : jobs_)
    if (job.between)
      for (const auto& [i, end] : rest_.corners.at(job.between->corner).branches)
        job.waits = job.waits || jobs_[i].waits;
  const auto runs = [](const Fillet_job& job) { return !job.waits && job.report.diagnosis.ok(); };
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
  for (Fillet_job& job : jobs_)
    if (job.waits && !job.between && job.report.diagnosis.ok())
      job.report.diagnosis = refusal(Status::corner, to_vec(body_.mesh->point(job.ends[0])));
}

void Pass_engine::give_up_waiting_corners() {
  for (const auto& [v, corner] : rest_.corners) {
    const bool waits = std::any_of(corner.branches.begin(), corner.branches.end(),
                                   [&](const auto& branch) { return jobs_[branch.first].waits; });
    if (waits && corner.branches.size() > 3) given_up_.push_back(v);
  }
}

std::optional<Diagnosis> Pass_engine::no_order(Vertex v, const Base_surface& surface) const {
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

bool Pass_engine::is_one_curve(const Base_surface& surface, Halfedge in, Halfedge out) {
  const Blend_mesh& mesh = surface.mesh();
  return surface.fan(in) == surface.fan(mesh.prev(out)) &&
         surface.fan(mesh.prev(mesh.opposite(in))) == surface.fan(mesh.opposite(out));
}

Halfedge Pass_engine::into(const std::pair<std::size_t, int>& branch) const {
  const Fillet_job& job = jobs_[branch.first];
  return branch.second == 1 ? job.halfedges.back() : body_.mesh->opposite(job.halfedges.front());
}

void Pass_engine::resume_corners() {
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

Surface_point Pass_engine::point_at(const Base_surface& surface, Vertex v) const {
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

std::optional<Surface_point> Pass_engine::third_foot(const Base_surface& surface, const Blend_corner& corner,
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

void Pass_engine::rest_balls(const Base_surface& surface) {
  std::vector<Corner_branch> branches(jobs_.size());
  for (std::size_t i = 0; i < jobs_.size(); ++i) {
    const Fillet_job& job = jobs_[i];
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

void Pass_engine::add_spine(Vertex v, const Corner_balls& balls, const Corner_balls::Spine& spine,
                            const std::pair<std::size_t, int>& like) {
  Fillet_job job;
  const Fillet_job& model = jobs_[like.first];
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

}  // namespace cgal_blend
