// SPDX-License-Identifier: GPL-3.0-or-later
#include "surd.h"

#include <CGAL/assertions.h>

#include <atomic>

namespace cgal_blend {

struct Surd::Root {
  Surd radicand;
  Real value;
  unsigned long order;  // later roots are outside of earlier ones
};

struct Surd::Extension {
  Surd a, b;
  std::shared_ptr<const Root> root;
};

namespace {

unsigned long next_order() {
  static std::atomic<unsigned long> last{0};
  return ++last;
}

bool is_square(const Rational& x) {
  return mpz_perfect_square_p(mpq_numref(x.mpq())) != 0 && mpz_perfect_square_p(mpq_denref(x.mpq())) != 0;
}

Rational square_root(const Rational& square) {
  mpq_t root;
  mpq_init(root);
  mpz_sqrt(mpq_numref(root), mpq_numref(square.mpq()));
  mpz_sqrt(mpq_denref(root), mpq_denref(square.mpq()));
  Rational result(root);
  mpq_clear(root);
  return result;
}

}  // namespace

Surd::Surd(const Surd& a, const Surd& b, std::shared_ptr<const Root> root) {
  if (b.is_rational() && b.rational_ == 0)
    *this = a;
  else
    extension_ = std::make_shared<const Extension>(Extension{a, b, std::move(root)});
}

unsigned long Surd::outermost() const { return extension_ ? extension_->root->order : 0; }

Surd Surd::norm() const {
  const Extension& e = *extension_;
  return e.a * e.a - e.b * e.b * e.root->radicand;
}

int Surd::sign() const {
  if (!extension_) return CGAL::sign(rational_);
  const int a = extension_->a.sign(), b = extension_->b.sign();
  if (b == 0 || a == b) return a;
  if (a == 0) return b;
  return a * norm().sign();
}

Real Surd::to_real() const {
  if (!extension_) return cgal_blend::to_real(rational_);
  const Extension& e = *extension_;
  const Real a = e.a.to_real(), b = e.b.to_real() * e.root->value;
  if (a * b >= 0) return a + b;
  return norm().to_real() / (a - b);  // nothing cancels here
}

Surd Surd::operator-() const {
  if (!extension_) return Surd(-rational_);
  return {-extension_->a, -extension_->b, extension_->root};
}

Surd operator+(const Surd& x, const Surd& y) {
  if (!x.extension_ && !y.extension_) return Surd(x.rational_ + y.rational_);
  const unsigned long order_x = x.outermost(), order_y = y.outermost();
  if (order_x < order_y) return y + x;
  const Surd::Extension& e = *x.extension_;
  if (order_y < order_x) return {e.a + y, e.b, e.root};
  return {e.a + y.extension_->a, e.b + y.extension_->b, e.root};
}

Surd operator*(const Surd& x, const Surd& y) {
  if (!x.extension_ && !y.extension_) return Surd(x.rational_ * y.rational_);
  const unsigned long order_x = x.outermost(), order_y = y.outermost();
  if (order_x < order_y) return y * x;
  const Surd::Extension& e = *x.extension_;
  if (order_y < order_x) return {e.a * y, e.b * y, e.root};
  const Surd::Extension& f = *y.extension_;
  return {e.a * f.a + e.b * f.b * e.root->radicand, e.a * f.b + e.b * f.a, e.root};
}

Surd Surd::inverse() const {
  if (!extension_) {
    CGAL_precondition(rational_ != 0);
    return Surd(Rational(1) / rational_);
  }
  const Extension& e = *extension_;
  const Surd n = norm();
  // The norm of a nonzero number vanishes only if c is a square and a = b sqrt(c).
  if (n.is_zero()) return (e.a + e.a).inverse();
  const Surd factor = n.inverse();
  return {e.a * factor, -(e.b * factor), e.root};
}

Surd sqrt(const Surd& x) {
  CGAL_precondition(x.sign() >= 0);
  if (x.is_zero()) return 0;
  if (x.is_rational() && is_square(x.rational_)) return Surd(square_root(x.rational_));
  const Real value = sqrt(x.to_real());
  return {0, 1, std::make_shared<const Surd::Root>(Surd::Root{x, value, next_order()})};
}

}  // namespace cgal_blend
