// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/quadric.h>

#include "quadric_matrix.h"

#include <CGAL/assertions.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace cgal_blend {

namespace {

using Rational = CGAL::Gmpq;
using Vector = Quadric_3::Vector;

Rational dot(const Vector& x, const Vector& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; }

Quadric_3::Coefficients taken_exactly(const std::array<double, 10>& coefficients) {
  Quadric_3::Coefficients result;
  for (std::size_t k = 0; k < 10; ++k) {
    CGAL_precondition(std::isfinite(coefficients[k]));
    result[k] = Rational(coefficients[k]);
  }
  return result;
}

// Coefficients of (x - centre)^T m (x - centre) - constant for a symmetric m.
Quadric_3 centred(const std::array<Vector, 3>& m, const Vector& centre, const Rational& constant) {
  Vector image;
  for (std::size_t i = 0; i < 3; ++i) image[i] = dot(m[i], centre);
  return Quadric_3({m[0][0], m[1][1], m[2][2], 2 * m[0][1], 2 * m[0][2], 2 * m[1][2], -2 * image[0], -2 * image[1],
                    -2 * image[2], dot(centre, image) - constant});
}

// The squared length of the axis times the identity, minus `factor` times the square of the axis.
std::array<Vector, 3> about_axis(const Vector& axis, const Rational& factor) {
  const Rational length = dot(axis, axis);
  CGAL_precondition(length != 0);
  std::array<Vector, 3> m;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) m[i][j] = (i == j ? length : Rational(0)) - factor * axis[i] * axis[j];
  return m;
}

Quadric_type type_of_rank_4(const Diagonal_form& whole, const Diagonal_form& part) {
  const bool is_ruled = whole.positive == 2;
  if (whole.is_definite()) return Quadric_type::empty;
  if (part.rank < 3) return is_ruled ? Quadric_type::hyperbolic_paraboloid : Quadric_type::elliptic_paraboloid;
  if (is_ruled) return Quadric_type::one_sheeted_hyperboloid;
  return part.is_definite() ? Quadric_type::ellipsoid : Quadric_type::two_sheeted_hyperboloid;
}

Quadric_type type_of_rank_3(bool is_definite, const Diagonal_form& part) {
  if (part.rank == 3) return is_definite ? Quadric_type::point : Quadric_type::cone;
  if (is_definite) return Quadric_type::empty;
  if (part.rank == 1) return Quadric_type::parabolic_cylinder;
  return part.positive == 1 ? Quadric_type::hyperbolic_cylinder : Quadric_type::elliptic_cylinder;
}

Quadric_type type_of_rank_2(bool is_definite, std::size_t part) {
  if (part == 2) return is_definite ? Quadric_type::line : Quadric_type::intersecting_planes;
  if (part == 1) return is_definite ? Quadric_type::empty : Quadric_type::parallel_planes;
  return Quadric_type::plane;
}

}  // namespace

Rational_motion::Rational_motion() : Rational_motion({Rational(1), Rational(0), Rational(0), Rational(0)}) {}

Rational_motion::Rational_motion(const std::array<Rational, 4>& quaternion, const Vector& translation)
    : translation_(translation) {
  const auto& [w, x, y, z] = quaternion;
  const Rational n = w * w + x * x + y * y + z * z;
  CGAL_precondition(n != 0);
  rotation_ = {Vector{(w * w + x * x - y * y - z * z) / n, 2 * (x * y - w * z) / n, 2 * (x * z + w * y) / n},
               Vector{2 * (x * y + w * z) / n, (w * w - x * x + y * y - z * z) / n, 2 * (y * z - w * x) / n},
               Vector{2 * (x * z - w * y) / n, 2 * (y * z + w * x) / n, (w * w - x * x - y * y + z * z) / n}};
}

Rational_motion Rational_motion::nearest(const std::array<std::array<double, 3>, 3>& rotation,
                                         const std::array<double, 3>& translation) {
  Eigen::Matrix3d m;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) m(i, j) = rotation[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  const Eigen::Quaterniond q(m);
  Vector exact;
  for (std::size_t i = 0; i < 3; ++i) exact[i] = Rational(translation[i]);
  return Rational_motion({Rational(q.w()), Rational(q.x()), Rational(q.y()), Rational(q.z())}, exact);
}

Quadric_3::Quadric_3(const Coefficients& coefficients) : coefficients_(coefficients) {
  Rational largest(0);
  for (const Rational& a : coefficients_) largest = std::max(largest, a < 0 ? Rational(-a) : a);
  CGAL_precondition(largest != 0);
  for (std::size_t k = 0; k < 10; ++k)
    rounded_[k] = static_cast<double>(Real(to_real(coefficients_[k]) / to_real(largest)));
}

Quadric_3::Quadric_3(const std::array<double, 10>& coefficients) : Quadric_3(taken_exactly(coefficients)) {}

Quadric_3 Quadric_3::plane(const Plane& p) {
  const Rational zero(0);
  return Quadric_3(Coefficients{zero, zero, zero, zero, zero, zero, p[0], p[1], p[2], p[3]});
}

Quadric_3 Quadric_3::planes(const Plane& p, const Plane& q) {
  const auto pair = [&](std::size_t i, std::size_t j) { return Rational(p[i] * q[j] + p[j] * q[i]); };
  return Quadric_3(Coefficients{p[0] * q[0], p[1] * q[1], p[2] * q[2], pair(0, 1), pair(0, 2), pair(1, 2), pair(0, 3),
                                pair(1, 3), pair(2, 3), p[3] * q[3]});
}

Quadric_3 Quadric_3::sphere(const Vector& centre, const Rational& squared_radius) {
  const Rational zero(0), one(1);
  return centred({Vector{one, zero, zero}, Vector{zero, one, zero}, Vector{zero, zero, one}}, centre, squared_radius);
}

Quadric_3 Quadric_3::cylinder(const Vector& point, const Vector& axis, const Rational& squared_radius) {
  return centred(about_axis(axis, 1), point, squared_radius * dot(axis, axis));
}

Quadric_3 Quadric_3::cone(const Vector& apex, const Vector& axis, const Rational& squared_slope) {
  return centred(about_axis(axis, squared_slope + 1), apex, 0);
}

Quadric_type Quadric_3::type() const {
  const Surd_matrix m = quadric_matrix(*this);
  const Diagonal_form whole = diagonalize(m);
  Surd_matrix part = m;
  part.pop_back();
  for (Surd_vector& row : part) row.pop_back();
  const Diagonal_form affine = diagonalize(part);
  const bool has_one_sign = whole.positive == 0 || whole.negative == 0;
  if (whole.rank == 4) return type_of_rank_4(whole, affine);
  if (whole.rank == 3) return type_of_rank_3(has_one_sign, affine);
  if (whole.rank == 2) return type_of_rank_2(has_one_sign, affine.rank);
  return affine.rank == 1 ? Quadric_type::double_plane : Quadric_type::empty;
}

int Quadric_3::rank() const { return static_cast<int>(diagonalize(quadric_matrix(*this)).rank); }

std::array<int, 2> Quadric_3::inertia() const {
  const Diagonal_form form = diagonalize(quadric_matrix(*this));
  return {static_cast<int>(form.positive), static_cast<int>(form.negative)};
}

Quadric_3 Quadric_3::transformed(const Rational_motion& motion) const {
  // The columns of m take a new point (x, y, z, 1) to the old one, R^T (x - t).
  Surd_matrix m(4, Surd_vector(4));
  const auto& rotation = motion.rotation();
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) m[j][i] = Surd(rotation[j][i]);
    Rational shift(0);
    for (std::size_t j = 0; j < 3; ++j) shift -= rotation[j][i] * motion.translation()[j];
    m[3][i] = Surd(shift);
  }
  m[3][3] = 1;
  return Quadric_3(coefficients_of(restricted(quadric_matrix(*this), m)));
}

double Quadric_3::value(const Point_3& p) const {
  const double x = p.x(), y = p.y(), z = p.z();
  const auto& c = rounded_;
  return (c[0] * x + c[3] * y + c[4] * z + c[6]) * x + (c[1] * y + c[5] * z + c[7]) * y + (c[2] * z + c[8]) * z + c[9];
}

Quadric_3::Vector_3 Quadric_3::gradient(const Point_3& p) const {
  const double x = p.x(), y = p.y(), z = p.z();
  const auto& c = rounded_;
  return {2 * c[0] * x + c[3] * y + c[4] * z + c[6], c[3] * x + 2 * c[1] * y + c[5] * z + c[7],
          c[4] * x + c[5] * y + 2 * c[2] * z + c[8]};
}

const char* describe(Quadric_type type) noexcept {
  switch (type) {
    case Quadric_type::ellipsoid: return "ellipsoid";
    case Quadric_type::one_sheeted_hyperboloid: return "one-sheeted hyperboloid";
    case Quadric_type::two_sheeted_hyperboloid: return "two-sheeted hyperboloid";
    case Quadric_type::elliptic_paraboloid: return "elliptic paraboloid";
    case Quadric_type::hyperbolic_paraboloid: return "hyperbolic paraboloid";
    case Quadric_type::cone: return "cone";
    case Quadric_type::elliptic_cylinder: return "elliptic cylinder";
    case Quadric_type::hyperbolic_cylinder: return "hyperbolic cylinder";
    case Quadric_type::parabolic_cylinder: return "parabolic cylinder";
    case Quadric_type::intersecting_planes: return "intersecting planes";
    case Quadric_type::parallel_planes: return "parallel planes";
    case Quadric_type::double_plane: return "double plane";
    case Quadric_type::plane: return "plane";
    case Quadric_type::line: return "line";
    case Quadric_type::point: return "point";
    case Quadric_type::empty: return "empty";
  }
  return "unknown";
}

}  // namespace cgal_blend
