// SPDX-License-Identifier: GPL-3.0-or-later
#include "transform.h"

#include "failure.h"
#include "values.h"

#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/determinant.h>

#include <array>
#include <cmath>

namespace cgal_blend::cli {

namespace {

// A volume below this share of the product of the rows' lengths is rounding noise.
constexpr double flat = 1e-12;

bool is_singular(const std::array<double, 12>& m) {
  std::array<double, 9> unit_rows{};
  for (std::size_t row = 0; row < 3; ++row) {
    const double length = std::hypot(m[4 * row], m[4 * row + 1], m[4 * row + 2]);
    for (std::size_t k = 0; k < 3; ++k) unit_rows[3 * row + k] = m[4 * row + k] / length;
  }
  const auto& u = unit_rows;
  return !(std::abs(CGAL::determinant(u[0], u[1], u[2], u[3], u[4], u[5], u[6], u[7], u[8])) > flat);
}

}  // namespace

Transform parse_transform(const std::string& text, const std::string& option) {
  const std::vector<std::string> words = split(text, " \t\n\r,", false);
  if (words.size() != 12)
    throw usage_failure(option + ": 12 numbers are needed, row by row, not " + std::to_string(words.size()));
  std::array<double, 12> m{};
  for (std::size_t i = 0; i < m.size(); ++i) {
    const auto number = parse_number(words[i]);
    if (!number) throw usage_failure(option + ": '" + words[i] + "' is not a number");
    m[i] = *number;
  }
  if (is_singular(m)) throw usage_failure(option + ": the matrix flattens the body");
  return CGAL::Aff_transformation_3<Kernel>(m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8], m[9], m[10], m[11]);
}

void apply(const Transform& transform, Blend_mesh& mesh) {
  if (!transform) return;
  for (Vertex v : mesh.vertices()) mesh.point(v) = transform->transform(mesh.point(v));
  if (transform->is_odd()) CGAL::Polygon_mesh_processing::reverse_face_orientations(mesh);
}

}  // namespace cgal_blend::cli
