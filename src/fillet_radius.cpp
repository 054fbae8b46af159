// SPDX-License-Identifier: GPL-3.0-or-later
#include "fillet_radius.h"

#include "refusal.h"

#include <cmath>
#include <optional>

namespace cgal_blend {

namespace {

/// Fraction of a branch's length at which one of its vertices lies, or nothing: of an open branch only its ends count.
std::optional<double> fraction_at(const Blend_mesh& mesh, const Branch<Blend_mesh>& branch, Vertex v) {
  std::optional<double> along;
  double length = 0;
  for (const Halfedge h : branch.halfedges) {
    if (!along && mesh.source(h) == v) along = length;
    length += std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))));
  }
  if (branch.closed()) return along ? std::optional(*along / length) : std::nullopt;
  if (mesh.source(branch.halfedges.front()) == v) return 0;
  return mesh.target(branch.halfedges.back()) == v ? std::optional(1.0) : std::nullopt;
}

Diagnosis wrong_at(const Blend_mesh& mesh, Vertex v, const char* what) {
  Diagnosis diagnosis = refusal(Status::invalid_parameter, to_vec(mesh.point(v)));
  diagnosis.detail = what;
  return diagnosis;
}

}  // namespace

Radius_law radius_law_of(const Edge_blend& blend, const Fillet_options& options) {
  if (blend.law) return *blend.law;
  if (blend.radius != 0 || !options.law) return blend.radius != 0 ? blend.radius : options.radius;
  return *options.law;
}

Branch_laws laws_along(const Blend_mesh& mesh, const Curve_network<Blend_mesh>& network, const Edge_blend& blend,
                       const Fillet_options& options) {
  const Radius_law law = radius_law_of(blend, options);
  Branch_laws result;
  result.diagnosis = law.check();
  if (!result.diagnosis.ok()) return result;
  bool start_is_found = !blend.start;
  for (const Branch<Blend_mesh>& branch : network.branches) {
    const std::optional<double> found = blend.start ? fraction_at(mesh, branch, *blend.start) : std::nullopt;
    const double start = found.value_or(0);
    start_is_found = start_is_found || found;
    if (branch.closed() && !law.is_periodic()) {
      const Vertex at = found ? *blend.start : mesh.source(branch.halfedges.front());
      result.diagnosis = wrong_at(mesh, at, "on a closed curve the radius must end as it begins");
      return result;
    }
    if (branch.closed())
      result.laws.push_back(law.with_period().shifted(-start));
    else
      result.laws.push_back(start > 0 ? law.reversed() : law);
  }
  if (!start_is_found)
    result.diagnosis =
        wrong_at(mesh, *blend.start, "the radius must start at an end of an open curve or on a closed one");
  return result;
}

}  // namespace cgal_blend
