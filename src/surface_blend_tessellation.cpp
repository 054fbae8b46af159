// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_blend_tessellation.h"

#include "join_rows.h"
#include "sample_curve.h"

#include <algorithm>
#include <cmath>

namespace cgal_blend {

namespace {

constexpr std::size_t first_spans = 16;
constexpr std::size_t fewest_rows = 6, most_rows = 400;

/// The blend's parameters of the vertices that a side insists on, ascending; empty if it does not.
std::vector<double> fixed_parameters(const Surface_blend& blend, int side) {
  std::vector<double> fixed;
  for (const double p : blend.curve(side).fixed_parameters()) fixed.push_back(blend.parameter_map(side).inverse(p));
  std::sort(fixed.begin(), fixed.end());
  return fixed;
}

/// Parameters in which all rows but fixed ones are sampled; 1 included if the blend is open.
std::vector<double> inner_parameters(const Surface_blend& blend, const std::vector<double>& fixed, double tolerance) {
  std::vector<double> start = fixed;
  if (start.empty())
    for (std::size_t i = 0; i < first_spans; ++i) start.push_back(static_cast<double>(i) / first_spans);
  const bool closed = blend.is_closed();
  if (closed) start.push_back(start.front() + 1);
  if (!closed && start.back() < 1) start.push_back(1);
  const auto at = [&](double s) {
    const Blend_column column = blend.column(closed && s >= 1 ? s - 1 : s);
    return Point_row{column.at(0), column.at(0.25), column.at(0.5), column.at(0.75), column.at(1)};
  };
  std::vector<double> parameters = refined_parameters(at, start, tolerance);
  if (closed) {
    parameters.pop_back();
    for (double& s : parameters) s = s >= 1 ? s - 1 : s;
    std::sort(parameters.begin(), parameters.end());
  }
  return parameters;
}

/// Steps in t that keep chords within the tolerance: a Bezier curve of degree n strays from a chord over 1 / m of it by at
/// most n (n - 1) / (8 m^2) times its largest second difference (Filip, Magedson, Markot, CAGD 3 (1986)).
std::size_t steps_across(const std::vector<Blend_column>& columns, double tolerance) {
  double largest = 0;
  for (const Blend_column& column : columns)
    for (int i = 0; i + 2 <= column.degree; ++i) {
      const Vector_3 second =
          (column.control[i + 2] - column.control[i + 1]) - (column.control[i + 1] - column.control[i]);
      largest = std::max(largest, std::sqrt(second.squared_length()));
    }
  const int n = columns.front().degree;
  const double steps = std::sqrt(n * (n - 1) * largest / (8 * tolerance));
  return std::clamp(static_cast<std::size_t>(std::ceil(steps)), fewest_rows, most_rows);
}

Trim_curve boundary(const Surface_blend& blend, int side, const std::vector<double>& parameters, Triangle_soup& soup) {
  Trim_curve curve;
  curve.closed = blend.is_closed();
  for (const double s : parameters) {
    const double parameter = blend.parameter_map(side)(s).parameter;
    curve.vertices.push_back(soup.add(blend.curve(side).at(parameter).point));
    curve.parameters.push_back(parameter);
    curve.outward.push_back(blend.direction(side, s));
  }
  return curve;
}

/// Exactly the vertices of a chain, whatever the inverse of the map has rounded.
void use_fixed(const Surface_blend& blend, int side, Trim_curve& curve, Triangle_soup& soup) {
  const std::vector<double>& fixed = blend.curve(side).fixed_parameters();
  const auto distance = [](double a, double b) { return std::min(std::abs(a - b), 1 - std::abs(a - b)); };
  for (std::size_t i = 0; i < curve.vertices.size(); ++i) {
    curve.parameters[i] = *std::min_element(fixed.begin(), fixed.end(), [&](double a, double b) {
      return distance(a, curve.parameters[i]) < distance(b, curve.parameters[i]);
    });
    soup.points[curve.vertices[i]] = blend.curve(side).at(curve.parameters[i]).point;
  }
}

}  // namespace

std::array<Trim_curve, 2> tessellate(const Surface_blend& blend, const Tessellation_options& options,
                                     Triangle_soup& soup) {
  const std::array<std::vector<double>, 2> fixed{fixed_parameters(blend, 0), fixed_parameters(blend, 1)};
  const std::vector<double> inner = inner_parameters(blend, fixed[0].empty() ? fixed[1] : fixed[0], options.tolerance);
  std::vector<Blend_column> columns;
  for (const double s : inner) columns.push_back(blend.column(s));
  const std::size_t steps = steps_across(columns, options.tolerance);

  std::array<Trim_curve, 2> curves;
  std::array<Point_line, 2> ends;
  for (int side = 0; side < 2; ++side) {
    const std::vector<double>& parameters = fixed[side].empty() ? inner : fixed[side];
    curves[side] = boundary(blend, side, parameters, soup);
    if (!fixed[side].empty()) use_fixed(blend, side, curves[side], soup);
    ends[side] = {curves[side].vertices, parameters};
  }
  Point_line before = ends[0];
  for (std::size_t k = 1; k <= steps; ++k) {
    Point_line next = ends[1];
    if (k < steps) {
      next = {{}, inner};
      const double t = static_cast<double>(k) / static_cast<double>(steps);
      for (const Blend_column& column : columns) next.vertices.push_back(soup.add(column.at(t)));
    }
    join_rows(before, next, blend.is_closed(), options.part, soup);
    before = std::move(next);
  }
  return curves;
}

}  // namespace cgal_blend
