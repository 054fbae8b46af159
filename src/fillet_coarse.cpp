// SPDX-License-Identifier: GPL-3.0-or-later
#include "fillet_coarse.h"

#include "coarse_level.h"
#include "fillet_engine.h"
#include "mesh_checks.h"
#include "refusal.h"
#include "sharp_mesh.h"
#include "stitching.h"
#include "stopwatch.h"

#include <cgal_blend/curve_network.h>
#include <cgal_blend/validate.h>

#include <set>
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
  Diagnosis diagnosis;
  std::vector<std::vector<Edge>> edges;
  std::vector<Edge_blend> blends;  // without edges
};

Curves collect_curves(const Fillet_body& body, const Sharp_mesh& sharp, const Compact& fine,
                      const std::vector<Edge_blend>& blends) {
  Curves curves;
  for (const Edge_blend& blend : blends) {
    const Curve_network<Blend_mesh> network = make_curve_network(*body.mesh, blend.edges);
    for (const Branch<Blend_mesh>& branch : network.branches) {
      const Vertex first = body.mesh->source(branch.halfedges.front());
      if (!branch.closed()) {
        curves.diagnosis = refusal(Status::open_branch, to_vec(body.mesh->point(first)));
        return curves;
      }
      const std::vector<Vertex> chain = sharp.curve(*body.mesh, branch.halfedges);
      std::vector<Edge> edges;
      for (std::size_t i = 0; i < chain.size(); ++i) {
        const Vertex a = fine.vertex_of[chain[i].idx()], b = fine.vertex_of[chain[(i + 1) % chain.size()].idx()];
        const Halfedge h = fine.mesh.halfedge(a, b);
        if (h == Blend_mesh::null_halfedge()) {
          curves.diagnosis = refusal(Status::region_not_annular, to_vec(fine.mesh.point(a)));
          return curves;
        }
        edges.push_back(fine.mesh.edge(h));
      }
      curves.edges.push_back(std::move(edges));
      curves.blends.push_back({{}, blend.radius, blend.profile});
    }
  }
  if (curves.edges.empty()) curves.diagnosis.status = Status::no_edges_selected;
  return curves;
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

Fillet_outcome refused(Diagnosis diagnosis, const Stage_times& times) {
  Fillet_outcome outcome;
  outcome.diagnosis = std::move(diagnosis);
  outcome.times = times;
  return outcome;
}

}  // namespace

Fillet_outcome fillet_coarse(const Fillet_body& body, const std::vector<Edge_blend>& blends, Blend_mesh& out,
                             const Fillet_options& options) {
  Stage_times times;
  const Stopwatch copying;
  Sharp_mesh sharp(body);
  const Compact fine = compact(sharp.mesh);
  times.copy = copying.milliseconds();
  const Curves curves = collect_curves(body, sharp, fine, blends);
  if (!curves.diagnosis.ok()) return refused(curves.diagnosis, times);
  const Stopwatch coarsening;
  const Validity_report validity = validate(fine.mesh);
  if (!validity.ok()) return refused(refusal_of_result(validity.diagnosis), times);
  const Coarse_level level(fine.mesh, curves.edges, options.coarse_faces);
  Diagnosis bad = validate(level.mesh()).diagnosis;
  times.coarsen = coarsening.milliseconds();
  if (!bad.ok()) {
    bad.status = Status::region_too_coarse;
    bad.detail = "the decimated mesh is not valid; ask for more coarse faces";
    return refused(std::move(bad), times);
  }

  Fillet_body coarse;
  coarse.mesh = coarse.base[0] = coarse.base[1] = &level.mesh();
  std::vector<Edge_blend> coarse_blends = curves.blends;
  for (std::size_t i = 0; i < coarse_blends.size(); ++i) coarse_blends[i].edges = level.curves()[i];
  Blend_mesh blended;
  Fillet_outcome outcome = fillet_body(coarse, coarse_blends, blended, options);
  times.blend = outcome.times.blend;
  if (!outcome.ok()) {
    outcome.times = times;
    return outcome;
  }
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
  whole.blends = std::move(outcome.blends);
  whole.blend_faces = whole.changed_faces;
  whole.times = times;
  if (!whole.ok()) {
    whole.diagnosis = refusal_of_result(whole.diagnosis);
    out.clear();
  }
  return whole;
}

}  // namespace cgal_blend
