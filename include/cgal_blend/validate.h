// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_VALIDATE_H
#define CGAL_BLEND_VALIDATE_H

#include <cgal_blend/blend_mesh.h>
#include <cgal_blend/status.h>

#include <array>
#include <cstddef>
#include <vector>

namespace cgal_blend {

/// A defect of one or two faces that leaves the surface closed, 2-manifold and oriented.
struct Flaw {
  Status status = Status::ok;   ///< `input_degenerate` or `input_self_intersecting`
  std::array<Face, 2> faces{};  ///< those that meet; or twice the one without area or with an edge of almost no length
};

/// What `validate` says of a mesh whose only defects are flaws.
enum class Flaw_policy {
  refuse,  ///< it breaks a promise
  accept   ///< it is acceptable; the flaws are counted and listed all the same
};

/// Everything the library promises of a mesh that it writes, measured.
struct Validity_report {
  Diagnosis diagnosis;  ///< the first promise broken, with its place; `ok` if none
  std::size_t vertices = 0;
  std::size_t faces = 0;
  std::size_t components = 0;  ///< pieces connected by edges
  bool finite = false;
  bool closed = false;                 ///< every edge has two faces
  bool manifold = false;               ///< no edge with more faces, no vertex where separate fans of faces meet
  bool outward = false;                ///< outer components outward, cavities inward, by nesting; false if not checked
  std::size_t degenerate_faces = 0;    ///< exactly collinear corners
  std::size_t short_edges = 0;         ///< below `shortest_edge_fraction` of the bounding box diagonal
  std::size_t self_intersections = 0;  ///< pairs of faces, by exact predicates
  std::vector<Flaw> flaws;             ///< faces of the three counts above; degenerate ones first, both by face index
  bool intersections_checked = false;  ///< false: a defect found earlier made the test pointless
  double volume = 0;                   ///< cubic length units; 0 unless closed
  double area = 0;                     ///< square length units

  [[nodiscard]] bool ok() const noexcept { return diagnosis.ok(); }
};

/// Edges shorter than this fraction of the bounding box diagonal count as degenerate.
inline constexpr double shortest_edge_fraction = 1e-12;

/// Checks a whole mesh: finite, closed, 2-manifold, oriented outward, free of degenerate faces and of
/// self-intersections (exact predicates). Vertices without faces are ignored. Never throws for bad data.
/// Checks run from cheap to dear; the diagnosis names the first promise broken, and there the element of least index.
/// \param policy what the diagnosis says of flaws. If they are accepted, pieces that cross each other count as side by
///        side, none inside the other, and each is oriented outward if it encloses a positive volume in sum.
[[nodiscard]] Validity_report validate(const Blend_mesh& mesh, Flaw_policy policy = Flaw_policy::refuse);

/// Checks a mesh of which only `changed` faces are new, the rest being as valid as it was before: the changed faces
/// among themselves and against all that their bounding boxes meet, and everything at their vertices.
/// Flaws of the rest are left alone. Counts of defects cover these faces only; components, volume and area the whole mesh.
/// Costs a few linear sweeps over the faces, and the exact tests near the changed ones.
[[nodiscard]] Validity_report validate_changes(const Blend_mesh& mesh, const std::vector<Face>& changed);

}  // namespace cgal_blend

#endif
