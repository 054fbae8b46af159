// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_COARSE_LEVEL_H
#define CGAL_BLEND_SRC_COARSE_LEVEL_H

#include "phong_tessellation.h"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace cgal_blend {

/// A decimated version of a mesh with its blending curves, and where each fine vertex lies on it: for blends that are
/// made on a coarse level and carried back to the fine one (Liu et al. 2005, Mesh blending, section 6.3). The detail of
/// the fine mesh is its displacement from a smooth surface over the coarse mesh, in a frame that moves with it.
class Coarse_level {
 public:
  /// What the construction took.
  struct Milliseconds {
    double decimation = 0, encoding = 0;
  };

  /// \param fine valid by `validate`: closed, 2-manifold, outward, no degenerate faces or edges
  /// \param curves per blending curve its edges, in any order: a simple chain, closed or open; no two share a vertex
  /// \param faces about how many faces the coarse mesh shall have; more where the curves or the shape need them
  /// The coarse mesh is closed and 2-manifold as the fine one is, and free of folds. Parts of it that are close to each
  /// other may cross all the same: that is for the caller to `validate`, and to ask for more faces then.
  Coarse_level(const Blend_mesh& fine, const std::vector<std::vector<Edge>>& curves, std::size_t faces);

  // The normals refer to the mesh beside them.
  Coarse_level(const Coarse_level&) = delete;
  Coarse_level& operator=(const Coarse_level&) = delete;

  /// The coarse mesh, without removed elements. Vertices on curves are vertices of the fine mesh.
  [[nodiscard]] const Blend_mesh& mesh() const { return mesh_; }

  /// The same curves on the coarse mesh, their edges in the order of the chain; each keeps `least_curve_vertices`.
  [[nodiscard]] const std::vector<std::vector<Edge>>& curves() const { return curves_; }

  /// \param moved the coarse mesh with other positions, connectivity and indices being the same
  /// \return fine vertices in order, with their new positions, where a face of the coarse mesh changed: one whose
  /// corners, or normals there, did. All others stay; the change fades to nothing at the rim of these faces. A fine
  /// vertex that is a vertex of the coarse mesh goes exactly where that went.
  [[nodiscard]] std::vector<std::pair<Vertex, Point_3>> restore(const Blend_mesh& moved) const;

  [[nodiscard]] const Milliseconds& milliseconds() const { return milliseconds_; }

 private:
  friend class Detail_encoder;

  /// Place of a fine vertex: a point of a facet, and the displacement from it.
  struct Detail {
    Vertex fine;
    Face face;
    Vec bary;
    Vec displacement;       ///< along the frame: side, across, normal
    int side = 0;           ///< of the facet that the frame is aligned to: from this corner to the next
    bool on_curve = false;  ///< on this side, with the normals averaged over both sides of the curve
  };
  /// A fine vertex that is a vertex of the coarse mesh.
  struct Common {
    Vertex fine, coarse;
  };

  [[nodiscard]] Phong_facet facet(const Detail& detail, const Blend_mesh& positions,
                                  const Corner_normals& normals) const;

  Blend_mesh mesh_;
  std::vector<std::vector<Edge>> curves_;
  std::vector<bool> on_curve_;  // indexed by edge
  std::optional<Corner_normals> normals_;
  std::vector<Detail> details_;
  std::vector<Common> common_;
  Milliseconds milliseconds_;
};

}  // namespace cgal_blend

#endif
