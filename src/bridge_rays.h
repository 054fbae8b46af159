// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_BRIDGE_RAYS_H
#define CGAL_BLEND_SRC_BRIDGE_RAYS_H

#include "base_surface.h"

#include <cgal_blend/geodesic_polar.h>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace cgal_blend {

/// A ray of a base surface as a cubic spline over x in [0, 1], from the source (0) to the contact curve (1): twice
/// continuously differentiable, and exact at the contact.
class Bridge_ray {
 public:
  Bridge_ray() = default;
  /// Interpolates points at equal steps of x, at least four; not-a-knot at both ends.
  explicit Bridge_ray(const std::vector<Vec>& knots);

  [[nodiscard]] Vec point(double x) const;
  [[nodiscard]] Vec derivative(double x) const;

 private:
  struct Piece {
    Vec a, b, c, d;
  };
  [[nodiscard]] const Piece& piece(double x, double& u) const;

  std::vector<Piece> pieces_;
};

/// Lifts rays in parameter space to the smooth surface that a mesh stands for.
class Ray_lifter {
 public:
  /// \param surface, polar of the same mesh; live as long as the lifter
  /// \param step distance of knots, length units
  Ray_lifter(const Base_surface& surface, const Geodesic_polar& polar, double step)
      : surface_(surface), polar_(polar), step_(step) {}

  /// The ray from the source to a contact point; knots lie about a step apart.
  /// \param place of the contact, on the facets
  [[nodiscard]] Bridge_ray ray(const Polar_point& contact, const Vec& place) const;

  /// Point of the curved triangle over a point of a face: quadratic, with the curvature that the normals have.
  [[nodiscard]] Vec lifted(const Surface_point& at) const;
  /// The same for coordinates; none where the mesh has no point with them.
  [[nodiscard]] std::optional<Vec> lifted(const Polar_point& at) const;

 private:
  const Base_surface& surface_;
  const Geodesic_polar& polar_;
  double step_;
};

}  // namespace cgal_blend

#endif
