// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_BASE_SURFACE_H
#define CGAL_BLEND_SRC_BASE_SURFACE_H

#include <cgal_blend/blend_mesh.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace cgal_blend {

inline constexpr double pi = 3.14159265358979323846;

using Vec = Eigen::Vector3d;

inline Vec to_vec(const Point_3& p) { return {p.x(), p.y(), p.z()}; }
inline Point_3 to_point(const Vec& v) { return {v.x(), v.y(), v.z()}; }

/// Angle between two vectors, radians in [0, pi].
[[nodiscard]] double angle_between(const Vec& a, const Vec& b);

/// A point of a mesh: a face, and the barycentric coordinates with respect to the targets of its halfedges
/// h, next(h), next(next(h)) where h = halfedge(face).
struct Surface_point {
  Face face;
  Eigen::Vector3d bary = Eigen::Vector3d::Constant(1.0 / 3);
};

/// A triangle mesh seen as a piecewise smooth surface: within a smooth group normals are interpolated linearly
/// between corner normals and normalized, so that the offset p + d n/|n| is continuous and at the exact distance |d|.
/// Everything is evaluated on demand, so that the cost depends on what is visited only.
class Base_surface {
 public:
  /// Where a vertex lies on an edge of the surface that was divided; halfedges run from the edge's first end to its last.
  struct Edge_point {
    Halfedge first, into, last;  ///< from the first end on; to the vertex; to the last end
    double part = 0;             ///< of the edge from its first end on
  };
  using Edge_points = std::unordered_map<Vertex, Edge_point>;

  struct Options {
    double smooth_angle = 40;    ///< degrees; across edges above it normals are not averaged
    double shortest_crease = 0;  ///< chains of such edges that are shorter are roughness, and smooth all the same
    int smoothing_passes = 0;    ///< Laplacian passes over the corner normals, for surfaces rough at the ball's scale
    bool reversed = false;       ///< true: the solid lies on the side the faces point to
    bool area_weights = false;   ///< average normals by squared area: large faces are the surface, small ones a round
    /// A ball of this radius rolls on over sharp edges that bend towards it, length units; 0: they stop it.
    double rolling_radius = 0;
    bool ball_inside = false;  ///< of the solid: then the edges that bend towards the ball are the concave ones
    const Edge_points* edge_points = nullptr;  ///< where normals are interpolated, as if there were no vertex
  };

  /// \param creases edges across which the surface is not smooth, whatever their angle; may be null
  /// \param blends faces of blends, which are tangent to the others: no normal is averaged over both; may be null
  Base_surface(const Blend_mesh& mesh, const Options& options, const std::unordered_set<Edge>* creases = nullptr,
               const std::unordered_set<Face>* blends = nullptr);

  /// What a face contributes to evaluations.
  struct Frame {
    std::array<Halfedge, 3> halfedge;  ///< their targets are the corners
    std::array<Vec, 3> corner;
    std::array<Vec, 3> place;     ///< where the corners are; on bands over an edge they are moved apart for the walk
    std::array<Vec, 3> normal;    ///< corner normals, outward of the solid
    std::array<Vec, 3> gradient;  ///< of the barycentric coordinates
    Vec face_normal;              ///< unit, outward of the solid
  };

  /// Offset point and its derivative with respect to tangential displacements of the foot point.
  struct Offset {
    Vec point;
    Eigen::Matrix3d derivative;
  };

  /// Continues the surface beyond a chain of its sharp edges, ruled along `direction` as projected into the tangent
  /// plane of each vertex, normals unchanged: there walks go on, over faces that the mesh does not have.
  /// \param chain halfedges of the surface's own side, each ending where the one before it starts or starting where it
  /// ends; edges that the direction does not leave across are skipped
  /// \param length of the extension, length units
  void extend(const std::vector<Halfedge>& chain, const Vec& direction, double length);

  /// True for a face beyond a sharp edge, see `extend`.
  [[nodiscard]] bool is_extension(Face face) const {
    return is_virtual(face) && virtual_[face.idx() - first_virtual_].band == Blend_mesh::null_halfedge();
  }

  /// True if a ball may roll on over a sharp edge (`Options::rolling_radius`): there the surface has a *band*, two faces
  /// without width between the normals of both sides, so that the offset goes round the edge.
  [[nodiscard]] bool rolls_over(Halfedge h) const;

  /// The edge that a face is the band of, as the halfedge that the band begins at; null for other faces.
  [[nodiscard]] Halfedge band_edge(Face face) const {
    return is_virtual(face) ? virtual_[face.idx() - first_virtual_].band : Blend_mesh::null_halfedge();
  }

  [[nodiscard]] bool rolls() const { return options_.rolling_radius > 0; }

  /// End of a walk; `blocked` is the sharp edge at which it stopped short.
  struct Walk {
    Surface_point end;
    Halfedge blocked;
  };

  [[nodiscard]] const Blend_mesh& mesh() const { return mesh_; }
  [[nodiscard]] const Frame& frame(Face face) const;
  [[nodiscard]] Vec position(const Surface_point& at) const;
  [[nodiscard]] Vec normal(const Surface_point& at) const;
  [[nodiscard]] Offset offset(const Surface_point& at, double distance) const;

  /// Change of the interpolated normal along a unit tangent, in that direction: positive where the surface is convex.
  [[nodiscard]] double normal_curvature(const Surface_point& at, const Vec& direction) const;

  /// Nearest point of one face to p.
  [[nodiscard]] Surface_point locate(Face face, const Vec& p) const;

  /// Walks straight ahead over the unfolded faces, as far as `displacement` is long.
  [[nodiscard]] Walk walk(Surface_point from, Vec displacement) const;

  /// True if the interpolated normals agree on both sides of the edge.
  [[nodiscard]] bool crossable(Halfedge h) const;

  /// The border of the smooth surface from halfedge h of it on, forward or backward, while its vertices are nearer to
  /// `center` than `distance`; includes h.
  [[nodiscard]] std::vector<Halfedge> border_chain(Halfedge h, bool forward, const Vec& center, double distance) const;

  /// Identifies the smooth fan of faces around target(h) that face(h) belongs to.
  [[nodiscard]] Halfedge fan(Halfedge h) const;

 private:
  [[nodiscard]] bool sharp(Edge e) const;
  [[nodiscard]] bool steep(Edge e) const;
  [[nodiscard]] bool on_long_crease(Edge e) const;
  [[nodiscard]] Vec corner_normal(Halfedge h, int pass) const;
  [[nodiscard]] Vec normal_on_edge(const Edge_point& at, const std::vector<Halfedge>& corners) const;
  [[nodiscard]] Vec smoothed_normal(const std::vector<Halfedge>& corners, Halfedge id, int pass) const;
  Halfedge name_fan(const std::vector<Halfedge>& corners) const;
  [[nodiscard]] std::vector<Halfedge> fan_corners(Halfedge h) const;
  [[nodiscard]] Vec raw_normal(Face face) const;

  /// A side of a face and that of its neighbour; `blocked` is a sharp edge without one.
  struct Side {
    Face face;
    int opposite = -1;  ///< index of the neighbour's corner that faces the side
    Halfedge blocked;
  };
  struct Virtual_face {
    std::array<Side, 3> sides;
    Halfedge band;
  };
  [[nodiscard]] bool is_virtual(Face face) const { return face.idx() >= first_virtual_; }
  [[nodiscard]] Side across(const Surface_point& at, int exit) const;
  [[nodiscard]] Side across_band(Face face, int exit) const;
  [[nodiscard]] Side band_beyond(Halfedge h) const;
  [[nodiscard]] Side band_at_end(Halfedge h, bool at_target) const;
  [[nodiscard]] Halfedge next_on_border(Halfedge h, bool at_target) const;
  void extend_band(Face face, int exit, Halfedge h, bool at_target);
  [[nodiscard]] std::array<Face, 2> band(Halfedge h) const;
  Face add_virtual_face(const std::array<Vec, 3>& corner, const std::array<Vec, 3>& place,
                        const std::array<Vec, 3>& normal, const Vec& outward, Halfedge band) const;
  [[nodiscard]] int index_of(Halfedge h) const;

  const Blend_mesh& mesh_;
  Options options_;
  double cos_smooth_;
  const std::unordered_set<Edge>* creases_;
  const std::unordered_set<Face>* blends_;
  mutable std::unordered_map<std::uint32_t, Frame> frames_;
  mutable std::unordered_map<std::uint32_t, Halfedge> fans_;
  mutable std::unordered_map<std::uint32_t, bool> long_creases_;
  mutable std::unordered_map<std::uint64_t, Vec> normals_;
  std::uint32_t first_virtual_;
  mutable std::vector<Virtual_face> virtual_;
  std::unordered_map<std::uint32_t, Side> extension_beyond_;              // per sharp halfedge of the surface's side
  mutable std::unordered_map<std::uint32_t, std::array<Face, 2>> bands_;  // low and high, per smaller halfedge
};

}  // namespace cgal_blend

#endif
