// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_IMPLICIT_REMESHING_H
#define CGAL_BLEND_SRC_IMPLICIT_REMESHING_H

#include <cgal_blend/blend_mesh.h>

#include <functional>

namespace cgal_blend {

/// What a surface is remeshed to.
struct Remeshing_target {
  std::function<double(const Point_3&)> function;  ///< zero on the surface, positive where its normals point
  std::function<double(const Point_3&)> size;      ///< edge length wanted, length units, > 0
  double zmin = 0, zmax = 0;                       ///< new vertices lie strictly between
  double least_angle = 20;                         ///< aimed at last, away from borders, degrees
  int rounds = 5;
  std::function<bool(double)> progress;  ///< told the part done in [0, 1]; false stops between rounds
};

/// Remeshes a surface with borders to edges between 4/5 and 4/3 of the wanted length, with its inner vertices on the zero
/// set. Border vertices and edges stay. No operation turns a face by more than a right angle against the normals
/// at its vertices, and none joins two vertices of one plane border by an inner edge. Returns false if stopped.
/// Source: Botsch and Kobbelt, A remeshing approach to multiresolution modeling (2004), section 4; the projection is a
/// secant iteration along the normal, kept in a bracket once there is one.
[[nodiscard]] bool remesh_implicit(Blend_mesh& mesh, const Remeshing_target& target);

}  // namespace cgal_blend

#endif
