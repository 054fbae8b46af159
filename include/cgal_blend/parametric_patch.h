// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_PARAMETRIC_PATCH_H
#define CGAL_BLEND_PARAMETRIC_PATCH_H

#include <cgal_blend/blend_mesh.h>
#include <cgal_blend/dual.h>

#include <array>
#include <cmath>
#include <functional>
#include <type_traits>

namespace cgal_blend {

/// Point of a parametric surface with its derivatives by u and v.
struct Patch_point {
  Point_3 point;
  Vector_3 du, dv;
};

/// Parametric surface P(u, v) over a rectangle; by value.
struct Parametric_patch {
  std::function<Patch_point(double u, double v)> at;
  /// The second derivative of P along the vector (a, b) of the parameter plane.
  std::function<Vector_3(double u, double v, double a, double b)> second_derivative;
  double u0 = 0, u1 = 1, v0 = 0, v1 = 1;  ///< u0 < u1, v0 < v1
  bool closed_u = false;                  ///< P(u0, v) = P(u1, v), with the same derivatives
};

namespace internal {

template <class T>
Vector_3 slopes(const std::array<T, 3>& p, int i) {
  return {p[0].slope[i], p[1].slope[i], p[2].slope[i]};
}

}  // namespace internal

/// Makes a patch of a formula; derivatives are exact to rounding.
/// \tparam Function callable as std::array<T, 3> f(T u, T v) for double, `Dual<2>` and `Dual<1, Dual<1>>`
/// \param domain u0, u1, v0, v1
template <class Function>
[[nodiscard]] Parametric_patch parametric_patch(Function f, const std::array<double, 4>& domain, bool closed_u) {
  Parametric_patch patch;
  patch.at = [f](double u, double v) {
    using D = Dual<2>;
    const std::array<D, 3> p = f(D::variable(u, 0), D::variable(v, 1));
    return Patch_point{Point_3(p[0].value, p[1].value, p[2].value), internal::slopes(p, 0), internal::slopes(p, 1)};
  };
  patch.second_derivative = [f](double u, double v, double a, double b) {
    using D = Dual<1>;
    using D2 = Dual<1, D>;
    const std::array<D2, 3> p = f(D2(D(u, {a}), {D(a)}), D2(D(v, {b}), {D(b)}));
    return Vector_3(p[0].slope[0].slope[0], p[1].slope[0].slope[0], p[2].slope[0].slope[0]);
  };
  patch.u0 = domain[0], patch.u1 = domain[1], patch.v0 = domain[2], patch.v1 = domain[3];
  patch.closed_u = closed_u;
  return patch;
}

/// Makes a part of a torus: u runs round the tube, v round the axis.
/// \param centre, e1, e2, e3 e3 is the axis; the three are orthonormal and positively oriented
/// \param major, minor radii, 0 < minor < major
/// \param from, to angles about the axis from e1 towards e2, radians, from < to
[[nodiscard]] inline Parametric_patch torus_patch(const Point_3& centre, const std::array<Vector_3, 3>& e, double major,
                                                  double minor, double from, double to) {
  const auto f = [=](const auto& u, const auto& v) {
    using std::cos;
    using std::sin;
    using T = std::decay_t<decltype(u)>;
    const T rho = T(major) + T(minor) * cos(u), height = T(minor) * sin(u), x = rho * cos(v), y = rho * sin(v);
    std::array<T, 3> p;
    for (int i = 0; i < 3; ++i) p[i] = T(centre[i]) + x * T(e[0][i]) + y * T(e[1][i]) + height * T(e[2][i]);
    return p;
  };
  return parametric_patch(f, {0, 2 * CGAL_PI, from, to}, true);
}

/// Makes a ringed surface S = C(v) + r(v, u) (e1(v) cos u + e2(v) sin u), u in [0, 2 pi], with e1, e2 orthonormal and
/// normal to C'(v): e1 is along the part of `up` that is normal to C', e2 = C'/|C'| x e1.
/// \tparam Centre callable as std::array<T, 3> C(T v); Radius as T r(T v, T u) > 0, 2 pi periodic in u; for double and
///         dual numbers, nested twice
/// \param up nowhere along C'
/// Source: Cheng, Gao, Constructing blending surfaces for two arbitrary surfaces (2003), equation 12.
template <class Centre, class Radius>
[[nodiscard]] Parametric_patch ringed_patch(Centre centre, Radius radius, const Vector_3& up, double from, double to) {
  const auto f = [=](const auto& u, const auto& v) {
    using std::cos;
    using std::sin;
    using std::sqrt;
    using T = std::decay_t<decltype(v)>;
    using Triple = std::array<T, 3>;
    const auto dot = [](const Triple& a, const Triple& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
    // One more level of derivatives: C'(v) has to be differentiated in its turn.
    const auto raised = centre(Dual<1, T>(v, {T(1.0)}));
    const Triple c{raised[0].value, raised[1].value, raised[2].value};
    Triple tangent{raised[0].slope[0], raised[1].slope[0], raised[2].slope[0]}, e1{T(up.x()), T(up.y()), T(up.z())};
    const T speed = sqrt(dot(tangent, tangent));
    for (T& x : tangent) x = x / speed;
    const T along = dot(e1, tangent);
    for (int i = 0; i < 3; ++i) e1[i] = e1[i] - along * tangent[i];
    const T length = sqrt(dot(e1, e1));
    for (T& x : e1) x = x / length;
    const T a = radius(v, u) * cos(u), b = radius(v, u) * sin(u);
    Triple p;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      p[i] = c[i] + a * e1[i] + b * (tangent[j] * e1[k] - tangent[k] * e1[j]);
    }
    return p;
  };
  return parametric_patch(f, {0, 2 * CGAL_PI, from, to}, true);
}

}  // namespace cgal_blend

#endif
