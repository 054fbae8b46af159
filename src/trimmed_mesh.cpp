// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/trimmed_surface.h>

#include "join_rows.h"

#include <limits>
#include <string>

namespace cgal_blend {

namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

class Mesh_part {
 public:
  Mesh_part(const Blend_mesh& mesh, const std::vector<std::vector<Vertex>>& chains)
      : mesh_(mesh),
        chains_(chains),
        kept_(mesh.number_of_faces() + mesh.number_of_removed_faces(), false),
        point_(mesh.number_of_vertices() + mesh.number_of_removed_vertices(), none),
        is_cut_(mesh.number_of_edges() + mesh.number_of_removed_edges(), false) {}

  Diagnosis run(const std::vector<Trim_curve>& curves, const Tessellation_options& options, Triangle_soup& soup,
                Rims& rims) {
    for (const Trim_curve& curve : curves)
      if (Diagnosis bad = join(curve); !bad.ok()) return bad;
    flood();
    for (const Face f : mesh_.faces())
      if (kept_[f]) add(f, options.part, soup);
    find_rims(rims);
    return {};
  }

 private:
  /// Takes over the vertices of the curve and cuts the mesh along it.
  Diagnosis join(const Trim_curve& curve) {
    if (curve.slot < 0 || static_cast<std::size_t>(curve.slot) >= chains_.size())
      return {Status::no_boundary_curve, "the mesh has no chain " + std::to_string(curve.slot), {}, {}};
    const std::vector<Vertex>& chain = chains_[static_cast<std::size_t>(curve.slot)];
    const Point_line line = ascending(curve);
    if (line.vertices.size() != chain.size())
      return {Status::no_boundary_curve, "the curve is not that of the chain of edges", {}, {}};
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const Halfedge h = mesh_.halfedge(chain[i], chain[(i + 1) % chain.size()]);
      if (h == Blend_mesh::null_halfedge())
        return {Status::no_such_edge, "vertices of a chain are not joined", mesh_.point(chain[i]), {}};
      if (mesh_.is_border(h))
        return {Status::no_boundary_curve, "there is no face on the left of a chain", mesh_.point(chain[i]), {}};
      point_[chain[i]] = line.vertices[i];
      is_cut_[mesh_.edge(h)] = true;
      stack_.push_back(mesh_.face(h));
    }
    return {};
  }

  void flood() {
    while (!stack_.empty()) {
      const Face f = stack_.back();
      stack_.pop_back();
      if (kept_[f]) continue;
      kept_[f] = true;
      for (const Halfedge h : mesh_.halfedges_around_face(mesh_.halfedge(f)))
        if (const Face g = mesh_.face(mesh_.opposite(h)); g != Blend_mesh::null_face() && !is_cut_[mesh_.edge(h)])
          stack_.push_back(g);
    }
  }

  void add(Face f, int part, Triangle_soup& soup) {
    std::array<std::size_t, 3> triangle{};
    std::size_t i = 0;
    for (const Vertex v : mesh_.vertices_around_face(mesh_.halfedge(f))) {
      if (point_[v] == none) point_[v] = soup.add(mesh_.point(v));
      triangle[i++] = point_[v];
    }
    soup.triangles.push_back(triangle);
    soup.parts.push_back(part);
  }

  /// Loops of border edges of the mesh beside kept faces that are not chains.
  void find_rims(Rims& rims) {
    std::vector<char> seen(2 * is_cut_.size(), false);
    for (const Halfedge start : mesh_.halfedges()) {
      if (!mesh_.is_border(start) || seen[start] || is_cut_[mesh_.edge(start)]) continue;
      if (!kept_[mesh_.face(mesh_.opposite(start))]) continue;
      std::vector<std::size_t> rim;
      for (Halfedge h = start; !seen[h]; h = mesh_.next(h)) {
        seen[h] = true;
        rim.push_back(point_[mesh_.target(h)]);
      }
      rims.push_back(std::move(rim));
    }
  }

  const Blend_mesh& mesh_;
  const std::vector<std::vector<Vertex>>& chains_;
  std::vector<char> kept_;
  std::vector<std::size_t> point_;  // of the soup, per vertex
  std::vector<char> is_cut_;
  std::vector<Face> stack_;
};

}  // namespace

Trimmed_surface trimmed_mesh(const Blend_mesh& mesh, const std::vector<std::vector<Vertex>>& chains) {
  return [mesh, chains](const std::vector<Trim_curve>& curves, const Tessellation_options& options, Triangle_soup& soup,
                        Rims& rims) { return Mesh_part(mesh, chains).run(curves, options, soup, rims); };
}

}  // namespace cgal_blend
