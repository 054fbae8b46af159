// SPDX-License-Identifier: GPL-3.0-or-later
#include "ruled_quadric.h"

#include "quadric_matrix.h"
#include "quadric_pencil.h"

#include <CGAL/assertions.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace cgal_blend {

namespace {

const Real pi = boost::math::constants::pi<Real>();
constexpr int most_bits = 350;
// How far the member through the rounded point must stay from the singular ones, as a share of the gap.
const Real margin("0.2");
// What is left of coordinates that should vanish.
const Real cancelled("1e-60");
// Angles between the squares of either sign, to try: tangents of a quarter of them are rational and small.
constexpr std::array<std::array<double, 2>, 5> turns{
    {{0.6435, 0.9273}, {2.2143, 0.6435}, {0.9273, 2.2143}, {0.2, 1.3}, {1.9, 2.6}}};

/// Members between two singular ones: angles of (c, s).
struct Gap {
  Real begin, end;

  [[nodiscard]] Real width() const { return end - begin; }
  [[nodiscard]] Real middle() const { return (begin + end) / 2; }
  [[nodiscard]] bool holds(const Surd& c, const Surd& s) const {
    Real angle = c.is_zero() ? Real(pi / 2) : Real(atan(s.to_real() / c.to_real()));
    while (angle <= begin) angle += pi;
    return angle - begin > margin * width() && end - angle > margin * width();
  }
};

std::vector<Gap> gaps_between(const std::vector<Form_root>& roots) {
  std::vector<Real> angles;
  for (const Form_root& root : roots)
    angles.push_back(root.at.c == 0 ? Real(pi / 2) : Real(atan(root.at.s / root.at.c)));
  if (angles.empty()) return {{-pi / 2, pi / 2}};
  std::vector<Gap> gaps;
  for (std::size_t i = 0; i + 1 < angles.size(); ++i) gaps.push_back({angles[i], angles[i + 1]});
  gaps.push_back({angles.back(), angles.front() + pi});
  return gaps;
}

// A member in the gap with short coefficients.
Surd_matrix member_in(const Gap& gap, const Surd_matrix& a, const Surd_matrix& b) {
  const auto without_noise = [](const Real& v) { return abs(v) < cancelled ? Real(0) : v; };
  const Real x = without_noise(cos(gap.middle())), y = without_noise(sin(gap.middle()));
  for (int bits = 2; bits < most_bits; ++bits) {
    const Surd c = round_to_bits(x, bits), s = round_to_bits(y, bits);
    if (!gap.holds(c, s)) continue;
    Surd_matrix m = member(a, b, c, s);
    make_primitive(m);
    return m;
  }
  throw std::range_error("the singular members of a pencil are too close to each other");
}

using Real_vector = std::array<Real, 4>;

// A point of a doubly ruled quadric: equal lengths along squares of either sign.
Real_vector point_on(const Diagonal_form& form, const std::array<double, 2>& turn) {
  Real_vector p{0, 0, 0, 0}, terms{0, 0, 0, 0};
  int seen[2] = {0, 0};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t side = form.diagonal[i].sign() > 0 ? 0 : 1;
    const double angle = turn[side];
    const Real factor =
        (seen[side]++ == 0 ? cos(Real(angle)) : sin(Real(angle))) / sqrt(abs(form.diagonal[i].to_real()));
    for (std::size_t k = 0; k < 4; ++k) {
      const Real term = factor * form.basis[i][k].to_real();
      p[k] += term;
      terms[k] += abs(term);
    }
  }
  for (std::size_t k = 0; k < 4; ++k)
    if (abs(p[k]) < cancelled * terms[k]) p[k] = 0;
  return p;
}

bool is_regular_at_infinity(Surd_matrix m) {
  m.pop_back();
  for (Surd_vector& row : m) row.pop_back();
  return diagonalize(m).rank == 3;
}

/// A rational point and the member of the pencil that it lies on.
struct Point_and_member {
  Surd_vector point;
  Surd_matrix form;
};

std::optional<Point_and_member> round(const Real_vector& place, int bits, const Gap& gap, const Surd_matrix& a,
                                      const Surd_matrix& b, bool is_central) {
  Surd_matrix point(1);
  for (const Real& x : place) point[0].push_back(round_to_bits(x, bits));
  make_primitive(point);
  const Surd c = bilinear(b, point[0], point[0]), s = bilinear(a, point[0], point[0]);
  if ((c.is_zero() && s.is_zero()) || !gap.holds(c, s)) return std::nullopt;
  Surd_matrix form = member(a, b, c, s);
  make_primitive(form);
  if (diagonalize(form).positive != 2 || (is_central && !is_regular_at_infinity(form))) return std::nullopt;
  return Point_and_member{point[0], form};
}

Point_and_member rational_point(const Gap& gap, const Surd_matrix& a, const Surd_matrix& b, const Diagonal_form& middle,
                                bool is_central) {
  for (int bits = 2; bits < most_bits; ++bits)
    for (const auto& turn : turns)
      if (const auto found = round(point_on(middle, turn), bits, gap, a, b, is_central)) return *found;
  throw std::range_error("no rational point was found on a quadric");
}

// The two rulings through p: directions in its tangent plane on which the form vanishes.
std::pair<Surd_vector, Surd_vector> rulings_through(const Surd_vector& p, const Surd_matrix& form) {
  const Surd_vector normal = product(form, p);
  const Surd_matrix tangent = kernel({normal}, 4);
  // Two vectors that span the tangent plane together with p.
  Surd_matrix rest;
  for (const Surd_vector& v : tangent) {
    Surd_matrix rows{p};
    rows.insert(rows.end(), rest.begin(), rest.end());
    rows.push_back(v);
    if (kernel(rows, 4).size() == 4 - rows.size() && rest.size() < 2) rest.push_back(v);
  }
  make_primitive(rest);
  const Surd_matrix m = restricted(form, rest);
  const auto directions = exact_roots({m[0][0], m[0][1] + m[0][1], m[1][1]});
  CGAL_assertion(directions.size() == 2);
  const auto along = [&](const std::pair<Surd, Surd>& d) {
    return sum(scaled(rest[0], d.first), scaled(rest[1], d.second));
  };
  return {along(directions[0]), along(directions[1])};
}

Real size(const Surd_vector& v) {
  Real largest = 0;
  for (const Surd& x : v) largest = std::max<Real>(largest, abs(x.to_real()));
  return largest;
}

Surd power_of_two(const Real& ratio) { return round_to_bits(ratio, 1); }

// Parameters of the rulings are free up to a factor each: makes the vectors about as long as p.
void balance(Ruled_quadric& r) {
  const Surd u = power_of_two(size(r.p) / size(r.d2)), v = power_of_two(size(r.p) / size(r.d1));
  r.d2 = scaled(r.d2, u);
  r.d1 = scaled(r.d1, v);
  r.q = scaled(r.q, u * v);
}

Ruled_quadric parametrize(const Point_and_member& at) {
  const Surd_vector& p = at.point;
  const Surd_vector normal = product(at.form, p);
  const auto [first, second] = rulings_through(p, at.form);
  // Another point, off the tangent plane, and the rulings moved into the tangent planes of both.
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 4; ++i)
    if (abs(normal[i].to_real()) > abs(normal[axis].to_real())) axis = i;
  const Surd_vector e = identity(4)[axis];
  Surd_matrix other{sum(scaled(e, normal[axis] + normal[axis]), scaled(p, -at.form[axis][axis]))};
  make_primitive(other);
  const Surd_vector image = product(at.form, other[0]);
  const Surd between = dot(image, p);
  const auto moved = [&](const Surd_vector& d) { return sum(scaled(d, between), scaled(p, -dot(image, d))); };
  const Surd_vector d1 = moved(first), d2 = moved(second);
  // With x0 x3 = -k x1 x2 as it stands, factors that make it x0 x3 = x1 x2.
  Ruled_quadric result{p, d1, scaled(d2, -between), scaled(other[0], bilinear(at.form, d1, d2)), at.form};
  balance(result);
  return result;
}

}  // namespace

Ruled_search find_ruled_quadric(const Surd_matrix& a, const Surd_matrix& b, const Binary_form& determinant,
                                bool is_central) {
  Ruled_search result;
  std::optional<std::pair<Gap, Diagonal_form>> best;
  for (const Gap& gap : gaps_between(real_roots(determinant))) {
    const Diagonal_form form = diagonalize(member_in(gap, a, b));
    if (form.is_definite()) result.has_definite_member = true;
    if (form.positive == 2 && form.negative == 2 && (!best || gap.width() > best->first.width()))
      best = std::make_pair(gap, form);
  }
  if (!result.has_definite_member && best)
    result.quadric = parametrize(rational_point(best->first, a, b, best->second, is_central));
  return result;
}

}  // namespace cgal_blend
