// SPDX-License-Identifier: GPL-3.0-or-later
#include "intersection_cases.h"

#include <CGAL/assertions.h>

#include <array>
#include <optional>

namespace cgal_blend {

namespace {

// The third coordinate in a plane's basis vanishes on the line of the first two.
bool is_on_first_line(const Surd_vector& coordinates) { return coordinates[2].is_zero(); }

void add_line_pair(Intersection_builder& builder, const Diagonal_form& conic, const Surd_matrix& basis,
                   int multiplicity, bool is_alone) {
  const Surd_vector vertex = in_space(basis, conic.basis[2]);
  const Surd slope = sqrt(-(conic.diagonal[0] / conic.diagonal[1]));
  for (const Surd& s : {slope, -slope})
    builder.add_line(vertex, in_space(basis, sum(conic.basis[0], scaled(conic.basis[1], s))), multiplicity);
  if (is_alone || !is_on_first_line(conic.basis[2])) builder.add_singular_point(vertex);
}

// Where the line of two planes meets the quadric.
struct Line_points {
  std::vector<Surd_vector> points;
  bool is_touching = false, is_contained = false;
};

Line_points points_on_line(const Surd_matrix& line, const Surd_matrix& quadric) {
  const Surd_matrix m = restricted(quadric, line);
  const Binary_form f{m[0][0], m[0][1] + m[0][1], m[1][1]};
  Line_points result;
  result.is_contained = is_zero(f);
  if (result.is_contained) return result;
  for (const auto& [c, s] : exact_roots(f)) result.points.push_back(sum(scaled(line[0], c), scaled(line[1], s)));
  result.is_touching = result.points.size() == 1;
  return result;
}

// Complex planes: all that is real is on the line where they meet.
void add_complex_planes(Intersection_builder& builder, const Surd_matrix& line, const Surd_matrix& quadric) {
  const Line_points on_line = points_on_line(line, quadric);
  if (on_line.is_contained) builder.add_line(line[0], line[1], 2);
  for (const Surd_vector& p : on_line.points) builder.add_isolated_point(p);
}

// Real planes whose common line lies on the quadric: besides it, each has one more line, or the same once more.
void add_planes_through_generator(Intersection_builder& builder, const Surd_matrix& line,
                                  const std::array<Surd_vector, 2>& off_line, const Surd_matrix& quadric) {
  int multiplicity = 2;
  std::optional<std::array<Surd, 2>> crossing;
  for (const Surd_vector& g : off_line) {
    const Surd x = bilinear(quadric, line[0], g), y = bilinear(quadric, line[1], g), z = bilinear(quadric, g, g);
    const Surd size = Surd(2) * (x * x + y * y);
    if (size.is_zero()) {
      CGAL_assertion(!z.is_zero());
      ++multiplicity;
      continue;
    }
    // 2 x alpha + 2 y beta + z = 0 for points alpha line[0] + beta line[1] + g
    const Surd_vector on_line = sum(scaled(line[0], y), scaled(line[1], -x));
    const Surd_vector foot = sum(scaled(line[0], -(z * x) / size), scaled(line[1], -(z * y) / size));
    builder.add_line(on_line, sum(foot, g), 1);
    if (!crossing || !((*crossing)[0] * y - (*crossing)[1] * x).is_zero()) builder.add_singular_point(on_line);
    crossing = {x, y};
  }
  builder.add_line(line[0], line[1], multiplicity);
  builder.add_crossings();
}

void add_crossings(Intersection_builder& builder, const Line_points& on_line,
                   const std::array<Plane_section, 2>& sections) {
  const bool is_isolated = !sections[0].has_curve && !sections[1].has_curve;
  for (const Surd_vector& p : on_line.points) {
    if (is_isolated)
      builder.add_isolated_point(p);
    else
      builder.add_singular_point(p);
  }
  const bool is_tangent = on_line.is_touching && sections[0].is_smooth_conic && sections[1].is_smooth_conic;
  builder.add_crossings(is_tangent ? "touching in one point" : "");
}

}  // namespace

// With d0 and d2 of different signs and r = sqrt(-d0 d2), (d0 x - r z)(d0 x + r z) = -d0 d1 y^2 is solved by
// d0 x + r z = c^2, d0 x - r z = -d0 d1 s^2, y = c s; here times 2 d0 r, and with 2^k s in place of s, which makes a circle
// of angles that are about even.
Surd_matrix parametrize_conic(const Diagonal_form& conic) {
  std::array<std::size_t, 3> order{0, 1, 2};
  if (conic.diagonal[0].sign() == conic.diagonal[2].sign()) order = {0, 2, 1};
  const Surd &d0 = conic.diagonal[order[0]], &d1 = conic.diagonal[order[1]], &d2 = conic.diagonal[order[2]];
  const Surd r = sqrt(-(d0 * d2));
  const Surd unit = round_to_bits(1 / sqrt(abs((d0 * d1).to_real())), 1);
  const Surd_vector &x = conic.basis[order[0]], &y = conic.basis[order[1]], &z = conic.basis[order[2]];
  return {sum(scaled(x, r), scaled(z, d0)), scaled(y, Surd(2) * d0 * r * unit),
          scaled(sum(scaled(x, -r), scaled(z, d0)), d0 * d1 * unit * unit)};
}

Plane_section add_plane_section(Intersection_builder& builder, const Surd_matrix& quadric, const Surd_matrix& basis,
                                int multiplicity, bool is_alone) {
  const Diagonal_form conic = diagonalize(restricted(quadric, basis));
  const bool has_one_sign = conic.positive == 0 || conic.negative == 0;
  CGAL_assertion(conic.rank > 0);
  if (conic.rank == 1) {
    builder.add_line(in_space(basis, conic.basis[1]), in_space(basis, conic.basis[2]), 2 * multiplicity);
    return {true, false};
  }
  if (conic.rank == 2 && has_one_sign) {
    // A point on the line that two planes share may be on a curve of the other one: add_crossings sees to it.
    if (is_alone || !is_on_first_line(conic.basis[2])) builder.add_isolated_point(in_space(basis, conic.basis[2]));
    return {false, false};
  }
  if (conic.rank == 2) {
    add_line_pair(builder, conic, basis, multiplicity, is_alone);
    return {true, false};
  }
  if (has_one_sign) return {false, false};
  Surd_matrix points;
  for (const Surd_vector& x : parametrize_conic(conic)) points.push_back(in_space(basis, x));
  builder.add_rational("conic", points, multiplicity);
  return {true, true};
}

void add_planes(Intersection_builder& builder, const Surd_matrix& planes, const Surd_matrix& quadric) {
  const Diagonal_form form = diagonalize(planes);
  const Surd_matrix line = form.kernel();
  if (form.rank == 1) {
    add_plane_section(builder, quadric, line, 2, true);
    builder.add_crossings();
    return;
  }
  CGAL_assertion(form.rank == 2);
  if (form.positive != 1) {
    add_complex_planes(builder, line, quadric);
    return;
  }
  const Surd slope = sqrt(-(form.diagonal[0] / form.diagonal[1]));
  const std::array<Surd_vector, 2> off_line{sum(form.basis[0], scaled(form.basis[1], slope)),
                                            sum(form.basis[0], scaled(form.basis[1], -slope))};
  const Line_points on_line = points_on_line(line, quadric);
  if (on_line.is_contained) {
    add_planes_through_generator(builder, line, off_line, quadric);
    return;
  }
  std::array<Plane_section, 2> sections;
  for (std::size_t i = 0; i < 2; ++i)
    sections[i] = add_plane_section(builder, quadric, {line[0], line[1], off_line[i]}, 1, false);
  add_crossings(builder, on_line, sections);
}

}  // namespace cgal_blend
