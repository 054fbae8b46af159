// SPDX-License-Identifier: GPL-3.0-or-later
#include "unfold_chart.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cgal_blend {

namespace {

// More would unfold more, but move what lies around far from its geodesic distance.
constexpr int angle_rounds = 12, place_rounds = 12, place_rounds_in_band = 60;
constexpr int patience = 18;  // rounds without fewer folds

class Unfolding {
 public:
  Unfolding(const Region_mesh& region, Chart_kind kind, double thin, double limit, Geodesic_field& field)
      : region_(region), kind_(kind), thin_(thin), limit_(limit), field_(field), is_fixed_(field.at.size(), 0) {
    for (const std::int32_t v : field.fixed) is_fixed_[v] = 1;
    for (std::int32_t t = 0; t < static_cast<std::int32_t>(region.triangles().size()); ++t)
      if (is_folded(t)) folded_.push_back(t);
  }

  void run() {
    std::size_t fewest = folded_.size();
    int since = 0;
    const int rounds = angle_rounds + (kind_ == Chart_kind::disk ? place_rounds : place_rounds_in_band);
    for (int round = 0; round < rounds && since < patience && !folded_.empty(); ++round) {
      const std::vector<std::int32_t> vertices = movable();
      for (const std::int32_t v : vertices) move(v, round >= angle_rounds);
      collect(vertices);
      since = folded_.size() < fewest ? 0 : since + 1;
      fewest = std::min(fewest, folded_.size());
    }
  }

 private:
  /// The place of a vertex in the chart, in a band relative to an angle.
  [[nodiscard]] Eigen::Vector2d place(std::int32_t v, double around) const {
    const auto& [distance, angle] = field_.at[v];
    if (kind_ == Chart_kind::band) return {around + turn(around, angle), distance};
    return {distance * std::cos(angle), distance * std::sin(angle)};
  }

  [[nodiscard]] Kernel::Point_2 point(std::int32_t v, double around) const {
    const Eigen::Vector2d p = place(v, around);
    return {p.x(), p.y()};
  }

  [[nodiscard]] bool is_folded(std::int32_t t) const {
    const auto& corner = region_.triangles()[t].corner;
    for (const std::int32_t v : corner)
      if (!(field_.at[v].distance <= limit_)) return false;
    const double around = field_.at[corner[0]].angle;
    const bool upright = CGAL::orientation(point(corner[0], around), point(corner[1], around),
                                           point(corner[2], around)) == CGAL::LEFT_TURN;
    return !upright && (kind_ == Chart_kind::band || region_.height(t) >= thin_);
  }

  /// The corners of folded triangles, but the source and what has its coordinates from the start.
  [[nodiscard]] std::vector<std::int32_t> movable() const {
    std::vector<std::int32_t> vertices;
    for (const std::int32_t t : folded_)
      for (const std::int32_t v : region_.triangles()[t].corner)
        if (field_.at[v].distance > 0 && !is_fixed_[v]) vertices.push_back(v);
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
  }

  /// With mean value weights, which leave a vertex where it is if the chart around it is linear (Floater 2003).
  void move(std::int32_t v, bool freely) {
    auto& [distance, angle] = field_.at[v];
    const Vec& origin = region_.points()[v];
    const double around = angle;
    Eigen::Vector2d sum(0, 0);
    double turns = 0, weights = 0;
    bool inside = true;
    region_.for_star(v, [&](std::int32_t t, int slot) {
      const auto& [corner, beyond] = region_.triangles()[t];
      const std::int32_t p = corner[(slot + 1) % 3], q = corner[(slot + 2) % 3];
      inside = inside && field_.at[p].distance <= limit_ && beyond[(slot + 2) % 3] >= 0;
      if (!inside) return;
      const Vec to_p = region_.points()[p] - origin, to_q = region_.points()[q] - origin;
      const double tangent = std::tan(0.5 * angle_between(to_p, to_q));
      for (const auto& [w, weight] : {std::pair{p, tangent / to_p.norm()}, std::pair{q, tangent / to_q.norm()}}) {
        turns += weight * turn(around, field_.at[w].angle);
        sum += weight * place(w, around);
        weights += weight;
      }
    });
    if (!inside || !(weights > 0) || !std::isfinite(weights)) return;
    if (!freely) {
      angle = wrapped(around + turns / weights);
      return;
    }
    sum /= weights;
    distance = kind_ == Chart_kind::band ? sum.y() : sum.norm();
    angle = wrapped(kind_ == Chart_kind::band ? sum.x() : std::atan2(sum.y(), sum.x()));
  }

  /// The folded ones among those that were or that meet what was moved.
  void collect(const std::vector<std::int32_t>& vertices) {
    for (const std::int32_t v : vertices) region_.for_star(v, [&](std::int32_t t, int) { folded_.push_back(t); });
    std::sort(folded_.begin(), folded_.end());
    folded_.erase(std::unique(folded_.begin(), folded_.end()), folded_.end());
    folded_.erase(std::remove_if(folded_.begin(), folded_.end(), [&](std::int32_t t) { return !is_folded(t); }),
                  folded_.end());
  }

  const Region_mesh& region_;
  Chart_kind kind_;
  double thin_, limit_;
  Geodesic_field& field_;
  std::vector<char> is_fixed_;
  std::vector<std::int32_t> folded_;
};

}  // namespace

void unfold_chart(const Region_mesh& region, Chart_kind kind, double thin, double limit, Geodesic_field& field) {
  Unfolding(region, kind, thin, limit, field).run();
}

}  // namespace cgal_blend
