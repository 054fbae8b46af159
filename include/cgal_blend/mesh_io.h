// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_MESH_IO_H
#define CGAL_BLEND_MESH_IO_H

#include <cgal_blend/blend_mesh.h>
#include <cgal_blend/status.h>

#include <stdexcept>
#include <string>

namespace cgal_blend {

/// Thrown when a file cannot be read or written, or what it holds is no acceptable mesh.
class Mesh_io_error : public std::runtime_error {
 public:
  enum class Kind { unreadable, unwritable, unknown_format, bad_mesh };
  Mesh_io_error(Kind kind, const std::string& what, Diagnosis diagnosis = {})
      : std::runtime_error(what), kind(kind), diagnosis(std::move(diagnosis)) {}
  Kind kind;
  Diagnosis diagnosis;  ///< for `bad_mesh`: which promise is broken and where
};

/// Reads an OFF, OBJ, PLY or STL file (text or binary, by extension).
///
/// Polygons are triangulated. Vertices of formats without shared vertices (STL) are merged where their positions are
/// equal bit by bit; vertices and faces of the others keep the order of the file, vertex i being vertex i of the file.
/// Throws `Mesh_io_error`: unreadable (missing, truncated, malformed), unknown_format, bad_mesh (empty, not finite,
/// non-manifold, inconsistently oriented: what a halfedge structure cannot hold).
[[nodiscard]] Blend_mesh read_mesh(const std::string& path);

/// Writes a mesh with 17 significant digits (STL: binary single precision), format by extension. Vertices and faces are
/// written in index order, removed ones skipped. The file appears whole or not at all: it is written beside `path` and renamed.
/// Throws `Mesh_io_error` (unwritable, unknown_format); an existing file is then untouched.
void write_mesh(const std::string& path, const Blend_mesh& mesh);

}  // namespace cgal_blend

#endif
