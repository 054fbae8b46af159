// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge_union.h"

#include "boolean.h"
#include "collapse_short_edges.h"
#include "refusal.h"
#include "stitching.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace cgal_blend {

namespace {

using Step = std::pair<Vertex, Vertex>;

/// The curves as steps between vertices, after some of these were merged.
std::vector<Step> curve_steps(const Boolean_result& sharp, const std::vector<std::pair<Vertex, Vertex>>& merged) {
  std::unordered_map<Vertex, Vertex> into(merged.begin(), merged.end());
  const auto now = [&](Vertex v) {
    for (auto at = into.find(v); at != into.end(); at = into.find(v)) v = at->second;
    return v;
  };
  std::vector<Step> steps;
  for (const Edge e : sharp.curves) {
    const Step step{now(sharp.mesh.vertex(e, 0)), now(sharp.mesh.vertex(e, 1))};
    if (step.first != step.second) steps.push_back(step);
  }
  return steps;
}

bool same_corners(const Blend_mesh& a, const Blend_mesh& b, Face f) {
  Halfedge g = a.halfedge(f), h = b.halfedge(f);
  for (int i = 0; i < 3; ++i, g = a.next(g), h = b.next(h))
    if (a.point(a.target(g)) != b.point(b.target(h))) return false;
  return true;
}

/// Numbers what is left of the mesh anew.
void compact(const Boolean_result& sharp, const Blend_mesh& work, const std::vector<Step>& steps,
             Bridge_union& result) {
  const std::vector<Vertex> vertices(work.vertices().begin(), work.vertices().end());
  const std::vector<Face> faces(work.faces().begin(), work.faces().end());
  std::unordered_map<Vertex, Vertex> number;
  for (const Vertex v : vertices) number.emplace(v, Vertex(static_cast<std::uint32_t>(number.size())));
  result.mesh = reorder(work, vertices, faces).mesh;
  for (const Face f : faces) {
    result.origins.push_back(sharp.cells.cell(f));
    result.of_second.push_back(sharp.cells.operand(f) == 1);
    result.whole.push_back(sharp.cells.whole(f, sharp.mesh) && same_corners(work, sharp.mesh, f));
  }
  for (const Step& step : steps) {
    const Halfedge h = result.mesh.halfedge(number.at(step.first), number.at(step.second));
    if (h == Blend_mesh::null_halfedge())
      result.diagnosis = refusal(Status::boolean_failed, to_vec(work.point(step.first)));
    else
      result.curves.insert(result.mesh.edge(h));
  }
}

/// Halfedges of the curves by the vertex that they leave, with the first body on their left.
std::unordered_map<Vertex, Halfedge> leaving(Bridge_union& result) {
  std::unordered_map<Vertex, Halfedge> found;
  const auto of_second = [&](Halfedge h) { return result.of_second[result.mesh.face(h).idx()]; };
  for (const Edge e : result.curves) {
    Halfedge h = result.mesh.halfedge(e);
    if (of_second(h)) h = result.mesh.opposite(h);
    if (of_second(h) || !of_second(result.mesh.opposite(h)) || !found.emplace(result.mesh.source(h), h).second)
      result.diagnosis = refusal(Status::corner, to_vec(result.mesh.point(result.mesh.source(h))));
  }
  return found;
}

void chain(Bridge_union& result) {
  const auto next = leaving(result);
  if (!result.diagnosis.ok()) return;
  std::vector<Vertex> starts;
  for (const auto& [v, h] : next) starts.push_back(v);
  std::sort(starts.begin(), starts.end());
  std::unordered_set<Vertex> seen;
  for (const Vertex start : starts) {
    if (seen.count(start)) continue;
    result.loops.emplace_back();
    for (Vertex v = start; seen.insert(v).second; v = result.mesh.target(result.loops.back().back())) {
      const auto found = next.find(v);
      if (found == next.end()) {
        result.diagnosis = refusal(Status::open_branch, to_vec(result.mesh.point(v)));
        return;
      }
      result.loops.back().push_back(found->second);
    }
  }
}

}  // namespace

Bridge_union unite(const Blend_mesh& a, const Blend_mesh& b) {
  Bridge_union result;
  const Boolean_result sharp = compute_boolean(a, b, Boolean_operation::union_);
  result.diagnosis = sharp.diagnosis;
  if (!result.diagnosis.ok()) return result;
  if (sharp.curves.empty()) {
    result.diagnosis.status = sharp.contact ? Status::operands_touch : Status::operands_disjoint;
    return result;
  }
  Blend_mesh work = sharp.mesh;
  std::vector<std::pair<Vertex, Vertex>> merged;
  if (has_short_edges(work)) merged = collapse_short_edges(work, [&](Vertex v) { return sharp.cells.is_original(v); });
  compact(sharp, work, curve_steps(sharp, merged), result);
  if (result.diagnosis.ok()) chain(result);
  return result;
}

}  // namespace cgal_blend
