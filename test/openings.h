// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_TEST_OPENINGS_H
#define CGAL_BLEND_TEST_OPENINGS_H

#include "hermite_transition.h"
#include "shapes.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

// Rings, and the sections of cones that stand on them.

namespace cgal_blend::test {

struct Circle {
  double radius, x = 0, y = 0;
  int vertices = 64;
  double slope = 0;  ///< change of the radius with z
};

inline Ring ring_of(const Circle& c, double dz = 0) {
  Ring ring;
  for (int i = 0; i < c.vertices; ++i) {
    const double a = 2 * pi * i / c.vertices, r = c.radius + c.slope * dz;
    ring.emplace_back(c.x + r * std::cos(a), c.y + r * std::sin(a));
  }
  return ring;
}

/// r = radius * (1 + amplitude * cos(k a)).
inline Ring wavy_ring(double radius, double amplitude, int k, int vertices) {
  Ring ring;
  for (int i = 0; i < vertices; ++i) {
    const double a = 2 * pi * i / vertices, r = radius * (1 + amplitude * std::cos(k * a));
    ring.emplace_back(r * std::cos(a), r * std::sin(a));
  }
  return ring;
}

inline std::vector<Ring> rings_of(const std::vector<Circle>& circles, double dz = 0) {
  std::vector<Ring> rings;
  for (const Circle& c : circles) rings.push_back(ring_of(c, dz));
  return rings;
}

/// Exact sections of cones through the circles.
inline Opening_sections sections_of(const std::vector<Circle>& circles, double step = 0.02) {
  return {rings_of(circles), rings_of(circles, -step), rings_of(circles, step), step};
}

/// Walls that stand upright on the rings.
inline Opening_sections upright(const std::vector<Ring>& rings, double step = 0.02) {
  return {rings, rings, rings, step};
}

template <class Map>
Opening_sections mapped(Opening_sections sections, const Map& map) {
  for (std::vector<Ring>* rings : {&sections.rings, &*sections.below, &*sections.above})
    for (Ring& ring : *rings)
      for (Point_2& p : ring) p = map(p);
  return sections;
}

/// The Hermite basis, written out by powers.
inline std::array<double, 4> hermite_basis(double w) {
  const double w2 = w * w, w3 = w2 * w;
  return {2 * w3 - 3 * w2 + 1, 3 * w2 - 2 * w3, w3 - 2 * w2 + w, w3 - w2};
}

/// Radius of the transition between coaxial cones, with signed distances.
inline double hermite_radius(const Circle& low, const Circle& high, double height, double w) {
  const auto f = hermite_basis(w);
  return low.radius * f[0] + high.radius * f[1] + height * (low.slope * f[2] + high.slope * f[3]);
}

}  // namespace cgal_blend::test

#endif
