// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_MESH_FORMATS_H
#define CGAL_BLEND_SRC_MESH_FORMATS_H

#include <cgal_blend/blend_mesh.h>

#include "triangle_topology.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

// Own readers rather than CGAL's (5.5.1): those take cut-off files and indices out of range for good in places, cannot
// tell a coordinate that is not finite from the end of the file, and need two to five times as long.

namespace cgal_blend::internal {

/// Polygons over shared points as a file holds them, nothing checked but that indices are in range.
struct Polygon_soup {
  std::vector<Point_3> points;
  std::vector<std::uint32_t> corners;      ///< vertex indices of all polygons, one after another
  std::vector<std::uint32_t> polygon_end;  ///< per polygon: where it ends in `corners`

  void end_polygon() { polygon_end.push_back(static_cast<std::uint32_t>(corners.size())); }
};

/// Thrown by the readers for text or bytes that are not what the format asks for.
struct Malformed_file : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Walks over text token by token. Knows its line for error messages, and '#' comments.
class Text_cursor {
 public:
  explicit Text_cursor(std::string_view text, std::size_t first_line = 1)
      : position_(text.data()), end_(text.data() + text.size()), line_(first_line) {}

  /// Next token, over line ends; throws at the end of the text.
  std::string_view token();
  /// Next token of the current line; empty at its end. A backslash at the end of a line continues it.
  std::string_view token_on_line();
  void skip_line();
  [[nodiscard]] bool at_end();

  double number() { return to_number(token()); }
  Point_3 point();
  std::size_t count();
  /// A vertex index below `size`.
  std::uint32_t index(std::size_t size);

  double to_number(std::string_view token) const;
  long long to_integer(std::string_view token) const;
  [[noreturn]] void fail(const std::string& what) const;

 private:
  void skip_blanks(bool over_lines);
  std::string_view take();

  const char* position_;
  const char* end_;
  std::size_t line_;
};

[[nodiscard]] Polygon_soup read_off(std::string_view text);
[[nodiscard]] Polygon_soup read_obj(std::string_view text);
[[nodiscard]] Polygon_soup read_ply(std::string_view bytes);
/// Merges corners at equal positions; facets that shrink to a segment or a point by that are dropped.
[[nodiscard]] Polygon_soup read_stl(std::string_view bytes);

/// Splits a polygon into triangles without folding it where that is possible; appends vertex indices three by three.
void triangulate_polygon(const std::vector<Point_3>& points, const std::uint32_t* polygon, std::size_t size,
                         std::vector<std::uint32_t>& triangles);

/// Builds the mesh that `topology` (manifold) describes; vertex, face and corner indices stay what they are.
[[nodiscard]] Blend_mesh assemble(const std::vector<Point_3>& points, const std::vector<Triangle>& triangles,
                                  const Triangle_topology& topology);

/// Vertices (removed ones skipped) and triangles of a mesh in the order of their indices.
struct Indexed_mesh {
  std::vector<Point_3> points;
  std::vector<Triangle> triangles;
};

[[nodiscard]] std::string write_off(const Indexed_mesh& mesh);
[[nodiscard]] std::string write_obj(const Indexed_mesh& mesh);
[[nodiscard]] std::string write_ply(const Indexed_mesh& mesh);
[[nodiscard]] std::string write_stl(const Indexed_mesh& mesh);
/// PLY with a colour and a curvature for each vertex.
[[nodiscard]] std::string write_curvature_ply(const Indexed_mesh& mesh, const std::vector<double>& curvatures,
                                              const std::vector<std::array<unsigned char, 3>>& colours);

}  // namespace cgal_blend::internal

#endif
