// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_FILLET_H
#define CGAL_BLEND_FILLET_H

#include <cgal_blend/blend_mesh.h>
#include <cgal_blend/boolean_operation.h>
#include <cgal_blend/face_origin.h>
#include <cgal_blend/profile.h>
#include <cgal_blend/radius_law.h>
#include <cgal_blend/status.h>
#include <cgal_blend/validate.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace cgal_blend {

/// How a blend becomes part of the mesh.
enum class Blend_mode {
  stitch,  ///< cut along the linkage curves, with the tessellated blend sewn in: any mesh, exact linkage curves
  map      ///< connectivity kept, vertices moved onto the blend: as fine as the mesh is between the linkage curves;
           ///< closed curves only
};

/// Options of the rolling-ball blends; one set for all curves of a call.
struct Fillet_options {
  double radius = 0;  ///< ball radius, length units, > 0
  /// Radius that varies along each curve, open or closed, instead of `radius`. Where s = 0 lies: see
  /// `Edge_blend_of::start`. Not with a coarse level.
  std::optional<Radius_law> law;
  Profile profile;  ///< cross-section; the arc of the ball if not set
  Blend_mode mode = Blend_mode::stitch;
  /// Map mode: blend the mesh decimated to about so many faces, then restore the detail of the fine one; 0: off.
  std::size_t coarse_faces = 0;
  double chord_tolerance =
      2e-3;                 ///< largest distance between arc and facets as a fraction of the radius, in [1e-6, 0.3]
  std::size_t samples = 0;  ///< about so many ball positions spread by arc length; 0: as many as the tolerance asks for
  double chord_ratio =
      0;  ///< divide steps of the ball whose chord height over chord length is larger, in [0, 1]; 0: by tolerance
  double smooth_angle = 40;  ///< faces whose normals differ by less belong to one smooth surface, degrees in (0, 180)
  bool mend_spine = true;   ///< where the spine crosses itself, cut the loop off and join the ends, instead of refusing
  /// Leave curves that cannot be blended sharp instead of refusing all; also those that wait for them at a corner, if a
  /// whole pass fails.
  bool keep_going = false;
  /// A mesh whose edges are blended may have flaws (`Flaw`) away from the blends: they stay as they are, all that is new
  /// is as valid as ever. A flaw that a blend meets is refused by its name. For the check of the input; operands of
  /// booleans may have none, as corefinement has no answer for them.
  bool accept_flaws = false;
  /// Edges chosen for a blend are continued over those that go on smoothly from their ends: the only further crease there
  /// by `smooth_angle`, bent to the same side, turning by less than 25 degrees. Off by default, so that what is blended is
  /// what was chosen; on, one edge of a rim stands for the rim. Curves of booleans are whole anyway. A law runs along the
  /// curve as it has grown, and its start at an open end moves along with the end.
  bool propagate = false;

  /// Called with a fraction in [0,1] from time to time; return false to cancel.
  std::function<bool(double)> progress;
};

/// What became of one blending curve: a closed one, or a branch between ends and corners.
struct Blend_report {
  /// `max_radius` is found by trial with the radii of all blends of the call in proportion, so that it works for all of
  /// them together; with `keep_going` for this one alone. Where success ends at some radius, it is at most 1.2 % less,
  /// unless the number of trials was used up. Where the radius varies it is that of the largest.
  Diagnosis diagnosis;
  /// Edges of the blending curve. In a later pass they are those of the mesh by then: the curve may run on along the
  /// end of an earlier blend.
  std::size_t edges = 0;
  bool closed = true;
  bool convex = false;      ///< true: material removed; false: material added
  double radius = 0;        ///< the largest where it varies
  double radius_error = 0;  ///< largest | |x - spine| - r | / r over the linkage curves, joints over loops apart
  double tangency_deg =
      0;  ///< largest angle across the linkage curves between the blend's tangent plane and the base face, degrees
  std::size_t loops = 0;  ///< loops of the spine that were cut off
  /// True if the ball had to roll on over the edge of a neighbouring face: to the face beyond, or along the edge, where
  /// the blend is not tangent but ends.
  bool over_edges = false;
  /// Ends of an open curve, 0 to 2, that are a flat face across it: where the crease goes on sharp, as at the ends of a
  /// part of a curve, and where the faces beyond are in no order that is known.
  std::size_t flat_ends = 0;
  double coarseness = 0;  ///< map mode: largest distance of the blend from the facets that stand for it / r
};

/// Wall-clock times of the stages, milliseconds.
struct Stage_times {
  double boolean = 0;
  double coarsen = 0;  ///< making the coarse level that is blended instead of the mesh, and checking it
  double blend = 0;    ///< all that blending takes, but for copying the mesh
  double copy = 0;     ///< copying the whole mesh and putting it in order: linear in its size, whatever is blended
  double validate = 0;
};

/// A blend of one mesh as the engines produce it.
struct Fillet_outcome {
  Diagnosis diagnosis;  ///< `ok`, or the first refusal; then the output mesh is left empty
  /// One per blending curve, in the order in which they are made: those that wait at a corner follow those that they
  /// wait for. Curves that have become one over the end of an earlier blend have one report.
  std::vector<Blend_report> blends;
  std::vector<Face> blend_faces;    ///< faces of the transition surfaces
  std::vector<Face> changed_faces;  ///< every face that is not a face of the input, blend faces included
  std::size_t kept_faces =
      0;  ///< faces bit-identical to faces of the input, order kept; they come first, but not in map mode
  std::vector<std::uint32_t>
      origins;                  ///< per face: index of the input face that it is, or is a part of, else `no_origin`;
                                ///< faces of a second body count on after those of the first, and so on
  double volume = 0, area = 0;  ///< of the output
  Stage_times times;

  [[nodiscard]] bool ok() const noexcept { return diagnosis.ok(); }
};

/// The edges of one blend with their radius, constant or varying along each curve that they form.
template <class Graph>
struct Edge_blend_of {
  std::vector<typename boost::graph_traits<Graph>::edge_descriptor> edges;  ///< of the input mesh, in any order
  double radius = 0;                                                        ///< 0: the radius of the options
  std::optional<Profile> profile{};                                         ///< none: the profile of the options
  std::optional<Radius_law> law{};  ///< instead of `radius`; none: that, or the radius or law of the options
  /// Where the law's s = 0 lies: an end of an open curve, from which s runs to the other one, or any vertex of a closed
  /// curve, from which s runs as the curve does. None, and for curves that it is not on: their first vertex. Curves are
  /// the branches of `make_curve_network`, corners in which two edges meet included.
  std::optional<typename boost::graph_traits<Graph>::vertex_descriptor> start{};
  /// The part of each curve that is blended, as arc-length fractions from `start` on, 0 <= from < to <= 1: at stations
  /// within the curve the blend ends in a flat face across it, and what is beyond stays sharp. A law runs over the part.
  /// On closed curves `from` may exceed `to`: then the part runs over the start. Stations nearer to a vertex than 0.001
  /// radii are moved there.
  double from = 0, to = 1;
};
using Edge_blend = Edge_blend_of<Blend_mesh>;

/// One step of a series of booleans: what is done with which further body.
template <class Graph>
struct Part_of {
  const Graph* mesh = nullptr;                              ///< lives as long as the call
  Boolean_operation operation = Boolean_operation::union_;  ///< of the body as it is by then, and `mesh`
  double radius = 0;                                        ///< 0: the radius of the options
  std::optional<Radius_law> law{};                          ///< instead of `radius`, as in `Edge_blend_of`
};
using Part = Part_of<Blend_mesh>;

/// The engines, for input that is known to be valid (`validate`); the overloads of fillet_graphs.h check it first.
namespace unchecked {

/// Blends edges of a mesh with a rolling ball. Curves may be closed, end at faces or at nothing, and meet in corners:
/// there the ball comes to rest, or, where no ball of one radius touches all faces from one side, the blends are made
/// in an order and later ones roll over the ends of earlier ones. With the sharp profile, closed chains of edges along the
/// middle of a round are taken for the round itself: the radius must be larger than the round's, and the round is
/// replaced by a sharp edge.
/// \param mesh closed, 2-manifold, outward oriented, without self-intersections: checked by the caller (`validate`)
/// \param out receives the result; vertices and faces of the input that are kept come first, in their order
/// Refuses by name in the outcome; never throws for bad data, never changes `mesh`.
/// Source: Liu et al., Mesh blending, The Visual Computer 21 (2005), sections 3 to 6.
[[nodiscard]] Fillet_outcome fillet_edges(const Blend_mesh& mesh, const std::vector<Edge_blend>& blends,
                                          Blend_mesh& out, const Fillet_options& options);

/// The same for a mesh with flaws, all of which are told; in stitching or map mode without a coarse level.
/// \param flaws as `validate` lists them. Faces named there are kept, or the blend is refused with the status of the
///        flaw and its place. `keep_going` leaves curves sharp whose edges touch one; their reports come last
[[nodiscard]] Fillet_outcome fillet_edges(const Blend_mesh& mesh, const std::vector<Edge_blend>& blends,
                                          const std::vector<Flaw>& flaws, Blend_mesh& out,
                                          const Fillet_options& options);

/// Computes a boolean of two meshes and blends their intersection curves; radius 0 leaves the curves sharp.
/// Faces of `a` that are kept come first in `out`, then those of `b`, then new ones.
[[nodiscard]] Fillet_outcome corefine_and_fillet(const Blend_mesh& a, const Blend_mesh& b, Boolean_operation operation,
                                                 Blend_mesh& out, const Fillet_options& options);

/// Computes a series of booleans, each on the result of those before, and blends the intersection curves of each with a
/// radius of its own before the next; radius 0 leaves the curves of a step sharp.
/// The outcome is that of the whole: in stitching mode faces of `first` that are still bit-identical come first in `out`,
/// then those of the parts in turn; `kept_faces` counts them; `blend_faces` are the transition surfaces of all steps as far as later
/// steps have left them; `blends` and the times are those of all steps. If a step is refused, so is the whole; the
/// detail of the diagnosis begins with the step ("part 2", counted from 1, where there are several) and the reports end
/// with those of that step. `keep_going` holds for each step by itself.
/// Source: Liu et al., Mesh blending, The Visual Computer 21 (2005), section 6.3.
[[nodiscard]] Fillet_outcome corefine_and_fillet_all(const Blend_mesh& first, const std::vector<Part>& parts,
                                                     Blend_mesh& out, const Fillet_options& options);

}  // namespace unchecked

}  // namespace cgal_blend

#include <cgal_blend/fillet_graphs.h>  // the same for meshes of any type

#endif
