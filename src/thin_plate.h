// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_THIN_PLATE_H
#define CGAL_BLEND_SRC_THIN_PLATE_H

#include <cgal_blend/implicit_opening.h>

#include <Eigen/Core>

#include <array>
#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

namespace cgal_blend {

/// Thin plate spline sum_i l_i phi(|x - x_i|) + p0 + p1 x + p2 y, phi(r) = r^2 log r, in coordinates that are centred and
/// scaled so that the centres lie in the unit square about 0.
class Thin_plate {
 public:
  /// Interpolates the values; the centres are distinct and not all on one line.
  /// Source: Jin et al. (2006), equations 2 to 5. The bordered matrix is symmetric, but indefinite: LU with pivoting.
  Thin_plate(const std::vector<Point_2>& centres, const Eigen::VectorXd& values);

  /// The sum term by term.
  [[nodiscard]] double operator()(const Point_2& p) const;
  [[nodiscard]] const Eigen::ArrayXd& x() const { return x_; }
  [[nodiscard]] const Eigen::ArrayXd& y() const { return y_; }
  [[nodiscard]] const Eigen::ArrayXd& weights() const { return weights_; }
  [[nodiscard]] const Eigen::Vector3d& linear() const { return linear_; }
  /// The coordinates that centres and weights are in.
  [[nodiscard]] Eigen::Vector2d local(const Point_2& p) const {
    return {(p.x() - origin_[0]) * scale_, (p.y() - origin_[1]) * scale_};
  }

 private:
  std::array<double, 2> origin_{};
  double scale_ = 1;
  Eigen::ArrayXd x_, y_, weights_;
  Eigen::Vector3d linear_;
};

/// The same function at a cost that hardly grows with the number of centres: a quadtree whose leaves sum the few centres
/// near them term by term, and hold the others as a Chebyshev polynomial, handed down from cell to cell.
/// What is far lies at least three half-widths from a cell's middle, where phi is analytic within the ellipse of Bernstein of
/// 2 + sqrt(5): the error falls by 4.2 with each degree, to 1e-6 of the sum of the terms' sizes for degree 9.
/// Cells are made when first asked for, and may be asked for by several threads.
class Thin_plate_tree {
 public:
  explicit Thin_plate_tree(const Thin_plate& spline);
  [[nodiscard]] double operator()(const Point_2& p) const;

  static constexpr int order = 10;  ///< coefficients each way

 private:
  using Coefficients = Eigen::Matrix<double, order, order, Eigen::DontAlign>;
  struct Node;
  struct Children;
  struct Delete_children {
    void operator()(Children* children) const;
  };
  struct Node {
    double x, y, half;
    std::vector<int> near;
    Coefficients far;
    std::unique_ptr<Children, Delete_children> owner;
    std::atomic<Children*> children{nullptr};

    [[nodiscard]] double far_sum(double u, double v) const;
  };

  void fill(Node& node, const std::vector<int>& candidates, const Node* parent) const;
  [[nodiscard]] Children& divide(Node& node) const;
  [[nodiscard]] double term(int centre, double x, double y) const;

  Thin_plate spline_;
  mutable std::mutex dividing_;
  mutable Node root_;
};

}  // namespace cgal_blend

#endif
