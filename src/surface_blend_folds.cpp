// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/surface_blend.h>

#include "mesh_checks.h"
#include "sample_curve.h"

#include <algorithm>
#include <cmath>

namespace cgal_blend {

namespace {

constexpr int halvings = 7;  // 1 % of the factor
constexpr double fold_tolerance =
    2e-4;  // of the longer curve: between columns they are halved until chords are so near

/// Vertices row by row, two triangles to a cell.
Blend_mesh grid_mesh(const std::vector<Point_3>& points, std::size_t columns, bool closed) {
  Blend_mesh mesh;
  for (const Point_3& p : points) mesh.add_vertex(p);
  const auto vertex = [&](std::size_t k, std::size_t i) {
    return Vertex(static_cast<Blend_mesh::size_type>(k * columns + i % columns));
  };
  for (std::size_t k = 0; k + 1 < points.size() / columns; ++k)
    for (std::size_t i = 0; i < columns - (closed ? 0 : 1); ++i) {
      mesh.add_face(vertex(k, i), vertex(k, i + 1), vertex(k + 1, i + 1));
      mesh.add_face(vertex(k, i), vertex(k + 1, i + 1), vertex(k + 1, i));
    }
  return mesh;
}

/// Where the normals of cells beside each other point into opposite half-spaces: the surface turns back there, even if
/// its facets are too few to cut each other.
std::optional<Point_3> find_turn(const std::vector<Point_3>& points, std::size_t columns, bool closed) {
  const std::size_t rows = points.size() / columns, cells = columns - (closed ? 0 : 1);
  const auto at = [&](std::size_t k, std::size_t i) { return points[k * columns + i % columns]; };
  const auto normal = [&](std::size_t k, std::size_t i) {
    return CGAL::cross_product(at(k + 1, i + 1) - at(k, i), at(k + 1, i) - at(k, i + 1));
  };
  for (std::size_t k = 0; k + 1 < rows; ++k)
    for (std::size_t i = 0; i < cells; ++i) {
      const Vector_3 n = normal(k, i);
      if ((closed || i + 1 < cells) && n * normal(k, (i + 1) % cells) < 0) return at(k, i + 1);
      if (k + 2 < rows && n * normal(k + 1, i) < 0) return at(k + 1, i);
    }
  return std::nullopt;
}

/// Points row by row, as `Surface_blend::sample`, with more columns where curves bend.
std::vector<Point_3> adaptive_grid(const Surface_blend& blend, std::size_t least_columns, std::size_t rows,
                                   std::size_t& columns) {
  const double tolerance =
      fold_tolerance * std::max(blend.correspondence().length[0], blend.correspondence().length[1]);
  std::vector<double> start;
  const double spans = static_cast<double>(blend.is_closed() ? least_columns : least_columns - 1);
  for (std::size_t i = 0; static_cast<double>(i) <= spans; ++i) start.push_back(static_cast<double>(i) / spans);
  const auto at = [&](double s) {
    const Blend_column column = blend.column(blend.is_closed() && s == 1 ? 0 : s);
    Point_row points;
    for (std::size_t k = 0; k < rows; ++k)
      points.push_back(column.at(static_cast<double>(k) / static_cast<double>(rows - 1)));
    return points;
  };
  std::vector<double> parameters = refined_parameters(at, start, tolerance);
  if (blend.is_closed()) parameters.pop_back();
  columns = parameters.size();
  std::vector<Point_3> points(columns * rows);
  for (std::size_t i = 0; i < columns; ++i) {
    const Point_row row = at(parameters[i]);
    for (std::size_t k = 0; k < rows; ++k) points[k * columns + i] = row[k];
  }
  return points;
}

}  // namespace

std::optional<Point_3> find_fold(const Surface_blend& blend, std::size_t least_columns, std::size_t rows) {
  std::size_t columns = 0;
  const std::vector<Point_3> points = adaptive_grid(blend, least_columns, rows, columns);
  if (const auto turn = find_turn(points, columns, blend.is_closed())) return turn;
  const Blend_mesh mesh = grid_mesh(points, columns, blend.is_closed());
  const auto pairs = internal::intersecting_pairs(mesh);
  if (pairs.empty()) return std::nullopt;
  return internal::meeting_point(mesh, pairs.front());
}

double largest_safe_factor(const Surface_blend& blend, double limit) {
  const auto is_safe = [&](double factor) { return !find_fold(blend.scaled(factor)); };
  if (is_safe(limit)) return limit;
  // Very small distances give nearly the ruled surface, with sharp bends beside the curves: those may fail where larger
  // ones work. So the search goes down from the limit.
  double safe = limit;
  do {
    safe /= 2;
    if (safe < limit / 100) return 0;
  } while (!is_safe(safe));
  double unsafe = 2 * safe;
  for (int i = 0; i < halvings; ++i) {
    const double middle = (safe + unsafe) / 2;
    (is_safe(middle) ? safe : unsafe) = middle;
  }
  return safe;
}

}  // namespace cgal_blend
