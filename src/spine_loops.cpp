// SPDX-License-Identifier: GPL-3.0-or-later
#include "spine_loops.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/box_intersection_d.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <utility>

namespace cgal_blend {

namespace {

constexpr double meeting = 0.02;        // of the radius: steps nearer than this cross
constexpr double longest_loop = 12;     // radii
constexpr double largest_share = 0.45;  // of the spine
constexpr double regress = 0.6;         // radii from the crossing back to the ends of the joint
constexpr double search_reach = 4;      // radii around the joint in which contacts are looked for
constexpr std::size_t fewest_joints = 4;
constexpr int taubin_steps = 6;
constexpr double taubin_lambda = 0.5, taubin_mu = -0.53;
constexpr double widest_contact = 1.6;  // radii: farther away the surface is none of the ball's

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
    tree_.insert(triangles_.cbegin(), triangles_.cend());
    tree_.build();
  }

  [[nodiscard]] Surface_point foot(const Vec& p) const {
    const auto [point, primitive] = tree_.closest_point_and_primitive(to_point(p));
    return surface_.locate(faces_[static_cast<std::size_t>(primitive - triangles_.cbegin())], to_vec(point));
  }

 private:
  using Triangle = Kernel::Triangle_3;
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, std::vector<Triangle>::const_iterator>;

  const Base_surface& surface_;
  std::vector<Face> faces_;
  std::vector<Triangle> triangles_;
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree_;
};

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
    const double inner =
        (start[j] - start[i + 1]) + (positions[i + 1].center - at).norm() + (positions[j].center - at).norm();
    const double loop = std::min(inner, start[n] - inner);
    if (loop > limit || loop <= best) return;
    best = loop;
    longest = inner <= start[n] - inner ? Spine_crossing{i, j, at} : Spine_crossing{j, i, at};
  });
  return longest;
}

std::optional<std::vector<Ball_position>> cut_loop(const std::vector<Ball_position>& positions,
                                                   const Spine_crossing& crossing,
                                                   const std::array<const Base_surface*, 2>& surfaces, double radius,
                                                   double step) {
  const std::size_t n = positions.size();
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

  const Ball_position &from = kept.back(), &to = kept.front();
  const Vec leave = (from.center - kept[kept.size() - 2].center).stableNormalized();
  const Vec arrive = (kept[1].center - to.center).stableNormalized();
  const double span = (to.center - from.center).norm();
  const auto joints = std::max(fewest_joints, static_cast<std::size_t>(std::ceil(span / step)));
  std::vector<Vec> centers;
  for (std::size_t k = 0; k <= joints; ++k) {
    const double s = static_cast<double>(k) / static_cast<double>(joints), r = 1 - s;
    centers.push_back(r * r * (1 + 2 * s) * from.center + s * s * (1 + 2 * r) * to.center +
                      span * (s * r * r * leave - s * s * r * arrive));
  }
  taubin(centers);

  std::array<std::vector<Surface_point>, 2> feet;
  for (int side = 0; side < 2; ++side) {
    std::vector<Face> seeds{from.foot[side].face, to.foot[side].face};
    const Foot_finder finder(*surfaces[side], seeds, crossing.point, search_reach * radius);
    for (const Vec& c : centers) feet[side].push_back(finder.foot(c));
  }
  for (std::size_t k = 1; k < joints; ++k) {
    Ball_position joint;
    joint.center = centers[k];
    joint.mended = true;
    for (int side = 0; side < 2; ++side) {
      joint.foot[side] = feet[side][k];
      joint.contact[side] = surfaces[side]->position(joint.foot[side]);
      if ((joint.contact[side] - joint.center).norm() > widest_contact * radius) return std::nullopt;
    }
    kept.push_back(joint);
  }
  return kept;
}

}  // namespace cgal_blend
