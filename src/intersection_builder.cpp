// SPDX-License-Identifier: GPL-3.0-or-later
#include "intersection_builder.h"

#include "curve_arc.h"

#include <boost/math/constants/constants.hpp>

#include <CGAL/assertions.h>

#include <algorithm>

namespace cgal_blend {

namespace {

const Real pi = boost::math::constants::pi<Real>();
const Real on_box("1e-60");  // relative

// The angle in (-pi / 2, pi / 2] of a direction, whichever its sense.
Real angle_of(const Direction& d) { return d.c == 0 ? Real(pi / 2) : Real(atan(d.s / d.c)); }

Quadric_3::Point_3 affine(const Projective<Real>& p) {
  const auto number = [&](std::size_t i) { return static_cast<double>(Real(p[i] / p[3])); };
  return {number(0), number(1), number(2)};
}

// Makes the arc reach from break to break; from and to infinite ones only as far as its first and last point on the box.
// Returns false if nothing is left.
bool set_range(internal::Curve_arc& arc, const Intersection_builder::Break& begin,
               const Intersection_builder::Break& end, const std::vector<Real>& entries) {
  Real from = begin.angle, to = end.angle;
  if (begin.is_infinite || end.is_infinite) {
    std::vector<Real> inside;
    for (const Real& entry : entries)
      for (const Real& angle : {entry, Real(entry + pi)})
        if (angle > begin.angle && angle < end.angle) inside.push_back(angle);
    if (inside.empty()) return false;
    const auto [first, last] = std::minmax_element(inside.begin(), inside.end());
    if (begin.is_infinite) from = *first;
    if (end.is_infinite) to = *last;
  }
  if (from == to) return false;
  arc.set_range(from, to);
  arc.has_cusp = {!begin.is_infinite, !end.is_infinite};
  return true;
}

std::string in_plural(const std::string& name, int count) {
  return count_in_words(static_cast<std::size_t>(count)) + " " + name + "s";
}

void append(std::string& text, const std::string& separator, const std::string& part) {
  if (!text.empty()) text += separator;
  text += part;
}

}  // namespace

std::string count_in_words(std::size_t count) {
  constexpr const char* words[] = {"no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine"};
  return count < 10 ? words[count] : std::to_string(count);
}

Projective<Real> to_projective(const Surd_vector& p) {
  CGAL_precondition(p.size() == 4);
  return {p[0].to_real(), p[1].to_real(), p[2].to_real(), p[3].to_real()};
}

Intersection_builder::Intersection_builder(const Quadric_3& a, const Quadric_3& b, const Intersection_options& options)
    : surfaces_(std::make_shared<const internal::Curve_arc>(a, b)), options_(options) {
  CGAL_precondition(options.box > 0);
}

void Intersection_builder::note(const std::string& name, int degree, int multiplicity) {
  const std::string whole = multiplicity == 1   ? name
                            : multiplicity == 2 ? "double " + name
                            : multiplicity == 3 ? "triple " + name
                                                : "quadruple " + name;
  const int rank = 10 * (4 - degree) + multiplicity;
  const auto place = std::find_if(curves_.begin(), curves_.end(), [&](const Curves& c) { return c.rank >= rank; });
  if (place != curves_.end() && place->name == whole)
    ++place->count;
  else
    curves_.insert(place, {whole, rank, 1});
}

bool Intersection_builder::has_several_curves() const {
  int count = 0;
  for (const Curves& c : curves_) count += c.rank < 40 ? c.count : 0;
  return count > 1;
}

void Intersection_builder::set_parallel() {
  if (has_several_curves()) crossings_ = "in parallel";
}

void Intersection_builder::add_crossings(const std::string& how) {
  if (!has_several_curves()) return;
  crossings_ = how;
  const std::size_t isolated = static_cast<std::size_t>(std::count_if(
      components_.begin(), components_.end(), [](const Intersection_curve& c) { return c.is_isolated(); }));
  const std::size_t points = singular_points_.size() - isolated;
  if (points == 0)
    crossings_ = "not meeting";
  else if (how.empty())
    crossings_ = "crossing in " + count_in_words(points) + (points == 1 ? " point" : " points");
}

void Intersection_builder::add_rational(const std::string& name, const Surd_matrix& coefficients, int multiplicity,
                                        const Binary_form& cusps) {
  Binary_form w;
  std::vector<Projective<Real>> points;
  for (const Surd_vector& point : coefficients) {
    w.push_back(point[3]);
    points.push_back(to_projective(point));
  }
  if (is_zero(w)) return;
  note(name, static_cast<int>(coefficients.size()) - 1, multiplicity);
  std::vector<Break> breaks;
  for (const Form_root& root : real_roots(w)) breaks.push_back({angle_of(root.at), true});
  for (const Form_root& root : real_roots(cusps)) breaks.push_back({angle_of(root.at), false});
  add_arcs(std::make_shared<const Rational_curve>(points), breaks, static_cast<int>(coefficients.size()) - 1,
           multiplicity);
}

void Intersection_builder::add_line(const Surd_vector& p, const Surd_vector& q, int multiplicity) {
  add_rational("line", {p, q}, multiplicity);
}

void Intersection_builder::add_line(const Surd_vector& p, const Projective<Real>& q, int multiplicity) {
  note("line", 1, multiplicity);
  const Projective<Real> from = to_projective(p);
  const Direction infinite = p[3].is_zero() ? Direction{1, 0} : Direction{q[3], -from[3]};
  add_arcs(std::make_shared<const Rational_curve>(std::vector<Projective<Real>>{from, q}), {{angle_of(infinite), true}},
           1, multiplicity);
}

void Intersection_builder::add_quartic_loop(const std::string& name,
                                            const std::shared_ptr<const Projective_curve>& loop,
                                            const std::vector<Direction>& infinite) {
  if (curves_.empty()) note(name, 4, 1);  // all loops are one curve
  std::vector<Break> breaks;
  for (const Direction& at : infinite) breaks.push_back({angle_of(at), true});
  add_arcs(loop, breaks, 4, 1);
}

void Intersection_builder::add_isolated_point(const Surd_vector& p) {
  if (!add_singular_point(p)) return;
  note("isolated point", 0, 1);
  auto arc = std::make_shared<internal::Curve_arc>(*surfaces_);
  arc->isolated_point = affine(to_projective(p));
  components_.emplace_back(arc);
}

bool Intersection_builder::add_singular_point(const Surd_vector& p) {
  if (p[3].is_zero()) return false;
  singular_points_.push_back(affine(to_projective(p)));
  return true;
}

void Intersection_builder::add_arcs(const std::shared_ptr<const Projective_curve>& curve, std::vector<Break> breaks,
                                    int degree, int multiplicity) {
  if (breaks.empty()) {
    auto arc = std::make_shared<internal::Curve_arc>(*surfaces_);
    arc->curve = curve;
    arc->set_range(0, pi);
    arc->is_closed = true;
    arc->degree = degree;
    arc->multiplicity = multiplicity;
    components_.emplace_back(arc);
    return;
  }
  std::sort(breaks.begin(), breaks.end(), [](const Break& x, const Break& y) { return x.angle < y.angle; });
  const std::vector<Real> entries = entries_to_box(*curve);
  for (std::size_t i = 0; i < breaks.size(); ++i) {
    const bool is_last = i + 1 == breaks.size();
    Break end = breaks[is_last ? 0 : i + 1];
    if (is_last) end.angle += pi;
    auto arc = std::make_shared<internal::Curve_arc>(*surfaces_);
    arc->curve = curve;
    arc->degree = degree;
    arc->multiplicity = multiplicity;
    if (!set_range(*arc, breaks[i], end, entries)) continue;
    components_.emplace_back(arc);
  }
}

std::vector<Real> Intersection_builder::entries_to_box(const Projective_curve& curve) const {
  std::vector<Real> angles;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const double wall : {options_.box, -options_.box}) {
      Projective<Real> plane{0, 0, 0, -wall};
      plane[axis] = 1;
      for (const Direction& at : curve.meets_plane(plane)) {
        const Projective<Dual<Real>> x = curve.at({at.c, 0}, {at.s, 0});
        const Real limit = options_.box * abs(x[3].value) * (1 + on_box);
        if (std::all_of(x.begin(), x.begin() + 3, [&](const Dual<Real>& c) { return abs(c.value) <= limit; }))
          angles.push_back(angle_of(at));
      }
    }
  std::sort(angles.begin(), angles.end());
  return angles;
}

std::string Intersection_builder::words() const {
  std::string curves, parts;
  for (const Curves& c : curves_) append(curves, " and ", c.count == 1 ? c.name : in_plural(c.name, c.count));
  if (!crossings_.empty()) append(curves, " ", crossings_);
  std::size_t loops = 0, arcs = 0;
  for (const Intersection_curve& component : components_) {
    loops += component.is_closed() ? 1 : 0;
    arcs += !component.is_closed() && !component.is_isolated() ? 1 : 0;
  }
  if (loops > 0) append(parts, ", ", count_in_words(loops) + (loops == 1 ? " closed loop" : " closed loops"));
  if (arcs > 0) append(parts, ", ", count_in_words(arcs) + (arcs == 1 ? " open arc" : " open arcs"));
  return parts.empty() ? curves : curves + ": " + parts;
}

Quadric_intersection Intersection_builder::finish(const std::string& segre) const {
  Quadric_intersection result;
  result.segre = segre;
  result.singular_points = singular_points_;
  result.components = components_;
  result.type = words();
  if (!surface_.empty()) {
    result.status = Intersection_status::surface;
    result.type = curves_.empty() ? surface_ : surface_ + ", and " + result.type;
  } else if (curves_.empty()) {
    result.status = Intersection_status::empty;
    result.type = "empty";
    result.singular_points.clear();
  }
  return result;
}

}  // namespace cgal_blend
