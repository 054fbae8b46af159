// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/surface_blend.h>

#include <cmath>
#include <utility>

namespace cgal_blend {

namespace {

constexpr double default_distance = 0.4;  // of the mean distance; an arc of 90 degrees has 0.39
constexpr double difference_step = 1e-5;  // of the parameter s
constexpr int sign_samples = 32;
constexpr double least_mean_direction = 0.02;  // of unit vectors, below which they cancel out

Vector_3 unit(const Vector_3& v) { return v / std::sqrt(v.squared_length()); }

/// Raises the degree of a Bezier curve by one.
void elevate(Blend_column& column) {
  const int n = column.degree + 1;
  std::array<Point_3, 7> raised = column.control;
  for (int i = 1; i < n; ++i) {
    const double share = static_cast<double>(i) / n;
    raised[i] = column.control[i] + share * (column.control[i - 1] - column.control[i]);
  }
  raised[n] = column.control[n - 1];
  column = {raised, n};
}

}  // namespace

Point_3 Blend_column::at(double t) const {
  std::array<Point_3, 7> p = control;
  for (int level = degree; level > 0; --level)  // de Casteljau
    for (int i = 0; i < level; ++i) p[i] = p[i] + t * (p[i + 1] - p[i]);
  return p[0];
}

Vector_3 Blend_column::derivative(double t) const {
  std::array<Vector_3, 6> d;
  for (int i = 0; i < degree; ++i) d[i] = control[i + 1] - control[i];
  for (int level = degree - 1; level > 0; --level)
    for (int i = 0; i < level; ++i) d[i] = d[i] + t * (d[i + 1] - d[i]);
  return degree * d[0];
}

Surface_blend::Surface_blend(Boundary_curve first, Boundary_curve second, Correspondence correspondence,
                             Surface_blend_options options)
    : curves_{std::move(first), std::move(second)},
      correspondence_(std::move(correspondence)),
      options_(std::move(options)) {
  for (std::size_t side : {0, 1}) {
    if (!options_.sides[side].distance)
      options_.sides[side].distance = Adjusting_function(default_distance * correspondence_.mean_distance);
    choose_sign(side);
  }
}

int Surface_blend::degree() const noexcept { return 3 + (options_.middle ? 1 : 0) + (options_.g2 ? 2 : 0); }

Boundary_point Surface_blend::boundary_point(int side, double s) const {
  const Parameter_map::Value value = parameter_map(side)(s);
  Boundary_point p = curve(side).at(value.parameter);
  p.derivative = value.slope * p.derivative;
  return p;
}

/// Equations 3 and 4 without the sign, with unit vectors.
Vector_3 Surface_blend::direction_at(std::size_t side, const Boundary_point& p) const {
  const double lambda = options_.sides[side].direction;
  const bool has_transversal = p.transversal != CGAL::NULL_VECTOR;
  const Vector_3 across = unit(has_transversal ? p.transversal : CGAL::cross_product(p.normal, p.derivative));
  const Vector_3 along = unit(p.derivative);
  return sign_[side] * std::sqrt(1 - lambda * lambda) * across + lambda * along;
}

Vector_3 Surface_blend::direction(int side, double s) const {
  return direction_at(static_cast<std::size_t>(side), boundary_point(side, s));
}

/// One sign for the whole curve, along which the direction is continuous. On closed curves that by which the mean
/// direction leads to the other centroid: the curves may be of very different size, when nearness of points misleads.
/// Where directions cancel out, as round a hole in a plane, that which leads nearer to the other points.
void Surface_blend::choose_sign(std::size_t side) {
  if (options_.sides[side].flip) {
    sign_[side] = *options_.sides[side].flip ? -1 : 1;
    const bool has_transversal = boundary_point(static_cast<int>(side), 0).transversal != CGAL::NULL_VECTOR;
    if (!has_transversal && correspondence_.maps[side].is_reversed()) sign_[side] = -sign_[side];
    return;
  }
  const double lambda = options_.sides[side].direction;
  double nearer = 0;
  Vector_3 mean(0, 0, 0), chord(0, 0, 0);
  for (int i = 0; i < sign_samples; ++i) {
    const double s = (i + 0.5) / sign_samples;
    const Boundary_point p = boundary_point(static_cast<int>(side), s);
    const Vector_3 to_other = boundary_point(1 - static_cast<int>(side), s).point - p.point;
    const Vector_3 across = direction_at(side, p) - lambda * unit(p.derivative);
    if (to_other.squared_length() > 0) nearer += across * unit(to_other);
    mean = mean + across / sign_samples;
    chord = chord + to_other;
  }
  const double onward = chord == CGAL::NULL_VECTOR ? 0 : mean * unit(chord);
  sign_[side] = (is_closed() && std::abs(onward) > least_mean_direction ? onward : nearer) < 0 ? -1 : 1;
}

Surface_blend::End Surface_blend::end(std::size_t side, double s) const {
  const Boundary_point p = boundary_point(static_cast<int>(side), s);
  return {p, direction_at(side, p), (*options_.sides[side].distance)(s)};
}

Blend_column Surface_blend::column(double s) const {
  const End a = end(0, s), b = end(1, s);
  const Point_3 inner_a = a.at.point + a.distance * a.towards, inner_b = b.at.point + b.distance * b.towards;
  Blend_column column;
  if (options_.middle)
    column = {{a.at.point, inner_a, options_.middle(s, CGAL::midpoint(inner_a, inner_b)), inner_b, b.at.point,
               Point_3(), Point_3()},
              4};
  else
    column = {{a.at.point, inner_a, inner_b, b.at.point, Point_3(), Point_3(), Point_3()}, 3};
  if (!options_.g2) return column;
  elevate(column);
  elevate(column);
  match_curvature(0, s, a, column);
  match_curvature(1, s, b, column);
  return column;
}

/// Two surfaces with a common tangent plane along a curve have the same curvature along it if the normal curvatures agree
/// in one direction across it: Pegna, Wolter, Geometrical criteria to guarantee curvature continuity of blend surfaces,
/// J. Mech. Design 114 (1992). Here the direction is T. Of a Bezier curve of degree n with n b = P', b = b1 - b0,
/// P'' = n (n - 1) (b2 - 2 b1 + b0), so P''. N = II(P', P') asks for (b2 - b0) . N = n / (n - 1) II(b, b): b2 is moved
/// along N until it holds.
void Surface_blend::match_curvature(std::size_t side, double s, const End& end, Blend_column& column) const {
  const int n = column.degree, first = side == 0 ? 1 : n - 1, second = side == 0 ? 2 : n - 2;
  const double parameter = correspondence_.maps[side](s).parameter;
  const double form = curves_[side].second_form(parameter, column.control[first] - end.at.point);
  const double wanted = form * n / (n - 1), height = (column.control[second] - end.at.point) * end.at.normal;
  column.control[second] = column.control[second] + (wanted - height) * end.at.normal;
}

Vector_3 Surface_blend::normal(double s, double t) const {
  if (t == 0 || t == 1) {
    const Vector_3 along = boundary_point(t == 0 ? 0 : 1, s).derivative;
    return CGAL::cross_product(along, column(s).derivative(t));
  }
  const double low = is_closed() ? s - difference_step : std::max(0.0, s - difference_step);
  const double high = is_closed() ? s + difference_step : std::min(1.0, s + difference_step);
  const auto wrapped = [&](double x) { return is_closed() ? x - std::floor(x) : x; };
  const Vector_3 along = (at(wrapped(high), t) - at(wrapped(low), t)) / (high - low);
  return CGAL::cross_product(along, column(s).derivative(t));
}

std::vector<Point_3> Surface_blend::sample(std::size_t columns, std::size_t rows) const {
  std::vector<Point_3> points(columns * rows);
  for (std::size_t i = 0; i < columns; ++i) {
    const Blend_column column_i =
        column(static_cast<double>(i) / static_cast<double>(is_closed() ? columns : columns - 1));
    for (std::size_t k = 0; k < rows; ++k)
      points[k * columns + i] = column_i.at(static_cast<double>(k) / static_cast<double>(rows - 1));
  }
  return points;
}

Surface_blend Surface_blend::scaled(double factor) const {
  Surface_blend copy = *this;
  for (Blend_side_options& side : copy.options_.sides) side.distance = side.distance->scaled(factor);
  return copy;
}

}  // namespace cgal_blend
