// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/boundary_models.h>
#include <cgal_blend/mesh_boundary.h>
#include <cgal_blend/quadric_intersection.h>
#include <cgal_blend/sphere_hub.h>
#include <cgal_blend/surface_blend_body.h>

#include "blend_boundaries.h"
#include "checks.h"
#include "shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;

using Rational = Quadric_3::Rational;
constexpr double pi_ = 3.141592653589793;

Quadric_3::Plane plane(double a, double b, double c, double d) {
  return {Rational(a), Rational(b), Rational(c), Rational(d)};
}

/// The curve of a quadric and a plane; the first component.
Implicit_boundary section(const Quadric_3& quadric, const Quadric_3::Plane& p, std::size_t component = 0) {
  const auto result = intersect(quadric, p);
  return {implicit_function(quadric), space_curve_of(result.components.at(component))};
}

Surface_blend blend_of(const Boundary_curve& a, const Boundary_curve& b, const Surface_blend_options& options = {}) {
  auto result = blend_surfaces(a, b, options);
  EXPECT_TRUE(result.ok()) << message(result.diagnosis);
  return *result.blend;
}

std::vector<Face> faces_of(const Blend_body& body, Face_label::Kind kind, std::size_t index) {
  std::vector<Face> faces;
  for (const Face f : body.mesh.faces())
    if (body.labels[f].kind == kind && body.labels[f].index == index) faces.push_back(f);
  return faces;
}

void expect_solid(const Blend_body& body) {
  ASSERT_TRUE(body.ok()) << message(body.diagnosis);
  EXPECT_TRUE(body.closed);
  EXPECT_TRUE(is_closed_by_counting(body.mesh));
  EXPECT_TRUE(has_single_fans(body.mesh));
  EXPECT_GT(volume_of(body.mesh), 0);
  EXPECT_EQ(body.labels.size(), body.mesh.number_of_faces());
}

// The blend between two ends of one cylinder, at a third of the gap, is the cylinder itself.
TEST(Surface_blend_body, Continues_a_cylinder) {
  const Quadric_3 cylinder = Quadric_3::cylinder({0, 0, 0}, {0, 0, 1}, 1);
  Surface_blend_options options;
  options.sides[0].distance = options.sides[1].distance = 1.0;
  const Surface_blend blend =
      blend_of(section(cylinder, plane(0, 0, 1, 0)), section(cylinder, plane(0, 0, 1, -3)), options);
  Blend_body_options body_options;
  body_options.chord_tolerance = 1e-4;
  const Blend_body body = make_blend_body(
      {trimmed_quadric(cylinder, {plane(0, 0, -1, -2)}), trimmed_quadric(cylinder, {plane(1, 0, 1, -5)})}, {{blend}},
      body_options);
  expect_solid(body);
  const double tolerance = 1e-4 * std::sqrt(4 + 4 + 9);
  for (const Vertex v : body.mesh.vertices())
    EXPECT_LT(distance_to_cylinder(body.mesh.point(v), Point_3(0, 0, 0), Vector_3(0, 0, 1), 1), 1e-12);
  EXPECT_NEAR(volume_of(body.mesh), pi_ * 7, 2 * tolerance * 2 * pi_ * 7);
  EXPECT_LT(volume_of(body.mesh), pi_ * 7);
  for (const Face f : faces_of(body, Face_label::Kind::blend, 0))
    for (const std::size_t v : corners_of(body.mesh, f)) {
      EXPECT_GE(body.mesh.point(Vertex(v)).z(), -1e-12);
      EXPECT_LE(body.mesh.point(Vertex(v)).z(), 3 + 1e-12);
    }
}

double volume_of_cap(double radius, double height) { return pi_ * height * height * (3 * radius - height) / 3; }

// Every kind of quadric that a closed curve can run round, cut off by a plane and joined to a sphere above it.
TEST(Surface_blend_body, Tessellates_every_kind_of_quadric) {
  struct Case {
    std::array<double, 10> coefficients;
    double cut;  // z of the section
    std::vector<Quadric_3::Plane> far;
    double volume;  // of the part below; 0: unknown
  };
  const auto low = plane(0, 0, -1, -4);  // z >= -4
  const std::vector<Case> cases{{{1, 1, 1, 0, 0, 0, 0, 0, 0, -4}, 1, {}, 4. / 3 * pi_ * 8 - volume_of_cap(2, 1)},
                                {{4, 9, 1, 0, 0, 0, 0, 0, 0, -36}, 1, {low}, 0},
                                {{1, 1, 0, 0, 0, 0, 0, 0, 0, -1}, 0, {low}, 4 * pi_},
                                {{1, 4, 0, 0, 0, 0, 0, 0, 0, -1}, 0, {low}, 2 * pi_},
                                {{4, 4, -1, 0, 0, 0, 0, 0, 0, -4}, 0, {low}, pi_ * (4 + 16. / 3)},  // r^2 = 1 + z^2 / 4
                                {{4, 4, -1, 0, 0, 0, 0, 0, 0, 0}, -1, {low}, pi_ / 4 * (64 - 1) / 3},
                                {{4, 4, -1, 0, 0, 0, 0, 0, -2, -1}, 0, {low}, 0},    // apex at z = -1: two nappes
                                {{1, 1, 0, 0, 0, 0, 0, 0, -1, -1}, 0, {}, pi_ / 2},  // z = r^2 - 1
                                {{1, 2, 0, 0, 0, 0, 0, 0, -1, -1}, 0, {}, 0},
                                {{1, 1, -1, 0, 0, 0, 0, 0, -4, -3}, 1, {}, 0}};  // two sheets about z = -2
  const Quadric_3 sphere = Quadric_3::sphere({0, 0, 6}, 1);
  Blend_body_options fine;
  fine.chord_tolerance = 3e-4;
  for (const Case& c : cases) {
    SCOPED_TRACE(&c - cases.data());
    const Quadric_3 quadric(c.coefficients);
    const Surface_blend blend =
        blend_of(section(quadric, plane(0, 0, 1, -c.cut)), section(sphere, plane(0, 0, 1, -5.7)));
    const Blend_body body =
        make_blend_body({trimmed_quadric(quadric, c.far), trimmed_quadric(sphere)}, {{blend}}, fine);
    if (&c - cases.data() == 6) {
      EXPECT_EQ(body.diagnosis.status, Status::ok) << message(body.diagnosis);
    }
    expect_solid(body);
    // The part of the quadric lies on it, and where its volume below the section is known that is right, too.
    double volume = 0;
    for (const Face f : body.mesh.faces()) {
      const auto [i, j, k] = corners_of(body.mesh, f);
      const std::array<Point_3, 3> p{body.mesh.point(Vertex(i)), body.mesh.point(Vertex(j)),
                                     body.mesh.point(Vertex(k))};
      if (body.labels[f].kind == Face_label::Kind::surface && body.labels[f].index == 0)
        for (const Point_3& q : p) {
          EXPECT_LT(std::abs(quadric.value(q)) / std::sqrt(quadric.gradient(q).squared_length() + 1e-20), 1e-11);
          EXPECT_LE(q.z(), c.cut + 1e-9);
        }
      const bool is_below = body.labels[f].kind == Face_label::Kind::cap ||
                            (body.labels[f].kind == Face_label::Kind::surface && body.labels[f].index == 0);
      const Vector_3 down(0, 0, c.cut);  // cones over the section have no volume
      if (is_below) volume += (p[0] - CGAL::ORIGIN - down) * CGAL::cross_product(p[1] - p[0], p[2] - p[0]) / 6;
    }
    if (c.volume > 0) {
      EXPECT_NEAR(volume, c.volume, 0.01 * c.volume);
    }
  }
}

TEST(Surface_blend_body, Joins_three_cylinders_through_a_sphere) {
  std::vector<Boundary_curve> ends;
  std::vector<Trimmed_surface> surfaces;
  const std::array<std::array<int, 3>, 3> axes{{{1, 0, 0}, {0, 1, 0}, {-1, -1, 2}}};
  for (const auto& [x, y, z] : axes) {
    const Quadric_3 cylinder = Quadric_3::cylinder({0, 0, 0}, {x, y, z}, Rational(1) / 2);
    const double length = std::sqrt(x * x + y * y + z * z);
    const auto at = [&](double d, double side) { return plane(side * x, side * y, side * z, -side * d * length); };
    ends.push_back(section(cylinder, at(3, 1)));
    surfaces.push_back(trimmed_quadric(cylinder, {at(5, 1)}));
  }
  const Sphere_hub hub = sphere_between(ends);
  ASSERT_TRUE(hub.ok()) << message(hub.diagnosis);
  EXPECT_LT(std::sqrt(CGAL::squared_distance(hub.centre, Point_3(0, 0, 0))), 1e-6);
  surfaces.push_back(trimmed_quadric(hub.sphere));
  std::vector<Body_blend> blends;
  for (std::size_t i = 0; i < 3; ++i) blends.push_back({blend_of(ends[i], hub.circles[i]), {i, 3}, {0, 0}});
  const Blend_body body = make_blend_body(surfaces, blends);
  expect_solid(body);
  for (const Face f : faces_of(body, Face_label::Kind::surface, 3))
    for (const std::size_t v : corners_of(body.mesh, f))
      EXPECT_NEAR(distance_to_sphere(body.mesh.point(Vertex(v)), hub.centre, hub.radius), 0, 1e-12);
}

TEST(Surface_blend_body, Joins_a_torus_and_a_ringed_surface) {
  // The end of the torus faces that of the ringed surface, 9 away.
  const double h = std::sqrt(0.5);
  const Vector_3 along = Vector_3(4, 1, -1) / std::sqrt(18.0), e1(0, h, h);
  const Vector_3 axis = CGAL::cross_product(along, e1);
  const Point_3 middle = Point_3(12, 9, 0) + 9 * along - 6 * e1;
  const Parametric_patch torus = torus_patch(middle, {e1, -along, -CGAL::cross_product(e1, along)}, 6, 3, -2.5, 0);
  // Paper 004, section 5.2; below t = 0.6 the radius is larger than the centre line's radius of curvature.
  const auto centre = [](const auto& t) {
    using T = std::decay_t<decltype(t)>;
    return std::array<T, 3>{t * t + T(8.0), t + T(7.0), T(2.0) - t};
  };
  const auto radius = [](const auto& t, const auto& u) {
    using std::cos;
    using std::sin;
    using T = std::decay_t<decltype(t)>;
    return t * t * sin(u) * sin(u) + cos(u) + T(2.0);
  };
  const Parametric_patch ringed = ringed_patch(centre, radius, Vector_3(0, 0, 1), 0.8, 2);
  Surface_blend_options options;
  options.sides[0].distance = options.sides[1].distance = 2.0;
  const Surface_blend blend = blend_of(Iso_curve_boundary(torus, 0), Iso_curve_boundary(ringed, 2), options);
  EXPECT_LT(worst_tangency(blend, 0,
                           [&](const Point_3& p) {
                             const Vector_3 d = p - middle, flat = d - (d * axis) * axis;
                             return d - 6 / std::sqrt(flat.squared_length()) * flat;
                           }),
            1e-7);
  const Blend_body body = make_blend_body({trimmed_patch(torus), trimmed_patch(ringed)}, {{blend, {0, 1}, {1, 1}}});
  expect_solid(body);
  for (const Face f : faces_of(body, Face_label::Kind::surface, 0))
    for (const std::size_t v : corners_of(body.mesh, f))
      EXPECT_NEAR(distance_to_torus(body.mesh.point(Vertex(v)), middle, axis, 6, 3), 0, 1e-12);
}

TEST(Surface_blend_body, Joins_a_mesh_to_a_quadric) {
  // A closed mesh, of which all above a ring of edges goes.
  const Blend_mesh mesh = test::cylinder(1.5, 20, -2, 2, 7);
  std::vector<Vertex> chain;
  for (const Vertex v : mesh.vertices())
    if (std::abs(mesh.point(v).z() - 1) < 1e-9 && std::hypot(mesh.point(v).x(), mesh.point(v).y()) > 1)
      chain.push_back(v);
  ASSERT_EQ(chain.size(), 20u);
  const auto angle = [&](Vertex v) { return std::atan2(mesh.point(v).y(), mesh.point(v).x()); };
  std::sort(chain.begin(), chain.end(), [&](Vertex v, Vertex w) { return angle(v) > angle(w); });
  const Quadric_3 cylinder = Quadric_3::cylinder({0, 0, 0}, {0, 0, 1}, 1);
  const Surface_blend blend = blend_of(Mesh_boundary(mesh, chain), section(cylinder, plane(0, 0, 1, -3)));
  const Blend_body body =
      make_blend_body({trimmed_mesh(mesh, {chain}), trimmed_quadric(cylinder, {plane(0, 0, 1, -5)})}, {{blend}});
  expect_solid(body);
  const std::set<Point_3> points(body.mesh.points().begin(), body.mesh.points().end());
  for (const Vertex v : mesh.vertices()) EXPECT_EQ(points.count(mesh.point(v)), mesh.point(v).z() < 1 + 1e-9 ? 1u : 0u);
  EXPECT_LT(worst_tangency(blend, 1, [](const Point_3& p) { return Vector_3(p.x(), p.y(), 0); }), 1e-7);
  for (const double s : blend.curve(0).fixed_parameters())
    EXPECT_LT(line_angle(blend.curve(0).at(s).normal, blend.normal(blend.parameter_map(0).inverse(s), 0)), 1e-7);
}

/// An ellipsoid and a cone with its apex, all coordinates times a factor.
Blend_body scaled_body(const Rational& scale) {
  const Rational q = scale * scale, none = 0;
  const Quadric_3 ellipsoid({1, 2, 3, none, none, none, none, none, none, -6 * q});
  const Quadric_3 cone({1, 2, -1, none, none, none, none, none, 12 * scale, -36 * q});  // apex at z = 6
  Surface_blend_options options;
  options.g2 = true;
  const auto level = [&](const Rational& z) { return Quadric_3::Plane{0, 0, 1, -z * scale}; };
  const Surface_blend blend = blend_of(section(ellipsoid, level(Rational(1) / 2)), section(cone, level(4)), options);
  return make_blend_body({trimmed_quadric(ellipsoid), trimmed_quadric(cone)}, {{blend}});
}

TEST(Surface_blend_body, Does_not_depend_on_the_scale) {
  const Blend_body unit_body = scaled_body(1);
  expect_solid(unit_body);
  for (const Rational& scale : {Rational(1) / 1024, Rational(1) / 1000, Rational(1000), Rational(1000000)}) {
    const double factor = CGAL::to_double(scale);
    SCOPED_TRACE(factor);
    const Blend_body body = scaled_body(scale);
    expect_solid(body);
    EXPECT_NEAR(volume_of(body.mesh) / (factor * factor * factor), volume_of(unit_body.mesh),
                1e-3 * volume_of(unit_body.mesh));
  }
}

TEST(Surface_blend_body, Is_the_same_on_every_run) { EXPECT_TRUE(identical(scaled_body(1).mesh, scaled_body(1).mesh)); }

TEST(Surface_blend_body, Converges_with_the_tolerance) {
  const Quadric_3 low = Quadric_3::sphere({0, 0, 0}, 1), high = Quadric_3::sphere({0, 0, 4}, 1);
  const Surface_blend blend = blend_of(section(low, plane(0, 0, 1, -0.6)), section(high, plane(0, 0, 1, -3.4)));
  std::vector<double> volumes;
  for (const double tolerance : {4e-3, 1e-3, 2.5e-4, 6.25e-5}) {
    Blend_body_options options;
    options.chord_tolerance = tolerance;
    const Blend_body body = make_blend_body({trimmed_quadric(low), trimmed_quadric(high)}, {{blend}}, options);
    expect_solid(body);
    volumes.push_back(volume_of(body.mesh));
  }
  // The error is of the order of the tolerance, so a quarter of it at every step.
  EXPECT_LT(std::abs(volumes[3] - volumes[2]), 0.5 * std::abs(volumes[1] - volumes[0]));
  // Both spheres less a cap of height 0.4 each, and the blend of revolution by its profile.
  double expected = 2 * (4. / 3 * pi_ - volume_of_cap(1, 0.4));
  for (int i = 0; i < 4000; ++i) {
    const double t = (i + 0.5) / 4000;
    const Point_3 p = blend.at(0, t);
    expected += pi_ * (p.x() * p.x() + p.y() * p.y()) * blend.column(0).derivative(t).z() / 4000;
  }
  EXPECT_NEAR(volumes[3], expected, 1e-3 * expected);
}

// A narrow cylinder over the middle of a wide cone, near by: the nearest way from its rim leads back over the cone.
TEST(Surface_blend_body, Leaves_wide_surfaces_outwards) {
  const Quadric_3 cone(std::array<double, 10>{1, 1, -16, 0, 0, 0, 0, 0, 0, 0});
  const Quadric_3 cylinder = Quadric_3::cylinder({0, 0, 0}, {0, 0, 1}, Rational(1) / 4);
  const Surface_blend blend = blend_of(section(cone, plane(0, 0, 1, -1)), section(cylinder, plane(0, 0, 1, -3)));
  EXPECT_GT(blend.direction(0, 0.3).z(), 0);
  expect_solid(make_blend_body({trimmed_quadric(cone), trimmed_quadric(cylinder, {plane(0, 0, 1, -5)})}, {{blend}}));
}

// Lengths of thousands of radii.
TEST(Surface_blend_body, Keeps_long_wires) {
  const Quadric_3 wire = Quadric_3::cylinder({0, 0, 0}, {0, 0, 1}, Rational(1) / 1000000),
                  ball = Quadric_3::sphere({0, 0, 0}, 1);
  const Surface_blend blend = blend_of(section(ball, plane(0, 0, 1, -0.9)), section(wire, plane(0, 0, 1, -2)));
  const Blend_body body =
      make_blend_body({trimmed_quadric(ball), trimmed_quadric(wire, {plane(0, 0, 1, -9)})}, {{blend}});
  expect_solid(body);
  for (const Face f : faces_of(body, Face_label::Kind::surface, 1))
    for (const std::size_t v : corners_of(body.mesh, f))
      EXPECT_NEAR(distance_to_axis(body.mesh.point(Vertex(v)), Point_3(0, 0, 0), Vector_3(0, 0, 1)), 1e-3, 1e-13);
}

// An open sheet: half of a cylinder in two parts, swept to planes, made a plate.
TEST(Surface_blend_body, Thickens_open_sheets) {
  const Quadric_3 cylinder = Quadric_3::cylinder({0, 0, 0}, {0, 0, 1}, 1);
  const auto arc = [&](double z) {
    const auto f = [z](const auto& s) {
      using std::cos;
      using std::sin;
      using T = std::decay_t<decltype(s)>;
      return std::array<T, 3>{cos(T(pi_) * s), sin(T(pi_) * s), T(z)};
    };
    return Implicit_boundary(implicit_function(cylinder), space_curve(f, false));
  };
  Surface_blend_options options;
  options.sides[0].distance = options.sides[1].distance = 0.5;
  const Surface_blend blend = blend_of(arc(0), arc(1.5), options);
  const auto swept = [&](const Quadric_3::Plane& p) { return swept_surface(implicit_function(cylinder), p); };
  const std::vector<Trimmed_surface> surfaces{swept(plane(0, 0, -1, -1)), swept(plane(0, 0, 1, -2.5))};
  const Blend_body sheet = make_blend_body(surfaces, {{blend}});
  ASSERT_TRUE(sheet.ok()) << message(sheet.diagnosis);
  EXPECT_FALSE(sheet.closed);
  EXPECT_NEAR(area_of(sheet.mesh), 3.5 * pi_, 0.01 * 3.5 * pi_);
  Blend_body_options plate;
  plate.thickness = 0.2;
  plate.chord_tolerance = 2e-4;
  const Blend_body body = make_blend_body(surfaces, {{blend}}, plate);
  expect_solid(body);
  EXPECT_NEAR(volume_of(body.mesh), 3.5 * pi_ * 0.2, 0.01 * 3.5 * pi_ * 0.2);
}

TEST(Surface_blend_body, Refuses_by_name) {
  const Quadric_3 cylinder = Quadric_3::cylinder({0, 0, 0}, {0, 0, 1}, 1);
  const Surface_blend blend = blend_of(section(cylinder, plane(0, 0, 1, 0)), section(cylinder, plane(0, 0, 1, -3)));
  const auto status = [&](const Trimmed_surface& a, const Trimmed_surface& b) {
    return make_blend_body({a, b}, {{blend}}).diagnosis.status;
  };
  const Trimmed_surface low = trimmed_quadric(cylinder, {plane(0, 0, -1, -2)});
  EXPECT_EQ(status(low, trimmed_quadric(cylinder)), Status::surface_not_bounded);
  EXPECT_EQ(status(trimmed_quadric(cylinder), trimmed_quadric(cylinder, {plane(0, 0, 1, -5)})),
            Status::surface_not_bounded);
  EXPECT_EQ(status(low, trimmed_quadric(cylinder, {plane(1, 0, 0.1, -0.3)})), Status::blend_collides);
}

}  // namespace
