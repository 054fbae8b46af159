// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_TRIMMED_SURFACE_H
#define CGAL_BLEND_TRIMMED_SURFACE_H

#include <cgal_blend/blend_mesh.h>
#include <cgal_blend/implicit_function.h>
#include <cgal_blend/parametric_patch.h>
#include <cgal_blend/quadric.h>
#include <cgal_blend/status.h>

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace cgal_blend {

/// Triangles that share points, with the number of the part that each belongs to.
struct Triangle_soup {
  std::vector<Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<int> parts;  ///< per triangle

  std::size_t add(const Point_3& p) {
    points.push_back(p);
    return points.size() - 1;
  }
};

/// Boundary of the kept part of a surface towards a blend, sampled: a polygon or, of an open curve, a polyline.
struct Trim_curve {
  std::vector<std::size_t> vertices;  ///< points of the soup, along the curve
  std::vector<double> parameters;     ///< of the boundary curve, per vertex, in [0, 1]
  std::vector<Vector_3> outward;      ///< per vertex: leaves the kept part, in the tangent plane
  bool closed = true;
  int slot = 0;  ///< which end of the surface it is, where that has several of its own
};

/// What else bounds a part: closed polygons of points of the soup, to be capped.
using Rims = std::vector<std::vector<std::size_t>>;

struct Tessellation_options {
  double tolerance = 0;  ///< largest distance between surface and facets, length units, > 0
  int part = 0;          ///< number that the triangles get
};

/// Surface that can tessellate the part of it that is kept, up to the given curves, exactly to their vertices. Adds its
/// triangles to the soup, in either orientation, and its other rims; says why if it cannot.
using Trimmed_surface = std::function<Diagnosis(const std::vector<Trim_curve>& curves,
                                                const Tessellation_options& options, Triangle_soup& soup, Rims& rims)>;

/// Half-space (a, b, c, d): what is kept of an unbounded surface has a x + b y + c z + d <= 0.
using Far_plane = Quadric_3::Plane;

/// Makes the kept part of a quadric between closed curves, on the one component that they lie on, cut by far planes.
/// Refuses `surface_not_bounded`, and `not_supported` for pairs of planes, and for what is no surface.
[[nodiscard]] Trimmed_surface trimmed_quadric(const Quadric_3& quadric, const std::vector<Far_plane>& far = {});

/// Makes the part of a patch between v = v0 (slot 0) and v = v1 (slot 1). A slot without a curve is a rim; one that
/// shrinks to a point is closed.
[[nodiscard]] Trimmed_surface trimmed_patch(const Parametric_patch& patch);

/// Makes the part of an implicit surface that lines of steepest ascent of a linear function sweep, from one curve, open
/// or closed, to a plane. The other ends of open curves stay open.
/// \param far the plane; (a, b, c) is not normal to the surface on the way
/// Refuses `surface_not_bounded` where the lines do not reach the plane.
[[nodiscard]] Trimmed_surface swept_surface(const Implicit_function& surface, const Far_plane& far);

/// Makes the part of a mesh on the left of closed chains of its edges, seen from outside; all of an open mesh if they
/// are its borders. Chain i is slot i, and its curve must be the `Mesh_boundary` of it. Other borders are rims.
[[nodiscard]] Trimmed_surface trimmed_mesh(const Blend_mesh& mesh, const std::vector<std::vector<Vertex>>& chains);

}  // namespace cgal_blend

#endif
