// SPDX-License-Identifier: GPL-3.0-or-later
#include "hermite_transition.h"

#include <CGAL/assertions.h>

#include <utility>

namespace cgal_blend {

namespace {

using Section = std::optional<std::vector<Ring>>;

/// Equation 6: the difference quotient of two functions whose planes are `distance` apart.
Planar_function difference(Planar_function high, Planar_function low, double distance) {
  return [high = std::move(high), low = std::move(low), distance](const Point_2& p) {
    return (high(p) - low(p)) / distance;
  };
}

struct Slope {
  Planar_function function;
  bool one_sided = false;
};

bool present(const Section& section) { return section && !section->empty(); }

/// Central where both shifted sections look like the opening; else against the opening itself, on the kept side if its
/// section will do, and a vertical wall where there is no section at all.
Slope slope_of(const Opening_sections& side, const Planar_function& opening, bool kept_above,
               const Opening_model& model) {
  const auto like_opening = [&](const Section& s) { return present(s) && s->size() == side.rings.size(); };
  const bool below = like_opening(side.below), above = like_opening(side.above);
  if (below && above) return {difference(model(*side.above), model(*side.below), 2 * side.step), false};
  bool use_above = kept_above ? above || (!below && present(side.above)) : above && !below;
  if (!below && !above && !(kept_above ? present(side.above) : present(side.below))) use_above = !kept_above;
  if (use_above && present(side.above)) return {difference(model(*side.above), opening, side.step), true};
  if (!use_above && present(side.below)) return {difference(opening, model(*side.below), side.step), true};
  return {[](const Point_2&) { return 0.0; }, true};
}

/// The Bezier curve of degree 5 over its parameter, whose abscissae are equidistant: w = eta(t).
double bezier(const std::array<double, 2>& middle, double t) {
  const double s = 1 - t;
  return 5 * s * s * s * s * t * 0.2 + 10 * s * s * s * t * t * middle[0] + 10 * s * s * t * t * t * middle[1] +
         5 * s * t * t * t * t * 0.8 + t * t * t * t * t;
}

}  // namespace

Hermite_transition::Hermite_transition(const std::array<Opening_sections, 2>& sides, double height,
                                       const Transition_options& options)
    : height_(height), eta_(options.eta), weight_(options.weight) {
  CGAL_precondition(height > 0 && weight_[0] > 0 && weight_[1] > 0);
  const Opening_model model = options.model ? options.model : distance_opening();
  for (std::size_t i = 0; i < 2; ++i) {
    CGAL_precondition(!sides[i].rings.empty());
    rings_[i] = sides[i].rings;
    opening_[i] = model(sides[i].rings);
    Slope slope = slope_of(sides[i], opening_[i], i == 1, model);
    slope_[i] = std::move(slope.function);
    one_sided_[i] = slope.one_sided;
  }
}

double Hermite_transition::operator()(const Point_3& p) const {
  const Point_2 q(p.x(), p.y());
  const double w = bezier(eta_, p.z() / height_), v = w - 1;
  const double f1 = weight_[0] * v * v * (1 + 2 * w), f2 = weight_[1] * w * w * (3 - 2 * w);
  const double f3 = weight_[0] * w * v * v, f4 = weight_[1] * w * w * v;
  double psi = 0;  // equation 1; what has no weight is not asked for
  if (f1 != 0) psi += f1 * opening_[0](q);
  if (f2 != 0) psi += f2 * opening_[1](q);
  if (f3 != 0) psi += f3 * height_ * slope_[0](q);
  if (f4 != 0) psi += f4 * height_ * slope_[1](q);
  return psi;
}

}  // namespace cgal_blend
