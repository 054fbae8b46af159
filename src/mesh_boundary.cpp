// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/mesh_boundary.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>

namespace cgal_blend {

namespace {

Vector_3 unit(const Vector_3& v) { return v / std::sqrt(v.squared_length()); }

/// The normals of the faces on the kept side of a vertex, from the edge that leaves it to the one that comes in,
/// weighted by their angles.
Vector_3 kept_normal(const Blend_mesh& mesh, Vertex before, Vertex at, Vertex after) {
  Vector_3 sum(0, 0, 0);
  Halfedge h = mesh.halfedge(at, after);
  const Halfedge last = mesh.opposite(mesh.halfedge(before, at));
  // Turning to the left about the vertex, face by face.
  for (std::size_t guard = 0; h != last && mesh.face(h) != Blend_mesh::null_face() && guard < mesh.number_of_faces();
       ++guard) {
    const Point_3 &p = mesh.point(at), &q = mesh.point(mesh.target(h)), &r = mesh.point(mesh.target(mesh.next(h)));
    const Vector_3 a = q - p, b = r - p, cross = CGAL::cross_product(a, b);
    const double length = std::sqrt(cross.squared_length());
    if (length > 0) sum = sum + std::atan2(length, a * b) / length * cross;
    h = mesh.opposite(mesh.prev(h));
  }
  return unit(sum);
}

}  // namespace

Mesh_boundary::Mesh_boundary(const Blend_mesh& mesh, const std::vector<Vertex>& chain) {
  const std::size_t n = chain.size();
  CGAL_precondition(n >= 3);
  double length = 0;
  std::vector<double> lengths;
  for (std::size_t i = 0; i < n; ++i) {
    lengths.push_back(length);
    points_.push_back(mesh.point(chain[i]));
    normals_.push_back(kept_normal(mesh, chain[(i + n - 1) % n], chain[i], chain[(i + 1) % n]));
    length += std::sqrt(CGAL::squared_distance(mesh.point(chain[i]), mesh.point(chain[(i + 1) % n])));
  }
  for (const double l : lengths) parameters_.push_back(l / length);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t before = (i + n - 1) % n, after = (i + 1) % n;
    const double a = parameters_[i] - parameters_[before] + (i == 0 ? 1 : 0);
    const double b = parameters_[after] - parameters_[i] + (after == 0 ? 1 : 0);
    const Vector_3 p = (points_[i] - points_[before]) / a, q = (points_[after] - points_[i]) / b;
    Vector_3 tangent = (b * p + a * q) / (a + b);  // of the parabola through the three
    tangent = tangent - (tangent * normals_[i]) * normals_[i];
    tangents_.push_back(tangent);
  }
}

Boundary_point Mesh_boundary::at(double s) const {
  const std::size_t n = points_.size();
  s -= std::floor(s);
  const auto next = std::upper_bound(parameters_.begin(), parameters_.end(), s);
  const std::size_t i = static_cast<std::size_t>(next - parameters_.begin()) - 1, j = (i + 1) % n;
  const double step = (j == 0 ? 1 : parameters_[j]) - parameters_[i], x = (s - parameters_[i]) / step, y = 1 - x;
  Boundary_point p;
  const Vector_3 chord = points_[j] - points_[i];
  // Hermite cubic; the vertex itself comes out bit for bit.
  p.point = points_[i] + x * x * (3 - 2 * x) * chord + step * x * y * (y * tangents_[i] - x * tangents_[j]);
  p.derivative = 6 * x * y / step * chord + y * (1 - 3 * x) * tangents_[i] + x * (3 * x - 2) * tangents_[j];
  const Vector_3 normal = y * normals_[i] + x * normals_[j];
  p.normal = unit(normal - (normal * p.derivative / p.derivative.squared_length()) * p.derivative);
  p.transversal = CGAL::cross_product(p.derivative, p.normal);
  return p;
}

std::vector<Vertex> border_chain(const Blend_mesh& mesh, Vertex on_it) {
  for (const Halfedge h : CGAL::halfedges_around_target(on_it, mesh)) {
    if (!mesh.is_border(h)) continue;
    std::vector<Vertex> chain;
    Halfedge at = h;
    do {
      chain.push_back(mesh.target(at));
      at = mesh.next(at);
    } while (at != h);
    std::reverse(chain.begin(), chain.end());  // border halfedges have the mesh on their right
    return chain;
  }
  return {};
}

}  // namespace cgal_blend
