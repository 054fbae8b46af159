// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_SURFACE_PATH_H
#define CGAL_BLEND_SRC_SURFACE_PATH_H

#include "base_surface.h"

#include <array>
#include <cstddef>
#include <optional>
#include <unordered_set>
#include <vector>

namespace cgal_blend {

/// A vertex of a polyline on a mesh: on a vertex, on an edge, or inside a face of it.
struct Station {
  enum class Kind { vertex, edge, face };
  Kind kind;
  Face face;      ///< kind face: the face; else one of those it lies on
  Halfedge edge;  ///< kind edge: the smaller halfedge of the edge
  Vertex vertex;  ///< kind vertex
  Vec point;
};

/// A polyline on a mesh, each step within one closed face.
struct Surface_path {
  bool closed = true;
  std::vector<Station> stations;
  std::vector<std::size_t> station_of;  ///< for each given point its station; non-decreasing
};

/// Joins points of a surface to a closed polyline on it: between consecutive points along the plane section through
/// both that contains the mean normal. Stations nearer than `snap` to a vertex or an edge are moved onto it, so that
/// no sliver is cut off. Returns nothing where a section does not arrive, with the index of the point not reached in `stuck`.
/// \param cross_creases sharp edges are no barrier
[[nodiscard]] std::optional<Surface_path> closed_path(const Base_surface& surface,
                                                      const std::vector<Surface_point>& points, double snap,
                                                      std::size_t& stuck, bool cross_creases = false);

/// What an open path may do.
struct Path_rules {
  double snap = 0;             ///< as for closed paths
  bool cross_creases = false;  ///< sharp edges are no barrier
  Vec ruling = Vec::Zero();  ///< sections are taken along it where that joins the points, instead of along the normals
  const std::unordered_set<Face>* within = nullptr;  ///< faces that the path stays in; null: all
  std::array<double, 2> shared_ends{};  ///< so near to first and last point nothing is moved onto vertices: other paths
                                        ///< come to that point too, and could be moved onto the same
};

/// Joins points to an open polyline. Its first and last points may be given as stations, on a vertex or an edge.
[[nodiscard]] std::optional<Surface_path> open_path(const Base_surface& surface, const std::vector<Station>& points,
                                                    const Path_rules& rules, std::size_t& stuck);

/// Where the section from a point of the surface to one of its extension (`Base_surface::extend`) leaves the mesh.
[[nodiscard]] std::optional<Station> leaving_station(const Base_surface& surface, const Surface_point& inside,
                                                     const Vec& outside, double snap);

/// A point of a surface as a station on a sharp edge of its face, or on an end of one, if one is nearer than `snap`.
[[nodiscard]] std::optional<Station> border_station_at(const Base_surface& surface, const Surface_point& at,
                                                       double snap);

/// A point of a surface as a station, on a vertex or an edge if one is nearer than `snap`.
[[nodiscard]] Station station_at(const Base_surface& surface, const Surface_point& at, double snap);
[[nodiscard]] Station station_at(const Base_surface& surface, Face face, Vertex vertex);

}  // namespace cgal_blend

#endif
