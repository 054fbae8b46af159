// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_MESH_IO_H
#define CGAL_BLEND_MESH_IO_H

#include <cgal_blend/blend_mesh.h>
#include <cgal_blend/status.h>

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

namespace cgal_blend {

/// Thrown when a file cannot be read or written, or what it holds is no acceptable mesh. `what()` is one line.
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
/// Vertices and faces keep the order of the file, vertex i being vertex i of the file; vertices without faces stay.
/// Polygons are triangulated in place. Formats without shared vertices (STL) have corners at equal positions merged,
/// in the order in which they first appear, and facets dropped that shrink to a segment or a point by that.
/// An open or inside-out mesh is read; `validate` names it.
/// Throws `Mesh_io_error`: unreadable (missing, cut off, malformed), unknown_format, bad_mesh (empty, not finite,
/// non-manifold, inconsistently oriented, a face that names a vertex twice: what a halfedge structure cannot hold).
[[nodiscard]] Blend_mesh read_mesh(const std::string& path);

/// Writes a mesh, format by extension. Text formats get the shortest decimals that read back to the same doubles, PLY
/// is binary with doubles, STL is binary and so rounded to single precision: where that would turn a valid mesh into an
/// invalid one it is refused as unwritable. Vertices and faces are written in index order, removed ones skipped.
/// The file appears whole or not at all: it is written beside `path` and renamed.
/// Throws `Mesh_io_error` (unwritable, unknown_format); an existing file is then untouched.
void write_mesh(const std::string& path, const Blend_mesh& mesh);

/// Writes a mesh with its mean curvature as a binary PLY file: beside the coordinates, each vertex has a colour (`red`,
/// `green`, `blue`, uchar) and a double `mean_curvature`. `read_mesh` reads it like any other mesh.
/// \param curvatures, colours one per vertex that is not removed, in index order (`mean_curvature`, `colour_scale`)
/// Files and errors as for `write_mesh`; unknown_format unless `path` ends in .ply.
void write_curvature_ply(const std::string& path, const Blend_mesh& mesh, const std::vector<double>& curvatures,
                         const std::vector<std::array<unsigned char, 3>>& colours);

}  // namespace cgal_blend

#endif
