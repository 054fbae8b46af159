// SPDX-License-Identifier: GPL-3.0-or-later
// Cross-sections of blends in the plane, against circles, lines and Bezier curves.
#include <cgal_blend/profile.h>

#include "shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace cgal_blend::test {
namespace {

using Point = std::array<double, 2>;
constexpr double ball = 7;  // radius

Point operator+(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1]}; }
Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1]}; }
Point operator*(double s, const Point& a) { return {s * a[0], s * a[1]}; }
double cross(const Point& a, const Point& b) { return a[0] * b[1] - a[1] * b[0]; }
double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1]; }
double norm(const Point& a) { return std::hypot(a[0], a[1]); }
double angle_deg(const Point& a, const Point& b) { return std::atan2(std::abs(cross(a, b)), dot(a, b)) * 180 / pi; }

/// The ball about a centre that is not the origin, contacts at angles 0 and `angle`; the tangents meet in the apex.
struct Section {
  explicit Section(double angle, std::array<double, 2> curvature = {0, 0}) : frame{angle, curvature} {}
  Profile_frame frame;
  Point centre{3, -2};
  [[nodiscard]] Point on_ball(double angle) const { return centre + ball * Point{std::cos(angle), std::sin(angle)}; }
  [[nodiscard]] Point contact_1() const { return on_ball(0); }
  [[nodiscard]] Point contact_2() const { return on_ball(frame.angle); }
  [[nodiscard]] Point apex() const {
    return centre + ball / std::cos(frame.angle / 2) * Point{std::cos(frame.angle / 2), std::sin(frame.angle / 2)};
  }
  [[nodiscard]] Point at(const Profile& profile, double u) const {
    const Profile_point p = profile(u, frame);
    return p.centre * centre + p.contact_1 * contact_1() + p.apex * apex() + p.contact_2 * contact_2();
  }
  /// Same, from the end.
  [[nodiscard]] Point from(int end, const Profile& profile, double u) const {
    return at(profile, end == 0 ? u : 1 - u);
  }

  /// Angle between the profile's end and the tangent there, degrees.
  [[nodiscard]] double off_tangent(int end, const Profile& profile) const {
    const Point contact = end == 0 ? contact_1() : contact_2();
    return angle_deg(from(end, profile, 1e-5) - contact, apex() - contact);
  }

  /// Curvature at an end times the radius; positive towards the centre. One-sided differences, extrapolated.
  [[nodiscard]] double end_curvature(int end, const Profile& profile) const {
    const auto rough = [&](double h) {
      const Point a = from(end, profile, 0), b = from(end, profile, h), c = from(end, profile, 2 * h),
                  d = from(end, profile, 3 * h);
      const Point first = 1 / (6 * h) * (18.0 * b - 11.0 * a - 9.0 * c + 2.0 * d);
      const Point second = 1 / (h * h) * (2.0 * a - 5.0 * b + 4.0 * c - d);
      return (end == 0 ? 1 : -1) * cross(first, second) / std::pow(norm(first), 3) * ball;
    };
    return (4 * rough(1e-3) - rough(2e-3)) / 3;
  }
};

const std::vector<double> angles = [] {
  std::vector<double> radians;
  for (int degrees = 30; degrees <= 170; degrees += 10) radians.push_back(degrees * pi / 180);
  return radians;
}();

std::vector<double> parameters() {
  std::vector<double> u;
  for (int k = 0; k <= 40; ++k) u.push_back(k / 40.0);
  return u;
}

/// Control points that lie on the tangents next to the ends.
const std::vector<Point> tangent_points{{0, 0}, {0.4, 0}, {0.8, 0.1}, {1, 0.7}, {1, 1}};

struct Named {
  std::string name;
  Profile profile;
};

std::vector<Named> tangent_profiles() {
  return {{"arc", Arc_profile()},
          {"conic 0.3", Conic_profile{0.3}},
          {"conic 2", Conic_profile{2}},
          {"Hermite", Hermite_profile()},
          {"Hermite 0.5 2.5", Hermite_profile{0.5, 2.5}},
          {"B-spline", Bspline_profile(tangent_points)},
          {"B-spline of degree 2", Bspline_profile(tangent_points, 2)},
          {"G2", G2_profile()},
          {"G2 0.2 0.9", G2_profile{0.2, 0.9}}};
}

std::vector<Named> all_profiles() {
  std::vector<Named> all = tangent_profiles();
  all.push_back({"chamfer", chamfer_profile()});
  all.push_back({"sharp", sharp_profile()});
  all.push_back({"polyline", Bspline_profile(tangent_points, 1)});
  return all;
}

TEST(Profile, EndsAtTheContactsInAffineCoordinates) {
  for (const auto& [name, profile] : all_profiles())
    for (const double angle : angles) {
      const Section section(angle, {0.4, -0.7});
      EXPECT_LT(norm(section.at(profile, 0) - section.contact_1()), 1e-12 * ball) << name << angle;
      EXPECT_LT(norm(section.at(profile, 1) - section.contact_2()), 1e-12 * ball) << name << angle;
      for (const double u : parameters()) {
        const Profile_point p = profile(u, section.frame);
        EXPECT_NEAR(p.centre + p.contact_1 + p.apex + p.contact_2, 1, 1e-13) << name << angle << ' ' << u;
      }
    }
}

TEST(Profile, ArcIsTheCircleAtEvenAngles) {
  for (const double angle : angles) {
    const Section section(angle);
    for (const double u : parameters())
      EXPECT_LT(norm(section.at(Arc_profile(), u) - section.on_ball(u * angle)), 1e-12 * ball) << angle;
  }
  // Hardly bent at all.
  const Section flat(1e-10);
  EXPECT_LT(norm(flat.at(Arc_profile(), 0.3) - flat.on_ball(0.3e-10)), 1e-14 * ball);
}

TEST(Profile, ConicOfTheRightWeightIsTheCircle) {
  for (const double angle : angles) {
    const Section section(angle);
    for (const double u : parameters())
      EXPECT_NEAR(norm(section.at(Conic_profile{std::cos(angle / 2)}, u) - section.centre), ball, 1e-12 * ball);
    EXPECT_GT(std::abs(norm(section.at(Conic_profile{0.9 * std::cos(angle / 2)}, 0.5) - section.centre) - ball),
              1e-4 * ball);
  }
}

TEST(Profile, ChamferIsTheChordAndSharpTheCorner) {
  for (const double angle : angles) {
    const Section section(angle);
    for (const double u : parameters()) {
      const Profile_point chord = chamfer_profile()(u, section.frame), corner = sharp_profile()(u, section.frame);
      EXPECT_EQ(chord.centre, 0);
      EXPECT_EQ(chord.apex, 0);
      EXPECT_TRUE(chord.contact_1 >= 0 && chord.contact_2 >= 0);
      EXPECT_EQ(corner.centre, 0);
      EXPECT_EQ(u < 0.5 ? corner.contact_2 : corner.contact_1, 0);
      EXPECT_TRUE(corner.contact_1 >= 0 && corner.contact_2 >= 0 && corner.apex >= 0);
    }
    EXPECT_EQ(sharp_profile()(0.5, section.frame).apex, 1);
  }
  EXPECT_EQ(Profile(sharp_profile()).kinks(), std::vector{0.5});
  EXPECT_TRUE(Profile(chamfer_profile()).kinks().empty());
  EXPECT_TRUE(Profile(Conic_profile{1e9}).kinks().empty());
}

TEST(Profile, HeavierConicsComeNearerToTheCorner) {
  for (const double angle : angles) {
    const Section section(angle);
    const double whole = norm(section.at(chamfer_profile(), 0.5) - section.apex());
    double last = whole;
    for (double weight = 0.1; weight < 1e7; weight *= 10) {
      const double left = norm(section.at(Conic_profile{weight}, 0.5) - section.apex());
      EXPECT_LT(left, last);
      EXPECT_NEAR(left, whole / (1 + weight), 1e-9 * whole);  // of the way from the apex to the chord
      last = left;
    }
    EXPECT_LT(last, 1e-6 * whole);
  }
}

TEST(Profile, IsTangentToPlanarNeighbours) {
  for (const auto& [name, profile] : tangent_profiles())
    for (const double angle : angles)
      for (const int end : {0, 1}) EXPECT_LT(Section(angle).off_tangent(end, profile), 0.5) << name << angle;
  // And those that are not are seen to be not: a chord makes half the angle with the tangents.
  for (const double angle : angles)
    for (const int end : {0, 1})
      EXPECT_NEAR(Section(angle).off_tangent(end, chamfer_profile()), angle / 2 * 180 / pi, 0.01);
}

TEST(Profile, G2ContinuesTheCurvature) {
  const std::vector<std::array<double, 2>> curvatures{{0, 0}, {1, 1}, {0.5, -0.3}, {-2, 0.7}};
  for (const double angle : angles)
    for (const int end : {0, 1}) {
      EXPECT_NEAR(Section(angle).end_curvature(end, Arc_profile()), 1, 1e-3) << "the measure itself";
      for (const G2_profile& profile : {G2_profile(), G2_profile{0.25, 0.7}})
        for (const auto& curvature : curvatures) {
          const double expected = curvature[end];
          EXPECT_NEAR(Section(angle, curvature).end_curvature(end, profile), expected,
                      std::max(0.01, 0.02 * std::abs(expected)))
              << angle << ' ' << end;
          EXPECT_LT(Section(angle, curvature).off_tangent(end, profile), 0.5);
        }
    }
}

TEST(Profile, HermiteComesNearTheArc) {
  const Section section(pi / 2);
  for (const double u : parameters()) {
    EXPECT_NEAR(norm(section.at(Hermite_profile(), u) - section.centre), ball, 2e-3 * ball);
    EXPECT_NEAR(norm(section.at(Hermite_profile{1.657, 1.657}, u) - section.centre), ball, 3e-4 * ball);
  }
}

/// The same seen from the other contact.
Profile_point mirrored(const Profile_point& p) { return {p.centre, p.contact_2, p.apex, p.contact_1}; }

void expect_equal(const Profile_point& a, const Profile_point& b, const std::string& where) {
  EXPECT_NEAR(a.centre, b.centre, 1e-13) << where;
  EXPECT_NEAR(a.contact_1, b.contact_1, 1e-13) << where;
  EXPECT_NEAR(a.apex, b.apex, 1e-13) << where;
  EXPECT_NEAR(a.contact_2, b.contact_2, 1e-13) << where;
}

TEST(Profile, IsSymmetricWhereItsParametersAre) {
  const std::vector<Named> symmetric{{"arc", Arc_profile()},
                                     {"conic", Conic_profile{0.8}},
                                     {"chamfer", chamfer_profile()},
                                     {"sharp", sharp_profile()},
                                     {"Hermite", Hermite_profile()},
                                     {"G2", G2_profile()},
                                     {"B-spline", Bspline_profile({{0, 0}, {0.3, 0}, {0.8, 0.2}, {1, 0.7}, {1, 1}})}};
  for (const auto& [name, profile] : symmetric)
    for (const double angle : angles)
      for (const double u : parameters()) {
        const Profile_frame one{angle, {0.3, -0.2}}, other{angle, {-0.2, 0.3}};
        expect_equal(profile(u, one), mirrored(profile(1 - u, other)), name);
      }
  for (const double u : parameters())
    expect_equal(Hermite_profile{0.5, 2}(u, {1, {}}), mirrored(Hermite_profile{2, 0.5}(1 - u, {1, {}})), "Hermite");
}

TEST(Profile, BsplineKnowsWhatItCanBeMadeOf) {
  const double nan = std::nan("");
  EXPECT_TRUE(Bspline_profile::is_valid({{0, 0}, {1, 1}}, 1));
  EXPECT_TRUE(Bspline_profile::is_valid(tangent_points, 4));
  EXPECT_FALSE(Bspline_profile::is_valid(tangent_points, 5));
  EXPECT_FALSE(Bspline_profile::is_valid(tangent_points, 0));
  EXPECT_FALSE(Bspline_profile::is_valid({{0, 0}}, 1));
  EXPECT_FALSE(Bspline_profile::is_valid({}, 1));
  EXPECT_FALSE(Bspline_profile::is_valid({{0, 0.1}, {0.5, 0.5}, {1, 1}}, 1));
  EXPECT_FALSE(Bspline_profile::is_valid({{0, 0}, {0.5, 0.5}, {1, 0.9}}, 1));
  EXPECT_FALSE(Bspline_profile::is_valid({{0, 0}, {nan, 0.5}, {1, 1}}, 1));
}

/// Point of a profile in the frame P1 + x (P0 - P1) + y (P2 - P0).
Point in_frame(const Profile_point& p) { return {1 - p.contact_1, p.contact_2}; }

TEST(Profile, BsplineOfFullDegreeIsABezierCurve) {
  for (const auto& points : {tangent_points, {{0, 0}, {2, -1}, {-0.5, 3}, {1, 1}}, {{0, 0}, {1, 0}, {1, 1}}}) {
    const Bspline_profile profile(points, points.size() - 1);
    for (const double u : parameters()) {
      const std::size_t n = points.size() - 1;
      Point bezier{0, 0};
      double binomial = 1;
      for (std::size_t k = 0; k <= n; ++k) {  // Bernstein polynomials
        bezier = bezier + binomial * std::pow(u, k) * std::pow(1 - u, n - k) * points[k];
        binomial *= static_cast<double>(n - k) / static_cast<double>(k + 1);
      }
      EXPECT_LT(norm(in_frame(profile(u, {1, {}})) - bezier), 1e-13);
    }
  }
}

TEST(Profile, BsplineOfSeveralSpansHasItsKnotsEvenlySpaced) {
  const std::vector<Point> points{{0, 0}, {0.5, -0.2}, {0.6, 0.4}, {1.2, 0.9}, {1, 1}};
  // By knot insertion at 1/2, the middle of the parameters.
  const Point cubic = 0.25 * (points[1] + 2.0 * points[2] + points[3]);
  EXPECT_LT(norm(in_frame(Bspline_profile(points, 3)(0.5, {1, {}})) - cubic), 1e-14);
  const Bspline_profile quadratic(points, 2);
  for (const std::size_t k : {1, 2})
    EXPECT_LT(norm(in_frame(quadratic(k / 3.0, {1, {}})) - 0.5 * (points[k] + points[k + 1])), 1e-14);
  // Once continuously differentiable at its knots.
  for (const double knot : {1 / 3.0, 2 / 3.0}) {
    const auto at = [&](double u) { return in_frame(quadratic(u, {1, {}})); };
    const double h = 1e-6;
    EXPECT_LT(norm((at(knot + h) - at(knot)) - (at(knot) - at(knot - h))), 1e-4 * norm(at(knot + h) - at(knot)));
  }
}

TEST(Profile, BsplineOfDegreeOneIsAPolylineWithKinks) {
  const Profile profile = Bspline_profile(tangent_points, 1);
  ASSERT_EQ(profile.kinks().size(), tangent_points.size() - 2);
  for (std::size_t k = 0; k < profile.kinks().size(); ++k)
    EXPECT_LT(norm(in_frame(profile(profile.kinks()[k], {1, {}})) - tangent_points[k + 1]), 1e-14);
  EXPECT_LT(norm(in_frame(profile(0.375, {1, {}})) - 0.5 * (tangent_points[1] + tangent_points[2])), 1e-14);
  EXPECT_TRUE(Profile(Bspline_profile(tangent_points, 2)).kinks().empty());
  EXPECT_TRUE(Profile(Bspline_profile({{0, 0}, {1, 1}}, 1)).kinks().empty());
}

/// Users' own: a smooth one, and one whose corners are in no order.
struct Parabola {
  Profile_point operator()(double u, const Profile_frame&) const {
    return {0, (1 - u) * (1 - u), 2 * u * (1 - u), u * u};
  }
};
struct Two_steps {
  double first, second;
  Profile_point operator()(double u, const Profile_frame&) const { return {0, 1 - u, 0, u}; }
  [[nodiscard]] std::vector<double> kinks() const { return {second, first, second}; }
};

TEST(Profile, TakesAnyModel) {
  const Profile parabola = Parabola();
  for (const double u : parameters())
    expect_equal(parabola(u, {1, {}}), Conic_profile{1}(u, {1, {}}), "a conic of weight 1");
  EXPECT_TRUE(parabola.kinks().empty());
  EXPECT_FALSE(parabola.is_arc() || parabola.is_sharp());
  EXPECT_EQ(Profile(Two_steps{0.25, 0.75}).kinks(), (std::vector{0.25, 0.75})) << "in order, each once";
}

TEST(Profile, KnowsTheArcAndTheCorner) {
  EXPECT_TRUE(Profile().is_arc());
  EXPECT_FALSE(Profile().is_sharp());
  EXPECT_TRUE(Profile(sharp_profile()).is_sharp());
  EXPECT_FALSE(Profile(chamfer_profile()).is_sharp());
  EXPECT_FALSE(Profile(Conic_profile{std::cos(pi / 4)}).is_arc());
  const Profile copy = Profile(sharp_profile());  // and copies do
  EXPECT_TRUE(copy.is_sharp());
}

}  // namespace
}  // namespace cgal_blend::test
