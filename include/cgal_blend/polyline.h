// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_POLYLINE_H
#define CGAL_BLEND_POLYLINE_H

#include <cgal_blend/internal/point_map.h>
#include <cgal_blend/status.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace cgal_blend {

/// How far a given point may lie from the vertex that it means, as a fraction of the mesh's largest coordinate: room
/// for single precision (STL) and for printed decimals, far below any distance between vertices that matters.
inline constexpr double position_match_fraction = 1e-6;

/// The edges along a polyline, or why there are none.
template <class Graph>
struct Edge_chain {
  Diagnosis diagnosis;  ///< `ok`, `no_such_edge` or `no_edges_selected`
  std::vector<typename boost::graph_traits<Graph>::edge_descriptor> edges;

  [[nodiscard]] bool ok() const noexcept { return diagnosis.ok(); }
};

/// Finds the vertices of a mesh by position; build it once for many look-ups.
template <class Graph>
class Vertex_locator {
 public:
  using vertex_descriptor = typename boost::graph_traits<Graph>::vertex_descriptor;

  template <class NamedParameters = CGAL::parameters::Default_named_parameters>
  explicit Vertex_locator(const Graph& mesh, const NamedParameters& np = CGAL::parameters::default_values()) {
    const auto points = internal::point_map(mesh, np);
    for (vertex_descriptor v : vertices(mesh)) {
      const Diagnosis::Point p = internal::to_double_point(get(points, v));
      for (int i = 0; i < 3; ++i) tolerance_ = (std::max)(tolerance_, position_match_fraction * std::abs(p[i]));
      sites_.push_back({p, v});
    }
    // Stable: among vertices at one place the first in the mesh is found.
    std::stable_sort(sites_.begin(), sites_.end(), [](const Site& a, const Site& b) { return a.p.x() < b.p.x(); });
  }

  /// Returns the vertex at `p`, the nearest one within `tolerance()`, or nothing.
  [[nodiscard]] std::optional<vertex_descriptor> operator()(const Diagnosis::Point& p) const {
    const auto begin = std::lower_bound(sites_.begin(), sites_.end(), p.x() - tolerance_,
                                        [](const Site& s, double x) { return s.p.x() < x; });
    double best = tolerance_ * tolerance_;
    std::optional<vertex_descriptor> found;
    for (auto it = begin; it != sites_.end() && it->p.x() <= p.x() + tolerance_; ++it) {
      const double d = CGAL::squared_distance(it->p, p);
      if (d < best || (!found && d <= best)) {
        best = d;
        found = it->v;
      }
    }
    return found;
  }

  /// Returns the largest distance that still counts as a match, length units.
  [[nodiscard]] double tolerance() const noexcept { return tolerance_; }

 private:
  struct Site {
    Diagnosis::Point p;
    vertex_descriptor v;
  };
  std::vector<Site> sites_;
  double tolerance_ = 0;
};

/// Returns the edges along a chain of vertices, one per consecutive pair.
/// A pair that is no edge of the mesh gives `no_such_edge` with its place in the list.
template <class Graph, class NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] Edge_chain<Graph> edges_of_polyline(
    const Graph& mesh, const std::vector<typename boost::graph_traits<Graph>::vertex_descriptor>& polyline,
    const NamedParameters& np = CGAL::parameters::default_values()) {
  const auto points = internal::point_map(mesh, np);
  if (polyline.size() < 2) return {{Status::no_edges_selected, "a polyline needs two vertices or more", {}, {}}, {}};
  Edge_chain<Graph> chain;
  for (std::size_t i = 0; i + 1 < polyline.size(); ++i) {
    const auto [h, exists] = halfedge(polyline[i], polyline[i + 1], mesh);
    if (!exists)
      return {{Status::no_such_edge,
               "between places " + std::to_string(i) + " and " + std::to_string(i + 1) + " of the polyline",
               internal::to_double_point(get(points, polyline[i])),
               {}},
              {}};
    chain.edges.push_back(edge(h, mesh));
  }
  return chain;
}

/// Returns the edges along a chain of points, each of which must be the position of a vertex (`Vertex_locator`).
/// For formats in which vertices have no index, such as STL.
template <class Graph, class NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] Edge_chain<Graph> edges_of_polyline(const Graph& mesh, const std::vector<Diagnosis::Point>& polyline,
                                                  const Vertex_locator<Graph>& locate,
                                                  const NamedParameters& np = CGAL::parameters::default_values()) {
  std::vector<typename boost::graph_traits<Graph>::vertex_descriptor> found;
  for (const Diagnosis::Point& p : polyline) {
    const auto v = locate(p);
    if (!v)
      return {{Status::no_such_edge, "no vertex at point " + std::to_string(found.size()) + " of the polyline", p, {}},
              {}};
    found.push_back(*v);
  }
  return edges_of_polyline(mesh, found, np);
}

/// As above, for a single look-up.
template <class Graph>
[[nodiscard]] Edge_chain<Graph> edges_of_polyline(const Graph& mesh, const std::vector<Diagnosis::Point>& polyline) {
  return edges_of_polyline(mesh, polyline, Vertex_locator<Graph>(mesh));
}

}  // namespace cgal_blend

#endif
