// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_CREASES_H
#define CGAL_BLEND_CREASES_H

#include <cgal_blend/internal/point_map.h>

#include <CGAL/Cartesian_converter.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>

#include <cmath>
#include <cstddef>
#include <type_traits>

namespace cgal_blend {

namespace internal {

/// The two triangles at an edge, as points of a kernel whose predicates are exact: edge a to b, `left` the apex of the
/// halfedge's own face, `right` that of the other.
template <class Kernel>
struct Wedge {
  typename Kernel::Point_3 a, b, left, right;

  [[nodiscard]] bool degenerate() const { return CGAL::collinear(a, b, left) || CGAL::collinear(a, b, right); }
};

/// Floating-point kernels are lifted to CGAL's filtered one; kernels over exact numbers are used as they are.
template <class Kernel>
using Exact_predicate_kernel = std::conditional_t<std::is_floating_point_v<typename Kernel::FT>,
                                                  CGAL::Exact_predicates_inexact_constructions_kernel, Kernel>;

template <class Graph, class Halfedge, class Point_map>
auto wedge_at(Halfedge h, const Graph& mesh, Point_map points) {
  using From = typename CGAL::Kernel_traits<typename boost::property_traits<Point_map>::value_type>::Kernel;
  using To = Exact_predicate_kernel<From>;
  CGAL_precondition(CGAL::is_triangle(h, mesh) && CGAL::is_triangle(opposite(h, mesh), mesh));
  const CGAL::Cartesian_converter<From, To> lift;
  return Wedge<To>{lift(get(points, source(h, mesh))), lift(get(points, target(h, mesh))),
                   lift(get(points, target(next(h, mesh), mesh))),
                   lift(get(points, target(next(opposite(h, mesh), mesh), mesh)))};
}

/// Cosine of an angle in degrees; 90 gives exactly 0, so that the right angles of a box compare as equal to it.
inline double cosine_of_degrees(double angle) { return std::sin((90 - angle) * (CGAL_PI / 180)); }

}  // namespace internal

/// Returns on which side an edge of a triangle mesh bends, by exact predicates: `POSITIVE` convex, `NEGATIVE` concave,
/// `ZERO` if its two faces are coplanar. The mesh is oriented outward; the edge is no border edge.
template <class Graph, class NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] CGAL::Sign edge_convexity(typename boost::graph_traits<Graph>::edge_descriptor e, const Graph& mesh,
                                        const NamedParameters& np = CGAL::parameters::default_values()) {
  const auto wedge = internal::wedge_at(halfedge(e, mesh), mesh, internal::point_map(mesh, np));
  return CGAL::opposite(CGAL::orientation(wedge.a, wedge.b, wedge.left, wedge.right));
}

/// Returns true if the edge bends outward; false for concave edges and between coplanar faces.
template <class Graph, class NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] bool is_convex_edge(typename boost::graph_traits<Graph>::edge_descriptor e, const Graph& mesh,
                                  const NamedParameters& np = CGAL::parameters::default_values()) {
  return edge_convexity(e, mesh, np) == CGAL::POSITIVE;
}

/// Returns true if the normals of the two faces at an edge differ by more than `angle` degrees, in (0, 180).
/// Decided by exact arithmetic on the given points and the double nearest to the angle's cosine. False for border edges
/// and beside faces of zero area, which have no normal.
template <class Graph, class NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] bool is_crease(typename boost::graph_traits<Graph>::edge_descriptor e, const Graph& mesh, double angle,
                             const NamedParameters& np = CGAL::parameters::default_values()) {
  if (CGAL::is_border(e, mesh)) return false;
  const auto w = internal::wedge_at(halfedge(e, mesh), mesh, internal::point_map(mesh, np));
  if (w.degenerate()) return false;
  // The angle between the faces themselves is 180 degrees less that between their normals.
  const double cosine = -internal::cosine_of_degrees(angle);
  return CGAL::compare_dihedral_angle(w.a, w.b, w.left, w.right, cosine) == CGAL::SMALLER;
}

/// Marks the creases of a closed or open triangle mesh and returns their number.
/// \param angle least deviation of the face normals, exclusive, degrees in (0, 180)
/// \param edge_is_crease a writable property map from edges to bool; every edge is written
/// \param np `vertex_point_map`
template <class Graph, class EdgeIsCreaseMap, class NamedParameters = CGAL::parameters::Default_named_parameters>
std::size_t detect_creases(const Graph& mesh, double angle, EdgeIsCreaseMap edge_is_crease,
                           const NamedParameters& np = CGAL::parameters::default_values()) {
  CGAL_precondition(angle > 0 && angle < 180);
  std::size_t count = 0;
  for (auto e : edges(mesh)) {
    const bool crease = is_crease(e, mesh, angle, np);
    put(edge_is_crease, e, crease);
    if (crease) ++count;
  }
  return count;
}

}  // namespace cgal_blend

#endif
