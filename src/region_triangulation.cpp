// SPDX-License-Identifier: GPL-3.0-or-later
#include "region_triangulation.h"

#include "marked_triangulation.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace cgal_blend {

namespace {

using Triangulation = Marked_triangulation<std::size_t, Kernel>;
using Vertex_handle = Triangulation::Vertex_handle;
using Face_handle = Triangulation::Face_handle;
using Point_2 = Kernel::Point_2;

constexpr int most_sweeps = 60;
constexpr std::size_t most_vertices = 400000;
constexpr double largest_ratio = 2;  // square of circumradius over shortest edge

bool is_finite(const Point_2& p) { return std::isfinite(p.x()) && std::isfinite(p.y()); }

}  // namespace

struct Region_triangulation::Impl {
  Triangulation cdt;
  std::vector<std::vector<Vertex_handle>> polygons;

  bool insert(const Point_2& p, std::size_t id, Vertex_handle& v) {
    const std::size_t before = cdt.number_of_vertices();
    v = cdt.insert(p);
    if (cdt.number_of_vertices() == before) return false;
    v->info() = id;
    return true;
  }

  /// The face on the left of a polygon's edge, and its mirror.
  [[nodiscard]] std::pair<Face_handle, Face_handle> sides_of(Vertex_handle a, Vertex_handle b) const {
    Face_handle face;
    int index = 0;
    if (!cdt.is_edge(a, b, face, index)) return {};
    const Face_handle other = face->neighbor(index);
    return face->vertex(Triangulation::ccw(index)) == a ? std::pair(face, other) : std::pair(other, face);
  }

  void flood(Face_handle start) {
    std::vector<Face_handle> stack{start};
    start->info() = true;
    while (!stack.empty()) {
      const Face_handle face = stack.back();
      stack.pop_back();
      for (int i = 0; i < 3; ++i)
        if (const Face_handle next = face->neighbor(i); !face->is_constrained(i) && !next->info()) {
          next->info() = true;
          stack.push_back(next);
        }
    }
  }

  bool try_insert(const Point_2& p, const std::function<std::size_t(const Point_2&)>& add);
  [[nodiscard]] Point_2 middle_of_longest(Face_handle face) const;
};

/// Inserts a point unless it is outside the region, on another one, or too near to a polygon.
bool Region_triangulation::Impl::try_insert(const Point_2& p, const std::function<std::size_t(const Point_2&)>& add) {
  if (!is_finite(p)) return false;
  Triangulation::Locate_type where = Triangulation::OUTSIDE_AFFINE_HULL;
  int index = 0;
  const Face_handle face = cdt.locate(p, where, index);
  if (where != Triangulation::FACE && where != Triangulation::EDGE) return false;
  if (!face->info() || (where == Triangulation::EDGE && face->is_constrained(index))) return false;
  std::vector<Triangulation::Edge> border;
  cdt.get_boundary_of_conflicts(p, std::back_inserter(border), face);
  for (const auto& [f, i] : border) {
    if (!f->is_constrained(i)) continue;
    const Point_2 &a = f->vertex(Triangulation::ccw(i))->point(), &b = f->vertex(Triangulation::cw(i))->point();
    if (CGAL::angle(a, p, b) != CGAL::ACUTE) return false;
  }
  const Vertex_handle v = cdt.insert(p, where, face, index);
  v->info() = add(p);
  // Conflicts stop at constraints, so all of the new faces are where the old ones were.
  Triangulation::Face_circulator around = cdt.incident_faces(v), start = around;
  do around->info() = true;
  while (++around != start);
  return true;
}

Point_2 Region_triangulation::Impl::middle_of_longest(Face_handle face) const {
  double longest = -1;
  Point_2 middle;
  for (int i = 0; i < 3; ++i) {
    if (face->is_constrained(i)) continue;
    const Point_2 &a = face->vertex(Triangulation::ccw(i))->point(), &b = face->vertex(Triangulation::cw(i))->point();
    const double length = CGAL::squared_distance(a, b);
    if (length <= longest) continue;
    longest = length;
    middle = CGAL::midpoint(a, b);
  }
  return middle;
}

Region_triangulation::Region_triangulation() : impl_(std::make_unique<Impl>()) {}
Region_triangulation::~Region_triangulation() = default;

bool Region_triangulation::add_polygon(const std::vector<Point_2>& points, const std::vector<std::size_t>& ids) {
  std::vector<Vertex_handle> handles(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!is_finite(points[i]) || !impl_->insert(points[i], ids[i], handles[i])) return false;
  try {
    for (std::size_t i = 0; i < handles.size(); ++i)
      impl_->cdt.insert_constraint(handles[i], handles[(i + 1) % handles.size()]);
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    return false;
  }
  for (std::size_t i = 0; i < handles.size(); ++i)  // a constraint through a vertex is split silently
    if (!impl_->cdt.is_edge(handles[i], handles[(i + 1) % handles.size()])) return false;
  impl_->polygons.push_back(std::move(handles));
  return true;
}

bool Region_triangulation::add_point(const Point_2& point, std::size_t id) {
  Vertex_handle v;
  return impl_->insert(point, id, v);
}

void Region_triangulation::mark(std::size_t index, bool right) {
  const auto& polygon = impl_->polygons[index];
  for (const Face_handle face : impl_->cdt.all_face_handles())
    if (impl_->polygons.size() > 0 && index == 0) face->info() = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto [on_left, on_right] = impl_->sides_of(polygon[i], polygon[(i + 1) % polygon.size()]);
    const Face_handle start = right ? on_right : on_left;
    if (start != Face_handle() && !start->info()) impl_->flood(start);
  }
}

bool Region_triangulation::is_bounded() const { return !impl_->cdt.infinite_face()->info(); }

bool Region_triangulation::contains(const Point_2& point) const {
  const Face_handle face = impl_->cdt.locate(point);
  return face != Face_handle() && !impl_->cdt.is_infinite(face) && face->info();
}

bool Region_triangulation::ends_at(std::size_t index) const {
  const auto& polygon = impl_->polygons[index];
  const auto [on_left, on_right] = impl_->sides_of(polygon[0], polygon[1]);
  return on_left != Face_handle() && on_left->info() != on_right->info();
}

void Region_triangulation::refine(const std::function<bool(const Triangle&)>& is_bad,
                                  const std::function<std::size_t(const Point_2&)>& add) {
  struct Candidate {
    std::array<Vertex_handle, 3> corners;
    bool is_bad;
  };
  const auto has_bad_shape = [](const Point_2& a, const Point_2& b, const Point_2& c) {
    const double shortest =
        std::min({CGAL::squared_distance(a, b), CGAL::squared_distance(b, c), CGAL::squared_distance(c, a)});
    return CGAL::squared_radius(a, b, c) > largest_ratio * shortest;
  };
  for (int sweep = 0; sweep < most_sweeps && impl_->cdt.number_of_vertices() < most_vertices; ++sweep) {
    std::vector<Candidate> candidates;
    for (const Face_handle face : impl_->cdt.finite_face_handles()) {
      if (!face->info()) continue;
      const std::array<Vertex_handle, 3> v{face->vertex(0), face->vertex(1), face->vertex(2)};
      const bool bad = is_bad({v[0]->info(), v[1]->info(), v[2]->info()});
      if (bad || has_bad_shape(v[0]->point(), v[1]->point(), v[2]->point())) candidates.push_back({v, bad});
    }
    bool changed = false;
    for (const auto& [v, bad] : candidates) {
      Face_handle face;
      if (!impl_->cdt.is_face(v[0], v[1], v[2], face)) continue;  // gone already
      const Point_2 centre = CGAL::circumcenter(v[0]->point(), v[1]->point(), v[2]->point());
      changed =
          impl_->try_insert(centre, add) || (bad && impl_->try_insert(impl_->middle_of_longest(face), add)) || changed;
    }
    if (!changed) return;
  }
}

std::vector<Region_triangulation::Triangle> Region_triangulation::triangles() const {
  std::vector<Triangle> result;
  for (const Face_handle face : impl_->cdt.finite_face_handles())
    if (face->info()) result.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  return result;
}

}  // namespace cgal_blend
