// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_formats.h"

#include <algorithm>

namespace cgal_blend::internal {

namespace {

/// Reads "OFF" with any of the prefixes for data per vertex that follow the coordinates, and are skipped.
void read_off_keyword(Text_cursor& in) {
  const std::string_view keyword = in.token();
  const std::size_t off = keyword.size() < 3 ? 0 : keyword.size() - 3;
  if (keyword.substr(off) != "OFF") in.fail("an OFF file begins with the word OFF");
  for (const char c : keyword.substr(0, off))
    if (c != 'S' && c != 'T' && c != 'C' && c != 'N') in.fail("only OFF files of three dimensions can be read");
}

}  // namespace

Polygon_soup read_off(std::string_view text) {
  Text_cursor in(text);
  read_off_keyword(in);
  const std::size_t vertices = in.count();
  const std::size_t faces = in.count();
  in.skip_line();
  // A vertex takes six characters at least and a face two: no memory for counts that the file cannot hold.
  if (vertices > text.size() / 6 + 1 || faces > text.size() / 2)
    in.fail("the file is too short for the counts in its head");

  Polygon_soup soup;
  soup.points.reserve(vertices);
  soup.corners.reserve(3 * faces);
  soup.polygon_end.reserve(faces);
  for (std::size_t i = 0; i < vertices; ++i) {
    soup.points.push_back(in.point());
    in.skip_line();
  }
  for (std::size_t i = 0; i < faces; ++i) {
    const std::size_t size = in.count();
    if (size < 3) in.fail("a face has less than three corners");
    for (std::size_t k = 0; k < size; ++k) soup.corners.push_back(in.index(vertices));
    soup.end_polygon();
    in.skip_line();
  }
  return soup;
}

namespace {

/// One-based, or counted back from the latest vertex if negative; what follows a slash is texture and normal.
std::uint32_t obj_index(const Text_cursor& in, std::string_view token, std::size_t vertices) {
  const long long value = in.to_integer(token.substr(0, token.find('/')));
  const long long index = value > 0 ? value - 1 : static_cast<long long>(vertices) + value;
  if (value == 0 || index < 0 || index >= 0xffffffffLL)
    in.fail("a face names vertex " + std::to_string(value) + ", which does not exist");
  return static_cast<std::uint32_t>(index);
}

}  // namespace

Polygon_soup read_obj(std::string_view text) {
  Text_cursor in(text);
  Polygon_soup soup;
  while (!in.at_end()) {
    const std::string_view keyword = in.token();
    if (keyword == "v") {
      double xyz[3];
      for (double& x : xyz) x = in.to_number(in.token_on_line());
      soup.points.emplace_back(xyz[0], xyz[1], xyz[2]);
    } else if (keyword == "f") {
      const std::size_t begin = soup.corners.size();
      for (std::string_view t = in.token_on_line(); !t.empty(); t = in.token_on_line())
        soup.corners.push_back(obj_index(in, t, soup.points.size()));
      if (soup.corners.size() < begin + 3) in.fail("a face has less than three corners");
      soup.end_polygon();
    }
    in.skip_line();
  }
  // Faces may come before their vertices, hence the check at the end.
  if (!soup.corners.empty()) {
    const std::uint32_t largest = *std::max_element(soup.corners.begin(), soup.corners.end());
    if (largest >= soup.points.size())
      in.fail("a face names vertex " + std::to_string(largest + 1) + " of " + std::to_string(soup.points.size()) +
              " vertices");
  }
  return soup;
}

}  // namespace cgal_blend::internal
