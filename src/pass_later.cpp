// SPDX-License-Identifier: GPL-3.0-or-later
#include "pass_engine.h"

#include "blend_strip.h"
#include "edge_finder.h"
#include "refusal.h"

#include <algorithm>
#include <cmath>

namespace cgal_blend {

void Pass_engine::join_over(const Point_3& corner, const std::vector<Later_blend::Step>& over,
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
  a.law =
      Piecewise_radius({{0, a.radius}, {first / total, a.radius}, {(first + middle) / total, b.radius}, {1, b.radius}});
  a.edges.insert(a.edges.end(), over.begin(), over.end());
  a.edges.insert(a.edges.end(), b.edges.begin(), b.edges.end());
  b.edges.clear();
}

void Pass_engine::add_unfinished(const Blend_mesh& work, std::size_t i, int end, const Strip_border& border,
                                 const std::vector<Rim>& rims, Fillet_assembly& result) const {
  const Fillet_job& job = jobs_[i];
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

void Pass_engine::add_later(const Blend_mesh& work, const Trimming& trimming,
                            const std::map<std::size_t, std::array<End_assembly, 2>>& ends,
                            const std::vector<Rim>& rims, Fillet_assembly& result) const {
  std::set<std::pair<Vertex, Vertex>> filled;  // within faces that have grown
  for (const auto& [i, both] : ends)
    for (const End_assembly& end : both) filled.insert(end.filled.begin(), end.filled.end());
  std::map<std::size_t, std::size_t> place;  // of jobs in result.later
  const auto step = [&](Vertex a, Vertex b) { return Later_blend::Step(work.point(a), work.point(b)); };
  for (std::size_t i = 0; i < jobs_.size(); ++i) {
    const Fillet_job& job = jobs_[i];
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
      const std::vector<Vertex> chain =
          divided != trimming.divided.end() ? divided->second : std::vector<Vertex>{work.source(h), work.target(h)};
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
        const Halfedge into = other == 1 ? jobs_[k].halfedges.back() : body_.mesh->opposite(jobs_[k].halfedges.front());
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
        join_over(work.point(jobs_[i].ends[end]), over,
                  {result.later[place[*waiting[0]]], result.later[place[*waiting[1]]]});
      } else if (waiting[0] || waiting[1]) {  // a mitre: this one's surface cuts the other's
        const int side = waiting[0] ? 0 : 1;
        if (jobs_[*waiting[side]].curve.convex != jobs_[i].curve.convex) continue;
        const auto rim =
            std::find_if(rims.begin(), rims.end(), [&, i = i](const Rim& r) { return r.blend == i; }) + side;
        const Vec corner = to_vec(work.point(jobs_[i].ends[end]));
        for (std::size_t k = 0; k + 1 < rim->vertices.size(); ++k) {
          const Vec a = to_vec(work.point(rim->vertices[k])), b = to_vec(work.point(rim->vertices[k + 1]));
          if (off_segment(a, b, corner) < e.reach)
            result.creases.push_back(step(rim->vertices[k], rim->vertices[k + 1]));
        }
      }
    }
}

}  // namespace cgal_blend
