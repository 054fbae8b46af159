// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/quadric_intersection.h>

#include "intersection_cases.h"
#include "quadric_matrix.h"

#include <CGAL/assertions.h>

namespace cgal_blend {

namespace {

// Both polynomials are the same but for a factor.
std::string add_same(Intersection_builder& builder, const Quadric_3& quadric) {
  const Diagonal_form form = diagonalize(quadric_matrix(quadric));
  const Quadric_type type = quadric.type();
  if (type == Quadric_type::line)
    builder.add_line(form.kernel()[0], form.kernel()[1], 1);
  else if (type == Quadric_type::point)
    builder.add_isolated_point(form.kernel()[0]);
  else if (type != Quadric_type::empty)
    builder.set_surface(std::string("the same ") + describe(type));
  return form.rank == 4 ? "[(1111)]" : "[]";
}

// The root of the members of rank 2 or less that is rational or else real, if any.
std::vector<std::pair<Surd, Surd>> members_of_rank_2(const Form_pencil& pencil) {
  for (const Binary_form& factor : squarefree_factors(pencil.corank_2))
    if (factor.size() > 1) return exact_roots(factor);
  return {};
}

// The square root of the determinant, up to a factor, where all its roots have even multiplicity.
Binary_form half_of(const Form_pencil& pencil) {
  if (pencil.factors.size() == 2) return pencil.factors[1];
  return product(pencil.factors[3], pencil.factors[3]);
}

// A pencil without members of rank 2 and common apex: the Segre symbol has no parentheses.
void add_irreducible_or_cubic(Intersection_builder& builder, const Form_pencil& pencil) {
  const std::vector<Binary_form>& factors = pencil.factors;
  const bool has_simple = factors[0].size() > 1;
  if (factors.size() == 1) {
    add_smooth_quartic(builder, pencil);
  } else if (!has_simple) {
    add_cubic_and_line(builder, pencil, half_of(pencil));
  } else {
    const auto [c, s] = exact_roots(factors.back()).front();
    const Surd_matrix cone = member(pencil.a, pencil.b, c, s);
    add_singular_quartic(builder, cone, are_proportional(cone, pencil.a) ? pencil.b : pencil.a);
  }
}

std::string add_pencil(Intersection_builder& builder, const Form_pencil& pencil) {
  const std::string segre = pencil.factors.empty() ? "[1{3}]" : segre_symbol(pencil);
  if (pencil.corank_2.size() == 1) {
    add_irreducible_or_cubic(builder, pencil);
    return segre;
  }
  const auto roots = members_of_rank_2(pencil);
  if (roots.empty()) {
    add_skew_lines(builder, pencil);
    return segre;
  }
  const Surd_matrix planes = member(pencil.a, pencil.b, roots[0].first, roots[0].second);
  add_planes(builder, planes, are_proportional(planes, pencil.a) ? pencil.b : pencil.a);
  return segre;
}

std::string add_all(Intersection_builder& builder, const Quadric_3& first, const Quadric_3& second) {
  const Surd_matrix a = quadric_matrix(first), b = quadric_matrix(second);
  if (are_proportional(a, b)) return add_same(builder, first);
  Surd_matrix rows = a;
  rows.insert(rows.end(), b.begin(), b.end());
  const Surd_matrix apexes = kernel(rows, 4);
  if (!apexes.empty()) return add_cones(builder, a, b, apexes);
  return add_pencil(builder, make_pencil(a, b));
}

}  // namespace

const char* name(Intersection_status status) noexcept {
  switch (status) {
    case Intersection_status::ok: return "ok";
    case Intersection_status::empty: return "empty";
    case Intersection_status::surface: return "surface";
  }
  return "unknown";
}

Quadric_intersection intersect_quadrics(const Quadric_3& a, const Quadric_3& b, const Intersection_options& options) {
  Intersection_builder builder(a, b, options);
  const std::string segre = add_all(builder, a, b);
  return builder.finish(segre);
}

Quadric_intersection intersect(const Quadric_3& quadric, const Quadric_3::Plane& plane,
                               const Intersection_options& options) {
  CGAL_precondition(plane[0] != 0 || plane[1] != 0 || plane[2] != 0);
  Intersection_builder builder(quadric, Quadric_3::plane(plane), options);
  const Surd_matrix m = quadric_matrix(quadric);
  const Surd_matrix basis = kernel({{Surd(plane[0]), Surd(plane[1]), Surd(plane[2]), Surd(plane[3])}}, 4);
  if (diagonalize(restricted(m, basis)).rank == 0)
    builder.set_surface("common plane");
  else
    add_plane_section(builder, m, basis, 1, true);
  builder.add_crossings();
  return builder.finish("");
}

}  // namespace cgal_blend
