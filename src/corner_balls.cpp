// SPDX-License-Identifier: GPL-3.0-or-later
#include "corner_balls.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

// On planes, a ball that rests on three sectors cuts a fourth one if the fourth normal lies within the circle of the
// three on the sphere of normals: the balls wanted are Delaunay's circles of the polygon of normals. Diagonals whose
// balls are in the wrong order are flipped until there is none. Source: Lawson (1977).

namespace cgal_blend {

namespace {

constexpr double same_ball = 1e-6;  // of the radius: centres so near are one ball's, and the solver tells others apart

// Of the normals' determinant: flatter trios have no ball at rest. Three branches can meet in passes then, and do so
// well where the corner is flat; more cannot, and balls are sought as long as rounding leaves their place known.
constexpr double least_volume_of_three = 1e-3;
constexpr double least_volume_of_many = 1e-6;

using Sectors = std::vector<std::vector<Halfedge>>;

/// Sectors that one ball touches, increasing.
using Trio = std::array<std::size_t, 3>;

/// A spine between the balls of two trios, the first of which also touches `behind`, and the second `ahead`.
struct Diagonal {
  std::size_t left, right, behind, ahead;
  std::array<std::size_t, 2> trio;
};

/// How the second ball of a diagonal lies to the first, seen along the spine.
enum class Order { ahead, same, back };

std::vector<Diagonal> diagonals_of(const std::vector<Trio>& trios) {
  const auto outside = [](const Trio& a, const Trio& b) {  // places in a of what is not in b
    std::vector<std::size_t> places;
    for (std::size_t p = 0; p < 3; ++p)
      if (std::find(b.begin(), b.end(), a[p]) == b.end()) places.push_back(p);
    return places;
  };
  std::vector<Diagonal> found;
  for (std::size_t s = 0; s < trios.size(); ++s)
    for (std::size_t t = s + 1; t < trios.size(); ++t) {
      const auto p = outside(trios[s], trios[t]), q = outside(trios[t], trios[s]);
      if (p.size() != 1) continue;
      const std::size_t k = p.front();  // counterclockwise left, behind, right
      found.push_back({trios[s][(k + 2) % 3], trios[s][(k + 1) % 3], trios[s][k], trios[t][q.front()], {s, t}});
    }
  return found;
}

/// Flips diagonals whose balls are in the wrong order; false if this comes to no end, or balls are not known.
template <class Order_along>
bool flip_diagonals(std::vector<Trio>& trios, const Order_along& order) {
  const auto sorted = [](Trio trio) {
    std::sort(trio.begin(), trio.end());
    return trio;
  };
  for (std::size_t flips = 0; flips <= trios.size() * trios.size(); ++flips) {
    bool changed = false;
    for (const Diagonal& d : diagonals_of(trios)) {
      const std::optional<Order> along = order(d);
      if (!along) return false;
      changed = *along == Order::back;
      if (!changed) continue;
      trios[d.trio[0]] = sorted({d.behind, d.right, d.ahead});
      trios[d.trio[1]] = sorted({d.ahead, d.left, d.behind});
      break;
    }
    if (!changed) return true;
  }
  return false;
}

/// Balls on the tangent planes of the sectors.
class Plane_balls {
 public:
  Plane_balls(const Base_surface& surface, const Sectors& sectors, double distance) : distance_(distance) {
    const auto corner = [&](const std::vector<Halfedge>& sector) {
      return to_vec(surface.mesh().point(surface.mesh().target(sector.front())));
    };
    origin_ = corner(sectors.front());
    for (const auto& sector : sectors) {
      normal_.push_back(sector_normal(surface, sector));
      height_.push_back(normal_.back().dot(corner(sector) - origin_) + distance);
    }
  }

  /// Of a trio's normals: positive, with the edges all bent the same way.
  [[nodiscard]] double determinant(const Trio& t) const {
    return normal_[t[0]].dot(normal_[t[1]].cross(normal_[t[2]]));
  }

  [[nodiscard]] bool is_solid(const Trio& t) const {
    return determinant(t) > (normal_.size() == 3 ? least_volume_of_three : least_volume_of_many);
  }

  [[nodiscard]] Vec center(const Trio& t) const { return origin_ + scaled_center(t) / determinant(t); }

  /// Without divisions: balls of trios on the way may be far away.
  [[nodiscard]] Order order(const Trio& first, const Trio& second, const Diagonal& d) const {
    const double cut = normal_[d.ahead].dot(scaled_center(first)) - height_[d.ahead] * determinant(first);
    const double length = std::abs(cut) * normal_[d.left].cross(normal_[d.right]).norm();  // of the spine, scaled
    if (length <= same_ball * std::abs(distance_ * determinant(first) * determinant(second))) return Order::same;
    return (cut > 0) == (distance_ < 0) ? Order::back : Order::ahead;
  }

  /// True if the ball of a trio cuts no other plane. Diagonals tell this by themselves in a corner of one vertex only.
  [[nodiscard]] bool is_clear(const Trio& t) const {
    const Vec center = scaled_center(t) / determinant(t);
    const double allowed = same_ball * std::abs(distance_);
    for (std::size_t k = 0; k < normal_.size(); ++k) {
      const double cut = normal_[k].dot(center) - height_[k];
      if (is_solid(t) && (distance_ < 0 ? cut : -cut) > allowed) return false;
    }
    return true;
  }

 private:
  /// The centre as seen from the origin, times the determinant (Cramer's rule).
  [[nodiscard]] Vec scaled_center(const Trio& t) const {
    Vec sum = Vec::Zero();
    for (int i = 0; i < 3; ++i) sum += height_[t[i]] * normal_[t[(i + 1) % 3]].cross(normal_[t[(i + 2) % 3]]);
    return sum;
  }

  double distance_;
  Vec origin_;
  std::vector<Vec> normal_;
  std::vector<double> height_;  // of the planes on which the centres lie, above the origin
};

/// Balls on the surface itself, each sought once.
class Surface_balls {
 public:
  Surface_balls(const Base_surface& surface, const Sectors& sectors, const Plane_balls& planes, double distance)
      : surface_(surface), sectors_(sectors), planes_(planes), distance_(distance) {}

  const Corner_solution& operator()(const Trio& t) {
    const auto found = balls_.find(t);
    if (found != balls_.end()) return found->second;
    Corner_solution solution;
    if (planes_.is_solid(t))
      solution =
          find_corner_ball(surface_, {&sectors_[t[0]], &sectors_[t[1]], &sectors_[t[2]]}, planes_.center(t), distance_);
    return balls_.emplace(t, std::move(solution)).first->second;
  }

  [[nodiscard]] std::optional<Order> order(const Trio& first, const Trio& second, const Diagonal& d) {
    const auto &a = (*this)(first).ball, &b = (*this)(second).ball;
    if (!a || !b) return std::nullopt;
    const auto normal = [&](std::size_t sector) {
      return surface_.normal(a->foot[std::find(first.begin(), first.end(), sector) - first.begin()]);
    };
    const Vec step = b->center - a->center, along = normal(d.left).cross(normal(d.right));
    if (step.norm() <= same_ball * std::abs(distance_)) return Order::same;
    return (step.dot(along) > 0) == (distance_ < 0) ? Order::ahead : Order::back;
  }

 private:
  const Base_surface& surface_;
  const Sectors& sectors_;
  const Plane_balls& planes_;
  double distance_;
  std::map<Trio, Corner_solution> balls_;
};

/// Balls that are the same become one.
Corner_balls merge_balls(const std::vector<Trio>& trios, Surface_balls& balls) {
  std::vector<std::size_t> first(trios.size());  // of the trios with the same ball
  std::iota(first.begin(), first.end(), std::size_t{0});
  std::vector<Diagonal> between;
  for (const Diagonal& d : diagonals_of(trios)) {
    if (balls.order(trios[d.trio[0]], trios[d.trio[1]], d) != Order::same) {
      between.push_back(d);
      continue;
    }
    const auto [low, high] = std::minmax(first[d.trio[0]], first[d.trio[1]]);
    std::replace(first.begin(), first.end(), std::size_t{high}, std::size_t{low});
  }
  Corner_balls result;
  std::vector<std::size_t> place(trios.size());
  for (std::size_t t = 0; t < trios.size(); ++t) {
    if (first[t] == t) {
      place[t] = result.balls.size();
      result.balls.push_back({{}, {balls(trios[t]).ball->center, {}}});
    }
    place[t] = place[first[t]];
    Corner_balls::Ball& ball = result.balls[place[t]];
    for (std::size_t i = 0; i < 3; ++i) {
      const auto at = std::lower_bound(ball.sectors.begin(), ball.sectors.end(), trios[t][i]);
      if (at != ball.sectors.end() && *at == trios[t][i]) continue;
      ball.rest.foot.insert(ball.rest.foot.begin() + (at - ball.sectors.begin()), balls(trios[t]).ball->foot[i]);
      ball.sectors.insert(at, trios[t][i]);
    }
  }
  for (const Diagonal& d : between) result.spines.push_back({{d.left, d.right}, {place[d.trio[0]], place[d.trio[1]]}});
  return result;
}

}  // namespace

Corner_balls find_corner_balls(const Base_surface& surface, const std::vector<std::vector<Halfedge>>& sectors,
                               double distance) {
  if (sectors.size() < 3) return {};
  const Plane_balls planes(surface, sectors, distance);
  std::vector<Trio> trios;
  for (std::size_t k = 2; k < sectors.size(); ++k) trios.push_back({0, k - 1, k});
  const auto order = [&](const Diagonal& d) -> std::optional<Order> {
    return planes.order(trios[d.trio[0]], trios[d.trio[1]], d);
  };
  if (!flip_diagonals(trios, order)) return {};
  if (!std::all_of(trios.begin(), trios.end(), [&](const Trio& t) { return planes.is_clear(t); })) return {};
  // Where the sectors are curved their balls may have another order; on planes nothing is left to flip.
  Surface_balls balls(surface, sectors, planes, distance);
  Corner_balls none;
  const auto known = [&](const Trio& t) {
    if (balls(t).ball) return true;
    none.blocked = balls(t).blocked;
    return false;
  };
  const bool found =
      std::all_of(trios.begin(), trios.end(), known) &&
      flip_diagonals(trios, [&](const Diagonal& d) { return balls.order(trios[d.trio[0]], trios[d.trio[1]], d); }) &&
      std::all_of(trios.begin(), trios.end(), known);
  return found ? merge_balls(trios, balls) : none;
}

}  // namespace cgal_blend
