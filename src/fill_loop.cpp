// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill_loop.h"

#include "marked_triangulation.h"

#include <CGAL/Projection_traits_3.h>

namespace cgal_blend {

namespace {

/// \tparam Traits the plane, with the points as they are given
template <class Traits>
class Polygon_triangulation {
 public:
  using Point = typename Traits::Point_2;

  explicit Polygon_triangulation(const Traits& traits) : triangulation_(traits) {}

  [[nodiscard]] std::optional<std::vector<Index_triangle>> operator()(const std::vector<Point>& polygon,
                                                                      const std::vector<Point>& inner) {
    if (!insert(polygon) || triangulation_.dimension() < 2 || !constrain(polygon.size())) return std::nullopt;
    // Inner points come last, when a walk to them starts in a triangulation that is already there.
    if (!insert(inner) || !mark_inside(polygon.size())) return std::nullopt;
    std::vector<Index_triangle> triangles;
    for (const auto face : triangulation_.finite_face_handles())
      if (face->info())
        triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    // Euler's formula: fewer if a point is outside.
    if (triangles.size() + 2 != polygon.size() + 2 * inner.size()) return std::nullopt;
    return triangles;
  }

 private:
  using Triangulation = Marked_triangulation<std::size_t, Traits>;
  using Handle = typename Triangulation::Vertex_handle;
  using Face_handle = typename Triangulation::Face_handle;

  /// False if two points fall together.
  bool insert(const std::vector<Point>& points) {
    for (const Point& p : points) {
      const Handle v = triangulation_.insert(p, handles_.empty() ? Face_handle() : handles_.back()->face());
      if (triangulation_.number_of_vertices() == handles_.size()) return false;
      v->info() = handles_.size();
      handles_.push_back(v);
    }
    return true;
  }

  /// False if two steps cross. One through a point is split there silently, which `mark_inside` finds.
  bool constrain(std::size_t size) {
    try {
      for (std::size_t i = 0; i < size; ++i) triangulation_.insert_constraint(handles_[i], handles_[(i + 1) % size]);
    } catch (const typename Triangulation::Intersection_of_constraints_exception&) {
      return false;
    }
    return true;
  }

  /// Marks what can be reached from the left of the steps; false if this is not bounded.
  bool mark_inside(std::size_t size) {
    for (const auto face : triangulation_.all_face_handles()) face->info() = false;
    std::vector<Face_handle> stack;
    const auto mark = [&](Face_handle face) {
      if (face->info()) return;
      face->info() = true;
      stack.push_back(face);
    };
    for (std::size_t i = 0; i < size; ++i) {
      const Handle a = handles_[i], b = handles_[(i + 1) % size];
      Face_handle face;
      int index = 0;
      if (!triangulation_.is_edge(a, b, face, index)) return false;
      // The face with the edge directed from a to b lies to its left.
      mark(face->vertex(Triangulation::ccw(index)) == a ? face : face->neighbor(index));
    }
    while (!stack.empty()) {
      const Face_handle face = stack.back();
      stack.pop_back();
      if (triangulation_.is_infinite(face)) return false;
      for (int i = 0; i < 3; ++i)
        if (!face->is_constrained(i)) mark(face->neighbor(i));
    }
    return true;
  }

  Triangulation triangulation_;
  std::vector<Handle> handles_;
};

}  // namespace

std::optional<std::vector<Index_triangle>> triangulate_inside(const std::vector<Kernel::Point_2>& polygon,
                                                              const std::vector<Kernel::Point_2>& inner) {
  return Polygon_triangulation<Kernel>(Kernel())(polygon, inner);
}

std::optional<std::vector<Triangle>> fill_loop(const Blend_mesh& mesh, const Vec& normal,
                                               const std::vector<Vertex>& loop) {
  if (!(normal.squaredNorm() > 0)) return std::nullopt;
  std::vector<Point_3> corners;
  for (const Vertex v : loop) corners.push_back(mesh.point(v));
  // The predicates take the corners as they are: what is in line in space is in line in the projection, too, and
  // Delaunay spans no triangle over it.
  const CGAL::Projection_traits_3<Kernel> traits(Vector_3(normal.x(), normal.y(), normal.z()));
  const auto indices = Polygon_triangulation<CGAL::Projection_traits_3<Kernel>>(traits)(corners, {});
  if (!indices) return std::nullopt;
  std::vector<Triangle> triangles;
  for (const auto& [a, b, c] : *indices) triangles.push_back({loop[a], loop[b], loop[c]});
  return triangles;
}

}  // namespace cgal_blend
