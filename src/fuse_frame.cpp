// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuse_frame.h"

#include "number_text.h"
#include "rotated.h"

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace cgal_blend {

namespace {

Vector_3 unit(const Vector_3& v) { return v / std::sqrt(v.squared_length()); }

/// A unit vector perpendicular to another, continuous but for jumps between axes.
Vector_3 perpendicular(const Vector_3& z) {
  const double x = std::abs(z.x()), y = std::abs(z.y()), w = std::abs(z.z());
  const Vector_3 along = x <= y && x <= w ? Vector_3(1, 0, 0) : y <= w ? Vector_3(0, 1, 0) : Vector_3(0, 0, 1);
  return unit(along - (along * z) * z);
}

/// 0 to 1 with slopes 0.
double smooth_step(double t) { return t * t * (3 - 2 * t); }

std::string degrees(double angle) { return std::to_string(static_cast<long>(std::ceil(angle * 180 / CGAL_PI - 1e-9))); }

}  // namespace

Fuse_frame::Fuse_frame(const Cut_plane& lower, const Cut_plane& upper)
    : centre_{lower.point, upper.point},
      x_(perpendicular(lower.normal)),
      y_(CGAL::cross_product(lower.normal, x_)),
      z_(lower.normal) {
  const Vector_3 onward = -upper.normal, turn = CGAL::cross_product(z_, onward), between = upper.point - lower.point;
  angle_ = std::atan2(std::sqrt(turn.squared_length()), z_ * onward);
  if (angle_ * 180 / CGAL_PI > steepest_planes * (1 + 1e-9)) {
    diagnosis_ = {Status::planes_too_steep,
                  degrees(angle_) + " degrees, and at most " + degrees(steepest_planes * CGAL_PI / 180) +
                      " are possible; normals point away from what is kept",
                  upper.point,
                  {}};
    return;
  }
  const bool bent = is_bent();
  if (bent) axis_ = unit(turn);
  const Vector_3 middle = bent ? rotated(z_, axis_, angle_ / 2) : z_;
  const double chord = between * middle;
  height_ = bent ? chord * (angle_ / 2) / std::sin(angle_ / 2) : chord;
  if (!(height_ > 0)) {
    const std::string excess =
        bent ? "" : "; move the upper side along the lower normal by more than " + number_text(-chord);
    diagnosis_ = {
        Status::sides_interpenetrate, "the upper plane is not beyond the lower one" + excess, upper.point, {}};
    return;
  }
  const Vector_3 across = between - chord * middle;
  offset_ = bent ? rotated(across, axis_, -angle_ / 2) : across;
  if (bent) residue_ = across - rotated(offset_, axis_, angle_);
}

Bend_ends Fuse_frame::ends() const { return {{centre_[0], centre_[1]}, x_, y_, z_, axis_, angle_, height_, offset_}; }

Point_3 Fuse_frame::to_frame(const Point_3& p, std::size_t side) const {
  Vector_3 v = p - centre_[side];
  if (side == 1) v = (is_bent() ? rotated(v, axis_, -angle_) : v) + offset_ + height_ * z_;
  return {v * x_, v * y_, v * z_};
}

Point_3 Fuse_frame::from_straight_frame(const Point_3& p) const {
  return centre_[0] + p.x() * x_ + p.y() * y_ + p.z() * z_;
}

double Fuse_frame::shortening(const Point_3& p) const {
  if (!is_bent()) return 1;
  return 1 - angle_ / height_ * ((p.x() * x_ + p.y() * y_) * CGAL::cross_product(axis_, z_));
}

/// Where a height goes before the bend shortens or lengthens what is off the arc: at both planes by just as much the other
/// way, so that the bend is rigid there to first order, and a tangent plane stays one. Points move along the arc only, so
/// that a cylinder becomes a torus all the same.
double Fuse_frame::warped(double z, double shortening) const {
  const double half = height_ / 2, excess = 1 / std::max(shortening, 1 / largest_warp) - 1;
  const double from_end = std::min(z, height_ - z), u = 1 - from_end / half;
  const double shift = excess * from_end * u * u;
  return z < half ? z + shift : z - shift;
}

Point_3 Fuse_frame::from_frame(const Point_3& p) const {
  if (!is_bent()) return from_straight_frame(p);
  const double z = std::clamp(p.z(), 0.0, height_), t = warped(z, shortening(p)) / height_;
  const double turn = t * angle_, radius = height_ / angle_;
  const Vector_3 inward = CGAL::cross_product(axis_, z_);
  const Vector_3 arc = radius * std::sin(turn) * z_ + radius * (1 - std::cos(turn)) * inward;
  const Vector_3 section = p.x() * x_ + p.y() * y_ + (p.z() - z) * z_;
  return centre_[0] + arc + rotated(section, axis_, turn) + smooth_step(t) * residue_;
}

Opening_sections sections_in_frame(const Fuse_side& side, std::size_t which, const Fuse_frame& frame) {
  const auto placed = [&](const std::vector<Section_loop>& loops) {
    std::vector<Ring> rings;
    for (const Section_loop& loop : loops) {
      rings.emplace_back();
      for (const Point_3& p : loop) {
        const Point_3 q = frame.to_frame(p, which);
        rings.back().emplace_back(q.x(), q.y());
      }
    }
    return rings;
  };
  Opening_sections sections;
  sections.rings = placed(side.points);
  const auto& into = side.shifted[1];
  const auto& away = side.shifted[0];
  const auto& below = which == 0 ? into : away;
  const auto& above = which == 0 ? away : into;
  if (!below.empty()) sections.below = placed(below);
  if (!above.empty()) sections.above = placed(above);
  sections.step = side.step;
  return sections;
}

}  // namespace cgal_blend
