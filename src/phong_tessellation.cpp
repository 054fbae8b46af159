// SPDX-License-Identifier: GPL-3.0-or-later
#include "phong_tessellation.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace cgal_blend {

namespace {

// Alpha of the paper. A half instead of its three quarters: then quadratic surfaces are reproduced, so that the distance to
// a smooth surface falls with a higher power of the length of edges.
constexpr double roundness = 0.5;
constexpr int longest_iteration = 20;
constexpr double close_enough = 1e-13;  // of the size of the facet
constexpr double far_outside = 4;       // barycentric coordinate at which an iteration is lost
constexpr double least_split = 1e-6;    // radians; below, the surface is smooth across the curve already

double angle(const Vec& a, const Vec& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

}  // namespace

// The flat point q, drawn to the planes at the corners: q - alpha sum b_i ((q - p_i) . n_i) n_i.
Vec Phong_facet::point(const Vec& bary) const {
  const Vec q = bary[0] * corner[0] + bary[1] * corner[1] + bary[2] * corner[2];
  Vec sum = Vec::Zero();
  for (int i = 0; i < 3; ++i) sum += bary[i] * (q - corner[i]).dot(normal[i]) * normal[i];
  return q - roundness * sum;
}

Vec Phong_facet::unit_normal(const Vec& bary) const {
  return (bary[0] * normal[0] + bary[1] * normal[1] + bary[2] * normal[2]).normalized();
}

Vec Phong_facet::nearest(const Vec& p) const {
  const Vec u = corner[1] - corner[0], v = corner[2] - corner[0], n = u.cross(v), w = p - corner[0];
  const double area = n.squaredNorm();
  if (area > 0) {
    const double b = w.cross(v).dot(n) / area, c = u.cross(w).dot(n) / area;
    if (b >= 0 && c >= 0 && b + c <= 1) return {1 - b - c, b, c};
  }
  Vec bary = Vec::Zero();
  double best = -1;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const Vec side = corner[j] - corner[i];
    const double t = std::clamp((p - corner[i]).dot(side) / side.squaredNorm(), 0.0, 1.0);
    const double distance = (corner[i] + t * side - p).squaredNorm();
    if (best >= 0 && distance >= best) continue;
    best = distance;
    bary.setZero();
    bary[i] = 1 - t;
    bary[j] = t;
  }
  return bary;
}

std::optional<Vec> Phong_facet::foot(const Vec& p, const Vec& start) const {
  Vec bary = start;
  double height = (p - point(bary)).dot(unit_normal(bary));
  const double size = (corner[1] - corner[0]).norm() + (corner[2] - corner[0]).norm();
  for (int step = 0; step < longest_iteration; ++step) {
    const Vec m = bary[0] * normal[0] + bary[1] * normal[1] + bary[2] * normal[2], n = m.normalized();
    const Vec rest = point(bary) + height * n - p;
    if (rest.norm() <= close_enough * size) return bary;
    const Vec q = bary[0] * corner[0] + bary[1] * corner[1] + bary[2] * corner[2];
    std::array<Vec, 3> pull;  // derivative of the sum in point() by b_k, less what is common to all k
    Eigen::Matrix3d tangent = Eigen::Matrix3d::Zero();
    for (int i = 0; i < 3; ++i) {
      pull[i] = (q - corner[i]).dot(normal[i]) * normal[i];
      tangent += bary[i] * normal[i] * normal[i].transpose();
    }
    Eigen::Matrix3d jacobian;
    for (int k = 1; k < 3; ++k) {
      const Vec side = corner[k] - corner[0], turn = (normal[k] - normal[0]) / m.norm();
      jacobian.col(k - 1) = side - roundness * (pull[k] - pull[0] + tangent * side) + height * (turn - n.dot(turn) * n);
    }
    jacobian.col(2) = n;
    const Vec change = jacobian.inverse() * rest;
    if (!change.allFinite()) return std::nullopt;
    bary += Vec(change[0] + change[1], -change[0], -change[1]);
    height -= change[2];
    if (!(bary.cwiseAbs().maxCoeff() < far_outside)) return std::nullopt;
  }
  return std::nullopt;
}

Corner_normals::Corner_normals(const Blend_mesh& mesh, const std::vector<bool>& on_curve)
    : mesh_(&mesh), on_curve_(&on_curve) {
  average(mesh);
}

Corner_normals::Corner_normals(const Corner_normals& before, const Blend_mesh& moved)
    : mesh_(before.mesh_), on_curve_(before.on_curve_) {
  average(moved);
  for (const Halfedge h : mesh_->halfedges()) {
    if (before.split_[h] < least_split || !(split_[h] < before.split_[h])) continue;
    const double merged = 1 - split_[h] / before.split_[h];
    corner_[h] = (corner_[h] + merged * (vertex_[mesh_->target(h)] - corner_[h])).normalized();
  }
}

void Corner_normals::average(const Blend_mesh& positions) {
  vertex_.resize(mesh_->num_vertices());
  corner_.resize(mesh_->num_halfedges());
  split_.assign(mesh_->num_halfedges(), 0);
  for (const Vertex v : mesh_->vertices()) {
    if (mesh_->is_isolated(v)) continue;
    Vec sum = Vec::Zero();
    for (const Halfedge h : mesh_->halfedges_around_target(mesh_->halfedge(v))) {
      const Halfedge first = first_of_fan(h);
      const Vec fan = fan_normal(first, positions);
      if (first == h) sum += fan;
      corner_[h] = fan.normalized();
    }
    vertex_[v] = sum.normalized();
    for (const Halfedge h : mesh_->halfedges_around_target(mesh_->halfedge(v)))
      split_[h] = angle(corner_[h], vertex_[v]);
  }
}

/// The corner from which on the fan of h's corner, between two edges of curves, is to be walked through by next(); the one of
/// least index if no curve passes.
Halfedge Corner_normals::first_of_fan(Halfedge h) const {
  const Halfedge start = h;
  Halfedge least = h;
  while (!(*on_curve_)[mesh_->edge(h)]) {
    h = mesh_->prev(mesh_->opposite(h));
    if (h == start) return least;
    least = std::min(least, h);
  }
  return h;
}

/// Sum over the corners from `first` to the next edge of a curve, or once around.
Vec Corner_normals::fan_normal(Halfedge first, const Blend_mesh& positions) const {
  Vec sum = Vec::Zero();
  Halfedge h = first;
  do {
    const Vec p = to_vec(positions.point(mesh_->target(h)));
    const Vec a = to_vec(positions.point(mesh_->target(mesh_->next(h)))) - p,
              b = to_vec(positions.point(mesh_->source(h))) - p;
    const Vec cross = a.cross(b);
    sum += std::atan2(cross.norm(), a.dot(b)) * cross.normalized();
    if ((*on_curve_)[mesh_->edge(mesh_->next(h))]) break;
    h = mesh_->opposite(mesh_->next(h));
  } while (h != first);
  return sum;
}

}  // namespace cgal_blend
