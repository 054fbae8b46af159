// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_GEODESIC_POLAR_H
#define CGAL_BLEND_GEODESIC_POLAR_H

#include <cgal_blend/blend_mesh.h>
#include <cgal_blend/polar_curve.h>
#include <cgal_blend/status.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace cgal_blend {

/// A point of a mesh: a face, and barycentric weights of the targets of its halfedges h, next(h), next(next(h)) where
/// h = halfedge(face); not negative, their sum is 1.
struct Face_point {
  Face face;
  std::array<double, 3> weights{1.0 / 3, 1.0 / 3, 1.0 / 3};
};

/// Returns the place of a point of a mesh.
[[nodiscard]] Point_3 position(const Blend_mesh& mesh, const Face_point& at);

struct Geodesic_polar_options {
  std::optional<Vector_3>
      zero_direction;  ///< angle 0 points along it as seen in the tangent plane of the source; none:
                       ///< along an edge there
  bool fill_holes =
      false;  ///< holes in the region are filled for the coordinates (CGAL's hole filling); false: refused
};

/// Geodesic polar coordinates around a source on a mesh, out to a distance; angles run counter-clockwise seen from
/// outside. The source is a point, or a closed curve on the mesh: then the coordinates are the distance from it to its left
/// side, and the arc-length fraction along it times 2 pi. Vertices have their coordinates; triangles lie straight between
/// them, around a point in the plane of (d cos a, d sin a), along a curve over (a, d). Long edges near the source are
/// divided for it. Planes are exact, developable surfaces too where geodesics run straight; elsewhere distances converge with
/// the first order of the edges. Where single triangles would be turned over, vertices are moved to the mean of
/// their neighbours.
/// Source: Shin et al., Parametric blending of triangular meshes, Symmetry 10 (2018), section 3.1; Melvaer and Reimers,
/// Geodesic polar coordinates on polygonal meshes (2012).
class Geodesic_polar {
 public:
  /// \param mesh 2-manifold, lives as long as the coordinates; borders are allowed outside the region
  /// \param radius length units, > 0
  Geodesic_polar(const Blend_mesh& mesh, const Face_point& source, double radius,
                 const Geodesic_polar_options& options = {});
  /// \param source a closed curve that does not meet itself, s = 0 at its first point; each step within one face or between
  /// faces that share an edge or a vertex. It may run along edges and have steps of almost no length.
  Geodesic_polar(const Blend_mesh& mesh, const std::vector<Face_point>& source, double radius,
                 const Geodesic_polar_options& options = {});

  /// `ok`, `radius_exceeds_cut_locus` or `region_meets_border` (with a radius that works, if one was found),
  /// `curve_crosses_itself`, `invalid_parameter`; if not ok only the next five work.
  [[nodiscard]] const Diagnosis& diagnosis() const;
  [[nodiscard]] bool covers(Vertex v) const;
  /// Coordinates of a vertex that is covered.
  [[nodiscard]] Polar_point operator()(Vertex v) const;
  /// Largest radius known to be free of overlaps, at most the one asked for; 0: none.
  [[nodiscard]] double safe_radius() const;

  [[nodiscard]] double radius() const;
  [[nodiscard]] const Blend_mesh& mesh() const;
  /// The point of the mesh with given coordinates, distance at most the radius; none if it is in a filled hole.
  [[nodiscard]] std::optional<Face_point> locate(const Polar_point& at) const;
  /// Its place, also within filled holes.
  [[nodiscard]] Point_3 point(const Polar_point& at) const;
  /// Coordinates of a point of the mesh; none if its face is not covered.
  [[nodiscard]] std::optional<Polar_point> coordinates(const Face_point& at) const;

 private:
  struct Impl;
  std::shared_ptr<const Impl> impl_;
};

}  // namespace cgal_blend

#endif
