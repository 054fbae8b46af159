// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/boundary_models.h>
#include <cgal_blend/mesh_boundary.h>
#include <cgal_blend/quadric_intersection.h>

#include "blend_boundaries.h"
#include "shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;

using Rational = Quadric_3::Rational;

/// A surface with a closed boundary curve, and its normals by a formula of the test's own.
struct Model {
  std::string name;
  Boundary_curve curve;
  Normal_field normal;
};

/// The component of an intersection on one side of a coordinate plane.
Intersection_curve component(const Quadric_intersection& section, int axis, double sign) {
  for (const Intersection_curve& curve : section.components)
    if (curve.is_closed() && curve.at(0.3).point[axis] * sign > 0) return curve;
  throw std::runtime_error("no such component");
}

// x^2 / 4 + y^2 / 2 - z^2 / 3 = 1, cut by z + x / 10 = 1/2.
Model quadric_and_plane() {
  const Quadric_3 q(std::array<double, 10>{3, 6, -4, 0, 0, 0, 0, 0, 0, -12});
  const auto section = intersect(q, {Rational(1) / 10, Rational(0), Rational(1), Rational(-1) / 2});
  return {"quadric and plane", Implicit_boundary(implicit_function(q), space_curve_of(section.components.at(0))),
          [](const Point_3& p) { return Vector_3(p.x() / 4, p.y() / 2, -p.z() / 3); }};
}

// The cylinder y^2 + z^2 = 1, cut by x^2 / 9 + y^2 / 4 = 1.
Model quadric_and_quadric() {
  const Quadric_3 q(std::array<double, 10>{0, 1, 1, 0, 0, 0, 0, 0, 0, -1}),
      cutter(std::array<double, 10>{4, 9, 0, 0, 0, 0, 0, 0, 0, -36});
  return {"quadric and quadric",
          Implicit_boundary(implicit_function(q), space_curve_of(component(intersect_quadrics(q, cutter), 0, 1))),
          [](const Point_3& p) { return Vector_3(0, p.y(), p.z()); }};
}

// A paraboloid of its own parameters: (v cos u, 2 v sin u, v^2) along v = 1.
Model patch() {
  const auto f = [](const auto& u, const auto& v) {
    using std::cos;
    using std::sin;
    using T = std::decay_t<decltype(u)>;
    return std::array<T, 3>{v * cos(u), T(2.0) * v * sin(u), v * v};
  };
  return {"patch", Iso_curve_boundary(parametric_patch(f, {0, 2 * CGAL_PI, 0.5, 1}, true), 1),
          [](const Point_3& p) { return Vector_3(2 * p.x(), p.y() / 2, -1); }};
}

// x^4 + y^4 + exp(z) = 2 along z = 0.
Model implicit() {
  const auto f = [](const auto& x, const auto& y, const auto& z) {
    using std::exp;
    using T = std::decay_t<decltype(x)>;
    return power(x, 4) + power(y, 4) + exp(z) - T(2.0);
  };
  const auto curve = [](const auto& s) {
    using std::cos;
    using std::sin;
    using std::sqrt;
    using T = std::decay_t<decltype(s)>;
    const T c = cos(T(2 * CGAL_PI) * s), d = sin(T(2 * CGAL_PI) * s);
    const T r = T(1.0) / sqrt(sqrt(power(c, 4) + power(d, 4)));
    return std::array<T, 3>{r * c, r * d, T(0.0)};
  };
  return {"implicit", Implicit_boundary(implicit_function(f), space_curve(curve, true)),
          [](const Point_3& p) { return Vector_3(4 * std::pow(p.x(), 3), 4 * std::pow(p.y(), 3), std::exp(p.z())); }};
}

Model torus() {
  const Parametric_patch t =
      torus_patch(Point_3(1, 0, 0), {Vector_3(1, 0, 0), Vector_3(0, 1, 0), Vector_3(0, 0, 1)}, 3, 1, -2, 0.3);
  return {"torus", Iso_curve_boundary(t, 0.3), [](const Point_3& p) {
            const double x = p.x() - 1, rho = std::hypot(x, p.y());
            return Vector_3(x * (1 - 3 / rho), p.y() * (1 - 3 / rho), p.z());
          }};
}

// Straight centre line along z and r = 2 + cos(u) / 2 + v / 4: an implicit form in cylindrical coordinates. The frame is
// e1 = x, e2 = y.
Model ringed() {
  const auto centre = [](const auto& t) {
    using T = std::decay_t<decltype(t)>;
    return std::array<T, 3>{T(0.0), T(0.0), t};
  };
  const auto radius = [](const auto& t, const auto& u) {
    using std::cos;
    using T = std::decay_t<decltype(t)>;
    return T(2.0) + T(0.5) * cos(u) + T(0.25) * t;
  };
  return {"ringed", Iso_curve_boundary(ringed_patch(centre, radius, Vector_3(1, 0, 0), 0, 2), 2), [](const Point_3& p) {
            const double rho = std::hypot(p.x(), p.y());
            // F = rho - 2 - x / (2 rho) - z / 4.
            return Vector_3(p.x() / rho - 1 / (2 * rho) + p.x() * p.x() / (2 * rho * rho * rho),
                            p.y() / rho + p.x() * p.y() / (2 * rho * rho * rho), -0.25);
          }};
}

/// A ring of edges of a mesh, whose normals at the vertices are radial by symmetry.
Model mesh() {
  const Blend_mesh m = test::cylinder(1.5, 48, -2, 2, 7);
  std::vector<Vertex> chain;
  for (const Vertex v : m.vertices())
    if (std::abs(m.point(v).z() - 1) < 1e-9) chain.push_back(v);
  const auto angle = [&](Vertex v) { return std::atan2(m.point(v).y(), m.point(v).x()); };
  std::sort(chain.begin(), chain.end(), [&](Vertex v, Vertex w) { return angle(v) > angle(w); });
  return {"mesh", Mesh_boundary(m, chain), {}};
}

std::vector<Model> all_models() {
  return {quadric_and_plane(), quadric_and_quadric(), patch(), implicit(), torus(), ringed(), mesh()};
}

TEST(Surface_blend_models, Are_tangent_in_every_pair) {
  const std::vector<Model> models = all_models();
  double worst = 0;
  for (const Model& a : models)
    for (const Model& b : models) {
      SCOPED_TRACE(a.name + " with " + b.name);
      Surface_blend_options options;
      options.sides[0].direction = 0.2;
      options.sides[0].distance = 0.8;
      options.sides[1].distance = 1.1;
      options.on_fold = Fold_policy::ignore;
      const auto result = blend_surfaces(a.curve, b.curve, options);
      ASSERT_TRUE(result.ok()) << message(result.diagnosis);
      const std::array<const Model*, 2> sides{&a, &b};
      for (int side = 0; side < 2; ++side) {
        const Model& model = *sides[side];
        // Of meshes: the vertices, in which the spline has the mean tangent; the chain has a mean plane there.
        if (model.normal) {
          worst = std::max(worst, worst_tangency(*result.blend, side, model.normal, 37));
          continue;
        }
        for (const double s : model.curve.fixed_parameters()) {
          const double at = result.blend->parameter_map(side).inverse(s);
          const Point_3 p = model.curve.at(s).point;
          worst = std::max(worst, line_angle(measured_normal(*result.blend, side, at), Vector_3(p.x(), p.y(), 0)));
        }
      }
      EXPECT_LT(worst, 1e-7);
    }
  RecordProperty("worst_tangency_rad", std::to_string(worst));
  std::cout << "largest angle " << worst << " rad\n";
}

TEST(Surface_blend_models, Second_forms_agree_with_differences) {
  for (const Model& model : all_models()) {
    if (!model.curve.has_second_form()) continue;
    SCOPED_TRACE(model.name);
    for (int i = 0; i < 20; ++i) {
      const double s = i / 20.0, h = 1e-5;
      const Boundary_point p = model.curve.at(s);
      // Along the curve itself II(C', C') = C'' . N = -C' . N'; N' by differences of the test's normals.
      const auto normal_at = [&](double x) {
        const Boundary_point q = model.curve.at(x - std::floor(x));
        const Vector_3 n = unit(model.normal(q.point));
        return n * q.normal < 0 ? -n : n;
      };
      const Vector_3 slope = (normal_at(s + h) - normal_at(s - h)) / (2 * h);
      const double size = p.derivative.squared_length();
      EXPECT_NEAR(model.curve.second_form(s, p.derivative), -slope * p.derivative, 1e-5 * size);
      // And II is symmetric: II(C' + T, C' + T) - II(C', C') - II(T, T) = -2 T . N'.
      const Vector_3 t = CGAL::cross_product(p.normal, p.derivative);
      const double mixed = model.curve.second_form(s, p.derivative + t) - model.curve.second_form(s, p.derivative) -
                           model.curve.second_form(s, t);
      EXPECT_NEAR(mixed, -2 * (slope * t), 1e-5 * size);
    }
  }
}

TEST(Surface_blend_models, Continues_the_curvature_of_every_pair) {
  const std::vector<Model> models = all_models();
  for (const Model& a : models)
    for (const Model& b : models) {
      SCOPED_TRACE(a.name + " with " + b.name);
      Surface_blend_options options;
      options.g2 = true;
      options.sides[0].distance = 0.8;
      options.sides[1].distance = 1.1;
      options.on_fold = Fold_policy::ignore;
      const auto result = blend_surfaces(a.curve, b.curve, options);
      if (!a.normal || !b.normal) {
        EXPECT_EQ(result.diagnosis.status, Status::not_supported);
        continue;
      }
      ASSERT_TRUE(result.ok()) << message(result.diagnosis);
      for (int i = 0; i < 12; ++i) {
        const double s = (i + 0.3) / 12;
        const auto f = [&](double t) { return result.blend->at(s, t); };
        const auto [d, dd] = one_sided_derivatives(f, 0.05);
        // The surface's normal curvature by differences of its normals along d, with the test's own formula.
        const Vector_3 n = unit(a.normal(f(0)));
        const double h = 1e-6 / std::sqrt(d.squared_length());
        const Vector_3 slope = (unit(a.normal(f(0) + h * d)) - unit(a.normal(f(0) - h * d))) / (2 * h);
        EXPECT_NEAR(dd * n, -slope * d, 2e-6 * d.squared_length());
      }
    }
}

}  // namespace
