// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_BRIDGE_H
#define CGAL_BLEND_BRIDGE_H

#include <cgal_blend/blend_mesh.h>
#include <cgal_blend/face_origin.h>
#include <cgal_blend/filled_mesh.h>
#include <cgal_blend/polar_curve.h>
#include <cgal_blend/status.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace cgal_blend {

/// Spots farther from the mesh than this fraction of its bounding box diagonal are not on it.
inline constexpr double spot_tolerance = 5e-3;

/// One end of a bridge: what is inside the contact curve around the spot goes, the bridge starts along that curve.
struct Bridge_end {
  Point_3 spot{0, 0, 0};                   ///< on the mesh to within `spot_tolerance`
  double radius = 0;                       ///< of the circle that is the contact curve if `curve` is not set, > 0
  Polar_curve curve;                       ///< contact curve around the spot
  double lambda = 0.5;                     ///< inner curve / contact curve, in [0, 1)
  std::optional<Vector_3> zero_direction;  ///< of angle 0, seen in the tangent plane of the spot; none: any
};

/// How a bridge is shaped and sampled.
struct Bridge_options {
  double mu = 0.5;       ///< in (0, 1): towards 1 the bridge follows the first end longer, towards 0 the second one
  int order = 2;         ///< 1, 2 or 3: of the contact, as far as the meshes stand for smooth surfaces
  double twist_deg = 0;  ///< of the second end against the first, about the bridge, degrees
  /// Turns the ends so that they match with least twist. If false, or if both ends have a zero direction, the angles 0 of
  /// both ends are joined.
  bool least_twist = true;
  double chord_tolerance =
      2e-3;                  ///< of curves and bridge, as a fraction of the larger contact's radius, in [1e-5, 0.1]
  std::size_t segments = 0;  ///< around the bridge, 3 to 4096; 0: by the tolerance
  std::size_t rows = 0;      ///< of facets along the bridge, 2 to 4096; 0: by the tolerance
  double smooth_angle = 40;  ///< edges above it are sharp: normals are not averaged across, degrees in (0, 180)
  /// Meshes may have holes, as long as each lies within a contact curve of a bridge; fillings stand in for them meanwhile.
  /// Spots may lie within the openings. False: meshes must be closed.
  bool fill_holes = false;
  /// Called with a fraction in [0,1] from time to time; return false to cancel.
  std::function<bool(double)> progress;
};

/// What became of one bridge.
struct Bridge_report {
  Diagnosis diagnosis;
  std::size_t segments = 0, rows = 0;
  double turn_deg = 0;      ///< between the zero angles of the ends, by least twist and twist, degrees
  double tangency_deg = 0;  ///< largest angle across the contacts between bridge and mesh, as tangent planes, degrees
  std::array<double, 2> lambda{};
  std::array<double, 2> safe_radius{};  ///< within which the coordinates around the spots are known to be sound
};

/// Wall-clock times, milliseconds.
struct Bridge_times {
  double parametrize = 0;  ///< coordinates, rays and contact curves
  double trim = 0;         ///< cutting and sewing
  double validate = 0;
};

/// A mesh with bridges as the engine produces it.
struct Bridge_outcome {
  Diagnosis diagnosis;  ///< `ok`, or the first refusal; then the output mesh is left empty
  std::vector<Bridge_report> bridges;
  std::vector<std::vector<Face>> bridge_faces;  ///< per bridge, as far as later ones have left them
  std::vector<Face> changed_faces;              ///< every face that is not a face of the input
  std::size_t kept_faces = 0;  ///< faces bit-identical to faces of the input, order kept; they come first
  std::vector<std::uint32_t>
      origins;                  ///< per face: index of the input face that it is, or is a part of, else `no_origin`
  double volume = 0, area = 0;  ///< of the output
  Bridge_times times;

  [[nodiscard]] bool ok() const noexcept { return diagnosis.ok(); }
};

/// A bridge of a series.
struct Bridge {
  std::array<Bridge_end, 2> ends;
  Bridge_options options;
};

/// What a drag came to.
struct Drag {
  std::array<double, 2> lambda{};
  double residual = 0;   ///< distance of the surface point from the target, length units
  bool reached = false;  ///< residual below `drag_tolerance`
};

/// Distance at which a drag counts as arrived, as a fraction of the larger contact's radius.
inline constexpr double drag_tolerance = 1e-6;

/// A bridge that is being shaped: coordinates, contact curves and cuts are made once, so that a change of shape
/// evaluates the bridge's surface only.
class Bridge_solver {
 public:
  /// \param mesh closed unless `fill_holes`, 2-manifold, outward oriented; lives as long as the solver
  Bridge_solver(const Blend_mesh& mesh, const std::array<Bridge_end, 2>& ends, const Bridge_options& options = {});
  ~Bridge_solver();
  Bridge_solver(Bridge_solver&&) noexcept;
  Bridge_solver& operator=(Bridge_solver&&) noexcept;

  /// `ok`, or why there is no bridge; then nothing else works.
  [[nodiscard]] const Diagnosis& diagnosis() const;

  // Changes of shape; values out of range are left out, and false is returned.
  bool set_lambda(int end, double lambda);
  bool set_mu(double mu);
  bool set_order(int order);
  bool set_twist(double degrees);
  [[nodiscard]] const std::array<double, 2>& lambda() const;

  /// Point B(s, t) of the surface: s around it, of period 1, along the first end's contact curve; t in [0, 1] from the first
  /// contact to the second.
  [[nodiscard]] Point_3 point(double s, double t) const;
  /// Sampled surface, row by row from the first contact to the second: (rows + 1) x segments points, the first and last
  /// rows on the contact curves.
  [[nodiscard]] const std::vector<Point_3>& points() const;
  [[nodiscard]] std::size_t segments() const;
  [[nodiscard]] std::size_t rows() const;

  /// Changes both lambdas so that B(s, t) comes to the target, or as near as it can.
  Drag drag(double s, double t, const Point_3& target);

  /// Trims the mesh and sews the bridge in, with the check of the result. Source of the formulas: see `bridge`.
  [[nodiscard]] Bridge_outcome build(Blend_mesh& out) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The engines, for input that is known to be valid (`validate`); the overloads of bridge_graphs.h check it first.
namespace unchecked {

/// Joins two spots of a mesh by a smooth tube, B(s, t) = f(t) S_1(s, t) + (1 - f(t)) S_2(s, t): S_i runs along geodesic rays
/// from the contact curve of end i to the inner curve, and f is Hartmann's function of parameter mu and order n.
/// \param mesh closed unless `fill_holes`, 2-manifold, outward oriented; of one body or several. Two spots of one body give a handle. Bodies
///        may cross each other if the bridge takes all of the crossing away, which is checked
/// \param out receives the result: kept vertices and faces come first, in their order
/// Refuses by name in the outcome; never throws for bad data, never changes `mesh`.
/// Source: Shin et al., Parametric blending of triangular meshes, Symmetry 10 (2018), section 3; Hartmann, Parametric
/// G^n blending of curves and surfaces, The Visual Computer 17 (2001).
[[nodiscard]] Bridge_outcome bridge(const Blend_mesh& mesh, const std::array<Bridge_end, 2>& ends, Blend_mesh& out,
                                    const Bridge_options& options = {});

/// Makes bridges one after the other, each on the mesh that those before left. If one is refused, so is the whole; the
/// detail of the diagnosis begins with its number, from 1. Holes are filled at the start if any bridge has `fill_holes`.
[[nodiscard]] Bridge_outcome bridge_all(const Blend_mesh& mesh, const std::vector<Bridge>& bridges, Blend_mesh& out);

/// Unites two bodies that cross and replaces the surroundings of each closed intersection curve by a bridge.
/// \param ends of `a` and `b`; contact curves at `radius` from the intersection curves along the surfaces, or at the
///        distance of `curve`, whose angle is the arc-length fraction along the intersection curve times 2 pi.
///        Spots and zero directions are left alone, and so is the twist
/// The origins of faces of `b` count on after those of `a`.
[[nodiscard]] Bridge_outcome bridge_intersection(const Blend_mesh& a, const Blend_mesh& b,
                                                 const std::array<Bridge_end, 2>& ends, Blend_mesh& out,
                                                 const Bridge_options& options = {});

/// Moves spots that lie within openings onto the fillings there. For bridges made one by one on a filled mesh.
void move_spots_to_fillings(const Filled_mesh& filled, std::array<Bridge_end, 2>& ends);

/// Says `region_meets_border` if part of a filling is left, with its hole, and, where that can be told, with the radius that
/// would take it away.
/// \param origins per face: that of the filled mesh that it is, or is a part of, or `no_origin`
/// \param ends of the bridges made on the filled mesh
[[nodiscard]] Diagnosis check_fillings(const Filled_mesh& filled, const std::vector<std::uint32_t>& origins,
                                       const std::vector<Bridge_end>& ends);

/// Puts bodies side by side into one mesh; vertices and faces of the first come first.
[[nodiscard]] Blend_mesh put_together(const std::vector<const Blend_mesh*>& bodies);

}  // namespace unchecked

}  // namespace cgal_blend

#include <cgal_blend/bridge_graphs.h>  // the same for meshes of any type

#endif
