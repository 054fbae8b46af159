// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_CLI_EXPRESSION_H
#define CGAL_BLEND_CLI_EXPRESSION_H

#include <cgal_blend/dual.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace cgal_blend::cli {

/// Formula of real numbers: + - * / ^ (whole exponents), parentheses, sqrt sin cos exp log, pi, numbers and named
/// variables. Evaluates with any number type, so that derivatives come by dual numbers.
class Expression {
 public:
  /// Throws `Failure` (input) for what is no formula; `where` begins the message.
  Expression(const std::string& text, const std::vector<std::string>& variables, const std::string& where);

  /// \param values one per variable, in their order
  template <class T, std::size_t N>
  [[nodiscard]] T operator()(const std::array<T, N>& values) const {
    std::vector<T> stack;
    for (const Step& step : steps_) apply(step, values.data(), stack);
    return stack.back();
  }

  enum class Operation { number, variable, negate, add, subtract, multiply, divide, power, sqrt, sin, cos, exp, log };
  struct Step {
    Operation operation;
    double number = 0;  ///< the constant, the index of a variable, or the exponent
  };

 private:
  template <class T>
  static void apply(const Step& step, const T* values, std::vector<T>& stack) {
    using std::cos;
    using std::exp;
    using std::log;
    using std::sin;
    using std::sqrt;
    using O = Operation;
    if (step.operation == O::number) return stack.push_back(T(step.number));
    if (step.operation == O::variable) return stack.push_back(values[static_cast<std::size_t>(step.number)]);
    const T b = stack.back();
    stack.pop_back();
    if (step.operation >= O::add && step.operation <= O::divide) {
      T& a = stack.back();
      if (step.operation == O::add) a = a + b;
      if (step.operation == O::subtract) a = a - b;
      if (step.operation == O::multiply) a = a * b;
      if (step.operation == O::divide) a = a / b;
      return;
    }
    switch (step.operation) {
      case O::negate: return stack.push_back(-b);
      case O::power: return stack.push_back(power(b, static_cast<int>(step.number)));
      case O::sqrt: return stack.push_back(sqrt(b));
      case O::sin: return stack.push_back(sin(b));
      case O::cos: return stack.push_back(cos(b));
      case O::exp: return stack.push_back(exp(b));
      default: return stack.push_back(log(b));
    }
  }

  std::vector<Step> steps_;  // in reverse Polish order
};

}  // namespace cgal_blend::cli

#endif
