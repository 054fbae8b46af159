// SPDX-License-Identifier: GPL-3.0-or-later
#include "fillet_coarse.h"

#include "coarse_level.h"
#include "fillet_engine.h"
#include "refusal.h"
#include "sharp_mesh.h"
#include "stitching.h"
#include "stopwatch.h"

#include <cgal_blend/curve_network.h>
#include <cgal_blend/validate.h>

#include <array>
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
// detail is restored. Then the rings of faces around the curve are smoothed, so many steps at a time.
constexpr std::array<int, 5> smoothings{0, 4, 8, 16, 32};
constexpr int smoothed_rings = 3;
constexpr double taubin_lambda = 0.5, taubin_mu = -0.53;

/// Taubin steps on the moved vertices near the curves.
void smooth_around(const std::vector<std::vector<Edge>>& curves, const Compact& fine, int steps,
                   const std::vector<Vertex>& moved, Blend_mesh& mesh) {
  const std::set<Vertex> movable(moved.begin(), moved.end());
  std::set<Vertex> near;
  for (const auto& curve : curves)
    for (const Edge e : curve)
      if (const Vertex v = fine.body_of[fine.mesh.source(fine.mesh.halfedge(e)).idx()]; movable.count(v))
        near.insert(v);
  for (int ring = 0; ring < smoothed_rings; ++ring)
    for (const Vertex v : std::vector<Vertex>(near.begin(), near.end()))
      for (const Vertex w : mesh.vertices_around_target(mesh.halfedge(v)))
        if (movable.count(w)) near.insert(w);
  for (int step = 0; step < steps; ++step)
    for (const double factor : {taubin_lambda, taubin_mu}) {
      std::vector<Point_3> next;
      for (const Vertex v : near) {
        Vec sum = Vec::Zero();
        int count = 0;
        for (const Vertex w : mesh.vertices_around_target(mesh.halfedge(v))) {
          sum += to_vec(mesh.point(w));
          ++count;
        }
        const Vec at = to_vec(mesh.point(v));
        next.push_back(to_point(at + factor * (sum / count - at)));
      }
      std::size_t i = 0;
      for (const Vertex v : near) mesh.point(v) = next[i++];
    }
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
  Stopwatch restoring;
  Body_changes changes;
  for (const auto& [v, to] : level.restore(blended)) {
    const Vertex moved = fine.body_of[v.idx()];
    sharp.mesh.point(moved) = to;
    changes.moved.push_back(moved);
  }
  times.blend += restoring.milliseconds();
  Fillet_outcome whole;
  for (std::size_t k = 0; k < smoothings.size(); ++k) {
    const Stopwatch smoothing;
    if (smoothings[k] > 0) smooth_around(curves.edges, fine, smoothings[k], changes.moved, sharp.mesh);
    times.blend += smoothing.milliseconds();
    whole = finish_body(body, sharp.mesh, changes, out);
    times.copy += whole.times.copy;
    times.validate += whole.times.validate;
    if (whole.ok()) break;
  }
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
