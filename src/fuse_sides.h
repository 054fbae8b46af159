// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_FUSE_SIDES_H
#define CGAL_BLEND_SRC_FUSE_SIDES_H

#include "plane_cut.h"

#include <cgal_blend/fuse.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace cgal_blend {

/// One mesh of a side, cut, with the places of its vertices in the output.
struct Fuse_part {
  const Blend_mesh* mesh = nullptr;
  Plane_cut cut;
  std::size_t first_kept = 0;  ///< output index of its first kept vertex
  std::size_t first_new = 0;   ///< output index of its first new vertex

  [[nodiscard]] std::size_t output_index(std::size_t v) const {
    return v < cut.vertices.size() ? first_kept + v : first_new + v - cut.vertices.size();
  }
};

/// A side with its openings.
struct Fuse_side {
  Diagnosis diagnosis;
  Cut_plane plane;  ///< of unit normal, through the centroid of the rings
  bool cut = true;  ///< false: the rings are the holes of open meshes
  std::vector<Fuse_part> parts;
  std::vector<std::vector<std::size_t>> rings;  ///< of all parts, by output index
  std::vector<Section_loop> points;             ///< positions of the same
  double mean_edge = 0;                         ///< of the rings
  /// Sections by the plane shifted by `step` away from what is kept (0) and into it (1); empty: there is none.
  std::array<std::vector<Section_loop>, 2> shifted;
  double step = 0;
};

/// Says in a message what it is about.
void put_before(Diagnosis& diagnosis, const std::string& subject);

/// Cuts all meshes of a side, or takes their holes.
/// \param tidy whether short edges of rings are collapsed
[[nodiscard]] Fuse_side open_side(const Fusion_side& side, bool tidy);

/// Computes the sections shifted by a share of the mean edge of the rings.
void add_shifted_sections(Fuse_side& side, double share);

/// Numbers the vertices of the output: kept ones of both sides, then new ones. Returns how many there are.
std::size_t number_vertices(std::array<Fuse_side, 2>& sides);

}  // namespace cgal_blend

#endif
