// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_CORRESPONDENCE_H
#define CGAL_BLEND_CORRESPONDENCE_H

#include <cgal_blend/boundary_curve.h>
#include <cgal_blend/status.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace cgal_blend {

/// Change of parameter: strictly monotone, once differentiable, from [0, 1] onto [0, 1] or, on closed curves, onto
/// an interval of length 1; parameters of the curve are meant modulo 1 there. By value.
class Parameter_map {
 public:
  /// The identity.
  Parameter_map() = default;
  /// Monotone cubic interpolation.
  /// \param s ascending from 0 to 1; at least two
  /// \param values strictly monotone; last - first is 1 or -1 if `closed`
  Parameter_map(const std::vector<double>& s, const std::vector<double>& values, bool closed);

  struct Value {
    double parameter;  ///< of the curve, in [0, 1]
    double slope;      ///< its derivative by s, not 0
  };
  [[nodiscard]] Value operator()(double s) const;
  /// Returns the s in [0, 1] (below 1 if closed) at which the map takes a parameter of the curve.
  [[nodiscard]] double inverse(double parameter) const;
  [[nodiscard]] bool is_reversed() const noexcept { return reversed_; }

 private:
  struct Interpolant;
  [[nodiscard]] double raw(double s) const;

  std::shared_ptr<const Interpolant> interpolant_;  // null: identity
  bool reversed_ = false, closed_ = false;
  double first_ = 0;
};

/// How points of two boundary curves are paired.
enum class Matching {
  parameter,  ///< the curves' own parameters
  arc_length,  ///< equal fractions of arc length; direction, and start on closed curves, so that pairs are nearest; closed
               ///< curves are compared after carrying one to the other without twist
  least_twist  ///< as before, then slid along the curves until pairs are nearest in sum
};

struct Correspondence_options {
  Matching matching = Matching::arc_length;
  std::optional<bool> reversed;  ///< second curve runs against its parameter; none: whichever brings pairs nearer
  std::optional<double> start;   ///< closed curves: parameter of the second curve that is paired with 0 of the first
};

/// The common parameter of two boundary curves.
struct Correspondence {
  Diagnosis diagnosis;  ///< `ok`, `curves_do_not_correspond` or `singular_boundary`
  std::array<Parameter_map, 2> maps;
  bool closed = false;
  std::array<double, 2> length{};  ///< of the curves, length units
  double mean_distance = 0;        ///< between paired points, length units

  [[nodiscard]] bool ok() const noexcept { return diagnosis.ok(); }
};

/// Pairs the points of two curves. Refuses a closed curve with an open one, and curves that are not regular: where the
/// derivative or the normal vanishes or turns at once.
/// Source: Cheng, Gao, Constructing blending surfaces for two arbitrary surfaces (2003), section 4, asks for equal
/// directions; the rest is this library's.
[[nodiscard]] Correspondence correspond(const Boundary_curve& first, const Boundary_curve& second,
                                        const Correspondence_options& options = {});

/// Finds a point where a curve or the surface along it is not regular: derivative or normal 0 or not finite, or turning
/// by more than 30 degrees within a parameter interval of `least_parameter_step`.
[[nodiscard]] Diagnosis check_regular(const Boundary_curve& curve);

inline constexpr double least_parameter_step = 1e-7;

}  // namespace cgal_blend

#endif
