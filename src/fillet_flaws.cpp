// SPDX-License-Identifier: GPL-3.0-or-later
#include "fillet_flaws.h"

#include "fillet_radius.h"
#include "mesh_checks.h"

#include <cgal_blend/creases.h>
#include <cgal_blend/curve_network.h>

#include <algorithm>
#include <utility>

namespace cgal_blend {

namespace {

// A flaw so many radii from the place of a refusal is none of its causes: the blend and what it rolls over end before.
constexpr double reach_in_radii = 3;

bool is_pair(const Flaw& flaw) { return flaw.faces[0] != flaw.faces[1]; }

/// A common point of two faces, a corner of a single one.
Point_3 place(const Blend_mesh& mesh, const Flaw& flaw) {
  if (is_pair(flaw)) return internal::meeting_point(mesh, {flaw.faces[0], flaw.faces[1]});
  return mesh.point(mesh.source(mesh.halfedge(flaw.faces[0])));
}

/// From the place where two faces meet, or from the sides of a single one.
double squared_distance(const Blend_mesh& mesh, const Flaw& flaw, const Point_3& p) {
  double nearest = CGAL::squared_distance(place(mesh, flaw), p);
  if (is_pair(flaw)) return nearest;
  for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(flaw.faces[0]))) {
    const Point_3 &a = mesh.point(mesh.source(h)), &b = mesh.point(mesh.target(h));
    if (a != b) nearest = std::min(nearest, CGAL::squared_distance(Kernel::Segment_3(a, b), p));
  }
  return nearest;
}

template <class Is_met>
Diagnosis first_met(const Blend_mesh& mesh, const std::vector<Flaw>& flaws, const Is_met& is_met) {
  for (const Flaw& flaw : flaws)
    if (is_met(flaw.faces[0]) || is_met(flaw.faces[1])) return flaw_diagnosis(mesh, flaw, "in the way of the blend");
  return {};
}

bool may_come_from_flaw(Status status) {
  switch (status) {
    case Status::corner:
    case Status::radius_exceeds_face:
    case Status::radius_exceeds_curvature:
    case Status::no_rolling_ball:
    case Status::blends_overlap:
    case Status::blend_collides:
    case Status::region_not_annular:
    case Status::parametrization_folds:
    case Status::region_too_coarse:
    case Status::result_invalid: return true;
    default: return false;
  }
}

}  // namespace

Diagnosis flaw_diagnosis(const Blend_mesh& mesh, const Flaw& flaw, const std::string& where) {
  Diagnosis diagnosis;
  diagnosis.status = flaw.status;
  diagnosis.detail = (is_pair(flaw) ? "faces " : "face ") + std::to_string(flaw.faces[0].idx());
  if (is_pair(flaw)) diagnosis.detail += " and " + std::to_string(flaw.faces[1].idx());
  diagnosis.detail += ", " + where;
  diagnosis.point = place(mesh, flaw);
  return diagnosis;
}

Diagnosis flaw_at_edges(const Blend_mesh& mesh, const std::vector<Flaw>& flaws, const std::vector<Edge_blend>& blends) {
  std::vector<bool> on_edge(mesh.num_vertices(), false);
  for (const Edge_blend& blend : blends)
    for (const Edge e : blend.edges)
      for (int side = 0; side < 2; ++side) on_edge[mesh.vertex(e, side).idx()] = true;
  return first_met(mesh, flaws, [&](Face f) {
    const auto corners = mesh.vertices_around_face(mesh.halfedge(f));
    return std::any_of(corners.begin(), corners.end(), [&](Vertex v) { return on_edge[v.idx()]; });
  });
}

std::vector<Blend_report> leave_out_flawed_curves(const Blend_mesh& mesh, const std::vector<Flaw>& flaws,
                                                  std::vector<Edge_blend>& blends, const Fillet_options& options) {
  std::vector<Blend_report> left_out;
  std::vector<Edge_blend> others;
  for (const Edge_blend& blend : blends) {
    Edge_blend rest = blend;
    rest.edges.clear();
    bool has_start = false;
    for (const Branch<Blend_mesh>& branch : make_curve_network(mesh, blend.edges).branches) {
      Edge_blend curve;
      for (const Halfedge h : branch.halfedges) curve.edges.push_back(mesh.edge(h));
      if (Diagnosis flaw = flaw_at_edges(mesh, flaws, {curve}); !flaw.ok()) {
        Blend_report& report = left_out.emplace_back();
        report.diagnosis = std::move(flaw);
        report.edges = curve.edges.size();
        report.closed = branch.closed();
        report.convex = is_convex_edge(curve.edges.front(), mesh);
        report.radius = radius_law_of(blend, options).largest();
        continue;
      }
      rest.edges.insert(rest.edges.end(), curve.edges.begin(), curve.edges.end());
      for (const Halfedge h : branch.halfedges)
        has_start = has_start || mesh.source(h) == blend.start || mesh.target(h) == blend.start;
    }
    if (!has_start) rest.start.reset();
    if (!rest.edges.empty()) others.push_back(std::move(rest));
  }
  blends = std::move(others);
  return left_out;
}

Diagnosis flaw_in_changes(const Blend_mesh& mesh, const std::vector<Flaw>& flaws, const Fillet_outcome& outcome) {
  std::vector<bool> is_changed(outcome.origins.size(), false), is_kept(mesh.num_faces(), false);
  for (const Face f : outcome.changed_faces) is_changed[f.idx()] = true;
  for (std::size_t f = 0; f < outcome.origins.size(); ++f)
    if (!is_changed[f] && outcome.origins[f] != no_origin) is_kept[outcome.origins[f]] = true;
  return first_met(mesh, flaws, [&](Face f) { return !is_kept[f.idx()]; });
}

Diagnosis flaw_near_refusal(const Blend_mesh& mesh, const std::vector<Flaw>& flaws,
                            const std::vector<Edge_blend>& blends, const Fillet_options& options,
                            const Diagnosis& refusal) {
  if (!refusal.point || !may_come_from_flaw(refusal.status)) return {};
  double reach = 0;
  for (const Edge_blend& blend : blends)
    reach = std::max(reach, reach_in_radii * radius_law_of(blend, options).largest());
  double nearest = reach * reach;
  const Flaw* cause = nullptr;
  for (const Flaw& flaw : flaws) {
    const double distance = squared_distance(mesh, flaw, *refusal.point);
    if (distance >= nearest) continue;
    nearest = distance;
    cause = &flaw;
  }
  if (!cause) return {};
  Diagnosis diagnosis = flaw_diagnosis(mesh, *cause, "in the way of the blend");
  diagnosis.max_radius = refusal.max_radius;
  return diagnosis;
}

}  // namespace cgal_blend
