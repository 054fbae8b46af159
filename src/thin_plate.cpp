// SPDX-License-Identifier: GPL-3.0-or-later
#include "thin_plate.h"

#include <CGAL/Bbox_2.h>
#include <CGAL/number_utils.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cgal_blend {

namespace {

constexpr int order = Thin_plate_tree::order;
constexpr double root_half = 8;    // the tree reaches so far about centres in [-1, 1]; beyond it sums directly
constexpr double near_halves = 3;  // what is nearer to the middle of a cell is summed there
constexpr std::size_t leaf_centres = 32;
constexpr double least_half = 1e-6;
constexpr double pi = 3.14159265358979323846;

/// phi of a squared distance.
double plate(double squared) { return squared > 0 ? 0.5 * squared * std::log(squared) : 0; }

using Nodes = Eigen::Matrix<double, order, 1>;
using Square_matrix = Eigen::Matrix<double, order, order>;

/// Chebyshev polynomials T_0 .. T_(order - 1) at u.
Nodes chebyshev(double u) {
  Nodes t;
  t[0] = 1;
  t[1] = u;
  for (int k = 2; k < order; ++k) t[k] = 2 * u * t[k - 1] - t[k - 2];
  return t;
}

struct Chebyshev_grid {
  Nodes places;
  Square_matrix transform;  ///< values at the places to coefficients

  Chebyshev_grid() {
    for (int i = 0; i < order; ++i) places[i] = std::cos(pi * (i + 0.5) / order);
    for (int i = 0; i < order; ++i) transform.col(i) = chebyshev(places[i]) * 2 / order;
    transform.row(0) /= 2;
  }
};

const Chebyshev_grid& grid() {
  static const Chebyshev_grid result;
  return result;
}

/// Some terms of a spline, side by side in memory.
struct Centres {
  Eigen::ArrayXd x, y, weights;

  Centres(const Thin_plate& spline, const std::vector<int>& chosen) {
    const auto n = static_cast<Eigen::Index>(chosen.size());
    x.resize(n);
    y.resize(n);
    weights.resize(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const int c = chosen[static_cast<std::size_t>(i)];
      x[i] = spline.x()[c];
      y[i] = spline.y()[c];
      weights[i] = spline.weights()[c];
    }
  }
  /// Not at a centre.
  [[nodiscard]] double sum(double u, double v) const {
    const auto squared = (x - u).square() + (y - v).square();
    return 0.5 * (weights * squared * squared.log()).sum();
  }
};

}  // namespace

Thin_plate::Thin_plate(const std::vector<Point_2>& centres, const Eigen::VectorXd& values) {
  CGAL::Bbox_2 box;
  for (const Point_2& p : centres) box += p.bbox();
  origin_ = {(box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2};
  scale_ = 2 / std::max(box.xmax() - box.xmin(), box.ymax() - box.ymin());
  const auto n = static_cast<Eigen::Index>(centres.size());
  x_.resize(n);
  y_.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector2d p = local(centres[static_cast<std::size_t>(i)]);
    x_[i] = p.x();
    y_[i] = p.y();
  }
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + 3, n + 3);
  for (Eigen::Index j = 0; j < n; ++j) {
    for (Eigen::Index i = 0; i < j; ++i)
      matrix(i, j) = matrix(j, i) = plate(CGAL::square(x_[i] - x_[j]) + CGAL::square(y_[i] - y_[j]));
    matrix.col(j).tail<3>() = matrix.row(j).tail<3>().transpose() = Eigen::Vector3d(1, x_[j], y_[j]);
  }
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n + 3);
  right.head(n) = values;
  const Eigen::VectorXd solution = Eigen::PartialPivLU<Eigen::Ref<Eigen::MatrixXd>>(matrix).solve(right);
  weights_ = solution.head(n).array();
  linear_ = solution.tail<3>();
}

double Thin_plate::operator()(const Point_2& p) const {
  const Eigen::Vector2d q = local(p);
  const auto squared = (x_ - q.x()).square() + (y_ - q.y()).square();
  const double tiny = std::numeric_limits<double>::min();  // at a centre: 0 * log(tiny)
  return linear_[0] + linear_[1] * q.x() + linear_[2] * q.y() +
         0.5 * (weights_ * squared * squared.max(tiny).log()).sum();
}

Thin_plate_tree::Thin_plate_tree(const Thin_plate& spline) : spline_(spline) {
  std::vector<int> all(static_cast<std::size_t>(spline.x().size()));
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
  add(0, 0, root_half, all, -1);
}

int Thin_plate_tree::add(double x, double y, double half, const std::vector<int>& candidates, int parent) {
  Node node{x, y, half, {-1, -1, -1, -1}, {}, {}};
  std::vector<int> far_away;
  for (const int i : candidates) {
    const bool near = std::max(std::abs(spline_.x()[i] - x), std::abs(spline_.y()[i] - y)) < near_halves * half;
    (near ? node.near : far_away).push_back(i);
  }
  const Centres far_centres(spline_, far_away);
  Square_matrix values;
  for (int j = 0; j < order; ++j)
    for (int i = 0; i < order; ++i) {
      const double u = x + half * grid().places[i], v = y + half * grid().places[j];
      const double sum = parent < 0 ? spline_.linear().dot(Eigen::Vector3d(1, u, v))
                                    : far(nodes_[static_cast<std::size_t>(parent)], u, v);
      values(i, j) = sum + far_centres.sum(u, v);
    }
  node.far = grid().transform * values * grid().transform.transpose();
  const int index = static_cast<int>(nodes_.size());
  nodes_.push_back(std::move(node));
  const std::vector<int> near = nodes_.back().near;
  if (near.size() <= leaf_centres || half < least_half) return index;
  for (int k = 0; k < 4; ++k) {
    const double quarter = half / 2;
    const int child = add(x + (k & 1 ? quarter : -quarter), y + (k & 2 ? quarter : -quarter), quarter, near, index);
    nodes_[static_cast<std::size_t>(index)].child[static_cast<std::size_t>(k)] = child;
  }
  return index;
}

double Thin_plate_tree::far(const Node& node, double x, double y) const {
  const Nodes s = chebyshev((x - node.x) / node.half), t = chebyshev((y - node.y) / node.half);
  return s.dot(node.far * t);
}

double Thin_plate_tree::term(int centre, double x, double y) const {
  return spline_.weights()[centre] *
         plate(CGAL::square(spline_.x()[centre] - x) + CGAL::square(spline_.y()[centre] - y));
}

double Thin_plate_tree::operator()(const Point_2& p) const {
  const Eigen::Vector2d q = spline_.local(p);
  if (!(std::max(std::abs(q.x()), std::abs(q.y())) <= root_half)) return spline_(p);
  const Node* node = &nodes_.front();
  while (node->child[0] >= 0) {
    const std::size_t k = (q.x() > node->x ? 1U : 0U) + (q.y() > node->y ? 2U : 0U);
    node = &nodes_[static_cast<std::size_t>(node->child[k])];
  }
  double sum = far(*node, q.x(), q.y());
  for (const int i : node->near) sum += term(i, q.x(), q.y());
  return sum;
}

}  // namespace cgal_blend
