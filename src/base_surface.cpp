// SPDX-License-Identifier: GPL-3.0-or-later
#include "base_surface.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace cgal_blend {

namespace {

constexpr int longest_walk = 4096;  // faces; a walk is a Newton step, a few ball radii long

}  // namespace

double angle_between(const Vec& a, const Vec& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

Base_surface::Base_surface(const Blend_mesh& mesh, const Options& options, const std::unordered_set<Edge>* creases,
                           const std::unordered_set<Face>* blends)
    : mesh_(mesh),
      options_(options),
      cos_smooth_(std::cos(options.smooth_angle * pi / 180)),
      creases_(creases),
      blends_(blends),
      first_virtual_(static_cast<std::uint32_t>(mesh.number_of_faces() + mesh.number_of_removed_faces())) {}

Vec Base_surface::raw_normal(Face face) const {
  const Halfedge h = mesh_.halfedge(face);
  const Vec a = to_vec(mesh_.point(mesh_.source(h)));
  const Vec b = to_vec(mesh_.point(mesh_.target(h)));
  const Vec c = to_vec(mesh_.point(mesh_.target(mesh_.next(h))));
  const Vec n = (b - a).cross(c - a).stableNormalized();
  return options_.reversed ? Vec(-n) : n;
}

bool Base_surface::steep(Edge e) const {
  const Halfedge h = mesh_.halfedge(e), o = mesh_.opposite(h);
  const Vec a = to_vec(mesh_.point(mesh_.source(h))), b = to_vec(mesh_.point(mesh_.target(h)));
  const Vec left = (b - a).cross(to_vec(mesh_.point(mesh_.target(mesh_.next(h)))) - a);
  const Vec right = (a - b).cross(to_vec(mesh_.point(mesh_.target(mesh_.next(o)))) - b);
  return left.dot(right) < cos_smooth_ * std::sqrt(left.squaredNorm() * right.squaredNorm());
}

bool Base_surface::sharp(Edge e) const {
  if ((creases_ && creases_->count(e)) || mesh_.is_border(e)) return true;
  return steep(e) && (options_.shortest_crease <= 0 || on_long_crease(e));
}

bool Base_surface::on_long_crease(Edge e) const {
  const auto found = long_creases_.find(e.idx());
  if (found != long_creases_.end()) return found->second;
  std::vector<Edge> crease{e};
  std::unordered_set<Edge> seen{e};
  double length = 0;
  for (std::size_t i = 0; i < crease.size() && length < options_.shortest_crease; ++i) {
    const Halfedge h = mesh_.halfedge(crease[i]);
    length += (to_vec(mesh_.point(mesh_.target(h))) - to_vec(mesh_.point(mesh_.source(h)))).norm();
    for (const Halfedge end : {h, mesh_.opposite(h)})
      for (const Halfedge g : mesh_.halfedges_around_target(end))
        if (!mesh_.is_border(mesh_.edge(g)) && !seen.count(mesh_.edge(g)) && steep(mesh_.edge(g))) {
          seen.insert(mesh_.edge(g));
          crease.push_back(mesh_.edge(g));
        }
  }
  return long_creases_[e.idx()] = length >= options_.shortest_crease;
}

std::vector<Halfedge> Base_surface::fan_corners(Halfedge h) const {
  const auto backward = [&](Halfedge g) { return mesh_.prev(mesh_.opposite(g)); };
  const auto forward = [&](Halfedge g) { return mesh_.opposite(mesh_.next(g)); };
  Halfedge first = h;
  while (!sharp(mesh_.edge(first))) {
    first = backward(first);
    if (first == h) break;
  }
  std::vector<Halfedge> corners{first};
  for (Halfedge g = first; !sharp(mesh_.edge(mesh_.next(g)));) {
    g = forward(g);
    if (g == first) break;
    corners.push_back(g);
  }
  return corners;
}

Halfedge Base_surface::fan(Halfedge h) const {
  const auto found = fans_.find(h.idx());
  return found != fans_.end() ? found->second : name_fan(fan_corners(h));
}

Halfedge Base_surface::name_fan(const std::vector<Halfedge>& corners) const {
  const Halfedge id = *std::min_element(corners.begin(), corners.end());
  for (const Halfedge g : corners) fans_[g.idx()] = id;
  return id;
}

/// Not of unit length, so that interpolation over the parts of a divided face gives what it gave over the whole.
Vec Base_surface::normal_on_edge(const Edge_point& at, const std::vector<Halfedge>& corners) const {
  const bool left = std::find(corners.begin(), corners.end(), at.into) != corners.end();
  const Halfedge first = left ? mesh_.prev(at.first) : mesh_.opposite(at.first);
  const Halfedge last = left ? at.last : mesh_.prev(mesh_.opposite(at.last));
  return (1 - at.part) * corner_normal(first, 0) + at.part * corner_normal(last, 0);
}

Vec Base_surface::smoothed_normal(const std::vector<Halfedge>& corners, Halfedge id, int pass) const {
  Vec sum = Vec::Zero();
  if (pass == 0) {
    if (options_.edge_points)
      if (const auto at = options_.edge_points->find(mesh_.target(id)); at != options_.edge_points->end())
        return normal_on_edge(at->second, corners);
    const auto is_blend = [&](Halfedge g) { return blends_ && blends_->count(mesh_.face(g)) != 0; };
    const bool only_blends = std::all_of(corners.begin(), corners.end(), is_blend);
    // Weights by angle: a quadrilateral split along either diagonal gives the same normal.
    for (const Halfedge g : corners) {
      if (!only_blends && is_blend(g)) continue;
      const Vec v = to_vec(mesh_.point(mesh_.target(g)));
      const Vec to = to_vec(mesh_.point(mesh_.target(mesh_.next(g)))) - v;
      const Vec from = to_vec(mesh_.point(mesh_.source(g))) - v;
      sum +=
          (options_.area_weights ? to.cross(from).squaredNorm() : angle_between(to, from)) * raw_normal(mesh_.face(g));
    }
    return sum.stableNormalized();
  }
  for (const Halfedge g : corners)
    sum += corner_normal(mesh_.next(g), pass - 1) + corner_normal(mesh_.prev(g), pass - 1);
  sum /= 2.0 * static_cast<double>(corners.size());
  return (sum + corner_normal(id, pass - 1)).stableNormalized();
}

Vec Base_surface::corner_normal(Halfedge h, int pass) const {
  const auto known = fans_.find(h.idx());
  std::vector<Halfedge> corners;
  if (known == fans_.end()) corners = fan_corners(h);
  const Halfedge id = known != fans_.end() ? known->second : name_fan(corners);
  const std::uint64_t key = (static_cast<std::uint64_t>(pass) << 32) | id.idx();
  const auto found = normals_.find(key);
  if (found != normals_.end()) return found->second;
  if (corners.empty()) corners = fan_corners(h);
  const Vec n = smoothed_normal(corners, id, pass);
  normals_.emplace(key, n);
  return n;
}

const Base_surface::Frame& Base_surface::frame(Face face) const {
  const auto found = frames_.find(face.idx());
  if (found != frames_.end()) return found->second;
  Frame f;
  f.halfedge[0] = mesh_.halfedge(face);
  f.halfedge[1] = mesh_.next(f.halfedge[0]);
  f.halfedge[2] = mesh_.next(f.halfedge[1]);
  for (int i = 0; i < 3; ++i) {
    f.corner[i] = f.place[i] = to_vec(mesh_.point(mesh_.target(f.halfedge[i])));
    f.normal[i] = corner_normal(f.halfedge[i], options_.smoothing_passes);
  }
  const Vec cross = (f.corner[1] - f.corner[0]).cross(f.corner[2] - f.corner[0]);
  const Vec unit = cross.stableNormalized();
  for (int i = 0; i < 3; ++i)
    f.gradient[i] = unit.cross(f.corner[(i + 2) % 3] - f.corner[(i + 1) % 3]) / cross.stableNorm();
  f.face_normal = options_.reversed ? Vec(-unit) : unit;
  return frames_.emplace(face.idx(), f).first->second;
}

Vec Base_surface::position(const Surface_point& at) const {
  const Frame& f = frame(at.face);
  return at.bary[0] * f.place[0] + at.bary[1] * f.place[1] + at.bary[2] * f.place[2];
}

Vec Base_surface::normal(const Surface_point& at) const {
  const Frame& f = frame(at.face);
  return (at.bary[0] * f.normal[0] + at.bary[1] * f.normal[1] + at.bary[2] * f.normal[2]).stableNormalized();
}

Base_surface::Offset Base_surface::offset(const Surface_point& at, double distance) const {
  const Frame& f = frame(at.face);
  Vec p = Vec::Zero(), n = Vec::Zero();
  Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero(), moved = Eigen::Matrix3d::Identity();
  if (is_virtual(at.face)) moved.setZero();
  for (int i = 0; i < 3; ++i) {
    p += at.bary[i] * f.place[i];
    n += at.bary[i] * f.normal[i];
    gradient += f.normal[i] * f.gradient[i].transpose();
    if (is_virtual(at.face)) moved += f.place[i] * f.gradient[i].transpose();
  }
  const double length = n.norm();
  const Vec unit = n / length;
  const Eigen::Matrix3d project = Eigen::Matrix3d::Identity() - unit * unit.transpose();
  return {p + distance * unit, moved + distance / length * project * gradient};
}

double Base_surface::normal_curvature(const Surface_point& at, const Vec& direction) const {
  return direction.dot((offset(at, 1).derivative - offset(at, 0).derivative) * direction);
}

Surface_point Base_surface::locate(Face face, const Vec& p) const {
  const Frame& f = frame(face);
  Surface_point at{face, {}};
  for (int i = 0; i < 3; ++i) at.bary[i] = 1 + f.gradient[i].dot(p - f.corner[i]);
  if (at.bary.minCoeff() >= 0) return at;
  double best = -1;
  for (int i = 0; i < 3; ++i) {  // outside: the nearest point lies on one of the sides
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const Vec side = f.corner[k] - f.corner[j];
    const double t = std::clamp((p - f.corner[j]).dot(side) / side.squaredNorm(), 0.0, 1.0);
    const double distance = (f.corner[j] + t * side - p).squaredNorm();
    if (best >= 0 && distance >= best) continue;
    best = distance;
    at.bary[i] = 0;
    at.bary[j] = 1 - t;
    at.bary[k] = t;
  }
  return at;
}

bool Base_surface::crossable(Halfedge h) const {
  if (mesh_.is_border(mesh_.edge(h))) return false;
  if (!sharp(mesh_.edge(h))) return true;
  if (creases_ && creases_->count(mesh_.edge(h))) return false;
  const Halfedge o = mesh_.opposite(h);
  return fan(h) == fan(mesh_.prev(o)) && fan(mesh_.prev(h)) == fan(o);
}

std::vector<Halfedge> Base_surface::border_chain(Halfedge h, bool forward, const Vec& center, double distance) const {
  std::vector<Halfedge> chain{h};
  std::unordered_set<Halfedge> seen{h};
  while (true) {
    const Vertex end = forward ? mesh_.target(h) : mesh_.source(h);
    if ((to_vec(mesh_.point(end)) - center).norm() > distance) break;
    const Halfedge start = h;
    h = next_on_border(h, forward);
    if (rolls_over(h)) h = next_on_border(mesh_.opposite(h), forward);  // to the face that the ball rolls on to
    if (h == mesh_.opposite(start) || !seen.insert(h).second) break;
    chain.push_back(h);
  }
  return chain;
}

Base_surface::Side Base_surface::across(const Surface_point& at, int exit) const {
  if (band_edge(at.face) != Blend_mesh::null_halfedge()) return across_band(at.face, exit);
  if (is_virtual(at.face)) return virtual_[at.face.idx() - first_virtual_].sides[exit];
  // The side opposite to corner i is the halfedge that ends in corner i + 2.
  const Halfedge h = frame(at.face).halfedge[(exit + 2) % 3];
  if (!crossable(h)) {
    const auto found = extension_beyond_.find(h.idx());
    if (found != extension_beyond_.end()) return found->second;
    return rolls_over(h) ? band_beyond(h) : Side{Blend_mesh::null_face(), -1, h};
  }
  const Halfedge o = mesh_.opposite(h);
  return {mesh_.face(o), (index_of(o) + 1) % 3, Halfedge()};
}

Base_surface::Walk Base_surface::walk(Surface_point from, Vec displacement) const {
  for (int step = 0; step < longest_walk; ++step) {
    const Frame& f = frame(from.face);
    Eigen::Vector3d rate;
    for (int i = 0; i < 3; ++i) rate[i] = f.gradient[i].dot(displacement);
    int exit = -1;
    double part = 1;
    for (int i = 0; i < 3; ++i)
      if (rate[i] < 0 && from.bary[i] + part * rate[i] < 0) {
        part = std::max(0.0, from.bary[i] / -rate[i]);
        exit = i;
      }
    from.bary = (from.bary + part * rate).cwiseMax(0.0);
    from.bary /= from.bary.sum();
    if (exit < 0) return {from, Halfedge()};
    from.bary[exit] = 0;
    const Side beyond = across(from, exit);
    if (beyond.face == Blend_mesh::null_face()) return {from, beyond.blocked};
    const Frame& g = frame(beyond.face);
    const Vec side = (f.corner[(exit + 2) % 3] - f.corner[(exit + 1) % 3]).stableNormalized();
    const Vec rest = (1 - part) * displacement;
    const double along = rest.dot(side);
    const double ahead = (rest - along * side).norm();
    Surface_point to{beyond.face, Eigen::Vector3d::Zero()};
    to.bary[(beyond.opposite + 1) % 3] = from.bary[(exit + 2) % 3];
    to.bary[(beyond.opposite + 2) % 3] = from.bary[(exit + 1) % 3];
    displacement = along * side + ahead * g.gradient[beyond.opposite].stableNormalized();
    from = to;
  }
  return {from, Halfedge()};
}

}  // namespace cgal_blend
