// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_ADJUSTING_FUNCTION_H
#define CGAL_BLEND_ADJUSTING_FUNCTION_H

#include <CGAL/assertions.h>
#include <CGAL/number_type_config.h>

#include <array>
#include <cmath>
#include <functional>
#include <type_traits>
#include <utility>

namespace cgal_blend {

// An adjusting function is any `double d(double s)`, s in [0, 1], > 0 and once differentiable: how far the inner control
// point of a blend lies from its boundary curve, length units. On closed curves d(0) = d(1).

/// Parabola through three pairs of parameter and distance.
/// Source: Cheng, Gao, Constructing blending surfaces for two arbitrary surfaces (2003), section 4.
class Quadratic_adjustment {
 public:
  using Pair = std::array<double, 2>;  ///< s, d

  /// \param pairs three different parameters
  explicit Quadratic_adjustment(const std::array<Pair, 3>& pairs) : pairs_(pairs) {
    CGAL_precondition(is_valid(pairs));
  }

  [[nodiscard]] static bool is_valid(const std::array<Pair, 3>& p) {
    for (const Pair& pair : p)
      if (!std::isfinite(pair[0]) || !std::isfinite(pair[1])) return false;
    return p[0][0] != p[1][0] && p[1][0] != p[2][0] && p[0][0] != p[2][0];
  }

  [[nodiscard]] double operator()(double s) const {
    double sum = 0;
    for (int i = 0; i < 3; ++i) {  // Lagrange
      const double a = pairs_[(i + 1) % 3][0], b = pairs_[(i + 2) % 3][0];
      sum += pairs_[i][1] * ((s - a) / (pairs_[i][0] - a)) * ((s - b) / (pairs_[i][0] - b));
    }
    return sum;
  }

 private:
  std::array<Pair, 3> pairs_;
};

/// The closed form for closed curves: from `least` at s = 0 to `largest` at s = 1/2 and back.
/// Source: Cheng, Gao (2003), section 4.
struct Cosine_adjustment {
  double least = 0, largest = 0;

  [[nodiscard]] double operator()(double s) const {
    return (largest - least) * (1 - std::cos(2 * CGAL_PI * s)) / 2 + least;
  }
};

/// Any adjusting function, by value; a number is a constant one.
class Adjusting_function {
 public:
  Adjusting_function(double constant) : evaluate_([constant](double) { return constant; }) {}

  template <class Model, class = std::enable_if_t<!std::is_same_v<std::decay_t<Model>, Adjusting_function> &&
                                                  !std::is_arithmetic_v<std::decay_t<Model>>>>
  Adjusting_function(Model model) : evaluate_(std::move(model)) {}

  [[nodiscard]] double operator()(double s) const { return evaluate_(s); }

  /// Returns the function times a factor.
  [[nodiscard]] Adjusting_function scaled(double factor) const {
    return Adjusting_function([f = evaluate_, factor](double s) { return factor * f(s); });
  }

 private:
  std::function<double(double)> evaluate_;
};

}  // namespace cgal_blend

#endif
