// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/surface_blend.h>

#include <cmath>
#include <string>

namespace cgal_blend {

namespace {

constexpr int distance_samples = 64;
constexpr double safety = 0.97;      // of the largest factor, at which a blend may be pinched to a point
constexpr double coincident = 1e-9;  // mean distance of the curves, of their length

std::string side_name(int side) { return side == 0 ? "first side: " : "second side: "; }

Diagnosis check_options(const Boundary_curve& first, const Boundary_curve& second,
                        const Surface_blend_options& options) {
  for (int side = 0; side < 2; ++side) {
    const Blend_side_options& o = options.sides[static_cast<std::size_t>(side)];
    if (!(std::abs(o.direction) < 1))
      return {Status::invalid_parameter, side_name(side) + "the direction lambda must lie between -1 and 1", {}, {}};
    for (int i = 0; o.distance && i <= distance_samples; ++i) {
      const double s = static_cast<double>(i) / distance_samples, d = (*o.distance)(s);
      if (!(d > 0) || !std::isfinite(d))
        return {Status::invalid_parameter,
                side_name(side) + "the distance d is not greater than 0 at s = " + std::to_string(s),
                {},
                {}};
    }
    if (options.g2 && !(side == 0 ? first : second).has_second_form())
      return {Status::not_supported, side_name(side) + "the curvature of this surface is not known", {}, {}};
  }
  return {};
}

bool is_finite(const Surface_blend& blend) {
  for (const Point_3& p : blend.sample(distance_samples, 5))
    if (!std::isfinite(p.x() + p.y() + p.z())) return false;
  return true;
}

/// The diagnosis of a blend that folds at a point.
Diagnosis folded(const Point_3& point, double factor) {
  const std::string advice =
      factor > 0 ? "multiplied by " + std::to_string(std::floor(factor * 1e4) / 1e4) + " or less the distances d work"
                 : "no smaller distances d help";
  return {Status::blend_folds, advice, point, {}};
}

}  // namespace

Surface_blend_result blend_surfaces(const Boundary_curve& first, const Boundary_curve& second,
                                    const Surface_blend_options& options) {
  Surface_blend_result result;
  if (result.diagnosis = check_options(first, second, options); !result.ok()) return result;
  const Correspondence correspondence = correspond(first, second, options.correspondence);
  if (result.diagnosis = correspondence.diagnosis; !result.ok()) return result;
  const bool needs_distance = !options.sides[0].distance || !options.sides[1].distance;
  if (needs_distance && !(correspondence.mean_distance > coincident * correspondence.length[0])) {
    result.diagnosis = {Status::curves_do_not_correspond, "the curves coincide, so there is nothing to bridge", {}, {}};
    return result;
  }
  Surface_blend blend(first, second, correspondence, options);
  if (!is_finite(blend)) {
    result.diagnosis = {Status::invalid_parameter, "a distance or the middle control point is not finite", {}, {}};
    return result;
  }
  if (options.on_fold != Fold_policy::ignore) {
    if (const auto place = find_fold(blend)) {
      result.factor = safety * largest_safe_factor(blend);
      const bool is_automatic = !options.sides[0].distance && !options.sides[1].distance;
      if ((options.on_fold == Fold_policy::refuse && !is_automatic) || result.factor == 0) {
        result.diagnosis = folded(*place, result.factor);
        return result;
      }
      blend = blend.scaled(result.factor);
    }
  }
  result.blend = std::move(blend);
  return result;
}

}  // namespace cgal_blend
