// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_PACED_BEND_H
#define CGAL_BLEND_SRC_PACED_BEND_H

#include <cgal_blend/blend_mesh.h>

#include <optional>
#include <vector>

namespace cgal_blend {

/// From where to where a straight transition is to be bent: its sections are normal to z, from z = 0 to z = height.
struct Bend_ends {
  Point_3 centre[2];         ///< of the openings, bent
  Vector_3 x, y, z;          ///< axes of the straight frame, in space
  Vector_3 axis{0, 0, 0};    ///< unit, normal to z; the upper plane is turned about it by
  double angle = 0;          ///< radians, and
  double height = 0;         ///< is how far the planes are apart when straight
  Vector_3 offset{0, 0, 0};  ///< of the upper centre from the z axis, straight
};

/// Bends a transition along a cubic curve that is tangent to both axes, and turns its sections where they are narrow: in
/// inverse proportion to how far they reach to the inner side, and not at all at both planes, so that the bend is rigid
/// there to first order. Leads around corners in which an arc's centre lies within an opening.
class Paced_bend {
 public:
  /// \param points the transition in the straight frame, that of the ends
  Paced_bend(const Bend_ends& ends, const std::vector<Point_3>& points);

  /// The first of the points where sections pass through each other; none: the bend does not fold there.
  [[nodiscard]] std::optional<Point_3> fold() const { return fold_; }
  [[nodiscard]] Point_3 operator()(const Point_3& p) const;

 private:
  void find_reach(const std::vector<Point_3>& points);
  void set_pace(double ease);
  [[nodiscard]] double advance(const Point_3& p) const;
  [[nodiscard]] double least_advance(const std::vector<Point_3>& points) const;
  [[nodiscard]] double turn(double t) const;
  [[nodiscard]] Vector_3 section(const Point_3& p) const;

  Bend_ends ends_;
  Vector_3 inward_;
  std::vector<double> reach_;        // of sections to the inner side, at equal steps of height
  std::vector<double> rate_, turn_;  // by height, likewise: of turning, and the angle so far
  std::optional<Point_3> fold_;
};

}  // namespace cgal_blend

#endif
