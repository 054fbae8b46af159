// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_SAMPLE_CURVE_H
#define CGAL_BLEND_SRC_SAMPLE_CURVE_H

#include <cgal_blend/blend_mesh.h>

#include <cmath>
#include <vector>

namespace cgal_blend {

inline constexpr double largest_chord_turn = 0.35;  // radians between neighbouring chords
inline constexpr int most_chord_halvings = 12;

/// Several points that move together with a parameter, such as one Bezier column of a blend.
using Point_row = std::vector<Point_3>;

/// Returns true if the middle is within the tolerance of the chord for each point, and turns little.
inline bool is_chord_good(const Point_row& a, const Point_row& middle, const Point_row& b, double tolerance) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vector_3 p = middle[i] - a[i], q = b[i] - middle[i], chord = b[i] - a[i];
    const double height = CGAL::cross_product(p, chord).squared_length();
    if (height > tolerance * tolerance * chord.squared_length()) return false;
    const double cosine = p * q / std::sqrt(p.squared_length() * q.squared_length());
    if (cosine < std::cos(largest_chord_turn / 2) && chord.squared_length() > tolerance * tolerance) return false;
  }
  return true;
}

/// Appends parameters between two, excluding the first and including the last.
template <class Evaluate>
void halve_chords(const Evaluate& at, double a, const Point_row& at_a, double b, const Point_row& at_b,
                  double tolerance, int halvings, std::vector<double>& parameters) {
  const double m = (a + b) / 2;
  const Point_row at_m = at(m);
  if (halvings > 0 && !is_chord_good(at_a, at_m, at_b, tolerance)) {
    halve_chords(at, a, at_a, m, at_m, tolerance, halvings - 1, parameters);
    halve_chords(at, m, at_m, b, at_b, tolerance, halvings - 1, parameters);
  } else {
    parameters.push_back(b);
  }
}

/// Halves the steps between ascending parameters until chords are within the tolerance and turn by less than
/// `largest_chord_turn`.
/// \param at returns the points at a parameter, always as many
template <class Evaluate>
[[nodiscard]] std::vector<double> refined_parameters(const Evaluate& at, const std::vector<double>& start,
                                                     double tolerance) {
  std::vector<double> parameters{start.front()};
  Point_row before = at(start.front());
  for (std::size_t i = 1; i < start.size(); ++i) {
    const Point_row next = at(start[i]);
    halve_chords(at, start[i - 1], before, start[i], next, tolerance, most_chord_halvings, parameters);
    before = next;
  }
  return parameters;
}

}  // namespace cgal_blend

#endif
