// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_TEST_BRIDGE_SPHERES_H
#define CGAL_BLEND_TEST_BRIDGE_SPHERES_H

#include "shapes.h"

#include <cgal_blend/bridge.h>

#include <array>
#include <cmath>

// Two spheres on the z axis whose bridge is known in closed form, and what the tests of bridges share.

namespace cgal_blend::test {

/// Spheres about (0, 0, 0) and (0, 0, gap between centres), with contact circles around the points that face each other.
struct Two_spheres {
  double first = 1, second = 0.8, between = 2.6;  // radii, distance of the centres
  std::array<double, 2> contact{0.6, 0.5};        // along the surfaces

  [[nodiscard]] Blend_mesh mesh(int level) const {
    // Turned, so that spots and contacts lie anywhere on the faces.
    const Blend_mesh a = transformed(sphere(first, level), placement({1, 2, 3}, 0.7));
    const Blend_mesh b = transformed(sphere(second, level), placement({2, -1, 1}, 1.1, {0, 0, between}));
    return side_by_side(a, b);
  }

  [[nodiscard]] std::array<Bridge_end, 2> ends() const {
    std::array<Bridge_end, 2> result;
    result[0].spot = {0, 0, first};
    result[1].spot = {0, 0, between - second};
    for (std::size_t k : {0, 1}) result[k].radius = contact[k];
    return result;
  }

  /// Distance from the axis, and z: the base surfaces are arcs of great circles by arc length.
  [[nodiscard]] std::array<double, 2> base(int side, double distance) const {
    const double r = side == 0 ? first : second, angle = distance / r;
    return {r * std::sin(angle), side == 0 ? r * std::cos(angle) : between - r * std::cos(angle)};
  }

  /// The blend, a surface of revolution: f S_1 + (1 - f) S_2.
  [[nodiscard]] std::array<double, 2> blend(double t, double mu, int order, double lambda_1, double lambda_2) const {
    const double a = mu * std::pow(1 - t, order + 1), b = (1 - mu) * std::pow(t, order + 1), f = a / (a + b);
    const auto p = base(0, contact[0] * (1 - t * (1 - lambda_1))),
               q = base(1, contact[1] * (1 - (1 - t) * (1 - lambda_2)));
    return {f * p[0] + (1 - f) * q[0], f * p[1] + (1 - f) * q[1]};
  }
};

/// V - E + F.
inline long euler(const Blend_mesh& mesh) {
  return static_cast<long>(mesh.number_of_vertices()) - static_cast<long>(mesh.number_of_edges()) +
         static_cast<long>(mesh.number_of_faces());
}

/// An end with a circle.
inline Bridge_end end_at(const Point_3& spot, double radius) {
  Bridge_end end;
  end.spot = spot;
  end.radius = radius;
  return end;
}

}  // namespace cgal_blend::test

#endif
