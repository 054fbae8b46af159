// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_STATUS_H
#define CGAL_BLEND_STATUS_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <optional>
#include <string>

namespace cgal_blend {

/// The outcome of an operation; every value but `ok` is a named refusal.
enum class Status {
  ok,
  // The call itself.
  invalid_parameter,
  not_supported,
  cancelled,
  // The input meshes.
  input_empty,
  input_not_finite,
  input_not_manifold,
  input_not_closed,
  input_misoriented,
  input_degenerate,
  input_self_intersecting,
  // The operands of a boolean.
  operands_disjoint,
  operands_touch,
  operands_coplanar,
  operands_identical,
  boolean_failed,
  empty_result,
  // The blending curves.
  no_such_edge,
  no_edges_selected,
  open_branch,
  corner,
  edge_is_smooth,
  mixed_convexity,
  // The ball.
  radius_exceeds_face,
  radius_exceeds_curvature,
  no_rolling_ball,
  blends_overlap,
  blend_collides,
  // Blends between surfaces.
  singular_boundary,
  curves_do_not_correspond,
  no_boundary_curve,
  surface_not_bounded,
  blend_folds,
  // Fusion of cut meshes.
  plane_misses_mesh,
  plane_meets_vertex,
  section_not_closed,
  opening_not_planar,
  openings_overlap,
  planes_too_steep,
  sides_interpenetrate,
  openings_not_joined,
  // Bridges.
  spot_off_surface,
  radius_exceeds_cut_locus,
  region_meets_border,
  curve_crosses_itself,
  regions_overlap,
  // Mapping.
  region_not_annular,
  parametrization_folds,
  region_too_coarse,
  // A result that breaks the promise of validity is never handed out.
  result_invalid
};

/// What a status means for the caller; the command line's exit status.
enum class Status_class { ok = 0, usage = 2, input = 3, blend = 4, result = 5 };

/// Returns the class of a status.
[[nodiscard]] Status_class status_class(Status status) noexcept;

/// Returns the identifier of a status as it stands in reports, e.g. "input_not_closed".
[[nodiscard]] const char* name(Status status) noexcept;

/// Returns one plain sentence that says what a status means, without final full stop.
[[nodiscard]] const char* describe(Status status) noexcept;

/// A status with its place, its wording, and the value that would work where one is known.
struct Diagnosis {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

  Status status = Status::ok;
  std::string detail;                ///< what exactly, e.g. "faces 12 and 80"; may be empty
  std::optional<Point> point;        ///< where, in the coordinates of the input
  std::optional<double> max_radius;  ///< largest radius known to work there, length units

  [[nodiscard]] bool ok() const noexcept { return status == Status::ok; }
};

/// Returns one line for users: what is wrong, where, and the number that would work.
[[nodiscard]] std::string message(const Diagnosis& diagnosis);

}  // namespace cgal_blend

#endif
