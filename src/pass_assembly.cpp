// SPDX-License-Identifier: GPL-3.0-or-later
#include "pass_engine.h"

#include "blend_strip.h"
#include "corner_patch.h"
#include "fill_loop.h"
#include "map_region.h"
#include "refusal.h"
#include "sharp_mesh.h"
#include "stitching.h"
#include "stopwatch.h"

#include <algorithm>

namespace cgal_blend {

namespace {

// Nor one whose strip is folded, with its rims: angle between neighbouring facets, degrees.
constexpr double worst_fold = 100;

constexpr double sliver_of_facet = 0.15;  // height of triangles that do not count

}  // namespace

Fillet_assembly Pass_engine::assemble() {
  Fillet_assembly result;
  Stopwatch watch;
  Blend_mesh work = *body_.mesh;
  aside_.copy += watch.milliseconds();
  std::unordered_set<Edge> curves;
  std::vector<Rim> rims, cuts;
  std::set<std::pair<Vertex, Vertex>> filled;
  std::map<std::size_t, std::array<End_assembly, 2>> ends;
  add_corner_vertices(work);
  for (std::size_t i = 0; i < jobs_.size(); ++i) {
    Fillet_job& job = jobs_[i];
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
      result.diagnosis =
          assemble_end(work, body_.cells, *job.open, end, job.curve.convex, own, open_snap(job.report.radius), parts);
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

void Pass_engine::add_chain(const Blend_corner& corner, std::vector<Rim>& cuts) const {
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

void Pass_engine::add_corner_vertices(Blend_mesh& work) {
  for (auto& [v, corners] : corners_)
    for (Blend_corner& corner : corners) add_contacts(work, corner);
}

void Pass_engine::add_contacts(Blend_mesh& work, Blend_corner& corner) const {
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

void Pass_engine::share_corner_vertices(const Open_branch& branch, int side, Rim& rim) const {
  rim.vertices.assign(rim.path.stations.size(), Blend_mesh::null_vertex());
  for (const int end : {0, 1}) {
    const Blend_corner* corner = branch.corner[end];
    if (!corner) continue;
    const std::size_t k = branch.place[end], n = corner->branches.size();
    const Vertex v = corner->contact[side == branch.ends[end].left() ? (k + n - 1) % n : k];
    (end == 0 ? rim.vertices.front() : rim.vertices.back()) = v;
  }
}

std::size_t Pass_engine::place_in_corner(const Blend_corner& corner, const std::pair<std::size_t, int>& branch) {
  return static_cast<std::size_t>(std::find(corner.branches.begin(), corner.branches.end(), branch) -
                                  corner.branches.begin());
}

void Pass_engine::stitch(Blend_mesh& work, const std::vector<Rim>& rims,
                         const std::map<std::size_t, std::array<End_assembly, 2>>& ends, Trimming& trimming,
                         Fillet_assembly& result) {
  std::vector<Triangle> triangles = std::move(trimming.remnants);
  for (std::size_t k = 0; k < rims.size(); k += 2) {
    const Fillet_job& job = jobs_[rims[k].blend];
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

bool Pass_engine::fill_corners(Blend_mesh& work, const std::map<std::size_t, std::array<End_assembly, 2>>& ends,
                               std::vector<Triangle>& triangles, Fillet_assembly& result) {
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

std::vector<Vertex> Pass_engine::loop_around(const Blend_corner& corner,
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

void Pass_engine::map(const Blend_mesh& work, const Trimming& trimming, Fillet_assembly& result) {
  std::unordered_set<Vertex> between = vertices_between(work, trimming);
  Stopwatch watch;
  Sharp_mesh sharp(body_);
  aside_.copy += watch.milliseconds();
  Blend_mesh& target = sharp.mesh;
  std::map<Vertex, Vec> moves;
  std::unordered_set<Vertex> inner;
  for (std::size_t i = 0; i < jobs_.size(); ++i) {
    Fillet_job& job = jobs_[i];
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

std::unordered_set<Vertex> Pass_engine::vertices_between(const Blend_mesh& work, const Trimming& trimming) const {
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

void Pass_engine::finish(const Blend_mesh& work, const Body_changes& changes, Fillet_assembly& result) {
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

std::size_t Pass_engine::nearest_job(const Vec& at) const {
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

}  // namespace cgal_blend
