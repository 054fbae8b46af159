// SPDX-License-Identifier: GPL-3.0-or-later
#include "boolean.h"

#include "corefinement.h"
#include "stitching.h"

#include <cgal_blend/face_origin.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <exception>
#include <map>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>

namespace cgal_blend {

namespace {

using Cell = Cell_map::Cell;
using Operands = std::array<const Blend_mesh*, 2>;

/// True if the base faces on both sides of an edge are coplanar. The faces of the result itself may be too small to tell.
/// \param point of a vertex of an operand
template <class Point_of>
bool flat(Edge e, const Blend_mesh& mesh, const Cell_map& cells, const Operands& operands, const Point_of& point) {
  using Point = std::decay_t<decltype(point(0, Vertex()))>;
  std::array<std::array<Point, 3>, 2> corner;
  for (int side = 0; side < 2; ++side) {
    const Face face = mesh.face(mesh.halfedge(e, side));
    const int operand = cells.operand(face);
    const Blend_mesh& base = *operands[operand];
    int i = 0;
    for (const Vertex v : base.vertices_around_face(base.halfedge(cells.base_face(face))))
      corner[side][i++] = point(operand, v);
  }
  for (const Point& p : corner[1])
    if (!CGAL::coplanar(corner[0][0], corner[0][1], corner[0][2], p)) return false;
  return true;
}

/// True if the faces at every vertex form one closed fan. Corefinement of bodies that are coplanar but for rounding may
/// answer that all is well and leave something else.
bool is_sound(const Blend_mesh& mesh) {
  std::size_t met = 0;
  for (const Vertex v : mesh.vertices()) {
    const Halfedge start = mesh.halfedge(v);
    if (start == Blend_mesh::null_halfedge()) return false;
    Halfedge h = start;
    do {
      if (mesh.is_border(h) || mesh.target(h) != v) return false;
      h = mesh.opposite(mesh.next(h));
      ++met;
    } while (h != start);
  }
  return met == mesh.number_of_halfedges();
}

/// Puts the result into an order that depends on the operands only: corefinement takes its own from addresses. Vertices
/// of the operands come first, new ones by their place; faces go by the face that they are a part of, and their corners.
/// A face starts at the first corner of that face, if it has it, else at its corner of least rank.
void put_in_order(Blend_mesh& mesh, Corefinement_record& record, const Operands& operands, std::vector<Edge>& creases) {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> rank(mesh.number_of_vertices(), no_origin);
  const auto list = [&](Vertex v) {
    if (v == Blend_mesh::null_vertex() || rank[v.idx()] != no_origin) return;
    rank[v.idx()] = static_cast<std::uint32_t>(vertices.size());
    vertices.push_back(v);
  };
  for (const auto& of_operand : record.vertex_of)
    for (const Vertex v : of_operand) list(v);
  std::vector<Vertex> others;
  for (const Vertex v : mesh.vertices())
    if (rank[v.idx()] == no_origin) others.push_back(v);
  const auto cells_at = [&](Vertex v) {
    std::vector<Cell> cells;
    for (const Face f : mesh.faces_around_target(mesh.halfedge(v))) cells.push_back(record.cell_of_face[f.idx()]);
    std::sort(cells.begin(), cells.end());
    return cells;
  };
  std::sort(others.begin(), others.end(), [&](Vertex v, Vertex w) {
    if (mesh.point(v) != mesh.point(w)) return mesh.point(v) < mesh.point(w);
    return cells_at(v) < cells_at(w);  // rounded to the same place
  });
  for (const Vertex v : others) list(v);

  struct Key {
    Cell cell;
    std::array<std::uint32_t, 3> corner;
    Face face;
    bool operator<(const Key& other) const { return std::tie(cell, corner) < std::tie(other.cell, other.corner); }
  };
  std::vector<Key> keys;
  for (const Face f : mesh.faces()) {
    const Cell cell = record.cell_of_face[f.idx()];
    const std::size_t operand = cell < record.faces[0] ? 0 : 1;
    const Blend_mesh& base = *operands[operand];
    const Halfedge of_base = base.halfedge(Face(static_cast<std::uint32_t>(cell - operand * record.faces[0])));
    const Vertex origin = record.vertex_of[operand][base.target(of_base).idx()];
    Halfedge least = mesh.halfedge(f), start;
    for (const Halfedge h : mesh.halfedges_around_face(least)) {
      if (rank[mesh.target(h).idx()] < rank[mesh.target(least).idx()]) least = h;
      if (origin != Blend_mesh::null_vertex() && mesh.target(h) == origin) start = h;
    }
    mesh.set_halfedge(f, start != Blend_mesh::null_halfedge() ? start : least);
    keys.push_back({cell, {}, f});
    for (auto& corner : keys.back().corner) {
      corner = rank[mesh.target(least).idx()];
      least = mesh.next(least);
    }
  }
  std::sort(keys.begin(), keys.end());
  std::vector<Face> faces;
  std::vector<Cell> cell_of_face;
  for (const Key& key : keys) {
    faces.push_back(key.face);
    cell_of_face.push_back(key.cell);
  }
  Blend_mesh ordered = reorder(mesh, vertices, faces).mesh;
  for (Edge& e : creases)
    e = ordered.edge(ordered.halfedge(Vertex(rank[mesh.vertex(e, 0).idx()]), Vertex(rank[mesh.vertex(e, 1).idx()])));
  std::sort(creases.begin(), creases.end());
  record.cell_of_face = std::move(cell_of_face);
  for (auto& of_operand : record.vertex_of)
    for (Vertex& v : of_operand)
      if (v != Blend_mesh::null_vertex()) v = Vertex(rank[v.idx()]);
  mesh = std::move(ordered);
}

Diagnosis refusal(Status status) {
  Diagnosis diagnosis;
  diagnosis.status = status;
  return diagnosis;
}

/// Turns what corefinement left behind into a result.
template <class Point_of>
void finish(Boolean_result& result, bool done, Edge_marks marks, Corefinement_record& record, const Operands& operands,
            const Point_of& point) {
  result.coplanar = record.coplanar && record.spread;
  result.contact = record.contact;
  if (!done) {  // CGAL's way to say that the result would not be manifold
    result.diagnosis = refusal(result.coplanar ? Status::operands_coplanar : Status::operands_touch);
    return;
  }
  if (!is_sound(result.mesh)) {
    result.diagnosis = refusal(result.coplanar ? Status::operands_coplanar : Status::boolean_failed);
    return;
  }
  record.cell_of_face.resize(result.mesh.number_of_faces());
  std::vector<Edge> creases;
  for (const Edge e : result.mesh.edges())
    if (marks[e]) creases.push_back(e);
  put_in_order(result.mesh, record, operands, creases);
  result.cells = Cell_map(record.faces, std::move(record.cell_of_face), std::move(record.vertex_of));
  for (const Edge e : creases)
    if (!flat(e, result.mesh, result.cells, operands, point)) result.curves.push_back(e);
}

Edge_marks add_marks(Blend_mesh& mesh) { return mesh.add_property_map<Edge, bool>("e:blending_curve", false).first; }

/// Gives the vertices of an exact result places in doubles: vertices of the operands those that they have, if they are
/// vertices of the result by corefinement or by their place.
void round_points(Exact_mesh& exact, const Shared_planes& planes, const Operands& operands,
                  Corefinement_record& record) {
  Blend_mesh& mesh = exact.mesh;
  std::vector<bool> placed(mesh.number_of_vertices(), false);
  const auto place = [&](Vertex v, const Point_3& p) {
    mesh.point(v) = p;
    placed[v.idx()] = true;
  };
  for (int k = 1; k >= 0; --k)  // where both operands have a vertex, the first decides
    for (const Vertex v : operands[k]->vertices())
      if (const Vertex w = record.vertex_of[k][v.idx()]; w != Blend_mesh::null_vertex())
        place(w, operands[k]->point(v));
  std::map<Point_3, std::vector<Vertex>> others;  // by their places rounded
  for (const Vertex v : mesh.vertices()) {
    if (placed[v.idx()]) continue;
    const Point_3 p = rounded(exact.points[v], planes.frame);
    place(v, p);
    others[p].push_back(v);
  }
  for (int k = 0; k < 2; ++k)
    for (const Vertex v : operands[k]->vertices()) {
      if (record.vertex_of[k][v.idx()] != Blend_mesh::null_vertex()) continue;
      const Exact_point& at = planes.points[k][v.idx()];
      const auto found = others.find(rounded(at, planes.frame));
      if (found == others.end()) continue;
      for (const Vertex w : found->second)
        if (exact.points[w] == at) {
          mesh.point(w) = operands[k]->point(v);
          record.vertex_of[k][v.idx()] = w;
        }
    }
}

}  // namespace

Boolean_result compute_boolean(const Blend_mesh& a, const Blend_mesh& b, Boolean_operation operation) {
  Boolean_result result;
  std::array<Blend_mesh, 2> copy{a, b};  // corefinement refines its operands
  Corefinement_record record;
  const Operands operands{&a, &b};
  const Edge_marks marks = add_marks(result.mesh);
  try {
    const bool done = corefine(copy, operation, result.mesh, marks, record);
    finish(result, done, marks, record, operands, [&](int k, Vertex v) { return operands[k]->point(v); });
  } catch (const std::exception&) {
    result.diagnosis = refusal(record.coplanar ? Status::operands_coplanar : Status::boolean_failed);
  }
  return result;
}

std::optional<Boolean_result> compute_boolean_on_shared_planes(const Blend_mesh& a, Blend_mesh& b,
                                                               Boolean_operation operation) {
  const std::optional<Shared_planes> planes = share_planes(a, b);
  if (!planes) return std::nullopt;
  for (const auto& [of_a, of_b] : planes->common) b.point(of_b) = a.point(of_a);
  const Operands operands{&a, &b};
  std::array<Exact_mesh, 2> exact;
  for (int k = 0; k < 2; ++k) {
    exact[k].mesh = *operands[k];
    exact[k].points = exact[k].mesh.add_property_map<Vertex, Exact_point>("v:exact").first;
    for (const Vertex v : exact[k].mesh.vertices()) exact[k].points[v] = planes->points[k][v.idx()];
  }
  Exact_mesh out;
  out.points = out.mesh.add_property_map<Vertex, Exact_point>("v:exact").first;
  const Edge_marks marks = add_marks(out.mesh);
  Boolean_result result;
  Corefinement_record record;
  try {
    const bool done = corefine_exactly(exact, operation, out, marks, record);
    if (done) round_points(out, *planes, operands, record);
    result.mesh = std::move(out.mesh);
    finish(result, done, marks, record, operands, [&](int k, Vertex v) { return planes->points[k][v.idx()]; });
  } catch (const std::exception&) {
    return std::nullopt;
  }
  return result;
}

}  // namespace cgal_blend
