// SPDX-License-Identifier: GPL-3.0-or-later
#include "cell_triangulation.h"

#include "marked_triangulation.h"

#include <map>

namespace cgal_blend {

namespace {

using Triangulation = Marked_triangulation<Vertex, Kernel>;
using Step = std::pair<Vertex, Vertex>;

/// Projects along the largest component of the normal: coordinates stay as they are, so predicates stay exact.
class Projection {
 public:
  explicit Projection(const Vec& normal) {
    int axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    first_ = (axis + 1) % 3;
    second_ = (axis + 2) % 3;
    if (normal[axis] < 0) std::swap(first_, second_);
  }
  [[nodiscard]] Kernel::Point_2 operator()(const Point_3& p) const { return {p[first_], p[second_]}; }

 private:
  int first_, second_;
};

class Cell_builder {
 public:
  Cell_builder(const Blend_mesh& mesh, const Vec& normal) : mesh_(mesh), project_(normal) {}

  /// False if two vertices fall together or two constraints cross; then `conflict` is set.
  bool constrain(const Step& step) {
    Triangulation::Vertex_handle a, b;
    if (!insert(step.first, a) || !insert(step.second, b)) return false;
    try {
      if (a != b) triangulation_.insert_constraint(a, b);
    } catch (const Triangulation::Intersection_of_constraints_exception&) {
      conflict = mesh_.point(step.first);
      return false;
    }
    return true;
  }

  bool insert(Vertex v, Triangulation::Vertex_handle& handle) {
    const auto found = handles_.find(v);
    if (found != handles_.end()) {
      handle = found->second;
      return true;
    }
    const std::size_t before = triangulation_.number_of_vertices();
    try {
      handle = triangulation_.insert(project_(mesh_.point(v)));
    } catch (const Triangulation::Intersection_of_constraints_exception&) {
      conflict = mesh_.point(v);
      return false;
    }
    if (triangulation_.number_of_vertices() == before) {
      conflict = mesh_.point(v);
      return false;
    }
    handle->info() = v;
    handles_.emplace(v, handle);
    return true;
  }

  /// Marks the faces left of a segment.
  bool seed(const Step& step) {
    Triangulation::Face_handle face;
    int index = 0;
    const auto a = handles_.at(step.first), b = handles_.at(step.second);
    if (!triangulation_.is_edge(a, b, face, index)) {
      conflict = mesh_.point(step.first);
      return false;
    }
    // The face with the edge directed from a to b lies to its left.
    if (face->vertex(Triangulation::ccw(index)) != a) face = face->neighbor(index);
    return mark(face);
  }

  bool flood() {
    while (!stack_.empty()) {
      const Triangulation::Face_handle face = stack_.back();
      stack_.pop_back();
      for (int i = 0; i < 3; ++i)
        if (!face->is_constrained(i) && !mark(face->neighbor(i))) return false;
    }
    return true;
  }

  /// The part right of a segment must not be reached.
  bool separated(const Step& step) {
    Triangulation::Face_handle face;
    int index = 0;
    const auto a = handles_.at(step.first), b = handles_.at(step.second);
    if (!triangulation_.is_edge(a, b, face, index)) return false;
    if (face->vertex(Triangulation::ccw(index)) == a) face = face->neighbor(index);
    if (triangulation_.is_infinite(face) || !face->info()) return true;
    conflict = mesh_.point(step.first);
    return false;
  }

  void clear_marks() {
    for (const auto face : triangulation_.all_face_handles()) face->info() = false;
  }

  [[nodiscard]] std::vector<std::array<Vertex, 3>> marked() const {
    std::vector<std::array<Vertex, 3>> triangles;
    for (const auto face : triangulation_.finite_face_handles())
      if (face->info())
        triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    return triangles;
  }

  std::optional<Point_3> conflict;

 private:
  bool mark(Triangulation::Face_handle face) {
    if (triangulation_.is_infinite(face)) {
      const auto v = face->vertex(triangulation_.is_infinite(face->vertex(0)) ? 1 : 0);
      conflict = mesh_.point(v->info());
      return false;
    }
    if (!face->info()) {
      face->info() = true;
      stack_.push_back(face);
    }
    return true;
  }

  const Blend_mesh& mesh_;
  Projection project_;
  Triangulation triangulation_;
  std::map<Vertex, Triangulation::Vertex_handle> handles_;
  std::vector<Triangulation::Face_handle> stack_;
};

bool build(Cell_builder& builder, const std::vector<Step>& border, const std::vector<Step>& segments,
           const std::set<Vertex>& inner) {
  std::set<Step> border_steps(border.begin(), border.end());
  for (const Step& step : border)
    if (!builder.constrain(step)) return false;
  for (const Step& step : segments)
    if (!builder.constrain(step)) return false;
  for (const Vertex v : inner) {
    Triangulation::Vertex_handle ignored;
    if (!builder.insert(v, ignored)) return false;
  }
  builder.clear_marks();
  // A segment that runs along the border against its direction keeps what is beyond, not this cell.
  const auto outside = [&](const Step& step) { return border_steps.count({step.second, step.first}) > 0; };
  for (const Step& step : segments)
    if (!outside(step) && !builder.seed(step)) return false;
  if (!builder.flood()) return false;
  for (const Step& step : segments)
    if (!border_steps.count(step) && !builder.separated(step)) return false;
  return true;
}

}  // namespace

Cell_triangulation triangulate_cell(const Blend_mesh& mesh, const Vec& normal, const std::vector<Step>& border,
                                    const std::vector<Step>& segments, const std::set<Vertex>& inner) {
  Cell_builder builder(mesh, normal);
  Cell_triangulation result;
  if (build(builder, border, segments, inner))
    result.triangles = builder.marked();
  else
    result.conflict =
        builder.conflict.value_or(mesh.point(border.empty() ? segments.front().first : border.front().first));
  return result;
}

}  // namespace cgal_blend
