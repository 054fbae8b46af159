// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/correspondence.h>

#include "base_surface.h"
#include "slide_pairs.h"

#include <Eigen/Geometry>

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace cgal_blend {

namespace {

constexpr std::size_t pairs = 96;           // in which the direction and the start are sought
constexpr double nearly_concentric = 1e-3;  // distance of centroids, of the curves' extent
constexpr std::size_t spans = 128;          // of the table of arc lengths

/// Arc length of a curve as a function of its parameter.
struct Length_table {
  std::vector<double> parameters, lengths;  // from 0 to the length
};

Length_table measure(const Boundary_curve& curve) {
  Length_table table{{0}, {0}};
  const auto speed = [&](double s) { return std::sqrt(curve.at(s).derivative.squared_length()); };
  for (std::size_t i = 0; i < spans; ++i) {
    const double a = static_cast<double>(i) / spans, b = static_cast<double>(i + 1) / spans;
    table.parameters.push_back(b);
    table.lengths.push_back(table.lengths.back() + boost::math::quadrature::gauss<double, 7>::integrate(speed, a, b));
  }
  return table;
}

/// The map from arc-length fraction to parameter.
Parameter_map by_length(const Length_table& table, bool closed) {
  std::vector<double> fractions;
  for (const double length : table.lengths) fractions.push_back(length / table.lengths.back());
  fractions.back() = 1;
  return {fractions, table.parameters, closed};
}

using Points = std::vector<Point_3>;

/// Points at equal steps of arc length: `pairs` of a closed curve, one more of an open one.
Points points_at_equal_lengths(const Boundary_curve& curve, const Parameter_map& map) {
  Points points;
  for (std::size_t i = 0; i < pairs + (curve.is_closed() ? 0 : 1); ++i)
    points.push_back(curve.at(map(static_cast<double>(i) / pairs).parameter).point);
  return points;
}

/// Centroid and axis, twice the area vector, of a closed curve.
struct Ring {
  Vec centroid = Vec::Zero(), axis = Vec::Zero();

  explicit Ring(const Points& points) {
    for (const Point_3& p : points) centroid += to_vec(p) / static_cast<double>(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      axis += (to_vec(points[i]) - centroid).cross(to_vec(points[(i + 1) % points.size()]) - centroid);
  }
};

/// Carries closed curve `p` to `q` without twist: its axis is turned into the line between the centroids and then into the
/// axis of `q`, each time by the smallest rotation. Nearness of points themselves says little between curves at an angle.
Points carried(const Points& p, const Points& q) {
  Ring from(p), to(q);
  Vec chord = to.centroid - from.centroid;
  const double size = std::sqrt(from.axis.norm() + to.axis.norm());
  if (chord.norm() < nearly_concentric * size) chord = from.axis;
  if (!(from.axis.norm() > 0 && to.axis.norm() > 0)) return p;
  if (from.axis.dot(chord) < 0) from.axis = -from.axis;
  if (to.axis.dot(chord) < 0) to.axis = -to.axis;
  const Eigen::Quaterniond turn =
      Eigen::Quaterniond::FromTwoVectors(chord, to.axis) * Eigen::Quaterniond::FromTwoVectors(from.axis, chord);
  Points result;
  for (const Point_3& x : p) result.push_back(to_point(to.centroid + turn * (to_vec(x) - from.centroid)));
  return result;
}

/// How the second curve runs: at fraction `shift` + or - that of the first.
struct Placement {
  bool reversed = false;
  double shift = 0;
};

double cost_of(const Points& p, const Points& q, bool reversed, std::size_t shift, bool closed) {
  double sum = 0;
  const std::size_t n = q.size();
  for (std::size_t i = 0; i < p.size(); ++i) {
    const std::size_t j = closed ? (reversed ? shift + n - i : shift + i) % n : (reversed ? n - 1 - i : i);
    sum += CGAL::squared_distance(p[i], q[j]);
  }
  return sum;
}

/// The best shift between whole steps: a parabola through the cost at the best step and its neighbours.
double between_steps(double before, double at, double after) {
  const double bend = before - 2 * at + after;
  return bend > 0 ? std::clamp((before - after) / (2 * bend), -0.5, 0.5) : 0;
}

Placement nearest_placement(const Points& p, const Points& q, bool closed, const std::optional<bool>& reversed) {
  Placement best;
  double least = std::numeric_limits<double>::infinity();
  for (const bool r : {false, true}) {
    if (reversed && *reversed != r) continue;
    for (std::size_t k = 0; k < (closed ? q.size() : 1); ++k) {
      const double cost = cost_of(p, q, r, k, closed);
      if (!(cost < least)) continue;
      least = cost;
      best = {r, static_cast<double>(k)};
    }
  }
  if (closed) {
    const std::size_t n = q.size(), k = static_cast<std::size_t>(best.shift);
    best.shift += between_steps(cost_of(p, q, best.reversed, (k + n - 1) % n, true), least,
                                cost_of(p, q, best.reversed, (k + 1) % n, true));
    best.shift /= static_cast<double>(n);
  }
  return best;
}

/// Follows `placement` and `pairing` (fractions of arc length) to the parameter of the second curve.
Parameter_map composed(const Length_table& table, bool closed, const Placement& placement, const Pairing& pairing) {
  const Parameter_map map = by_length(table, closed);
  std::vector<double> values;
  for (const double f : pairing.second) {
    const double g = closed ? placement.shift + (placement.reversed ? -f : f) : (placement.reversed ? 1 - f : f);
    const double turns = closed ? std::floor(g) : 0;
    values.push_back(turns + map(closed ? g - turns : g).parameter);
  }
  if (closed) values.back() = values.front() + (placement.reversed ? -1 : 1);
  return {pairing.s, values, closed};
}

Parameter_map composed_first(const Length_table& table, bool closed, const Pairing& pairing) {
  return composed(table, closed, {}, {pairing.s, pairing.first, pairing.first});
}

double mean_distance(const Boundary_curve& first, const Boundary_curve& second, const Correspondence& result) {
  double sum = 0;
  for (std::size_t i = 0; i < pairs; ++i) {
    const double s = static_cast<double>(i) / pairs;
    sum += std::sqrt(CGAL::squared_distance(first.at(result.maps[0](s).parameter).point,
                                            second.at(result.maps[1](s).parameter).point));
  }
  return sum / pairs;
}

/// The curves' own parameters, turned and shifted as the options say.
void pair_by_parameter(const Correspondence_options& options, Correspondence& result) {
  const bool reversed = options.reversed.value_or(false);
  const double start = result.closed ? options.start.value_or(0) : (reversed ? 1 : 0);
  if (!reversed && start == 0) return;
  result.maps[1] = Parameter_map({0, 1}, {start, start + (reversed ? -1 : 1)}, result.closed);
}

}  // namespace

Correspondence correspond(const Boundary_curve& first, const Boundary_curve& second,
                          const Correspondence_options& options) {
  Correspondence result;
  result.closed = first.is_closed();
  if (first.is_closed() != second.is_closed()) {
    result.diagnosis = {Status::curves_do_not_correspond, "one curve is closed and the other is open", {}, {}};
    return result;
  }
  for (const Boundary_curve* curve : {&first, &second})
    if (result.diagnosis = check_regular(*curve); !result.ok()) return result;
  const Length_table a = measure(first), b = measure(second);
  result.length = {a.lengths.back(), b.lengths.back()};
  if (options.matching == Matching::parameter) {
    pair_by_parameter(options, result);
  } else {
    const Parameter_map map_a = by_length(a, result.closed), map_b = by_length(b, result.closed);
    const Points q = points_at_equal_lengths(second, map_b);
    Points p = points_at_equal_lengths(first, map_a);
    if (result.closed) p = carried(p, q);
    Placement placement = nearest_placement(p, q, result.closed, options.reversed);
    if (result.closed && options.start) placement.shift = map_b.inverse(*options.start - std::floor(*options.start));
    const auto second_at = [&](double f) {
      const double g =
          result.closed ? placement.shift + (placement.reversed ? -f : f) : (placement.reversed ? 1 - f : f);
      return second.at(map_b(result.closed ? g - std::floor(g) : g).parameter).point;
    };
    const Pairing pairing =
        options.matching == Matching::least_twist ? slid_pairs(p, second_at, result.closed) : equal_pairs(spans);
    result.maps = {composed_first(a, result.closed, pairing), composed(b, result.closed, placement, pairing)};
  }
  result.mean_distance = mean_distance(first, second, result);
  return result;
}

}  // namespace cgal_blend
