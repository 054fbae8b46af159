// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_VIRTUAL_SURFACE_H
#define CGAL_BLEND_SRC_VIRTUAL_SURFACE_H

#include "rolling_ball.h"

#include <cgal_blend/profile.h>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace cgal_blend {

/// The blend as a sequence of profiles, closed or open, ruled between neighbours: S(t, u) = (1 - s) T_i(u) + s T_{i+1}(u).
/// t is the chord length along the spine, u in [0, 1] runs from the left contact to the right one, in proportion to the
/// length of the profile.
/// Source: Liu et al. (2005), section 4, Eq. 1.
class Virtual_surface {
 public:
  Virtual_surface(const std::vector<Ball_position>& positions, const std::array<const Base_surface*, 2>& surfaces,
                  Profile profile, bool closed = true);

  [[nodiscard]] std::size_t size() const { return sections_.size(); }
  [[nodiscard]] double length() const { return start_.back(); }

  /// Chord length at profile i; `start(size())` is the length of the spine.
  [[nodiscard]] double start(std::size_t i) const { return start_[i]; }

  /// A point of profile i.
  [[nodiscard]] Vec on_profile(std::size_t i, double u) const;

  /// A point of the surface; t is taken modulo the length.
  [[nodiscard]] Vec operator()(double t, double u) const;

  /// Parameters of rows, 0, the kinks and 1 included and at least one between, whose chords stay within `tolerance`
  /// radii of the profile with the largest angle. An arc is divided evenly, into the fewest
  /// rows, though no fewer than a quarter circle has; others by halving.
  [[nodiscard]] std::vector<double> rows(double tolerance) const;

  /// Parameters of the profile's corners.
  [[nodiscard]] const std::vector<double>& kinks() const { return kinks_; }

  [[nodiscard]] double profile_length(std::size_t i) const;

  /// Where neighbouring profiles twist against each other: a point at which the surface's normal turns by more than
  /// `angle` (radians) beyond the turn of the spine from one step to the next, if there is one.
  /// \param first, past of the profiles to look at, if the surface is open
  [[nodiscard]] std::optional<Vec> find_twist(double angle, std::size_t first = 0,
                                              std::size_t past = static_cast<std::size_t>(-1)) const;

  /// Angle between profile i's end tangent and the tangent plane of the base face there, degrees.
  [[nodiscard]] double end_angle(std::size_t i, int side) const;

 private:
  /// Where profile i lies in space.
  struct Section {
    Profile_frame frame;
    Vec centre, contact_1, apex, contact_2;
    std::array<Vec, 2> face_normal;
  };
  [[nodiscard]] static Section section_at(const Ball_position& position,
                                          const std::array<const Base_surface*, 2>& surfaces);
  [[nodiscard]] static Vec place(const Section& section, const Profile_point& p);
  [[nodiscard]] double even(double u) const;
  void make_even();

  Profile profile_;
  bool closed_;
  std::vector<Section> sections_;
  std::vector<double> start_;
  std::vector<double> parameters_;  ///< of the profile, increasing; empty: they are even by themselves
  std::vector<double> lengths_;     ///< of the widest profile up to each of them, as a fraction
  std::vector<double> kinks_;
  std::size_t widest_ = 0;  ///< the profile with the largest angle
};

}  // namespace cgal_blend

#endif
