// SPDX-License-Identifier: GPL-3.0-or-later
#include "fillet_stations.h"

#include "fillet_radius.h"
#include "refusal.h"

#include <cgal_blend/curve_network.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cgal_blend {

namespace {

Diagnosis wrong_at(const Blend_mesh& mesh, Vertex v, const char* what) {
  Diagnosis diagnosis = refusal(Status::invalid_parameter, to_vec(mesh.point(v)));
  diagnosis.detail = what;
  return diagnosis;
}

/// Turns a branch so that it begins at a vertex; false if it cannot: only its ends begin an open branch.
bool begin_at(const Blend_mesh& mesh, Vertex start, Branch<Blend_mesh>& branch) {
  std::vector<Halfedge>& chain = branch.halfedges;
  const auto found = std::find_if(chain.begin(), chain.end(), [&](Halfedge h) { return mesh.source(h) == start; });
  if (found == chain.begin()) return true;
  if (branch.closed()) {
    std::rotate(chain.begin(), found, chain.end());
    return found != chain.end();
  }
  if (mesh.target(chain.back()) != start) return false;
  std::reverse(chain.begin(), chain.end());
  for (Halfedge& h : chain) h = mesh.opposite(h);
  return true;
}

/// Finds a place by its distance along a curve.
/// \param begins distance of each vertex of the curve
Curve_station find_station(const std::vector<double>& begins, double distance, double snap) {
  const auto above = std::upper_bound(begins.begin() + 1, begins.end() - 1, distance);
  const auto i = static_cast<std::size_t>(above - begins.begin()) - 1;
  const double before = distance - begins[i], after = begins[i + 1] - distance;
  if (std::min(before, after) < snap) return {before < after ? i : i + 1, 0};
  return {i, before / (begins[i + 1] - begins[i])};
}

/// Adds the part of one curve between the fractions of its blend.
Diagnosis add_part(const Blend_mesh& mesh, const Edge_blend& blend, Branch<Blend_mesh> branch, double snap,
                   std::vector<Blend_part>& parts) {
  std::vector<Halfedge>& curve = branch.halfedges;
  const Vertex first = mesh.source(curve.front());
  const bool over_start = blend.to < blend.from;
  if (over_start && !branch.closed())
    return wrong_at(mesh, first, "on an open curve a blend must begin before it ends");
  const std::size_t once = curve.size();
  if (over_start)
    for (std::size_t i = 0; i < once; ++i) curve.push_back(curve[i]);
  std::vector<double> begins{0};
  for (const Halfedge h : curve)
    begins.push_back(begins.back() +
                     std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)))));
  const double from = blend.from * begins[once], to = (blend.to + (over_start ? 1 : 0)) * begins[once];
  Blend_part& part = parts.emplace_back();
  part.whole = false;
  part.ends = {find_station(begins, from, snap), find_station(begins, to, snap)};
  part.curve = std::move(curve);
  const bool has_length =
      std::pair(part.ends[0].edge, part.ends[0].part) < std::pair(part.ends[1].edge, part.ends[1].part);
  if (!has_length || to - from < snap)
    return wrong_at(mesh, first, "the part of the curve that is to be blended has no length");
  return {};
}

Diagnosis add_parts(const Blend_mesh& mesh, const Edge_blend& blend, double snap, std::vector<Blend_part>& parts) {
  bool start_is_found = !blend.start;
  Curve_network<Blend_mesh> network = make_curve_network(mesh, blend.edges);
  for (Branch<Blend_mesh>& branch : network.branches) {
    if (blend.start && begin_at(mesh, *blend.start, branch)) start_is_found = true;
    if (Diagnosis bad = add_part(mesh, blend, std::move(branch), snap, parts); !bad.ok()) return bad;
  }
  if (start_is_found) return {};
  return wrong_at(mesh, *blend.start, "fractions must start at an end of an open curve or on a closed one");
}

}  // namespace

Diagnosis check_range(const Edge_blend& blend) {
  const bool is_range = blend.from >= 0 && blend.from < 1 && blend.to > 0 && blend.to <= 1 && blend.from != blend.to;
  if (is_range) return {};
  return {Status::invalid_parameter,
          "a blend must begin and end at different fractions of its curve, between 0 and 1",
          {},
          {}};
}

Blend_parts find_parts(const Blend_mesh& mesh, const std::vector<Edge_blend>& blends, const Fillet_options& options) {
  Blend_parts result;
  for (std::size_t i = 0; i < blends.size(); ++i) {
    const std::size_t before = result.parts.size();
    const Radius_law law = radius_law_of(blends[i], options);
    if (result.diagnosis = law.check(); !result.diagnosis.ok()) return result;
    if (is_partial(blends[i]))
      result.diagnosis = add_parts(mesh, blends[i], snap_of_station * law.largest(), result.parts);
    else
      result.parts.emplace_back();
    if (!result.diagnosis.ok()) return result;
    for (std::size_t k = before; k < result.parts.size(); ++k) result.parts[k].blend = i;
  }
  return result;
}

}  // namespace cgal_blend
