// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_CURVATURE_H
#define CGAL_BLEND_CURVATURE_H

#include <cgal_blend/internal/point_map.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Weights/utils.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace cgal_blend {

namespace internal {

/// What the faces at a vertex say about the curvature there.
class Vertex_star {
 public:
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  using Vector = CGAL::Simple_cartesian<double>::Vector_3;

  /// Adds a face by its corners in order, `v` the vertex itself; faces without area add nothing.
  void add_face(const Point& v, const Point& next, const Point& previous) {
    const Vector cross = CGAL::cross_product(next - v, previous - v);
    const double area = std::sqrt(cross.squared_length()) / 2;
    if (!(area > 0)) return;
    const double at_next = CGAL::Weights::cotangent(v, next, previous);
    const double at_previous = CGAL::Weights::cotangent(v, previous, next);
    laplacian_ += at_next * (v - previous) + at_previous * (v - next);
    normal_ += cross;
    region_ += region(v, next, previous, area, at_next, at_previous);
  }

  /// Returns the mean curvature; 0 without faces that have an area.
  [[nodiscard]] double mean_curvature() const {
    const double size = std::sqrt(laplacian_.squared_length()) / (4 * region_);
    if (!std::isfinite(size)) return 0;
    return laplacian_ * normal_ < 0 ? -size : size;
  }

 private:
  // CGAL 5.5 has `mixed_voronoi_area`, but gives half of an obtuse triangle to each of its three corners.
  static double region(const Point& v, const Point& next, const Point& previous, double area, double at_next,
                       double at_previous) {
    if (CGAL::angle(next, v, previous) == CGAL::OBTUSE) return area / 2;
    if (at_next < 0 || at_previous < 0) return area / 4;
    return (at_next * CGAL::squared_distance(v, previous) + at_previous * CGAL::squared_distance(v, next)) / 8;
  }

  Vector laplacian_{0, 0, 0}, normal_{0, 0, 0};
  double region_ = 0;
};

}  // namespace internal

/// Computes the signed discrete mean curvature (half the sum of the principal curvatures) at every vertex of a triangle
/// mesh, in 1/length units: positive where the surface bends outward, 1/R on a sphere of radius R. Large on creases,
/// where it grows as the edges get shorter. 0 at border vertices, whose neighbourhood says nothing about it, and at
/// vertices without a face that has an area.
/// \param mesh oriented outward, closed or open; points of any Cartesian kernel, rounded to double
/// \param curvature a writable property map from vertices to double; every vertex is written
/// \param np `vertex_point_map`
/// Source: Meyer, Desbrun, Schroeder, Barr, Discrete differential-geometry operators for triangulated 2-manifolds
/// (2003), equation 8 and the mixed area of section 3.3; the sign is that of the normal weighted by area.
template <class Graph, class VertexCurvatureMap, class NamedParameters = CGAL::parameters::Default_named_parameters>
void mean_curvature(const Graph& mesh, VertexCurvatureMap curvature,
                    const NamedParameters& np = CGAL::parameters::default_values()) {
  const auto points = internal::point_map(mesh, np);
  const auto point = [&](auto v) {
    const auto p = internal::to_double_point(get(points, v));
    return internal::Vertex_star::Point(p.x(), p.y(), p.z());
  };
  const auto no_halfedge = boost::graph_traits<Graph>::null_halfedge();
  for (const auto v : vertices(mesh)) {
    internal::Vertex_star star;
    if (halfedge(v, mesh) != no_halfedge && !CGAL::is_border(v, mesh))
      for (const auto h : CGAL::halfedges_around_target(v, mesh)) {
        CGAL_precondition(CGAL::is_triangle(h, mesh));
        star.add_face(point(v), point(target(next(h, mesh), mesh)), point(source(h, mesh)));
      }
    put(curvature, v, star.mean_curvature());
  }
}

/// Returns a limit for `colour_scale` that a few extreme values do not spoil: the 95th percentile of the absolute
/// values, those left out that are rounding against the largest (below 1e-9 of it). 0 if all are 0 or there are none.
[[nodiscard]] inline double robust_limit(std::vector<double> values) {
  constexpr double share = 0.95, negligible = 1e-9;
  double largest = 0;
  for (double& value : values) largest = std::max(largest, value = std::abs(value));
  const auto is_rounding = [&](double value) { return !(value > negligible * largest); };
  values.erase(std::remove_if(values.begin(), values.end(), is_rounding), values.end());
  if (values.empty()) return 0;
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(values.size()))) - 1;
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Returns the colour (red, green, blue) of a value on a scale from blue (-limit and less: concave) over white (0) to
/// red (limit and more: convex), linear in between; the ends are those of ColorBrewer's scale RdBu.
/// \param limit at least 0; with 0 everything but 0 has the colour of an end
[[nodiscard]] inline std::array<unsigned char, 3> colour_scale(double value, double limit) {
  CGAL_precondition(limit >= 0);
  constexpr std::array<double, 3> red{178, 24, 43}, blue{33, 102, 172};
  const double share = !(std::abs(value) > 0) ? 0 : std::min(1.0, std::abs(value) / limit);
  std::array<unsigned char, 3> colour{};
  for (std::size_t i = 0; i < colour.size(); ++i) {
    const double end = value > 0 ? red[i] : blue[i];
    colour[i] = static_cast<unsigned char>(std::lround(255 + share * (end - 255)));
  }
  return colour;
}

}  // namespace cgal_blend

#endif
