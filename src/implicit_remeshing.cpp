// SPDX-License-Identifier: GPL-3.0-or-later
#include "implicit_remeshing.h"

#include "implicit_projection.h"

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace cgal_blend {

namespace {

constexpr double longest = 4.0 / 3, shortest = 4.0 / 5;  // of the wanted length; Botsch and Kobbelt
constexpr double pi = 3.14159265358979323846;
constexpr double least_cosine = 0.2;  // of a face's normal with those at its vertices

class Remesher {
 public:
  Remesher(Blend_mesh& mesh, const Remeshing_target& target)
      : mesh_(mesh),
        target_(target),
        normal_(mesh.add_property_map<Vertex, Vector_3>("v:implicit_normal").first),
        size_(mesh.add_property_map<Vertex, double>("v:implicit_size").first),
        fixed_(mesh.add_property_map<Vertex, char>("v:implicit_fixed", 0).first) {
    prepare();
  }
  Remesher(const Remesher&) = delete;
  Remesher& operator=(const Remesher&) = delete;
  ~Remesher() {
    mesh_.remove_property_map(normal_);
    mesh_.remove_property_map(size_);
    mesh_.remove_property_map(fixed_);
  }

  bool run() {
    for (int round = 0; round < target_.rounds; ++round) {
      if (target_.progress && !target_.progress(static_cast<double>(round) / target_.rounds)) return false;
      split_long_edges();
      collapse_short_edges();
      flip(&Remesher::improves_valence);
      relax();
    }
    polish();
    mesh_.collect_garbage();
    return true;
  }

 private:
  using Corners = std::array<Point_3, 3>;

  // --- what is measured ---

  double length(Edge e) const {
    const Halfedge h = mesh_.halfedge(e);
    return std::sqrt(CGAL::squared_distance(mesh_.point(mesh_.source(h)), mesh_.point(mesh_.target(h))));
  }
  double ratio(Edge e) const {
    const Halfedge h = mesh_.halfedge(e);
    return 2 * length(e) / (size_[mesh_.source(h)] + size_[mesh_.target(h)]);
  }
  double ratio(Vertex v, Vertex w) const {
    return 2 * std::sqrt(CGAL::squared_distance(mesh_.point(v), mesh_.point(w))) / (size_[v] + size_[w]);
  }
  static Vector_3 normal_of(const Corners& c) { return CGAL::cross_product(c[1] - c[0], c[2] - c[0]); }

  /// Cosine between a face and the mean normal at its vertices; -1 for a face without area.
  static double uprightness(const Corners& c, const Vector_3& wanted) {
    const Vector_3 n = normal_of(c);
    const double product = std::sqrt(n.squared_length() * wanted.squared_length());
    return product > 0 ? n * wanted / product : -1;
  }
  double uprightness(Vertex a, Vertex b, Vertex c) const {
    return uprightness({mesh_.point(a), mesh_.point(b), mesh_.point(c)}, normal_[a] + normal_[b] + normal_[c]);
  }

  /// The least angle of a triangle by its cosine: the larger, the sharper.
  static double sharpness(const Corners& c) {
    double result = -1;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector_3 u = c[(i + 1) % 3] - c[i], v = c[(i + 2) % 3] - c[i];
      const double product = std::sqrt(u.squared_length() * v.squared_length());
      result = std::max(result, product > 0 ? u * v / product : 1);
    }
    return result;
  }
  double sharpness(Vertex a, Vertex b, Vertex c) const {
    return sharpness({mesh_.point(a), mesh_.point(b), mesh_.point(c)});
  }

  Corners corners(Face f) const {
    const Halfedge h = mesh_.halfedge(f);
    return {mesh_.point(mesh_.source(h)), mesh_.point(mesh_.target(h)), mesh_.point(mesh_.target(mesh_.next(h)))};
  }

  // --- normals and places ---

  void prepare() {
    for (const Vertex v : mesh_.vertices()) {
      fixed_[v] = mesh_.is_border(v);
      size_[v] = target_.size(mesh_.point(v));
    }
    update_normals();
    for (const Vertex v : mesh_.vertices()) {
      if (!fixed_[v]) continue;
      // A vertex of a ring has faces on one side only, and those of the first strip may lean.
      const Vector_3 g = gradient(target_.function, mesh_.point(v), 0.1 * size_[v], target_.zmin, target_.zmax);
      if (g.squared_length() > 0) normal_[v] = g / std::sqrt(g.squared_length());
    }
  }

  void update_normals() {
    for (const Vertex v : mesh_.vertices())
      if (!fixed_[v]) normal_[v] = CGAL::NULL_VECTOR;
    std::vector<Vector_3> sums(mesh_.num_vertices(), CGAL::NULL_VECTOR);
    for (const Face f : mesh_.faces()) {
      const Vector_3 n = normal_of(corners(f));
      for (const Vertex v : mesh_.vertices_around_face(mesh_.halfedge(f))) sums[v] += n;
    }
    for (const Vertex v : mesh_.vertices())
      if (!fixed_[v] && sums[v].squared_length() > 0) normal_[v] = sums[v] / std::sqrt(sums[v].squared_length());
  }

  /// The surface near a point along its vertex's normal, inside the slab.
  std::optional<Point_3> projected(const Point_3& p, const Vector_3& normal, double size) const {
    const auto q = project_along(target_.function, p, normal, size);
    const double margin = 0.02 * std::min(size, target_.zmax - target_.zmin);
    if (!q || q->z() <= target_.zmin + margin || q->z() >= target_.zmax - margin) return std::nullopt;
    return q;
  }

  /// True if all faces at a free vertex stand upright with it at `p`, or stand better than they do.
  bool may_move(Vertex v, const Point_3& p) const {
    for (const Halfedge h : CGAL::halfedges_around_target(v, mesh_)) {
      const Vertex a = mesh_.source(h), b = mesh_.target(mesh_.next(h));
      const Vector_3 wanted = normal_[v] + normal_[a] + normal_[b];
      const double now = uprightness({mesh_.point(v), mesh_.point(b), mesh_.point(a)}, wanted);
      if (uprightness({p, mesh_.point(b), mesh_.point(a)}, wanted) < std::min(least_cosine, now)) return false;
    }
    return true;
  }

  // --- operations ---

  template <class Wanted>
  std::vector<std::pair<double, Edge>> sorted_edges(const Wanted& wanted) const {
    std::vector<std::pair<double, Edge>> edges;
    for (const Edge e : mesh_.edges())
      if (const double r = ratio(e); wanted(r) && !mesh_.is_border(e)) edges.emplace_back(r, e);
    std::sort(edges.begin(), edges.end());
    return edges;
  }

  void split_long_edges() {
    for (int pass = 0; pass < 8; ++pass) {
      auto edges = sorted_edges([](double r) { return r > longest; });
      if (edges.empty()) return;
      std::reverse(edges.begin(), edges.end());
      for (const auto& [r, e] : edges)
        if (ratio(e) > longest && !beside_longer_border(e)) split(e);
    }
  }

  /// Splitting such an edge leaves the border with a flatter face, whose edges would be split again, without end.
  bool beside_longer_border(Edge e) const {
    const Halfedge h = mesh_.halfedge(e);
    for (const Halfedge g : {h, mesh_.opposite(h)})
      for (const Halfedge side : {mesh_.next(g), mesh_.prev(g)})
        if (mesh_.is_border(mesh_.edge(side)) && length(mesh_.edge(side)) > length(e)) return true;
    return false;
  }

  void split(Edge e) {
    const Halfedge h = mesh_.halfedge(e);
    const Vertex a = mesh_.source(h), b = mesh_.target(h);
    const Halfedge fresh = CGAL::Euler::split_edge(h, mesh_);
    const Vertex v = mesh_.target(fresh);
    mesh_.point(v) = CGAL::midpoint(mesh_.point(a), mesh_.point(b));
    const Vector_3 n = normal_[a] + normal_[b];
    normal_[v] = n.squared_length() > 0 ? n / std::sqrt(n.squared_length()) : normal_[a];
    fixed_[v] = 0;
    size_[v] = (size_[a] + size_[b]) / 2;
    CGAL::Euler::split_face(fresh, mesh_.next(mesh_.next(fresh)), mesh_);
    const Halfedge back = mesh_.opposite(h);
    CGAL::Euler::split_face(back, mesh_.next(mesh_.next(back)), mesh_);
    if (const auto p = projected(mesh_.point(v), normal_[v], size_[v]); p && may_move(v, *p)) {
      mesh_.point(v) = *p;
      size_[v] = target_.size(*p);
    }
  }

  void collapse_short_edges() {
    for (int pass = 0; pass < 8; ++pass) {
      std::size_t count = 0;
      for (const auto& [r, e] : sorted_edges([](double x) { return x < shortest; }))
        if (!mesh_.is_removed(e) && ratio(e) < shortest && try_collapse(e)) ++count;
      if (count == 0) return;
    }
  }

  bool try_collapse(Edge e) {
    const Halfedge h = mesh_.halfedge(e);
    return try_collapse(h) || try_collapse(mesh_.opposite(h));
  }

  /// Draws the source of a halfedge into its target.
  bool try_collapse(Halfedge h) {
    const Vertex v = mesh_.source(h);
    if (fixed_[v] || !may_collapse(h)) return false;
    CGAL::Euler::collapse_edge(mesh_.edge(h), mesh_);
    return true;
  }

  bool may_collapse(Halfedge h) const {
    const Vertex v = mesh_.source(h), w = mesh_.target(h);
    double sharpest_now = -1, sharpest_then = -1;
    for (const Halfedge g : CGAL::halfedges_around_source(v, mesh_)) {
      const Vertex a = mesh_.target(g), b = mesh_.target(mesh_.next(g));
      sharpest_now = std::max(sharpest_now, sharpness(v, a, b));
      if (a != w && ratio(a, w) > longest) return false;
      if (a == w || b == w) continue;
      if (chord(a, w) || chord(b, w)) return false;
      if (uprightness(w, a, b) < std::min(least_cosine, uprightness(v, a, b))) return false;
      sharpest_then = std::max(sharpest_then, sharpness(w, a, b));
    }
    return sharpest_then <= std::max(sharpest_now, sharp_limit) &&
           CGAL::Euler::does_satisfy_link_condition(mesh_.edge(h), mesh_);
  }

  /// True if an inner edge between the vertices would lie in the plane of the borders.
  bool chord(Vertex a, Vertex b) const { return fixed_[a] && fixed_[b] && mesh_.point(a).z() == mesh_.point(b).z(); }

  template <class Improves>
  std::size_t flip(const Improves& improves) {
    std::size_t count = 0;
    for (const Edge e : mesh_.edges()) {
      if (mesh_.is_border(e)) continue;
      const Halfedge h = mesh_.halfedge(e);
      if (!(this->*improves)(h) || !may_flip(h)) continue;
      CGAL::Euler::flip_edge(h, mesh_);
      ++count;
    }
    return count;
  }

  struct Diamond {
    Vertex a, b, c, d;  ///< edge a b, with c on its left and d on its right
  };
  Diamond diamond(Halfedge h) const {
    return {mesh_.source(h), mesh_.target(h), mesh_.target(mesh_.next(h)), mesh_.target(mesh_.next(mesh_.opposite(h)))};
  }

  bool may_flip(Halfedge h) const {
    const auto [a, b, c, d] = diamond(h);
    if (c == d || chord(c, d) || mesh_.halfedge(c, d) != Blend_mesh::null_halfedge()) return false;
    const double now = std::min(uprightness(a, b, c), uprightness(b, a, d));
    const double then = std::min(uprightness(c, d, b), uprightness(d, c, a));
    return then >= std::min(now, least_cosine) && then > 0;
  }

  bool improves_valence(Halfedge h) const {
    const auto [a, b, c, d] = diamond(h);
    const auto excess = [&](Vertex v, int change) {
      const int wanted = fixed_[v] ? 4 : 6, excess = static_cast<int>(mesh_.degree(v)) + change - wanted;
      return excess * excess;
    };
    const int now = excess(a, 0) + excess(b, 0) + excess(c, 0) + excess(d, 0);
    const int then = excess(a, -1) + excess(b, -1) + excess(c, 1) + excess(d, 1);
    return then < now && std::max(sharpness(c, d, b), sharpness(d, c, a)) <
                             std::max(sharp_limit, std::max(sharpness(a, b, c), sharpness(b, a, d)));
  }

  bool improves_angles(Halfedge h) const {
    const auto [a, b, c, d] = diamond(h);
    return std::max(sharpness(c, d, b), sharpness(d, c, a)) < std::max(sharpness(a, b, c), sharpness(b, a, d)) - 1e-9;
  }

  /// Moves free vertices towards the mean of their faces' centres, weighted by area over squared wanted length,
  /// within the tangent plane, and back to the surface.
  void relax() {
    for (const Vertex v : mesh_.vertices()) {
      if (fixed_[v]) continue;
      Vector_3 sum = CGAL::NULL_VECTOR, n = CGAL::NULL_VECTOR;
      double weights = 0;
      for (const Halfedge h : CGAL::halfedges_around_target(v, mesh_)) {
        const Vertex a = mesh_.source(h), b = mesh_.target(mesh_.next(h));
        const Vector_3 u = mesh_.point(b) - mesh_.point(v), w = mesh_.point(a) - mesh_.point(v);
        const Vector_3 area = CGAL::cross_product(u, w);
        const double size = size_[a] + size_[b] + size_[v];
        const double weight = std::sqrt(area.squared_length()) / (size * size);
        sum += weight / 3 * (u + w);
        n += area;
        weights += weight;
      }
      if (!(weights > 0) || !(n.squared_length() > 0)) continue;
      n = n / std::sqrt(n.squared_length());
      Vector_3 step = sum / weights;
      step = step - (step * n) * n;
      normal_[v] = n;
      move(v, step);
    }
  }

  void move(Vertex v, Vector_3 step) {
    for (int halving = 0; halving < 3; ++halving, step = step / 2) {
      const auto p = projected(mesh_.point(v) + step, normal_[v], size_[v]);
      if (!p || !may_move(v, *p)) continue;
      mesh_.point(v) = *p;
      size_[v] = target_.size(*p);
      return;
    }
  }

  /// Angles last: flips that make the sharpest of two faces less sharp, and moves, until none off the borders is too sharp.
  void polish() {
    const double limit = std::cos(target_.least_angle * pi / 180);
    for (int pass = 0; pass < 8 && (pass < 4 || sharpest_inside() > limit); ++pass) {
      while (flip(&Remesher::improves_angles) > mesh_.number_of_edges() / 1000) continue;
      relax();
    }
    flip(&Remesher::improves_angles);
  }

  double sharpest_inside() const {
    double result = -1;
    for (const Face f : mesh_.faces()) {
      const auto around = mesh_.vertices_around_face(mesh_.halfedge(f));
      if (std::none_of(around.begin(), around.end(), [&](Vertex v) { return fixed_[v] != 0; }))
        result = std::max(result, sharpness(corners(f)));
    }
    return result;
  }

  static constexpr double sharp_limit = 0.9848;  // cosine of 10 degrees: sharper faces are not made, only mended

  Blend_mesh& mesh_;
  const Remeshing_target& target_;
  Blend_mesh::Property_map<Vertex, Vector_3> normal_;
  Blend_mesh::Property_map<Vertex, double> size_;
  Blend_mesh::Property_map<Vertex, char> fixed_;
};

}  // namespace

bool remesh_implicit(Blend_mesh& mesh, const Remeshing_target& target) { return Remesher(mesh, target).run(); }

}  // namespace cgal_blend
