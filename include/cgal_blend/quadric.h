// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_QUADRIC_H
#define CGAL_BLEND_QUADRIC_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpq.h>

#include <array>

namespace cgal_blend {

/// Rigid motion x -> R x + t with an exactly orthogonal rational R, determinant 1.
class Rational_motion {
 public:
  using Rational = CGAL::Gmpq;
  using Vector = std::array<Rational, 3>;

  /// The identity.
  Rational_motion();
  /// \param quaternion (w, x, y, z), not all 0, of any length: the rotation v -> q v / q
  /// \param translation length units
  explicit Rational_motion(const std::array<Rational, 4>& quaternion, const Vector& translation = {});

  /// Returns an exact motion whose rotation is within about 1e-15 of the given one.
  /// \param rotation rows of a rotation matrix in doubles, right to 1e-6; what is not orthogonal about it is dropped
  /// \param translation length units, taken exactly
  [[nodiscard]] static Rational_motion nearest(const std::array<std::array<double, 3>, 3>& rotation,
                                               const std::array<double, 3>& translation = {0, 0, 0});

  [[nodiscard]] const std::array<Vector, 3>& rotation() const { return rotation_; }  ///< rows
  [[nodiscard]] const Vector& translation() const { return translation_; }

 private:
  std::array<Vector, 3> rotation_;
  Vector translation_;
};

/// What a quadric is in real affine space.
enum class Quadric_type {
  ellipsoid,
  one_sheeted_hyperboloid,
  two_sheeted_hyperboloid,
  elliptic_paraboloid,
  hyperbolic_paraboloid,
  cone,
  elliptic_cylinder,
  hyperbolic_cylinder,
  parabolic_cylinder,
  intersecting_planes,
  parallel_planes,
  double_plane,
  plane,
  line,
  point,
  empty
};

/// Returns the type in words, e.g. "elliptic cylinder".
[[nodiscard]] const char* describe(Quadric_type type) noexcept;

/// Quadric with exact rational coefficients: the points where a polynomial of degree 2 or 1 vanishes.
class Quadric_3 {
 public:
  using Rational = CGAL::Gmpq;
  using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  using Vector_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Vector_3;
  using Vector = std::array<Rational, 3>;
  /// Factors of x^2, y^2, z^2, xy, xz, yz, x, y, z, 1.
  using Coefficients = std::array<Rational, 10>;
  using Plane = std::array<Rational, 4>;  ///< a x + b y + c z + d = 0

  /// Not all coefficients may be 0.
  explicit Quadric_3(const Coefficients& coefficients);
  /// Takes finite doubles as the rational numbers that they are; not all may be 0.
  explicit Quadric_3(const std::array<double, 10>& coefficients);

  [[nodiscard]] static Quadric_3 plane(const Plane& p);
  /// The union of two planes.
  [[nodiscard]] static Quadric_3 planes(const Plane& p, const Plane& q);
  [[nodiscard]] static Quadric_3 sphere(const Vector& centre, const Rational& squared_radius);
  /// \param axis not 0, of any length
  [[nodiscard]] static Quadric_3 cylinder(const Vector& point, const Vector& axis, const Rational& squared_radius);
  /// \param axis not 0, of any length
  /// \param squared_slope of the radius along the axis: the squared tangent of half the opening angle
  [[nodiscard]] static Quadric_3 cone(const Vector& apex, const Vector& axis, const Rational& squared_slope);

  [[nodiscard]] const Coefficients& coefficients() const { return coefficients_; }
  /// Returns the type, decided exactly by rank and inertia.
  [[nodiscard]] Quadric_type type() const;
  /// Returns the rank of the symmetric 4 x 4 matrix, 1 to 4.
  [[nodiscard]] int rank() const;
  /// Returns the numbers of positive and of negative squares of the 4 x 4 matrix.
  [[nodiscard]] std::array<int, 2> inertia() const;
  /// Returns the quadric moved, exactly.
  [[nodiscard]] Quadric_3 transformed(const Rational_motion& motion) const;

  /// Returns the polynomial's value in doubles.
  [[nodiscard]] double value(const Point_3& p) const;
  /// Returns the polynomial's gradient in doubles.
  [[nodiscard]] Vector_3 gradient(const Point_3& p) const;

 private:
  Coefficients coefficients_;
  std::array<double, 10> rounded_;  // times a power of two, so that the largest is about 1
};

}  // namespace cgal_blend

#endif
