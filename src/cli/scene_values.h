// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_CLI_SCENE_VALUES_H
#define CGAL_BLEND_CLI_SCENE_VALUES_H

#include "expression.h"

#include <cgal_blend/blend_mesh.h>
#include <cgal_blend/quadric.h>

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace cgal_blend::cli {

/// A value of a scene file with its place in it, for messages. Everything that is not what it should be throws
/// `Failure` (input).
class Scene_value {
 public:
  using Json = nlohmann::json;

  Scene_value(const Json& json, std::string where) : json_(&json), where_(std::move(where)) {}

  [[noreturn]] void refuse(const std::string& what) const;

  [[nodiscard]] bool has(const std::string& key) const { return json_->is_object() && json_->contains(key); }
  /// Refuses an object with a key that is not among those known.
  void allow(const std::vector<std::string>& keys) const;
  [[nodiscard]] Scene_value operator[](const std::string& key) const;
  [[nodiscard]] std::vector<Scene_value> list() const;
  [[nodiscard]] std::vector<Scene_value> list(std::size_t size) const;
  [[nodiscard]] std::vector<std::string> keys() const;

  [[nodiscard]] bool is_null() const { return json_->is_null(); }
  [[nodiscard]] bool is_list() const { return json_->is_array(); }
  [[nodiscard]] bool is_number() const { return json_->is_number(); }
  [[nodiscard]] bool is_string() const { return json_->is_string(); }
  [[nodiscard]] bool boolean() const;
  [[nodiscard]] double number() const;
  [[nodiscard]] std::size_t index() const;
  [[nodiscard]] std::string text() const;
  [[nodiscard]] Point_3 point() const;
  [[nodiscard]] Vector_3 vector() const;
  /// A number, taken for the double that it is, or a string "p/q".
  [[nodiscard]] Quadric_3::Rational rational() const;
  [[nodiscard]] std::vector<Quadric_3::Rational> rationals(std::size_t size) const;
  /// Formulas of the given variables, as many as wanted.
  [[nodiscard]] std::vector<Expression> formulas(std::size_t size, const std::vector<std::string>& variables) const;
  [[nodiscard]] Expression formula(const std::vector<std::string>& variables) const;
  [[nodiscard]] const std::string& where() const { return where_; }

 private:
  const Json* json_;
  std::string where_;
};

}  // namespace cgal_blend::cli

#endif
