// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/sphere_hub.h>

#include "base_surface.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cgal_blend {

namespace {

constexpr int samples = 256;
constexpr double largest_circle = pi / 3;
constexpr double parallel_axes = 1e-6;  // least over largest eigenvalue at which a nearest point is not determined

struct Ring {
  Vec centroid = Vec::Zero(), axis = Vec::Zero();
  std::vector<Vec> points;
};

/// The centroid is that of the curve by arc length: the rule of equal weights is very accurate round closed curves.
Ring ring_of(const Boundary_curve& curve) {
  Ring ring;
  double length = 0;
  for (int i = 0; i < samples; ++i) {
    const Boundary_point at = curve.at(static_cast<double>(i) / samples);
    const double speed = std::sqrt(at.derivative.squared_length());
    ring.points.push_back(to_vec(at.point));
    ring.centroid += speed * ring.points.back();
    length += speed;
  }
  ring.centroid /= length;
  for (int i = 0; i < samples; ++i)
    ring.axis += (ring.points[i] - ring.centroid).cross(ring.points[(i + 1) % samples] - ring.centroid);
  ring.axis.normalize();
  return ring;
}

/// The point nearest to the axes; of parallel ones nearest to the centroids along them.
Vec nearest_to_axes(const std::vector<Ring>& rings) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  Vec right = Vec::Zero(), mean = Vec::Zero();
  for (const Ring& ring : rings) {
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - ring.axis * ring.axis.transpose();
    sum += across;
    right += across * ring.centroid;
    mean += ring.centroid / static_cast<double>(rings.size());
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(sum);
  Vec point = mean;
  for (int i = 0; i < 3; ++i) {
    if (solver.eigenvalues()[i] < parallel_axes * solver.eigenvalues()[2]) continue;
    const Vec v = solver.eigenvectors().col(i);
    point += (v.dot(right) / solver.eigenvalues()[i] - v.dot(mean)) * v;
  }
  return point;
}

Boundary_curve circle(const Quadric_3& sphere, const Vec& centre, double radius, const Vec& direction, double angle) {
  const Vec e1 = direction.unitOrthogonal(), e2 = direction.cross(e1);
  const Space_curve curve{[=](double s) {
                            const double a = 2 * pi * s, r = radius * std::sin(angle);
                            const Vec p = centre + radius * std::cos(angle) * direction +
                                          r * (std::cos(a) * e1 + std::sin(a) * e2);
                            const Vec d = 2 * pi * r * (std::cos(a) * e2 - std::sin(a) * e1);
                            return Space_curve_point{to_point(p), Vector_3(d.x(), d.y(), d.z())};
                          },
                          true};
  return Implicit_boundary(implicit_function(sphere), curve);
}

double least_angle(const std::vector<Vec>& directions) {
  double least = pi;
  for (std::size_t i = 0; i < directions.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) least = std::min(least, angle_between(directions[i], directions[j]));
  return least;
}

}  // namespace

Sphere_hub sphere_between(const std::vector<Boundary_curve>& curves, const Sphere_hub_options& options) {
  Sphere_hub hub;
  const auto refuse = [&](Status status, const char* why) {
    hub.diagnosis = {status, why, {}, {}};
    return hub;
  };
  if (curves.size() < 2) return refuse(Status::invalid_parameter, "a sphere joins two curves or more");
  if (!(options.spread > 0 && options.spread < 1) || (options.radius && !(*options.radius > 0)))
    return refuse(Status::invalid_parameter, "the sphere's radius must be > 0, the spread between 0 and 1");
  std::vector<Ring> rings;
  for (const Boundary_curve& curve : curves) {
    if (!curve.is_closed()) return refuse(Status::curves_do_not_correspond, "a sphere joins closed curves only");
    rings.push_back(ring_of(curve));
  }
  const Vec centre = options.centre ? to_vec(*options.centre) : nearest_to_axes(rings);
  double nearest = std::numeric_limits<double>::infinity();
  std::vector<Vec> directions;
  for (const Ring& ring : rings) {
    for (const Vec& p : ring.points) nearest = std::min(nearest, (p - centre).norm());
    directions.push_back((ring.centroid - centre).normalized());
  }
  hub.centre = to_point(centre);
  hub.radius = options.radius.value_or(nearest / 2);
  if (!(hub.radius > 0)) return refuse(Status::blends_overlap, "a curve runs through the sphere's centre");
  const double angle = std::min(largest_circle, options.spread * least_angle(directions) / 2);
  if (!(angle > 1e-6)) return refuse(Status::blends_overlap, "two curves lie in one direction from the sphere");
  const Quadric_3::Rational r(hub.radius);
  hub.sphere = Quadric_3::sphere(
      {Quadric_3::Rational(centre.x()), Quadric_3::Rational(centre.y()), Quadric_3::Rational(centre.z())}, r * r);
  for (const Vec& direction : directions)
    hub.circles.push_back(circle(hub.sphere, centre, hub.radius, direction, angle));
  return hub;
}

}  // namespace cgal_blend
