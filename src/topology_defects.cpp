// SPDX-License-Identifier: GPL-3.0-or-later
#include "topology_defects.h"

#include <string>

namespace cgal_blend::internal {

namespace {

std::string text(std::uint32_t i) { return std::to_string(i); }

Diagnosis diagnosis(Status status, std::string detail, const Point_3& point) {
  Diagnosis d;
  d.status = status;
  d.detail = std::move(detail);
  d.point = point;
  return d;
}

Diagnosis edge_defect(std::uint32_t corner, const std::vector<Triangle>& triangles, const Point_of_vertex& point,
                      Status status, const std::string& what) {
  const std::uint32_t next = next_corner(corner);
  const std::uint32_t u = triangles[corner / 3][corner % 3], v = triangles[next / 3][next % 3];
  return diagnosis(status, "edge between vertices " + text(u) + " and " + text(v) + what,
                   CGAL::midpoint(point(u), point(v)));
}

}  // namespace

Diagnosis manifold_defect(const Triangle_topology& t, const std::vector<Triangle>& triangles,
                          const Point_of_vertex& point) {
  if (t.repeated_corner) {
    const Triangle& v = triangles[*t.repeated_corner];
    const std::uint32_t twice = v[0] == v[1] || v[0] == v[2] ? v[0] : v[1];
    return diagnosis(Status::input_degenerate, "a face has vertex " + text(twice) + " twice", point(twice));
  }
  if (t.crowded_edge)
    return edge_defect(*t.crowded_edge, triangles, point, Status::input_not_manifold, " has more than two faces");
  if (t.misoriented_edge)
    return edge_defect(*t.misoriented_edge, triangles, point, Status::input_misoriented,
                       " lies between faces that point to opposite sides");
  if (t.crowded_vertex)
    return diagnosis(Status::input_not_manifold, "separate sheets meet in vertex " + text(*t.crowded_vertex),
                     point(*t.crowded_vertex));
  return {};
}

Diagnosis closedness_defect(const Triangle_topology& t, const std::vector<Triangle>& triangles,
                            const Point_of_vertex& point) {
  if (!t.border_edge) return {};
  return edge_defect(*t.border_edge, triangles, point, Status::input_not_closed, " has a face on one side only");
}

}  // namespace cgal_blend::internal
