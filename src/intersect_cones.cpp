// SPDX-License-Identifier: GPL-3.0-or-later
#include "intersection_cases.h"

#include <CGAL/assertions.h>

#include <stdexcept>

namespace cgal_blend {

namespace {

Surd_vector cross(const Surd_vector& x, const Surd_vector& y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}

// The other line of a conic that is a pair of lines.
Surd_vector other_line(const Surd_matrix& pair, const Surd_vector& line) {
  Surd_vector x;
  for (const Surd_vector& e : identity(3))
    if (!dot(line, e).is_zero()) x = e;
  const Surd on_line = dot(line, x);
  const Surd_vector polar = product(pair, x);
  return sum(scaled(polar, Surd(2) * on_line), scaled(line, -dot(polar, x)));  // times on_line^2
}

/// Two conics in the plane of a basis; lines join their common points to the apex.
struct Base_conics {
  Surd_vector apex;
  Surd_matrix basis, a, b;
};

// All conics of the pencil are singular: they share a line, the quadrics a plane.
void add_common_plane(Intersection_builder& builder, const Base_conics& c) {
  const Diagonal_form form_a = diagonalize(c.a), form_b = diagonalize(c.b);
  CGAL_assertion(form_a.rank == 2 && form_b.rank == 2);
  const Surd_vector vertex_a = form_a.basis[2], vertex_b = form_b.basis[2], line = cross(vertex_a, vertex_b);
  const bool is_infinite =
      c.apex[3].is_zero() && in_space(c.basis, vertex_a)[3].is_zero() && in_space(c.basis, vertex_b)[3].is_zero();
  if (!is_infinite) builder.set_surface("common plane");
  const Surd_vector crossing = cross(other_line(c.a, line), other_line(c.b, line));
  builder.add_line(c.apex, in_space(c.basis, crossing), 1);
}

/// A conic through a rational point, parametrized by the lines through that: three vectors, factors of c^2, c s, s^2.
struct Parametrized_conic {
  Surd_matrix points, other;  ///< `other`: a conic that spans the pencil with this one
};

Parametrized_conic parametrize(const Surd_matrix& conic, const Surd_vector& through, const Surd_matrix& other) {
  const Surd_matrix y = complement({through}, 3);
  const Surd_vector image = product(conic, through);
  const Surd m0 = dot(image, y[0]), m1 = dot(image, y[1]);
  const Surd_matrix m = restricted(conic, y);
  const auto combined = [&](const Surd& o, const Surd& f, const Surd& g) {
    return sum(scaled(through, o), sum(scaled(y[0], f), scaled(y[1], g)));
  };
  return {{combined(-m[0][0], m0 + m0, 0), combined(-(m[0][1] + m[0][1]), m1 + m1, m0 + m0),
           combined(-m[1][1], 0, m1 + m1)},
          other};
}

// Through every point off the common ones goes one conic of the pencil; takes the first that is regular.
Parametrized_conic find_conic(const Base_conics& c) {
  for (int size = 1; size < 8; ++size)
    for (int x = -size; x <= size; ++x)
      for (int y = -size; y <= size; ++y) {
        const Surd_vector point{x, y, size};
        const Surd at_a = bilinear(c.a, point, point), at_b = bilinear(c.b, point, point);
        if (at_a.is_zero() && at_b.is_zero()) continue;
        const Surd_matrix conic = member(c.a, c.b, at_b, at_a);
        if (diagonalize(conic).rank == 3) return parametrize(conic, point, at_b.is_zero() ? c.a : c.b);
      }
  throw std::runtime_error("no regular conic was found in a pencil");
}

Binary_form substituted(const Surd_matrix& conic, const Surd_matrix& p) {
  const auto twice = [&](std::size_t i, std::size_t j) { return Surd(2) * bilinear(conic, p[i], p[j]); };
  return {bilinear(conic, p[0], p[0]), twice(0, 1), twice(0, 2) + bilinear(conic, p[1], p[1]), twice(1, 2),
          bilinear(conic, p[2], p[2])};
}

// Takes the points at infinity out of the common points.
Binary_form without_infinity(Binary_form roots, const Binary_form& infinite) {
  for (Binary_form common = common_factor(roots, infinite); common.size() > 1; common = common_factor(roots, infinite))
    roots = quotient(roots, common);
  return roots;
}

void add_common_lines(Intersection_builder& builder, const Base_conics& c) {
  const Parametrized_conic conic = find_conic(c);
  Binary_form roots = substituted(conic.other, conic.points);
  Binary_form w;
  std::vector<Projective<Real>> points;
  for (const Surd_vector& p : conic.points) {
    points.push_back(to_projective(in_space(c.basis, p)));
    w.push_back(in_space(c.basis, p)[3]);
  }
  const bool is_parallel = c.apex[3].is_zero();
  if (is_parallel) roots = without_infinity(roots, w);
  const std::vector<Form_root> found = real_roots(roots);
  for (const Form_root& root : found) {
    const Real cc = root.at.c * root.at.c, cs = root.at.c * root.at.s, ss = root.at.s * root.at.s;
    Projective<Real> q;
    for (std::size_t i = 0; i < 4; ++i) q[i] = cc * points[0][i] + cs * points[1][i] + ss * points[2][i];
    builder.add_line(c.apex, q, root.multiplicity);
  }
  if (found.empty())
    builder.add_isolated_point(c.apex);
  else
    builder.add_singular_point(c.apex);
  if (is_parallel)
    builder.set_parallel();
  else
    builder.add_crossings("through one point");
}

// Pairs of planes through one line.
void add_planes_through_line(Intersection_builder& builder, const Surd_matrix& a, const Surd_matrix& b,
                             const Surd_matrix& axis, const Surd_matrix& across) {
  const auto form = [](const Surd_matrix& m) { return Binary_form{m[0][0], m[0][1] + m[0][1], m[1][1]}; };
  const Binary_form common = common_factor(form(a), form(b));
  if (common.size() == 1) {
    builder.add_line(axis[0], axis[1], 4);
    return;
  }
  CGAL_assertion(common.size() == 2);
  const Surd_vector third = sum(scaled(across[0], common[1]), scaled(across[1], -common[0]));
  if (!axis[0][3].is_zero() || !axis[1][3].is_zero() || !third[3].is_zero()) builder.set_surface("common plane");
}

}  // namespace

std::string add_cones(Intersection_builder& builder, const Surd_matrix& a, const Surd_matrix& b,
                      const Surd_matrix& apexes) {
  const Surd_matrix across = complement(apexes, 4);
  const Surd_matrix section_a = restricted(a, across), section_b = restricted(b, across);
  const Form_pencil pencil = make_pencil(section_a, section_b);
  const std::string segre = pencil.factors.empty() ? "[{3}]" : segre_symbol(pencil);
  if (apexes.size() == 2) {
    add_planes_through_line(builder, section_a, section_b, apexes, across);
    return segre;
  }
  CGAL_assertion(apexes.size() == 1);
  const Base_conics conics{apexes[0], across, section_a, section_b};
  if (pencil.factors.empty())
    add_common_plane(builder, conics);
  else
    add_common_lines(builder, conics);
  return segre;
}

}  // namespace cgal_blend
