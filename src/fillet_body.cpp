// SPDX-License-Identifier: GPL-3.0-or-later
#include "fillet_body.h"

#include "collapse_short_edges.h"
#include "stitching.h"
#include "stopwatch.h"

#include <cgal_blend/validate.h>

#include <algorithm>
#include <optional>
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

/// Which face of the bases each face is a part of; see `Fillet_outcome`. The numbers of cells are just those.
std::vector<std::uint32_t> origins(const Fillet_body& body, const std::vector<Face>& faces,
                                   const std::vector<Cell_map::Cell>& remnant_cells) {
  const std::size_t old_faces = body.mesh->number_of_faces();
  std::vector<std::uint32_t> result;
  result.reserve(faces.size());
  for (const Face f : faces) {
    const std::size_t added = f.idx() - old_faces;  // wraps for old faces
    if (f.idx() < old_faces)
      result.push_back(body.cells.cell(f));
    else
      result.push_back(added < remnant_cells.size() ? remnant_cells[added] : no_origin);
  }
  return result;
}

/// Rids the result of its edges of almost no length, but for those of the input itself: its flaws are told, or accepted.
Blend_mesh without_short_edges(const Fillet_body& body, const Blend_mesh& mesh) {
  Blend_mesh result = mesh;
  const std::size_t old_faces = body.mesh->number_of_faces();
  const auto is_old = [&](Halfedge h) { return result.face(h).idx() < old_faces; };
  const std::size_t old_vertices = body.mesh->number_of_vertices();
  const auto is_original = [&](Vertex v) { return v.idx() < old_vertices && body.cells.is_original(v); };
  collapse_short_edges(result, is_original, [&](Edge e) {
    const Halfedge h = result.halfedge(e);
    if (!body.own_surface && is_old(h) && is_old(result.opposite(h))) return true;  // the boolean has made it
    return !is_original(result.source(h)) || !is_original(result.target(h));
  });
  return result;
}

}  // namespace

Fillet_outcome finish_body(const Fillet_body& body, const Blend_mesh& blended, const Body_changes& changes,
                           Blend_mesh& out) {
  Fillet_outcome outcome;
  Stopwatch copying;
  std::optional<Blend_mesh> mended;
  if (changes.moved.empty() && has_short_edges(blended))
    mended = without_short_edges(body, blended);
  const Blend_mesh& mesh = mended ? *mended : blended;
  const Order order = output_order(body, mesh);
  Reordered result = reorder(mesh, order.vertices, order.faces);
  outcome.origins = origins(body, order.faces, changes.remnant_cells);
  for (const Vertex v : changes.moved)
    for (const Face f : mesh.faces_around_target(mesh.halfedge(v))) {
      const Face placed = result.face_of[f.idx()];
      outcome.origins[placed.idx()] = no_origin;
      if (placed.idx() < order.kept_faces) outcome.changed_faces.push_back(placed);
    }
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
