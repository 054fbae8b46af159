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

std::string in_plural(const std::string& name, int count) {
  const std::string shape = name.substr(0, name.find(" with "));
  return count_in_words(static_cast<std::size_t>(count)) + " " + shape + "s" + name.substr(shape.size());
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

void Intersection_builder::note(const std::string& name, int multiplicity) {
  const std::string whole = multiplicity == 1   ? name
                            : multiplicity == 2 ? "double " + name
                            : multiplicity == 3 ? "triple " + name
                                                : "quadruple " + name;
  const auto known = std::find_if(curves_.begin(), curves_.end(), [&](const auto& c) { return c.first == whole; });
  if (known == curves_.end())
    curves_.emplace_back(whole, 1);
  else
    ++known->second;
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
  note(name, multiplicity);
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
  note("line", multiplicity);
  const Projective<Real> from = to_projective(p);
  const Direction infinite = p[3].is_zero() ? Direction{1, 0} : Direction{q[3], -from[3]};
  add_arcs(std::make_shared<const Rational_curve>(std::vector<Projective<Real>>{from, q}), {{angle_of(infinite), true}}, 1,
           multiplicity);
}

void Intersection_builder::add_quartic_loop(const std::string& name, const std::shared_ptr<const Projective_curve>& loop,
                                            const std::vector<Direction>& infinite) {
  if (curves_.empty()) note(name, 1);  // all loops are one curve
  std::vector<Break> breaks;
  for (const Direction& at : infinite) breaks.push_back({angle_of(at), true});
  add_arcs(loop, breaks, 4, 1);
}

void Intersection_builder::add_isolated_point(const Surd_vector& p) {
  if (!add_singular_point(p)) return;
  note("isolated point", 1);
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
  for (std::size_t i = 0; i < breaks.size(); ++i) {
    const bool is_last = i + 1 == breaks.size();
    Break end = breaks[is_last ? 0 : i + 1];
    if (is_last) end.angle += pi;
    add_arc(curve, breaks[i], end, degree, multiplicity);
  }
}

void Intersection_builder::add_arc(const std::shared_ptr<const Projective_curve>& curve, Break begin, Break end,
                                   int degree, int multiplicity) {
  if (begin.is_infinite || end.is_infinite) {
    const std::vector<Real> entries = entries_to_box(*curve, begin, end);
    if (entries.empty()) return;
    if (begin.is_infinite) begin.angle = entries.front();
    if (end.is_infinite) end.angle = entries.back();
    if (begin.angle == end.angle) return;
  }
  auto arc = std::make_shared<internal::Curve_arc>(*surfaces_);
  arc->curve = curve;
  arc->set_range(begin.angle, end.angle);
  arc->degree = degree;
  arc->multiplicity = multiplicity;
  components_.emplace_back(arc);
}

// Angles where the arc meets the surface of the box, ascending.
std::vector<Real> Intersection_builder::entries_to_box(const Projective_curve& curve, const Break& begin,
                                                       const Break& end) const {
  std::vector<Real> angles;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const double wall : {options_.box, -options_.box}) {
      Projective<Real> plane{0, 0, 0, -wall};
      plane[axis] = 1;
      for (const Direction& at : curve.meets_plane(plane)) {
        Real angle = angle_of(at);
        if (angle <= begin.angle) angle += pi;
        if (angle >= end.angle) continue;
        const Projective<Dual<Real>> x = curve.at({at.c, 0}, {at.s, 0});
        const Real limit = options_.box * abs(x[3].value) * (1 + on_box);
        const bool is_inside =
            std::all_of(x.begin(), x.begin() + 3, [&](const Dual<Real>& c) { return abs(c.value) <= limit; });
        if (is_inside) angles.push_back(angle);
      }
    }
  std::sort(angles.begin(), angles.end());
  return angles;
}

std::string Intersection_builder::words() const {
  std::string curves, parts;
  for (const auto& [name, count] : curves_) append(curves, " and ", count == 1 ? name : in_plural(name, count));
  for (const std::string& remark : remarks_) append(curves, " ", remark);
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
