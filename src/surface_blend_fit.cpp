// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/surface_blend_fit.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>

namespace cgal_blend {

namespace {

constexpr int first_spans = 4, most_halvings = 14, samples_per_span = 8;
constexpr double difference_step = 2e-5;

using Points = std::vector<Point_3>;
using Vectors = std::vector<Vector_3>;

/// Control points at a parameter with their derivatives by it.
struct Node {
  double s;
  Points points;
  Vectors slopes;
};

class Fitter {
 public:
  Fitter(const Surface_blend& blend, double tolerance) : blend_(blend), tolerance_(tolerance) {}

  bool run() {
    nodes_.push_back(node(0));
    for (int i = 1; i <= first_spans; ++i)
      if (!add_spans(nodes_.back(), node(static_cast<double>(i) / first_spans), most_halvings)) return false;
    return true;
  }

  [[nodiscard]] Bspline_surface surface() const {
    Bspline_surface result;
    result.degree_t = blend_.degree();
    result.error = error_;
    result.control.push_back(nodes_.front().points);
    for (std::size_t i = 0; i + 1 < nodes_.size(); ++i) {
      const double third = (nodes_[i + 1].s - nodes_[i].s) / 3;
      result.control.push_back(moved(nodes_[i], third));
      result.control.push_back(moved(nodes_[i + 1], -third));
    }
    result.control.push_back(nodes_.back().points);
    for (const Node& n : nodes_) result.knots.push_back(n.s);
    return result;
  }

 private:
  [[nodiscard]] Points points(double s) const {
    const Blend_column column = blend_.column(blend_.is_closed() ? s - std::floor(s) : s);
    return {column.control.begin(), column.control.begin() + column.degree + 1};
  }

  /// Differences of fourth order; on open blends from one side at the ends.
  [[nodiscard]] Node node(double s) const {
    const double h = difference_step;
    const bool at_start = !blend_.is_closed() && s < 2 * h, at_end = !blend_.is_closed() && s > 1 - 2 * h;
    // Weights of f(s + k h), k from `first` on.
    const int first = at_start ? 0 : at_end ? -4 : -2;
    std::array<double, 5> weights{1. / 12, -2. / 3, 0, 2. / 3, -1. / 12};
    if (at_start) weights = {-25. / 12, 4, -3, 4. / 3, -1. / 4};
    if (at_end) weights = {1. / 4, -4. / 3, 3, -4, 25. / 12};
    Node result{s, points(s), Vectors(static_cast<std::size_t>(blend_.degree()) + 1, Vector_3(0, 0, 0))};
    for (int k = 0; k < 5; ++k) {
      if (weights[k] == 0) continue;
      const Points beside = points(s + (first + k) * h);
      for (std::size_t j = 0; j < beside.size(); ++j)
        result.slopes[j] = result.slopes[j] + weights[k] / h * (beside[j] - result.points[j]);
    }
    return result;
  }

  static Points moved(const Node& n, double step) {
    Points result;
    for (std::size_t j = 0; j < n.points.size(); ++j) result.push_back(n.points[j] + step * n.slopes[j]);
    return result;
  }

  /// Largest distance of the control points between two nodes: the surface strays no farther.
  [[nodiscard]] double error_between(const Node& a, const Node& b) const {
    const double third = (b.s - a.s) / 3;
    const Points p = moved(a, third), q = moved(b, -third);
    double largest = 0;
    for (int k = 1; k < samples_per_span; ++k) {
      const double x = static_cast<double>(k) / samples_per_span, y = 1 - x;
      const Points exact = points(a.s + x * (b.s - a.s));
      for (std::size_t j = 0; j < exact.size(); ++j) {
        const Vector_3 fitted = 3 * x * y * y * (p[j] - a.points[j]) + 3 * x * x * y * (q[j] - a.points[j]) +
                                x * x * x * (b.points[j] - a.points[j]);
        largest = std::max(largest, ((a.points[j] + fitted) - exact[j]).squared_length());
      }
    }
    return std::sqrt(largest);
  }

  bool add_spans(const Node& a, const Node& b, int halvings) {
    const double error = error_between(a, b);
    if (error <= tolerance_) {
      error_ = std::max(error_, error);
      nodes_.push_back(b);
      return true;
    }
    if (halvings == 0) return false;
    const Node from = a, middle = node((a.s + b.s) / 2);
    return add_spans(from, middle, halvings - 1) && add_spans(middle, b, halvings - 1);
  }

  const Surface_blend& blend_;
  double tolerance_, error_ = 0;
  std::vector<Node> nodes_;
};

/// Largest angle between fitted and true normals along both boundaries.
double normal_error(const Surface_blend& blend, const Bspline_surface& surface) {
  constexpr double step = 1e-6;
  double largest = 0;
  for (std::size_t i = 0; i + 1 < surface.knots.size(); ++i)
    for (int k = 1; k < samples_per_span; k += 2)
      for (const int side : {0, 1}) {
        const double s = surface.knots[i] + k * (surface.knots[i + 1] - surface.knots[i]) / samples_per_span;
        const Vector_3 along = surface.at(s + step, side) - surface.at(s - step, side);
        const Vector_3 across = surface.at(s, side == 0 ? step : 1 - step) - surface.at(s, side);
        const Vector_3 normal = CGAL::cross_product(along, across), truth = blend.normal(s, side);
        largest = std::max(largest, std::atan2(std::sqrt(CGAL::cross_product(normal, truth).squared_length()),
                                               std::abs(normal * truth)));
      }
  return largest;
}

}  // namespace

std::optional<Bspline_surface> fit_bspline(const Surface_blend& blend, double tolerance) {
  CGAL_precondition(tolerance > 0);
  Fitter fitter(blend, tolerance);
  if (!fitter.run()) return std::nullopt;
  Bspline_surface surface = fitter.surface();
  surface.normal_error = normal_error(blend, surface);
  return surface;
}

}  // namespace cgal_blend
