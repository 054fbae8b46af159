// SPDX-License-Identifier: GPL-3.0-or-later
#include "coarse_level.h"

#include "decimation.h"
#include "stopwatch.h"

#include <cgal_blend/curve_network.h>

#include <Eigen/Dense>

#include <algorithm>

namespace cgal_blend {

namespace {

constexpr int longest_walk = 32;

Vertex_chain chain_of(const std::vector<Edge>& edges, const Blend_mesh& mesh) {
  const Curve_network<Blend_mesh> network = make_curve_network(mesh, edges);
  CGAL_precondition(network.branches.size() == 1);
  const Branch<Blend_mesh>& branch = network.branches.front();
  Vertex_chain chain;
  chain.closed = branch.closed();
  for (const Halfedge h : branch.halfedges) chain.vertices.push_back(mesh.source(h));
  if (!chain.closed) chain.vertices.push_back(mesh.target(branch.halfedges.back()));
  return chain;
}

std::vector<Edge> edges_of(const Vertex_chain& chain, const Blend_mesh& mesh) {
  std::vector<Edge> edges;
  const std::size_t n = chain.vertices.size();
  for (std::size_t i = 0; i < (chain.closed ? n : n - 1); ++i) {
    const Halfedge h = mesh.halfedge(chain.vertices[i], chain.vertices[(i + 1) % n]);
    CGAL_assertion(h != Blend_mesh::null_halfedge());
    edges.push_back(mesh.edge(h));
  }
  return edges;
}

std::vector<bool> marks(const std::vector<std::vector<Edge>>& curves, const Blend_mesh& mesh) {
  std::vector<bool> on_curve(mesh.num_edges(), false);
  for (const std::vector<Edge>& curve : curves)
    for (const Edge e : curve) on_curve[e] = true;
  return on_curve;
}

/// Numbers the pieces into which curves cut a mesh; indexed by face.
std::vector<int> patches(const Blend_mesh& mesh, const std::vector<bool>& on_curve) {
  std::vector<int> patch(mesh.num_faces(), -1);
  std::vector<Face> front;
  int count = 0;
  for (const Face seed : mesh.faces()) {
    if (patch[seed] >= 0) continue;
    patch[seed] = count;
    front.push_back(seed);
    while (!front.empty()) {
      const Face f = front.back();
      front.pop_back();
      for (const Halfedge h : halfedges_of(f, mesh)) {
        const Face next = mesh.face(mesh.opposite(h));
        if (patch[next] >= 0 || on_curve[mesh.edge(h)]) continue;
        patch[next] = count;
        front.push_back(next);
      }
    }
    ++count;
  }
  return patch;
}

/// Position of the point of the line through a and b nearest to p: 0 at a, 1 at b, and kept between.
double along(const Vec& a, const Vec& b, const Vec& p) {
  return std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
}

/// Columns: along a side of the facet, across, and the normal.
Eigen::Matrix3d frame(const Phong_facet& facet, const Vec& bary, int side) {
  const Vec normal = facet.unit_normal(bary);
  const Vec edge = facet.corner[(side + 1) % 3] - facet.corner[side];
  const Vec tangent = (edge - edge.dot(normal) * normal).normalized();
  Eigen::Matrix3d axes;
  axes << tangent, normal.cross(tangent), normal;
  return axes;
}

bool same(const Phong_facet& a, const Phong_facet& b) { return a.corner == b.corner && a.normal == b.normal; }

}  // namespace

/// Finds the places of the fine vertices; lives for one construction.
class Detail_encoder {
 public:
  Detail_encoder(const Blend_mesh& fine, const std::vector<std::vector<Edge>>& fine_curves,
                 const Decimated_mesh& decimated, Coarse_level& level)
      : fine_(fine), decimated_(decimated), level_(level), coarse_(level.mesh_), on_fine_curve_(fine.num_vertices()) {
    fine_patch_ = patches(fine, marks(fine_curves, fine));
    for (const Face f : decimated.fine_face) patch_.push_back(fine_patch_[f]);
  }

  void encode(const std::vector<Vertex_chain>& fine_chains) {
    for (const Vertex_chain& chain : fine_chains) encode_curve(chain);
    for (const Vertex v : fine_.vertices()) {
      if (is_common(v))
        level_.common_.push_back({v, decimated_.merged_into[v]});
      else if (!on_fine_curve_[v])
        level_.details_.push_back(encode_vertex(v));
    }
  }

 private:
  using Detail = Coarse_level::Detail;

  [[nodiscard]] bool is_common(Vertex v) const { return decimated_.origin[decimated_.merged_into[v]] == v; }
  [[nodiscard]] Vec fine_point(Vertex v) const { return to_vec(fine_.point(v)); }

  /// Vertices between two that are left lie on the edge between these.
  void encode_curve(const Vertex_chain& chain) {
    const std::size_t n = chain.vertices.size();
    for (const Vertex v : chain.vertices) on_fine_curve_[v] = true;
    std::size_t first = 0;
    while (!is_common(chain.vertices[first])) ++first;
    std::size_t last = first;
    for (std::size_t i = first + 1; i < (chain.closed ? first + n + 1 : n); ++i) {
      if (!is_common(chain.vertices[i % n])) continue;
      const Halfedge h = coarse_.halfedge(decimated_.merged_into[chain.vertices[last % n]],
                                          decimated_.merged_into[chain.vertices[i % n]]);
      for (std::size_t k = last + 1; k < i; ++k) encode_on_curve(chain.vertices[k % n], h);
      last = i;
    }
  }

  void encode_on_curve(Vertex v, Halfedge h) {
    Detail detail{v, coarse_.face(h), {}, {}, 0, true};
    const auto sides = halfedges_of(detail.face, coarse_);
    detail.side = static_cast<int>(std::find(sides.begin(), sides.end(), h) - sides.begin() + 2) % 3;
    put_on_side(detail, fine_point(v));
    level_.details_.push_back(displaced(detail));
  }

  /// Sets the barycentric coordinates to the point nearest on the side.
  void put_on_side(Detail& detail, const Vec& p) const {
    const Phong_facet facet = level_.facet(detail, coarse_, *level_.normals_);
    const int next = (detail.side + 1) % 3;
    const double t = along(facet.corner[detail.side], facet.corner[next], p);
    detail.bary = Vec::Zero();
    detail.bary[detail.side] = 1 - t;
    detail.bary[next] = t;
  }

  [[nodiscard]] Detail displaced(Detail detail) const {
    const Phong_facet facet = level_.facet(detail, coarse_, *level_.normals_);
    detail.displacement =
        frame(facet, detail.bary, detail.side).transpose() * (fine_point(detail.fine) - facet.point(detail.bary));
    return detail;
  }

  /// Projects along the interpolated normals: walks over the coarse mesh, starting near the vertex that v went into, and
  /// never across a curve.
  [[nodiscard]] Detail encode_vertex(Vertex v) const {
    const Vec p = fine_point(v);
    const Detail nearest = nearest_face(v, p);
    Detail detail = nearest;
    Face from = Blend_mesh::null_face();
    for (int step = 0; step < longest_walk; ++step) {
      const Phong_facet facet = level_.facet(detail, coarse_, *level_.normals_);
      const std::optional<Vec> foot = facet.foot(p, facet.nearest(p));
      if (!foot) break;
      int corner = 0;
      detail.bary = *foot;
      if (foot->minCoeff(&corner) >= 0) return displaced(detail);
      const int side = (corner + 1) % 3;
      const Halfedge h = halfedges_of(detail.face, coarse_)[(side + 1) % 3];
      const Face next = coarse_.face(coarse_.opposite(h));
      if (level_.on_curve_[coarse_.edge(h)] || next == from) {
        detail.side = side;
        put_on_side(detail, p);
        return displaced(detail);
      }
      from = std::exchange(detail.face, next);
    }
    return displaced(nearest);
  }

  /// Goes from face to face as long as one comes nearer, among those of the patch of v.
  [[nodiscard]] Detail nearest_face(Vertex v, const Vec& p) const {
    const int patch = fine_patch_[fine_.face(fine_.halfedge(v))];
    Detail best{v, Blend_mesh::null_face(), {}, {}, 0, false};
    double distance = -1;
    const auto look_around = [&](Vertex centre, bool any) {
      for (const Face f : coarse_.faces_around_target(coarse_.halfedge(centre))) {
        if (!any && patch_[f] != patch) continue;
        Detail here{v, f, {}, {}, 0, false};
        const Phong_facet facet = level_.facet(here, coarse_, *level_.normals_);
        here.bary = facet.nearest(p);
        const Vec q = here.bary[0] * facet.corner[0] + here.bary[1] * facet.corner[1] + here.bary[2] * facet.corner[2];
        const double d = (p - q).squaredNorm();
        if (distance >= 0 && d >= distance) continue;
        distance = d;
        best = here;
      }
    };
    look_around(decimated_.merged_into[v], false);
    if (distance < 0) look_around(decimated_.merged_into[v], true);
    for (Face from; from != best.face;) {
      from = best.face;
      for (const Halfedge h : halfedges_of(from, coarse_)) look_around(coarse_.target(h), false);
    }
    return best;
  }

  const Blend_mesh& fine_;
  const Decimated_mesh& decimated_;
  Coarse_level& level_;
  const Blend_mesh& coarse_;
  std::vector<bool> on_fine_curve_;
  std::vector<int> fine_patch_, patch_;
};

Coarse_level::Coarse_level(const Blend_mesh& fine, const std::vector<std::vector<Edge>>& curves, std::size_t faces) {
  Stopwatch decimation;
  std::vector<Vertex_chain> chains;
  for (const std::vector<Edge>& curve : curves) chains.push_back(chain_of(curve, fine));
  Decimated_mesh decimated = decimate(fine, chains, faces);
  mesh_ = std::move(decimated.mesh);
  for (const Vertex_chain& chain : decimated.curves) curves_.push_back(edges_of(chain, mesh_));
  milliseconds_.decimation = decimation.milliseconds();

  Stopwatch encoding;
  on_curve_ = marks(curves_, mesh_);
  normals_.emplace(mesh_, on_curve_);
  Detail_encoder(fine, curves, decimated, *this).encode(chains);
  milliseconds_.encoding = encoding.milliseconds();
}

Phong_facet Coarse_level::facet(const Detail& detail, const Blend_mesh& positions,
                                const Corner_normals& normals) const {
  Phong_facet facet;
  const auto corners = halfedges_of(detail.face, mesh_);
  for (int i = 0; i < 3; ++i) {
    const Vertex v = mesh_.target(corners[i]);
    facet.corner[i] = to_vec(positions.point(v));
    facet.normal[i] = detail.on_curve ? normals.vertex(v) : normals.corner(corners[i]);
  }
  if (detail.on_curve) {  // the corner opposite plays no part
    const int opposite = (detail.side + 2) % 3;
    facet.corner[opposite] = facet.corner[detail.side];
    facet.normal[opposite] = facet.normal[detail.side];
  }
  return facet;
}

std::vector<std::pair<Vertex, Point_3>> Coarse_level::restore(const Blend_mesh& moved) const {
  CGAL_precondition(moved.num_vertices() == mesh_.num_vertices() && moved.num_faces() == mesh_.num_faces());
  const Corner_normals normals(*normals_, moved);
  std::vector<std::pair<Vertex, Point_3>> restored;
  for (const Common& c : common_)
    if (moved.point(c.coarse) != mesh_.point(c.coarse)) restored.emplace_back(c.fine, moved.point(c.coarse));
  for (const Detail& d : details_) {
    const Phong_facet now = facet(d, moved, normals);
    if (same(now, facet(d, mesh_, *normals_))) continue;
    const Vec point = now.point(d.bary) + frame(now, d.bary, d.side) * d.displacement;
    restored.emplace_back(d.fine, to_point(point));
  }
  std::sort(restored.begin(), restored.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  return restored;
}

}  // namespace cgal_blend
