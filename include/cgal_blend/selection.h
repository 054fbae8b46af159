// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SELECTION_H
#define CGAL_BLEND_SELECTION_H

#include <cgal_blend/mesh_io.h>

#include <array>
#include <cstddef>
#include <fstream>
#include <istream>
#include <sstream>
#include <string>
#include <vector>

namespace cgal_blend {

/// Parts of a mesh by number, as CGAL's polyhedron demo saves them (`*.selection.txt`).
struct Selection {
  std::vector<std::size_t> vertices;
  std::vector<std::size_t> faces;
  std::vector<std::array<std::size_t, 2>> edges;  ///< the two vertices of each edge
};

namespace internal {

inline std::vector<std::size_t> parse_numbers(const std::string& line, const std::string& what) {
  std::istringstream words(line);
  std::vector<std::size_t> numbers;
  for (std::string word; words >> word;) {
    const bool digits = word.size() <= 18 && word.find_first_not_of("0123456789") == std::string::npos;
    if (!digits) throw Mesh_io_error(Mesh_io_error::Kind::unreadable, what + ": '" + word + "' is not an index");
    numbers.push_back(std::stoull(word));
  }
  return numbers;
}

}  // namespace internal

/// Reads a selection: indices of vertices on line 1, of faces on line 2, pairs of vertex indices of edges from line 3
/// on. Trailing lines may be missing. Whether the indices exist in a mesh is not checked here.
/// Throws `Mesh_io_error` (unreadable) if a word is no index or an edge has only one vertex.
[[nodiscard]] inline Selection read_selection(std::istream& in, const std::string& file_name = "selection") {
  Selection selection;
  std::string line;
  if (std::getline(in, line)) selection.vertices = internal::parse_numbers(line, file_name + ", line 1");
  if (std::getline(in, line)) selection.faces = internal::parse_numbers(line, file_name + ", line 2");
  for (std::size_t number = 3; std::getline(in, line); ++number) {
    const std::string where = file_name + ", line " + std::to_string(number);
    const std::vector<std::size_t> ends = internal::parse_numbers(line, where);
    if (ends.size() % 2 != 0)
      throw Mesh_io_error(Mesh_io_error::Kind::unreadable, where + ": the last edge has only one vertex");
    for (std::size_t i = 0; i < ends.size(); i += 2) selection.edges.push_back({ends[i], ends[i + 1]});
  }
  return selection;
}

/// Reads a selection file; throws `Mesh_io_error` (unreadable) also if there is none.
[[nodiscard]] inline Selection read_selection(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw Mesh_io_error(Mesh_io_error::Kind::unreadable, "cannot read \"" + path + "\": it cannot be opened");
  return read_selection(in, "\"" + path + "\"");
}

}  // namespace cgal_blend

#endif
