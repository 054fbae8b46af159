// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuse_sides.h"

#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace cgal_blend {

namespace {

const Point_3& point(const Fuse_part& part, std::size_t v) {
  const std::size_t kept = part.cut.vertices.size();
  return v < kept ? part.mesh->point(part.cut.vertices[v]) : part.cut.points[v - kept];
}

Vector_3 unit(const Vector_3& v) { return v / std::sqrt(v.squared_length()); }

/// Cuts one mesh or takes its holes; `plane` receives the plane of the holes.
Fuse_part open_part(const Blend_mesh& mesh, const std::optional<Cut_plane>& by, bool tidy, Cut_plane& plane) {
  Fuse_part part;
  part.mesh = &mesh;
  part.cut = by ? cut(mesh, *by, tidy) : take_holes(mesh, plane);
  return part;
}

/// The first point of the holes of a part that is off the plane of the first part's holes.
std::optional<Point_3> point_off(const Cut_plane& plane, const Fuse_part& part) {
  double extent = 0;
  for (const auto& ring : part.cut.rings)
    for (const std::size_t v : ring)
      extent = std::max(extent, std::sqrt((point(part, v) - plane.point).squared_length()));
  for (const auto& ring : part.cut.rings)
    for (const std::size_t v : ring)
      if (std::abs((point(part, v) - plane.point) * plane.normal) > planar_hole * extent) return point(part, v);
  return std::nullopt;
}

/// Moves the plane's point to the centroid of the rings, and measures their edges.
void measure(Fuse_side& side) {
  Vector_3 sum(0, 0, 0);
  double length = 0, count = 0;
  for (const Section_loop& loop : side.points)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      sum = sum + (loop[i] - side.plane.point);
      length += std::sqrt(CGAL::squared_distance(loop[i], loop[(i + 1) % loop.size()]));
      ++count;
    }
  side.mean_edge = length / count;
  const Vector_3 shift = sum / count;
  side.plane.point = side.plane.point + (shift - (shift * side.plane.normal) * side.plane.normal);
}

}  // namespace

void put_before(Diagnosis& diagnosis, const std::string& subject) {
  diagnosis.detail = diagnosis.detail.empty() ? subject : subject + ": " + diagnosis.detail;
}

Fuse_side open_side(const Fusion_side& given, bool tidy) {
  Fuse_side side;
  side.cut = given.plane.has_value();
  if (given.plane) side.plane = *given.plane;
  for (const Blend_mesh* mesh : given.meshes) {
    Cut_plane plane = side.plane;
    side.parts.push_back(open_part(*mesh, given.plane, tidy, plane));
    Fuse_part& part = side.parts.back();
    side.diagnosis = part.cut.diagnosis;
    if (!side.cut && side.parts.size() == 1) side.plane = plane;
    if (side.diagnosis.ok() && !side.cut)
      if (const auto off = point_off(side.plane, part))
        side.diagnosis = {Status::opening_not_planar, "the holes of the meshes lie in different planes", *off, {}};
    if (side.diagnosis.ok()) continue;
    if (given.meshes.size() > 1) put_before(side.diagnosis, "mesh " + std::to_string(side.parts.size()));
    return side;
  }
  side.plane.normal = unit(side.plane.normal);
  for (const Fuse_part& part : side.parts)
    for (const auto& ring : part.cut.rings) {
      side.points.emplace_back();
      for (const std::size_t v : ring) side.points.back().push_back(point(part, v));
    }
  measure(side);
  return side;
}

void add_shifted_sections(Fuse_side& side, double share) {
  side.step = share * side.mean_edge;
  for (const int into : {0, 1}) {
    if (!side.cut && into == 0) continue;
    const double by = into == 1 ? -side.step : side.step;
    const Cut_plane shifted{side.plane.point + by * side.plane.normal, side.plane.normal};
    for (const Fuse_part& part : side.parts)
      for (Section_loop& loop : section(*part.mesh, shifted)) side.shifted[into].push_back(std::move(loop));
  }
}

std::size_t number_vertices(std::array<Fuse_side, 2>& sides) {
  std::size_t count = 0;
  for (Fuse_side& side : sides)
    for (Fuse_part& part : side.parts) {
      part.first_kept = count;
      count += part.cut.vertices.size();
    }
  for (Fuse_side& side : sides)
    for (Fuse_part& part : side.parts) {
      part.first_new = count;
      count += part.cut.points.size();
      for (const auto& ring : part.cut.rings) {
        side.rings.emplace_back();
        for (const std::size_t v : ring) side.rings.back().push_back(part.output_index(v));
      }
    }
  return count;
}

}  // namespace cgal_blend
