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

constexpr std::size_t few_vertices = 100;   // so few are all centres at once; solving takes 10 ms
constexpr std::size_t first_vertices = 50;  // of more, about so many begin
constexpr double least_vertices = 32;       // of a ring; sides longer than their mean edge are divided
constexpr double offset_tolerance = 0.25;   // of an offset point's value, where not all are centres
constexpr Eigen::Index few_centres = 48;    // a tree does not pay

/// Rings with vertices along long sides, so that the spline keeps to a box's edges as it does to a finely cut ring.
std::vector<Ring> subdivided(const std::vector<Ring>& rings) {
  std::vector<Ring> result;
  for (const Ring& ring : rings) {
    const double longest = mean_edge({ring}) * static_cast<double>(ring.size()) / least_vertices;
    Ring& fine = result.emplace_back();
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point_2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
      const double parts = std::max(1.0, std::ceil(std::sqrt(CGAL::squared_distance(a, b)) / longest));
      for (double k = 0; k < parts; ++k) fine.push_back(a + k / parts * (b - a));
    }
  }
  return result;
}

/// Centres are chosen among the constraints until all are met to their tolerance. Vertices, inner and outer points are
/// three sequences; between two centres of a sequence the worst point that misses its tolerance becomes one, so that
/// centres do not crowd where the first spline is worst.
/// Source: Carr et al., Reconstruction and representation of 3D objects with radial basis functions (2001), section 3.
class Greedy_fit {
 public:
  Greedy_fit(std::vector<Rbf_constraint> constraints, double tolerance)
      : constraints_(std::move(constraints)), tolerance_(tolerance), chosen_(constraints_.size(), 0) {}

  [[nodiscard]] Thin_plate run() {
    const std::size_t vertices = constraints_.size() / 3;
    const std::size_t step = vertices <= few_vertices ? 1 : vertices / first_vertices;
    for (std::size_t v = 0; v < vertices; v += step)
      for (std::size_t k = 0; k < 3; ++k) chosen_[3 * v + k] = 1;
    for (;;) {
      Thin_plate spline = fit();
      if (step == 1 || !choose_more(spline)) return spline;
    }
  }

 private:
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

  /// Of the value wanted, in tolerances.
  [[nodiscard]] double error(const Thin_plate& spline, std::size_t i) const {
    const auto& [point, value] = constraints_[i];
    return std::abs(spline(point) - value) / (i % 3 == 0 ? tolerance_ : offset_tolerance * std::abs(value));
  }

  /// Returns false if all constraints are met.
  bool choose_more(const Thin_plate& spline) {
    std::vector<std::size_t> more;
    for (std::size_t k = 0; k < 3; ++k) {
      std::size_t worst = 0;
      double largest = 1;
      const auto end_gap = [&] {
        if (largest > 1) more.push_back(worst);
        largest = 1;
      };
      for (std::size_t i = k; i < constraints_.size(); i += 3) {
        if (chosen_[i]) {
          end_gap();
        } else if (const double e = error(spline, i); e > largest) {
          largest = e;
          worst = i;
        }
      }
      end_gap();
    }
    for (const std::size_t i : more) chosen_[i] = 1;
    return !more.empty();
  }

  std::vector<Rbf_constraint> constraints_;
  double tolerance_;
  std::vector<char> chosen_;
};

/// Shared, as a std::function copies what it holds.
template <class Function>
Planar_function shared(std::shared_ptr<const Function> f) {
  return [f = std::move(f)](const Point_2& p) { return (*f)(p); };
}

}  // namespace

Opening_model rbf_opening(const Rbf_options& options) {
  CGAL_precondition(options.rho >= 0 && options.tolerance > 0);
  return [options](const std::vector<Ring>& given) -> Planar_function {
    const std::vector<Ring> rings = subdivided(given);
    const double edge = mean_edge(rings), rho = options.rho > 0 ? options.rho : edge / 2;
    Thin_plate spline = Greedy_fit(rbf_constraints(rings, rho), options.tolerance * edge).run();
    if (spline.x().size() <= few_centres) return shared(std::make_shared<const Thin_plate>(std::move(spline)));
    return shared(std::make_shared<const Thin_plate_tree>(spline));
  };
}

}  // namespace cgal_blend
