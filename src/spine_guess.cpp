// SPDX-License-Identifier: GPL-3.0-or-later
#include "spine_guess.h"

#include "offset_intersection.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <unordered_set>

namespace cgal_blend {

namespace {

// Base patches reach this far beyond the contact that a planar wedge would have, and never farther than the last.
constexpr double patch_stretch = 1.25;
constexpr double patch_margin = 0.5;  // of the radius
constexpr double patch_limit = 12;     // of the radius
constexpr std::size_t fewest_guesses = 16;
constexpr std::size_t fewest_open_guesses = 4;
constexpr double overhang_step = 0.5;  // radii
constexpr double beyond_round = 1.2;  // radii from the middle of a round; at right angles its end is at most 0.79 away

Surface_point foot_beside(const Ball_solver& solver, const Blend_curve& curve, std::size_t edge, int side,
                          const Vec& at) {
  return solver.surface(side).locate(curve.faces[edge][side], at);
}

/// tan of half the angle between the normals: distance from the edge to the contact, over the radius.
std::vector<double> contact_reach(const Ball_solver& solver, const Blend_curve& curve) {
  std::vector<double> reach;
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const Vec middle = (curve.points[i] + curve.points[curve.next(i)]) / 2;
    std::array<Vec, 2> n;
    for (int side = 0; side < 2; ++side)
      n[side] = solver.surface(side).normal(foot_beside(solver, curve, i, side, middle));
    const double c = n[0].dot(n[1]);
    reach.push_back(std::sqrt(std::max(0.0, 1 - c) / std::max(1e-12, 1 + c)));
  }
  return reach;
}

std::vector<Face> collect_patch(const Base_surface& surface, const Blend_curve& curve, int side,
                                const std::vector<double>& reach, const Curve_locator& locator, double radius) {
  const Blend_mesh& mesh = surface.mesh();
  std::vector<Face> patch;
  std::vector<std::size_t> beside;  // per face of the patch: a segment of the curve that is near
  std::unordered_set<Face> seen;
  for (std::size_t k = 0; k < curve.faces.size(); ++k)
    if (seen.insert(curve.faces[k][side]).second) {
      patch.push_back(curve.faces[k][side]);
      beside.push_back(k);
    }
  for (std::size_t i = 0; i < patch.size(); ++i) {
    for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(patch[i]))) {
      const Face other = mesh.face(mesh.opposite(h));
      if (other == Blend_mesh::null_face() || seen.count(other) || !surface.crossable(h)) continue;
      const Vec a = to_vec(mesh.point(mesh.source(h))), b = to_vec(mesh.point(mesh.target(h)));
      const Curve_locator::Nearest near = locator.nearest((a + b) / 2, beside[i]);
      const double allowed = radius * std::min(patch_limit, patch_stretch * reach[near.segment] + patch_margin);
      if (std::sqrt(near.squared_distance) - (a - b).norm() / 2 > allowed) continue;
      seen.insert(other);
      patch.push_back(other);
      beside.push_back(near.segment);
    }
  }
  return patch;
}

/// A polyline at arc length s: modulo its length if it is closed, and straight on beyond its ends if it is not.
struct Arc {
  const std::vector<Vec>& points;
  bool closed;
  std::vector<double> start{0};

  explicit Arc(const std::vector<Vec>& polyline, bool is_closed = true) : points(polyline), closed(is_closed) {
    for (std::size_t i = 0; i + (closed ? 0 : 1) < points.size(); ++i)
      start.push_back(start.back() + (points[(i + 1) % points.size()] - points[i]).norm());
  }
  [[nodiscard]] double length() const { return start.back(); }
  [[nodiscard]] std::size_t segment(double s) const {
    const auto upper = std::upper_bound(start.begin(), start.end(), wrap(s));
    return std::clamp<std::size_t>(static_cast<std::size_t>(upper - start.begin()), 1, start.size() - 1) - 1;
  }
  [[nodiscard]] double wrap(double s) const { return closed ? s - length() * std::floor(s / length()) : s; }
  [[nodiscard]] Vec operator()(double s) const {
    const std::size_t i = segment(s);
    const double size = start[i + 1] - start[i];
    const double t = size > 0 ? (wrap(s) - start[i]) / size : 0;
    return (1 - t) * points[i] + t * points[(i + 1) % points.size()];
  }
  /// Mean over a window: takes the jags out of curves cut by a tessellation.
  [[nodiscard]] Vec mean(double s, double window) const {
    constexpr int samples = 9;
    Vec sum = Vec::Zero();
    for (int i = 0; i < samples; ++i) sum += (*this)(s + window * (i / (samples - 1.0) - 0.5));
    return sum / samples;
  }
};

std::size_t guess_count(double length, const Guess_spacing& spacing, std::size_t fewest = fewest_guesses) {
  return std::max(fewest,
                  spacing.count > 0 ? spacing.count : static_cast<std::size_t>(std::ceil(length / spacing.step)));
}

}  // namespace

int turns_along(const std::vector<Vec>& points, const Curve_locator& locator) {
  const double length = locator.length();
  double total = 0, last = 0;
  std::size_t hint = 0;
  for (std::size_t i = 0; i <= points.size(); ++i) {
    const Curve_locator::Nearest near = locator.nearest(points[i % points.size()], hint);
    const double s = near.arc_length;
    hint = near.segment;
    if (i > 0) total += std::remainder(s - last, length);
    last = s;
  }
  return static_cast<int>(std::lround(total / length));
}

std::vector<Ball_guess> guess_from_offsets(const Ball_solver& solver, const Blend_curve& curve,
                                           const Curve_locator& locator, const Guess_spacing& wanted) {
  const std::vector<double> reach = contact_reach(solver, curve);
  std::array<Base_patch, 2> patches;
  for (int side = 0; side < 2; ++side)
    patches[side] = {&solver.surface(side),
                     collect_patch(solver.surface(side), curve, side, reach, locator, solver.radius()),
                     solver.distance()};
  Offset_curve best;
  double best_distance = 0;
  for (Offset_curve& candidate : intersect_offsets(patches[0], patches[1])) {
    if (!candidate.closed) continue;
    std::vector<Vec> points;
    double distance = 0;
    std::size_t hint = 0;
    for (const Offset_node& node : candidate.nodes) {
      const Curve_locator::Nearest near = locator.nearest(node.point, hint);
      points.push_back(node.point);
      distance += std::sqrt(near.squared_distance);
      hint = near.segment;
    }
    const int turns = turns_along(points, locator);
    if (std::abs(turns) != 1) continue;
    distance /= static_cast<double>(points.size());
    if (!best.nodes.empty() && distance >= best_distance) continue;
    if (turns < 0) std::reverse(candidate.nodes.begin(), candidate.nodes.end());
    best = std::move(candidate);
    best_distance = distance;
  }
  std::vector<Ball_guess> guesses;
  if (best.nodes.empty()) return guesses;
  std::vector<Vec> points;
  for (const Offset_node& node : best.nodes) points.push_back(node.point);
  const Arc arc(points);
  const std::size_t n = guess_count(arc.length(), wanted);
  const double spacing = arc.length() / static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double s = spacing * static_cast<double>(i);
    const Vec direction = arc.mean(s + spacing, spacing) - arc.mean(s - spacing, spacing);
    guesses.push_back({arc(s), direction.normalized(), best.nodes[arc.segment(s)].foot});
  }
  return guesses;
}

std::vector<Ball_guess> guess_from_wedges(const Ball_solver& solver, const Blend_curve& curve,
                                          const Guess_spacing& wanted) {
  const Arc arc(curve.points, curve.closed);
  const std::size_t fewest = curve.closed ? fewest_guesses : fewest_open_guesses;
  const std::size_t n = guess_count(arc.length(), wanted, fewest);
  const double spacing = arc.length() / static_cast<double>(n);
  const double window = std::min(solver.radius(), arc.length() / 8);
  std::vector<double> stations;
  if (!curve.closed)
    for (double s = overhang_step * solver.radius(); s < wanted.overhang[0]; s += overhang_step * solver.radius())
      stations.insert(stations.begin(), -s);
  for (std::size_t i = 0; i < n + (curve.closed ? 0 : 1); ++i) stations.push_back(spacing * static_cast<double>(i));
  if (!curve.closed)
    for (double s = overhang_step * solver.radius(); s < wanted.overhang[1]; s += overhang_step * solver.radius())
      stations.push_back(arc.length() + s);
  std::vector<Ball_guess> guesses;
  for (const double s : stations) {
    const std::size_t edge = arc.segment(s);
    const Vec at = arc(s);
    Ball_guess guess;
    std::array<Vec, 2> normal;
    for (int side = 0; side < 2; ++side) {
      guess.foot[side] = foot_beside(solver, curve, edge, side, at);
      normal[side] = solver.surface(side).normal(guess.foot[side]);
    }
    guess.fraction = std::clamp(s / arc.length(), 0.0, 1.0);
    const double distance = solver.distance(guess.fraction);
    const Vec to_center = distance * (normal[0] + normal[1]) / std::max(0.05, 1 + normal[0].dot(normal[1]));
    guess.direction = (arc.mean(s + spacing, window) - arc.mean(s - spacing, window)).normalized();
    guess.point = arc.mean(s, window) + to_center;
    if (!curve.closed && (s < 0 || s > arc.length()))
      for (int side = 0; side < 2; ++side) {  // the way to the contact leads round the end of the curve
        const Base_surface& surface = solver.surface(side);
        guess.foot[side] = surface.walk(guess.foot[side], to_center - distance * normal[side]).end;
        guess.foot[side] = surface.walk(guess.foot[side], s < 0 ? Vec(at - arc(0)) : Vec(at - arc(arc.length()))).end;
      }
    guesses.push_back(guess);
  }
  return guesses;
}

std::vector<Ball_guess> guess_beyond_round(const Ball_solver& solver, const Blend_curve& curve,
                                           const Guess_spacing& wanted) {
  const Arc arc(curve.points);
  const std::size_t n = guess_count(arc.length(), wanted);
  const double spacing = arc.length() / static_cast<double>(n);
  const double window = std::min(solver.radius(), arc.length() / 8);
  std::vector<Ball_guess> guesses;
  for (std::size_t i = 0; i < n; ++i) {
    const double s = spacing * static_cast<double>(i);
    const std::size_t edge = arc.segment(s);
    Ball_guess guess;
    const Vec at = arc(s);
    guess.direction = (arc.mean(s + spacing, window) - arc.mean(s - spacing, window)).normalized();
    for (int side = 0; side < 2; ++side) {
      const Surface_point from = foot_beside(solver, curve, edge, side, at);
      const Vec left = solver.surface(side).frame(from.face).face_normal.cross(guess.direction);
      guess.foot[side] = solver.surface(side)
                             .walk(from, (side == 0 ? 1 : -1) * beyond_round * solver.radius() * left.normalized())
                             .end;
    }
    // The centre, for planes at the feet.
    Eigen::Matrix3d normals;
    Vec heights;
    for (int side = 0; side < 2; ++side) {
      const Vec normal = solver.surface(side).normal(guess.foot[side]);
      normals.row(side) = normal;
      heights[side] = normal.dot(solver.surface(side).position(guess.foot[side])) + solver.distance();
    }
    normals.row(2) = guess.direction;
    heights[2] = guess.direction.dot(at);
    guess.point = normals.colPivHouseholderQr().solve(heights);
    guesses.push_back(guess);
  }
  return guesses;
}

}  // namespace cgal_blend
