// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_HERMITE_TRANSITION_H
#define CGAL_BLEND_SRC_HERMITE_TRANSITION_H

#include <cgal_blend/implicit_opening.h>

#include <array>
#include <optional>
#include <vector>

namespace cgal_blend {

/// What a side of a fusion looks like at its plane, in the common frame: z = 0 is the plane of the lower side, z = height
/// that of the upper one, the kept parts lie below and above.
struct Opening_sections {
  std::vector<Ring> rings;                 ///< in the plane
  std::optional<std::vector<Ring>> below;  ///< section at z - step
  std::optional<std::vector<Ring>> above;  ///< section at z + step
  double step = 0;                         ///< distance of the shifted sections, length units, > 0
};

struct Transition_options {
  Opening_model model;                  ///< signed distance if not set
  std::array<double, 2> eta{0.4, 0.6};  ///< the two free control values of w = eta(z), Bezier of degree 5; 0.4 and 0.6
                                        ///< give w = z
  std::array<double, 2> weight{1, 1};  ///< of the sides' functions, opening and slope, > 0: the heavier keeps its shape
                                       ///< the longer, as with the larger rho of the paper
};

/// The implicit transition between two openings: Psi(x, y, z), negative inside, for 0 <= z <= height.
/// Source: Jin et al., Mesh fusion using functional blending on topologically incompatible sections (2006), equations 1 and 6;
/// with w = eta(z / height) and height * T_i, so that dPsi/dz = T_i at the planes whatever the height.
class Hermite_transition {
 public:
  Hermite_transition(const std::array<Opening_sections, 2>& sides, double height, const Transition_options& options);

  [[nodiscard]] double operator()(const Point_3& p) const;
  [[nodiscard]] double height() const { return height_; }
  [[nodiscard]] const std::vector<Ring>& rings(std::size_t side) const { return rings_[side]; }
  /// True if a side's slope comes from one shifted section only, as the other is missing or has another number of rings.
  [[nodiscard]] bool one_sided(std::size_t side) const { return one_sided_[side]; }

 private:
  double height_;
  std::array<double, 2> eta_, weight_;
  std::array<std::vector<Ring>, 2> rings_;
  std::array<bool, 2> one_sided_{};
  std::array<Planar_function, 2> opening_, slope_;
};

}  // namespace cgal_blend

#endif
