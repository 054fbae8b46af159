// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/bridge.h>

#include "bridge_spheres.h"
#include "checks.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <set>
#include <vector>

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;
using Vec = Eigen::Vector3d;

Vec vec(const Point_3& p) { return {p.x(), p.y(), p.z()}; }

/// Largest distances of a bridge from the closed form: in the half plane of the axis, and in angle (degrees) around it.
struct Deviation {
  double profile = 0, angle = 0;
};

Deviation deviation(const Two_spheres& spheres, int level, const std::array<double, 2>& lambda, int order, double mu) {
  const Blend_mesh mesh = spheres.mesh(level);
  auto ends = spheres.ends();
  for (std::size_t k : {0, 1}) ends[k].lambda = lambda[k];
  Bridge_options options;
  options.order = order;
  options.mu = mu;
  const Bridge_solver solver(mesh, ends, options);
  EXPECT_TRUE(solver.diagnosis().ok()) << message(solver.diagnosis());
  Deviation result;
  const Point_3 start = solver.point(0, 0);
  const double zero = std::atan2(start.y(), start.x());
  for (int i = 0; i < 40; ++i)
    for (int j = 0; j <= 20; ++j) {
      const double s = i / 40.0, t = j / 20.0;
      const Point_3 p = solver.point(s, t);
      const auto expected = spheres.blend(t, mu, order, lambda[0], lambda[1]);
      result.profile =
          std::max(result.profile, std::hypot(std::hypot(p.x(), p.y()) - expected[0], p.z() - expected[1]));
      const double turned = std::remainder(std::atan2(p.y(), p.x()) - zero - 2 * pi * s, 2 * pi);
      result.angle = std::max(result.angle, std::abs(turned) * 180 / pi);
    }
  return result;
}

TEST(Bridge, equals_the_closed_form_between_spheres) {
  const Two_spheres spheres;
  const Deviation coarse = deviation(spheres, 3, {0.5, 0.3}, 2, 0.4),
                  middle = deviation(spheres, 4, {0.5, 0.3}, 2, 0.4), fine = deviation(spheres, 5, {0.5, 0.3}, 2, 0.4);
  EXPECT_GT(coarse.profile, 2 * middle.profile);  // order 1 at least
  EXPECT_GT(middle.profile, 2 * fine.profile);
  EXPECT_LT(fine.profile, 1.5e-3);
  EXPECT_LT(fine.angle, 1);
}

TEST(Bridge, has_mu_order_and_lambda_of_the_closed_form) {
  const Two_spheres spheres;
  for (const int order : {1, 2, 3})
    for (const double mu : {0.2, 0.7}) EXPECT_LT(deviation(spheres, 5, {0.1, 0.8}, order, mu).profile, 1.5e-3);
}

/// Derivatives of t -> B(s, t) at a contact, by a polynomial through many points near it.
std::array<Vec, 2> derivatives_at_contact(const Bridge_solver& solver, double s, int end) {
  constexpr int points = 40, degree = 5;
  constexpr double reach = 0.05;
  Eigen::Matrix<double, points, degree + 1> powers;
  Eigen::Matrix<double, points, 3> values;
  for (int i = 0; i < points; ++i) {
    const double t = reach * i / (points - 1);
    for (int k = 0; k <= degree; ++k) powers(i, k) = std::pow(t / reach, k);
    values.row(i) = vec(solver.point(s, end == 0 ? t : 1 - t)).transpose();
  }
  const Eigen::Matrix<double, degree + 1, 3> c = powers.colPivHouseholderQr().solve(values);
  return {Vec(c.row(1).transpose() / reach), Vec(2 * c.row(2).transpose() / (reach * reach))};
}

TEST(Bridge, continues_tangent_planes_and_curvature_across_the_contacts) {
  const Two_spheres spheres;
  const Blend_mesh mesh = spheres.mesh(5);  // 10242 vertices per sphere
  const std::array<Vec, 2> centre{Vec(0, 0, 0), Vec(0, 0, spheres.between)};
  for (const int order : {1, 2}) {
    Bridge_options options;
    options.order = order;
    const Bridge_solver solver(mesh, spheres.ends(), options);
    ASSERT_TRUE(solver.diagnosis().ok());
    for (const int end : {0, 1}) {
      const double radius = end == 0 ? spheres.first : spheres.second;
      double steepest = 0, worst = 0;
      for (int i = 0; i < 48; ++i) {
        const double s = i / 48.0, t = end;
        const auto d = derivatives_at_contact(solver, s, end);
        const Vec around = vec(solver.point(s + 1e-3, t)) - vec(solver.point(s - 1e-3, t));
        const Vec normal = (vec(solver.point(s, t)) - centre[end]).normalized();
        const double sine = std::abs(d[0].cross(around).normalized().dot(normal));
        steepest = std::max(steepest, std::acos(std::min(1.0, sine)) * 180 / pi);
        const double curvature = -d[1].dot(normal) / d[0].squaredNorm();  // normal curvature across the contact
        worst = std::max(worst, std::abs(curvature * radius - 1));
      }
      EXPECT_LT(steepest, 2) << "order " << order << ", end " << end;
      if (order == 2)
        EXPECT_LT(worst, 0.1) << "end " << end;
      else
        EXPECT_GT(worst, 0.5) << "of order 1 there is no reason for it, end " << end;
    }
  }
}

TEST(Bridge, lies_in_the_facets_next_to_the_contacts_as_the_spheres_do) {
  const Two_spheres spheres;
  const Blend_mesh mesh = spheres.mesh(5);
  Blend_mesh out;
  const Bridge_outcome outcome = unchecked::bridge(mesh, spheres.ends(), out);
  ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
  EXPECT_LT(outcome.bridges[0].tangency_deg, 2);
  const std::set<Face> bridge(outcome.bridge_faces[0].begin(), outcome.bridge_faces[0].end());
  double steepest = 0;
  std::size_t seen = 0;
  for (const Face f : bridge)
    for (const Halfedge h : out.halfedges_around_face(out.halfedge(f))) {
      if (bridge.count(out.face(out.opposite(h)))) continue;
      const Vec a = vec(out.point(out.source(h))), b = vec(out.point(out.target(h))),
                c = vec(out.point(out.target(out.next(h))));
      const Vec middle = (a + b) / 2, centre = middle.z() < 1.3 ? Vec(0, 0, 0) : Vec(0, 0, spheres.between);
      const double cosine = (b - a).cross(c - a).normalized().dot((middle - centre).normalized());
      steepest = std::max(steepest, std::acos(std::min(1.0, cosine)) * 180 / pi);
      ++seen;
    }
  EXPECT_GT(seen, 100u);
  EXPECT_LT(steepest, 2);  // facets of the spheres themselves are up to 1.2 degrees off
}

TEST(Bridge, has_the_volume_of_the_surface_of_revolution) {
  const Two_spheres spheres;
  const auto volume_error = [&](int level) {
    Blend_mesh out;
    Bridge_options options;
    options.chord_tolerance = 1e-4;
    const Bridge_outcome outcome = unchecked::bridge(spheres.mesh(level), spheres.ends(), out, options);
    EXPECT_TRUE(outcome.ok()) << message(outcome.diagnosis);
    double exact = 0;  // of the tube between the planes of the contacts, by pi r^2 dz, and what is left of the spheres
    constexpr int steps = 20000;
    for (int i = 0; i < steps; ++i) {
      const auto p = spheres.blend(static_cast<double>(i) / steps, 0.5, 2, 0.5, 0.5),
                 q = spheres.blend((i + 1.0) / steps, 0.5, 2, 0.5, 0.5);
      exact += pi / 4 * (p[0] + q[0]) * (p[0] + q[0]) * (q[1] - p[1]);
    }
    for (const int side : {0, 1}) {
      const double r = side == 0 ? spheres.first : spheres.second,
                   height = r * (1 - std::cos(spheres.contact[side] / r));
      exact += 4 * pi / 3 * r * r * r - pi * height * height * (3 * r - height) / 3;
    }
    return std::abs(outcome.volume / exact - 1);
  };
  const double coarse = volume_error(3), fine = volume_error(5);
  EXPECT_GT(coarse, 6 * fine);
  EXPECT_LT(fine, 2e-3);
}

}  // namespace
