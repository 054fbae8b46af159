// SPDX-License-Identifier: GPL-3.0-or-later
#include "expression.h"

#include "failure.h"
#include "values.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <utility>

namespace cgal_blend::cli {

namespace {

using Operation = Expression::Operation;
using Step = Expression::Step;

constexpr int deepest = 200;  // nested parentheses and signs
constexpr double largest_exponent = 100;
constexpr double pi = 3.14159265358979323846;

/// Recursive descent: sum = product {+- product}, product = factor {*/ factor}, factor = [-+] factor | atom [^ exponent].
class Parser {
 public:
  Parser(const std::string& text, const std::vector<std::string>& variables, const std::string& where)
      : text_(text), variables_(variables), where_(where) {}

  std::vector<Step> run() {
    sum();
    if (peek() != '\0') fail("unexpected '" + std::string(1, peek()) + "'");
    return std::move(steps_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw Failure(Exit::input, "input_unreadable", where_ + ": \"" + text_ + "\" is no formula: " + what);
  }

  char peek() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool take(char c) {
    if (peek() != c) return false;
    ++at_;
    return true;
  }

  void sum() {
    if (++depth_ > deepest) fail("it is nested too deeply");
    product();
    while (peek() == '+' || peek() == '-') {
      const Operation operation = take('+') ? Operation::add : (++at_, Operation::subtract);
      product();
      steps_.push_back({operation, 0});
    }
    --depth_;
  }

  void product() {
    factor();
    while (peek() == '*' || peek() == '/') {
      const Operation operation = take('*') ? Operation::multiply : (++at_, Operation::divide);
      factor();
      steps_.push_back({operation, 0});
    }
  }

  void factor() {
    if (++depth_ > deepest) fail("it is nested too deeply");
    if (take('-')) {
      factor();
      steps_.push_back({Operation::negate, 0});
    } else if (!take('+')) {
      atom();
      if (take('^')) steps_.push_back({Operation::power, exponent()});
    } else {
      factor();
    }
    --depth_;
  }

  double exponent() {
    const bool negative = take('-');
    const double value = number();
    if (value != std::floor(value) || value > largest_exponent) fail("exponents must be whole numbers of at most 100");
    return negative ? -value : value;
  }

  void atom() {
    if (take('(')) {
      sum();
      if (!take(')')) fail("a parenthesis is not closed");
    } else if (std::isalpha(static_cast<unsigned char>(peek())) != 0) {
      name();
    } else {
      steps_.push_back({Operation::number, number()});
    }
  }

  double number() {
    peek();
    const auto is_part = [&](std::size_t i) {
      const unsigned char c = static_cast<unsigned char>(text_[i]);
      const bool is_sign = (c == '-' || c == '+') && i > at_ && (text_[i - 1] == 'e' || text_[i - 1] == 'E');
      return std::isdigit(c) != 0 || c == '.' || c == 'e' || c == 'E' || is_sign;
    };
    std::size_t end = at_;
    while (end < text_.size() && is_part(end)) ++end;
    const auto value = parse_number(text_.substr(at_, end - at_));
    if (!value) fail("a number is missing");
    at_ = end;
    return *value;
  }

  void name() {
    std::size_t end = at_;
    while (end < text_.size() && std::isalnum(static_cast<unsigned char>(text_[end])) != 0) ++end;
    const std::string word = text_.substr(at_, end - at_);
    at_ = end;
    const auto variable = std::find(variables_.begin(), variables_.end(), word);
    if (variable != variables_.end()) {
      steps_.push_back({Operation::variable, static_cast<double>(variable - variables_.begin())});
    } else if (word == "pi") {
      steps_.push_back({Operation::number, pi});
    } else {
      call(word);
    }
  }

  void call(const std::string& word) {
    static const std::array<std::pair<const char*, Operation>, 5> functions{{{"sqrt", Operation::sqrt},
                                                                             {"sin", Operation::sin},
                                                                             {"cos", Operation::cos},
                                                                             {"exp", Operation::exp},
                                                                             {"log", Operation::log}}};
    const auto found = std::find_if(functions.begin(), functions.end(), [&](const auto& f) { return f.first == word; });
    if (found == functions.end()) fail("'" + word + "' is not known");
    if (!take('(')) fail("'" + word + "' needs an argument in parentheses");
    sum();
    if (!take(')')) fail("a parenthesis is not closed");
    steps_.push_back({found->second, 0});
  }

  const std::string& text_;
  const std::vector<std::string>& variables_;
  const std::string& where_;
  std::size_t at_ = 0;
  int depth_ = 0;
  std::vector<Step> steps_;
};

}  // namespace

Expression::Expression(const std::string& text, const std::vector<std::string>& variables, const std::string& where)
    : steps_(Parser(text, variables, where).run()) {}

}  // namespace cgal_blend::cli
