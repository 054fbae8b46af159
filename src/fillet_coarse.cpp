// SPDX-License-Identifier: GPL-3.0-or-later
#include "fillet_coarse.h"

#include "coarse_level.h"
#include "fillet_in_passes.h"
#include "fillet_radius.h"
#include "mesh_checks.h"
#include "refusal.h"
#include "sharp_mesh.h"
#include "stitching.h"
#include "stopwatch.h"

#include <cgal_blend/curve_network.h>
#include <cgal_blend/validate.h>

#include <algorithm>
#include <set>
#include <unordered_set>
#include <utility>
#include <vector>

namespace cgal_blend {

namespace {

/// The body without removed elements, and its vertices there and back.
struct Compact {
  Blend_mesh mesh;
  std::vector<Vertex> vertex_of;  // indexed by vertex of the body
  std::vector<Vertex> body_of;    // indexed by vertex of `mesh`
};

Compact compact(const Blend_mesh& mesh) {
  Compact result;
  result.body_of.assign(mesh.vertices().begin(), mesh.vertices().end());
  result.mesh = reorder(mesh, result.body_of, {mesh.faces().begin(), mesh.faces().end()}).mesh;
  result.vertex_of.resize(mesh.number_of_vertices() + mesh.number_of_removed_vertices());
  for (std::size_t i = 0; i < result.body_of.size(); ++i)
    result.vertex_of[result.body_of[i].idx()] = Vertex(static_cast<std::uint32_t>(i));
  return result;
}

/// Curves of the blends, each with its edges on the compact mesh.
struct Curves {
  std::vector<std::vector<Edge>> edges;
  std::vector<Edge_blend> blends;      // without edges
  std::vector<Blend_report> reports;   // one per branch, those that are refused filled in
  std::vector<std::size_t> report_of;  // per curve
};

class Curve_collector {
 public:
  Curve_collector(const Fillet_body& body, const Sharp_mesh& sharp, const Compact& fine, const Fillet_options& options)
      : body_(body), sharp_(sharp), fine_(fine), options_(options) {}

  Curves collect(const std::vector<Edge_blend>& blends) {
    for (const Edge_blend& blend : blends) {
      const Radius_law law = radius_law_of(blend, options_);
      const Curve_network<Blend_mesh> network = make_curve_network(*body_.mesh, blend.edges);
      for (const Branch<Blend_mesh>& branch : network.branches) {
        Blend_report report;
        report.edges = branch.halfedges.size();
        report.closed = branch.closed();
        report.radius = law.largest();
        std::vector<Edge> edges;
        report.diagnosis = add(branch, edges);
        if (report.diagnosis.ok()) {
          curves_.report_of.push_back(curves_.reports.size());
          curves_.edges.push_back(std::move(edges));
          curves_.blends.push_back({{}, law.largest(), blend.profile});
        }
        curves_.reports.push_back(std::move(report));
      }
    }
    return std::move(curves_);
  }

 private:
  /// The level decimates closed curves that have no vertex in common.
  Diagnosis add(const Branch<Blend_mesh>& branch, std::vector<Edge>& edges) {
    const Vec at = to_vec(body_.mesh->point(body_.mesh->source(branch.halfedges.front())));
    if (!branch.closed()) return refusal(Status::open_branch, at);
    const std::vector<Vertex> chain = sharp_.curve(*body_.mesh, branch.halfedges);
    if (chain.size() < 3) return refusal(Status::region_not_annular, at);
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const Vertex a = fine_.vertex_of[chain[i].idx()], b = fine_.vertex_of[chain[(i + 1) % chain.size()].idx()];
      if (!taken_.insert(a).second) return refusal(Status::blends_overlap, to_vec(fine_.mesh.point(a)));
      const Halfedge h = fine_.mesh.halfedge(a, b);
      if (h == Blend_mesh::null_halfedge()) return refusal(Status::region_not_annular, to_vec(fine_.mesh.point(a)));
      edges.push_back(fine_.mesh.edge(h));
    }
    return {};
  }

  const Fillet_body& body_;
  const Sharp_mesh& sharp_;
  const Compact& fine_;
  const Fillet_options& options_;
  std::unordered_set<Vertex> taken_;
  Curves curves_;
};

/// `ok` if there is something to blend: every curve, or one at least if the others may stay sharp.
Diagnosis first_refusal(const std::vector<Blend_report>& reports, bool keep_going) {
  if (reports.empty()) return {Status::no_edges_selected, "", {}, {}};
  const auto is_ok = [](const Blend_report& report) { return report.diagnosis.ok(); };
  if (keep_going && std::any_of(reports.begin(), reports.end(), is_ok)) return {};
  const auto refused = std::find_if_not(reports.begin(), reports.end(), is_ok);
  return refused != reports.end() ? refused->diagnosis : Diagnosis();
}

/// The decimated curve has another length, and other vertices to start from.
Diagnosis check_radius(const Edge_blend& blend, const Fillet_options& options) {
  const Radius_law law = radius_law_of(blend, options);
  if (Diagnosis bad = law.check(); !bad.ok()) return bad;
  if (law.is_constant()) return {};
  return {Status::not_supported, "a radius that varies along the curve, with a coarse level", {}, {}};
}

// Slivers that a boolean leaves along its curve are thinner than the coarse curve is exact; they may fold when the
// detail is restored. Then the corners of faces that cross are smoothed, in ever wider rings.
constexpr int untangle_rounds = 24;
constexpr int rounds_per_ring = 6;
constexpr int smoothing_steps = 2;

/// Laplacian steps on some vertices.
void smooth(const std::set<Vertex>& vertices, Blend_mesh& mesh) {
  for (int step = 0; step < smoothing_steps; ++step) {
    std::vector<Point_3> next;
    for (const Vertex v : vertices) {
      Vec sum = to_vec(mesh.point(v));
      int count = 1;
      for (const Vertex w : mesh.vertices_around_target(mesh.halfedge(v))) {
        sum += to_vec(mesh.point(w));
        ++count;
      }
      next.push_back(to_point(sum / count));
    }
    std::size_t i = 0;
    for (const Vertex v : vertices) mesh.point(v) = next[i++];
  }
}

/// Moves vertices among `movable` until no two faces of theirs cross, or for some rounds.
/// \return milliseconds spent on looking for faces that cross
double untangle(const std::vector<Vertex>& movable, Blend_mesh& mesh) {
  const std::set<Vertex> may_move(movable.begin(), movable.end());
  std::set<Face> changed;
  for (const Vertex v : movable)
    for (const Face f : mesh.faces_around_target(mesh.halfedge(v))) changed.insert(f);
  internal::Face_table table;
  for (const Face f : mesh.faces()) {
    const Halfedge h = mesh.halfedge(f);
    table.faces.push_back(f);
    table.triangles.push_back({mesh.source(h).idx(), mesh.target(h).idx(), mesh.target(mesh.next(h)).idx()});
  }
  double checking = 0;
  for (int round = 0; round < untangle_rounds; ++round) {
    std::set<Vertex> bad;
    const Stopwatch watch;
    const auto pairs = internal::intersecting_pairs(mesh, table, {changed.begin(), changed.end()});
    checking += watch.milliseconds();
    for (const auto& [f, g] : pairs)
      for (const Face face : {f, g})
        for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(face)))
          if (may_move.count(v)) bad.insert(v);
    if (bad.empty()) break;
    for (int ring = 0; ring < round / rounds_per_ring; ++ring)
      for (const Vertex v : std::vector<Vertex>(bad.begin(), bad.end()))
        for (const Vertex w : mesh.vertices_around_target(mesh.halfedge(v)))
          if (may_move.count(w)) bad.insert(w);
    smooth(bad, mesh);
    changed.clear();  // all others are in order
    for (const Vertex v : bad)
      for (const Face f : mesh.faces_around_target(mesh.halfedge(v))) changed.insert(f);
  }
  return checking;
}

Fillet_outcome refused(Diagnosis diagnosis, const Stage_times& times, std::vector<Blend_report> reports) {
  Fillet_outcome outcome;
  outcome.diagnosis = std::move(diagnosis);
  outcome.blends = std::move(reports);
  outcome.times = times;
  return outcome;
}

}  // namespace

Fillet_outcome fillet_coarse(const Fillet_body& body, const std::vector<Edge_blend>& blends, Blend_mesh& out,
                             const Fillet_options& options) {
  Stage_times times;
  for (const Edge_blend& blend : blends)
    if (Diagnosis bad = check_radius(blend, options); !bad.ok()) return refused(std::move(bad), times, {});
  const Stopwatch copying;
  Sharp_mesh sharp(body);
  const Compact fine = compact(sharp.mesh);
  times.copy = copying.milliseconds();
  Curves curves = Curve_collector(body, sharp, fine, options).collect(blends);
  if (Diagnosis bad = first_refusal(curves.reports, options.keep_going); !bad.ok())
    return refused(std::move(bad), times, std::move(curves.reports));
  const Stopwatch coarsening;
  const Validity_report validity = validate(fine.mesh);
  if (!validity.ok()) return refused(refusal_of_result(validity.diagnosis), times, std::move(curves.reports));
  const Coarse_level level(fine.mesh, curves.edges, options.coarse_faces);
  Diagnosis bad = validate(level.mesh()).diagnosis;
  times.coarsen = coarsening.milliseconds();
  if (!bad.ok()) {
    bad.status = Status::region_too_coarse;
    bad.detail = "the decimated mesh is not valid; ask for more coarse faces";
    return refused(std::move(bad), times, std::move(curves.reports));
  }

  Fillet_body coarse;
  coarse.mesh = coarse.base[0] = coarse.base[1] = &level.mesh();
  std::vector<Edge_blend> coarse_blends = curves.blends;
  for (std::size_t i = 0; i < coarse_blends.size(); ++i) coarse_blends[i].edges = level.curves()[i];
  Blend_mesh blended;
  const Fillet_outcome outcome = fillet_in_passes(coarse, coarse_blends, blended, options);
  times.blend = outcome.times.blend;
  for (std::size_t i = 0; i < outcome.blends.size() && i < curves.report_of.size(); ++i) {
    Blend_report& report = curves.reports[curves.report_of[i]];
    const std::size_t edges = report.edges;
    report = outcome.blends[i];
    report.edges = edges;  // of the fine curve
  }
  if (!outcome.ok()) return refused(outcome.diagnosis, times, std::move(curves.reports));
  const Stopwatch restoring;
  Blend_mesh restored = fine.mesh;
  std::vector<Vertex> moved;
  for (const auto& [v, to] : level.restore(blended)) {
    restored.point(v) = to;
    moved.push_back(v);
  }
  const double checking = untangle(moved, restored);
  Body_changes changes;
  for (const Vertex v : moved) {
    changes.moved.push_back(fine.body_of[v.idx()]);
    sharp.mesh.point(changes.moved.back()) = restored.point(v);
  }
  times.blend += restoring.milliseconds() - checking;
  times.validate += checking;
  Fillet_outcome whole = finish_body(body, sharp.mesh, changes, out);
  times.copy += whole.times.copy;
  times.validate += whole.times.validate;
  whole.blends = std::move(curves.reports);
  whole.blend_faces = whole.changed_faces;
  whole.times = times;
  if (!whole.ok()) {
    whole.diagnosis = refusal_of_result(whole.diagnosis);
    out.clear();
  }
  return whole;
}

}  // namespace cgal_blend
