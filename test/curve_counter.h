// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_TEST_CURVE_COUNTER_H
#define CGAL_BLEND_TEST_CURVE_COUNTER_H

#include "quadric_pairs.h"

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>

#include <cmath>
#include <optional>
#include <random>
#include <vector>

namespace cgal_blend::test {

/// Counts the components of the intersection of two quadrics in doubles: finds points on many planes, follows the curve
/// through each on the unit sphere of homogeneous coordinates until it closes, and counts how often it crosses infinity.
/// Good for curves without singular points that touch the plane at infinity nowhere; shares no code with the library.
class Curve_counter {
 public:
  Curve_counter(const Quadric_3& a, const Quadric_3& b) : a_(matrix(a)), b_(matrix(b)) {}

  /// Returns the parts, or nothing if the curve bends too sharply somewhere to be followed.
  std::optional<Parts> count() {
    Parts result;
    std::vector<Point> seeds = find_seeds();
    while (!seeds.empty()) {
      const auto loop = follow(seeds.back());
      if (!loop) return std::nullopt;
      const int crossings = count_crossings(*loop);
      ++(crossings == 0 ? result.closed : result.open);
      result.open += std::max(0, crossings - 1);
      std::vector<Point> rest;
      for (std::size_t i = 0; i + 1 < seeds.size(); ++i)
        if (!is_on(seeds[i], *loop)) rest.push_back(seeds[i]);
      seeds = rest;
    }
    return result;
  }

 private:
  using Point = Eigen::Vector4d;
  using Matrix = Eigen::Matrix4d;

  static constexpr int planes_per_pencil = 90;
  static constexpr double longest_step = 0.03, shortest_step = 1e-6, largest_turn = 0.15;

  static Matrix matrix(const Quadric_3& q) {
    std::array<double, 10> c;
    for (std::size_t k = 0; k < 10; ++k) c[k] = CGAL::to_double(q.coefficients()[k]);
    Matrix m;
    m << 2 * c[0], c[3], c[4], c[6], c[3], 2 * c[1], c[5], c[7], c[4], c[5], 2 * c[2], c[8], c[6], c[7], c[8], 2 * c[9];
    return m / m.norm();
  }

  // The point on both quadrics and the sphere that is nearest, or that lies in a plane if one is given.
  [[nodiscard]] std::optional<Point> corrected(Point x, const Point* plane = nullptr) const {
    for (int k = 0; k < 20; ++k) {
      Eigen::Matrix<double, 4, 4> j = Eigen::Matrix4d::Zero();
      Eigen::Vector4d f = Eigen::Vector4d::Zero();
      j.row(0) = 2 * (a_ * x).transpose();
      j.row(1) = 2 * (b_ * x).transpose();
      j.row(2) = 2 * x.transpose();
      f << x.dot(a_ * x), x.dot(b_ * x), x.squaredNorm() - 1, 0;
      if (plane) {
        j.row(3) = plane->transpose();
        f[3] = plane->dot(x);
      } else {
        j.row(3) = tangent(x).transpose();
      }
      const Point step = j.partialPivLu().solve(f);
      x -= step;
      if (!(step.norm() < 1e3)) return std::nullopt;
      if (step.norm() < 1e-13) return x;
    }
    return std::nullopt;
  }

  // Orthogonal to both gradients and to the point: the generalized cross product.
  [[nodiscard]] Point tangent(const Point& x) const {
    Eigen::Matrix<double, 3, 4> rows;
    rows << (a_ * x).transpose(), (b_ * x).transpose(), x.transpose();
    Point t;
    for (int i = 0; i < 4; ++i) {
      Eigen::Matrix3d minor;
      for (int j = 0, k = 0; j < 4; ++j)
        if (j != i) minor.col(k++) = rows.col(j);
      t[i] = (i % 2 == 0 ? 1 : -1) * minor.determinant();
    }
    return t.normalized();
  }

  std::vector<Point> find_seeds() {
    std::vector<Point> seeds;
    std::normal_distribution<double> normal;
    for (int pencil = 0; pencil < 4; ++pencil) {
      Matrix random;
      for (int i = 0; i < 16; ++i) random(i / 4, i % 4) = normal(random_);
      const Matrix basis = random.householderQr().householderQ();
      for (int k = 0; k < planes_per_pencil; ++k) {
        const double angle = 3.14159265358979 * k / planes_per_pencil;
        const Point plane = std::cos(angle) * basis.col(0) + std::sin(angle) * basis.col(1);
        Eigen::Matrix<double, 4, 3> in_plane;
        in_plane << -std::sin(angle) * basis.col(0) + std::cos(angle) * basis.col(1), basis.col(2), basis.col(3);
        add_points(plane, in_plane, seeds);
      }
    }
    return seeds;
  }

  // Points (s, t, 1) of a plane that are on both conics, by the resultant with respect to t.
  void add_points(const Point& plane, const Eigen::Matrix<double, 4, 3>& basis, std::vector<Point>& seeds) const {
    const Eigen::Matrix3d a = basis.transpose() * a_ * basis, b = basis.transpose() * b_ * basis;
    const double a2 = a(1, 1), b2 = b(1, 1);
    const Eigen::Vector2d a1(2 * a(1, 2), 2 * a(0, 1)), b1(2 * b(1, 2), 2 * b(0, 1));  // ascending in s
    const Eigen::Vector3d a0(a(2, 2), 2 * a(0, 2), a(0, 0)), b0(b(2, 2), 2 * b(0, 2), b(0, 0));
    const Eigen::Vector3d p = a2 * b0 - b2 * a0;
    const Eigen::Vector2d q = a2 * b1 - b2 * a1;
    Eigen::Matrix<double, 5, 1> r = Eigen::Matrix<double, 5, 1>::Zero();
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) r[i + j] += p[i] * p[j];
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        for (int k = 0; k < 3; ++k) r[i + j + k] -= q[i] * (a1[j] * b0[k] - b1[j] * a0[k]);
    Matrix companion = Matrix::Zero();
    for (int i = 0; i < 4; ++i) companion(i, 3) = -r[i] / r[4];
    for (int i = 0; i < 3; ++i) companion(i + 1, i) = 1;
    const Eigen::Vector4cd roots = companion.eigenvalues();
    for (int i = 0; i < 4; ++i) {
      if (std::abs(roots[i].imag()) > 1e-4 * (1 + std::abs(roots[i].real()))) continue;
      const double s = roots[i].real(), t = -(p[0] + s * (p[1] + s * p[2])) / (q[0] + s * q[1]);
      const Point guess = (basis * Eigen::Vector3d(s, t, 1)).normalized();
      const auto found = corrected(guess, &plane);
      if (found && std::min((*found - guess).norm(), (*found + guess).norm()) < 1e-2) seeds.push_back(*found);
    }
  }

  using Loop = std::vector<Point>;  // the last is the first or its opposite

  [[nodiscard]] std::optional<Loop> follow(const Point& start) const {
    Loop loop{start};
    const Point first = tangent(start);
    Point t = first;
    double step = longest_step / 4;
    for (int k = 0; k < 100000; ++k) {
      const Point x = loop.back();
      const auto next = corrected((x + step * t).normalized());
      Point turned = next ? tangent(*next) : t;
      if (turned.dot(t) < 0) turned = -turned;
      const bool is_good = next && (*next - x - step * t).norm() < 0.3 * step && turned.dot(t) > std::cos(largest_turn);
      if (!is_good) {
        step /= 2;
        if (step < shortest_step) return std::nullopt;
        continue;
      }
      if (k > 2)
        if (const auto end = passes(start, first, x, *next)) {
          loop.push_back(*end);
          return loop;
        }
      loop.push_back(*next);
      t = turned;
      step = std::min(longest_step, 1.5 * step);
    }
    return std::nullopt;
  }

  // The point or its opposite, whichever the curve passes between x and y.
  [[nodiscard]] std::optional<Point> passes(const Point& point, const Point& along, const Point& x,
                                            const Point& y) const {
    for (const Point& p : {point, Point(-point)}) {
      if ((p - x).norm() > 4 * (y - x).norm() && (p - y).norm() > 4 * (y - x).norm()) continue;
      const double f = along.dot(x), g = along.dot(y);
      if (f * g > 0 && std::min(std::abs(f), std::abs(g)) > 1e-12) continue;
      const auto found = corrected(((g * x - f * y) / (g - f)).normalized(), &along);
      if (found && (*found - p).norm() < 1e-7) return p;
    }
    return std::nullopt;
  }

  [[nodiscard]] bool is_on(const Point& point, const Loop& loop) const {
    const Point along = tangent(point);
    for (std::size_t k = 0; k + 1 < loop.size(); ++k)
      if (passes(point, along, loop[k], loop[k + 1])) return true;
    return false;
  }

  static int count_crossings(const Loop& loop) {
    int crossings = 0;
    for (std::size_t k = 0; k + 1 < loop.size(); ++k) crossings += loop[k][3] * loop[k + 1][3] < 0 ? 1 : 0;
    return crossings;
  }

  Matrix a_, b_;
  std::mt19937 random_{1};
};

}  // namespace cgal_blend::test

#endif
