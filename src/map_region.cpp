// SPDX-License-Identifier: GPL-3.0-or-later
#include "map_region.h"

#include "blend_curve.h"
#include "curve_ring.h"
#include "flatten_disk.h"
#include "placed_region.h"
#include "refusal.h"

#include <CGAL/boost/graph/iterator.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <unordered_map>

namespace cgal_blend {

namespace {

constexpr double hop_cost = 1e-3;      // of the longest profile, per edge of the cut
constexpr double border_slack = 0.08;  // share of even spacing in the border's parameters: keeps them apart
constexpr int relaxations = 8;         // Laplacian sweeps in the plane
constexpr double border_reach = 0.4;   // of the shortest edge: border vertices nearer to the linkage curve move onto it
constexpr int border_steps = 3;        // Taubin steps along the linkage curve
constexpr double taubin_lambda = 0.5, taubin_mu = -0.53;
constexpr double least_upright = 0.5;  // cosine between a face's normals before and after its border vertex moved

/// Coarse fans of faces may fold in space whatever the map, because the blend is no longer seen from their apex as the
/// curve was. Then vertices stay beside their old places, and the whole region moves towards one of the linkage curves.
struct Slant {
  bool own_t;       // t of the nearest spine point, not of the map
  double curve_at;  // mean of u over the curve; 0: as mapped
};
constexpr std::array<Slant, mapping_attempts> slants{{{false, 0}, {true, 0}, {true, 0.9}, {true, 0.1}}};

/// The annulus of faces around the curve, cut open to a disk. Disk vertices are classes of corners that hang together
/// over edges inside the region, so that vertices on the cut, and those that the border touches twice, come apart.
class Mapper {
 public:
  Mapper(const Blend_mesh& mesh, const std::vector<Vertex>& curve, const std::unordered_set<Vertex>& between,
         const Virtual_surface& surface, const std::vector<Ball_position>& positions, std::size_t attempt)
      : mesh_(mesh),
        curve_(curve),
        between_(between),
        surface_(surface),
        positions_(positions),
        linkage_{polyline(positions, left_contact), polyline(positions, right_contact)},
        spine_(polyline(positions, center)),
        slant_(slants[attempt]),
        ring_(mesh) {}

  Region_mapping run() {
    if (!ring_.collect(curve_, between_) || !cut()) return refuse(Status::region_not_annular);
    build_disk();
    if (!place_border()) return refuse(Status::region_not_annular);
    if (!flatten()) return refuse(Status::parametrization_folds);
    relax();
    placed_.emplace(mesh_, surface_, ring_.faces(), ring_.inner_index(), ring_.inner().size());
    place_interior();
    draw_border_in();
    placed_->untangle();
    for (std::size_t k = 0; k < ring_.inner().size(); ++k)
      result_.interior.emplace_back(ring_.inner()[k], placed_->place(ring_.inner()[k]).point);
    for (const auto& [v, to] : placed_->border()) result_.border.emplace_back(v, to);
    result_.faces = ring_.faces();
    result_.coarseness = placed_->coarseness();
    return std::move(result_);
  }

 private:
  /// A polyline through one point of each ball position.
  template <class Member>
  static Curve_locator polyline(const std::vector<Ball_position>& positions, const Member& point) {
    std::vector<Vec> points;
    for (const Ball_position& p : positions) points.push_back(point(p));
    return Curve_locator(points);
  }
  static Vec left_contact(const Ball_position& p) { return p.contact[0]; }
  static Vec right_contact(const Ball_position& p) { return p.contact[1]; }
  static Vec center(const Ball_position& p) { return p.center; }

  Region_mapping refuse(Status status) const {
    Region_mapping refused;
    refused.diagnosis = refusal(status, to_vec(mesh_.point(curve_.front())));
    return refused;
  }

  // Splitting.

  /// Cuts along the shortest path between the border vertices nearest to the ends of the longest profile.
  bool cut() {
    longest_ = 0;
    double length = -1;
    for (std::size_t i = 0; i < positions_.size(); ++i) {
      if (positions_[i].mended) continue;
      const double size = surface_.profile_length(i);
      if (size <= length) continue;
      length = size;
      longest_ = i;
    }
    std::array<Halfedge, 2> ends;
    for (int side = 0; side < 2; ++side) {
      const auto distance = [&](Halfedge h) {
        return (to_vec(mesh_.point(mesh_.target(h))) - positions_[longest_].contact[side]).squaredNorm();
      };
      ends[side] = *std::min_element(ring_.border(side).begin(), ring_.border(side).end(),
                                     [&](Halfedge a, Halfedge b) { return distance(a) < distance(b); });
    }
    path_ = ring_.shortest_path(ends, hop_cost * surface_.profile_length(longest_));
    for (const Halfedge h : path_) cut_.insert(mesh_.edge(h));
    return !path_.empty();
  }

  // The disk.

  [[nodiscard]] bool joined(Halfedge h) const { return ring_.inside(mesh_.opposite(h)) && !cut_.count(mesh_.edge(h)); }

  /// The first corner of the fan that a corner of the region belongs to; a corner is the halfedge that ends in it.
  [[nodiscard]] Halfedge fan_of(Halfedge corner) const {
    Halfedge h = corner, least = corner;
    while (joined(h)) {  // h is the edge to the neighbour on one side
      h = mesh_.prev(mesh_.opposite(h));
      if (h == corner) return least;
      least = std::min(least, h);
    }
    return h;  // first one after a border or cut edge
  }

  void build_disk() {
    for (const Face f : ring_.faces())
      for (const Halfedge h : mesh_.halfedges_around_face(mesh_.halfedge(f))) {
        const Halfedge fan = fan_of(h);
        const auto [at, is_new] = fan_vertex_.emplace(fan, Vertex(static_cast<std::uint32_t>(origin_.size())));
        corner_[h] = at->second;
        if (!is_new) continue;
        origin_.push_back(mesh_.target(h));
        disk_.add_vertex(mesh_.point(mesh_.target(h)));
      }
    for (const Face f : ring_.faces()) {
      const Halfedge h = mesh_.halfedge(f);
      disk_.add_face(corner_[h], corner_[mesh_.next(h)], corner_[mesh_.next(mesh_.next(h))]);
    }
  }

  // The rectangle: t runs along the curve, the height is 1 on the left and 0 on the right.

  /// Parameter of the nearest point of a polyline through one point of each ball position.
  template <class Member>
  [[nodiscard]] double parameter_on(const Curve_locator& polyline, const Member& point, const Vec& p) const {
    const std::size_t i = polyline.nearest(p, hint_).segment, j = (i + 1) % positions_.size();
    hint_ = i;  // borders are asked for in order
    const Vec a = point(positions_[i]), chord = point(positions_[j]) - a;
    const double size = chord.squaredNorm();
    const double s = size > 0 ? std::clamp((p - a).dot(chord) / size, 0.0, 1.0) : 0;
    return surface_.start(i) + s * (surface_.start(i + 1) - surface_.start(i));
  }

  [[nodiscard]] double parameter_at(int side, const Vec& p) const {
    return parameter_on(linkage_[side], side == 0 ? left_contact : right_contact, p);
  }

  bool place_border() {
    if (disk_.number_of_faces() != ring_.faces().size()) return false;
    places_.assign(origin_.size(), Point_2(0, 0));
    for (int side = 0; side < 2; ++side)
      if (!place_side(side)) return false;
    place_cut();
    // Between the linkage curves the region is as wide as they are apart, however far its border reaches beyond them.
    for (const Vertex v : disk_.vertices())
      if (!ring_.is_inner(origin_[v.idx()]))
        disk_.point(v) = to_point(surface_(places_[v.idx()].x() + surface_.start(longest_), 1 - places_[v.idx()].y()));
    return true;
  }

  /// Parameters along one side, increasing: the nearest of the linkage curve, evened out.
  bool place_side(int side) {
    // The border in the direction of the curve, from the cut once around to the cut.
    std::vector<Halfedge> loop = ring_.border(side);
    const Halfedge start = side == 0 ? mesh_.opposite(path_.front()) : path_.back();
    const auto at_cut = [&](Halfedge h) { return mesh_.target(h) == mesh_.target(start) && ends_at_cut(h); };
    const auto first = std::find_if(loop.begin(), loop.end(), at_cut);
    if (first == loop.end()) return false;
    std::rotate(loop.begin(), first + 1, loop.end());  // now the last one arrives at the cut
    const std::size_t n = loop.size();
    std::vector<double> t(n + 1), even(n + 1, 0);
    const double whole = surface_.length(), zero = surface_.start(longest_);
    const double direction = side == 0 ? -1 : 1;  // left of the curve the border runs backward
    for (std::size_t k = 1; k < n; ++k) {
      const double raw = parameter_at(side, to_vec(mesh_.point(mesh_.target(loop[k - 1])))) - zero;
      double along = direction * raw - t[k - 1];
      along -= whole * std::round(along / whole);
      t[k] = t[k - 1] + along;
    }
    t[n] = whole;
    for (std::size_t k = 0; k <= n; ++k) t[k] = std::clamp(t[k], 0.0, whole);
    make_monotone(t);
    for (std::size_t k = 1; k <= n; ++k) even[k] = even[k - 1] + ring_.length(loop[k - 1]);
    for (std::size_t k = 0; k <= n; ++k) {
      const double along = (1 - border_slack) * t[k] + border_slack * whole * even[k] / even[n];
      // A border vertex k stands between halfedges k - 1 and k; both ends of the row are copies of the cut's end.
      const Vertex v = k < n ? corner_source(loop[k]) : corner_.at(loop[n - 1]);
      put(v, side == 0 ? whole - along : along, side == 0 ? 1 : 0);
    }
    return true;
  }

  [[nodiscard]] bool ends_at_cut(Halfedge border) const {
    bool found = false;
    ring_.for_fan(border, [&](Halfedge h) { found = found || cut_.count(mesh_.edge(h)) != 0; });
    return found;
  }

  [[nodiscard]] Vertex corner_source(Halfedge h) const { return corner_.at(mesh_.prev(h)); }

  void put(Vertex v, double t, double height) { places_[v.idx()] = Point_2(t, height); }

  /// Replaces stretches that run backward by their mean (pool adjacent violators), the ends kept.
  static void make_monotone(std::vector<double>& t) {
    struct Pool {
      double sum;
      std::size_t size;
      [[nodiscard]] double mean() const { return sum / static_cast<double>(size); }
    };
    std::vector<Pool> pools;
    for (std::size_t k = 1; k + 1 < t.size(); ++k) {
      pools.push_back({t[k], 1});
      while (pools.size() > 1 && pools[pools.size() - 2].mean() > pools.back().mean()) {
        const Pool top = pools.back();
        pools.pop_back();
        pools.back() = {pools.back().sum + top.sum, pools.back().size + top.size};
      }
    }
    std::size_t k = 1;
    for (const Pool& pool : pools)
      for (std::size_t i = 0; i < pool.size; ++i) t[k++] = pool.mean();
  }

  /// Heights along the cut, in proportion to length from linkage curve to linkage curve; equal on both copies.
  void place_cut() {
    std::vector<Vec> points;
    for (std::size_t k = 0; k <= path_.size(); ++k)
      points.push_back(k == 0              ? positions_[longest_].contact[0]
                       : k == path_.size() ? positions_[longest_].contact[1]
                                           : to_vec(mesh_.point(mesh_.source(path_[k]))));
    std::vector<double> far{0};
    for (std::size_t k = 1; k < points.size(); ++k)
      far.push_back(far.back() + (points[k] - points[k - 1]).norm() + border_slack * surface_.profile_length(longest_));
    for (std::size_t k = 0; k + 1 < path_.size(); ++k) {
      const double height = 1 - far[k + 1] / far.back();
      // The cut runs from left to right: the faces left of it, seen along it, lie ahead of it (t = 0).
      put(corner_.at(path_[k]), 0, height);
      put(corner_source(mesh_.opposite(path_[k])), surface_.length(), height);
    }
  }

  bool flatten() {
    for (const Flat_weights weights : {Flat_weights::conformal, Flat_weights::mean_value, Flat_weights::uniform})
      if (auto flat = flatten_disk(disk_, places_, weights)) {
        flat_ = std::move(*flat);
        return true;
      }
    return false;
  }

  // Relaxation in the plane, the cut closed again.

  void relax() {
    // One list of disk copies per inner vertex.
    std::vector<std::vector<Vertex>> copies(ring_.inner().size());
    for (const Vertex v : disk_.vertices())
      if (const int k = ring_.inner_index()[origin_[v.idx()].idx()]; k >= 0) copies[k].push_back(v);
    const double across = width();
    for (int sweep = 0; sweep < relaxations; ++sweep)
      for (const std::vector<Vertex>& disk_vertices : copies) relax_vertex(disk_vertices, across);
    if (!surface_.kinks().empty())
      for (const Vertex v : curve_) onto_kink(copies[ring_.inner_index()[v.idx()]]);
  }

  [[nodiscard]] double width() const {
    double sum = 0;
    for (std::size_t i = 0; i < positions_.size(); i += 4) sum += surface_.profile_length(i);
    return sum / static_cast<double>((positions_.size() + 3) / 4);
  }

  [[nodiscard]] Vec flat(Vertex v, double shift, double across) const {
    return {flat_[v.idx()].x() + shift, flat_[v.idx()].y() * across, 0};
  }

  /// Shifts that bring the copies of a vertex to the place of the first.
  [[nodiscard]] double shift_of(const std::vector<Vertex>& copies, std::size_t k) const {
    return k == 0 ? 0
                  : std::round((flat_[copies[0].idx()].x() - flat_[copies[k].idx()].x()) / surface_.length()) *
                        surface_.length();
  }

  void relax_vertex(const std::vector<Vertex>& copies, double across) {
    Vec sum = Vec::Zero();
    double weight = 0;
    for (std::size_t k = 0; k < copies.size(); ++k) {
      const double shift = shift_of(copies, k);
      for (const Vertex v : disk_.vertices_around_target(disk_.halfedge(copies[k]))) {
        const Vec to = flat(v, shift, across);
        const double w = (to - flat(copies[0], 0, across)).norm();  // long edges pull harder
        sum += w * to;
        weight += w;
      }
    }
    if (weight > 0) move(copies, Point_2(sum.x() / weight, sum.y() / weight / across));
  }

  void onto_kink(const std::vector<Vertex>& copies) {
    const Point_2 at = flat_[copies[0].idx()];
    double nearest = 2;
    for (const double kink : surface_.kinks())
      if (std::abs(1 - kink - at.y()) < std::abs(nearest - at.y())) nearest = 1 - kink;
    move(copies, Point_2(at.x(), nearest));
  }

  /// Moves all copies of a vertex, unless a face would fold.
  void move(const std::vector<Vertex>& copies, const Point_2& to) {
    std::vector<Point_2> old, next;
    bool upright = true;
    for (std::size_t k = 0; k < copies.size(); ++k) {
      old.push_back(flat_[copies[k].idx()]);
      const double shift = shift_of(copies, k);
      next.emplace_back(to.x() - shift, to.y());
    }
    for (std::size_t k = 0; k < copies.size(); ++k) flat_[copies[k].idx()] = next[k];
    for (const Vertex v : copies)
      for (const Halfedge h : disk_.halfedges_around_target(disk_.halfedge(v))) {
        if (disk_.is_border(h)) continue;
        upright = upright && CGAL::orientation(flat_[disk_.source(h).idx()], flat_[v.idx()],
                                               flat_[disk_.target(disk_.next(h)).idx()]) == CGAL::LEFT_TURN;
      }
    if (upright) return;
    for (std::size_t k = 0; k < copies.size(); ++k) flat_[copies[k].idx()] = old[k];
  }

  // Back into space.

  void place_interior() {
    const double bias = slant_.curve_at > 0 ? odds(curve_mean()) / odds(slant_.curve_at) : 1;
    for (std::size_t i = 0; i < origin_.size(); ++i) {  // copies on the cut have the same place
      const Vertex v = origin_[i];
      if (!ring_.is_inner(v)) continue;
      const double u = std::clamp(1 - flat_[i].y(), 0.0, 1.0);
      const double t =
          slant_.own_t ? parameter_on(spine_, center, to_vec(mesh_.point(v))) : flat_[i].x() + surface_.start(longest_);
      placed_->put(v, t, u / (u + bias * (1 - u)));
    }
  }

  static double odds(double share) { return share / (1 - share); }

  /// Mean of u over the curve.
  [[nodiscard]] double curve_mean() const {
    const std::set<Vertex> curve(curve_.begin(), curve_.end());
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < origin_.size(); ++i)
      if (curve.count(origin_[i])) {
        sum += 1 - flat_[i].y();
        ++count;
      }
    return std::clamp(sum / count, 0.01, 0.99);
  }

  /// Border vertices near their linkage curve move onto it; a few Taubin steps along it even them out.
  void draw_border_in() {
    for (int side = 0; side < 2; ++side) {
      const std::vector<Halfedge>& loop = ring_.border(side);
      std::vector<std::optional<double>> t;  // per border vertex that moves
      for (const Halfedge h : loop) t.push_back(drawn_to(h, side));
      for (int step = 0; step < border_steps; ++step)
        for (const double factor : {taubin_lambda, taubin_mu}) smooth(t, factor);
      for (std::size_t k = 0; k < loop.size(); ++k) {
        if (!t[k]) continue;
        const Vec to = surface_(*t[k], side);
        if (stays_upright(loop[k], to)) placed_->draw(mesh_.target(loop[k]), to);
      }
    }
  }

  void smooth(std::vector<std::optional<double>>& t, double factor) const {
    const auto old = t;
    const double whole = surface_.length();
    for (std::size_t k = 0; k < t.size(); ++k) {
      const auto &before = old[k == 0 ? t.size() - 1 : k - 1], &after = old[(k + 1) % t.size()];
      if (!old[k] || !before || !after) continue;
      const auto step = [&](double to) { return std::remainder(to - *old[k], whole); };
      *t[k] += factor * (step(*before) + step(*after)) / 2;
    }
  }

  /// Parameter of the linkage curve that a border vertex moves to, if it is near enough and inside a smooth part of the
  /// surface that the curve runs over.
  [[nodiscard]] std::optional<double> drawn_to(Halfedge border, int side) const {
    const Vertex v = mesh_.target(border);
    const Vec at = to_vec(mesh_.point(v));
    double shortest = -1;
    for (const Halfedge h : mesh_.halfedges_around_target(border))
      if (shortest < 0 || ring_.length(h) < shortest) shortest = ring_.length(h);
    const double t = parameter_at(side, at);
    if ((surface_(t, side) - at).norm() > border_reach * shortest) return std::nullopt;
    Vec normal = Vec::Zero();
    for (const Face f : mesh_.faces_around_target(border)) normal += face_normal(mesh_, f);
    for (const Face f : mesh_.faces_around_target(border))
      if (face_normal(mesh_, f).dot(normal.normalized()) < least_upright) return std::nullopt;
    int borders = 0;  // a vertex that the border touches twice has two places to go to
    for (const Halfedge h : mesh_.halfedges_around_target(border)) borders += ring_.on_border(h) ? 1 : 0;
    return borders == 1 ? std::optional(t) : std::nullopt;
  }

  [[nodiscard]] bool stays_upright(Halfedge border, const Vec& to) const {
    for (const Halfedge h : mesh_.halfedges_around_target(border)) {
      if (ring_.inside(h)) continue;
      const Vec moved =
          face_normal(to_vec(mesh_.point(mesh_.source(h))), to, to_vec(mesh_.point(mesh_.target(mesh_.next(h)))));
      if (moved.dot(face_normal(mesh_, mesh_.face(h))) < least_upright) return false;
    }
    return true;
  }

  const Blend_mesh& mesh_;
  const std::vector<Vertex>& curve_;
  const std::unordered_set<Vertex>& between_;
  const Virtual_surface& surface_;
  const std::vector<Ball_position>& positions_;
  std::array<Curve_locator, 2> linkage_;
  Curve_locator spine_;
  mutable std::size_t hint_ = 0;  // segment that was nearest last
  const Slant& slant_;

  Curve_ring ring_;
  std::size_t longest_ = 0;     // profile at which the region is cut
  std::vector<Halfedge> path_;  // the cut, from left to right
  std::set<Edge> cut_;

  Blend_mesh disk_;
  std::unordered_map<Halfedge, Vertex> fan_vertex_;
  std::unordered_map<Halfedge, Vertex> corner_;  // disk vertex at the target
  std::vector<Vertex> origin_;                   // per disk vertex
  std::vector<Point_2> places_, flat_;
  std::optional<Placed_region> placed_;
  Region_mapping result_;
};

}  // namespace

Region_mapping map_region(const Blend_mesh& mesh, const std::vector<Vertex>& curve,
                          const std::unordered_set<Vertex>& between, const Virtual_surface& surface,
                          const std::vector<Ball_position>& positions, std::size_t attempt) {
  return Mapper(mesh, curve, between, surface, positions, attempt).run();
}

}  // namespace cgal_blend
