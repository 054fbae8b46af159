// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_FUSE_FRAME_H
#define CGAL_BLEND_SRC_FUSE_FRAME_H

#include "fuse_sides.h"
#include "hermite_transition.h"
#include "paced_bend.h"

#include <array>

namespace cgal_blend {

/// The common frame of two sides, and the way from it back to where they are. Planes that are not parallel are unbent: an
/// elbow, the arc of a torus, becomes a straight tube as long as its arc. Where planes are parallel nothing moves.
class Fuse_frame {
 public:
  /// \param lower, upper planes with unit normals that point away from what is kept, through the centres of the openings
  Fuse_frame(const Cut_plane& lower, const Cut_plane& upper);

  /// `planes_too_steep`, or `sides_interpenetrate` if the upper plane is not beyond the lower one.
  [[nodiscard]] const Diagnosis& diagnosis() const { return diagnosis_; }
  [[nodiscard]] double angle() const { return angle_; }  ///< between the planes, radians
  [[nodiscard]] double height() const { return height_; }
  [[nodiscard]] bool is_bent() const { return angle_ > parallel; }

  /// Coordinates in the frame of a point that moves along with a side, 0 lower, 1 upper.
  [[nodiscard]] Point_3 to_frame(const Point_3& p, std::size_t side) const;
  /// Back again, bent about the arc; rigid at both planes to first order, so that tangents are kept.
  [[nodiscard]] Point_3 from_frame(const Point_3& p) const;
  /// True where the bend would turn the transition over: on the inner side of an arc that is too tight for its openings.
  [[nodiscard]] bool folds(const Point_3& p) const { return !(shortening(p) > 0); }
  /// True where the bend shortens by more than can be made up for at the planes: tangents are lost there.
  [[nodiscard]] bool is_tight(const Point_3& p) const { return !(shortening(p) * largest_warp > 1); }
  /// What a `Paced_bend` starts from.
  [[nodiscard]] Bend_ends ends() const;

 private:
  // Planes at a smaller angle, radians, count as parallel: the rings of both sides keep their places anyway.
  static constexpr double parallel = 1e-6;
  // At the planes heights are stretched by no more, so that none is passed twice; 4 would be the limit.
  static constexpr double largest_warp = 3.5;

  [[nodiscard]] Point_3 from_straight_frame(const Point_3& p) const;  // along with the lower side
  [[nodiscard]] double shortening(const Point_3& p) const;            // of lengths along the bend
  [[nodiscard]] double warped(double z, double shortening) const;

  Diagnosis diagnosis_;
  Point_3 centre_[2];
  Vector_3 x_, y_, z_;
  Vector_3 axis_{0, 0, 0};  // of the bend
  double angle_ = 0, height_ = 0;
  Vector_3 offset_{0, 0, 0};   // of the upper centre from the axis, straight
  Vector_3 residue_{0, 0, 0};  // what the arc alone misses the upper centre by
};

/// The sections of a side in the common frame.
[[nodiscard]] Opening_sections sections_in_frame(const Fuse_side& side, std::size_t which, const Fuse_frame& frame);

/// Refuses rings of one side that cross, touch or overlap themselves or each other (`openings_overlap`, by exact predicates),
/// and solids inside each other (`sides_interpenetrate`): outer rings run counter-clockwise around the normal, holes clockwise.
[[nodiscard]] Diagnosis check_rings(const Fuse_side& side, const Opening_sections& sections, bool upper);

}  // namespace cgal_blend

#endif
