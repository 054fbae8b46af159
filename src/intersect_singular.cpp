// SPDX-License-Identifier: GPL-3.0-or-later
#include "intersection_cases.h"

#include <CGAL/assertions.h>

#include <cstddef>

namespace cgal_blend {

namespace {

Binary_form difference(const Binary_form& f, const Binary_form& g) { return sum(f, scaled(g, -1)); }

// Sum of vectors times binary forms: the coefficients of a curve.
struct Curve_sum {
  Surd_matrix points;

  explicit Curve_sum(std::size_t degree) : points(degree + 1, Surd_vector(4)) {}
  void add(const Binary_form& factor, const Surd_vector& point) {
    CGAL_assertion(factor.size() == points.size());
    for (std::size_t k = 0; k < factor.size(); ++k) points[k] = sum(points[k], scaled(point, factor[k]));
  }
};

// The quadric's values along y(c, s), three vectors that are factors of c^2, c s, s^2.
Binary_form along(const Surd_matrix& quadric, const Surd_matrix& y) {
  const auto twice = [&](std::size_t i, std::size_t j) { return Surd(2) * bilinear(quadric, y[i], y[j]); };
  return {bilinear(quadric, y[0], y[0]), twice(0, 1), twice(0, 2) + bilinear(quadric, y[1], y[1]), twice(1, 2),
          bilinear(quadric, y[2], y[2])};
}

// A linear form and a quadratic one for every plane through the line: the quadric restricted to points
// alpha l1 + beta l2 + gamma g, with g = c g0 + s g1, is gamma (2 alpha at_l1 + 2 beta at_l2 + gamma at_g).
struct On_planes {
  Binary_form at_l1, at_l2, at_g;

  On_planes(const Surd_matrix& m, const Surd_matrix& line, const Surd_matrix& g)
      : at_l1{Surd(2) * bilinear(m, line[0], g[0]), Surd(2) * bilinear(m, line[0], g[1])},
        at_l2{Surd(2) * bilinear(m, line[1], g[0]), Surd(2) * bilinear(m, line[1], g[1])},
        at_g{bilinear(m, g[0], g[0]), Surd(2) * bilinear(m, g[0], g[1]), bilinear(m, g[1], g[1])} {}
};

// The line is where h(t) = t^2 + f t + g vanishes for t = b^-1 a: the span of the apexes of the two singular members, or
// of the one and the tangent there. Solves b y = a x, a y + f a x + g b x = 0.
Surd_matrix rational_line(const Form_pencil& pencil, const Binary_form& half) {
  // half, of the members c a - s b, has its roots s / c where h has them.
  const Surd f = half[1] / half[2], g = half[0] / half[2];
  Surd_matrix rows(8, Surd_vector(8));
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      rows[i][j] = pencil.a[i][j];
      rows[i][j + 4] = -pencil.b[i][j];
      rows[i + 4][j] = f * pencil.a[i][j] + g * pencil.b[i][j];
      rows[i + 4][j + 4] = pencil.a[i][j];
    }
  Surd_matrix line;
  for (const Surd_vector& xy : kernel(rows, 8)) line.emplace_back(xy.begin(), xy.begin() + 4);
  CGAL_assertion(line.size() == 2);
  return line;
}

void add_crossings(Intersection_builder& builder, const Binary_form& gamma, const Binary_form& alpha,
                   const Binary_form& beta, const Surd_matrix& line) {
  const auto at = [](const Binary_form& f, const Surd& c, const Surd& s) {
    return c * (c * (f[0] * c + f[1] * s) + f[2] * s * s) + f[3] * s * s * s;
  };
  const auto roots = exact_roots(gamma);
  for (const auto& [c, s] : roots)
    builder.add_singular_point(sum(scaled(line[0], at(alpha, c, s)), scaled(line[1], at(beta, c, s))));
  builder.add_crossings(roots.size() == 1 ? "touching in one point" : "");
}

}  // namespace

// On a ruling p + t y of the cone, p its apex, the quadric has the values 2 t (p, y) + t^2 (y, y) for its bilinear form:
// the curve is (y, y) p - 2 (p, y) y.
void add_singular_quartic(Intersection_builder& builder, const Surd_matrix& cone, const Surd_matrix& quadric) {
  const Surd_vector apex = kernel(cone, 4).at(0);
  const Surd_matrix across = complement({apex}, 4);
  const Diagonal_form conic = diagonalize(restricted(cone, across));
  if (conic.is_definite()) {
    builder.add_isolated_point(apex);
    return;
  }
  Surd_matrix y;
  for (const Surd_vector& x : parametrize_conic(conic)) y.push_back(in_space(across, x));
  const Surd_vector image = product(quadric, apex);
  const Binary_form at_apex{dot(image, y[0]), dot(image, y[1]), dot(image, y[2])};
  Curve_sum curve(4);
  curve.add(along(quadric, y), apex);
  for (std::size_t k = 0; k < 3; ++k) {
    Binary_form monomial(3);
    monomial[k] = -2;
    curve.add(product(at_apex, monomial), y[k]);
  }
  const int branches = (at_apex[1] * at_apex[1] - Surd(4) * at_apex[0] * at_apex[2]).sign();
  if (branches < 0) {
    builder.add_rational("quartic", curve.points, 1);
    builder.add_isolated_point(apex);
    return;
  }
  const bool is_affine = builder.add_singular_point(apex);
  if (branches > 0)
    builder.add_rational("nodal quartic", curve.points, 1);
  else
    builder.add_rational("cuspidal quartic", curve.points, 1, is_affine ? at_apex : Binary_form{Surd(1)});
}

// In each plane through the line either quadric has one more line; where the two cross is a point of the cubic.
void add_cubic_and_line(Intersection_builder& builder, const Form_pencil& pencil, const Binary_form& half) {
  const Surd_matrix line = rational_line(pencil, half), g = complement(line, 4);
  const On_planes a(pencil.a, line, g), b(pencil.b, line, g);
  const Binary_form alpha = difference(product(a.at_l2, b.at_g), product(a.at_g, b.at_l2));
  const Binary_form beta = difference(product(a.at_g, b.at_l1), product(a.at_l1, b.at_g));
  const Binary_form gamma = difference(product(a.at_l1, b.at_l2), product(a.at_l2, b.at_l1));
  Curve_sum cubic(3);
  cubic.add(alpha, line[0]);
  cubic.add(beta, line[1]);
  cubic.add(product(gamma, {1, 0}), g[0]);
  cubic.add(product(gamma, {0, 1}), g[1]);
  builder.add_rational("twisted cubic", cubic.points, 1);
  builder.add_line(line[0], line[1], 1);
  add_crossings(builder, gamma, alpha, beta, line);
}

}  // namespace cgal_blend
