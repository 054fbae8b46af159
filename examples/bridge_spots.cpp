// SPDX-License-Identifier: GPL-3.0-or-later
// Joins spots of two meshes by smooth tubes: bridge_spots A B OUT; without arguments, two spheres are joined.
// The shape is changed by dragging a point of the surface before the mesh is made.
#include <cgal_blend/bridge.h>
#include <cgal_blend/mesh_io.h>

#include <cmath>
#include <iostream>

namespace {

using namespace cgal_blend;

/// Sphere of 2 n^2 faces about a point.
Blend_mesh sphere(double radius, const Point_3& centre, int n) {
  Blend_mesh mesh;
  const auto at = [&](int i, int j) {
    const double u = CGAL_PI * i / n, v = 2 * CGAL_PI * j / n;
    return centre + radius * Vector_3(std::sin(u) * std::cos(v), std::sin(u) * std::sin(v), std::cos(u));
  };
  const Vertex top = mesh.add_vertex(at(0, 0)), bottom = mesh.add_vertex(at(n, 0));
  std::vector<Vertex> rings;
  for (int i = 1; i < n; ++i)
    for (int j = 0; j < n; ++j) rings.push_back(mesh.add_vertex(at(i, j)));
  const auto ring = [&](int i, int j) { return rings[static_cast<std::size_t>((i - 1) * n + j % n)]; };
  for (int j = 0; j < n; ++j) {
    mesh.add_face(top, ring(1, j), ring(1, j + 1));
    mesh.add_face(bottom, ring(n - 1, j + 1), ring(n - 1, j));
    for (int i = 1; i + 1 < n; ++i) {
      mesh.add_face(ring(i, j), ring(i + 1, j), ring(i + 1, j + 1));
      mesh.add_face(ring(i, j), ring(i + 1, j + 1), ring(i, j + 1));
    }
  }
  return mesh;
}

}  // namespace

int main(int argc, char** argv) {
  const Blend_mesh a = argc > 3 ? read_mesh(argv[1]) : sphere(1, {0, 0, 0}, 64);
  const Blend_mesh b = argc > 3 ? read_mesh(argv[2]) : sphere(0.7, {2.5, 0, 0.4}, 64);
  const Blend_mesh bodies = unchecked::put_together({&a, &b});

  std::array<Bridge_end, 2> ends;
  ends[0].spot = {1, 0, 0};
  ends[0].curve = star_curve(0.5, 0.2, 5);
  ends[1].spot = {1.8, 0, 0.4};
  ends[1].radius = 0.4;

  Bridge_solver solver(bodies, ends);
  if (!solver.diagnosis().ok()) {
    std::cerr << message(solver.diagnosis()) << "\n";
    return 1;
  }
  const Point_3 middle = solver.point(0.25, 0.5);
  const Drag drag = solver.drag(0.25, 0.5, middle + 0.1 * (middle - Point_3(1.4, 0, 0.2)));
  std::cout << "lambdas " << drag.lambda[0] << ", " << drag.lambda[1] << ", off by " << drag.residual << "\n";

  Blend_mesh result;
  const Bridge_outcome outcome = solver.build(result);
  std::cout << message(outcome.diagnosis) << ": " << result.number_of_faces() << " faces, " << outcome.kept_faces
            << " of them as they were\n";
  if (outcome.ok()) write_mesh(argc > 3 ? argv[3] : "bridge_spots.off", result);
  return outcome.ok() ? 0 : 1;
}
