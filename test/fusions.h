// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_TEST_FUSIONS_H
#define CGAL_BLEND_TEST_FUSIONS_H

#include "shapes.h"

#include <cgal_blend/fuse.h>

#include <cmath>
#include <utility>
#include <vector>

// Sides of fusions, with planes at z = 0 (lower) and z = height (upper) but for motions.

namespace cgal_blend::test {

/// Cone frusta and cylinders about the z axis: radius r0 at z0 to r1 at z1, in `levels` steps, n sides.
inline Blend_mesh frustum(double r0, double r1, int n, double z0, double z1, int levels) {
  std::vector<std::pair<double, double>> outline{{0, z0}};
  for (int k = 0; k <= levels; ++k) {
    const double t = static_cast<double>(k) / levels;
    outline.emplace_back(r0 + t * (r1 - r0), z0 + t * (z1 - z0));
  }
  outline.emplace_back(0, z1);
  return turned(outline, n);
}

/// A pipe: between the cylinders r0 < r1, from z0 to z1.
inline Blend_mesh pipe(double r0, double r1, int n, double z0, double z1) {
  std::vector<Point_3> points;
  const std::pair<double, double> corners[] = {{r1, z0}, {r1, z1}, {r0, z1}, {r0, z0}};
  for (const auto& [r, z] : corners)
    for (int i = 0; i < n; ++i) points.emplace_back(r * std::cos(2 * pi * i / n), r * std::sin(2 * pi * i / n), z);
  std::vector<Corner_indices> triangles;
  for (std::size_t k = 0; k < 4; ++k)
    for (int i = 0; i < n; ++i) {
      const std::size_t j = (i + 1) % n, m = n, a = k * m + i, b = k * m + j, c = (k + 1) % 4 * m + j,
                        d = (k + 1) % 4 * m + i;
      triangles.push_back({a, b, c});
      triangles.push_back({a, c, d});
    }
  return mesh_of(points, triangles);
}

/// Copies of a mesh on a circle about the z axis, the first one at `angle`; one copy: in the middle.
inline std::vector<Blend_mesh> on_circle(const Blend_mesh& mesh, int count, double radius, double angle) {
  std::vector<Blend_mesh> all;
  for (int k = 0; k < count; ++k) {
    const double a = angle + 2 * pi * k / count, r = count == 1 ? 0 : radius;
    all.push_back(transformed(mesh, moved_by(r * std::cos(a), r * std::sin(a), 0)));
  }
  return all;
}

inline Fusion_side side_of_meshes(const std::vector<Blend_mesh>& meshes, const Cut_plane& plane) {
  Fusion_side side;
  for (const Blend_mesh& mesh : meshes) side.meshes.push_back(&mesh);
  side.plane = plane;
  return side;
}

inline const Cut_plane lower_plane{{0, 0, 0}, {0, 0, 1}};
inline Cut_plane upper_plane(double height) { return {{0, 0, height}, {0, 0, -1}}; }

}  // namespace cgal_blend::test

#endif
