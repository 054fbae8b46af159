// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/bridge.h>

#include "bridge_spheres.h"
#include "checks.h"

#include <cgal_blend/validate.h>

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

TEST(Bridge, makes_one_body_of_two) {
  const Two_spheres spheres;
  const Blend_mesh mesh = spheres.mesh(4);
  Blend_mesh out;
  const Bridge_outcome outcome = unchecked::bridge(mesh, spheres.ends(), out);
  ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
  const Validity_report report = validate(out);
  EXPECT_TRUE(report.ok()) << message(report.diagnosis);
  EXPECT_EQ(report.components, 1u);
  EXPECT_EQ(euler(out), 2);
  EXPECT_NEAR(outcome.volume, volume_of(out), 1e-12 * outcome.volume);
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

TEST(Bridge, raises_the_genus_by_a_handle) {
  const Blend_mesh ring = torus(1, 0.35, 96, 48);
  Blend_mesh out;
  const Bridge_outcome outcome = unchecked::bridge(ring, {end_at({0.65, 0, 0}, 0.2), end_at({-0.65, 0, 0}, 0.2)}, out);
  ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
  EXPECT_TRUE(validate(out).ok());
  EXPECT_EQ(validate(out).components, 1u);
  EXPECT_EQ(euler(out), -2);  // genus 2
}

TEST(Bridge, sees_the_bridges_made_before) {
  const Two_spheres spheres;
  const Blend_mesh mesh = spheres.mesh(4);
  const auto pair = [&](double angle) {
    Bridge bridge;
    bridge.ends = {
        end_at({std::sin(angle), 0, std::cos(angle)}, 0.2),
        end_at({spheres.second * std::sin(angle), 0, spheres.between - spheres.second * std::cos(angle)}, 0.2)};
    return bridge;
  };
  Blend_mesh out;
  const Bridge_outcome outcome = unchecked::bridge_all(mesh, {pair(0.6), pair(-0.6), pair(0)}, out);
  ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
  EXPECT_TRUE(validate(out).ok());
  EXPECT_EQ(euler(out), -2);  // three tubes between two spheres: genus 2
  ASSERT_EQ(outcome.bridge_faces.size(), 3u);
  std::set<Face> all;
  for (const auto& faces : outcome.bridge_faces) all.insert(faces.begin(), faces.end());
  EXPECT_EQ(all.size(),
            outcome.bridge_faces[0].size() + outcome.bridge_faces[1].size() + outcome.bridge_faces[2].size());
  for (std::size_t f = 0; f < outcome.kept_faces; ++f) EXPECT_EQ(all.count(Face(f)), 0u);

  const Bridge_outcome crossing = unchecked::bridge_all(mesh, {pair(0.6), pair(0.62)}, out);
  EXPECT_FALSE(crossing.ok());
  EXPECT_EQ(crossing.diagnosis.detail.rfind("bridge 2", 0), 0u) << crossing.diagnosis.detail;
  EXPECT_EQ(out.number_of_faces(), 0u);
}

TEST(Bridge, leaves_everything_beyond_the_contacts_as_it_is) {
  const Two_spheres spheres;
  const Blend_mesh mesh = spheres.mesh(4);
  Blend_mesh out;
  const Bridge_outcome outcome = unchecked::bridge(mesh, spheres.ends(), out);
  ASSERT_TRUE(outcome.ok());
  std::vector<Face> beyond;  // with all corners outside the contacts, by exact geodesics and a facet's sagitta
  for (const Face f : mesh.faces()) {
    bool outside = true;
    for (const std::size_t v : corners_of(mesh, f)) {
      const Vec p = vec(mesh.point(Vertex(static_cast<std::uint32_t>(v))));
      const int side = p.z() < 1.3 ? 0 : 1;
      const double r = side == 0 ? spheres.first : spheres.second;
      const double cosine = side == 0 ? p.z() / r : (spheres.between - p.z()) / r;
      outside = outside && r * std::acos(std::clamp(cosine, -1.0, 1.0)) > 1.02 * spheres.contact[side] + 0.1 * r;
    }
    if (outside) beyond.push_back(f);
  }
  EXPECT_GT(beyond.size(), mesh.number_of_faces() / 2);
  EXPECT_TRUE(faces_kept_in_order(mesh, out, beyond));
  ASSERT_EQ(outcome.origins.size(), out.number_of_faces());
  for (std::size_t f = 0; f < outcome.kept_faces; ++f) {
    const Face origin(outcome.origins[f]);
    const auto a = corners_of(mesh, origin), b = corners_of(out, Face(static_cast<std::uint32_t>(f)));
    for (int i = 0; i < 3; ++i)
      ASSERT_EQ(mesh.point(Vertex(static_cast<std::uint32_t>(a[i]))),
                out.point(Vertex(static_cast<std::uint32_t>(b[i]))));
  }
}

TEST(Bridge, does_not_depend_on_position_and_size) {
  const Two_spheres spheres;
  const Blend_mesh mesh = spheres.mesh(4);
  Blend_mesh out;
  const double volume = unchecked::bridge(mesh, spheres.ends(), out).volume;
  ASSERT_GT(volume, 0);
  for (const double scale : {1e-3, 1.0, 1e6}) {
    const Placement motion = placement({3, 1, 2}, 0.9, {5 * scale, -2 * scale, 7 * scale}, scale);
    auto ends = spheres.ends();
    for (Bridge_end& end : ends) {
      end.spot = motion.transform(end.spot);
      end.radius *= scale;
    }
    Blend_mesh moved;
    const Bridge_outcome outcome = unchecked::bridge(transformed(mesh, motion), ends, moved);
    ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
    EXPECT_NEAR(outcome.volume / (scale * scale * scale * volume), 1, 1e-4) << scale;
  }
}

TEST(Bridge, is_deterministic) {
  const Two_spheres spheres;
  Blend_mesh once, again;
  ASSERT_TRUE(unchecked::bridge(spheres.mesh(4), spheres.ends(), once).ok());
  ASSERT_TRUE(unchecked::bridge(spheres.mesh(4), spheres.ends(), again).ok());
  EXPECT_TRUE(identical(once, again));
}

TEST(Bridge, takes_all_curves_and_extremes_of_lambda) {
  const Two_spheres spheres;
  const Blend_mesh mesh = spheres.mesh(4);
  const std::vector<Polar_curve> curves{rectangle_curve(0.5, 0.3, 0.1), cross_curve(0.5, 0.2, 0.08),
                                        star_curve(0.4, 0.3, 5), ellipse_curve(0.6, 0.3),
                                        spline_curve({{0.3, 0}, {0.5, 2}, {0.4, 4}})};
  for (std::size_t i = 0; i < curves.size(); ++i)
    for (const double lambda : {0.0, 0.9}) {
      auto ends = spheres.ends();
      ends[0].curve = curves[i];
      ends[1].curve = curves[(i + 1) % curves.size()];
      ends[0].lambda = ends[1].lambda = lambda;
      Blend_mesh out;
      const Bridge_outcome outcome = unchecked::bridge(mesh, ends, out);
      ASSERT_TRUE(outcome.ok()) << i << ", lambda " << lambda << ": " << message(outcome.diagnosis);
      EXPECT_TRUE(validate(out).ok());
      EXPECT_EQ(euler(out), 2);
    }
}

TEST(Bridge, works_within_single_facets_and_across_sharp_edges) {
  const Blend_mesh boxes = side_by_side(box({-1, -1, -1}, {1, 1, 0}), box({-1, -1, 1}, {1, 1, 2}));
  for (const double radius : {0.1, 0.6}) {  // within one of the 12 faces; across its diagonal
    Blend_mesh out;
    const Bridge_outcome outcome =
        unchecked::bridge(boxes, {end_at({0.5, -0.3, 0}, radius), end_at({0.2, 0.1, 1}, radius)}, out);
    ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
    EXPECT_TRUE(validate(out).ok());
    EXPECT_EQ(euler(out), 2);
  }
  Blend_mesh out;  // around a corner of each
  const Blend_mesh apart = side_by_side(grid_box({-2, -2, -2}, {0, 0, 0}, 8), grid_box({1, 1, 1}, {3, 3, 3}, 8));
  const Bridge_outcome outcome = unchecked::bridge(apart, {end_at({0, 0, 0}, 0.6), end_at({1, 1, 1}, 0.6)}, out);
  ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
  EXPECT_EQ(euler(out), 2);
}

TEST(Bridge, takes_as_many_facets_as_it_is_told) {
  const Two_spheres spheres;
  Blend_mesh out;
  Bridge_options options;
  options.segments = 24;
  options.rows = 10;
  const Bridge_outcome outcome = unchecked::bridge(spheres.mesh(4), spheres.ends(), out, options);
  ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
  EXPECT_EQ(outcome.bridges[0].segments, 24u);
  EXPECT_EQ(outcome.bridges[0].rows, 10u);
  EXPECT_GT(outcome.bridge_faces[0].size(), 2u * 24 * 10);
}

}  // namespace
