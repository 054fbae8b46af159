// SPDX-License-Identifier: GPL-3.0-or-later
#include "placed_region.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <set>

namespace cgal_blend {

namespace {

constexpr double derivative_step = 1e-3;  // of the parameters
constexpr double upright = 0.25;          // cosine: faces that lean more are to be untangled
constexpr int untangle_passes = 40;

}  // namespace

Vec face_normal(const Vec& a, const Vec& b, const Vec& c) { return (b - a).cross(c - a).stableNormalized(); }

Vec face_normal(const Blend_mesh& mesh, Face f) {
  const Halfedge h = mesh.halfedge(f);
  return face_normal(to_vec(mesh.point(mesh.source(h))), to_vec(mesh.point(mesh.target(h))),
                     to_vec(mesh.point(mesh.target(mesh.next(h)))));
}

Vec Placed_region::position(Vertex v) const {
  if (is_inner(v)) return place(v).point;
  const auto drawn = border_.find(v);
  return drawn != border_.end() ? drawn->second : to_vec(mesh_.point(v));
}

Placed_region::Mean_place Placed_region::mean_place(Face f) const {
  Mean_place mean;
  double first = 0;
  for (const Vertex v : mesh_.vertices_around_face(mesh_.halfedge(f))) {
    if (!is_inner(v)) continue;
    const Place& on = place(v);
    if (mean.inner++ == 0) first = on.t;
    mean.t += first + std::remainder(on.t - first, surface_.length());
    mean.u += on.u;
    mean.point += on.point;
  }
  mean.t /= mean.inner;
  mean.u /= mean.inner;
  mean.point /= mean.inner;
  return mean;
}

/// Unit normal that a face should have: that of the surface at its inner vertices; between it and the old normal for
/// faces that reach out of the region.
Vec Placed_region::wanted_normal(Face f) const {
  const Mean_place mean = mean_place(f);
  const double u = std::clamp(mean.u, derivative_step, 1 - derivative_step);
  const double dt = derivative_step * surface_.length();
  const Vec along = surface_(mean.t + dt, u) - surface_(mean.t - dt, u);
  const Vec across = surface_(mean.t, u + derivative_step) - surface_(mean.t, u - derivative_step);
  const Vec normal = across.cross(along).stableNormalized();
  return mean.inner == 3 ? normal : Vec((normal + face_normal(mesh_, f)).stableNormalized());
}

/// Cosine between the normal that a face has and the one it should have.
double Placed_region::uprightness(Face f) const {
  const Halfedge h = mesh_.halfedge(f);
  const Vec normal =
      face_normal(position(mesh_.source(h)), position(mesh_.target(h)), position(mesh_.target(mesh_.next(h))));
  return normal.dot(wanted_normal(f));
}

double Placed_region::tangle(Vertex v) const {
  double sum = 0;
  for (const Face f : mesh_.faces_around_target(mesh_.halfedge(v))) {
    const double lack = std::max(0.0, upright - uprightness(f));
    sum += lack * lack;
  }
  return sum;
}

void Placed_region::untangle() {
  for (int pass = 0; pass < untangle_passes; ++pass) {
    std::set<Vertex> bad;
    for (const Face f : faces_)
      if (uprightness(f) < upright)
        for (const Vertex v : mesh_.vertices_around_face(mesh_.halfedge(f)))
          if (is_inner(v)) bad.insert(v);
    bool improved = false;
    for (const Vertex v : bad) improved = slide(v) || improved;
    if (!improved) return;
  }
}

/// Tries places on the surface around that of a vertex; takes the one with the least tangle.
bool Placed_region::slide(Vertex v) {
  const Place start = place(v);
  double reach = 0;  // along the curve
  for (const Vertex w : mesh_.vertices_around_target(mesh_.halfedge(v)))
    if (is_inner(w)) reach = std::max(reach, std::abs(std::remainder(place(w).t - start.t, surface_.length())));
  const bool on_corner = std::find(surface_.kinks().begin(), surface_.kinks().end(), start.u) != surface_.kinks().end();
  Place best = start;
  double least = tangle(v);
  const double before = least;
  for (const double a : {0.0, -0.4, 0.4})
    for (const double b : {0.0, -0.05, 0.05, -0.15, 0.15, -0.3, 0.3, -0.6, 0.6}) {
      if ((a == 0 && b == 0) || (b != 0 && on_corner)) continue;
      put(v, start.t + a * reach, std::clamp(start.u + b, 0.02, 0.98));
      const double value = tangle(v);
      if (value >= least * (1 - 1e-3)) continue;
      least = value;
      best = place(v);
    }
  at(v) = best;
  return least < before;
}

double Placed_region::coarseness() const {
  double largest = 0;
  for (const Face f : faces_)
    if (const Mean_place mean = mean_place(f); mean.inner > 1)
      largest = std::max(largest, (surface_(mean.t, mean.u) - mean.point).norm());
  return largest;
}

}  // namespace cgal_blend
