// SPDX-License-Identifier: GPL-3.0-or-later
#include "rbf_constraints.h"

#include "ring_clearance.h"

#include <cmath>

namespace cgal_blend {

namespace {

using Vector_2 = Kernel::Vector_2;

Vector_2 unit(const Vector_2& v) { return v / std::sqrt(v.squared_length()); }

class Offset_points {
 public:
  explicit Offset_points(const std::vector<Ring>& rings) : rings_(rings), clearance_(rings) {}

  [[nodiscard]] std::vector<Rbf_constraint> run(double rho) const {
    std::vector<Rbf_constraint> result;
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      const Ring& ring = rings_[r];
      const double turn = interior_on_left(rings_, r) ? 1 : -1;
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vector_2 normal = turn * normal_at(ring, i);
        result.push_back({ring[i], 0});
        for (const double sign : {-1.0, 1.0}) {
          const double d = clearance_(ring[i], sign * normal, sign < 0, rho);
          result.push_back({ring[i] + sign * d * normal, sign * d});
        }
      }
    }
    return result;
  }

 private:
  /// The bisector of the normals to the right of both sides at a vertex; unit.
  static Vector_2 normal_at(const Ring& ring, std::size_t i) {
    const std::size_t n = ring.size();
    const Vector_2 before = unit(ring[i] - ring[(i + n - 1) % n]), after = unit(ring[(i + 1) % n] - ring[i]);
    const Vector_2 sum = before + after;
    const Vector_2 tangent = sum.squared_length() > 1e-12 ? unit(sum) : after;  // else the ring turns back on itself
    return {tangent.y(), -tangent.x()};
  }

  const std::vector<Ring>& rings_;
  Ring_clearance clearance_;
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
