// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/status.h>

#include "number_text.h"

#include <CGAL/number_utils.h>

#include <charconv>
#include <cmath>

namespace cgal_blend {

namespace {

/// The three faces of a status, kept together so that none can be forgotten.
struct Wording {
  const char* name;
  const char* sentence;
  Status_class status_class;
};

Wording wording(Status status) noexcept {
  using S = Status;
  using C = Status_class;
  switch (status) {
    case S::ok: return {"ok", "Everything is in order", C::ok};
    case S::invalid_parameter: return {"invalid_parameter", "An option has a value outside its range", C::usage};
    case S::not_supported: return {"not_supported", "This is not supported in this version", C::blend};
    case S::cancelled: return {"cancelled", "The operation was cancelled", C::blend};

    case S::input_empty: return {"input_empty", "The mesh has no faces", C::input};
    case S::input_not_finite:
      return {"input_not_finite", "The mesh has a coordinate that is not a finite number", C::input};
    case S::input_not_manifold:
      return {"input_not_manifold",
              "The mesh is not a surface everywhere: parts of it only touch along an edge or in a vertex", C::input};
    case S::input_not_closed:
      return {"input_not_closed", "The mesh is not closed: it has a hole or an open edge", C::input};
    case S::input_misoriented:
      return {"input_misoriented", "The faces of the mesh do not all point outwards", C::input};
    case S::input_degenerate:
      return {"input_degenerate", "The mesh has a face without area or an edge of almost no length", C::input};
    case S::input_self_intersecting: return {"input_self_intersecting", "The mesh cuts through itself", C::input};

    case S::operands_disjoint:
      return {"operands_disjoint", "The two bodies do not meet, so there is no curve to blend", C::blend};
    case S::operands_touch:
      return {"operands_touch",
              "The two bodies only touch, in a point or along a curve, so the result would not be a solid", C::blend};
    case S::operands_coplanar:
      return {"operands_coplanar", "The two bodies share part of a face, so their intersection is not a curve there",
              C::blend};
    case S::operands_identical: return {"operands_identical", "The two bodies are the same", C::blend};
    case S::boolean_failed:
      return {"boolean_failed", "The boolean of the two bodies could not be computed reliably", C::blend};
    case S::empty_result: return {"empty_result", "Nothing is left: the result of the operation is empty", C::blend};

    case S::no_such_edge: return {"no_such_edge", "The mesh has no such edge", C::blend};
    case S::no_edges_selected: return {"no_edges_selected", "No edge to blend was found", C::blend};
    case S::open_branch:
      return {"open_branch", "The curve to blend has ends, and a blend of this kind needs a closed curve", C::blend};
    case S::corner:
      return {"corner", "A blend ends, or blends meet, in a corner of a kind that is not supported", C::blend};
    case S::edge_is_smooth:
      return {"edge_is_smooth", "The edge is smooth already: its faces hardly meet at an angle", C::blend};
    case S::mixed_convexity:
      return {"mixed_convexity", "The curve to blend is a ridge in one place and a groove in another", C::blend};

    case S::radius_exceeds_face:
      return {"radius_exceeds_face", "The radius is too large: the ball rolls off one of the neighbouring surfaces",
              C::blend};
    case S::radius_exceeds_curvature:
      return {"radius_exceeds_curvature", "The radius is too large for the curvature: the blend would fold over itself",
              C::blend};
    case S::no_rolling_ball:
      return {"no_rolling_ball", "No ball of this radius touches both surfaces along the curve", C::blend};
    case S::blends_overlap: return {"blends_overlap", "Two blends run into each other", C::blend};
    case S::blend_collides: return {"blend_collides", "The blend runs into another part of the body", C::blend};

    case S::singular_boundary:
      return {"singular_boundary", "A boundary curve is not regular: it, or the surface along it, has a singular point",
              C::blend};
    case S::curves_do_not_correspond:
      return {"curves_do_not_correspond", "The points of the two boundary curves cannot be paired", C::blend};
    case S::no_boundary_curve: return {"no_boundary_curve", "There is no such boundary curve on the surface", C::blend};
    case S::surface_not_bounded:
      return {"surface_not_bounded", "The part of the surface that is kept has no end; give it a far plane", C::blend};
    case S::blend_folds: return {"blend_folds", "The blend folds over or cuts through itself", C::blend};

    case S::plane_misses_mesh: return {"plane_misses_mesh", "The plane does not cut the mesh", C::blend};
    case S::plane_meets_vertex:
      return {"plane_meets_vertex",
              "The plane runs through a vertex or along a face of the mesh, so the cut is not a clean curve; move it a "
              "little",
              C::blend};
    case S::section_not_closed:
      return {"section_not_closed", "The plane cuts the mesh where it is open, so the opening has no closed rim",
              C::blend};
    case S::opening_not_planar:
      return {"opening_not_planar", "The holes of the mesh do not lie in one plane", C::blend};
    case S::openings_overlap: return {"openings_overlap", "Openings of one side cross or touch each other", C::blend};
    case S::planes_too_steep: return {"planes_too_steep", "The angle between the two planes is too large", C::blend};
    case S::sides_interpenetrate:
      return {"sides_interpenetrate",
              "The kept parts reach into each other or beyond the planes, so there is no room for a transition",
              C::blend};
    case S::openings_not_joined:
      return {"openings_not_joined", "The transition surface does not lead from the one side to the other", C::blend};

    case S::spot_off_surface: return {"spot_off_surface", "The spot does not lie on the mesh", C::blend};
    case S::radius_exceeds_cut_locus:
      return {"radius_exceeds_cut_locus",
              "The radius is too large: shortest paths from the spot meet again on the far side of it", C::blend};
    case S::region_meets_border:
      return {"region_meets_border", "The region around the spot reaches a hole or a border of the mesh", C::blend};
    case S::curve_crosses_itself:
      return {"curve_crosses_itself", "A contact curve crosses or touches itself", C::blend};
    case S::regions_overlap: return {"regions_overlap", "The regions of the two ends overlap", C::blend};

    case S::region_not_annular:
      return {"region_not_annular",
              "The faces between the linkage curves form no ring that could be mapped; stitching mode can do without",
              C::blend};
    case S::parametrization_folds:
      return {"parametrization_folds", "The blending region cannot be mapped to a rectangle without folds", C::blend};
    case S::region_too_coarse:
      return {
          "region_too_coarse",
          "The mesh is too coarse there for its vertices to be moved onto the blend without folds; refine it, or use "
          "stitching mode",
          C::blend};

    case S::result_invalid:
      return {"result_invalid", "The result failed the final check and was withheld; this is a defect of the program",
              C::result};
  }
  return {"unknown", "Unknown status", C::result};  // a value cast from outside the enumeration
}

double number_value(const std::string& text) {
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// Six digits, never more than the value: a user who types the number back must not be refused again.
std::string number_text_rounded_down(double value) {
  std::string text = number_text(value);
  if (!(value > 0) || !std::isfinite(value)) return text;
  const double digit = std::pow(10.0, std::floor(std::log10(value)) - 5);
  for (int steps = 1; number_value(text) > value && steps < 4; ++steps) text = number_text(value - steps * digit);
  return text;
}

}  // namespace

Status_class status_class(Status status) noexcept { return wording(status).status_class; }

const char* name(Status status) noexcept { return wording(status).name; }

const char* describe(Status status) noexcept { return wording(status).sentence; }

std::string message(const Diagnosis& diagnosis) {
  std::string text = describe(diagnosis.status);
  if (!diagnosis.detail.empty()) text += ": " + diagnosis.detail;
  if (diagnosis.point) {
    const auto& p = *diagnosis.point;
    text += ", at (" + number_text(p.x()) + ", " + number_text(p.y()) + ", " + number_text(p.z()) + ")";
  }
  if (diagnosis.max_radius)
    text += "; largest radius that works there: " + number_text_rounded_down(*diagnosis.max_radius);
  for (char& c : text)
    if (c == '\n' || c == '\r') c = ' ';
  return text;
}

}  // namespace cgal_blend
