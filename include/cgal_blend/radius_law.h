// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_RADIUS_LAW_H
#define CGAL_BLEND_RADIUS_LAW_H

#include <cgal_blend/status.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace cgal_blend {

// A radius law is a model of this concept: `double operator()(double s) const`, the ball's radius, length units, > 0, at
// the arc-length fraction s in [0, 1] of the blending curve. Optional: `std::array<double, 2> bounds() const`, the
// smallest and the largest radius; `Diagnosis check() const`, whether its data make a law at all; `Model closed() const`,
// the law to take on a closed curve, where s = 1 is the place of s = 0.

namespace internal {

inline Diagnosis wrong_radius(const char* what) {
  return {Status::invalid_parameter, what, std::nullopt, std::nullopt};
}

/// Returns `ok` if all are > 0 and finite.
inline Diagnosis check_radii(std::initializer_list<double> radii) {
  for (const double radius : radii)
    if (!(radius > 0 && std::isfinite(radius))) return wrong_radius("the radius must be greater than 0");
  return {};
}

}  // namespace internal

/// Radius that grows or shrinks evenly from one end of the curve to the other.
struct Linear_radius {
  double first = 0, last = 0;  ///< at s = 0 and s = 1, length units, > 0

  [[nodiscard]] double operator()(double s) const {
    const auto [low, high] = bounds();
    return std::clamp((1 - s) * first + s * last, low, high);  // rounding could exceed the bounds
  }
  [[nodiscard]] std::array<double, 2> bounds() const { return {std::min(first, last), std::max(first, last)}; }
  [[nodiscard]] Diagnosis check() const { return internal::check_radii({first, last}); }
};

/// Radius through given values: monotone between neighbouring ones, and smooth (once continuously differentiable) or
/// linear. On an open curve the first and the last value hold on to the ends; on a closed one the interpolation goes
/// round, unless there are different values at 0 and 1.
/// Source: Fritsch, Carlson, Monotone piecewise cubic interpolation, SIAM J. Numer. Anal. 17 (1980): the slopes of
/// parabolas, limited to the square [0, 3]^2 of their monotonicity region, so that neither sense nor start matter.
class Piecewise_radius {
 public:
  using Pair = std::array<double, 2>;  ///< arc-length fraction in [0, 1], radius > 0
  enum class Interpolation { smooth, linear };
  static constexpr double least_step = 1e-9;  ///< between fractions

  /// \param pairs two or more, fractions ascending by `least_step` or more; what `check` refuses gives a law that is refused
  explicit Piecewise_radius(std::vector<Pair> pairs, Interpolation interpolation = Interpolation::smooth)
      : pairs_(std::move(pairs)), interpolation_(interpolation) {
    if (!check().ok()) return;
    knots_ = pairs_;
    if (knots_.front()[0] > 0) knots_.insert(knots_.begin(), {0, knots_.front()[1]});
    if (knots_.back()[0] < 1) knots_.push_back({1, knots_.back()[1]});
    find_slopes();
  }

  /// Returns `ok`, or `invalid_parameter` with what is wrong with the pairs.
  [[nodiscard]] static Diagnosis check(const std::vector<Pair>& pairs) {
    using internal::wrong_radius;
    if (pairs.size() < 2) return wrong_radius("a radius that varies takes two pairs of fraction and radius or more");
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (!(pairs[i][0] >= 0 && pairs[i][0] <= 1))
        return wrong_radius("the fractions of a radius must lie between 0 and 1");
      if (i > 0 && !(pairs[i][0] - pairs[i - 1][0] >= least_step))
        return wrong_radius("the fractions of a radius must ascend");
      if (Diagnosis bad = internal::check_radii({pairs[i][1]}); !bad.ok()) return bad;
    }
    return {};
  }
  [[nodiscard]] Diagnosis check() const { return check(pairs_); }

  [[nodiscard]] double operator()(double s) const {
    if (knots_.empty()) return std::numeric_limits<double>::quiet_NaN();
    const auto above = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, s,
                                        [](double fraction, const Pair& knot) { return fraction < knot[0]; });
    const auto i = static_cast<std::size_t>(above - knots_.begin()) - 1;
    const double a = knots_[i][1], b = knots_[i + 1][1], h = knots_[i + 1][0] - knots_[i][0];
    const double u = (s - knots_[i][0]) / h, v = 1 - u;
    const double chord = v * a + u * b;
    // Hermite's cubic: by how much the slopes at its ends bend it away from the chord.
    const double bend = u * v * (v * (h * slopes_[i] - (b - a)) - u * (h * slopes_[i + 1] - (b - a)));
    const double radius = interpolation_ == Interpolation::linear ? chord : chord + bend;
    return std::clamp(radius, std::min(a, b), std::max(a, b));  // rounding could exceed the bounds
  }

  [[nodiscard]] std::array<double, 2> bounds() const {
    std::array<double, 2> range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const Pair& pair : pairs_) range = {std::min(range[0], pair[1]), std::max(range[1], pair[1])};
    return range;
  }

  [[nodiscard]] Piecewise_radius closed() const {
    Piecewise_radius result = *this;
    if (knots_.empty()) return result;
    std::vector<Pair> once = pairs_;  // in [0, 1)
    if (once.back()[0] == 1) {
      if (once.front()[0] == 0 && once.front()[1] != once.back()[1]) return result;
      if (once.front()[0] > 0) once.insert(once.begin(), {0, once.back()[1]});
      once.pop_back();
    }
    // Two more values on either side of the round: the slope at the nearest of them counts, the farther one makes it.
    const auto n = static_cast<std::ptrdiff_t>(once.size());
    result.knots_.clear();
    for (std::ptrdiff_t k = -2; k < n + 2; ++k) {
      const std::ptrdiff_t round = (k + 2 * n) / n - 2;
      const Pair& pair = once[static_cast<std::size_t>(k - round * n)];
      result.knots_.push_back({pair[0] + static_cast<double>(round), pair[1]});
    }
    result.find_slopes();
    return result;
  }

 private:
  void find_slopes() {
    const std::size_t last = knots_.size() - 1;
    const auto width = [&](std::size_t i) { return knots_[i + 1][0] - knots_[i][0]; };
    const auto secant = [&](std::size_t i) { return (knots_[i + 1][1] - knots_[i][1]) / width(i); };
    const auto limited = [](double slope, double secant) {
      return slope * secant > 0 ? std::copysign(std::min(std::abs(slope), 3 * std::abs(secant)), slope) : 0;
    };
    const auto at_end = [&](std::size_t i, std::size_t next) {  // of the first or the last interval
      const double slope = secant(i) + (secant(i) - secant(next)) * width(i) / (width(i) + width(next));
      return limited(slope, secant(i));
    };
    slopes_.assign(last + 1, secant(0));
    if (last == 1) return;
    slopes_.front() = at_end(0, 1);
    slopes_.back() = at_end(last - 1, last - 2);
    for (std::size_t i = 1; i < last; ++i) {
      const double before = secant(i - 1), after = secant(i), whole = width(i - 1) + width(i);
      const double parabola = (width(i) * before + width(i - 1) * after) / whole;
      slopes_[i] = before * after > 0 ? limited(limited(parabola, before), after) : 0;
    }
  }

  std::vector<Pair> pairs_;
  Interpolation interpolation_;
  std::vector<Pair> knots_;  // empty if the pairs are no law; else they cover [0, 1]
  std::vector<double> slopes_;
};

/// Any radius law, by value: a constant, or a model of the concept above.
class Radius_law {
 public:
  /// \param radius length units; what is not > 0 and finite gives a law that is refused
  Radius_law(double radius) : Radius_law([radius](double) { return radius; }, {radius, radius}) {}

  /// Laws without `bounds` are sampled at `samples` + 1 places, and refused if one of these is not > 0 and finite.
  template <class Model, class = std::enable_if_t<!std::is_same_v<std::decay_t<Model>, Radius_law> &&
                                                  std::is_invocable_r_v<double, const Model&, double>>>
  Radius_law(Model model) : Radius_law(model, bounds_of(model, 0)) {
    diagnosis_ = check_of(model, 0);
    on_closed_ = closed_of(model, 0);
    is_periodic_ = std::abs(on_closed_(0) - on_closed_(1)) <= 1e-9 * bounds_[1];
  }

  static constexpr int samples = 1024;

  /// Returns the radius at s in [0, 1], length units; s beyond is taken to the nearer end, on a closed curve once round.
  [[nodiscard]] double operator()(double s) const {
    const double at = begin_ + span_ * (turns_ ? s : std::clamp(s, 0.0, 1.0));
    return factor_ * (is_closed_ ? on_closed_(at - std::floor(at)) : on_open_(std::clamp(at, 0.0, 1.0)));
  }

  /// Returns `ok`, or `invalid_parameter` with what is wrong; the engines refuse such laws.
  [[nodiscard]] Diagnosis check() const {
    if (!diagnosis_.ok()) return diagnosis_;
    return internal::check_radii({smallest(), largest()});
  }

  /// Bounds of the radius, length units: exact for the laws of this header, of samples for others.
  [[nodiscard]] double smallest() const noexcept { return factor_ * bounds_[0]; }
  [[nodiscard]] double largest() const noexcept { return factor_ * bounds_[1]; }
  [[nodiscard]] bool is_constant() const noexcept { return bounds_[0] == bounds_[1]; }

  /// True if the law can hold on a closed curve: it ends as it begins.
  [[nodiscard]] bool is_periodic() const noexcept { return is_periodic_; }

  /// Returns the law on a closed curve, periodic in s with the period 1. The law must be periodic.
  [[nodiscard]] Radius_law with_period() const {
    CGAL_precondition(is_periodic_);
    Radius_law result = *this;
    result.is_closed_ = result.turns_ = true;
    return result;
  }

  /// Returns the law times `factor` > 0.
  [[nodiscard]] Radius_law scaled(double factor) const {
    CGAL_precondition(factor > 0);
    Radius_law result = *this;
    result.factor_ *= factor;
    return result;
  }

  /// Returns the law of the same curve run through the other way: at s what was at 1 - s.
  [[nodiscard]] Radius_law reversed() const {
    Radius_law result = *this;
    result.begin_ += span_;
    result.span_ = -span_;
    return result;
  }

  /// Returns the law of the same closed curve begun elsewhere: at s what was at s + `by`. The law must have its period.
  [[nodiscard]] Radius_law shifted(double by) const {
    CGAL_precondition(turns_);
    Radius_law result = *this;
    result.begin_ += by * span_;
    return result;
  }

  /// Returns the law of a part of the curve: at s what was at `from` + s (`to` - `from`), from 0 to 1 and, with a period,
  /// anywhere. It is not periodic, and its bounds are of samples.
  [[nodiscard]] Radius_law restricted(double from, double to) const {
    Radius_law result = *this;
    result.begin_ += from * span_;
    result.span_ *= to - from;
    result.is_periodic_ = result.turns_ = false;
    result.bounds_ = sampled_bounds(result);
    for (double& bound : result.bounds_) bound /= factor_;
    return result;
  }

 private:
  using Function = std::function<double(double)>;

  Radius_law(Function function, const std::array<double, 2>& bounds)
      : on_open_(std::move(function)), on_closed_(on_open_), bounds_(bounds) {}

  template <class Model>
  static auto bounds_of(const Model& model, int) -> decltype(model.bounds()) {
    return model.bounds();
  }
  template <class Model>
  static std::array<double, 2> bounds_of(const Model& model, long) {
    return sampled_bounds(model);
  }
  template <class Model>
  static std::array<double, 2> sampled_bounds(const Model& model) {
    std::array<double, 2> range{model(0.0), model(0.0)};
    for (int k = 1; k <= samples; ++k) {
      const double radius = model(static_cast<double>(k) / samples);
      if (!std::isfinite(radius)) return {radius, radius};
      range = {std::min(range[0], radius), std::max(range[1], radius)};
    }
    return range;
  }
  template <class Model>
  static auto check_of(const Model& model, int) -> decltype(model.check()) {
    return model.check();
  }
  template <class Model>
  static Diagnosis check_of(const Model&, long) {
    return {};
  }
  template <class Model>
  static auto closed_of(const Model& model, int) -> decltype(model.closed()) {
    return model.closed();
  }
  template <class Model>
  static Model closed_of(const Model& model, long) {
    return model;
  }

  Function on_open_, on_closed_;
  std::array<double, 2> bounds_;  // before scaling
  Diagnosis diagnosis_;
  bool is_periodic_ = true;
  bool is_closed_ = false;                    // the curve that the model is of
  bool turns_ = false;                        // and all of it is meant
  double begin_ = 0, span_ = 1, factor_ = 1;  // the law is factor (model at begin + s span)
};

}  // namespace cgal_blend

#endif
