// SPDX-License-Identifier: GPL-3.0-or-later
#include "rbf_constraints.h"

#include "segment_tree.h"

#include <CGAL/Polygon_2_algorithms.h>

#include <cmath>

namespace cgal_blend {

namespace {

using Vector_2 = Kernel::Vector_2;

constexpr int most_halvings = 20;
// A clear place is not much nearer to the rings than the one half as far; at the least, sharp corners bring it down.
constexpr double clearance = 0.8, least_distance = 0.2;

Vector_2 unit(const Vector_2& v) { return v / std::sqrt(v.squared_length()); }

class Offset_points {
 public:
  explicit Offset_points(const std::vector<Ring>& rings) : rings_(rings), distance_(sides_of(rings)), inside_(rings) {}

  [[nodiscard]] std::vector<Rbf_constraint> run(double rho) const {
    std::vector<Rbf_constraint> result;
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      const Ring& ring = rings_[r];
      const double turn = outward_turn(r);
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vector_2 normal = turn * normal_at(ring, i);
        result.push_back({ring[i], 0});
        for (const double sign : {-1.0, 1.0}) {
          const double d = clear_distance(ring[i], sign * normal, sign < 0, rho);
          result.push_back({ring[i] + sign * d * normal, sign * d});
        }
      }
    }
    return result;
  }

 private:
  /// 1 if the right of the ring's direction is outside the opening, -1 if the left is.
  [[nodiscard]] double outward_turn(std::size_t r) const {
    std::vector<Ring> others = rings_;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(r));
    const bool hole = Even_odd_test(others)(rings_[r].front());
    const bool counterclockwise =
        CGAL::orientation_2(rings_[r].begin(), rings_[r].end(), Kernel()) == CGAL::COUNTERCLOCKWISE;
    return counterclockwise != hole ? 1 : -1;
  }

  /// The bisector of the normals to the right of both sides at a vertex; unit.
  static Vector_2 normal_at(const Ring& ring, std::size_t i) {
    const std::size_t n = ring.size();
    const Vector_2 before = unit(ring[i] - ring[(i + n - 1) % n]), after = unit(ring[(i + 1) % n] - ring[i]);
    const Vector_2 sum = before + after;
    const Vector_2 tangent = sum.squared_length() > 1e-12 ? unit(sum) : after;  // else the ring turns back on itself
    return {tangent.y(), -tangent.x()};
  }

  [[nodiscard]] double clear_distance(const Point_2& p, const Vector_2& normal, bool inside, double rho) const {
    double d = rho;
    for (int i = 0; i < most_halvings && !clear(p, normal, inside, d); ++i) d /= 2;
    return d;
  }

  [[nodiscard]] bool clear(const Point_2& p, const Vector_2& normal, bool inside, double d) const {
    const Point_2 near = p + d * normal, far = p + 2 * d * normal;
    if (inside_(near) != inside || inside_(far) != inside) return false;
    const double at_near = distance_(near);
    return at_near >= least_distance * d && distance_(far) >= clearance * 2 * at_near;
  }

  const std::vector<Ring>& rings_;
  Segment_tree distance_;
  Even_odd_test inside_;
};

}  // namespace

double mean_edge(const std::vector<Ring>& rings) {
  double sum = 0;
  const std::vector<Weighted_segment> sides = sides_of(rings);
  for (const Weighted_segment& s : sides) sum += std::sqrt(CGAL::squared_distance(s.source, s.target));
  return sum / static_cast<double>(sides.size());
}

std::vector<Rbf_constraint> rbf_constraints(const std::vector<Ring>& rings, double rho) {
  return Offset_points(rings).run(rho);
}

}  // namespace cgal_blend
