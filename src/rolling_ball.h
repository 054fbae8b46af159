// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_ROLLING_BALL_H
#define CGAL_BLEND_SRC_ROLLING_BALL_H

#include "base_surface.h"
#include "blend_curve.h"

#include <cgal_blend/radius_law.h>
#include <cgal_blend/status.h>

#include <array>
#include <vector>

namespace cgal_blend {

/// The ball in contact with both base surfaces.
struct Ball_position {
  Vec center;
  std::array<Surface_point, 2> foot;
  std::array<Vec, 2> contact;
  double radius = 0;
  Vec across = Vec::Zero();  ///< normal of the plane that it was sought in
  double fraction = 0;  ///< of the blending curve's length, for the radius
  bool mended = false;  ///< of a joint over a loop of the spine: the contacts are the nearest points
};

/// Normal curvature of a surface at a contact along a tangent, positive where it bends towards the ball's centre.
/// \param arm from the centre to the contact
[[nodiscard]] double curvature_towards_ball(const Base_surface& surface, const Surface_point& foot, const Vec& arm,
                                            const Vec& along);

/// How finely the ball's way is sampled; lengths as fractions of the radius.
struct Sampling {
  double tolerance;         ///< largest distance between polylines of centres, of contacts, and the true curves
  double finest;            ///< shortest step that is looked into
  double coarsest;          ///< longest step
  double spacing;           ///< least distance of positions that are kept, from `finest` up
  std::size_t samples = 0;  ///< first positions, spread by arc length; 0: as `coarsest` asks for
  double chord_ratio = 0;  ///< chord height over chord length above which a step is divided; 0: as `tolerance` asks for
  bool mend_loops = true;  ///< cut loops off where the spine crosses itself, or refuse
};

/// Returns the sampling that belongs to a chord tolerance: steps from one to several facets of the arc.
[[nodiscard]] Sampling sampling(double chord_tolerance);

/// Ball positions along a spine, in the direction of the blending curve, or why there are none.
struct Ball_path {
  Diagnosis diagnosis;
  std::vector<Ball_position> positions;
  std::size_t loops = 0;  ///< cut off where the spine crossed itself
};

/// What a blending curve is.
enum class Curve_kind {
  crease,  ///< a sharp edge between the base surfaces
  round    ///< the middle of a round; the base surfaces are those beyond it
};

/// Rolls a ball along a blending curve; along an open one on beyond its ends, where the base surfaces are extended
/// (`Base_surface::extend`), as far as the curve's overhang.
///
/// The intersection of the offset patches is the first guess, with exact topology; where offsets that cross themselves
/// leave no closed loop along the curve, the planar wedge at each point of the curve is. Each position is then the
/// solution of x_0(u) = x_1(v) on the exact offsets p + d n/|n|, in a plane across the guess. Where the spine turns more
/// sharply than the ball it crosses itself; such loops are cut off and the ends joined (`cut_loop`).
/// \param surfaces the base surfaces left and right of the curve; may be the same object
/// \param law the radius along the curve; in each plane across the guess it is that of the curve there
Ball_path roll_ball(const std::array<const Base_surface*, 2>& surfaces, const Blend_curve& curve, Curve_kind kind,
                    const Radius_law& law, const Sampling& sampling);

/// Rolls a ball of constant radius from one place to another, in contact with the two faces that it touches in both.
/// Where these are less than a facet apart it has no position between them.
/// \param ends with their feet
Ball_path roll_between(const Base_surface& surface, const std::array<Ball_position, 2>& ends, bool convex,
                       const Radius_law& law, const Sampling& sampling);

}  // namespace cgal_blend

#endif
