// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SURFACE_BLEND_BODY_H
#define CGAL_BLEND_SURFACE_BLEND_BODY_H

#include <cgal_blend/surface_blend.h>
#include <cgal_blend/trimmed_surface.h>
#include <cgal_blend/validate.h>

#include <array>
#include <cstddef>
#include <vector>

namespace cgal_blend {

/// A blend and the surfaces that it joins.
struct Body_blend {
  Surface_blend blend;
  std::array<std::size_t, 2> surfaces{0, 1};  ///< indices of the surfaces of its two sides
  std::array<int, 2> slots{0, 0};             ///< which end of these surfaces, see `trimmed_patch` and `trimmed_mesh`
};

struct Blend_body_options {
  double chord_tolerance = 1e-3;  ///< largest distance between surfaces and facets, of the bounding box diagonal of the
                                  ///< boundary curves; in [1e-6, 0.1]
  bool capped = true;             ///< close planar rims; false: leave them open
  double thickness = 0;           ///< > 0: an open sheet becomes a plate of this thickness, length units
};

/// What a face of a blended body is a part of.
struct Face_label {
  enum class Kind { surface, blend, cap } kind = Kind::surface;
  std::size_t index = 0;  ///< of the surface or blend; caps and the sides of plates have 0
};

/// Returns "surface", "blend" or "cap".
[[nodiscard]] const char* name(Face_label::Kind kind) noexcept;

/// Kept parts of surfaces with the blends between them, as one mesh.
struct Blend_body {
  Diagnosis diagnosis;  ///< `ok`, or why there is no mesh
  Blend_mesh mesh;
  std::vector<Face_label> labels;  ///< per face
  bool closed = false;
  Validity_report validity;  ///< of `validate` if closed

  [[nodiscard]] bool ok() const noexcept { return diagnosis.ok(); }
};

/// Tessellates blends with the kept parts of their surfaces: watertight along the boundary curves, oriented alike, outward
/// if closed; checked before it is handed out. Closed bodies meet all that `validate` asks; open ones are manifold,
/// oriented and do not cut through themselves.
/// Refuses what the surfaces refuse, and `blend_collides` if parts of the body cut each other.
[[nodiscard]] Blend_body make_blend_body(const std::vector<Trimmed_surface>& surfaces,
                                         const std::vector<Body_blend>& blends, const Blend_body_options& options = {});

}  // namespace cgal_blend

#endif
