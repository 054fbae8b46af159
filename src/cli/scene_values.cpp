// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene_values.h"

#include "failure.h"

#include <algorithm>
#include <cmath>

namespace cgal_blend::cli {

namespace {

bool is_whole(const std::string& text) {
  const std::size_t begin = !text.empty() && text[0] == '-' ? 1 : 0;
  return text.size() > begin && std::all_of(text.begin() + static_cast<std::ptrdiff_t>(begin), text.end(),
                                            [](unsigned char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

void Scene_value::refuse(const std::string& what) const {
  throw Failure(Exit::input, "input_unreadable", where_ + ": " + what);
}

void Scene_value::allow(const std::vector<std::string>& keys) const {
  if (!json_->is_object()) refuse("must be an object");
  for (const auto& item : json_->items())
    if (std::find(keys.begin(), keys.end(), item.key()) == keys.end()) refuse("'" + item.key() + "' is not known");
}

Scene_value Scene_value::operator[](const std::string& key) const {
  if (!has(key)) refuse("no '" + key + "'");
  return {(*json_)[key], where_ + ", " + key};
}

std::vector<Scene_value> Scene_value::list() const {
  if (!json_->is_array()) refuse("must be a list");
  std::vector<Scene_value> items;
  for (const Json& item : *json_) items.emplace_back(item, where_ + " " + std::to_string(items.size() + 1));
  return items;
}

std::vector<Scene_value> Scene_value::list(std::size_t size) const {
  std::vector<Scene_value> items = list();
  if (items.size() != size) refuse("must be a list of " + std::to_string(size));
  return items;
}

std::vector<std::string> Scene_value::keys() const {
  if (!json_->is_object()) refuse("must be an object");
  std::vector<std::string> names;
  for (const auto& item : json_->items()) names.push_back(item.key());
  return names;
}

bool Scene_value::boolean() const {
  if (!json_->is_boolean()) refuse("must be true or false");
  return json_->get<bool>();
}

double Scene_value::number() const {
  if (!json_->is_number()) refuse(json_->dump() + " is not a number");
  const double value = json_->get<double>();
  if (!std::isfinite(value)) refuse("a number is not finite");
  return value;
}

std::size_t Scene_value::index() const {
  if (!json_->is_number_unsigned()) refuse(json_->dump() + " is not a whole number");
  return json_->get<std::size_t>();
}

std::string Scene_value::text() const {
  if (!json_->is_string()) refuse(json_->dump() + " is not a text");
  return json_->get<std::string>();
}

Vector_3 Scene_value::vector() const {
  const auto items = list(3);
  return {items[0].number(), items[1].number(), items[2].number()};
}

Point_3 Scene_value::point() const { return CGAL::ORIGIN + vector(); }

Quadric_3::Rational Scene_value::rational() const {
  using Rational = Quadric_3::Rational;
  if (!json_->is_string()) return Rational(number());
  const std::string fraction = text();
  const std::size_t slash = fraction.find('/');
  const std::string above = fraction.substr(0, slash);
  const std::string below = slash == std::string::npos ? "1" : fraction.substr(slash + 1);
  if (!is_whole(above) || !is_whole(below)) refuse("\"" + fraction + "\" is no fraction \"p/q\" of whole numbers");
  const Rational denominator(below);
  if (denominator == 0) refuse("\"" + fraction + "\" has the denominator 0");
  return Rational(above) / denominator;
}

std::vector<Quadric_3::Rational> Scene_value::rationals(std::size_t size) const {
  std::vector<Quadric_3::Rational> values;
  for (const Scene_value& item : list(size)) values.push_back(item.rational());
  return values;
}

Expression Scene_value::formula(const std::vector<std::string>& variables) const {
  return Expression(is_number() ? json_->dump() : text(), variables, where_);
}

std::vector<Expression> Scene_value::formulas(std::size_t size, const std::vector<std::string>& variables) const {
  std::vector<Expression> result;
  for (const Scene_value& item : list(size)) result.push_back(item.formula(variables));
  return result;
}

}  // namespace cgal_blend::cli
