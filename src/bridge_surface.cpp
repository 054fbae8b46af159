// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge_surface.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace cgal_blend {

namespace {

constexpr double most_lambda = 1 - 1e-9;
constexpr int grid = 24;  // steps of the search for a start, along each lambda
constexpr int most_iterations = 50;

/// Squared distance from the target, with what Newton's method needs.
struct Misfit {
  const Bridge_column& column;
  double t, f;
  Vec target;

  [[nodiscard]] std::array<double, 2> places(const Eigen::Vector2d& lambda) const {
    return {1 - t * (1 - lambda[0]), 1 - (1 - t) * (1 - lambda[1])};
  }
  [[nodiscard]] Vec residual(const Eigen::Vector2d& lambda) const {
    const auto x = places(lambda);
    return f * column.ray[0].point(x[0]) + (1 - f) * column.ray[1].point(x[1]) - target;
  }
  [[nodiscard]] Eigen::Matrix<double, 3, 2> jacobian(const Eigen::Vector2d& lambda) const {
    const auto x = places(lambda);
    Eigen::Matrix<double, 3, 2> j;
    j.col(0) = f * t * column.ray[0].derivative(x[0]);
    j.col(1) = (1 - f) * (1 - t) * column.ray[1].derivative(x[1]);
    return j;
  }
};

Eigen::Vector2d best_of_grid(const Misfit& misfit) {
  // The two ends contribute to the point independently.
  std::array<std::vector<Vec>, 2> part;
  for (int i = 0; i <= grid; ++i) {
    const double lambda = most_lambda * i / grid;
    const auto x = misfit.places({lambda, lambda});
    part[0].push_back(misfit.f * misfit.column.ray[0].point(x[0]) - misfit.target);
    part[1].push_back((1 - misfit.f) * misfit.column.ray[1].point(x[1]));
  }
  Eigen::Vector2d best(0, 0);
  double least = -1;
  for (int i = 0; i <= grid; ++i)
    for (int j = 0; j <= grid; ++j) {
      const double d = (part[0][i] + part[1][j]).squaredNorm();
      if (least >= 0 && d >= least) continue;
      least = d;
      best = {most_lambda * i / grid, most_lambda * j / grid};
    }
  return best;
}

/// Levenberg's step within the box: lambdas at a bound that the step would leave by stay there.
Eigen::Vector2d step_within(const Eigen::Vector2d& at, const Eigen::Matrix2d& normal, const Eigen::Vector2d& gradient) {
  std::array<bool, 2> fixed{};
  Eigen::Vector2d step = -normal.ldlt().solve(gradient);
  for (int pass = 0; pass < 2; ++pass) {
    for (int k = 0; k < 2; ++k)
      if (!fixed[k] && ((at[k] <= 0 && step[k] < 0) || (at[k] >= most_lambda && step[k] > 0))) fixed[k] = true;
    for (int k = 0; k < 2; ++k) {
      if (!fixed[k]) continue;
      step[k] = 0;
      step[1 - k] = fixed[1 - k] ? 0 : -gradient[1 - k] / normal(1 - k, 1 - k);
    }
  }
  return step;
}

}  // namespace

double hartmann(double t, double mu, int order) {
  const double a = mu * std::pow(1 - t, order + 1), b = (1 - mu) * std::pow(t, order + 1);
  return a / (a + b);
}

Vec Bridge_column::point(double t, const Bridge_shape& shape) const {
  const double f = hartmann(t, shape.mu, shape.order);
  return f * ray[0].point(1 - t * (1 - shape.lambda[0])) + (1 - f) * ray[1].point(1 - (1 - t) * (1 - shape.lambda[1]));
}

std::array<double, 2> nearest_lambdas(const Bridge_column& column, double t, const Bridge_shape& shape,
                                      const Vec& target) {
  const Misfit misfit{column, t, hartmann(t, shape.mu, shape.order), target};
  Eigen::Vector2d at = best_of_grid(misfit);
  double damping = 1e-4, squared = misfit.residual(at).squaredNorm();
  for (int i = 0; i < most_iterations; ++i) {
    const Eigen::Matrix<double, 3, 2> j = misfit.jacobian(at);
    const Eigen::Matrix2d product = j.transpose() * j;
    const double scale = product.trace();
    if (!(scale > 0)) break;  // at a contact, which lambdas do not move
    const Eigen::Vector2d gradient = j.transpose() * misfit.residual(at);
    const Eigen::Vector2d step = step_within(at, product + damping * scale * Eigen::Matrix2d::Identity(), gradient);
    const Eigen::Vector2d next = (at + step).cwiseMax(0.0).cwiseMin(most_lambda);
    const double then = misfit.residual(next).squaredNorm();
    if (then < squared) {
      const bool still = (next - at).norm() < 1e-14;
      at = next;
      squared = then;
      damping = std::max(damping / 10, 1e-15);
      if (still) break;
    } else if ((damping *= 10) > 1e6) {
      break;
    }
  }
  return {at[0], at[1]};
}

double opposite_parameter(double s, double turn) {
  const double r = turn - s;
  const double part = r - std::floor(r);
  return part < 1 ? part : 0;
}

double least_twist(const std::vector<Vec>& first, const std::vector<Vec>& second) {
  // Sum |a_k - b_(j-k)|^2 is constant but for the scalar products, whose sum is to be the largest.
  const std::size_t n = first.size();
  Vec mean = Vec::Zero();  // products about it lose no digits to the distance from the origin
  for (std::size_t k = 0; k < n; ++k) mean += (first[k] + second[k]) / (2.0 * static_cast<double>(n));
  const auto sum = [&](std::size_t j) {
    double s = 0;
    for (std::size_t k = 0; k < n; ++k) s += (first[k] - mean).dot(second[(j + n - k) % n] - mean);
    return s;
  };
  std::vector<double> sums;
  for (std::size_t j = 0; j < n; ++j) sums.push_back(sum(j));
  const auto best = static_cast<std::size_t>(std::max_element(sums.begin(), sums.end()) - sums.begin());
  const double before = sums[(best + n - 1) % n], at = sums[best], after = sums[(best + 1) % n];
  const double bend = before - 2 * at + after;  // the parabola through three neighbours has its top there
  const double offset = bend < 0 ? std::clamp(0.5 * (before - after) / bend, -0.5, 0.5) : 0;
  return opposite_parameter(-(static_cast<double>(best) + offset) / static_cast<double>(n), 0);
}

}  // namespace cgal_blend
