// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_IMPLICIT_FUNCTION_H
#define CGAL_BLEND_IMPLICIT_FUNCTION_H

#include <cgal_blend/blend_mesh.h>
#include <cgal_blend/dual.h>
#include <cgal_blend/quadric.h>

#include <functional>

namespace cgal_blend {

/// Function of space with its derivatives, whose zero set is a surface; by value.
struct Implicit_function {
  std::function<double(const Point_3&)> value;
  std::function<Vector_3(const Point_3&)> gradient;
  /// The second derivative along a vector: t . H t with the Hessian H.
  std::function<double(const Point_3&, const Vector_3&)> second_derivative;
};

/// Makes an implicit function of a formula; derivatives are exact to rounding.
/// \tparam Function callable as T f(T x, T y, T z) for double, `Dual<3>` and `Dual<1, Dual<1>>`, for example a generic
///         lambda
template <class Function>
[[nodiscard]] Implicit_function implicit_function(Function f) {
  Implicit_function result;
  result.value = [f](const Point_3& p) { return f(p.x(), p.y(), p.z()); };
  result.gradient = [f](const Point_3& p) {
    using D = Dual<3>;
    const D y = f(D::variable(p.x(), 0), D::variable(p.y(), 1), D::variable(p.z(), 2));
    return Vector_3(y.slope[0], y.slope[1], y.slope[2]);
  };
  result.second_derivative = [f](const Point_3& p, const Vector_3& t) {
    using D = Dual<1>;
    using D2 = Dual<1, D>;
    const auto along = [](double x, double slope) { return D2(D(x, {slope}), {D(slope)}); };
    const D2 y = f(along(p.x(), t.x()), along(p.y(), t.y()), along(p.z(), t.z()));
    return y.slope[0].slope[0];
  };
  return result;
}

/// Makes an implicit function of a quadric, in doubles.
[[nodiscard]] inline Implicit_function implicit_function(const Quadric_3& quadric) {
  Implicit_function result;
  result.value = [quadric](const Point_3& p) { return quadric.value(p); };
  result.gradient = [quadric](const Point_3& p) { return quadric.gradient(p); };
  result.second_derivative = [quadric](const Point_3&, const Vector_3& t) {
    // The gradient is an affine function of the place.
    const Point_3 origin(0, 0, 0);
    return (quadric.gradient(origin + t) - quadric.gradient(origin)) * t;
  };
  return result;
}

}  // namespace cgal_blend

#endif
