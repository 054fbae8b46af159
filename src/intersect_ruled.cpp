// SPDX-License-Identifier: GPL-3.0-or-later
#include "intersection_cases.h"

#include "ruled_quadric.h"

#include <CGAL/assertions.h>

#include <array>
#include <memory>
#include <stdexcept>
#include <vector>

namespace cgal_blend {

namespace {

// The cutting quadric on the ruled one: a v0^2 + 2 b v0 v1 + c v1^2.
struct Exact_section {
  Binary_form a, b, c;
};

Exact_section cut(const Ruled_quadric& r, const Surd_matrix& m) {
  const auto of = [&](const Surd_vector& x, const Surd_vector& y) { return bilinear(m, x, y); };
  return {{of(r.p, r.p), Surd(2) * of(r.p, r.d2), of(r.d2, r.d2)},
          {of(r.p, r.d1), of(r.p, r.q) + of(r.d2, r.d1), of(r.d2, r.q)},
          {of(r.d1, r.d1), Surd(2) * of(r.d1, r.q), of(r.q, r.q)}};
}

Binary_form discriminant(const Exact_section& s) { return sum(product(s.b, s.b), scaled(product(s.a, s.c), -1)); }

// Where the curve meets the plane at infinity: the rulings u.
Binary_form at_infinity(const Ruled_quadric& r, const Exact_section& s) {
  const Binary_form f{r.p[3], r.d2[3]}, g{r.d1[3], r.q[3]};
  return sum(product(s.a, product(g, g)), sum(scaled(product(s.b, product(f, g)), -2), product(s.c, product(f, f))));
}

// Common powers of two go, so that the numbers of the section fit any precision's range of exponents.
Ruled_section<Real> to_real(const Ruled_quadric& r, const Exact_section& s) {
  Ruled_section<Real> result{
      to_projective(r.p), to_projective(r.d1), to_projective(r.d2), to_projective(r.q), {}, {}, {}};
  Real largest = 0, longest = 0;
  for (const Binary_form* f : {&s.a, &s.b, &s.c})
    for (const Surd& x : *f) largest = std::max<Real>(largest, abs(x.to_real()));
  for (const Projective<Real>* p : {&result.p, &result.d1, &result.d2, &result.q})
    for (const Real& x : *p) longest = std::max<Real>(longest, abs(x));
  for (std::size_t k = 0; k < 3; ++k) {
    result.a[k] = s.a[k].to_real() / largest;
    result.b[k] = s.b[k].to_real() / largest;
    result.c[k] = s.c[k].to_real() / largest;
  }
  for (Projective<Real>* p : {&result.p, &result.d1, &result.d2, &result.q})
    for (Real& x : *p) x /= longest;
  return result;
}

Direction unit(const Direction& d) {
  const Real length = sqrt(d.c * d.c + d.s * d.s);
  return {d.c / length, d.s / length};
}

Real cosine(const std::array<Direction, 2>& d) { return d[0].c * d[1].c + d[0].s * d[1].s; }

std::vector<std::shared_ptr<const Quartic_loop>> find_loops(const Ruled_section<Real>& section,
                                                            const Exact_section& exact) {
  const std::vector<Form_root> roots = real_roots(discriminant(exact));
  const std::vector<Real> d = cgal_blend::discriminant(section);
  if (roots.empty()) {
    if (value(d, {1, 0}) < 0) return {};
    return {std::make_shared<const Quartic_loop>(section, 1), std::make_shared<const Quartic_loop>(section, -1)};
  }
  // All roots are simple: the sign is found in the widest interval and alternates.
  std::vector<std::array<Direction, 2>> intervals;
  std::size_t widest = 0;
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const Direction begin = unit(roots[i].at), end = unit(roots[(i + 1) % roots.size()].at);
    intervals.push_back({begin, i + 1 == roots.size() ? Direction{-end.c, -end.s} : end});
    if (cosine(intervals[i]) < cosine(intervals[widest])) widest = i;
  }
  const auto& [begin, end] = intervals[widest];
  const bool is_positive = value(d, {begin.c + end.c, begin.s + end.s}) > 0;
  std::vector<std::shared_ptr<const Quartic_loop>> loops;
  for (std::size_t i = 0; i < intervals.size(); ++i)
    if (((i + widest) % 2 == 0) == is_positive)
      loops.push_back(std::make_shared<const Quartic_loop>(section, intervals[i][0], intervals[i][1]));
  return loops;
}

// A point of the curve at infinity: the ruling, and the sheet, or 0 where both meet.
struct Infinite_point {
  Direction u;
  int sheet;
};

std::vector<Infinite_point> infinite_points(const Ruled_quadric& r, const Exact_section& exact,
                                            const Ruled_section<Real>& section) {
  const Real certain("1e-50"), noise("1e-100");  // a sign; what is smaller is looked at exactly, or has none
  const Binary_form w = at_infinity(r, exact);
  std::vector<Infinite_point> points;
  for (const Form_root& root : real_roots(w)) {
    const Real sheet = sheet_in_plane(section, {0, 0, 0, 1}, root.at);
    bool is_turn = false;
    if (abs(sheet) < certain) {
      const Binary_form turns = common_factor(w, discriminant(exact));
      const Real bend = value(cgal_blend::to_real(turns), root.at);
      is_turn = turns.size() > 1 && abs(bend) < certain;
      if (!is_turn && abs(sheet) < noise)
        throw std::range_error("a point at infinity is too close to where two arcs of the curve meet");
    }
    points.push_back({root.at, is_turn ? 0 : sheet < 0 ? -1 : 1});
  }
  return points;
}

}  // namespace

void add_smooth_quartic(Intersection_builder& builder, const Form_pencil& pencil) {
  const Ruled_search search = find_ruled_quadric(pencil.a, pencil.b, pencil.determinant, true);
  if (search.has_definite_member || !search.quadric) return;
  const Ruled_quadric& r = *search.quadric;
  const Exact_section exact = cut(r, are_proportional(pencil.a, r.form) ? pencil.b : pencil.a);
  const Ruled_section<Real> section = to_real(r, exact);
  const std::vector<Infinite_point> infinite = infinite_points(r, exact, section);
  for (const auto& loop : find_loops(section, exact)) {
    std::vector<Direction> breaks;
    for (const Infinite_point& at : infinite)
      if (at.sheet != 0 || loop->is_between(at.u))
        for (const Direction& parameter : loop->parameter_of(at.u, at.sheet)) breaks.push_back(parameter);
    builder.add_quartic_loop("smooth quartic", loop, breaks);
  }
}

// On a doubly ruled quadric the other one's equation is a product f(u) g(v): its roots are the lines of either family.
void add_skew_lines(Intersection_builder& builder, const Form_pencil& pencil) {
  const Ruled_search search = find_ruled_quadric(pencil.a, pencil.b, pencil.determinant, false);
  CGAL_assertion(search.quadric.has_value());
  const Ruled_quadric& r = *search.quadric;
  const Exact_section s = cut(r, are_proportional(pencil.a, r.form) ? pencil.b : pencil.a);
  const Binary_form& f = !is_zero(s.a) ? s.a : !is_zero(s.b) ? s.b : s.c;
  const std::size_t k = !f[0].is_zero() ? 0 : !f[1].is_zero() ? 1 : 2;
  for (const auto& [c, d] : exact_roots(f))
    builder.add_line(sum(scaled(r.p, c), scaled(r.d2, d)), sum(scaled(r.d1, c), scaled(r.q, d)), 1);
  for (const auto& [c, d] : exact_roots({s.a[k], s.b[k] + s.b[k], s.c[k]}))
    builder.add_line(sum(scaled(r.p, c), scaled(r.d1, d)), sum(scaled(r.d2, c), scaled(r.q, d)), 1);
  builder.add_crossings();
}

}  // namespace cgal_blend
