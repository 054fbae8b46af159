// SPDX-License-Identifier: GPL-3.0-or-later
#include "thin_plate.h"

#include <CGAL/Bbox_2.h>
#include <CGAL/number_utils.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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

struct Thin_plate_tree::Children {
  std::array<Node, 4> nodes;
};

void Thin_plate_tree::Delete_children::operator()(Children* children) const { delete children; }

Thin_plate_tree::Thin_plate_tree(const Thin_plate& spline) : spline_(spline) {
  std::vector<int> all(static_cast<std::size_t>(spline.x().size()));
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
  root_.x = root_.y = 0;
  root_.half = root_half;
  fill(root_, all, nullptr);
}

/// Parts the candidates into near and far ones, and samples the far part, with what the parent has as such.
void Thin_plate_tree::fill(Node& node, const std::vector<int>& candidates, const Node* parent) const {
  std::vector<int> far_away;
  for (const int i : candidates) {
    const double away = std::max(std::abs(spline_.x()[i] - node.x), std::abs(spline_.y()[i] - node.y));
    (away < near_halves * node.half ? node.near : far_away).push_back(i);
  }
  const Centres far_centres(spline_, far_away);
  Square_matrix values;
  for (int j = 0; j < order; ++j)
    for (int i = 0; i < order; ++i) {
      const double u = node.x + node.half * grid().places[i], v = node.y + node.half * grid().places[j];
      const double inherited = parent ? parent->far_sum(u, v) : spline_.linear().dot(Eigen::Vector3d(1, u, v));
      values(i, j) = inherited + far_centres.sum(u, v);
    }
  node.far = grid().transform * values * grid().transform.transpose();
}

Thin_plate_tree::Children& Thin_plate_tree::divide(Node& node) const {
  const std::lock_guard<std::mutex> lock(dividing_);
  if (Children* made = node.children.load(std::memory_order_relaxed)) return *made;
  std::unique_ptr<Children, Delete_children> children(new Children);
  for (std::size_t k = 0; k < 4; ++k) {
    Node& child = children->nodes[k];
    child.half = node.half / 2;
    child.x = node.x + (k & 1U ? child.half : -child.half);
    child.y = node.y + (k & 2U ? child.half : -child.half);
    fill(child, node.near, &node);
  }
  node.owner = std::move(children);
  node.children.store(node.owner.get(), std::memory_order_release);
  return *node.owner;
}

double Thin_plate_tree::Node::far_sum(double u, double v) const {
  const Nodes s = chebyshev((u - x) / half), t = chebyshev((v - y) / half);
  return s.dot(far * t);
}

double Thin_plate_tree::term(int centre, double x, double y) const {
  return spline_.weights()[centre] *
         plate(CGAL::square(spline_.x()[centre] - x) + CGAL::square(spline_.y()[centre] - y));
}

double Thin_plate_tree::operator()(const Point_2& p) const {
  const Eigen::Vector2d q = spline_.local(p);
  if (!(std::max(std::abs(q.x()), std::abs(q.y())) <= root_half)) return spline_(p);
  Node* node = &root_;
  while (node->near.size() > leaf_centres && node->half > least_half) {
    Children* children = node->children.load(std::memory_order_acquire);
    if (!children) children = &divide(*node);
    node = &children->nodes[(q.x() > node->x ? 1U : 0U) + (q.y() > node->y ? 2U : 0U)];
  }
  double sum = node->far_sum(q.x(), q.y());
  for (const int i : node->near) sum += term(i, q.x(), q.y());
  return sum;
}

}  // namespace cgal_blend
