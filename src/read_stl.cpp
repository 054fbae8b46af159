// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_formats.h"

#include <cstring>
#include <unordered_map>

namespace cgal_blend::internal {

namespace {

constexpr std::size_t header_size = 84;  // 80 bytes of anything, then the number of facets
constexpr std::size_t facet_size = 50;   // normal, three corners, two bytes of anything

struct Position_hash {
  std::size_t operator()(const std::array<double, 3>& p) const {
    std::uint64_t hash = 0;
    for (const double x : p) {
      std::uint64_t bits;
      std::memcpy(&bits, &x, sizeof bits);
      hash = (hash ^ bits) * 0x9E3779B97F4A7C15u;
      hash ^= hash >> 29;
    }
    return hash;
  }
};

/// Collects facets corner by corner, giving equal positions one vertex, in the order in which they first appear.
class Merger {
 public:
  explicit Merger(std::size_t facets) { vertices_.reserve(facets / 2 + 8); }

  void add_corner(double x, double y, double z) {
    // Adding zero turns -0 into 0, which is the same position.
    const auto [place, is_new] = vertices_.try_emplace({x + 0.0, y + 0.0, z + 0.0}, soup_.points.size());
    if (is_new) soup_.points.emplace_back(x, y, z);
    facet_[corners_++] = static_cast<std::uint32_t>(place->second);
  }

  void end_facet() {
    const auto [a, b, c] = facet_;
    corners_ = 0;
    if (a == b || b == c || c == a) return;  // its neighbours meet without it
    soup_.corners.insert(soup_.corners.end(), {a, b, c});
    soup_.end_polygon();
  }

  [[nodiscard]] std::size_t corners() const { return corners_; }
  Polygon_soup take() { return std::move(soup_); }

 private:
  Polygon_soup soup_;
  std::unordered_map<std::array<double, 3>, std::size_t, Position_hash> vertices_;
  std::array<std::uint32_t, 3> facet_{};
  std::size_t corners_ = 0;
};

std::uint32_t little_endian(const char* bytes) {
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

double load_float(const char* bytes) {
  const std::uint32_t bits = little_endian(bytes);
  float value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

std::size_t binary_facets(std::string_view bytes) {
  return bytes.size() < header_size ? 0 : little_endian(bytes.data() + 80);
}

Polygon_soup read_binary(std::string_view bytes) {
  const std::size_t facets = binary_facets(bytes);
  if (bytes.size() < header_size || (bytes.size() - header_size) / facet_size < facets)
    throw Malformed_file("the file ends too early");
  Merger merger(facets);
  for (std::size_t f = 0; f < facets; ++f) {
    const char* corner = bytes.data() + header_size + f * facet_size + 12;
    for (int i = 0; i < 3; ++i, corner += 12)
      merger.add_corner(load_float(corner), load_float(corner + 4), load_float(corner + 8));
    merger.end_facet();
  }
  return merger.take();
}

/// Any number of solids; all that matters are the words "vertex" and "endfacet".
Polygon_soup read_ascii(std::string_view text) {
  Text_cursor in(text);
  Merger merger(text.size() / 200);
  bool in_solid = false;
  while (!in.at_end()) {
    const std::string_view word = in.token();
    if (word == "solid" || word == "endsolid") {
      in_solid = word == "solid";
      in.skip_line();  // a name
    } else if (word == "vertex") {
      if (merger.corners() == 3) in.fail("a facet has more than three corners");
      const Point_3 p = in.point();
      merger.add_corner(p.x(), p.y(), p.z());
    } else if (word == "endfacet") {
      if (merger.corners() != 3) in.fail("a facet has less than three corners");
      merger.end_facet();
    } else if (word == "facet") {
      in.skip_line();  // its normal, which follows from the corners
    }
  }
  if (in_solid || merger.corners() != 0) in.fail("the file ends too early");
  return merger.take();
}

bool begins_with_solid(std::string_view bytes) {
  const std::size_t at = bytes.find_first_not_of(" \t\r\n");
  return at != std::string_view::npos && bytes.substr(at, 5) == "solid";
}

}  // namespace

Polygon_soup read_stl(std::string_view bytes) {
  // Binary files may begin with "solid" too; their length then gives them away.
  const bool length_fits =
      bytes.size() >= header_size && bytes.size() == header_size + facet_size * binary_facets(bytes);
  return length_fits || !begins_with_solid(bytes) ? read_binary(bytes) : read_ascii(bytes);
}

}  // namespace cgal_blend::internal
