// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/mesh_io.h>
#include <cgal_blend/validate.h>

#include "mesh_formats.h"
#include "topology_defects.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

namespace cgal_blend {

namespace {

namespace fs = std::filesystem;
using internal::Indexed_mesh;
using internal::Polygon_soup;
using internal::Triangle;
using internal::Triangle_topology;
using Kind = Mesh_io_error::Kind;

struct Format {
  const char* extension;
  Polygon_soup (*read)(std::string_view);
  std::string (*write)(const Indexed_mesh&);
};

constexpr Format formats[] = {{".off", internal::read_off, internal::write_off},
                              {".obj", internal::read_obj, internal::write_obj},
                              {".ply", internal::read_ply, internal::write_ply},
                              {".stl", internal::read_stl, internal::write_stl}};

const Format& format_of(const std::string& path) {
  std::string extension = fs::path(path).extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  for (const Format& format : formats)
    if (extension == format.extension) return format;
  throw Mesh_io_error(Kind::unknown_format, "\"" + path + "\": the format is not known; use .off, .obj, .ply or .stl");
}

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

File open_file(const std::string& path, const char* mode) { return {std::fopen(path.c_str(), mode), &std::fclose}; }

std::string error_text() { return std::strerror(errno); }

std::string read_bytes(const std::string& path) {
  const auto fail = [&](const std::string& why) -> Mesh_io_error {
    return {Kind::unreadable, "cannot read \"" + path + "\": " + why};
  };
  const File file = open_file(path, "rb");
  if (!file) throw fail(error_text());
  std::error_code ignored;
  const auto size = fs::file_size(path, ignored);
  std::string bytes;
  std::size_t used = 0;
  for (;;) {  // pipes do not know their size, so read on to the end
    bytes.resize(std::max<std::size_t>(ignored ? 0 : size + 1, used + (1 << 16)));
    const std::size_t got = std::fread(&bytes[used], 1, bytes.size() - used, file.get());
    used += got;
    if (got == 0) break;
  }
  if (std::ferror(file.get())) throw fail(error_text());
  bytes.resize(used);
  return bytes;
}

[[noreturn]] void refuse(const std::string& path, const Diagnosis& diagnosis) {
  throw Mesh_io_error(Kind::bad_mesh, "\"" + path + "\": " + message(diagnosis), diagnosis);
}

[[noreturn]] void refuse(const std::string& path, Status status, std::string detail) {
  Diagnosis diagnosis;
  diagnosis.status = status;
  diagnosis.detail = std::move(detail);
  refuse(path, diagnosis);
}

bool is_finite(const Point_3& p) { return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()); }

void refuse_unless_finite(const std::string& path, const std::vector<Point_3>& points) {
  const auto bad = std::find_if_not(points.begin(), points.end(), is_finite);
  if (bad != points.end()) refuse(path, Status::input_not_finite, "vertex " + std::to_string(bad - points.begin()));
}

std::vector<Triangle> triangulate(const Polygon_soup& soup) {
  std::vector<Triangle> triangles;
  triangles.reserve(soup.polygon_end.size());
  std::vector<std::uint32_t> flat;
  std::uint32_t begin = 0;
  for (const std::uint32_t end : soup.polygon_end) {
    flat.clear();
    internal::triangulate_polygon(soup.points, &soup.corners[begin], end - begin, flat);
    for (std::size_t i = 0; i < flat.size(); i += 3) triangles.push_back({flat[i], flat[i + 1], flat[i + 2]});
    begin = end;
  }
  return triangles;
}

}  // namespace

Blend_mesh read_mesh(const std::string& path) {
  const Format& format = format_of(path);
  const std::string bytes = read_bytes(path);
  if (bytes.find_first_not_of(" \t\r\n") == std::string::npos) refuse(path, Status::input_empty, "the file is empty");
  Polygon_soup soup;
  try {
    soup = format.read(bytes);
  } catch (const internal::Malformed_file& error) {
    throw Mesh_io_error(Kind::unreadable, "cannot read \"" + path + "\": " + error.what());
  }
  refuse_unless_finite(path, soup.points);
  if (soup.polygon_end.empty()) refuse(path, Status::input_empty, "");
  const std::vector<Triangle> triangles = triangulate(soup);
  const Triangle_topology topology = internal::analyze_topology(soup.points.size(), triangles);
  const Diagnosis defect =
      internal::manifold_defect(topology, triangles, [&](std::uint32_t v) { return soup.points[v]; });
  if (!defect.ok()) refuse(path, defect);
  return internal::assemble(soup.points, triangles, topology);
}

namespace {

/// Removed elements skipped; isolated vertices stay, so that indices of a file just read are those of the file.
Indexed_mesh index_mesh(const Blend_mesh& mesh) {
  Indexed_mesh indexed;
  indexed.points.reserve(mesh.number_of_vertices());
  indexed.triangles.reserve(mesh.number_of_faces());
  std::vector<std::uint32_t> index(mesh.num_vertices(), 0);
  for (const Vertex v : mesh.vertices()) {
    index[v] = static_cast<std::uint32_t>(indexed.points.size());
    indexed.points.push_back(mesh.point(v));
  }
  for (const Face f : mesh.faces()) {
    const Halfedge h = mesh.halfedge(f);
    CGAL_precondition(mesh.next(mesh.next(mesh.next(h))) == h);
    // Beginning with the source of the halfedge gives back the corners in the order in which they were read.
    indexed.triangles.push_back({index[mesh.source(h)], index[mesh.target(h)], index[mesh.target(mesh.next(h))]});
  }
  return indexed;
}

double single(double x) {
  const volatile float rounded = static_cast<float>(x);  // volatile: g++ 12 at -O2 optimizes the detour away
  return rounded;
}

/// The mesh that a reader gets back from single precision, corners at equal positions not merged.
Blend_mesh rounded_to_single(const Blend_mesh& mesh) {
  Blend_mesh rounded = mesh;
  for (const Vertex v : rounded.vertices()) {
    const Point_3& p = mesh.point(v);
    rounded.point(v) = Point_3(single(p.x()), single(p.y()), single(p.z()));
  }
  return rounded;
}

/// STL holds seven digits: where that would turn a valid mesh into an invalid file, refuse.
void refuse_if_rounding_spoils(const std::string& path, const Blend_mesh& mesh) {
  const Validity_report rounded = validate(rounded_to_single(mesh));
  if (rounded.ok() || !validate(mesh).ok()) return;
  throw Mesh_io_error(Kind::unwritable, "cannot write \"" + path +
                                            "\": STL rounds coordinates to seven digits, which would spoil " +
                                            "the mesh (" + message(rounded.diagnosis) + "); use .off, .obj or .ply");
}

/// Creates a file of a new name beside the target; never one that exists.
File create_beside(const fs::path& target, fs::path& created) {
  for (int attempt = 0; attempt < 1000; ++attempt) {
    created = target;
    created += ".part" + std::to_string(attempt);
    if (File file = open_file(created.string(), "wbx"); file || errno != EEXIST) return file;
  }
  return {nullptr, &std::fclose};
}

bool write_and_close(File file, const std::string& bytes) {
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
  return std::fclose(file.release()) == 0 && written;
}

bool is_write_protected(const fs::path& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  const auto any_write = fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
  return fs::exists(status) && (status.permissions() & any_write) == fs::perms::none;
}

void replace_file(const std::string& path, const std::string& bytes) {
  const auto fail = [&](const std::string& why) -> Mesh_io_error {
    return {Kind::unwritable, "cannot write \"" + path + "\": " + why};
  };
  std::error_code error;
  fs::path target = fs::weakly_canonical(path, error);  // a link stays a link
  if (error) target = path;
  if (fs::is_directory(target, error)) throw fail("it is a directory");
  if (is_write_protected(target)) throw fail("it is write-protected");
  fs::path temporary;
  File file = create_beside(target, temporary);
  if (!file) throw fail(error_text());
  if (!write_and_close(std::move(file), bytes)) {
    const std::string why = error_text();
    fs::remove(temporary, error);
    throw fail(why);
  }
  fs::rename(temporary, target, error);
  if (!error) return;
  const std::string why = error.message();
  fs::remove(temporary, error);
  throw fail(why);
}

}  // namespace

void write_mesh(const std::string& path, const Blend_mesh& mesh) {
  const Format& format = format_of(path);
  if (format.write == internal::write_stl) refuse_if_rounding_spoils(path, mesh);
  replace_file(path, format.write(index_mesh(mesh)));
}

void write_curvature_ply(const std::string& path, const Blend_mesh& mesh, const std::vector<double>& curvatures,
                         const std::vector<std::array<unsigned char, 3>>& colours) {
  CGAL_precondition(curvatures.size() == mesh.number_of_vertices() && colours.size() == mesh.number_of_vertices());
  if (format_of(path).write != internal::write_ply)
    throw Mesh_io_error(Kind::unknown_format, "\"" + path + "\": curvature is written as .ply only");
  replace_file(path, internal::write_curvature_ply(index_mesh(mesh), curvatures, colours));
}

}  // namespace cgal_blend
