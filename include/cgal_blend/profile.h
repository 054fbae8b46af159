// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_PROFILE_H
#define CGAL_BLEND_PROFILE_H

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace cgal_blend {

/// What a profile may depend on, in the plane of the ball's centre P and its contacts P1, P2. The apex P0 is where the
/// tangents at the contacts meet: P0 = P + (P1 - P + P2 - P) / (1 + cos(angle)).
/// Source: Liu et al., Mesh blending, The Visual Computer 21 (2005), section 4.2.
struct Profile_frame {
  double angle = 0;  ///< between P1 - P and P2 - P, radians in (0, pi)
  /// Curvature of the base surfaces at the contacts, in the profile's plane, times the radius; positive where the
  /// surface bends towards the ball's centre, 1 where it bends as the ball does.
  std::array<double, 2> curvature{};
};

/// A point of a profile: affine coordinates (sum 1) with respect to centre P, contact P1, apex P0, contact P2.
struct Profile_point {
  double centre = 0, contact_1 = 0, apex = 0, contact_2 = 0;
};

// A profile is a model of this concept: `Profile_point operator()(double u, const Profile_frame&) const`, a curve over
// u in [0, 1] from P1 to P2. Optional: `std::vector<double> kinks() const`, the parameters of its corners in (0, 1).

/// Arc of the ball itself; u is the fraction of the angle.
struct Arc_profile {
  [[nodiscard]] Profile_point operator()(double u, const Profile_frame& frame) const {
    const double s = std::sin(frame.angle);
    // Nearly straight: the chord is the arc to rounding.
    const double a = s < 1e-9 ? 1 - u : std::sin((1 - u) * frame.angle) / s;
    const double b = s < 1e-9 ? u : std::sin(u * frame.angle) / s;
    return {1 - a - b, a, 0, b};
  }
};

/// Rational quadratic with control points P1, P0, P2 and weights 1, w0, 1. cos(angle / 2) is the arc, 0 the chord
/// (chamfer), infinity the sharp corner P1 - P0 - P2 (the paper's sharpening profile).
struct Conic_profile {
  double weight = 0;  ///< w0, >= 0, may be infinite

  [[nodiscard]] Profile_point operator()(double u, const Profile_frame&) const {
    if (std::isinf(weight)) {
      const double apex = 1 - std::abs(1 - 2 * u);
      return u < 0.5 ? Profile_point{0, 1 - apex, apex, 0} : Profile_point{0, 0, apex, 1 - apex};
    }
    const double a = (1 - u) * (1 - u), m = 2 * u * (1 - u) * weight, b = u * u;
    return {0, a / (a + m + b), m / (a + m + b), b / (a + m + b)};
  }
  [[nodiscard]] std::vector<double> kinks() const {
    return std::isinf(weight) ? std::vector{0.5} : std::vector<double>();
  }
};

inline Conic_profile chamfer_profile() { return {0}; }
inline Conic_profile sharp_profile() { return {std::numeric_limits<double>::infinity()}; }

/// Cubic with given end tangents: speed_1 (P0 - P1) at the start and speed_2 (P2 - P0) at the end.
struct Hermite_profile {
  static constexpr double as_arc = 1.6568542494923801;  ///< 4 (sqrt 2 - 1): at 90 degrees nearly the arc
  double speed_1 = as_arc, speed_2 = as_arc;           ///< > 0

  [[nodiscard]] Profile_point operator()(double u, const Profile_frame&) const {
    const double v = 1 - u;
    const double to_1 = v * v * (1 + 2 * u), to_2 = u * u * (1 + 2 * v);
    const double along_1 = speed_1 * u * v * v, along_2 = -speed_2 * u * u * v;
    return {0, to_1 - along_1, along_1 - along_2, to_2 + along_2};
  }
};

/// Clamped uniform B-spline with control points (x, y) in the frame P1 + x (P0 - P1) + y (P2 - P0). Tangent to the base
/// surfaces if the second point has y = 0 and the last but one x = 1.
class Bspline_profile {
 public:
  /// \param points two or more; the first must be (0, 0), the last (1, 1)
  /// \param degree in [1, points.size() - 1]
  explicit Bspline_profile(std::vector<std::array<double, 2>> points, std::size_t degree = 3)
      : points_(std::move(points)), degree_(degree) {
    CGAL_precondition(is_valid(points_, degree_));
  }

  [[nodiscard]] static bool is_valid(const std::vector<std::array<double, 2>>& points, std::size_t degree) {
    const auto finite = [](const std::array<double, 2>& p) { return std::isfinite(p[0]) && std::isfinite(p[1]); };
    return points.size() >= 2 && degree >= 1 && degree < points.size() &&
           std::all_of(points.begin(), points.end(), finite) && points.front() == std::array<double, 2>{0, 0} &&
           points.back() == std::array<double, 2>{1, 1};
  }

  [[nodiscard]] Profile_point operator()(double u, const Profile_frame&) const {
    const std::size_t spans = points_.size() - degree_;
    const std::size_t span = std::min(static_cast<std::size_t>(u * static_cast<double>(spans)), spans - 1);
    std::vector<std::array<double, 2>> d(points_.begin() + static_cast<std::ptrdiff_t>(span),
                                         points_.begin() + static_cast<std::ptrdiff_t>(span + degree_ + 1));
    for (std::size_t level = 1; level <= degree_; ++level)  // de Boor
      for (std::size_t j = degree_; j >= level; --j) {
        const double low = knot(span + j), high = knot(span + j + degree_ + 1 - level);
        const double t = (u - low) / (high - low);
        for (int k = 0; k < 2; ++k) d[j][k] = (1 - t) * d[j - 1][k] + t * d[j][k];
      }
    const auto [x, y] = d[degree_];
    return {0, 1 - x, x - y, y};
  }
  [[nodiscard]] std::vector<double> kinks() const {
    std::vector<double> inner;
    const std::size_t spans = points_.size() - degree_;
    if (degree_ == 1)
      for (std::size_t i = 1; i < spans; ++i) inner.push_back(static_cast<double>(i) / static_cast<double>(spans));
    return inner;
  }

 private:
  [[nodiscard]] double knot(std::size_t i) const {
    const std::size_t spans = points_.size() - degree_;
    return i <= degree_ ? 0.0 : std::min(1.0, static_cast<double>(i - degree_) / static_cast<double>(spans));
  }

  std::vector<std::array<double, 2>> points_;
  std::size_t degree_;
};

/// Quintic Bezier curve that continues the curvature of the base surfaces: zero at both ends on planes.
/// Control points: P1, P1 + a (P0 - P1), P1 + b (P0 - P1) + h n, and the same from P2; the curvature at the end is
/// (4/5) h / (a |P0 - P1|)^2.
struct G2_profile {
  double first = 1.0 / 3, second = 0.6;  ///< a, b: 0 < a < b < 1

  [[nodiscard]] Profile_point operator()(double u, const Profile_frame& frame) const {
    const double leg = std::tan(frame.angle / 2);  // in radii
    std::array<double, 2> h;
    for (int i = 0; i < 2; ++i) h[i] = 1.25 * frame.curvature[i] * first * first * leg * leg;
    const double v = 1 - u;
    const std::array<double, 6> b{v * v * v * v * v,      5 * u * v * v * v * v, 10 * u * u * v * v * v,
                                  10 * u * u * u * v * v, 5 * u * u * u * u * v, u * u * u * u * u};
    return {b[2] * h[0] + b[3] * h[1], b[0] + b[1] * (1 - first) + b[2] * (1 - second - h[0]),
            (b[1] + b[4]) * first + (b[2] + b[3]) * second, b[5] + b[4] * (1 - first) + b[3] * (1 - second - h[1])};
  }
};

/// Any profile, by value.
class Profile {
 public:
  Profile() : Profile(Arc_profile()) {}

  template <class Model, class = std::enable_if_t<!std::is_same_v<std::decay_t<Model>, Profile>>>
  Profile(Model model) : is_arc_(std::is_same_v<Model, Arc_profile>), kinks_(kinks_of(model, 0)) {
    std::sort(kinks_.begin(), kinks_.end());
    kinks_.erase(std::unique(kinks_.begin(), kinks_.end()), kinks_.end());
    CGAL_precondition(kinks_.empty() || (kinks_.front() > 0 && kinks_.back() < 1));
    if constexpr (std::is_same_v<Model, Conic_profile>) is_sharp_ = std::isinf(model.weight);
    evaluate_ = [held = std::move(model)](double u, const Profile_frame& frame) { return held(u, frame); };
  }

  [[nodiscard]] Profile_point operator()(double u, const Profile_frame& frame) const { return evaluate_(u, frame); }
  [[nodiscard]] bool is_arc() const noexcept { return is_arc_; }
  [[nodiscard]] bool is_sharp() const noexcept { return is_sharp_; }
  /// Parameters of the corners in (0, 1), increasing.
  [[nodiscard]] const std::vector<double>& kinks() const noexcept { return kinks_; }

 private:
  template <class Model>
  static auto kinks_of(const Model& model, int) -> decltype(model.kinks()) {
    return model.kinks();
  }
  template <class Model>
  static std::vector<double> kinks_of(const Model&, long) {
    return {};
  }

  bool is_arc_, is_sharp_ = false;
  std::vector<double> kinks_;
  std::function<Profile_point(double, const Profile_frame&)> evaluate_;
};

}  // namespace cgal_blend

#endif
