// SPDX-License-Identifier: GPL-3.0-or-later
#include "spine_loops.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/box_intersection_d.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <memory>
#include <unordered_set>
#include <utility>

namespace cgal_blend {

namespace {

constexpr double meeting = 0.02;        // of the radius: steps nearer than this cross
constexpr double least_crossing = 0.1;  // sine of the angle between steps that cross
constexpr double longest_loop = 12;     // radii
constexpr double largest_share = 0.45;  // of the spine
constexpr double jump_ratio = 3;        // contact's way over the centre's, where the spine turns on the spot
constexpr double shortest_jump = 0.4;   // radii
constexpr double regress = 0.6;         // radii from the crossing back to the ends of the joint
constexpr double search_reach = 4;      // radii around the joint in which contacts are looked for
constexpr std::size_t fewest_joints = 4;
constexpr double widest_joint = 10;  // radii: farther apart, positions are too sparse to tell where the loop is
constexpr int taubin_steps = 6;
constexpr double taubin_lambda = 0.5, taubin_mu = -0.53;
constexpr double widest_contact_step = 1.5;  // of the joint's step
constexpr double nearest_contact = 0.4;      // radii: nearer the joint runs into the surface
constexpr double widest_contact = 1.6;       // radii: farther away the surface is none of the ball's

/// Where two segments are nearest: the middle between the nearest points, and their distance.
std::pair<Vec, double> nearest(const Vec& a, const Vec& b, const Vec& c, const Vec& d) {
  const Vec u = b - a, v = d - c, w = a - c;
  const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm(), uw = u.dot(w), vw = v.dot(w);
  const double det = uu * vv - uv * uv;
  double s = det > 1e-12 * uu * vv ? std::clamp((uv * vw - vv * uw) / det, 0.0, 1.0) : 0;
  const double t = vv > 0 ? std::clamp((uv * s + vw) / vv, 0.0, 1.0) : 0;
  s = uu > 0 ? std::clamp((uv * t - uw) / uu, 0.0, 1.0) : 0;
  const Vec p = a + s * u, q = c + t * v;
  return {(p + q) / 2, (p - q).norm()};
}

/// Chord lengths from the first position on; one more than positions.
std::vector<double> chord_lengths(const std::vector<Ball_position>& positions) {
  std::vector<double> start{0};
  for (std::size_t i = 0; i < positions.size(); ++i)
    start.push_back(start.back() + (positions[(i + 1) % positions.size()].center - positions[i].center).norm());
  return start;
}

/// Nearest points on the part of a base surface around some faces.
class Foot_finder {
 public:
  Foot_finder(const Base_surface& surface, const std::vector<Face>& seeds, const Vec& around, double reach)
      : surface_(surface) {
    const Blend_mesh& mesh = surface.mesh();
    std::unordered_set<Face> seen(seeds.begin(), seeds.end());
    faces_ = seeds;
    std::sort(faces_.begin(), faces_.end());
    faces_.erase(std::unique(faces_.begin(), faces_.end()), faces_.end());
    for (std::size_t i = 0; i < faces_.size(); ++i)
      for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(faces_[i]))) {
        if (!surface.crossable(h)) continue;
        const Face other = mesh.face(mesh.opposite(h));
        const Vec a = to_vec(mesh.point(mesh.source(h))), b = to_vec(mesh.point(mesh.target(h)));
        if (nearest(a, b, around, around).second > reach || !seen.insert(other).second) continue;
        faces_.push_back(other);
      }
    for (const Face f : faces_) {
      const Halfedge h = mesh.halfedge(f);
      triangles_.emplace_back(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                              mesh.point(mesh.target(mesh.next(h))));
    }
    tree_ = std::make_unique<Tree>(triangles_.cbegin(), triangles_.cend());
    tree_->build();
  }

  [[nodiscard]] Surface_point foot(const Vec& p) const {
    const auto [point, primitive] = tree_->closest_point_and_primitive(to_point(p));
    return surface_.locate(faces_[static_cast<std::size_t>(primitive - triangles_.cbegin())], to_vec(point));
  }

 private:
  using Triangle = Kernel::Triangle_3;
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, std::vector<Triangle>::const_iterator>;
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

  const Base_surface& surface_;
  std::vector<Face> faces_;
  std::vector<Triangle> triangles_;
  std::unique_ptr<Tree> tree_;
};

/// True if somewhere on the way between two contacts the surface is curved more sharply than the ball, towards it.
bool is_inverted_between(const Base_surface& surface, const Ball_position& a, const Ball_position& b, int side,
                         double radius) {
  const Vec way = b.contact[side] - a.contact[side];
  constexpr int samples = 16;
  for (int k = 0; k <= samples; ++k) {
    const Surface_point at = surface.walk(a.foot[side], way * (static_cast<double>(k) / samples)).end;
    const Vec normal = surface.normal(at);
    const Vec along = (way - way.dot(normal) * normal).stableNormalized();
    if (curvature_towards_ball(surface, at, a.contact[side] - a.center, along) * radius > 1) return true;
  }
  return false;
}

/// Unit tangent in c of the parabola through three points.
Vec end_tangent(const Vec& a, const Vec& b, const Vec& c) {
  const double ab = (b - a).norm(), bc = (c - b).norm();
  const Vec last = (c - b) / bc;
  return (last + bc / (ab + bc) * (last - (b - a) / ab)).stableNormalized();
}

/// Smooths the inner points of an open polyline, without shrinking it.
void taubin(std::vector<Vec>& points) {
  for (int step = 0; step < taubin_steps; ++step)
    for (const double factor : {taubin_lambda, taubin_mu}) {
      const std::vector<Vec> old = points;
      for (std::size_t i = 1; i + 1 < points.size(); ++i)
        points[i] = old[i] + factor * ((old[i - 1] + old[i + 1]) / 2 - old[i]);
    }
}

}  // namespace

std::optional<Spine_crossing> find_crossing(const std::vector<Ball_position>& positions, double radius) {
  const std::size_t n = positions.size();
  if (n < 4) return std::nullopt;
  const double reach = meeting * radius;
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec &a = positions[i].center, &b = positions[(i + 1) % n].center;
    const Vec low = a.cwiseMin(b).array() - reach, high = a.cwiseMax(b).array() + reach;
    boxes.emplace_back(CGAL::Bbox_3(low.x(), low.y(), low.z(), high.x(), high.y(), high.z()), i);
  }
  const std::vector<double> start = chord_lengths(positions);
  std::optional<Spine_crossing> longest;
  const double limit = std::min(longest_loop * radius, largest_share * start[n]);
  double best = 4 * reach;  // steps that are neighbours but for a few short ones are near each other without crossing
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& x, const Box& y) {
    const std::size_t i = std::min(x.info(), y.info()), j = std::max(x.info(), y.info());
    if (j - i < 2 || (i == 0 && j == n - 1)) return;
    const auto [at, distance] =
        nearest(positions[i].center, positions[i + 1].center, positions[j].center, positions[(j + 1) % n].center);
    if (distance > reach) return;
    const Vec u = positions[i + 1].center - positions[i].center,
              v = positions[(j + 1) % n].center - positions[j].center;
    if (u.cross(v).norm() < least_crossing * u.norm() * v.norm()) return;  // side by side
    const double inner =
        (start[j] - start[i + 1]) + (positions[i + 1].center - at).norm() + (positions[j].center - at).norm();
    const double loop = std::min(inner, start[n] - inner);
    if (loop > limit || loop <= best) return;
    best = loop;
    longest = inner <= start[n] - inner ? Spine_crossing{i, j, at} : Spine_crossing{j, i, at};
  });
  return longest;
}

std::optional<Spine_crossing> find_trimmed_loop(const std::vector<Ball_position>& positions,
                                                const std::array<const Base_surface*, 2>& surfaces, double radius) {
  const std::size_t n = positions.size();
  const auto at = [&](std::size_t i) -> const Ball_position& { return positions[i % n]; };
  for (int side = 0; side < 2; ++side) {
    const auto jumps = [&](std::size_t i) {
      const Ball_position &a = at(i), &b = at(i + 1);
      const double way = (b.contact[side] - a.contact[side]).norm();
      return !a.mended && !b.mended && way > jump_ratio * (b.center - a.center).norm();
    };
    std::size_t start = 0;  // outside any run
    while (start < n && jumps(start)) ++start;
    for (std::size_t i = start; i < start + n; ++i) {
      if (!jumps(i)) continue;
      const std::size_t first = i;
      double way = 0;
      bool inverted = false;
      for (; i < start + n && jumps(i); ++i) {
        way += (at(i + 1).contact[side] - at(i).contact[side]).norm();
        inverted = inverted || is_inverted_between(*surfaces[side], at(i), at(i + 1), side, radius);
      }
      if (way > shortest_jump * radius && inverted)
        return Spine_crossing{first % n, (i - 1) % n, (at(first).center + at(i).center) / 2};
    }
  }
  return std::nullopt;
}

std::optional<std::vector<Ball_position>> cut_loop(const std::vector<Ball_position>& positions,
                                                   const Spine_crossing& crossing,
                                                   const std::array<const Base_surface*, 2>& surfaces, double radius,
                                                   double step) {
  const std::size_t n = positions.size();
  if (surfaces[0]->rolls() || surfaces[1]->rolls()) return std::nullopt;  // feet on bands are on no face
  // What is left, starting behind the loop, without what lies too near to the crossing.
  std::vector<Ball_position> kept;
  for (std::size_t k = 0, i = (crossing.last + 1) % n; k < n; ++k, i = (i + 1) % n) {
    kept.push_back(positions[i]);
    if (i == crossing.first) break;
  }
  const auto near = [&](const Ball_position& p) { return (p.center - crossing.point).norm() < regress * radius; };
  while (!kept.empty() && near(kept.back())) kept.pop_back();
  std::reverse(kept.begin(), kept.end());
  while (!kept.empty() && near(kept.back())) kept.pop_back();
  std::reverse(kept.begin(), kept.end());
  if (kept.size() < fewest_joints) return std::nullopt;

  const Ball_position from = kept.back(), to = kept.front();
  const Vec leave = end_tangent(kept[kept.size() - 3].center, kept[kept.size() - 2].center, from.center);
  const Vec arrive = -end_tangent(kept[2].center, kept[1].center, to.center);
  const double span = (to.center - from.center).norm();
  if (span > widest_joint * radius) return std::nullopt;
  const auto joints = std::max(fewest_joints, static_cast<std::size_t>(std::ceil(span / step)));
  std::vector<Vec> centers;
  for (std::size_t k = 0; k <= joints; ++k) {
    const double s = static_cast<double>(k) / static_cast<double>(joints), r = 1 - s;
    centers.push_back(r * r * (1 + 2 * s) * from.center + s * s * (1 + 2 * r) * to.center +
                      span * (s * r * r * leave - s * s * r * arrive));
  }
  taubin(centers);

  std::vector<Foot_finder> finders;
  finders.reserve(2);
  for (int side = 0; side < 2; ++side)
    finders.emplace_back(*surfaces[side], std::vector<Face>{from.foot[side].face, to.foot[side].face}, crossing.point,
                         search_reach * radius);
  const auto joint_at = [&](const Vec& center, const std::array<Vec, 2>& near) {
    Ball_position joint;
    joint.radius = radius;
    joint.center = center;
    joint.mended = true;
    for (int side = 0; side < 2; ++side) {
      joint.foot[side] = finders[side].foot(near[side]);
      joint.contact[side] = surfaces[side]->position(joint.foot[side]);
    }
    return joint;
  };
  // Nearest points of the centres; of points on the chord between the outer contacts where those would run backward.
  std::array<bool, 2> forward{};
  for (int side = 0; side < 2; ++side) {
    const Vec chord = to.contact[side] - from.contact[side];
    std::vector<Vec> contacts{from.contact[side]};
    for (std::size_t k = 1; k < joints; ++k)
      contacts.push_back(surfaces[side]->position(finders[side].foot(centers[k])));
    contacts.push_back(to.contact[side]);
    forward[side] = true;
    for (std::size_t k = 0; k < joints; ++k)
      forward[side] = forward[side] && (contacts[k + 1] - contacts[k]).dot(chord) >= 0;
  }
  std::vector<Ball_position> joint{from};
  for (std::size_t k = 1; k < joints; ++k) {
    const double s = static_cast<double>(k) / static_cast<double>(joints);
    std::array<Vec, 2> near;
    for (int side = 0; side < 2; ++side)
      near[side] = forward[side] ? centers[k] : Vec((1 - s) * from.contact[side] + s * to.contact[side]);
    joint.push_back(joint_at(centers[k], near));
  }
  joint.push_back(to);
  for (std::size_t k = 0; k + 1 < joint.size(); ++k) {
    if (k > 0) kept.push_back(joint[k]);
    // Where a nearest point jumps over what the ball does not reach, the contact walks.
    const Ball_position &a = joint[k], &b = joint[k + 1];
    const double way = std::max((b.contact[0] - a.contact[0]).norm(), (b.contact[1] - a.contact[1]).norm());
    const auto steps = static_cast<std::size_t>(std::ceil(way / (widest_contact_step * step)));
    for (std::size_t i = 1; i < steps; ++i) {
      const double s = static_cast<double>(i) / static_cast<double>(steps);
      const auto between = [s](const Vec& p, const Vec& q) -> Vec { return (1 - s) * p + s * q; };
      kept.push_back(joint_at(between(a.center, b.center),
                              {between(a.contact[0], b.contact[0]), between(a.contact[1], b.contact[1])}));
    }
  }
  for (const Ball_position& p : kept)
    for (int side = 0; side < 2; ++side)
      if (const double arm = (p.contact[side] - p.center).norm();
          p.mended && (arm > widest_contact * radius || arm < nearest_contact * radius))
        return std::nullopt;
  return kept;
}

}  // namespace cgal_blend
