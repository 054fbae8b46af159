// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/fillet.h>

#include "ancestry.h"
#include "boolean.h"
#include "edge_finder.h"
#include "fillet_coarse.h"
#include "fillet_flaws.h"
#include "fillet_in_passes.h"
#include "fillet_partial.h"
#include "near_faces.h"
#include "propagate_chain.h"
#include "sharp_mesh.h"
#include "snap_to_planes.h"
#include "stopwatch.h"

#include <cgal_blend/validate.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace cgal_blend {

namespace {

// A profile that leaves its wedge by more, in legs, is a mistake.
constexpr double largest_profile = 1000;

Fillet_outcome blend_body(const Fillet_body& body, const std::vector<Edge_blend>& blends, Blend_mesh& out,
                          const Fillet_options& options) {
  return options.coarse_faces > 0 ? fillet_coarse(body, blends, out, options) : fillet_in_passes(body, blends, out, options);
}

/// Blends edges of a mesh whose flaws must not be met.
Fillet_outcome blend_beside_flaws(const Fillet_body& body, std::vector<Edge_blend> blends,
                                  const std::vector<Flaw>& flaws, Blend_mesh& out, const Fillet_options& options) {
  const Blend_mesh& mesh = *body.mesh;
  Fillet_outcome outcome;
  std::vector<Blend_report> left_sharp;
  if (options.coarse_faces > 0) {
    outcome.diagnosis = flaw_diagnosis(mesh, flaws.front(), "where the coarse level would be");
  } else if (options.keep_going) {
    left_sharp = leave_out_flawed_curves(mesh, flaws, blends, options);
    if (blends.empty() && !left_sharp.empty()) outcome.diagnosis = left_sharp.front().diagnosis;
  } else {
    outcome.diagnosis = flaw_at_edges(mesh, flaws, blends);
  }
  if (outcome.ok()) {
    outcome = blend_body(body, blends, out, options);
    const Diagnosis flaw = outcome.ok() ? flaw_in_changes(mesh, flaws, outcome)
                                        : flaw_near_refusal(mesh, flaws, blends, options, outcome.diagnosis);
    if (!flaw.ok()) {
      outcome.diagnosis = flaw;
      out.clear();
    }
  }
  outcome.blends.insert(outcome.blends.end(), left_sharp.begin(), left_sharp.end());
  return outcome;
}

/// A profile must be made of numbers, whatever the wedge.
bool is_finite(const Profile& profile) {
  for (const double angle : {0.5, 1.5, 2.5})
    for (int k = 0; k <= 16; ++k) {
      const Profile_point p = profile(k / 16.0, {angle, {}});
      if (!std::isfinite(std::abs(p.centre) + std::abs(p.contact_1) + std::abs(p.apex) + std::abs(p.contact_2)) ||
          std::abs(p.apex) > largest_profile)
        return false;
    }
  return true;
}

Diagnosis check_options(const Fillet_options& options) {
  const auto wrong = [](const char* what) {
    return Diagnosis{Status::invalid_parameter, what, std::nullopt, std::nullopt};
  };
  if (!(options.chord_tolerance >= 1e-6 && options.chord_tolerance <= 0.3))
    return wrong("chord tolerance must lie between 1e-6 and 0.3");
  if (!(options.smooth_angle > 0 && options.smooth_angle < 180))
    return wrong("smooth angle must lie between 0 and 180 degrees");
  if (!is_finite(options.profile)) return wrong("the profile must be finite, and not wander far beyond its apex");
  if (options.coarse_faces > 0 && options.mode != Blend_mode::map)
    return wrong("a coarse level keeps the connectivity, so it needs the map mode");
  if (!(options.chord_ratio >= 0 && options.chord_ratio <= 1)) return wrong("chord ratio must lie between 0 and 1");
  if (options.law && !options.law->check().ok()) return options.law->check();
  if (!(options.radius >= 0) || !std::isfinite(options.radius)) return wrong("radius must be a positive number");
  return {};
}

bool identical(const Blend_mesh& a, const Blend_mesh& b) {
  if (a.number_of_vertices() != b.number_of_vertices() || a.number_of_faces() != b.number_of_faces()) return false;
  std::vector<Point_3> p, q;
  for (const Vertex v : a.vertices()) p.push_back(a.point(v));
  for (const Vertex v : b.vertices()) q.push_back(b.point(v));
  std::sort(p.begin(), p.end());
  std::sort(q.begin(), q.end());
  return p == q;
}

Fillet_outcome refused(Status status) {
  Fillet_outcome outcome;
  outcome.diagnosis.status = status;
  return outcome;
}

/// Why the sharp result is not valid, in terms of the operands.
Status sharp_failure(const Boolean_result& sharp) {
  if (sharp.coplanar) return Status::operands_coplanar;
  return sharp.curves.empty() ? Status::operands_touch : Status::boolean_failed;
}

Fillet_outcome sharp_boolean(const Fillet_body& body, const Boolean_result& sharp, Blend_mesh& out) {
  Fillet_outcome outcome = finish_body(body, Sharp_mesh(body).mesh, {}, out);
  if (!outcome.diagnosis.ok()) {
    outcome.diagnosis.status = sharp_failure(sharp);
    out.clear();
  }
  return outcome;
}

Fillet_body body_of(const std::array<const Blend_mesh*, 2>& operands, const Boolean_result& sharp,
                    Boolean_operation operation) {
  Fillet_body body;
  body.mesh = &sharp.mesh;
  body.cells = sharp.cells;
  body.base = operands;
  body.reversed = {false, operation == Boolean_operation::difference};
  body.own_surface = false;
  return body;
}

/// Blends the curves of a boolean as edges of the mesh that results, whatever surfaces it was made of: their corners are
/// known to the mesh alone.
Fillet_outcome blend_result(const Fillet_body& body, const Boolean_result& sharp, Blend_mesh& out,
                            const Fillet_options& options, bool search) {
  Blend_mesh plain;
  Fillet_outcome whole = sharp_boolean(body, sharp, plain);
  if (!whole.ok()) return whole;
  std::vector<Edge_finder::Step> steps;
  for (const Edge e : sharp.curves)
    steps.emplace_back(sharp.mesh.point(sharp.mesh.vertex(e, 0)), sharp.mesh.point(sharp.mesh.vertex(e, 1)));
  Ancestry ancestry(whole);
  Fillet_body own;
  own.mesh = own.base[0] = own.base[1] = &plain;
  whole = fillet_in_passes(own, {{Edge_finder(plain)(steps)}}, out, options, search);
  if (!whole.ok()) return whole;
  ancestry.advance(whole, 0);
  ancestry.put_kept_first(out);
  ancestry.describe_faces(whole);
  return whole;
}

/// Blends the curves of a boolean. Where the boolean itself is not valid, that is what is wrong, and not the blend.
Fillet_outcome blend_sharp(const Fillet_body& body, const Boolean_result& sharp, Blend_mesh& out,
                           const Fillet_options& options) {
  if (options.mode != Blend_mode::stitch) return blend_body(body, {{sharp.curves}}, out, options);
  Fillet_outcome outcome = fillet_in_passes(body, {{sharp.curves}}, out, options, false);
  switch (outcome.diagnosis.status) {
    case Status::ok:
    case Status::result_invalid: break;
    case Status::corner:
    case Status::open_branch:
    case Status::mixed_convexity: {
      Fillet_outcome other = blend_result(body, sharp, out, options, true);
      if (other.ok() || other.diagnosis.max_radius) return other;
      break;
    }
    default: outcome = fillet_in_passes(body, {{sharp.curves}}, out, options);
  }
  if (outcome.diagnosis.status != Status::result_invalid) return outcome;
  Blend_mesh unblended;
  const Fillet_outcome without = sharp_boolean(body, sharp, unblended);
  if (!without.ok()) outcome.diagnosis = without.diagnosis;
  return outcome;
}

/// A place where a vertex of one operand lies on one of the other and no curve passes: the result would be pinched
/// there. The faces around are those of the operands, which no later check looks at again.
std::optional<Point_3> pinch(const Boolean_result& sharp, const std::array<const Blend_mesh*, 2>& operands) {
  if (!sharp.contact) return std::nullopt;
  const auto bounds = [&](int side) { return CGAL::Polygon_mesh_processing::bbox(*operands[side]); };
  const CGAL::Bbox_3 boxes[] = {bounds(0), bounds(1)};
  const auto is_near = [&](int side, Vertex v, Vertex placed) {
    return placed != Blend_mesh::null_vertex() && CGAL::do_overlap(operands[side]->point(v).bbox(), boxes[1 - side]);
  };
  std::vector<std::pair<Point_3, Vertex>> first;
  for (const Vertex v : operands[0]->vertices())
    if (const Vertex placed = sharp.cells.vertex(0, v); is_near(0, v, placed))
      first.emplace_back(operands[0]->point(v), placed);
  std::sort(first.begin(), first.end());
  for (const Vertex v : operands[1]->vertices()) {
    const Vertex placed = sharp.cells.vertex(1, v);
    if (!is_near(1, v, placed)) continue;
    const Point_3& point = operands[1]->point(v);
    const auto found = std::lower_bound(first.begin(), first.end(), std::make_pair(point, Vertex(0)));
    if (found != first.end() && found->first == point && found->second != placed) return point;
  }
  return std::nullopt;
}

/// Goes on from the sharp result of a boolean.
Fillet_outcome blend_boolean(const std::array<const Blend_mesh*, 2>& operands, const Boolean_result& sharp,
                             Boolean_operation operation, Blend_mesh& out, const Fillet_options& options) {
  const bool blend = options.law || options.radius > 0;
  Fillet_outcome outcome;
  outcome.diagnosis = sharp.diagnosis;
  if (!outcome.diagnosis.ok()) return outcome;
  if (sharp.mesh.is_empty()) return refused(Status::empty_result);
  if (blend && sharp.curves.empty())
    return refused(sharp.coplanar  ? Status::operands_coplanar
                   : sharp.contact ? Status::operands_touch
                                   : Status::operands_disjoint);
  if (const auto at = pinch(sharp, operands)) {
    outcome = refused(Status::operands_touch);
    outcome.diagnosis.point = at;
    return outcome;
  }
  const Fillet_body body = body_of(operands, sharp, operation);
  return blend ? blend_sharp(body, sharp, out, options) : sharp_boolean(body, sharp, out);
}

/// Computes the boolean on shared planes and goes on from there; false if there is no such boolean, or its result is
/// not valid. Checks all of the sharp result, as vertices of faces that are kept may have moved within rounding.
bool on_shared_planes(const Blend_mesh& a, const Blend_mesh& b, Boolean_operation operation, Blend_mesh& out,
                      const Fillet_options& options, Fillet_outcome& outcome) {
  Stopwatch watch;
  Blend_mesh moved = b;
  const std::optional<Boolean_result> sharp = compute_boolean_on_shared_planes(a, moved, operation);
  const double boolean_time = watch.milliseconds();
  if (!sharp) return false;
  if (sharp->diagnosis.ok() && !sharp->mesh.is_empty()) {
    Blend_mesh mesh = Sharp_mesh(body_of({&a, &moved}, *sharp, operation)).mesh;
    mesh.collect_garbage();
    if (!validate(mesh).ok()) return false;
  }
  outcome = blend_boolean({&a, &moved}, *sharp, operation, out, options);
  outcome.times.boolean = boolean_time;
  return true;
}

/// True if the boolean is to blame, and not the blend.
bool is_failure_of_boolean(const Fillet_outcome& outcome) {
  switch (outcome.diagnosis.status) {
    case Status::operands_touch:
    case Status::operands_coplanar:
    case Status::boolean_failed:
    case Status::result_invalid: return true;
    default: return false;
  }
}

}  // namespace

namespace unchecked {

Fillet_outcome fillet_edges(const Blend_mesh& mesh, const std::vector<Edge_blend>& blends, Blend_mesh& out,
                            const Fillet_options& options) {
  return fillet_edges(mesh, blends, std::vector<Flaw>{}, out, options);
}

Fillet_outcome fillet_edges(const Blend_mesh& mesh, const std::vector<Edge_blend>& chosen,
                            const std::vector<Flaw>& flaws, Blend_mesh& out, const Fillet_options& options) {
  Fillet_outcome outcome;
  outcome.diagnosis = check_options(options);
  if (!outcome.diagnosis.ok()) return outcome;
  for (const Edge_blend& blend : chosen) {
    outcome.diagnosis = check_range(blend);
    if (blend.profile && !is_finite(*blend.profile))
      outcome.diagnosis = {Status::invalid_parameter, "the profile of a blend must be finite", {}, {}};
    if (!outcome.diagnosis.ok()) return outcome;
  }
  const std::vector<Edge_blend> blends =
      options.propagate ? propagate_chains(mesh, chosen, options.smooth_angle) : chosen;
  const auto engine = [&](const Fillet_body& body, const std::vector<Edge_blend>& wanted) {
    return flaws.empty() ? blend_body(body, wanted, out, options)
                         : blend_beside_flaws(body, wanted, flaws, out, options);
  };
  if (std::any_of(blends.begin(), blends.end(), is_partial))
    return fillet_partial(mesh, blends, flaws, out, options, engine);
  Fillet_body body;
  body.mesh = body.base[0] = body.base[1] = &mesh;
  return engine(body, blends);
}

Fillet_outcome corefine_and_fillet(const Blend_mesh& first, const Blend_mesh& second, Boolean_operation operation,
                                   Blend_mesh& out, const Fillet_options& options) {
  Fillet_outcome outcome;
  outcome.diagnosis = check_options(options);
  if (!outcome.diagnosis.ok()) return outcome;
  const bool blend = options.law || options.radius > 0;
  if (blend && identical(first, second)) return refused(Status::operands_identical);
  Blend_mesh a = first, b = second;
  snap_to_planes(a, b);
  snap_to_planes(b, a);
  const bool nearly_coplanar = coplanar_but_for_rounding(a, b);
  if (nearly_coplanar && on_shared_planes(a, b, operation, out, options, outcome)) return outcome;
  Stopwatch watch;
  const Boolean_result sharp = compute_boolean(a, b, operation);
  const double boolean_time = watch.milliseconds();
  outcome = blend_boolean({&a, &b}, sharp, operation, out, options);
  outcome.times.boolean = boolean_time;
  if (nearly_coplanar && outcome.ok() && !validate(out).ok()) {  // whole faces may cross each other then
    outcome = refused(Status::operands_coplanar);
    out.clear();
  }
  if (!nearly_coplanar && is_failure_of_boolean(outcome)) {
    Fillet_outcome other;
    if (on_shared_planes(a, b, operation, out, options, other) && other.ok()) return other;
    out.clear();
  }
  return outcome;
}

}  // namespace unchecked

}  // namespace cgal_blend
