// SPDX-License-Identifier: GPL-3.0-or-later
#include "fillet_body.h"

#include "stitching.h"
#include "stopwatch.h"

#include <cgal_blend/validate.h>

#include <algorithm>
#include <utility>

namespace cgal_blend {

namespace {

/// Elements of a body in the order they are handed out: those of the bases first, in their order.
struct Order {
  std::vector<Vertex> vertices;
  std::vector<Face> faces;
  std::size_t kept_faces = 0;
};

Order output_order(const Fillet_body& body, const Blend_mesh& mesh) {
  Order order;
  std::vector<bool> listed(mesh.number_of_vertices() + mesh.number_of_removed_vertices(), false);
  const auto list = [&](Vertex v) {
    if (v == Blend_mesh::null_vertex() || mesh.is_removed(v) || listed[v.idx()]) return;
    listed[v.idx()] = true;
    order.vertices.push_back(v);
  };
  for (int operand = 0; operand < 2; ++operand)
    if (body.base[operand])
      for (const Vertex v : body.base[operand]->vertices()) list(body.cells.vertex(operand, v));
  for (const Vertex v : mesh.vertices()) list(v);
  const std::size_t old_faces = body.mesh->number_of_faces();
  std::vector<Face> changed;
  std::vector<std::pair<Cell_map::Cell, Face>> kept;
  for (const Face f : mesh.faces()) {
    if (f.idx() < old_faces && body.cells.whole(f, mesh))
      kept.push_back({body.cells.cell(f), f});
    else
      changed.push_back(f);
  }
  if (!std::is_sorted(kept.begin(), kept.end())) std::sort(kept.begin(), kept.end());
  for (const auto& [cell, face] : kept) order.faces.push_back(face);
  order.kept_faces = order.faces.size();
  order.faces.insert(order.faces.end(), changed.begin(), changed.end());
  return order;
}

}  // namespace

Fillet_outcome finish_body(const Fillet_body& body, const Blend_mesh& mesh, Blend_mesh& out,
                           const std::vector<Vertex>& moved) {
  Fillet_outcome outcome;
  Stopwatch copying;
  const Order order = output_order(body, mesh);
  Reordered result = reorder(mesh, order.vertices, order.faces);
  for (const Vertex v : moved)
    for (const Face f : mesh.faces_around_target(mesh.halfedge(v)))
      if (result.face_of[f.idx()].idx() < order.kept_faces) outcome.changed_faces.push_back(result.face_of[f.idx()]);
  std::sort(outcome.changed_faces.begin(), outcome.changed_faces.end());
  outcome.changed_faces.erase(std::unique(outcome.changed_faces.begin(), outcome.changed_faces.end()),
                              outcome.changed_faces.end());
  outcome.kept_faces = order.kept_faces - outcome.changed_faces.size();
  for (std::size_t i = order.kept_faces; i < order.faces.size(); ++i)
    outcome.changed_faces.push_back(Face(static_cast<std::uint32_t>(i)));
  outcome.times.copy = copying.milliseconds();
  Stopwatch watch;
  const Validity_report report = validate_changes(result.mesh, outcome.changed_faces);
  outcome.times.validate = watch.milliseconds();
  outcome.diagnosis = report.diagnosis;
  outcome.volume = report.volume;
  outcome.area = report.area;
  out = std::move(result.mesh);
  return outcome;
}

}  // namespace cgal_blend
