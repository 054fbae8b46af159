// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_checks.h"

#include <CGAL/Side_of_triangle_mesh.h>

#include <algorithm>
#include <numeric>

namespace cgal_blend::internal {

namespace {

/// Disjoint sets with path halving; the root is the least member.
class Disjoint_sets {
 public:
  explicit Disjoint_sets(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0u); }

  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void join(std::uint32_t i, std::uint32_t j) {
    i = root(i);
    j = root(j);
    if (i < j)
      parent_[j] = i;
    else
      parent_[i] = j;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

void label_faces(const Blend_mesh& mesh, const Face_table& table, Components& components) {
  Disjoint_sets sets(mesh.num_faces());
  for (const Edge e : mesh.edges()) {
    const Face f = mesh.face(mesh.halfedge(e, 0)), g = mesh.face(mesh.halfedge(e, 1));
    if (f != Blend_mesh::null_face() && g != Blend_mesh::null_face()) sets.join(f, g);
  }
  constexpr auto none = static_cast<std::uint32_t>(-1);
  components.of_face.assign(mesh.num_faces(), none);
  for (const Face f : table.faces) {
    std::uint32_t& label = components.of_face[sets.root(f)];  // of the least face, which comes first
    if (label == none) label = static_cast<std::uint32_t>(components.count++);
    components.of_face[f] = label;
  }
}

}  // namespace

Components find_components(const Blend_mesh& mesh, const Face_table& table) {
  Components components;
  label_faces(mesh, table, components);
  std::vector<long double> sum(components.count, 0);
  std::vector<const Point_3*> origin(components.count, nullptr);  // near the piece, or far away pieces lose all digits
  for (std::size_t i = 0; i < table.faces.size(); ++i) {
    const std::uint32_t c = components.of_face[table.faces[i]];
    const Triangle& t = table.triangles[i];
    if (!origin[c]) origin[c] = &mesh.point(Vertex(t[0]));
    const Vector_3 p = mesh.point(Vertex(t[0])) - *origin[c], q = mesh.point(Vertex(t[1])) - *origin[c],
                   r = mesh.point(Vertex(t[2])) - *origin[c];
    sum[c] += CGAL::determinant(p, q, r);
  }
  for (const long double six_volumes : sum) components.volume.push_back(static_cast<double>(six_volumes / 6));
  return components;
}

namespace {

struct Piece {
  std::vector<Face> faces;  ///< that have an area
  CGAL::Bbox_3 box;
  Point_3 point;  ///< any of its points
};

std::vector<Piece> split(const Blend_mesh& mesh, const Face_table& table, const Components& components) {
  std::vector<Piece> pieces(components.count);
  for (std::size_t i = 0; i < table.faces.size(); ++i) {
    Piece& piece = pieces[components.of_face[table.faces[i]]];
    const Point_3 corner[] = {mesh.point(Vertex(table.triangles[i][0])), mesh.point(Vertex(table.triangles[i][1])),
                              mesh.point(Vertex(table.triangles[i][2]))};
    for (const Point_3& p : corner) piece.box += p.bbox();
    piece.point = corner[0];
    if (!CGAL::collinear(corner[0], corner[1], corner[2])) piece.faces.push_back(table.faces[i]);
  }
  return pieces;
}

bool contains(const CGAL::Bbox_3& outer, const CGAL::Bbox_3& inner) {
  for (int k = 0; k < 3; ++k)
    if (inner.min(k) < outer.min(k) || inner.max(k) > outer.max(k)) return false;
  return true;
}

bool is_vouched_for(std::size_t component, const Orientation_doubts& doubts) {
  return !doubts.vouched_for.empty() && doubts.vouched_for[component] != 0;
}

/// Per piece: how many others enclose it. Only a piece whose box holds another's needs a search tree.
std::vector<int> nesting_depths(const Blend_mesh& mesh, const std::vector<Piece>& pieces,
                                const Orientation_doubts& doubts) {
  using Side_test = CGAL::Side_of_triangle_mesh<Blend_mesh, Kernel>;
  std::vector<int> depth(pieces.size(), 0);
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const Piece& outer = pieces[k];
    std::vector<std::size_t> candidates;
    const auto crosses = [&](std::size_t i) {
      const auto [low, high] = std::minmax(i, k);
      return doubts.crossing.count({static_cast<std::uint32_t>(low), static_cast<std::uint32_t>(high)}) != 0;
    };
    for (std::size_t i = 0; i < pieces.size(); ++i)
      if (i != k && !is_vouched_for(i, doubts) && contains(outer.box, pieces[i].box) && !crosses(i))
        candidates.push_back(i);
    if (candidates.empty() || outer.faces.empty()) continue;
    Side_test::AABB_tree tree(outer.faces.begin(), outer.faces.end(), mesh);
    const Side_test side(tree);
    for (const std::size_t i : candidates)
      if (side(pieces[i].point) == CGAL::ON_BOUNDED_SIDE) ++depth[i];
  }
  return depth;
}

}  // namespace

std::size_t misoriented_component(const Blend_mesh& mesh, const Face_table& table, const Components& components,
                                  const Orientation_doubts& doubts) {
  bool any = false;
  for (std::size_t c = 0; c < components.count; ++c) any = any || !is_vouched_for(c, doubts);
  if (!any) return components.count;
  std::vector<int> depth(components.count, 0);
  if (components.count > 1) depth = nesting_depths(mesh, split(mesh, table, components), doubts);
  for (std::size_t c = 0; c < components.count; ++c)
    if (!is_vouched_for(c, doubts) && (components.volume[c] > 0) != (depth[c] % 2 == 0)) return c;
  return components.count;
}

}  // namespace cgal_blend::internal
