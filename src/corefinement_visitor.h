// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_COREFINEMENT_VISITOR_H
#define CGAL_BLEND_SRC_COREFINEMENT_VISITOR_H

#include "corefinement.h"

#include <CGAL/Polygon_mesh_processing/corefinement.h>

#include <array>
#include <memory>
#include <vector>

namespace cgal_blend {

/// Keeps the record; `Points` maps vertices to the points that corefinement computes with.
template <class Points>
class Corefinement_visitor : public CGAL::Polygon_mesh_processing::Corefinement::Default_visitor<Blend_mesh> {
 public:
  Corefinement_visitor(const std::array<const Blend_mesh*, 2>& operands, const std::array<Points, 2>& points,
                       Corefinement_record& record)
      : operands_(operands), points_(points), record_(&record), shared_(std::make_shared<Shared>()) {
    for (int k = 0; k < 2; ++k) {
      record.faces[k] = operands[k]->number_of_faces();
      record.vertices[k] = operands[k]->number_of_vertices();
      for (const Face f : operands[k]->faces()) record.origin[k].push_back(f.idx());
      record.vertex_of[k].resize(record.vertices[k]);
    }
  }

  void before_subface_creations(Face old, Blend_mesh& mesh) {
    shared_->current = record_->origin[side(mesh)][old.idx()];
  }
  void after_subface_created(Face created, Blend_mesh& mesh) {
    auto& origin = record_->origin[side(mesh)];
    if (origin.size() <= created.idx()) origin.resize(created.idx() + 1);
    origin[created.idx()] = shared_->current;
  }
  void after_face_copy(Face old, const Blend_mesh& mesh, Face copy, Blend_mesh&) {
    const int k = side(mesh);
    auto& cells = record_->cell_of_face;
    if (cells.size() <= copy.idx()) cells.resize(copy.idx() + 1);
    cells[copy.idx()] = record_->origin[k][old.idx()] + static_cast<Cell_map::Cell>(k == 1 ? record_->faces[0] : 0);
  }
  void after_vertex_copy(Vertex old, const Blend_mesh& mesh, Vertex copy, Blend_mesh&) {
    const int k = side(mesh);
    if (old.idx() < record_->vertices[k]) record_->vertex_of[k][old.idx()] = copy;
  }
  void intersection_point_detected(std::size_t, int dimension, Halfedge edge, Halfedge simplex, const Blend_mesh& mesh,
                                   const Blend_mesh& other, bool target_on, bool source_on) {
    const auto point = [&](const Blend_mesh& m, Vertex v) { return &get(points_[side(m)], v); };
    note(target_on        ? point(mesh, mesh.target(edge))
         : source_on      ? point(mesh, mesh.source(edge))
         : dimension == 0 ? point(other, other.target(simplex))
                          : nullptr);
  }
  void start_handling_intersection_of_coplanar_faces(std::size_t count) const {
    if (count > 0) record_->coplanar = true;
  }

 private:
  using Point = typename boost::property_traits<Points>::value_type;
  /// CGAL copies the visitor.
  struct Shared {
    Cell_map::Cell current = 0;
    std::vector<Point> at_vertices;  // up to two different ones
  };

  [[nodiscard]] int side(const Blend_mesh& mesh) const { return &mesh == operands_[0] ? 0 : 1; }

  void note(const Point* vertex) {
    record_->contact = true;
    bool& spread = record_->spread;
    auto& known = shared_->at_vertices;
    if (spread) return;
    if (!vertex)
      spread = true;
    else if (known.size() == 2)
      spread = !CGAL::collinear(known[0], known[1], *vertex);
    else if (known.empty() || known[0] != *vertex)
      known.push_back(*vertex);
  }

  std::array<const Blend_mesh*, 2> operands_;
  std::array<Points, 2> points_;
  Corefinement_record* record_;
  std::shared_ptr<Shared> shared_;
};

/// Runs the boolean of `corefine` on the points of the maps.
template <class Points>
bool corefine_points(const std::array<Blend_mesh*, 2>& operands, const std::array<Points, 2>& points,
                     Boolean_operation operation, Blend_mesh& out, Points out_points, Edge_marks marks,
                     Corefinement_record& record) {
  namespace PMP = CGAL::Polygon_mesh_processing;
  const Corefinement_visitor<Points> visitor({operands[0], operands[1]}, points, record);
  const auto first = CGAL::parameters::vertex_point_map(points[0]).visitor(visitor).throw_on_self_intersection(true);
  const auto second = CGAL::parameters::vertex_point_map(points[1]);
  const auto result = CGAL::parameters::vertex_point_map(out_points).edge_is_constrained_map(marks);
  Blend_mesh &a = *operands[0], &b = *operands[1];
  switch (operation) {
    case Boolean_operation::union_: return PMP::corefine_and_compute_union(a, b, out, first, second, result);
    case Boolean_operation::intersection:
      return PMP::corefine_and_compute_intersection(a, b, out, first, second, result);
    case Boolean_operation::difference: return PMP::corefine_and_compute_difference(a, b, out, first, second, result);
  }
  return false;
}

}  // namespace cgal_blend

#endif
