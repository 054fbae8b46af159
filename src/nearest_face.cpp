// SPDX-License-Identifier: GPL-3.0-or-later
#include "nearest_face.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cmath>

namespace cgal_blend {

namespace {

/// Squared distance of a point from a box.
double outside(const CGAL::Bbox_3& box, const Point_3& p) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    const double d = std::max({box.min(k) - p[k], p[k] - box.max(k), 0.0});
    sum += d * d;
  }
  return sum;
}

}  // namespace

Nearest_face nearest_face(const Blend_mesh& mesh, const Point_3& p) {
  Nearest_face nearest;
  CGAL::Bbox_3 whole;
  double best = -1;
  for (const Face f : mesh.faces()) {
    const Halfedge h = mesh.halfedge(f);
    const Kernel::Triangle_3 t(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                               mesh.point(mesh.target(mesh.next(h))));
    const CGAL::Bbox_3 box = t.bbox();
    whole += box;
    if (best >= 0 && outside(box, p) >= best) continue;
    const double d = CGAL::squared_distance(p, t);
    if (best >= 0 && d >= best) continue;
    best = d;
    nearest.face = f;
  }
  nearest.distance = std::sqrt(std::max(best, 0.0));
  nearest.diagonal = std::sqrt(std::pow(whole.x_span(), 2) + std::pow(whole.y_span(), 2) + std::pow(whole.z_span(), 2));
  return nearest;
}

}  // namespace cgal_blend
