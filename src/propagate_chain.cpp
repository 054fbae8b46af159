// SPDX-License-Identifier: GPL-3.0-or-later
#include "propagate_chain.h"

#include <cgal_blend/creases.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <unordered_set>
#include <utility>

namespace cgal_blend {

namespace {

constexpr double largest_turn = 25;  // degrees

using Edges = std::unordered_set<Edge>;

bool goes_straight_on(const Blend_mesh& mesh, Halfedge from, Halfedge to) {
  const auto direction = [&](Halfedge h) { return mesh.point(mesh.target(h)) - mesh.point(mesh.source(h)); };
  const Vector_3 a = direction(from), b = direction(to);
  const double cosine = a * b / std::sqrt(a.squared_length() * b.squared_length());
  return cosine > internal::cosine_of_degrees(largest_turn);
}

/// Where a chain that ends with a halfedge goes on. With one further crease at the vertex there is one way only, and the
/// faces on either side are smooth from the one edge to the other. A selected edge aside makes the vertex a junction.
std::optional<Halfedge> continuation(const Blend_mesh& mesh, Halfedge end, const Edges& selected, double smooth_angle) {
  std::optional<Halfedge> only;
  for (const Halfedge h : mesh.halfedges_around_target(end)) {
    if (h == end) continue;
    if (is_crease(mesh.edge(h), mesh, smooth_angle)) {
      if (only) return std::nullopt;
      only = mesh.opposite(h);
    } else if (selected.count(mesh.edge(h)) != 0) {
      return std::nullopt;
    }
  }
  if (!only || selected.count(mesh.edge(*only)) != 0) return std::nullopt;
  if (edge_convexity(mesh.edge(*only), mesh) != edge_convexity(mesh.edge(end), mesh)) return std::nullopt;
  return goes_straight_on(mesh, end, *only) ? only : std::nullopt;
}

/// True if the chain meets a selected edge at its end.
bool closes(const Blend_mesh& mesh, Halfedge end, const Edges& selected) {
  for (const Halfedge h : mesh.halfedges_around_target(end))
    if (h != end && selected.count(mesh.edge(h)) != 0) return true;
  return false;
}

void grow(const Blend_mesh& mesh, Halfedge end, Edge_blend& blend, Edges& selected, double smooth_angle) {
  const Vertex from = mesh.target(end);
  while (const std::optional<Halfedge> next = continuation(mesh, end, selected, smooth_angle)) {
    end = *next;
    selected.insert(mesh.edge(end));
    blend.edges.push_back(mesh.edge(end));
  }
  if (blend.start == from && !closes(mesh, end, selected)) blend.start = mesh.target(end);
}

}  // namespace

std::vector<Edge_blend> propagate_chains(const Blend_mesh& mesh, std::vector<Edge_blend> blends, double smooth_angle) {
  Edges selected;
  for (const Edge_blend& blend : blends) selected.insert(blend.edges.begin(), blend.edges.end());
  for (Edge_blend& blend : blends) {
    const std::vector<Edge> own = blend.edges;
    for (const Edge e : own)
      for (int side = 0; side < 2; ++side) grow(mesh, mesh.halfedge(e, side), blend, selected, smooth_angle);
  }
  return blends;
}

}  // namespace cgal_blend
