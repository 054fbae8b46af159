// SPDX-License-Identifier: GPL-3.0-or-later
#include "triangle_topology.h"

#include <algorithm>

namespace cgal_blend::internal {

namespace {

constexpr std::uint32_t none = Triangle_topology::none;

struct Edge_use {
  std::uint32_t far_vertex;  ///< the larger of the two vertex indices; the smaller one is the bucket
  std::uint32_t corner;
};

/// Uses of edges sorted into buckets by their smaller vertex: linear, unlike sorting all of them.
struct Edge_buckets {
  std::vector<std::uint32_t> begin;
  std::vector<Edge_use> uses;
};

std::uint32_t vertex_at(const std::vector<Triangle>& triangles, std::uint32_t corner) {
  return triangles[corner / 3][corner % 3];
}

Edge_buckets sort_edges(std::size_t vertex_count, const std::vector<Triangle>& triangles) {
  Edge_buckets buckets;
  buckets.begin.assign(vertex_count + 1, 0);
  const auto each_edge = [&](auto&& visit) {
    for (std::uint32_t f = 0; f < triangles.size(); ++f)
      for (std::uint32_t i = 0; i < 3; ++i) {
        const auto [low, high] = std::minmax({triangles[f][i], triangles[f][(i + 1) % 3]});
        visit(low, high, 3 * f + i);
      }
  };
  each_edge([&](std::uint32_t low, std::uint32_t, std::uint32_t) { ++buckets.begin[low + 1]; });
  for (std::size_t v = 0; v < vertex_count; ++v) buckets.begin[v + 1] += buckets.begin[v];
  buckets.uses.resize(3 * triangles.size());
  std::vector<std::uint32_t> fill(buckets.begin.begin(), buckets.begin.end() - 1);
  each_edge([&](std::uint32_t low, std::uint32_t high, std::uint32_t c) { buckets.uses[fill[low]++] = {high, c}; });
  for (std::size_t v = 0; v < vertex_count; ++v)
    std::sort(buckets.uses.begin() + buckets.begin[v], buckets.uses.begin() + buckets.begin[v + 1],
              [](const Edge_use& a, const Edge_use& b) {
                return a.far_vertex != b.far_vertex ? a.far_vertex < b.far_vertex : a.corner < b.corner;
              });
  return buckets;
}

void count(std::size_t& number, std::optional<std::uint32_t>& first, std::uint32_t where) {
  ++number;
  if (!first || where < *first) first = where;
}

/// Judges one edge by its uses [first, last), sorted by corner.
void judge_edge(const std::vector<Triangle>& triangles, const Edge_use* first, const Edge_use* last,
                Triangle_topology& t) {
  const std::uint32_t c = first->corner;
  if (last - first == 1) return count(t.border_edges, t.border_edge, c);
  if (last - first > 2) return count(t.crowded_edges, t.crowded_edge, c);
  const std::uint32_t d = first[1].corner;
  if (vertex_at(triangles, c) == vertex_at(triangles, d)) return count(t.misoriented_edges, t.misoriented_edge, c);
  t.twin[c] = d;
  t.twin[d] = c;
}

void judge_edges(std::size_t vertex_count, const std::vector<Triangle>& triangles, const std::vector<char>& judged,
                 Triangle_topology& t) {
  const Edge_buckets buckets = sort_edges(vertex_count, triangles);
  for (std::size_t v = 0; v < vertex_count; ++v) {
    const Edge_use* first = buckets.uses.data() + buckets.begin[v];
    const Edge_use* const end = buckets.uses.data() + buckets.begin[v + 1];
    while (first != end) {
      const Edge_use* last = first + 1;
      while (last != end && last->far_vertex == first->far_vertex) ++last;
      if (judged.empty() || judged[v] || judged[first->far_vertex]) judge_edge(triangles, first, last, t);
      first = last;
    }
  }
}

/// Number of corners met by turning about the vertex of a corner, both ways if a border stops the turn.
std::uint32_t fan_size(const Triangle_topology& t, std::uint32_t start) {
  std::uint32_t size = 1;
  std::uint32_t c = t.twin[previous_corner(start)];
  for (; c != none && c != start; c = t.twin[previous_corner(c)]) ++size;
  if (c == start) return size;
  for (c = t.twin[start]; c != none; c = t.twin[next_corner(c)]) ++size;
  return size;
}

void judge_vertices(std::size_t vertex_count, const std::vector<Triangle>& triangles, const std::vector<char>& judged,
                    Triangle_topology& t) {
  std::vector<std::uint32_t> valence(vertex_count, 0), some_corner(vertex_count, none);
  for (std::uint32_t c = 0; c < 3 * triangles.size(); ++c) {
    const std::uint32_t v = vertex_at(triangles, c);
    ++valence[v];
    some_corner[v] = c;
  }
  for (std::uint32_t v = 0; v < vertex_count; ++v) {
    if (valence[v] == 0 || (!judged.empty() && !judged[v])) continue;
    if (fan_size(t, some_corner[v]) != valence[v]) count(t.crowded_vertices, t.crowded_vertex, v);
  }
}

}  // namespace

Triangle_topology analyze_topology(std::size_t vertex_count, const std::vector<Triangle>& triangles,
                                   const std::vector<char>& judged) {
  Triangle_topology t;
  t.twin.assign(3 * triangles.size(), none);
  for (std::uint32_t f = 0; f < triangles.size(); ++f) {
    const Triangle& v = triangles[f];
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) count(t.repeated_corners, t.repeated_corner, f);
  }
  if (t.repeated_corner) return t;
  judge_edges(vertex_count, triangles, judged, t);
  if (!t.crowded_edge && !t.misoriented_edge) judge_vertices(vertex_count, triangles, judged, t);
  return t;
}

}  // namespace cgal_blend::internal
