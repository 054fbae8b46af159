// SPDX-License-Identifier: GPL-3.0-or-later
#include "rbf_constraints.h"
#include "thin_plate.h"

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace cgal_blend {

namespace {

constexpr std::size_t all_at_once = 420;  // so few constraints are all centres; solving takes 20 ms
constexpr std::size_t first_vertices = 60;
constexpr double offset_tolerance = 0.1;  // of an offset point's value, where not all are centres

/// Centres are chosen among the constraints, the worst met first, until all are met to their tolerance.
/// Source: Carr et al., Reconstruction and representation of 3D objects with radial basis functions (2001), section 3.
class Greedy_fit {
 public:
  Greedy_fit(std::vector<Rbf_constraint> constraints, double tolerance)
      : constraints_(std::move(constraints)), tolerance_(tolerance), chosen_(constraints_.size(), 0) {}

  [[nodiscard]] Thin_plate run() {
    const std::size_t vertices = constraints_.size() / 3;
    const std::size_t step =
        constraints_.size() <= all_at_once ? 1 : std::max<std::size_t>(1, vertices / first_vertices);
    for (std::size_t v = 0; v < vertices; v += step)
      for (std::size_t k = 0; k < 3; ++k) choose(3 * v + k);
    for (;;) {
      Thin_plate spline = fit();
      if (!choose_worst(spline)) return spline;
    }
  }

 private:
  void choose(std::size_t i) {
    chosen_[i] = 1;
    ++count_;
  }

  [[nodiscard]] Thin_plate fit() const {
    std::vector<Point_2> centres;
    std::vector<double> values;
    for (std::size_t i = 0; i < constraints_.size(); ++i) {
      if (!chosen_[i]) continue;
      centres.push_back(constraints_[i].point);
      values.push_back(constraints_[i].value);
    }
    return {centres, Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()))};
  }

  /// Adds the worst constraints, half as many as there are; false if all are met.
  bool choose_worst(const Thin_plate& spline) {
    if (count_ == constraints_.size()) return false;
    const Thin_plate_tree quick(spline);
    std::vector<std::pair<double, std::size_t>> missed;
    for (std::size_t i = 0; i < constraints_.size(); ++i) {
      if (chosen_[i]) continue;
      const double tolerance = i % 3 == 0 ? tolerance_ : offset_tolerance * std::abs(constraints_[i].value);
      const double error = std::abs(quick(constraints_[i].point) - constraints_[i].value) / tolerance;
      if (error > 1) missed.emplace_back(-error, i);
    }
    std::sort(missed.begin(), missed.end());
    if (missed.size() > count_ / 2) missed.resize(count_ / 2);
    for (const auto& [error, i] : missed) choose(i);
    return !missed.empty();
  }

  std::vector<Rbf_constraint> constraints_;
  double tolerance_;
  std::vector<char> chosen_;
  std::size_t count_ = 0;
};

}  // namespace

Opening_model rbf_opening(const Rbf_options& options) {
  CGAL_precondition(options.rho >= 0 && options.tolerance > 0);
  return [options](const std::vector<Ring>& rings) -> Planar_function {
    const double edge = mean_edge(rings), rho = options.rho > 0 ? options.rho : edge / 2;
    const auto spline = std::make_shared<const Thin_plate_tree>(
        Greedy_fit(rbf_constraints(rings, rho), options.tolerance * edge).run());
    return [spline](const Point_2& p) { return (*spline)(p); };
  };
}

}  // namespace cgal_blend
