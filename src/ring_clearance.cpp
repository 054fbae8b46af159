// SPDX-License-Identifier: GPL-3.0-or-later
#include "ring_clearance.h"

#include <CGAL/Polygon_2_algorithms.h>

namespace cgal_blend {

namespace {

constexpr int most_halvings = 20;
// Of twice the distance of the nearer place; and at the least, to which sharp corners bring it down.
constexpr double clearance = 0.8, least_distance = 0.2;

}  // namespace

double Ring_clearance::operator()(const Point_2& p, const Kernel::Vector_2& direction, bool inside,
                                  double reach) const {
  double d = reach;
  for (int i = 0; i < most_halvings && !clear(p, direction, inside, d); ++i) d /= 2;
  return d;
}

bool Ring_clearance::clear(const Point_2& p, const Kernel::Vector_2& direction, bool inside, double d) const {
  const Point_2 near = p + d * direction, far = p + 2 * d * direction;
  if (inside_(near) != inside || inside_(far) != inside) return false;
  const double at_near = distance_(near);
  return at_near >= least_distance * d && distance_(far) >= clearance * 2 * at_near;
}

bool interior_on_left(const std::vector<Ring>& rings, std::size_t ring) {
  std::vector<Ring> others = rings;
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(ring));
  const bool hole = Even_odd_test(others)(rings[ring].front());
  return (CGAL::orientation_2(rings[ring].begin(), rings[ring].end(), Kernel()) == CGAL::COUNTERCLOCKWISE) != hole;
}

}  // namespace cgal_blend
