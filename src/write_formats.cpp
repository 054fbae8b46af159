// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_formats.h"

#include <charconv>
#include <cstring>

namespace cgal_blend::internal {

namespace {

/// Appends the shortest decimal that reads back to the same double.
void append(std::string& out, double value) {
  char buffer[32];
  out.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
}

void append(std::string& out, std::size_t value) {
  char buffer[24];
  out.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
}

void append_point(std::string& out, const Point_3& p) {
  append(out, p.x());
  out += ' ';
  append(out, p.y());
  out += ' ';
  append(out, p.z());
  out += '\n';
}

/// Appends the bytes of a number, least significant first on any machine.
template <class T>
void append_bytes(std::string& out, T value) {
  unsigned char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof value);
  const std::uint16_t one = 1;
  unsigned char first;
  std::memcpy(&first, &one, 1);
  for (std::size_t i = 0; i < sizeof(T); ++i) out += static_cast<char>(bytes[first == 1 ? i : sizeof(T) - 1 - i]);
}

void append_triangles(std::string& out, const Indexed_mesh& mesh, const char* head, std::size_t first_index) {
  for (const auto& triangle : mesh.triangles) {
    out += head;
    for (const std::uint32_t v : triangle) {
      out += ' ';
      append(out, v + first_index);
    }
    out += '\n';
  }
}

/// Binary PLY; `append_more` appends the values of further vertex properties.
template <class Append_more>
std::string ply(const Indexed_mesh& mesh, const char* further_properties, const Append_more& append_more) {
  std::string out = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(mesh.points.size()) +
                    "\nproperty double x\nproperty double y\nproperty double z\n" + further_properties +
                    "element face " + std::to_string(mesh.triangles.size()) +
                    "\nproperty list uchar int vertex_indices\nend_header\n";
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    for (int i = 0; i < 3; ++i) append_bytes(out, mesh.points[v][i]);
    append_more(out, v);
  }
  for (const auto& triangle : mesh.triangles) {
    out += static_cast<char>(3);
    for (const std::uint32_t v : triangle) append_bytes(out, static_cast<std::int32_t>(v));
  }
  return out;
}

}  // namespace

std::string write_off(const Indexed_mesh& mesh) {
  std::string out = "OFF\n" + std::to_string(mesh.points.size()) + ' ' + std::to_string(mesh.triangles.size()) + " 0\n";
  for (const Point_3& p : mesh.points) append_point(out, p);
  append_triangles(out, mesh, "3", 0);
  return out;
}

std::string write_obj(const Indexed_mesh& mesh) {
  std::string out;
  for (const Point_3& p : mesh.points) {
    out += "v ";
    append_point(out, p);
  }
  append_triangles(out, mesh, "f", 1);
  return out;
}

std::string write_ply(const Indexed_mesh& mesh) {
  return ply(mesh, "", [](std::string&, std::size_t) {});
}

std::string write_curvature_ply(const Indexed_mesh& mesh, const std::vector<double>& curvatures,
                                const std::vector<std::array<unsigned char, 3>>& colours) {
  const char* properties =
      "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty double mean_curvature\n";
  return ply(mesh, properties, [&](std::string& out, std::size_t vertex) {
    for (const unsigned char channel : colours[vertex]) append_bytes(out, channel);
    append_bytes(out, curvatures[vertex]);
  });
}

std::string write_stl(const Indexed_mesh& mesh) {
  std::string out = "binary STL, units as in the source";
  out.resize(80, ' ');
  append_bytes(out, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& triangle : mesh.triangles) {
    const Point_3 &p = mesh.points[triangle[0]], &q = mesh.points[triangle[1]], &r = mesh.points[triangle[2]];
    Vector_3 normal = CGAL::cross_product(q - p, r - p);
    const double length = std::sqrt(normal.squared_length());
    if (length > 0) normal = normal / length;
    for (int i = 0; i < 3; ++i) append_bytes(out, static_cast<float>(normal[i]));
    for (const Point_3* corner : {&p, &q, &r})
      for (int i = 0; i < 3; ++i) append_bytes(out, static_cast<float>((*corner)[i]));
    append_bytes(out, std::uint16_t{0});
  }
  return out;
}

}  // namespace cgal_blend::internal
