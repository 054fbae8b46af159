// SPDX-License-Identifier: GPL-3.0-or-later
#include "fillet_divided.h"

#include "fillet_radius.h"

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>
#include <unordered_set>
#include <utility>

namespace cgal_blend {

namespace {

/// One end of a part within an edge.
struct Cut {
  double at = 0;  // fraction of the edge along its first halfedge
  std::size_t part = 0;
  int end = 0;
  double snap = 0;  // length units

  bool operator<(const Cut& other) const { return std::tie(at, part, end) < std::tie(other.at, other.part, other.end); }
};

/// The same for both halfedges of an edge. An `Edge` remembers the halfedge that it was made from.
Halfedge first_of(const Blend_mesh& mesh, Halfedge h) { return std::min(h, mesh.opposite(h)); }

class Mesh_divider {
 public:
  Mesh_divider(const Blend_mesh& mesh, const std::vector<Edge_blend>& blends, const std::vector<Blend_part>& parts,
               const Fillet_options& options)
      : mesh_(mesh), blends_(blends), parts_(parts), options_(options) {}

  Divided_mesh run() {
    out_.mesh = mesh_;
    out_.origins.resize(mesh_.number_of_faces());
    std::iota(out_.origins.begin(), out_.origins.end(), 0u);
    out_.stations.assign(parts_.size(), {Blend_mesh::null_vertex(), Blend_mesh::null_vertex()});
    for (auto& [e, cuts] : cuts_of_edges()) divide(e, cuts);
    name_divided_faces();
    for (std::size_t i = 0; i < parts_.size(); ++i) add_blend(i);
    return std::move(out_);
  }

 private:
  [[nodiscard]] std::map<Edge, std::vector<Cut>> cuts_of_edges() const {
    std::map<Edge, std::vector<Cut>> cuts;
    for (std::size_t i = 0; i < parts_.size(); ++i)
      for (const int end : {0, 1}) {
        const Curve_station& s = parts_[i].ends[end];
        if (parts_[i].whole || parts_[i].left_sharp || s.part == 0) continue;
        const Halfedge h = parts_[i].curve[s.edge];
        const double at = first_of(mesh_, h) == h ? s.part : 1 - s.part;
        const double snap = snap_of_station * radius_law_of(blends_[parts_[i].blend], options_).largest();
        cuts[mesh_.edge(h)].push_back({at, i, end, snap});
      }
    for (auto& [e, of_edge] : cuts) std::sort(of_edge.begin(), of_edge.end());
    return cuts;
  }

  /// Cuts nearer to each other than both of them bear share one vertex.
  void divide(Edge e, const std::vector<Cut>& cuts) {
    const Halfedge h = first_of(mesh_, mesh_.halfedge(e));
    const Point_3 &a = mesh_.point(mesh_.source(h)), &b = mesh_.point(mesh_.target(h));
    const double length = std::sqrt(CGAL::squared_distance(a, b));
    std::vector<Vertex>& chain = chains_[e];
    chain = {mesh_.source(h)};
    const Cut* last = nullptr;
    for (const Cut& cut : cuts) {
      if (!last || (cut.at - last->at) * length >= std::min(cut.snap, last->snap)) {
        chain.push_back(divide(h, a + cut.at * (b - a)));
        out_.edge_points[chain.back()].part = cut.at;
        last = &cut;
      }
      out_.stations[cut.part][cut.end] = chain.back();
    }
    chain.push_back(mesh_.target(h));
    const auto step = [&](std::size_t k) { return out_.mesh.halfedge(chain[k], chain[k + 1]); };
    for (std::size_t k = 1; k + 1 < chain.size(); ++k) {
      Base_surface::Edge_point& point = out_.edge_points[chain[k]];
      point.first = step(0);
      point.into = step(k - 1);
      point.last = step(chain.size() - 2);
    }
  }

  /// Puts a vertex on an edge and joins it to the corners opposite; `h` is then what is left behind that vertex.
  Vertex divide(Halfedge h, const Point_3& point) {
    Blend_mesh& mesh = out_.mesh;
    const Halfedge before = CGAL::Euler::split_edge(h, mesh);
    mesh.point(mesh.target(before)) = point;
    for (const Halfedge into : {before, mesh.opposite(h)}) {
      out_.origins.push_back(out_.origins[mesh.face(into).idx()]);
      CGAL::Euler::split_face(into, mesh.next(mesh.next(into)), mesh);
    }
    return mesh.target(before);
  }

  void name_divided_faces() {
    std::vector<bool> is_divided(mesh_.number_of_faces(), false);
    for (std::size_t f = mesh_.number_of_faces(); f < out_.origins.size(); ++f) is_divided[out_.origins[f]] = true;
    for (const Face f : out_.mesh.faces())
      if (is_divided[out_.origins[f.idx()]]) out_.divided.push_back(f);
  }

  /// Vertices of an edge that may be divided, from the source of a halfedge of it to its target.
  [[nodiscard]] std::vector<Vertex> chain_of(Halfedge h) const {
    const auto found = chains_.find(mesh_.edge(h));
    if (found == chains_.end()) return {mesh_.source(h), mesh_.target(h)};
    std::vector<Vertex> chain = found->second;
    if (first_of(mesh_, h) != h) std::reverse(chain.begin(), chain.end());
    return chain;
  }

  [[nodiscard]] Vertex end_of(std::size_t i, int end) const {
    const Blend_part& part = parts_[i];
    const Curve_station& s = part.ends[end];
    if (s.part != 0) return out_.stations[i][end];
    return s.edge < part.curve.size() ? mesh_.source(part.curve[s.edge]) : mesh_.target(part.curve.back());
  }

  void add_blend(std::size_t i) {
    const Blend_part& part = parts_[i];
    if (part.left_sharp) return add_rest(part, {});
    Edge_blend& blend = out_.blends.emplace_back(blends_[part.blend]);
    std::vector<Edge> edges;
    if (part.whole) {
      for (const Edge e : blend.edges) append_pieces(chain_of(mesh_.halfedge(e)), edges);
      blend.edges = std::move(edges);
      return;
    }
    blend.from = 0;
    blend.to = 1;
    blend.start.reset();
    if (!radius_law_of(blend, options_).is_constant()) blend.start = end_of(i, 0);
    std::vector<Vertex> chain;
    for (std::size_t k = part.ends[0].edge; k <= part.ends[1].edge && k < part.curve.size(); ++k) {
      const std::vector<Vertex> more = chain_of(part.curve[k]);
      chain.insert(chain.end(), more.begin() + (chain.empty() ? 0 : 1), more.end());
    }
    const auto first = std::find(chain.begin(), chain.end(), end_of(i, 0));
    append_pieces({first, std::find(first + 1, chain.end(), end_of(i, 1)) + 1}, edges);
    add_rest(part, edges);
    blend.edges = std::move(edges);
  }

  void append_pieces(const std::vector<Vertex>& chain, std::vector<Edge>& edges) const {
    for (std::size_t k = 0; k + 1 < chain.size(); ++k)
      edges.push_back(out_.mesh.edge(out_.mesh.halfedge(chain[k], chain[k + 1])));
  }

  void add_rest(const Blend_part& part, const std::vector<Edge>& edges) {
    std::vector<Edge> all;
    for (const Halfedge h : part.curve) append_pieces(chain_of(h), all);
    const std::unordered_set<Edge> blended(edges.begin(), edges.end());
    std::copy_if(all.begin(), all.end(), std::back_inserter(out_.creases), [&](Edge e) { return !blended.count(e); });
  }

  const Blend_mesh& mesh_;
  const std::vector<Edge_blend>& blends_;
  const std::vector<Blend_part>& parts_;
  const Fillet_options& options_;
  std::map<Edge, std::vector<Vertex>> chains_;  // of divided edges, along their first halfedges
  Divided_mesh out_;
};

}  // namespace

Divided_mesh divide_at_stations(const Blend_mesh& mesh, const std::vector<Edge_blend>& blends,
                                const std::vector<Blend_part>& parts, const Fillet_options& options) {
  return Mesh_divider(mesh, blends, parts, options).run();
}

}  // namespace cgal_blend
