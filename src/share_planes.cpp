// SPDX-License-Identifier: GPL-3.0-or-later
#include "share_planes.h"

#include "elimination_order.h"
#include "flat_regions.h"
#include "near_faces.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>

namespace cgal_blend {

namespace {

using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Exact_vector = Exact_kernel::Vector_3;
using Exact_number = Exact_kernel::FT;

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

// Two planes that meet at a smaller angle do not say well where their line is. Sine.
constexpr double steep_enough = 0.17;
// Edges at a smaller angle are not said to cross. Sine.
constexpr double least_crossing = 1e-3;
// In units of the tolerance: how far points may be off a plane that several regions share, and how far a vertex may move
// that lies on planes at small angles.
constexpr double largest_misfit = 4, largest_move = 64;

/// A vertex of one of the bodies.
struct Place_of {
  int side;
  Vertex vertex;
  bool operator<(const Place_of& other) const { return side != other.side ? side < other.side : vertex < other.vertex; }
};

/// A plane that is meant as it stands, to the last bit.
struct Plane {
  Vec point, normal;  // of any length

  [[nodiscard]] double distance(const Point_3& p) const {
    return std::abs(normal.dot(to_vec(p) - point)) / normal.norm();
  }
};

struct Exact_plane {
  Exact_point point;
  Exact_vector normal;
};

/// Cuts the bits of a number off that others next to it do not have either.
double on_grid(double x, double step) { return std::nearbyint(x / step) * step; }

/// A point on up to three planes, near p: keeps as many coordinates of p as it can, so that the numbers stay short, and
/// those that make the others move least. Leaves out planes that turn out to depend on the others.
/// \param step coordinates that stay are multiples of it
Exact_point project(const Point_3& p, const std::vector<Exact_plane>& planes, double step) {
  struct Row {
    std::array<Exact_number, 3> factor;
    Exact_number right;
    double norm = 0;
    int column = 0;  // of the coordinate that the row gives
  };
  std::vector<Row> rows(planes.size());
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const auto& [q, normal] = planes[i];
    rows[i].factor = {normal.x(), normal.y(), normal.z()};
    rows[i].right = normal.x() * q.x() + normal.y() * q.y() + normal.z() * q.z();
    for (int j = 0; j < 3; ++j) rows[i].norm = std::max(rows[i].norm, std::abs(CGAL::to_double(normal[j])));
  }
  std::array<bool, 3> taken{};
  for (std::size_t i = 0; i < rows.size();) {
    double largest = -1;
    std::size_t pivot = i;
    for (std::size_t k = i; k < rows.size(); ++k)
      for (int j = 0; j < 3; ++j) {
        const double norm = rows[k].norm, size = norm > 0 ? std::abs(CGAL::to_double(rows[k].factor[j])) / norm : 0;
        if (taken[j] || size <= largest) continue;
        largest = size;
        pivot = k;
        rows[k].column = j;
      }
    std::swap(rows[i], rows[pivot]);
    const int column = rows[i].column;
    if (CGAL::is_zero(rows[i].factor[column])) {
      rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(i));
      continue;
    }
    taken[column] = true;
    for (std::size_t k = i + 1; k < rows.size(); ++k) {
      const Exact_number share = rows[k].factor[column] / rows[i].factor[column];
      for (int j = 0; j < 3; ++j) rows[k].factor[j] -= share * rows[i].factor[j];
      rows[k].right -= share * rows[i].right;
    }
    ++i;
  }
  std::array<Exact_number, 3> x;
  for (int j = 0; j < 3; ++j)
    if (!taken[j]) x[j] = rows.empty() ? p[j] : on_grid(p[j], step);
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    Exact_number right = row->right;
    for (int j = 0; j < 3; ++j)
      if (j != row->column) right -= row->factor[j] * x[j];
    x[row->column] = right / row->factor[row->column];
  }
  const Exact_point result(x[0], x[1], x[2]);
  CGAL::exact(result);
  return result;
}

Vec on_grid(const Vec& v, double step) {
  return v.unaryExpr([step](double x) { return on_grid(x, step); });
}

Vec unit_on_grid(const Vec& v) { return on_grid(v.normalized(), std::numeric_limits<double>::epsilon() / 2); }

/// A power of two about as large as the rounding of the coordinates, and so that differences need no more bits.
double step_of(double tolerance) { return std::exp2(std::floor(std::log2(tolerance / 16))); }

/// The plane through up to three points that is nearest to a given one.
Exact_plane through(const std::vector<Exact_point>& points, const Plane& fit) {
  const Exact_vector normal(fit.normal.x(), fit.normal.y(), fit.normal.z());
  if (points.empty()) return {{fit.point.x(), fit.point.y(), fit.point.z()}, normal};
  if (points.size() == 1) return {points[0], normal};
  const Exact_vector along = points[1] - points[0];
  if (points.size() == 2) return {points[0], along.squared_length() * normal - (along * normal) * along};
  return {points[0], CGAL::cross_product(along, points[2] - points[0])};
}

class Plane_sharing {
 public:
  Plane_sharing(const Blend_mesh& a, const Blend_mesh& b, double tolerance)
      : mesh_{&a, &b}, tolerance_(tolerance), regions_{Flat_regions(a, tolerance), Flat_regions(b, tolerance)} {}

  /// The planes of regions that are to be shared, and how many vertices each has.
  std::vector<std::pair<Vec, std::size_t>> directions() {
    find_contacts();
    if (!contradiction_) choose_planes();
    std::vector<std::pair<Vec, std::size_t>> result;
    for (const Plane& plane : planes_) result.emplace_back(plane.normal.normalized(), 0);
    if (!contradiction_)
      for (const std::size_t i : in_use_) result[plane_of(i)].second += region(nodes_[i]).vertices.size();
    return result;
  }

  std::optional<Shared_planes> run() {
    find_contacts();
    if (!contradiction_) choose_planes();
    if (!contradiction_) bind_to_planes();
    if (contradiction_) return std::nullopt;
    bind_to_lines();
    bind_crossings();
    return solve();
  }

 private:
  struct Touch {
    Place_of vertex;
    Halfedge edge;  // of the other body; null for the face
    Face face;
    bool operator<(const Touch& other) const {
      return std::tie(vertex, edge, face) < std::tie(other.vertex, other.edge, other.face);
    }
  };
  /// A region, and the set of coplanar regions that it belongs to, as in union-find.
  struct Node {
    int side;
    std::size_t region;
    std::size_t parent;
  };
  struct Place {
    std::array<Vertex, 2> vertex;  // null where the body has no vertex there
    Point_3 point;
  };

  [[nodiscard]] const Flat_region& region(const Node& node) const { return regions_[node.side][node.region]; }

  std::size_t node(int side, Face face) {
    const std::size_t r = regions_[side].region_of(face);
    auto& known = node_of_region_[side];
    if (known.size() <= r) known.resize(r + 1, none);
    if (known[r] == none) {
      known[r] = nodes_.size();
      nodes_.push_back({side, r, nodes_.size()});
    }
    return known[r];
  }

  std::size_t root(std::size_t i) {
    while (nodes_[i].parent != i) i = nodes_[i].parent = nodes_[nodes_[i].parent].parent;
    return i;
  }

  void find_contacts() {
    for (const auto& [f, g] : near_faces(*mesh_[0], *mesh_[1], tolerance_)) {
      if (nearly_coplanar(*mesh_[0], f, *mesh_[1], g, largest_misfit * tolerance_)) join_regions(f, g);
      for (const Halfedge h : mesh_[1]->halfedges_around_face(mesh_[1]->halfedge(g)))
        find_touch({1, mesh_[1]->target(h)}, f);
      for (const Halfedge h : mesh_[0]->halfedges_around_face(mesh_[0]->halfedge(f)))
        find_touch({0, mesh_[0]->target(h)}, g);
      find_crossings(f, g);
    }
  }

  /// Finds edges of two faces that meet inside both, at an angle.
  void find_crossings(Face f, Face g) {
    const Blend_mesh &a = *mesh_[0], &b = *mesh_[1];
    for (const Halfedge h : a.halfedges_around_face(a.halfedge(f)))
      for (const Halfedge k : b.halfedges_around_face(b.halfedge(g))) {
        const Vector_3 u = a.point(a.target(h)) - a.point(a.source(h)), v = b.point(b.target(k)) - b.point(b.source(k));
        const Vector_3 between = b.point(b.source(k)) - a.point(a.source(h)), across = CGAL::cross_product(u, v);
        const double height = between * across, size = across.squared_length();
        if (height * height > tolerance_ * tolerance_ * size) continue;
        if (!(size > least_crossing * least_crossing * u.squared_length() * v.squared_length())) continue;
        const double s = CGAL::cross_product(between, v) * across / size,
                     t = CGAL::cross_product(between, u) * across / size;
        const double margin_s = tolerance_ / std::sqrt(u.squared_length()),
                     margin_t = tolerance_ / std::sqrt(v.squared_length());
        if (s > margin_s && s < 1 - margin_s && t > margin_t && t < 1 - margin_t)
          crossings_.insert({a.halfedge(a.edge(h)), b.halfedge(b.edge(k))});
      }
  }

  /// The larger region says more about the plane than the smaller one; which one is larger depends on the direction.
  void join_regions(Face f, Face g) {
    const std::size_t i = node(0, f), j = node(1, g);
    if (root(i) == root(j)) return;
    const auto lies_on = [&](std::size_t of_points, std::size_t of_plane) {
      const Node& points = nodes_[of_points];
      const Fitted_plane& plane = region(nodes_[of_plane]).plane;
      return std::all_of(region(points).vertices.begin(), region(points).vertices.end(), [&](Vertex v) {
        return plane.distance(mesh_[points.side]->point(v)) <= largest_misfit * tolerance_;
      });
    };
    if (!lies_on(i, j) && !lies_on(j, i)) return;
    const std::size_t first = std::min(root(i), root(j)), second = std::max(root(i), root(j));
    nodes_[second].parent = first;
    in_use_.insert(i);
    in_use_.insert(j);
  }

  /// Finds out whether a vertex lies on a vertex, an edge or the inside of a face of the other body.
  void find_touch(Place_of p, Face face) {
    const Blend_mesh& other = *mesh_[1 - p.side];
    const Point_3& point = mesh_[p.side]->point(p.vertex);
    const double limit = tolerance_ * tolerance_;
    const Halfedge start = other.halfedge(face);
    const Point_3 &q = other.point(other.source(start)), &r = other.point(other.target(start)),
                  &s = other.point(other.target(other.next(start)));
    const Vector_3 normal = CGAL::cross_product(r - q, s - q);
    const double height = normal * (point - q);
    if (height * height > 16 * limit * normal.squared_length()) return;  // thin faces know their plane badly
    for (const Halfedge h : other.halfedges_around_face(start))
      if (CGAL::squared_distance(point, other.point(other.target(h))) <= limit) return note_common(p, other.target(h));
    bool inside = true;
    for (const Halfedge h : other.halfedges_around_face(start)) {
      const Point_3& from = other.point(other.source(h));
      const Vector_3 along = other.point(other.target(h)) - from, to = point - from;
      const double at = along * to, length = along.squared_length();
      const Vector_3 across = CGAL::cross_product(along, to);
      if (at > 0 && at < length && across.squared_length() <= limit * length) {
        touches_.insert({p, other.halfedge(other.edge(h)), Face()});
        return;
      }
      inside = inside && across * normal > 0;
    }
    if (inside && height * height <= limit * normal.squared_length()) touches_.insert({p, Halfedge(), face});
  }

  void note_common(Place_of p, Vertex other) {
    const Place_of q{1 - p.side, other};
    for (const auto& [from, to] : {std::pair(p, q), std::pair(q, p)}) {
      const auto [known, is_new] = partner_.emplace(from, to.vertex);
      if (!is_new && known->second != to.vertex) contradiction_ = true;
    }
  }

  [[nodiscard]] bool steep(std::size_t i, std::size_t j) const {
    return region(nodes_[i]).plane.normal.cross(region(nodes_[j]).plane.normal).norm() > steep_enough;
  }

  /// The regions left and right of an edge, the larger first.
  std::pair<std::size_t, std::size_t> sides(int side, Halfedge h) {
    std::size_t i = node(side, mesh_[side]->face(h)), j = node(side, mesh_[side]->face(mesh_[side]->opposite(h)));
    if (region(nodes_[j]).area_vector.norm() > region(nodes_[i]).area_vector.norm()) std::swap(i, j);
    return {i, j};
  }

  /// Regions whose planes have something to say: those with a counterpart in the other body, or touched by its vertices.
  void choose_planes() {
    for (const Touch& touch : touches_) {
      const int other = 1 - touch.vertex.side;
      if (touch.edge == Halfedge()) {
        in_use_.insert(node(other, touch.face));
        continue;
      }
      const auto [i, j] = sides(other, touch.edge);
      in_use_.insert(i);
      if (steep(i, j)) in_use_.insert(j);
    }
    std::map<std::size_t, std::vector<std::size_t>> members;
    for (const std::size_t i : in_use_) members[root(i)].push_back(i);
    for (const auto& [root_node, list] : members) {
      plane_of_root_[root_node] = planes_.size();
      planes_.push_back(fit(list));
      if (!fits(planes_.back(), list)) contradiction_ = true;
    }
  }

  [[nodiscard]] Plane fit(const std::vector<std::size_t>& list) {
    // A plane that is parallel to two axes to the last bit stays what it is.
    for (const std::size_t i : list)
      for (int axis = 0; axis < 3; ++axis)
        if (shares_coordinate(nodes_[i], axis)) return {region(nodes_[i]).plane.point, Vec::Unit(axis)};
    Vec sum = Vec::Zero(), point = Vec::Zero();
    double count = 0;
    for (const std::size_t i : list) {
      const Flat_region& r = region(nodes_[i]);
      sum += sum.dot(r.area_vector) < 0 ? Vec(-r.area_vector) : r.area_vector;
      const auto n = static_cast<double>(r.vertices.size());
      point += n / (count + n) * (r.plane.point - point);
      count += n;
    }
    const Plane fitted{on_grid(point, step_of(tolerance_)), unit_on_grid(sum)};
    for (int axis = 0; axis < 3; ++axis) {
      const Plane upright{fitted.point, Vec::Unit(axis)};
      if (std::abs(fitted.normal[axis]) > 0.999 && fits(upright, list)) return upright;
    }
    for (int axis = 0; axis < 3; ++axis) {
      const Plane along = plane_along(axis, fitted.normal, list);
      if (std::abs(fitted.normal[axis]) < 0.001 && fits(along, list)) return along;
    }
    return fitted;
  }

  /// A plane parallel to an axis, through the vertices farthest apart across the axis. Sides of a prism so meet in lines
  /// with short coordinates.
  [[nodiscard]] Plane plane_along(int axis, const Vec& normal, const std::vector<std::size_t>& list) {
    const Vec direction = Vec::Unit(axis).cross(normal);
    Vec first = Vec::Zero(), last = Vec::Zero();
    double least = std::numeric_limits<double>::infinity(), largest = -least;
    for (const std::size_t i : list)
      for (const Vertex v : region(nodes_[i]).vertices) {
        const Vec p = to_vec(mesh_[nodes_[i].side]->point(v));
        const double at = direction.dot(p);
        if (at < least) first = p;
        if (at > largest) last = p;
        least = std::min(least, at);
        largest = std::max(largest, at);
      }
    first = line_along(axis, first);
    last = line_along(axis, last);
    return {first, Vec::Unit(axis).cross(last - first)};
  }

  /// The line parallel to an axis that stands for all within rounding, as the point where the coordinate is zero.
  Vec line_along(int axis, Vec p) {
    const double cell = 4 * tolerance_;
    p[axis] = 0;
    std::array<double, 3> key{std::round(p.x() / cell), std::round(p.y() / cell), std::round(p.z() / cell)};
    auto& known = lines_[axis];
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j) {
        std::array<double, 3> near = key;
        near[(axis + 1) % 3] += i;
        near[(axis + 2) % 3] += j;
        if (const auto found = known.find(near); found != known.end()) return found->second;
      }
    return known[key] = on_grid(p, step_of(tolerance_));
  }

  [[nodiscard]] bool fits(const Plane& plane, const std::vector<std::size_t>& list) const {
    for (const std::size_t i : list)
      for (const Vertex v : region(nodes_[i]).vertices)
        if (plane.distance(mesh_[nodes_[i].side]->point(v)) > largest_misfit * tolerance_) return false;
    return true;
  }

  [[nodiscard]] bool shares_coordinate(const Node& n, int axis) const {
    const auto& vertices = region(n).vertices;
    const Blend_mesh& mesh = *mesh_[n.side];
    return std::all_of(vertices.begin(), vertices.end(),
                       [&](Vertex v) { return mesh.point(v)[axis] == mesh.point(vertices[0])[axis]; });
  }

  std::size_t place(Place_of p) {
    const auto found = place_of_.find(p);
    if (found != place_of_.end()) return found->second;
    const auto partner = partner_.find(p);
    Place place;
    place.vertex[p.side] = p.vertex;
    if (partner != partner_.end()) place.vertex[1 - p.side] = partner->second;
    const int side = place.vertex[0] != Vertex() ? 0 : 1;
    place.point = mesh_[side]->point(place.vertex[side]);
    for (int k = 0; k < 2; ++k)
      if (place.vertex[k] != Vertex()) place_of_[{k, place.vertex[k]}] = places_.size();
    places_.push_back(place);
    return places_.size() - 1;
  }

  void bind(std::size_t place, std::size_t plane) { bonds_.insert({place, plane}); }
  [[nodiscard]] bool bound(std::size_t place, std::size_t plane) const { return bonds_.count({place, plane}) > 0; }

  /// The plane that a region belongs to, if it is in use.
  std::size_t plane_of(std::size_t node) {
    const auto found = plane_of_root_.find(root(node));
    return found != plane_of_root_.end() ? found->second : none;
  }

  void bind_to_planes() {
    for (const std::size_t i : in_use_)
      for (const Vertex v : region(nodes_[i]).vertices) bind(place({nodes_[i].side, v}), plane_of(i));
    for (const auto& [p, partner] : partner_) place(p);
    for (const Touch& touch : touches_) {
      const int other = 1 - touch.vertex.side;
      const std::size_t at = place(touch.vertex);
      if (touch.edge == Halfedge()) {
        bind(at, plane_of(node(other, touch.face)));
        continue;
      }
      const auto [i, j] = sides(other, touch.edge);
      bind(at, plane_of(i));
      if (steep(i, j)) bind(at, plane_of(j));
    }
  }

  /// Vertices on an edge that is no line of two planes: the edge gets a plane of its own, across the face beside it.
  void bind_to_lines() {
    first_of_edges_ = planes_.size();
    std::map<std::pair<int, Halfedge>, std::size_t> plane_of_edge;
    for (const Touch& touch : touches_) {
      if (touch.edge == Halfedge()) continue;
      const int other = 1 - touch.vertex.side;
      const auto [i, j] = sides(other, touch.edge);
      const std::size_t at = place(touch.vertex), first = plane_of(i), second = plane_of(j);
      if (first != second && second != none && bound(at, second)) continue;
      const auto [known, is_new] = plane_of_edge.emplace(std::pair(other, touch.edge), planes_.size());
      if (is_new) {
        const Blend_mesh& mesh = *mesh_[other];
        const Vertex source = mesh.source(touch.edge), target = mesh.target(touch.edge);
        const Vec from = to_vec(mesh.point(source)), along = to_vec(mesh.point(target)) - from;
        planes_.push_back({from, unit_on_grid(along.cross(planes_[first].normal))});
        bind(place({other, source}), known->second);
        bind(place({other, target}), known->second);
      }
      bind(at, known->second);
    }
  }

  /// Edges that cross each other away from common planes get a plane that contains both.
  void bind_crossings() {
    for (const auto& [h, k] : crossings_) {
      const std::array<Place_of, 4> ends{Place_of{0, mesh_[0]->source(h)}, Place_of{0, mesh_[0]->target(h)},
                                         Place_of{1, mesh_[1]->source(k)}, Place_of{1, mesh_[1]->target(k)}};
      std::array<std::size_t, 4> at{};
      std::transform(ends.begin(), ends.end(), at.begin(), [&](const Place_of& end) { return place(end); });
      bool meet = false;  // already
      for (std::size_t i = 0; i < planes_.size() && !meet; ++i)
        meet = std::all_of(at.begin(), at.end(), [&](std::size_t p) { return bound(p, i); });
      if (meet) continue;
      const Vec p = to_vec(places_[at[0]].point), q = to_vec(places_[at[1]].point);
      const Vec r = to_vec(places_[at[2]].point), s = to_vec(places_[at[3]].point);
      for (const std::size_t i : at) bind(i, planes_.size());
      planes_.push_back({p, unit_on_grid((q - p).cross(s - r))});
    }
  }

  std::optional<Shared_planes> solve() {
    std::vector<Vec> normals, points;
    for (const Plane& plane : planes_) normals.push_back(plane.normal.normalized());
    for (const Place& place : places_) points.push_back(to_vec(place.point));
    std::vector<Exact_plane> exact_plane(planes_.size());
    std::vector<Exact_point> exact_place(places_.size());
    for (const Eliminated& step :
         elimination_order(points, normals, {bonds_.begin(), bonds_.end()}, first_of_edges_, 1000 * tolerance_)) {
      if (step.is_plane) {
        std::vector<Exact_point> before;
        for (const std::size_t i : step.earlier) before.push_back(exact_place[i]);
        exact_plane[step.index] = through(before, planes_[step.index]);
      } else {
        std::vector<Exact_plane> before;
        for (const std::size_t i : step.earlier) before.push_back(exact_plane[i]);
        exact_place[step.index] = project(places_[step.index].point, before, step_of(tolerance_));
      }
    }
    Shared_planes result;
    for (int side = 0; side < 2; ++side)
      for (const Vertex v : mesh_[side]->vertices()) {
        const Point_3& p = mesh_[side]->point(v);
        result.points[side].emplace_back(p.x(), p.y(), p.z());
      }
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const Point_3 moved(CGAL::to_double(exact_place[i].x()), CGAL::to_double(exact_place[i].y()),
                          CGAL::to_double(exact_place[i].z()));
      if (CGAL::squared_distance(moved, places_[i].point) > std::pow(largest_move * tolerance_, 2)) return std::nullopt;
      const auto& vertex = places_[i].vertex;
      for (int side = 0; side < 2; ++side)
        if (vertex[side] != Vertex()) result.points[side][vertex[side].idx()] = exact_place[i];
      if (vertex[0] != Vertex() && vertex[1] != Vertex()) result.common.emplace_back(vertex[0], vertex[1]);
    }
    return result;
  }

  std::array<const Blend_mesh*, 2> mesh_;
  double tolerance_;
  std::array<Flat_regions, 2> regions_;
  std::array<std::vector<std::size_t>, 2> node_of_region_;
  std::vector<Node> nodes_;
  std::set<std::size_t> in_use_;  // nodes
  std::set<Touch> touches_;
  std::set<std::pair<Halfedge, Halfedge>> crossings_;
  std::map<Place_of, Vertex> partner_;  // the vertex of the other body in the same place
  std::map<std::size_t, std::size_t> plane_of_root_;
  std::array<std::map<std::array<double, 3>, Vec>, 3> lines_;  // along each axis, by their places rounded
  std::vector<Plane> planes_;                                  // of regions, then of edges
  std::size_t first_of_edges_ = 0;
  std::map<Place_of, std::size_t> place_of_;
  std::vector<Place> places_;
  std::set<std::pair<std::size_t, std::size_t>> bonds_;  // of places to planes
  bool contradiction_ = false;
};

// Frames that are more oblique take more digits than they save. Volume of the box of the unit normals.
constexpr double least_frame = 0.3;

/// The directions with most vertices, as far as they are independent, filled up at right angles.
Frame frame_along(std::vector<std::pair<Vec, std::size_t>> directions, const Point_3& origin) {
  std::stable_sort(directions.begin(), directions.end(),
                   [](const auto& d, const auto& e) { return d.second > e.second; });
  std::vector<Vec> chosen;
  for (const auto& [n, count] : directions) {
    if (chosen.size() == 3) break;
    if (chosen.empty() || (chosen.size() == 1 && n.cross(chosen[0]).norm() > least_frame) ||
        (chosen.size() == 2 && std::abs(n.dot(chosen[0].cross(chosen[1]))) > least_frame))
      chosen.push_back(n);
  }
  Frame frame;
  const bool upright = std::all_of(chosen.begin(), chosen.end(), [](const Vec& n) { return n.cwiseAbs().sum() == 1; });
  if (upright) return frame;
  if (chosen.size() == 1) chosen.push_back(chosen[0].unitOrthogonal());
  if (chosen.size() == 2) chosen.push_back(chosen[0].cross(chosen[1]).normalized());
  for (int i = 0; i < 3; ++i) frame.to_frame.row(i) = chosen[i].transpose();
  if (frame.to_frame.determinant() < 0) frame.to_frame.row(2) *= -1;
  frame.to_space = frame.to_frame.inverse();
  frame.origin = to_vec(origin);
  return frame;
}

Blend_mesh in_frame(Blend_mesh mesh, const Frame& frame, double step) {
  for (const Vertex v : mesh.vertices()) {
    const Vec x = frame.to_frame * (to_vec(mesh.point(v)) - frame.origin);
    mesh.point(v) = {on_grid(x.x(), step), on_grid(x.y(), step), on_grid(x.z(), step)};
  }
  return mesh;
}

}  // namespace

std::optional<Shared_planes> share_planes(const Blend_mesh& a, const Blend_mesh& b) {
  const double tolerance = rounding_tolerance(a, b);
  const Frame frame = frame_along(Plane_sharing(a, b, tolerance).directions(), a.point(*a.vertices().begin()));
  if (frame.to_frame.isIdentity(0)) return Plane_sharing(a, b, tolerance).run();
  const double step = step_of(tolerance);
  std::optional<Shared_planes> result =
      Plane_sharing(in_frame(a, frame, step), in_frame(b, frame, step), tolerance).run();
  if (result) result->frame = frame;
  return result;
}

Point_3 rounded(const Exact_point& p, const Frame& frame) {
  CGAL::exact(p);  // else the result depends on what has been computed with it
  const Vec x(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  return to_point(frame.origin + frame.to_space * x);
}

}  // namespace cgal_blend
