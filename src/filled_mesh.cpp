// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/filled_mesh.h>

#include <cgal_blend/face_origin.h>
#include <cgal_blend/validate.h>

#include "hole_surroundings.h"

#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <iterator>
#include <sstream>
#include <unordered_map>
#include <unordered_set>

namespace cgal_blend {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Triangle_3 = Kernel::Triangle_3;

/// One border halfedge per hole, in the order of the halfedges.
std::vector<Halfedge> holes_of(const Blend_mesh& mesh) {
  std::vector<Halfedge> holes;
  std::unordered_set<Halfedge> seen;
  for (const Halfedge h : mesh.halfedges()) {
    if (!mesh.is_border(h) || seen.count(h)) continue;
    for (const Halfedge g : mesh.halfedges_around_face(h)) seen.insert(g);
    holes.push_back(h);
  }
  return holes;
}

Point_3 mean(const Blend_mesh& mesh, const std::vector<Vertex>& vertices) {
  Vector_3 sum(0, 0, 0);
  for (const Vertex v : vertices) sum += mesh.point(v) - CGAL::ORIGIN;
  return CGAL::ORIGIN + sum / static_cast<double>(vertices.size());
}

std::vector<Vertex> rim_of(const Blend_mesh& mesh, Halfedge hole) {
  std::vector<Vertex> rim;
  for (const Halfedge h : mesh.halfedges_around_face(hole)) rim.push_back(mesh.target(h));
  return rim;
}

std::vector<std::array<Point_3, 3>> flat_filling(const Blend_mesh& mesh, const std::vector<Vertex>& rim) {
  std::vector<Point_3> points;
  for (const Vertex v : rim) points.push_back(mesh.point(v));
  std::vector<CGAL::Triple<int, int, int>> triangles;
  PMP::triangulate_hole_polyline(points, std::back_inserter(triangles));
  std::vector<std::array<Point_3, 3>> flat;
  for (const auto& t : triangles) flat.push_back({points[t.first], points[t.second], points[t.third]});
  return flat;
}

/// Adds the filling of a hole to the mesh; false if there is none.
bool fill(const Blend_mesh& mesh, Halfedge at, Filled_mesh& filled) {
  Hole_surroundings around(mesh, at);
  const std::vector<Face> faces = around.fill();
  Filled_mesh::Hole hole;
  hole.rim = rim_of(mesh, at);
  hole.first = filled.mesh.number_of_faces();
  std::unordered_map<Vertex, Vertex> added;
  for (const Face f : faces) {
    std::vector<Vertex> corners;
    for (const Vertex v : around.copy().vertices_around_face(around.copy().halfedge(f))) {
      Vertex own = around.original(v);
      if (own == Blend_mesh::null_vertex()) {
        const auto [place, is_new] = added.emplace(v, Vertex());
        if (is_new) place->second = filled.mesh.add_vertex(around.copy().point(v));
        own = place->second;
      }
      corners.push_back(own);
    }
    if (filled.mesh.add_face(corners) == Blend_mesh::null_face()) return false;
  }
  hole.last = filled.mesh.number_of_faces();
  hole.flat = flat_filling(mesh, hole.rim);
  filled.holes.push_back(std::move(hole));
  return !faces.empty();
}

/// Mean direction of the opening: the sum of the flat triangles' areas.
Vector_3 axis(const Filled_mesh::Hole& hole) {
  Vector_3 sum(0, 0, 0);
  for (const auto& t : hole.flat) sum += CGAL::cross_product(t[1] - t[0], t[2] - t[0]);
  return sum;
}

Triangle_3 triangle(const Blend_mesh& mesh, std::size_t face) {
  const Halfedge h = mesh.halfedge(Face(static_cast<std::uint32_t>(face)));
  return {mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h)))};
}

/// Where the line along the opening's axis through a point meets the filling, nearest to the point.
std::optional<Point_3> over(const Filled_mesh& filled, const Filled_mesh::Hole& hole, const Point_3& p) {
  const Vector_3 along = axis(hole);
  if (!(along.squared_length() > 0)) return std::nullopt;
  std::optional<Point_3> nearest;
  for (std::size_t f = hole.first; f < hole.last; ++f) {
    const auto meeting = CGAL::intersection(Kernel::Line_3(p, along), triangle(filled.mesh, f));
    const Point_3* at = meeting ? boost::get<Point_3>(&*meeting) : nullptr;
    if (at && (!nearest || CGAL::compare_distance_to_point(p, *at, *nearest) == CGAL::SMALLER)) nearest = *at;
  }
  return nearest;
}

std::string place_of(const Point_3& p) {
  std::ostringstream text;
  text << "(" << p.x() << ", " << p.y() << ", " << p.z() << ")";
  return text.str();
}

std::string name_of_hole(std::size_t edges, const Point_3& at) {
  return "the hole of " + std::to_string(edges) + " edges around " + place_of(at);
}

Diagnosis describe_flaw(const Blend_mesh& mesh, const Flaw& flaw) {
  const auto& [f, g] = flaw.faces;
  Diagnosis diagnosis;
  diagnosis.status = flaw.status;
  diagnosis.detail = f == g ? "face " + std::to_string(f.idx())
                            : "faces " + std::to_string(f.idx()) + " and " + std::to_string(g.idx());
  diagnosis.point = mesh.point(mesh.source(mesh.halfedge(f)));
  return diagnosis;
}

}  // namespace

Filled_mesh fill_mesh(const Blend_mesh& mesh) {
  Filled_mesh filled;
  filled.mesh = mesh;
  filled.own_faces = mesh.number_of_faces();
  for (const Halfedge h : holes_of(mesh)) {
    if (fill(mesh, h, filled)) continue;
    const std::vector<Vertex> rim = rim_of(mesh, h);
    const Point_3 at = mean(mesh, rim);
    filled.diagnosis = {Status::input_not_closed, name_of_hole(rim.size(), at) + " cannot be filled", at, {}};
    break;
  }
  return filled;
}

Diagnosis check_but_for_holes(const Blend_mesh& mesh, bool holes_allowed, const std::string& advice) {
  const Validity_report report = validate(mesh);
  if (report.diagnosis.status != Status::input_not_closed || !report.manifold) return report.diagnosis;
  if (!holes_allowed) {
    Diagnosis diagnosis = report.diagnosis;
    const std::vector<Halfedge> holes = holes_of(mesh);
    if (holes.empty()) return diagnosis;
    const std::vector<Vertex> rim = rim_of(mesh, holes.front());
    diagnosis.point = mean(mesh, rim);
    diagnosis.detail = name_of_hole(rim.size(), *diagnosis.point);
    if (holes.size() > 1) diagnosis.detail += ", the first of " + std::to_string(holes.size());
    diagnosis.detail += advice;
    return diagnosis;
  }
  if (!report.flaws.empty()) return describe_flaw(mesh, report.flaws.front());
  const Filled_mesh filled = fill_mesh(mesh);
  if (!filled.diagnosis.ok()) return filled.diagnosis;
  return validate(filled.mesh, Flaw_policy::accept).diagnosis;  // for the orientation; fillings need not be sound
}

std::optional<Point_3> point_on_filling(const Filled_mesh& filled, const Point_3& p, double tolerance) {
  for (const Filled_mesh::Hole& hole : filled.holes)
    for (const auto& t : hole.flat)
      if (CGAL::squared_distance(p, Triangle_3(t[0], t[1], t[2])) <= tolerance * tolerance)
        return over(filled, hole, p);
  return std::nullopt;
}

const Filled_mesh::Hole* hole_left(const Filled_mesh& filled, const std::vector<std::uint32_t>& origins) {
  for (const std::uint32_t origin : origins) {
    if (origin == no_origin || origin < filled.own_faces) continue;
    for (const Filled_mesh::Hole& hole : filled.holes)
      if (origin >= hole.first && origin < hole.last) return &hole;
  }
  return nullptr;
}

Point_3 centre(const Filled_mesh& filled, const Filled_mesh::Hole& hole) { return mean(filled.mesh, hole.rim); }

}  // namespace cgal_blend
