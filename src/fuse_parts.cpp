// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/fuse.h>

#include "mesh_checks.h"

#include <cgal_blend/validate.h>

#include <cmath>
#include <string>

namespace cgal_blend {

namespace {

/// A hole that is still there when the plane has cut: across it, or else on the side that is kept.
Diagnosis hole_that_stays(const Blend_mesh& mesh, const Cut_plane& plane) {
  Diagnosis kept;
  for (const Halfedge h : mesh.halfedges()) {
    if (!mesh.is_border(h)) continue;
    const Point_3& a = mesh.point(mesh.source(h));
    const bool from = side_of(plane, a) < 0, to = side_of(plane, mesh.point(mesh.target(h))) < 0;
    if (from != to) return {Status::section_not_closed, "", a, std::nullopt};
    if (from && kept.ok()) kept = {Status::input_not_closed, "", a, std::nullopt};
  }
  return kept;
}

Diagnosis first_flaw(const Blend_mesh& mesh) {
  for (const Vertex v : mesh.vertices())
    for (int k = 0; k < 3; ++k)
      if (!std::isfinite(mesh.point(v)[k]))
        return {Status::input_not_finite, "vertex " + std::to_string(v.idx()), {}, {}};
  for (const Face f : mesh.faces()) {
    const Halfedge h = mesh.halfedge(f);
    const Point_3& p = mesh.point(mesh.source(h));
    if (mesh.next(mesh.next(mesh.next(h))) != h ||
        CGAL::collinear(p, mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h)))))
      return {Status::input_degenerate, "face " + std::to_string(f.idx()), p, {}};
  }
  const auto pairs = internal::intersecting_pairs(mesh);
  if (pairs.empty()) return {};
  const auto& [f, g] = pairs.front();
  return {Status::input_self_intersecting,
          "faces " + std::to_string(f.idx()) + " and " + std::to_string(g.idx()),
          internal::meeting_point(mesh, pairs.front()),
          {}};
}

}  // namespace

Diagnosis check_fusion_part(const Blend_mesh& mesh, const std::optional<Cut_plane>& plane) {
  if (plane)
    if (const Diagnosis bad = check(*plane); !bad.ok()) return bad;
  if (mesh.number_of_faces() == 0) return {Status::input_empty, "", {}, {}};
  if (CGAL::is_closed(mesh)) return validate(mesh).diagnosis;
  if (const Diagnosis flaw = first_flaw(mesh); !flaw.ok()) return flaw;
  return plane ? hole_that_stays(mesh, *plane) : Diagnosis{};
}

}  // namespace cgal_blend
