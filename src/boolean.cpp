// SPDX-License-Identifier: GPL-3.0-or-later
#include "boolean.h"

#include "stitching.h"

#include <CGAL/Polygon_mesh_processing/corefinement.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <exception>
#include <memory>
#include <tuple>
#include <utility>

namespace cgal_blend {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Cell = Cell_map::Cell;

/// What the visitor learns; shared by its copies.
struct Record {
  std::array<const Blend_mesh*, 2> operand{};
  std::array<std::size_t, 2> faces{}, vertices{};  // before corefinement
  std::array<std::vector<Cell>, 2> origin;         // base face of each face, by operand
  std::array<std::vector<Vertex>, 2> vertex_of;
  std::vector<Cell> cell_of_face;
  Cell current = 0;
  bool coplanar = false;
  bool contact = false;
  bool spread = false;               // contact beyond vertices, or at vertices that are not in line
  std::vector<Point_3> at_vertices;  // up to two different ones

  void note(const Point_3* vertex) {
    contact = true;
    if (spread) return;
    if (!vertex)
      spread = true;
    else if (at_vertices.size() == 2)
      spread = !CGAL::collinear(at_vertices[0], at_vertices[1], *vertex);
    else if (at_vertices.empty() || at_vertices[0] != *vertex)
      at_vertices.push_back(*vertex);
  }

  [[nodiscard]] int side(const Blend_mesh& mesh) const { return &mesh == operand[0] ? 0 : 1; }
};

struct Origin_visitor : PMP::Corefinement::Default_visitor<Blend_mesh> {
  std::shared_ptr<Record> record;

  void before_subface_creations(Face old, Blend_mesh& mesh) {
    record->current = record->origin[record->side(mesh)][old.idx()];
  }
  void after_subface_created(Face created, Blend_mesh& mesh) {
    auto& origin = record->origin[record->side(mesh)];
    if (origin.size() <= created.idx()) origin.resize(created.idx() + 1);
    origin[created.idx()] = record->current;
  }
  void after_face_copy(Face old, const Blend_mesh& mesh, Face copy, Blend_mesh&) {
    const int side = record->side(mesh);
    auto& cells = record->cell_of_face;
    if (cells.size() <= copy.idx()) cells.resize(copy.idx() + 1);
    cells[copy.idx()] = record->origin[side][old.idx()] + static_cast<Cell>(side == 1 ? record->faces[0] : 0);
  }
  void after_vertex_copy(Vertex old, const Blend_mesh& mesh, Vertex copy, Blend_mesh&) {
    const int side = record->side(mesh);
    if (old.idx() < record->vertices[side]) record->vertex_of[side][old.idx()] = copy;
  }
  void intersection_point_detected(std::size_t, int dimension, Halfedge edge, Halfedge simplex, const Blend_mesh& mesh,
                                   const Blend_mesh& other, bool target_on, bool source_on) {
    const Point_3* vertex = target_on        ? &mesh.point(mesh.target(edge))
                            : source_on      ? &mesh.point(mesh.source(edge))
                            : dimension == 0 ? &other.point(other.target(simplex))
                                             : nullptr;
    record->note(vertex);
  }
  void start_handling_intersection_of_coplanar_faces(std::size_t count) const {
    if (count > 0) record->coplanar = true;
  }
};

bool run(Blend_mesh& a, Blend_mesh& b, Boolean_operation operation, Blend_mesh& out, const Origin_visitor& visitor,
         Blend_mesh::Property_map<Edge, bool> crease) {
  const auto in = CGAL::parameters::visitor(visitor).throw_on_self_intersection(true);
  const auto none = CGAL::parameters::default_values();
  const auto marked = CGAL::parameters::edge_is_constrained_map(crease);
  switch (operation) {
    case Boolean_operation::union_: return PMP::corefine_and_compute_union(a, b, out, in, none, marked);
    case Boolean_operation::intersection: return PMP::corefine_and_compute_intersection(a, b, out, in, none, marked);
    case Boolean_operation::difference: return PMP::corefine_and_compute_difference(a, b, out, in, none, marked);
  }
  return false;
}

/// True if the base faces on both sides of an edge are coplanar. The faces of the result itself may be too small to tell.
bool flat(Edge e, const Blend_mesh& mesh, const Cell_map& cells, const std::array<const Blend_mesh*, 2>& operands) {
  std::array<std::array<Point_3, 3>, 2> corner;
  for (int side = 0; side < 2; ++side) {
    const Face face = mesh.face(mesh.halfedge(e, side));
    const Blend_mesh& base = *operands[cells.operand(face)];
    int i = 0;
    for (const Vertex v : base.vertices_around_face(base.halfedge(cells.base_face(face))))
      corner[side][i++] = base.point(v);
  }
  for (const Point_3& p : corner[1])
    if (!CGAL::coplanar(corner[0][0], corner[0][1], corner[0][2], p)) return false;
  return true;
}

/// Puts the result into an order that depends on the operands only: corefinement takes its own from addresses. Vertices
/// of the operands come first, new ones by their place; faces go by the face that they are a part of, and their corners.
/// A face starts at the first corner of that face, if it has it, else at its corner of least rank.
void put_in_order(Blend_mesh& mesh, Record& record, const std::array<const Blend_mesh*, 2>& operands,
                  std::vector<Edge>& creases) {
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

}  // namespace

Boolean_result compute_boolean(const Blend_mesh& a, const Blend_mesh& b, Boolean_operation operation) {
  Boolean_result result;
  std::array<Blend_mesh, 2> copy{a, b};  // corefinement refines its operands
  auto record = std::make_shared<Record>();
  for (int k = 0; k < 2; ++k) {
    record->operand[k] = &copy[k];
    record->faces[k] = copy[k].number_of_faces();
    record->vertices[k] = copy[k].number_of_vertices();
    for (const Face f : copy[k].faces()) record->origin[k].push_back(f.idx());
    record->vertex_of[k].resize(record->vertices[k]);
  }
  Origin_visitor visitor;
  visitor.record = record;
  auto crease = result.mesh.add_property_map<Edge, bool>("e:blending_curve", false).first;
  bool done = false;
  try {
    done = run(copy[0], copy[1], operation, result.mesh, visitor, crease);
  } catch (const std::exception&) {
    result.diagnosis = refusal(record->coplanar ? Status::operands_coplanar : Status::boolean_failed);
    return result;
  }
  result.coplanar = record->coplanar && record->spread;
  result.contact = record->contact;
  if (!done) {  // CGAL's way to say that the result would not be manifold
    result.diagnosis = refusal(record->coplanar && record->spread ? Status::operands_coplanar : Status::operands_touch);
    return result;
  }
  record->cell_of_face.resize(result.mesh.number_of_faces());
  std::vector<Edge> creases;
  for (const Edge e : result.mesh.edges())
    if (crease[e]) creases.push_back(e);
  put_in_order(result.mesh, *record, {&a, &b}, creases);
  result.cells = Cell_map(record->faces, std::move(record->cell_of_face), std::move(record->vertex_of));
  for (const Edge e : creases)
    if (!flat(e, result.mesh, result.cells, {&a, &b})) result.curves.push_back(e);
  return result;
}

}  // namespace cgal_blend
