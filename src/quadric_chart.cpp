// SPDX-License-Identifier: GPL-3.0-or-later
#include "quadric_chart.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cgal_blend {

namespace {

constexpr double largest_exponent = 20;
constexpr double longest_true = 50;  // lengths of cylinders, in radii, up to which the map is true to angles

// Beyond, lengths grow logarithmically, or exp would overflow for wires.
double compressed(double z) {
  const double more = std::abs(z) - longest_true;
  return more > 0 ? std::copysign(longest_true + std::log1p(more), z) : z;
}
double expanded(double h) {
  const double more = std::abs(h) - longest_true;
  return more > 0 ? std::copysign(longest_true + std::expm1(more), h) : h;
}

/// An orthonormal frame with the given third axis.
Eigen::Matrix3d frame_about(const Vec& axis) {
  Eigen::Matrix3d frame;
  frame.col(2) = axis.normalized();
  frame.col(0) = axis.unitOrthogonal();
  frame.col(1) = frame.col(2).cross(frame.col(0));
  return frame;
}

}  // namespace

/// x . A x + b . x + c with A = V diag(lambda) V^T.
struct Quadric_chart::Form {
  explicit Form(const Quadric_3& quadric) {
    std::array<double, 10> k;
    double largest = 0;
    for (int i = 0; i < 10; ++i) {
      k[i] = CGAL::to_double(quadric.coefficients()[i]);
      largest = std::max(largest, std::abs(k[i]));
    }
    for (double& x : k) x /= largest;
    matrix << k[0], k[3] / 2, k[4] / 2, k[3] / 2, k[1], k[5] / 2, k[4] / 2, k[5] / 2, k[2];
    linear = {k[6], k[7], k[8]};
    constant = k[9];
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix);
    lambda = solver.eigenvalues();
    vectors = solver.eigenvectors();
  }

  [[nodiscard]] double value(const Vec& x) const { return x.dot(matrix * x) + linear.dot(x) + constant; }

  /// Brings eigenvalues into an order, vectors along; the first two are swapped if the frame would be left-handed.
  void order(std::array<int, 3> by) {
    Vec l;
    Eigen::Matrix3d v;
    for (int i = 0; i < 3; ++i) l[i] = lambda[by[i]], v.col(i) = vectors.col(by[i]);
    if (v.determinant() < 0) {
      std::swap(l[0], l[1]);
      v.col(0).swap(v.col(1));
    }
    lambda = l;
    vectors = v;
  }

  /// The eigenvalue of least size, which is 0 in exact numbers, last.
  void order_by_size() {
    std::array<int, 3> by{0, 1, 2};
    std::sort(by.begin(), by.end(), [&](int i, int j) { return std::abs(lambda[i]) > std::abs(lambda[j]); });
    order(by);
  }

  /// The eigenvalue whose sign differs from that of the others last.
  void order_by_sign() {
    const int negative = static_cast<int>((lambda.array() < 0).count());
    if (negative == 1) order({1, 2, 0});  // they are ascending
    if (negative == 2) order({0, 1, 2});
  }

  /// Where the gradient vanishes along the first `rank` axes.
  [[nodiscard]] Vec centre(int rank) const {
    Vec c = Vec::Zero();
    for (int i = 0; i < rank; ++i) c -= linear.dot(vectors.col(i)) / (2 * lambda[i]) * vectors.col(i);
    return c;
  }

  Eigen::Matrix3d matrix, vectors;
  Vec lambda, linear;
  double constant = 0;
};

void Quadric_chart::set_central(const Form& form, Quadric_type type) {
  centre_ = form.centre(3);
  axes_ = form.vectors;
  const double k = type == Quadric_type::cone ? form.lambda[0] : form.value(centre_);
  for (int i = 0; i < 3; ++i) scale_[i] = std::sqrt(std::abs(k / form.lambda[i]));
  const double mean = std::sqrt(scale_[0] * scale_[1]);
  if (type == Quadric_type::cone) {
    shape_ = Shape::cone;
    origin_ = Origin::apex;
    exponent_ = std::min(largest_exponent, std::hypot(1, scale_[2] / mean));
  } else if (type == Quadric_type::one_sheeted_hyperboloid) {
    shape_ = Shape::one_sheet;
    origin_ = Origin::infinity;
    exponent_ = std::min(largest_exponent, std::max(1.0, scale_[2] / mean));
  } else if (type == Quadric_type::two_sheeted_hyperboloid) {
    shape_ = Shape::root;
    a_ = b_ = 1;
  } else {
    shape_ = Shape::sphere;
  }
}

void Quadric_chart::set_cylinder(const Form& form, Quadric_type type) {
  centre_ = form.centre(2);
  axes_ = form.vectors;
  const double k = form.value(centre_);
  for (int i = 0; i < 2; ++i) scale_[i] = std::sqrt(std::abs(k / form.lambda[i]));
  scale_[2] = std::sqrt(scale_[0] * scale_[1]);
  if (type == Quadric_type::elliptic_cylinder) {
    shape_ = Shape::cylinder;
    origin_ = Origin::infinity;
    return;
  }
  // x^2 - y^2 = 1 with x along the axis whose eigenvalue has the other sign than the constant: z there is x here.
  const int up = form.lambda[0] * k < 0 ? 0 : 1;
  const Eigen::Matrix3d v = form.vectors;
  const Vec s = scale_;
  for (const auto& [to, from] : {std::pair(2, up), {0, 1 - up}, {1, 2}})
    axes_.col(to) = v.col(from), scale_[to] = s[from];
  shape_ = Shape::root;
  a_ = 1;
}

/// Paraboloids, parabolic cylinders and planes: z = a x^2 + b y^2.
void Quadric_chart::set_parabolic(const Form& form) {
  Vec up = form.linear;
  int rank = 0;
  const double tiny = 1e-12 * form.lambda.cwiseAbs().maxCoeff();
  while (rank < 3 && std::abs(form.lambda[rank]) > tiny) ++rank;
  for (int i = 0; i < rank; ++i) up -= up.dot(form.vectors.col(i)) * form.vectors.col(i);
  axes_.col(2) = up.normalized();
  axes_.col(0) = rank > 0 ? Vec(form.vectors.col(0)) : frame_about(up).col(0);
  axes_.col(1) = axes_.col(2).cross(axes_.col(0));
  const double slope = up.norm();
  a_ = -axes_.col(0).dot(form.matrix * axes_.col(0)) / slope;
  b_ = -axes_.col(1).dot(form.matrix * axes_.col(1)) / slope;
  centre_ = form.centre(rank);
  centre_ -= form.value(centre_) / slope * axes_.col(2);
}

std::optional<Quadric_chart> Quadric_chart::make(const Quadric_3& quadric, const Point_3& on_it, const Vector_3& away) {
  using T = Quadric_type;
  Form form(quadric);
  Quadric_chart chart;
  const T type = quadric.type();
  switch (type) {
    case T::ellipsoid:
    case T::cone:
    case T::one_sheeted_hyperboloid:
    case T::two_sheeted_hyperboloid:
      form.order_by_sign();
      chart.set_central(form, type);
      break;
    case T::elliptic_cylinder:
    case T::hyperbolic_cylinder:
      form.order_by_size();
      chart.set_cylinder(form, type);
      break;
    case T::elliptic_paraboloid:
    case T::hyperbolic_paraboloid:
    case T::parabolic_cylinder:
    case T::plane:
      form.order_by_size();
      if (type == T::plane) form.lambda.setZero();
      if (type == T::parabolic_cylinder) form.lambda[1] = 0;
      if (type != T::plane) form.lambda[2] = 0;
      chart.set_parabolic(form);
      break;
    default: return std::nullopt;
  }
  if (chart.shape_ == Shape::sphere) {
    // The frame need not be that of the axes any more once lengths are scaled: it is turned towards the pole.
    const Vec direction(away.x(), away.y(), away.z());
    const Vec pole = (chart.axes_.transpose() * direction).cwiseQuotient(chart.scale_);
    const Eigen::Matrix3d turn = frame_about(pole);
    chart.axes_ = chart.axes_ * chart.scale_.asDiagonal() * turn;
    chart.scale_ = Vec::Ones();
  }
  const Vec p = chart.local(on_it);
  chart.side_ = p.z() < 0 ? -1 : 1;
  if (chart.shape_ == Shape::cylinder) chart.middle_ = p.z();
  return chart;
}

Vec Quadric_chart::local(const Point_3& p) const {
  if (shape_ == Shape::sphere) return axes_.inverse() * (to_vec(p) - centre_);
  return (axes_.transpose() * (to_vec(p) - centre_)).cwiseQuotient(scale_);
}

Quadric_chart::Point_2 Quadric_chart::to_plane(const Point_3& p) const {
  const Vec q = local(p);
  double factor = 1;
  switch (shape_) {
    case Shape::sphere: factor = 1 / (q.norm() - q.z()); break;
    case Shape::cylinder: factor = std::exp(compressed(q.z() - middle_)) / std::hypot(q.x(), q.y()); break;
    case Shape::one_sheet: factor = std::exp(exponent_ * std::asinh(q.z())) / std::hypot(q.x(), q.y()); break;
    case Shape::cone: factor = std::pow(std::hypot(q.x(), q.y()), exponent_ - 1); break;
    case Shape::square:
    case Shape::root: break;
  }
  return {factor * q.x(), factor * q.y()};
}

Point_3 Quadric_chart::to_surface(const Point_2& p) const {
  const double x = p.x(), y = p.y(), r = std::hypot(x, y);
  Vec q = Vec::Zero();
  switch (shape_) {
    case Shape::sphere: q = Vec(2 * x, 2 * y, r * r - 1) / (1 + r * r); break;
    case Shape::cylinder: q = {x / r, y / r, middle_ + expanded(std::log(r))}; break;
    case Shape::one_sheet: {
      const double h = std::log(r) / exponent_;
      q = {x / r * std::cosh(h), y / r * std::cosh(h), std::sinh(h)};
      break;
    }
    case Shape::cone: {
      const double factor = r > 0 ? std::pow(r, 1 / exponent_ - 1) : 0;
      q = {factor * x, factor * y, side_ * factor * r};
      break;
    }
    case Shape::square: q = {x, y, a_ * x * x + b_ * y * y}; break;
    case Shape::root: q = {x, y, side_ * std::sqrt(1 + a_ * x * x + b_ * y * y)}; break;
  }
  return to_point(centre_ + axes_ * q.cwiseProduct(scale_));
}

bool Quadric_chart::is_on_component(const Point_3& p) const {
  if (shape_ != Shape::cone && shape_ != Shape::root) return true;
  return (local(p).z() < 0) == (side_ < 0);
}

}  // namespace cgal_blend
