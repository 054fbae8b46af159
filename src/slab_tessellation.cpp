// SPDX-License-Identifier: GPL-3.0-or-later
#include "slab_tessellation.h"

#include "implicit_remeshing.h"
#include "mesh_checks.h"
#include "ring_strips.h"
#include "slab_lattice.h"
#include "slab_sizing.h"
#include "slab_verification.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>

namespace cgal_blend {

namespace {

constexpr double growth = 0.35;                      // of facets with the distance from finer ones
constexpr double decline = 0.7;                      // from coarser ones
constexpr double off_surface = 0.02;                 // of the edge length wanted
constexpr int attempts = 3;                          // each with cells half as wide and half as near the planes
constexpr std::size_t most_cells_again = 30'000;     // of all later ones
constexpr std::size_t most_cells_finer = 150'000;    // of one that confirms the topology
constexpr std::size_t most_vertices_again = 60'000;  // of a mesh, for another attempt
constexpr int rounds = 5;                            // of halving facets where they cut through each other
constexpr int attempts_to_reach = 2;                 // where a piece of surface does not lead to the other side

std::size_t ring_vertices(const Hermite_transition& psi, std::size_t side) {
  std::size_t count = 0;
  for (const Ring& ring : psi.rings(side)) count += ring.size();
  return count;
}

/// Vertices by the piece of surface they belong to.
class Pieces {
 public:
  explicit Pieces(const Joined_rings& joined) : parent_(joined.points.size()) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    for (const auto& [a, b, c] : joined.triangles) {
      parent_[of(a)] = of(b);
      parent_[of(b)] = of(c);
    }
  }
  std::size_t of(std::size_t v) {
    while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
    return v;
  }

 private:
  std::vector<std::size_t> parent_;
};

/// Drops what no ring bounds; returns a vertex of a ring whose piece does not lead to the other side.
std::optional<std::size_t> keep_joined(Joined_rings& joined, std::size_t lower, std::size_t rings) {
  Pieces pieces(joined);
  std::vector<unsigned> reached(joined.points.size(), 0);
  for (std::size_t v = 0; v < rings; ++v) reached[pieces.of(v)] |= v < lower ? 1U : 2U;
  for (std::size_t v = 0; v < rings; ++v)
    if (reached[pieces.of(v)] != 3) return v;
  auto& triangles = joined.triangles;
  triangles.erase(
      std::remove_if(triangles.begin(), triangles.end(), [&](const auto& t) { return reached[pieces.of(t[0])] == 0; }),
      triangles.end());
  return std::nullopt;
}

/// Nothing if the triangles are no 2-manifold.
std::optional<Blend_mesh> mesh_of(const Joined_rings& joined) {
  Blend_mesh mesh;
  mesh.reserve(static_cast<Blend_mesh::size_type>(joined.points.size()),
               static_cast<Blend_mesh::size_type>(joined.points.size() + joined.triangles.size()),
               static_cast<Blend_mesh::size_type>(joined.triangles.size()));
  for (const Point_3& p : joined.points) mesh.add_vertex(p);
  for (const auto& [a, b, c] : joined.triangles)
    if (mesh.add_face(Vertex(static_cast<unsigned>(a)), Vertex(static_cast<unsigned>(b)),
                      Vertex(static_cast<unsigned>(c))) == Blend_mesh::null_face())
      return std::nullopt;
  for (const Vertex v : mesh.vertices())
    if (mesh.is_isolated(v)) mesh.remove_vertex(v);
  return mesh;
}

class Tessellator {
 public:
  Tessellator(const Hermite_transition& psi, const Slab_options& options)
      : psi_(psi),
        options_(options),
        cells_(psi, options, cell_growth, cell_growth, 1),
        facets_(psi, options, growth, decline, 0),
        lower_(ring_vertices(psi, 0)),
        rings_(lower_ + ring_vertices(psi, 1)) {}

  Slab_tessellation run() {
    Slab_tessellation result;
    for (int attempt = 0, round = 0; attempt < attempts;) {
      std::optional<Blend_mesh> mesh = coarse_mesh(result.diagnosis);
      if (exhausted_ || (short_of_other_side_ && attempt + 1 >= attempts_to_reach)) return result;
      const bool large = mesh && mesh->number_of_vertices() > most_vertices_again;
      if (mesh && !remesh(*mesh)) {
        result.diagnosis = {Status::cancelled, "", std::nullopt, std::nullopt};
        return result;
      }
      if (mesh && good(*mesh, result.diagnosis)) {
        write(*mesh, result);
        return result;
      }
      if (large) return result;
      if (mesh && ++round % rounds != 0) continue;
      refine_everywhere();
      ++attempt;
    }
    return result;
  }

 private:
  void refine_everywhere() {
    contour_.fineness *= 2;
    contour_.gap /= 2;
    cells_.forget_halvings();
    facets_.forget_halvings();
  }

  /// The surface from the rings of one side to those of the other.
  std::optional<Joined_rings> joined_contour(const Slab_sizing& cells, const Contour_options& options,
                                             Diagnosis& diagnosis) {
    short_of_other_side_ = false;
    const auto refuse = [&](const std::optional<Point_3>& where, const char* why) {
      diagnosis = {Status::openings_not_joined, why, where, std::nullopt};
      return std::nullopt;
    };
    const Slab_contour contour = contour_slab(psi_, cells, options);
    exhausted_ = contour.exhausted;
    cells_marched_ = contour.cells;
    if (exhausted_) return refuse(contour.escape, "the transition needs too many facets for its walls or gaps");
    if (contour.escape) return refuse(contour.escape, "the transition leaves the space between the openings");
    Joined_rings joined = join_rings(psi_, contour);
    if (joined.gap) return refuse(joined.gap, "no transition leaves this ring");
    if (const auto v = keep_joined(joined, lower_, rings_)) {
      short_of_other_side_ = true;
      return refuse(joined.points[*v], "the transition from this ring does not reach the other side");
    }
    return joined;
  }

  /// A finer attempt that takes too much leaves the diagnosis of the coarser one.
  std::optional<Blend_mesh> coarse_mesh(Diagnosis& diagnosis) {
    const Diagnosis before = diagnosis;
    const std::optional<Joined_rings> joined = joined_contour(cells_, contour_, diagnosis);
    contour_.most_cells = std::min(contour_.most_cells, most_cells_again + (before.ok() ? cells_marched_ : 0));
    contour_.most_cells -= std::min(contour_.most_cells, cells_marched_);
    if (exhausted_ && !before.ok()) diagnosis = before;
    if (!joined) return std::nullopt;
    std::optional<Blend_mesh> mesh = mesh_of(*joined);
    if (!mesh) diagnosis = {Status::blend_folds, "the transition touches itself", joined->points.front(), std::nullopt};
    return mesh;
  }

  /// True if a finer contour has the characteristic found.
  bool confirmed(long found) {
    for (const double finer : {1.5, 2.0}) {
      Contour_options options = contour_;
      options.fineness *= finer;
      options.most_cells = most_cells_finer;
      options.topology_only = true;
      Diagnosis unused;
      const std::optional<Joined_rings> joined = joined_contour(cells_, options, unused);
      exhausted_ = short_of_other_side_ = false;
      if (joined && euler_characteristic(joined->triangles) == found) return true;
    }
    return false;
  }

  bool remesh(Blend_mesh& mesh) const {
    Remeshing_target target;
    target.function = [this](const Point_3& p) { return psi_(p); };
    target.size = [this](const Point_3& p) { return facets_(p); };
    target.zmax = psi_.height();
    target.least_angle = options_.least_angle;
    target.progress = options_.progress;
    return remesh_implicit(mesh, target);
  }

  /// Where facets cut through each other, or a vertex found no surface near it, walls or gaps are thinner than cells and
  /// facets: both are made smaller there.
  bool good(const Blend_mesh& mesh, Diagnosis& diagnosis) {
    std::vector<Point_3> places;
    for (const auto& pair : internal::intersecting_pairs(mesh)) places.push_back(internal::meeting_point(mesh, pair));
    diagnosis = {};
    if (!places.empty())
      diagnosis = {Status::blend_folds, "the transition crosses itself; a finer edge or another implicit form may help",
                   places.front(), std::nullopt};
    for (const Vertex v : mesh.vertices())
      if (v.idx() >= rings_ && std::abs(psi_(mesh.point(v))) > off_surface * facets_(mesh.point(v)))
        places.push_back(mesh.point(v));
    if (diagnosis.ok() && !places.empty())
      diagnosis = {Status::blend_folds, "walls or gaps are too thin; a finer edge or another implicit form may help",
                   places.front(), std::nullopt};
    if (places.empty()) places = unconfirmed(mesh, diagnosis);
    for (const Point_3& p : places) {
      cells_.halve_at(p);
      facets_.halve_at(p);
    }
    return places.empty();
  }

  /// The doubtful places, unless a finer contour, or the last one, coarser at such places, confirms the topology.
  std::vector<Point_3> unconfirmed(const Blend_mesh& mesh, Diagnosis& diagnosis) {
    std::vector<Point_3> places = doubtful_places(psi_, mesh);
    const long found = static_cast<long>(mesh.number_of_vertices()) - static_cast<long>(mesh.number_of_edges()) +
                       static_cast<long>(mesh.number_of_faces());
    if (places.empty() || unconfirmed_ == found || confirmed(found)) return {};
    unconfirmed_ = found;
    diagnosis = {Status::blend_folds,
                 "tunnels or necks are too narrow to tell; a finer edge or another implicit form may help",
                 places.front(), std::nullopt};
    return places;
  }

  static void write(const Blend_mesh& mesh, Slab_tessellation& result) {
    for (const Vertex v : mesh.vertices()) result.points.push_back(mesh.point(v));
    for (const Face f : mesh.faces()) {
      const Halfedge h = mesh.halfedge(f);
      result.triangles.push_back({mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))});
    }
  }

  const Hermite_transition& psi_;
  const Slab_options& options_;
  Slab_sizing cells_, facets_;
  std::size_t lower_, rings_;  ///< numbers of vertices
  bool short_of_other_side_ = false;
  bool exhausted_ = false;
  std::optional<long> unconfirmed_;  ///< characteristic of the last mesh with doubtful places
  std::size_t cells_marched_ = 0;    ///< by the last contour
  Contour_options contour_;          ///< with the cells left to this and further attempts
};

}  // namespace

Slab_tessellation tessellate_slab(const Hermite_transition& psi, const Slab_options& options) {
  return Tessellator(psi, options).run();
}

}  // namespace cgal_blend
