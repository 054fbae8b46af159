// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SURD_H
#define CGAL_BLEND_SURD_H

#include "real.h"

#include <memory>

namespace cgal_blend {

/// Real number made from rational ones by arithmetic and square roots, exactly: a + b sqrt(c) with a, b, c of the same
/// kind. Signs are exact whether or not c is a square already.
class Surd {
 public:
  Surd() = default;
  Surd(int value) : rational_(value) {}
  Surd(const Rational& value) : rational_(value) {}

  [[nodiscard]] int sign() const;
  [[nodiscard]] bool is_zero() const { return sign() == 0; }
  [[nodiscard]] bool is_rational() const { return !extension_; }
  /// Returns the value; `is_rational()` must hold.
  [[nodiscard]] const Rational& rational() const { return rational_; }
  /// Returns the value with a relative error below 1e-110.
  [[nodiscard]] Real to_real() const;

  Surd operator-() const;
  friend Surd operator+(const Surd& x, const Surd& y);
  friend Surd operator-(const Surd& x, const Surd& y) { return x + (-y); }
  friend Surd operator*(const Surd& x, const Surd& y);
  /// `y` must not be zero.
  friend Surd operator/(const Surd& x, const Surd& y) { return x * y.inverse(); }
  Surd& operator+=(const Surd& y) { return *this = *this + y; }
  Surd& operator-=(const Surd& y) { return *this = *this - y; }

  /// Returns the root >= 0 of `x` >= 0; of rational squares the rational one.
  friend Surd sqrt(const Surd& x);

 private:
  struct Root;
  struct Extension;

  Surd(const Surd& a, const Surd& b, std::shared_ptr<const Root> root);  // a + b sqrt(root)
  [[nodiscard]] Surd inverse() const;
  [[nodiscard]] Surd norm() const;  // a^2 - b^2 c
  [[nodiscard]] unsigned long outermost() const;

  Rational rational_;
  std::shared_ptr<const Extension> extension_;  // none: the number is rational_
};

}  // namespace cgal_blend

#endif
