// SPDX-License-Identifier: GPL-3.0-or-later
#include "flat_regions.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <unordered_set>
#include <utility>

namespace cgal_blend {

namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// The sum of positions is taken about the first vertex, so that small bodies far from the origin lose no digits.
class Region_builder {
 public:
  Region_builder(const Blend_mesh& mesh, Face seed, double tolerance)
      : mesh_(mesh), seed_(seed), tolerance_(tolerance), origin_(to_vec(mesh.point(mesh.target(mesh.halfedge(seed))))) {
    region.area_vector = Vec::Zero();
    add(seed);
  }

  /// The face joins if it lies in the plane of the region that it would be a part of; so does the seed, which keeps the
  /// region from turning away. The larger of both decides on the plane.
  bool try_add(Face face) {
    const Vec area = region.area_vector + area_vector(face);
    const double length = area.norm();
    if (!(length > 0)) return false;
    Vec sum = sum_;
    std::size_t count = region.vertices.size();
    for (const Vertex v : corners(face))
      if (!members_.count(v)) {
        sum += to_vec(mesh_.point(v)) - origin_;
        ++count;
      }
    const Fitted_plane plane{origin_ + sum / static_cast<double>(count), area / length};
    const auto on_plane = [&](Vertex v) { return plane.distance(mesh_.point(v)) <= tolerance_; };
    const auto c = corners(face), s = corners(seed_);
    if (!std::all_of(c.begin(), c.end(), on_plane) || !std::all_of(s.begin(), s.end(), on_plane)) return false;
    add(face);
    return true;
  }

  void add(Face face) {
    region.faces.push_back(face);
    region.area_vector += area_vector(face);
    for (const Vertex v : corners(face))
      if (members_.insert(v).second) {
        region.vertices.push_back(v);
        sum_ += to_vec(mesh_.point(v)) - origin_;
      }
  }

  /// Fits the plane; false if some vertex is off it.
  bool finish() {
    const double length = region.area_vector.norm();
    region.plane = {origin_ + sum_ / static_cast<double>(region.vertices.size()),
                    length > 0 ? Vec(region.area_vector / length) : Vec(Vec::UnitZ())};
    return std::all_of(region.vertices.begin(), region.vertices.end(),
                       [&](Vertex v) { return region.plane.distance(mesh_.point(v)) <= tolerance_; });
  }

  Flat_region region;

 private:
  [[nodiscard]] std::array<Vertex, 3> corners(Face face) const {
    const Halfedge h = mesh_.halfedge(face);
    return {mesh_.source(h), mesh_.target(h), mesh_.target(mesh_.next(h))};
  }
  [[nodiscard]] Vec area_vector(Face face) const {
    const auto [u, v, w] = corners(face);
    const Vec p = to_vec(mesh_.point(u));
    return (to_vec(mesh_.point(v)) - p).cross(to_vec(mesh_.point(w)) - p);
  }

  const Blend_mesh& mesh_;
  Face seed_;
  double tolerance_;
  Vec origin_, sum_ = Vec::Zero();
  std::unordered_set<Vertex> members_;
};

}  // namespace

Flat_regions::Flat_regions(const Blend_mesh& mesh, double tolerance)
    : mesh_(mesh), tolerance_(tolerance), of_face_(mesh.num_faces(), none) {}

std::size_t Flat_regions::region_of(Face face) {
  if (of_face_[face.idx()] == none) {
    Flat_region region = grow(face);
    for (const Face f : region.faces) of_face_[f.idx()] = regions_.size();
    regions_.push_back(std::move(region));
  }
  return of_face_[face.idx()];
}

Flat_region Flat_regions::grow(Face seed) const {
  Region_builder builder(mesh_, seed, tolerance_);
  std::unordered_set<Face> reached{seed};
  for (std::size_t i = 0; i < builder.region.faces.size(); ++i) {
    const Face from = builder.region.faces[i];  // the vector grows
    for (const Halfedge h : mesh_.halfedges_around_face(mesh_.halfedge(from))) {
      const Face next = mesh_.face(mesh_.opposite(h));
      if (of_face_[next.idx()] == none && !reached.count(next) && builder.try_add(next)) reached.insert(next);
    }
  }
  if (builder.finish()) return std::move(builder.region);
  Region_builder alone(mesh_, seed, tolerance_);
  alone.finish();
  return std::move(alone.region);
}

}  // namespace cgal_blend
