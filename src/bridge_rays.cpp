// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge_rays.h"

#include <algorithm>
#include <cmath>

namespace cgal_blend {

namespace {

constexpr std::size_t fewest_steps = 8, most_steps = 128;  // of a ray

/// Second derivatives of the not-a-knot cubic spline at knots of distance 1. With M_0 = 2 M_1 - M_2, and likewise at the
/// end, the rows next to the ends read 6 M_1 = 6 (y_0 - 2 y_1 + y_2), and the rest is tridiagonal.
std::vector<Vec> second_derivatives(const std::vector<Vec>& y) {
  const std::size_t n = y.size() - 1;
  std::vector<Vec> m(n + 1, Vec::Zero());
  const auto difference = [&](std::size_t i) -> Vec { return y[i - 1] - 2 * y[i] + y[i + 1]; };
  m[1] = difference(1);
  m[n - 1] = difference(n - 1);
  std::vector<double> factor(n + 1, 0);
  for (std::size_t i = 2; i + 1 < n; ++i) {  // forward elimination of M_{i-1} + 4 M_i + M_{i+1} = 6 d_i
    const double lower = 1 / (4 - factor[i - 1]);
    factor[i] = lower;
    m[i] = (6 * difference(i) - m[i - 1]) * lower;
  }
  for (std::size_t i = n - 2; i >= 2; --i) m[i] -= factor[i] * m[i + 1];
  m[0] = 2 * m[1] - m[2];
  m[n] = 2 * m[n - 1] - m[n - 2];
  return m;
}

}  // namespace

Bridge_ray::Bridge_ray(const std::vector<Vec>& knots) {
  const std::vector<Vec> m = second_derivatives(knots);
  for (std::size_t i = 0; i + 1 < knots.size(); ++i)
    pieces_.push_back({knots[i], knots[i + 1] - knots[i] - (2 * m[i] + m[i + 1]) / 6, m[i] / 2, (m[i + 1] - m[i]) / 6});
}

const Bridge_ray::Piece& Bridge_ray::piece(double x, double& u) const {
  const double at = x * static_cast<double>(pieces_.size());
  const auto i = std::min(static_cast<std::size_t>(std::max(at, 0.0)), pieces_.size() - 1);
  u = at - static_cast<double>(i);
  return pieces_[i];
}

Vec Bridge_ray::point(double x) const {
  double u = 0;
  const Piece& p = piece(x, u);
  return p.a + u * (p.b + u * (p.c + u * p.d));
}

Vec Bridge_ray::derivative(double x) const {
  double u = 0;
  const Piece& p = piece(x, u);
  return (p.b + u * (2 * p.c + 3 * u * p.d)) * static_cast<double>(pieces_.size());
}

Vec Ray_lifter::lifted(const Surface_point& at) const {
  const Base_surface::Frame& f = surface_.frame(at.face);
  const Vec p = surface_.position(at);
  // Half of what Phong tessellation adds: a quadratic with the surface's second fundamental form, where the normals
  // are those of the surface. The factor 3/4 of Boubekeur and Alexa (2008) is one for looks.
  Vec add = Vec::Zero();
  for (int i = 0; i < 3; ++i) add -= at.bary[i] * (p - f.corner[i]).dot(f.normal[i]) * f.normal[i];
  return p + add / 2;
}

std::optional<Vec> Ray_lifter::lifted(const Polar_point& at) const {
  if (const auto place = polar_.locate(at))
    return lifted({place->face, Eigen::Vector3d(place->weights[0], place->weights[1], place->weights[2])});
  return std::nullopt;
}

Bridge_ray Ray_lifter::ray(const Polar_point& contact, const Vec& place) const {
  const auto steps = static_cast<std::size_t>(
      std::clamp(std::ceil(contact.distance / step_), double(fewest_steps), double(most_steps)));
  std::vector<Vec> knots;
  Vec last = place;
  for (std::size_t i = steps + 1; i-- > 0;) {
    const double distance = contact.distance * static_cast<double>(i) / static_cast<double>(steps);
    if (const auto at = lifted({distance, contact.angle})) last = *at;  // else as it was
    knots.push_back(last);
  }
  std::reverse(knots.begin(), knots.end());
  // The contact lies on a facet. The same shift all along the ray leaves tangents and curvature as they are.
  const Vec shift = place - knots.back();
  for (Vec& k : knots) k += shift;
  return Bridge_ray(knots);
}

}  // namespace cgal_blend
