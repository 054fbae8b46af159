// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_ANCESTRY_H
#define CGAL_BLEND_SRC_ANCESTRY_H

#include <cgal_blend/fillet.h>

#include <cstdint>
#include <vector>

namespace cgal_blend {

/// Where the faces of a body come from, over all steps so far.
struct Ancestry {
  std::vector<std::uint32_t> origins;  ///< among the faces of all bodies so far
  std::vector<bool> kept;              ///< bit-identical to its origin
  std::uint32_t input_faces = 0;       ///< of all bodies so far

  explicit Ancestry(const Blend_mesh& first);

  /// From the first step on.
  explicit Ancestry(const Fillet_outcome& first);

  /// Passes on to the result of a step: on the body alone, or with a further body of so many faces.
  void advance(const Fillet_outcome& step, std::uint32_t part_faces);

  /// Faces of blends and of cut input faces were kept by later steps too, in between: moves them behind the faces of
  /// the input, which are in order among themselves.
  void put_kept_first(Blend_mesh& mesh);

  /// Fills in what follows from it: nothing but the blends has no origin.
  void describe_faces(Fillet_outcome& outcome) const;
};

/// Adds up the times of steps.
void add(Stage_times& times, const Stage_times& more);

}  // namespace cgal_blend

#endif
