// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_PASS_ENGINE_H
#define CGAL_BLEND_SRC_PASS_ENGINE_H

#include "blend_corners.h"
#include "blend_curve.h"
#include "fillet_engine.h"
#include "open_branch.h"
#include "resting_balls.h"
#include "rolling_ball.h"
#include "trim.h"
#include "virtual_surface.h"

#include <cgal_blend/curve_network.h>

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <tuple>
#include <unordered_set>
#include <utility>
#include <vector>

namespace cgal_blend {

/// Ways to see a rough surface as smooth, tried in turn. Whatever the normals are, the ball touches exactly; what suffers
/// is tangency to the facets, and that is reported.
struct Smoothing {
  double smooth_angle;     // at least this, degrees
  double shortest_crease;  // in radii
  int passes;              // over the normals
  double coarsening;       // of the steps between positions
};
inline constexpr std::array<Smoothing, 6> smoothings{
    {{0, 0, 0, 1}, {0, 2, 3, 1}, {50, 4, 6, 1.5}, {60, 6, 12, 2}, {75, 8, 24, 3}, {75, 12, 48, 4}}};

// Angles at open branches, degrees, as far as the options allow: where they end counts, so the strict view comes first.
inline constexpr std::array<double, 2> open_angles{25, 180};

/// Balls of a corner, by their index there, that a branch without edges runs between.
struct Between_balls {
  Vertex corner;
  std::array<std::size_t, 2> ball;
};

/// One branch on its way to becoming a blend.
struct Fillet_job {
  std::vector<Halfedge> halfedges;
  Blend_report report;
  Blend_curve curve;
  std::array<int, 2> operand{};
  std::size_t level = 0;    // of smoothing
  std::size_t attempt = 0;  // at mapping
  bool rolled = false;
  bool over_edges = false;  // the ball rolls on over sharp edges that bend towards it
  std::optional<Diagnosis> first_failure;
  std::optional<Radius_law> law;  // along the branch
  Profile profile;
  std::optional<Profile> own_profile;  // if it is not that of the options
  std::vector<Ball_position> positions;
  std::array<Rim, 2> rims;
  std::optional<Virtual_surface> surface;
  std::optional<Open_branch> open;
  std::array<Vertex, 2> ends;            // of an open branch
  bool waits = false;                    // for a later pass
  std::optional<Between_balls> between;  // a spine across a corner
  bool swallowed = false;                // by the balls at its ends, which leave nothing of it
};

struct Fillet_assembly {
  Diagnosis diagnosis;
  std::size_t blame = 0;  ///< job that the diagnosis is about
  Fillet_outcome outcome;
  Blend_mesh mesh;
  std::vector<Later_blend> later;
  std::vector<Later_blend::Step> creases;
  std::vector<Unfinished_corner> corners;
};

/// One pass of blends: edges become branches (prepare), branches wait or go first (pass_order), balls roll
/// (pass_rolling), the mesh is cut and sewn (pass_assembly), and what waits is told (pass_later).
class Pass_engine {
 public:
  /// \param thorough try every view of the surfaces
  Pass_engine(const Fillet_body& body, const Fillet_options& options, bool thorough = true,
              const Earlier_blends& earlier = {});
  Fillet_pass run(const std::vector<Edge_blend>& blends, Blend_mesh& out);

 private:
  // Preparation: from edges to curves with a base face on either side.

  Diagnosis prepare(const std::vector<Edge_blend>& blends);

  /// Decides which branches have to wait. Where one goes first, the others roll over its end.
  void set_order();

  /// Blends that would wait for each other for ever end flat at corners of four and more instead.
  void give_up_waiting_corners();

  /// Why the blends at a corner without balls at rest cannot be made one after the other; nothing if they can.
  [[nodiscard]] std::optional<Diagnosis> no_order(Vertex v, const Base_surface& surface) const;

  /// True if the faces left of two consecutive edges are one smooth surface there, and so are those right of them.
  static bool is_one_curve(const Base_surface& surface, Halfedge in, Halfedge out);
  [[nodiscard]] Halfedge into(const std::pair<std::size_t, int>& branch) const;

  /// Takes up the corners that an earlier pass has left: two branches and a blend that is there already.
  void resume_corners();

  /// A vertex as a point of a face that is of no blend.
  [[nodiscard]] Surface_point point_at(const Base_surface& surface, Vertex v) const;

  /// Where the ball at rest touches the faces between the two branches that are to come.
  [[nodiscard]] std::optional<Surface_point> third_foot(const Base_surface& surface, const Blend_corner& corner,
                                                        double radius) const;
  [[nodiscard]] Base_surface::Options open_surface_options(std::size_t level) const;
  static bool wants_the_same(const Edge_blend& a, const Edge_blend& b);

  /// Blends that meet and want the same are one, so that their curves run on into each other.
  [[nodiscard]] std::vector<Edge_blend> joined(const std::vector<Edge_blend>& blends) const;

  /// Branches between corners: where the faces on one side meet in a sharp edge, two edges are no one curve.
  [[nodiscard]] Curve_network<Blend_mesh> chain(const std::vector<Edge>& edges, double radius) const;
  [[nodiscard]] Base_surface::Options surface_options(const Smoothing& how, double radius) const;

  /// What no open branch can be, wherever it ends.
  [[nodiscard]] Diagnosis refuse_open(const Fillet_job& job) const;
  [[nodiscard]] Diagnosis node_refusal(const Curve_network<Blend_mesh>& network,
                                       const Branch<Blend_mesh>& branch) const;
  Diagnosis make_curve(Fillet_job& job) const;

  /// Signed bend of the last edge of a curve times its length, by the base faces: those of a boolean's result may be too
  /// thin to have a normal, and its edges too short to have a direction.
  [[nodiscard]] double bend_at(const Fillet_job& job, const Vec& edge) const;

  /// Where two consecutive edges of the curve border on base faces that meet in a sharp edge, three surfaces meet. Finds
  /// the nearest such place to `at`.
  [[nodiscard]] std::optional<Vec> find_corner(const Fillet_job& job, const Vec& at);
  const Base_surface& base_surface(const Fillet_job& job, int side);
  static void set_rolling(const Fillet_job& job, Base_surface::Options& options);

  /// How surfaces of jobs differ by `set_rolling`.
  static int kind_of_rolling(const Fillet_job& job) { return !job.over_edges ? 0 : job.curve.convex ? 1 : 2; }

  // Rolling, and what to do about failures.

  /// A smoother view would blur the round that is to be sharpened into the surfaces beyond it.
  [[nodiscard]] std::size_t levels_of(const Fillet_job& job) const;
  [[nodiscard]] bool is_cancelled() const { return options_.progress && !options_.progress(progress_); }
  Diagnosis roll_all();

  /// Where a face ends the ball may go on over its edge: along the edge, or to the face beyond.
  void roll_over_edges(Fillet_job& job, std::size_t index);
  Diagnosis roll(Fillet_job& job, std::size_t index);
  Diagnosis roll_to_ends(Fillet_job& job, std::size_t index);

  /// Finds out what an open branch runs into.
  void view_end_of(Fillet_job& job, std::size_t index, int end);

  /// The ball at rest that a branch ends at, or null.
  [[nodiscard]] const Blend_corner* ball_at(const Fillet_job& job, std::size_t index, int end) const;
  [[nodiscard]] double open_snap(double radius) const;

  /// Finds the balls at rest in all corners, and adds the branches between those of one corner.
  void rest_balls(const Base_surface& surface);

  /// Adds the branch between two balls of a corner; `like` is one of those that meet there.
  void add_spine(Vertex v, const Corner_balls& balls, const Corner_balls::Spine& spine,
                 const std::pair<std::size_t, int>& like);

  /// The refusal of a blend that is folded: by what joins a mended spine, or by rough surfaces.
  static Diagnosis folded(const Fillet_job& job, const Vec& at);
  Diagnosis lay_rims(Fillet_job& job, std::size_t index, const std::array<const Base_surface*, 2>& surfaces,
                     double snap) const;

  /// What comes too far off the ball, or leaves the surfaces at an angle, is no blend.
  Diagnosis judge(Fillet_job& job);

  /// What fails between the balls of a corner fails for the branches that meet there.
  void blame_edges();

  /// True if a branch is refused on which others count in a corner: these are to be looked at anew without it.
  [[nodiscard]] bool refused_at_corner() const;

  /// Gives a blend that did not fit another try on a smoother surface, or refuses it.
  Diagnosis escalate(std::size_t blame, const Diagnosis& diagnosis);

  /// The first failure is the one to tell: later ones come of ever cruder views. Failing at a corner has its own name;
  /// creases that are short against the ball make none.
  void refuse(Fillet_job& job);
  [[nodiscard]] Edge_blend blend_of(const Fillet_job& job) const;

  // Assembly of what waits.

  /// Joins two branches over the end of a blend between them. Where their radii differ, the radius changes on the way.
  static void join_over(const Point_3& corner, const std::vector<Later_blend::Step>& over,
                        const std::array<std::reference_wrapper<Later_blend>, 2>& both);

  /// The corner that a blend has passed, to be finished by the branches left and right of it.
  void add_unfinished(const Blend_mesh& work, std::size_t i, int end, const Strip_border& border,
                      const std::vector<Rim>& rims, Fillet_assembly& result) const;

  /// The edges of a branch as they are by now, cut where rims cross them; those that are gone are left out later.
  void add_later(const Blend_mesh& work, const Trimming& trimming,
                 const std::map<std::size_t, std::array<End_assembly, 2>>& ends, const std::vector<Rim>& rims,
                 Fillet_assembly& result) const;

  /// `ok` as long as something can be written: all blends, or some of them if that is wanted.
  Diagnosis first_refusal() const;

  // Assembly: cut, sew, put in order, check.

  Fillet_assembly assemble();

  /// Cuts the blend of an earlier pass where its ball is at rest.
  void add_chain(const Blend_corner& corner, std::vector<Rim>& cuts) const;

  /// Where blends meet in a corner their rims meet, in the contacts of the ball at rest there.
  void add_corner_vertices(Blend_mesh& work);
  void add_contacts(Blend_mesh& work, Blend_corner& corner) const;
  void share_corner_vertices(const Open_branch& branch, int side, Rim& rim) const;
  [[nodiscard]] static std::size_t place_in_corner(const Blend_corner& corner,
                                                   const std::pair<std::size_t, int>& branch);
  void stitch(Blend_mesh& work, const std::vector<Rim>& rims,
              const std::map<std::size_t, std::array<End_assembly, 2>>& ends, Trimming& trimming,
              Fillet_assembly& result);

  /// The parts of the balls at rest that are left between the strips.
  bool fill_corners(Blend_mesh& work, const std::map<std::size_t, std::array<End_assembly, 2>>& ends,
                    std::vector<Triangle>& triangles, Fillet_assembly& result);

  /// The arcs in which blends end at a ball at rest, one after the other; empty if not all are there.
  [[nodiscard]] std::vector<Vertex> loop_around(const Blend_corner& corner,
                                                const std::map<std::size_t, std::array<End_assembly, 2>>& ends) const;

  /// Moves the vertices that stitching would remove onto the blends.
  void map(const Blend_mesh& work, const Trimming& trimming, Fillet_assembly& result);

  /// Vertices of the body that no face that stays, and no remnant of one, has as a corner.
  [[nodiscard]] std::unordered_set<Vertex> vertices_between(const Blend_mesh& work, const Trimming& trimming) const;
  void finish(const Blend_mesh& work, const Body_changes& changes, Fillet_assembly& result);
  [[nodiscard]] std::size_t nearest_job(const Vec& at) const;

  Earlier_blends earlier_;
  std::unordered_set<Edge> creases_;  // those of earlier blends, and what is to be blended
  std::unordered_set<Face> blend_faces_;
  const Fillet_body& body_;
  const Fillet_options& options_;
  std::size_t levels_;
  double progress_ = 0;
  std::map<std::tuple<std::size_t, int, double, bool, int>, std::unique_ptr<Base_surface>> surfaces_;
  std::vector<Fillet_job> jobs_;
  std::map<Vertex, std::vector<std::pair<std::size_t, int>>> nodes_;  // branches and their ends, by vertex
  std::map<Vertex, Vertex> resumed_;  // ends of branches in corners of earlier passes: the key of these
  Resting_balls rest_;
  std::vector<Vertex> given_up_;                         // corners whose branches would wait for ever
  std::map<Vertex, std::vector<Blend_corner>> corners_;  // per corner a place for each of its balls
  Stage_times aside_;                                    // what is no part of blending, over all tries
};

}  // namespace cgal_blend

#endif
