// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_TEST_QUADRIC_PAIRS_H
#define CGAL_BLEND_TEST_QUADRIC_PAIRS_H

#include <cgal_blend/quadric_intersection.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace cgal_blend::test {

using Integers = std::array<int, 10>;  // x2 y2 z2 xy xz yz x y z 1

inline Quadric_3 quadric(const Integers& coefficients) {
  Quadric_3::Coefficients exact;
  for (std::size_t k = 0; k < 10; ++k) exact[k] = coefficients[k];
  return Quadric_3(exact);
}

/// What an intersection is made of.
struct Parts {
  int closed = 0, open = 0, isolated = 0;

  friend bool operator==(const Parts& x, const Parts& y) {
    return x.closed == y.closed && x.open == y.open && x.isolated == y.isolated;
  }
  friend std::ostream& operator<<(std::ostream& out, const Parts& p) {
    return out << p.closed << " closed, " << p.open << " open, " << p.isolated << " isolated";
  }
};

inline Parts parts(const Quadric_intersection& intersection) {
  Parts result;
  for (const Intersection_curve& curve : intersection.components)
    ++(curve.is_closed() ? result.closed : curve.is_isolated() ? result.isolated : result.open);
  return result;
}

inline double size(const Quadric_3::Point_3& p) {
  return std::max({std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
}

/// True if |F| / |grad F| is below 1e-12 of the coordinates' size, or F what rounding its terms leaves: where the gradient
/// vanishes.
inline bool is_on(const Quadric_3& q, const Quadric_3::Point_3& p) {
  const double unit = std::max(1.0, size(p)), value = std::abs(q.value(p));
  return value <= 1e-12 * unit * std::sqrt(q.gradient(p).squared_length()) || value <= 1e-15 * unit * unit;
}

inline bool is_near(const std::vector<Quadric_3::Point_3>& places, const Quadric_3::Point_3& p, double tolerance) {
  const double reach = tolerance * (1 + size(p));
  return std::any_of(places.begin(), places.end(),
                     [&](const auto& place) { return CGAL::squared_distance(place, p) <= reach * reach; });
}

inline double angle_deg(const Quadric_3::Vector_3& u, const Quadric_3::Vector_3& v) {
  const double c = u * v / std::sqrt(u.squared_length() * v.squared_length());
  return std::acos(std::clamp(c, -1.0, 1.0)) * 180 / 3.14159265358979323846;
}

/// Random affine map x -> M x + t with small integers, not singular: applied to a quadric's argument.
class Affine_change {
 public:
  explicit Affine_change(std::mt19937& random) {
    std::uniform_int_distribution<int> entry(-2, 2);
    do {
      for (auto& row : m_)
        for (int& x : row) x = entry(random);
    } while (determinant() == 0);
    for (int& x : t_) x = entry(random);
  }

  [[nodiscard]] Quadric_3 operator()(const Quadric_3& q) const {
    using Rational = Quadric_3::Rational;
    const auto& c = q.coefficients();
    // Twice the matrix of the form, then rows of (M t; 0 1) on either side.
    const std::array<std::array<Rational, 4>, 4> f{{{2 * c[0], c[3], c[4], c[6]},
                                                    {c[3], 2 * c[1], c[5], c[7]},
                                                    {c[4], c[5], 2 * c[2], c[8]},
                                                    {c[6], c[7], c[8], 2 * c[9]}}};
    const auto n = [&](std::size_t i, std::size_t j) {
      return Rational(i == 3 ? (j == 3 ? 1 : 0) : j == 3 ? t_[i] : m_[i][j]);
    };
    std::array<std::array<Rational, 4>, 4> g;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j) {
        g[i][j] = 0;
        for (std::size_t k = 0; k < 4; ++k)
          for (std::size_t l = 0; l < 4; ++l) g[i][j] += n(k, i) * f[k][l] * n(l, j);
      }
    return Quadric_3(Quadric_3::Coefficients{g[0][0] / 2, g[1][1] / 2, g[2][2] / 2, g[0][1], g[0][2], g[1][2], g[0][3],
                                             g[1][3], g[2][3], g[3][3] / 2});
  }

 private:
  [[nodiscard]] int determinant() const {
    return m_[0][0] * (m_[1][1] * m_[2][2] - m_[1][2] * m_[2][1]) -
           m_[0][1] * (m_[1][0] * m_[2][2] - m_[1][2] * m_[2][0]) +
           m_[0][2] * (m_[1][0] * m_[2][1] - m_[1][1] * m_[2][0]);
  }

  std::array<std::array<int, 3>, 3> m_;
  std::array<int, 3> t_;
};

/// Coefficients from -largest to largest, not all 0.
inline Quadric_3 random_quadric(std::mt19937& random, int largest) {
  std::uniform_int_distribution<int> entry(-largest, largest);
  Integers coefficients{};
  while (std::all_of(coefficients.begin(), coefficients.end(), [](int c) { return c == 0; }))
    for (int& c : coefficients) c = entry(random);
  return quadric(coefficients);
}

/// Few coefficients that are not 0, small ones: most pairs of these are degenerate in some way.
inline Quadric_3 random_sparse_quadric(std::mt19937& random) {
  std::uniform_int_distribution<int> entry(-2, 2), place(0, 9), number(1, 4);
  Integers coefficients{};
  while (std::all_of(coefficients.begin(), coefficients.end(), [](int c) { return c == 0; }))
    for (int k = number(random); k > 0; --k) coefficients[static_cast<std::size_t>(place(random))] = entry(random);
  return quadric(coefficients);
}

/// f a + g b.
inline Quadric_3 mixed(const Quadric_3& a, const Quadric_3& b, int f, int g) {
  Quadric_3::Coefficients c;
  for (std::size_t k = 0; k < 10; ++k) c[k] = f * a.coefficients()[k] + g * b.coefficients()[k];
  return Quadric_3(c);
}

}  // namespace cgal_blend::test

#endif
