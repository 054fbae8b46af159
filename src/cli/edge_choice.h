// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_CLI_EDGE_CHOICE_H
#define CGAL_BLEND_CLI_EDGE_CHOICE_H

#include <cgal_blend/fillet.h>

#include <optional>
#include <string>
#include <vector>

namespace cgal_blend::cli {

/// The ways to say which edges to blend; exactly one is given.
struct Edge_choice {
  std::optional<double> sharp_angle;  ///< least deviation of the face normals, degrees
  std::string edges_file;             ///< CGAL selection text
  std::string blends_file;            ///< JSON
  double from = 0, to = 1;            ///< fractions of each curve between which it is blended

  /// Throws `Failure` (usage) unless exactly one way is given.
  void require_one() const;
};

/// One entry of a blends file. One of `vertices` and `points` is filled.
struct Blend_request {
  std::vector<std::size_t> vertices;
  std::vector<Point_3> points;
  std::optional<Radius_law> radius{};  ///< none: the radius of the command line
  std::optional<Profile> profile{};    ///< none: the profile of the command line
  std::optional<double> from{}, to{};  ///< fractions along the polyline; none: those of the command line
};

/// Reads a blends file; throws `Failure`: input if it is no such file, usage or blend for values not accepted.
[[nodiscard]] std::vector<Blend_request> read_blends(const std::string& path);

/// Finds the edges of the mesh; radius and fractions of a request run along its polyline. Throws `Failure` (no_such_edge, no_edges_selected).
[[nodiscard]] std::vector<Edge_blend> chosen_edges(const Edge_choice& choice,
                                                   const std::vector<Blend_request>& requests, const Blend_mesh& mesh);

}  // namespace cgal_blend::cli

#endif
