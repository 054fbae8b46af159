// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_PROJECTIVE_CURVE_H
#define CGAL_BLEND_PROJECTIVE_CURVE_H

#include "binary_form.h"
#include "dual.h"

#include <array>
#include <vector>

namespace cgal_blend {

/// Point or plane of projective space, (x, y, z, w).
template <class NT>
using Projective = std::array<NT, 4>;

/// A closed curve in projective space with the projective line (c, s) for its parameter.
class Projective_curve {
 public:
  virtual ~Projective_curve() = default;

  /// Evaluates the curve at (c, s), of any length, with derivative.
  [[nodiscard]] virtual Projective<Dual<long double>> at(const Dual<long double>& c,
                                                         const Dual<long double>& s) const = 0;
  [[nodiscard]] virtual Projective<Dual<Real>> at(const Dual<Real>& c, const Dual<Real>& s) const = 0;

  /// Returns where the curve meets a plane, as far as the precision tells.
  [[nodiscard]] virtual std::vector<Direction> meets_plane(const Projective<Real>& plane) const = 0;
};

/// Curve with coordinates that are binary forms of one degree.
class Rational_curve : public Projective_curve {
 public:
  /// \param coefficients points; the k-th is the factor of c^(n - k) s^k
  explicit Rational_curve(const std::vector<Projective<Real>>& coefficients);

  [[nodiscard]] Projective<Dual<long double>> at(const Dual<long double>& c, const Dual<long double>& s) const override;
  [[nodiscard]] Projective<Dual<Real>> at(const Dual<Real>& c, const Dual<Real>& s) const override;
  [[nodiscard]] std::vector<Direction> meets_plane(const Projective<Real>& plane) const override;

 private:
  std::vector<Projective<Real>> coefficients_;
  std::vector<Projective<long double>> rounded_;
};

/// A doubly ruled quadric, u0 v0 p + u0 v1 d1 + u1 v0 d2 + u1 v1 q, cut by another: a v0^2 + 2 b v0 v1 + c v1^2 = 0 with
/// quadratic forms a, b, c in u; rulings of constant u meet the curve where the discriminant b^2 - a c is not negative.
template <class NT>
struct Ruled_section {
  Projective<NT> p, d1, d2, q;
  std::array<NT, 3> a, b, c;
};

/// One loop of a smooth quartic on a doubly ruled quadric.
class Quartic_loop : public Projective_curve {
 public:
  /// The loop that meets every ruling once; the discriminant is positive everywhere. (c, s) is u but for an affine map.
  /// \param sheet 1 or -1: the sign of the root
  Quartic_loop(const Ruled_section<Real>& section, int sheet);
  /// The loop over the rulings u = c^2 begin + s^2 k end with a constant k, where the discriminant is positive between its roots `begin` and
  /// `end`, and [begin, end] > 0; c s has the sign of the root.
  Quartic_loop(const Ruled_section<Real>& section, const Direction& begin, const Direction& end);

  [[nodiscard]] Projective<Dual<long double>> at(const Dual<long double>& c, const Dual<long double>& s) const override;
  [[nodiscard]] Projective<Dual<Real>> at(const Dual<Real>& c, const Dual<Real>& s) const override;
  [[nodiscard]] std::vector<Direction> meets_plane(const Projective<Real>& plane) const override;

  /// True if the ruling u, known to meet the curve, meets this loop.
  [[nodiscard]] bool is_between(const Direction& u) const;

  /// Returns the parameter of the point on the ruling u in the sheet of sign `sheet`, 0 if both sheets meet there;
  /// nothing if the point is on another loop.
  [[nodiscard]] std::vector<Direction> parameter_of(const Direction& u, int sheet) const;

 private:
  // In NT: the section, the ends of the interval, and what is left of the discriminant without these roots.
  template <class NT>
  struct Data {
    Ruled_section<NT> section;
    std::array<NT, 2> begin, end;
    std::vector<NT> rest;
    NT extent;  // [begin, end]
  };
  template <class NT>
  [[nodiscard]] Projective<Dual<NT>> evaluate(const Data<NT>& data, const Dual<NT>& c, const Dual<NT>& s) const;
  void round();

  int sheet_ = 0;  // 0: the loop has both
  Data<Real> exact_;
  Data<long double> rounded_;
};

/// Returns b^2 - a c, a quartic form.
[[nodiscard]] std::vector<Real> discriminant(const Ruled_section<Real>& section);

/// Returns on which sheet the section's point in a plane lies: the value has the sign of the root, and is 0 if both
/// sheets meet. The plane must meet the ruling u in one point, and that must be on the curve.
[[nodiscard]] Real sheet_in_plane(const Ruled_section<Real>& section, const Projective<Real>& plane,
                                  const Direction& u);

}  // namespace cgal_blend

#endif
