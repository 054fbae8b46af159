// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_IMPLICIT_PROJECTION_H
#define CGAL_BLEND_SRC_IMPLICIT_PROJECTION_H

#include <cgal_blend/blend_mesh.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace cgal_blend {

/// Largest value left after a projection, as a part of the length searched.
inline constexpr double projection_tolerance = 1e-7;

/// The zero of a function on the line p + t * direction, |t| <= reach, nearest to p as far as secants find it; nothing if
/// none is met. Once the sign has changed the zero is kept between the two points (Illinois), so that kinks do no harm.
/// \param direction unit; the function is expected to grow along it by about one per length
template <class Function>
[[nodiscard]] std::optional<Point_3> project_along(const Function& f, const Point_3& p, const Vector_3& direction,
                                                   double reach) {
  const double tolerance = projection_tolerance * reach;
  double a = 0, fa = f(p);
  if (std::abs(fa) <= tolerance) return p;
  double b = std::clamp(-fa, -reach / 2, reach / 2), fb = f(p + b * direction);
  for (int i = 0; i < 30 && std::abs(fb) > tolerance; ++i) {
    const bool bracketed = (fa < 0) != (fb < 0);
    double t = fa == fb ? 2 * b - a : (a * fb - b * fa) / (fb - fa);
    if (bracketed && (i > 8 || !(t > std::min(a, b) && t < std::max(a, b)))) t = (a + b) / 2;
    if (!bracketed) t = std::clamp(t, b - reach / 2, b + reach / 2);
    if (std::abs(t) > reach) return std::nullopt;
    const double ft = f(p + t * direction);
    if ((ft < 0) != (fb < 0)) {
      a = std::exchange(b, t);
      fa = std::exchange(fb, ft);
    } else {
      if (bracketed)
        fa /= 2;
      else
        a = b, fa = fb;
      b = t;
      fb = ft;
    }
  }
  if (std::abs(fb) > tolerance) return std::nullopt;
  return p + b * direction;
}

/// Gradient by central differences of half-width `step`, one-sided in z where the slab 0 .. `height` ends.
template <class Function>
[[nodiscard]] Vector_3 gradient(const Function& f, const Point_3& p, double step, double zmin, double zmax) {
  const double low = std::max(zmin, p.z() - step), high = std::min(zmax, p.z() + step);
  return {(f(Point_3(p.x() + step, p.y(), p.z())) - f(Point_3(p.x() - step, p.y(), p.z()))) / (2 * step),
          (f(Point_3(p.x(), p.y() + step, p.z())) - f(Point_3(p.x(), p.y() - step, p.z()))) / (2 * step),
          (f(Point_3(p.x(), p.y(), high)) - f(Point_3(p.x(), p.y(), low))) / (high - low)};
}

}  // namespace cgal_blend

#endif
