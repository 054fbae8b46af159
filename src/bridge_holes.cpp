// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/bridge.h>

#include <cgal_blend/geodesic_polar.h>

#include "nearest_face.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace cgal_blend {

namespace {

constexpr double margin = 1.01;  // of the radius that is named, over the rim's farthest vertex
constexpr int most_trials = 4;   // of radii

Face_point nearest_place(const Blend_mesh& mesh, const Point_3& p) {
  const Face face = nearest_face(mesh, p).face;
  const Halfedge h = mesh.halfedge(face);
  const std::array<Point_3, 3> corners{mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h))),
                                       mesh.point(mesh.source(h))};
  const Kernel::Triangle_3 triangle(corners[0], corners[1], corners[2]);
  const Point_3 foot = Kernel().construct_projected_point_3_object()(triangle, p);
  Face_point at{face, {}};
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    at.weights[i] = std::sqrt(CGAL::squared_area(foot, corners[(i + 1) % 3], corners[(i + 2) % 3]));
    sum += at.weights[i];
  }
  for (double& weight : at.weights) weight /= sum;
  return at;
}

/// Distance of the farthest vertex of a rim; none if there are no coordinates that go so far.
std::optional<double> farthest(const Filled_mesh& filled, const Filled_mesh::Hole& hole, const Point_3& spot) {
  double radius = 0;
  for (const Vertex v : hole.rim)
    radius = std::max(radius, std::sqrt(CGAL::squared_distance(spot, filled.mesh.point(v))));
  const Face_point at = nearest_place(filled.mesh, spot);
  for (int trial = 0; trial < most_trials; ++trial) {
    radius *= 1.5;  // a geodesic is longer than the chord
    const Geodesic_polar polar(filled.mesh, at, radius);
    if (!polar.diagnosis().ok()) return std::nullopt;
    if (!std::all_of(hole.rim.begin(), hole.rim.end(), [&](Vertex v) { return polar.covers(v); })) continue;
    double largest = 0;
    for (const Vertex v : hole.rim) largest = std::max(largest, polar(v).distance);
    return largest;
  }
  return std::nullopt;
}

const Bridge_end& nearest_end(const std::vector<Bridge_end>& ends, const Point_3& p) {
  return *std::min_element(ends.begin(), ends.end(), [&](const Bridge_end& a, const Bridge_end& b) {
    return CGAL::compare_distance_to_point(p, a.spot, b.spot) == CGAL::SMALLER;
  });
}

}  // namespace

namespace unchecked {

void move_spots_to_fillings(const Filled_mesh& filled, std::array<Bridge_end, 2>& ends) {
  for (Bridge_end& end : ends) {
    const Nearest_face nearest = nearest_face(filled.mesh, end.spot);
    const double tolerance = spot_tolerance * nearest.diagonal;
    if (nearest.distance <= tolerance) continue;
    if (const auto moved = point_on_filling(filled, end.spot, tolerance)) end.spot = *moved;
  }
}

Diagnosis check_fillings(const Filled_mesh& filled, const std::vector<std::uint32_t>& origins,
                         const std::vector<Bridge_end>& ends) {
  const Filled_mesh::Hole* hole = hole_left(filled, origins);
  if (!hole) return {};
  const Point_3 at = centre(filled, *hole);
  std::ostringstream text;
  text << "a hole of " << hole->rim.size() << " edges is not within a contact curve";
  if (!ends.empty())
    if (const auto radius = farthest(filled, *hole, nearest_end(ends, at).spot))
      text << "; a radius of " << margin * *radius << " at the spot would take it away";
  return {Status::region_meets_border, text.str(), at, {}};
}

}  // namespace unchecked

}  // namespace cgal_blend
