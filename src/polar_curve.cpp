// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/polar_curve.h>

#include "base_surface.h"

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>

namespace cgal_blend {

namespace {

using Vec_2 = Eigen::Vector2d;

/// A polygon around the origin with right angles, each rounded by an arc, by arc length from the middle of its last edge.
class Rounded_outline {
 public:
  Rounded_outline(std::vector<Vec_2> corners, double radius) : corners_(std::move(corners)), radius_(radius) {
    starts_.push_back(0);
    for (std::size_t i = 0; i < corners_.size(); ++i)
      starts_.push_back(starts_.back() + straight_before(i) + 0.5 * pi * radius_);
  }

  [[nodiscard]] Polar_point operator()(double s) const {
    const double length = starts_.back();
    const double turns = std::floor(s), from_middle = (s - turns) * length + 0.5 * straight_before(0);
    const bool wraps = from_middle >= length;
    const Vec_2 p = at(wraps ? from_middle - length : from_middle);
    double angle = std::atan2(p.y(), p.x());
    // The angle follows s: it is within a right angle of 2 pi s for these shapes.
    angle += 2 * pi * std::round((2 * pi * s - angle) / (2 * pi));
    return {p.norm(), angle};
  }

 private:
  [[nodiscard]] Vec_2 direction_to(std::size_t i) const { return (corners_[i] - corner_before(i)).normalized(); }
  [[nodiscard]] const Vec_2& corner_before(std::size_t i) const {
    return corners_[(i + corners_.size() - 1) % corners_.size()];
  }
  [[nodiscard]] double straight_before(std::size_t i) const {
    return (corners_[i] - corner_before(i)).norm() - 2 * radius_;
  }

  /// \param length from the end of the last corner's arc on
  [[nodiscard]] Vec_2 at(double length) const {
    const auto above = std::upper_bound(starts_.begin(), starts_.end(), length);
    const std::size_t i = std::min<std::size_t>(above - starts_.begin(), corners_.size()) - 1;
    const Vec_2 u = direction_to(i), v = direction_to((i + 1) % corners_.size());
    const double rest = length - starts_[i] - straight_before(i);
    if (rest < 0) return corners_[i] + (rest - radius_) * u;
    const double arc = rest / radius_;
    return corners_[i] - radius_ * u + radius_ * v + radius_ * (std::sin(arc) * u - std::cos(arc) * v);
  }

  std::vector<Vec_2> corners_;
  double radius_;
  std::vector<double> starts_;  // of the straight part before each corner
};

Polar_curve outline_curve(std::vector<Vec_2> corners, double radius) {
  const auto outline = std::make_shared<const Rounded_outline>(std::move(corners), radius);
  return [outline](double s) { return (*outline)(s); };
}

/// A periodic interpolating cubic spline by the moments (second derivatives) at its knots.
class Periodic_spline {
 public:
  explicit Periodic_spline(const std::vector<Polar_point>& points) {
    for (const Polar_point& p : points) {
      knots_.push_back(p.angle);
      values_.push_back(p.distance);
    }
    knots_.push_back(knots_.front() + 2 * pi);
    values_.push_back(values_.front());
    solve();
  }

  [[nodiscard]] double operator()(double angle) const {
    const double x = angle - 2 * pi * std::floor((angle - knots_.front()) / (2 * pi));
    const auto above = std::upper_bound(knots_.begin(), knots_.end(), x);
    const std::size_t i = std::clamp<std::ptrdiff_t>(above - knots_.begin(), 1, knots_.size() - 1) - 1;
    const double h = step(i), left = knots_[i + 1] - x, right = x - knots_[i];
    return (moments_[i] * left * left * left + moments_[i + 1] * right * right * right) / (6 * h) +
           (values_[i] / h - moments_[i] * h / 6) * left + (values_[i + 1] / h - moments_[i + 1] * h / 6) * right;
  }

 private:
  [[nodiscard]] double step(std::size_t i) const { return knots_[i + 1] - knots_[i]; }

  /// The cyclic tridiagonal system h[i-1] M[i-1] + 2 (h[i-1] + h[i]) M[i] + h[i] M[i+1] = 6 (slope change), solved as one
  /// without the two corners and one correction of rank one (Sherman and Morrison).
  void solve() {
    const std::size_t n = knots_.size() - 1;
    std::vector<double> diagonal(n), right(n), bordered(n, 0);
    const double corner = step(n - 1);
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t before = (i + n - 1) % n;
      diagonal[i] = 2 * (step(before) + step(i));
      right[i] = 6 * ((values_[i + 1] - values_[i]) / step(i) - (values_[before + 1] - values_[before]) / step(before));
    }
    const double gamma = -diagonal[0];
    diagonal[0] -= gamma;
    diagonal[n - 1] -= corner * corner / gamma;
    bordered[0] = gamma;
    bordered[n - 1] = corner;
    const std::vector<double> x = tridiagonal(diagonal, right), z = tridiagonal(diagonal, bordered);
    const double factor = (x[0] + corner * x[n - 1] / gamma) / (1 + z[0] + corner * z[n - 1] / gamma);
    for (std::size_t i = 0; i < n; ++i) moments_.push_back(x[i] - factor * z[i]);
    moments_.push_back(moments_.front());
  }

  [[nodiscard]] std::vector<double> tridiagonal(std::vector<double> diagonal, std::vector<double> right) const {
    for (std::size_t i = 1; i < diagonal.size(); ++i) {
      const double factor = step(i - 1) / diagonal[i - 1];
      diagonal[i] -= factor * step(i - 1);
      right[i] -= factor * right[i - 1];
    }
    for (std::size_t i = diagonal.size(); i-- > 0;) {
      if (i + 1 < diagonal.size()) right[i] -= step(i) * right[i + 1];
      right[i] /= diagonal[i];
    }
    return right;
  }

  std::vector<double> knots_, values_, moments_;
};

}  // namespace

Polar_curve circle_curve(double radius) {
  CGAL_precondition(radius > 0);
  return [radius](double s) { return Polar_point{radius, 2 * pi * s}; };
}

Polar_curve ellipse_curve(double a, double b) {
  CGAL_precondition(a > 0 && b > 0);
  return [a, b](double s) {
    const double phi = 2 * pi * s, x = std::cos(phi), y = std::sin(phi);
    return Polar_point{std::hypot(a * x, b * y), phi + std::atan2((b - a) * x * y, a * x * x + b * y * y)};
  };
}

Polar_curve rectangle_curve(double a, double b, double corner) {
  CGAL_precondition(a > 0 && b > 0 && corner > 0 && corner <= std::min(a, b));
  return outline_curve({{a, b}, {-a, b}, {-a, -b}, {a, -b}}, corner);
}

Polar_curve star_curve(double radius, double depth, int arms) {
  CGAL_precondition(radius > 0 && depth >= 0 && depth < 1 && arms > 0);
  return function_curve([=](double angle) { return radius * (1 + depth * std::cos(arms * angle)); });
}

Polar_curve cross_curve(double a, double b, double corner) {
  CGAL_precondition(b > 0 && a > b && corner > 0 && corner <= std::min(b, (a - b) / 2));
  return outline_curve(
      {{a, b}, {b, b}, {b, a}, {-b, a}, {-b, b}, {-a, b}, {-a, -b}, {-b, -b}, {-b, -a}, {b, -a}, {b, -b}, {a, -b}},
      corner);
}

Polar_curve spline_curve(const std::vector<Polar_point>& points) {
  CGAL_precondition(points.size() >= 3);
  CGAL_precondition(points.back().angle < points.front().angle + 2 * pi);
  CGAL_precondition(
      std::is_sorted(points.begin(), points.end(), [](const auto& p, const auto& q) { return p.angle <= q.angle; }));
  const auto spline = std::make_shared<const Periodic_spline>(points);
  return function_curve([spline](double angle) { return (*spline)(angle); });
}

Polar_curve function_curve(std::function<double(double angle)> distance) {
  return [distance = std::move(distance)](double s) {
    const double angle = 2 * pi * s;
    return Polar_point{distance(angle), angle};
  };
}

Polar_curve scaled(Polar_curve curve, double factor) {
  return [curve = std::move(curve), factor](double s) {
    Polar_point p = curve(s);
    p.distance *= factor;
    return p;
  };
}

}  // namespace cgal_blend
