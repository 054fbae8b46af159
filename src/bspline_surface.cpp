// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/bspline_surface.h>

#include <algorithm>

namespace cgal_blend {

namespace {

/// The value of a Bezier curve, by de Casteljau.
Point_3 bezier(std::vector<Point_3> p, double t) {
  for (std::size_t level = p.size() - 1; level > 0; --level)
    for (std::size_t i = 0; i < level; ++i) p[i] = p[i] + t * (p[i + 1] - p[i]);
  return p[0];
}

/// Inner knots twice, the ends four times.
std::vector<double> knot_vector(const std::vector<double>& knots) {
  std::vector<double> all(4, knots.front());
  for (std::size_t i = 1; i + 1 < knots.size(); ++i) all.insert(all.end(), 2, knots[i]);
  all.insert(all.end(), 4, knots.back());
  return all;
}

}  // namespace

Point_3 Bspline_surface::at(double s, double t) const {
  const std::vector<double> u = knot_vector(knots);
  const auto above = std::upper_bound(u.begin() + 4, u.end() - 4, s);
  const std::size_t span = static_cast<std::size_t>(above - u.begin()) - 1;
  std::vector<Point_3> d;
  for (std::size_t i = span - 3; i <= span; ++i) d.push_back(bezier(control[i], t));
  for (std::size_t level = 1; level <= 3; ++level)  // de Boor
    for (std::size_t j = 3; j >= level; --j) {
      const double low = u[span - 3 + j], high = u[span + 1 + j - level];
      d[j] = d[j - 1] + (s - low) / (high - low) * (d[j] - d[j - 1]);
    }
  return d[3];
}

}  // namespace cgal_blend
