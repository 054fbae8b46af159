// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_FUSE_H
#define CGAL_BLEND_FUSE_H

#include <cgal_blend/cut_plane.h>
#include <cgal_blend/implicit_opening.h>
#include <cgal_blend/status.h>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace cgal_blend {

/// One side of a fusion: meshes with their openings in one plane.
template <class Graph>
struct Fusion_side_of {
  std::vector<const Graph*> meshes;  ///< one or more; live as long as the call
  /// Cuts every one of the meshes; what it points to is removed. None: the meshes have holes, all in one plane.
  std::optional<Cut_plane> plane{};
};
using Fusion_side = Fusion_side_of<Blend_mesh>;

/// Options of a fusion. How far the sides are apart is given by where they are.
struct Fuse_options {
  Opening_model model;                  ///< implicit form of the openings; signed distance if not set
  std::array<double, 2> eta{0.4, 0.6};  ///< free control values of w = eta(z), in [0, 1]; 0.4 and 0.6 give w = z
  std::array<double, 2> weight{1, 1};   ///< of the sides' functions, > 0: where several openings come together, and how
                                        ///< soon sections change; the heavier side keeps its shape the longer
  double step = 0.2;        ///< distance of the shifted sections, of the mean edge of a side's rings, in [1e-3, 100]
  double edge = 0;          ///< edge length of the transition's facets, length units; 0: that of the rings, graded
  double grading = 1;       ///< facets grow away from the rings up to this many times their edges, in [1, 100]
  double least_angle = 20;  ///< what no facet away from the rings should fall below, degrees in [0, 30]
  /// Called with a fraction in [0,1] from time to time; return false to cancel.
  std::function<bool(double)> progress;
};

/// Wall-clock times of the stages of a fusion, milliseconds.
struct Fuse_times {
  double cut = 0;         ///< cutting, and the shifted sections
  double openings = 0;    ///< implicit forms of all sections
  double tessellate = 0;  ///< meshing the transition
  double assemble = 0;    ///< sewing; linear in the size of the meshes
  double validate = 0;
};

/// A fusion as the engine produces it.
struct Fuse_outcome {
  Diagnosis diagnosis;                 ///< `ok`, or the first refusal; then the output mesh is left empty
  std::vector<Face> transition_faces;  ///< the last faces
  std::vector<Face> changed_faces;  ///< every face that is not a face of the input: parts of divided ones, transition
  std::size_t kept_faces = 0;  ///< faces bit-identical to faces of the input; they come first: the lower meshes' in
                               ///< their order, then the upper ones'
  std::array<std::size_t, 2> rings{};  ///< number of rings of each side
  std::array<bool, 2> one_sided{};     ///< slopes of a side come from one shifted section, see `Hermite_transition`
  double angle = 0;                    ///< between the planes, degrees
  double height = 0;                   ///< distance of the planes, along an arc where they are not parallel
  long euler_characteristic = 0;       ///< of the output
  double tangency_mean = 0, tangency_max = 0;  ///< angle across the rings between facets on both sides, degrees
  double volume = 0, area = 0;                 ///< of the output
  Fuse_times times;

  [[nodiscard]] bool ok() const noexcept { return diagnosis.ok(); }
};

/// The largest angle between the planes of a fusion, degrees.
inline constexpr double steepest_planes = 120;

/// Checks a mesh that is to become a part of a fusion: a valid solid, but for holes that the plane cuts off; or, without a plane, a
/// surface without flaws that has holes.
[[nodiscard]] Diagnosis check_fusion_part(const Blend_mesh& mesh, const std::optional<Cut_plane>& plane);

namespace unchecked {

/// Joins the openings of two sides by a transition surface that is tangent to both, whatever the number of rings, nested
/// ones included. The normals of the planes point away from what is kept, towards each other up to `steepest_planes`.
/// \param lower, upper meshes that have passed `check_fusion_part`
/// \param out receives the result; kept vertices and faces of the input come first, in their order
/// Refuses by name in the outcome; never throws for bad data.
/// Source: Jin et al., Mesh fusion using functional blending on topologically incompatible sections, The Visual Computer 22
/// (2006).
[[nodiscard]] Fuse_outcome fuse(const Fusion_side& lower, const Fusion_side& upper, Blend_mesh& out,
                                const Fuse_options& options = {});

}  // namespace unchecked

}  // namespace cgal_blend

#include <cgal_blend/fuse_graphs.h>  // the same for meshes of any type

#endif
