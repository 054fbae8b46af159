// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_STRIP_END_H
#define CGAL_BLEND_SRC_STRIP_END_H

#include "rolling_ball.h"
#include "surface_path.h"
#include "virtual_surface.h"

#include <cgal_blend/status.h>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace cgal_blend {

/// What a branch runs into at an end.
struct Branch_end {
  enum class Kind {
    faces,  ///< other faces: the blend is cut by them, or by their extension
    cap,    ///< its own crease, which stays sharp beyond, or faces in no order that is known: a flat face across it
    fade,   ///< nothing: the crease has faded out
    ball    ///< other blends: the ball at rest in the corner
  };
  Kind kind = Kind::faces;
  int end = 0;     ///< 0 where the branch starts, 1 where it ends
  Halfedge into;   ///< edge of the branch that points to the vertex, from within
  Vec direction;   ///< of the branch, outward
  bool fill = false;                         ///< faces: their extension cuts, and they grow
  std::array<bool, 2> inside{};              ///< per side: the rim goes on inside the base face beyond the vertex
  std::array<std::vector<Halfedge>, 2> border{};  ///< per side: border of its base face from the vertex on, outward;
                                                  ///< none where its own crease goes on
  double reach = 0;                          ///< length to look at around the vertex

  [[nodiscard]] Vertex vertex(const Blend_mesh& mesh) const { return mesh.target(into); }
  /// Side of the branch left of `into`.
  [[nodiscard]] int left() const { return end == 1 ? 0 : 1; }
  /// Flat ends are to be flat: rims and seams are moved onto edges and vertices only from much nearer than elsewhere.
  [[nodiscard]] double snap(double elsewhere) const { return kind == Kind::cap ? elsewhere / 16 : elsewhere; }
};

/// Tells how a branch ends by the sharp edges around its end, none of which is to be blended.
/// \param into the edge of the branch that points to the vertex
[[nodiscard]] Branch_end view_end(const Base_surface& surface, Halfedge into, int end, bool convex, double radius);

/// The border of a strip at one end, from its left rim to its right one, a point per row.
struct Strip_end {
  std::vector<std::size_t> last;     ///< per row: the outermost ball position that it runs through
  std::vector<Vec> hit;              ///< per row: where it ends
  std::array<Station, 2> rim;        ///< where the rims end, on either side's base surface
  std::optional<Surface_path> path;  ///< on the faces that cut the strip; its points are the rows' ends
};

/// Finds where the rows of a strip end.
/// \param rows parameters of the profile, see `Virtual_surface::rows`
/// \param middle a position in the middle of the branch
/// \param clear rows keep no ball position that is nearer to their end, length units
struct Strip_end_result {
  Diagnosis diagnosis;
  Strip_end end;
};
[[nodiscard]] Strip_end_result end_strip(const Base_surface& surface, const Branch_end& branch_end,
                                         const std::vector<Ball_position>& positions, const Virtual_surface& blend,
                                         const std::vector<double>& rows, std::size_t middle, double clear, double snap);

/// Vertices of the base mesh along a base face's border from an end's vertex to where the rim crosses it, without that
/// place; empty if the rim does not cross it.
[[nodiscard]] std::vector<Vertex> border_to_rim(const Blend_mesh& mesh, const Branch_end& end, int side,
                                                const Station& rim);

}  // namespace cgal_blend

#endif
