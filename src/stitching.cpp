// SPDX-License-Identifier: GPL-3.0-or-later
#include "stitching.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace cgal_blend {

namespace {

std::uint64_t key(Vertex a, Vertex b) { return (static_cast<std::uint64_t>(a.idx()) << 32) | b.idx(); }

class Replacer {
 public:
  Replacer(Blend_mesh& mesh, const std::vector<Triangle>& triangles) : mesh_(mesh), triangles_(triangles) {}

  Replacement run(const std::vector<Face>& removed) {
    take_out(removed);
    Replacement result;
    for (const Triangle& t : triangles_) {
      const auto face = put_in(t);
      if (!face) break;
      result.faces.push_back(*face);
    }
    result.conflict = conflict_;
    if (!conflict_) result.conflict = check();
    if (!result.conflict) remove_unused();
    return result;
  }

 private:
  /// Removes the faces and the edges between them; the other edges wait for a new face on their open side.
  void take_out(const std::vector<Face>& removed) {
    const std::unordered_set<Face> gone(removed.begin(), removed.end());
    std::vector<Edge> inner;
    for (const Face f : removed)
      for (const Halfedge h : mesh_.halfedges_around_face(mesh_.halfedge(f))) {
        touched_.push_back(mesh_.target(h));
        if (!gone.count(mesh_.face(mesh_.opposite(h))))
          open_.emplace(key(mesh_.source(h), mesh_.target(h)), h);
        else if (h < mesh_.opposite(h))
          inner.push_back(mesh_.edge(h));
      }
    for (const auto& [k, h] : open_) mesh_.set_face(h, Blend_mesh::null_face());
    for (const Face f : removed) mesh_.remove_face(f);
    for (const Edge e : inner) mesh_.remove_edge(e);
  }

  /// The halfedge from a to b: that of an open edge, or one half of a new edge.
  std::optional<Halfedge> directed(Vertex a, Vertex b) {
    const auto found = open_.find(key(a, b));
    if (found != open_.end()) {
      const Halfedge h = found->second;
      open_.erase(found);
      return h;
    }
    if (!used_.insert(key(a, b)).second) return std::nullopt;
    const Halfedge h = mesh_.add_edge(a, b);
    used_.insert(key(a, b));
    open_.emplace(key(b, a), mesh_.opposite(h));
    return h;
  }

  std::optional<Face> put_in(const Triangle& t) {
    std::array<Halfedge, 3> h;
    for (int i = 0; i < 3; ++i) {
      const auto side = directed(t[i], t[(i + 1) % 3]);
      if (!side || t[i] == t[(i + 1) % 3]) {
        conflict_ = t[i];
        return std::nullopt;
      }
      h[i] = *side;
    }
    const Face face = mesh_.add_face();
    mesh_.set_halfedge(face, h[0]);
    for (int i = 0; i < 3; ++i) {
      mesh_.set_face(h[i], face);
      mesh_.set_next(h[i], h[(i + 1) % 3]);
      mesh_.set_halfedge(t[(i + 1) % 3], h[i]);
      corners_.push_back(h[i]);
    }
    return face;
  }

  /// No side may stay open, and around each vertex the new corners must form one umbrella with the kept ones.
  [[nodiscard]] std::optional<Vertex> check() const {
    if (!open_.empty()) return mesh_.target(open_.begin()->second);
    std::unordered_set<Halfedge> reached;
    std::unordered_set<Vertex> walked;
    for (const Halfedge h : corners_) {
      const Vertex v = mesh_.target(h);
      if (walked.insert(v).second) {
        const Halfedge start = mesh_.halfedge(v);
        Halfedge g = start;
        do {
          reached.insert(g);
          g = mesh_.opposite(mesh_.next(g));
        } while (g != start);
      }
      if (!reached.count(h)) return v;
    }
    for (const Vertex v : touched_) {  // kept faces around a vertex that no new face touches would hang on it
      const Halfedge h = mesh_.halfedge(v);
      if (!walked.count(v) && !mesh_.is_removed(mesh_.edge(h)) && mesh_.target(h) == v &&
          mesh_.face(h) != Blend_mesh::null_face() && !mesh_.is_removed(mesh_.face(h)))
        return v;
    }
    return std::nullopt;
  }

  void remove_unused() {
    std::unordered_set<Vertex> in_use;
    for (const Triangle& t : triangles_) in_use.insert(t.begin(), t.end());
    std::sort(touched_.begin(), touched_.end());
    touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
    for (const Vertex v : touched_)
      if (!in_use.count(v)) mesh_.remove_vertex(v);
  }

  Blend_mesh& mesh_;
  const std::vector<Triangle>& triangles_;
  std::unordered_map<std::uint64_t, Halfedge> open_;
  std::unordered_set<std::uint64_t> used_;
  std::vector<Vertex> touched_;
  std::vector<Halfedge> corners_;
  std::optional<Vertex> conflict_;
};

}  // namespace

Replacement replace_faces(Blend_mesh& mesh, const std::vector<Face>& removed, const std::vector<Triangle>& triangles) {
  mesh.set_recycle_garbage(false);
  return Replacer(mesh, triangles).run(removed);
}

Reordered reorder(const Blend_mesh& mesh, const std::vector<Vertex>& vertices, const std::vector<Face>& faces) {
  Reordered result;
  Blend_mesh& out = result.mesh;
  out.reserve(static_cast<Blend_mesh::size_type>(vertices.size()), static_cast<Blend_mesh::size_type>(mesh.number_of_edges()),
              static_cast<Blend_mesh::size_type>(faces.size()));
  std::vector<Vertex> vertex_of(mesh.number_of_vertices() + mesh.number_of_removed_vertices());
  std::vector<Halfedge> halfedge_of(2 * (mesh.number_of_edges() + mesh.number_of_removed_edges()));
  result.face_of.resize(mesh.number_of_faces() + mesh.number_of_removed_faces());
  for (const Vertex v : vertices) vertex_of[v.idx()] = out.add_vertex(mesh.point(v));
  // Edges in the order of the faces: corefinement leaves them in an order that depends on addresses.
  for (const Face f : faces)
    for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      if (halfedge_of[h.idx()].is_valid()) continue;
      const Halfedge g = out.add_edge(vertex_of[mesh.source(h).idx()], vertex_of[mesh.target(h).idx()]);
      halfedge_of[h.idx()] = g;
      halfedge_of[mesh.opposite(h).idx()] = out.opposite(g);
    }
  for (const Face f : faces) {
    const Face g = out.add_face();
    result.face_of[f.idx()] = g;
    out.set_halfedge(g, halfedge_of[mesh.halfedge(f).idx()]);
    for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      const Halfedge moved = halfedge_of[h.idx()];
      out.set_face(moved, g);
      out.set_next(moved, halfedge_of[mesh.next(h).idx()]);
      out.set_halfedge(vertex_of[mesh.target(h).idx()], moved);
    }
  }
  return result;
}

}  // namespace cgal_blend
