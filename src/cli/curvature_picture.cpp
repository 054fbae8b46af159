// SPDX-License-Identifier: GPL-3.0-or-later
#include "curvature_picture.h"

#include <cgal_blend/curvature.h>
#include <cgal_blend/mesh_io.h>

#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

namespace cgal_blend::cli {

Json write_curvature_picture(const std::string& path, const Blend_mesh& mesh, std::optional<double> limit) {
  // Meshes that were read or handed out have no removed vertices: indices are positions.
  std::vector<double> values(mesh.number_of_vertices());
  mean_curvature(mesh, CGAL::make_property_map(values));
  const double scale = limit ? *limit : robust_limit(values);
  std::vector<std::array<unsigned char, 3>> colours;
  colours.reserve(values.size());
  for (const double value : values) colours.push_back(colour_scale(value, scale));
  write_curvature_ply(path, mesh, values, colours);
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  return {{"file", path},
          {"min", *least},
          {"max", *greatest},
          {"mean", sum / static_cast<double>(values.size())},
          {"limit", scale}};
}

}  // namespace cgal_blend::cli
