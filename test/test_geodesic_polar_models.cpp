// SPDX-License-Identifier: GPL-3.0-or-later
// Geodesic polar coordinates on scanned and modelled bodies, against exact distances on their faces.
#include "polar_checks.h"

#include <cgal_blend/mesh_io.h>

#include <CGAL/Surface_mesh_shortest_path.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <iostream>
#include <random>
#include <string>

namespace cgal_blend::test {
namespace {

using Shortest_path = CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Blend_mesh>>;

double diagonal_of(const Blend_mesh& mesh) {
  CGAL::Bbox_3 box;
  for (const Vertex v : mesh.vertices()) box += mesh.point(v).bbox();
  return distance_between({box.xmin(), box.ymin(), box.zmin()}, {box.xmax(), box.ymax(), box.zmax()});
}

class On_model : public testing::TestWithParam<std::string> {};

TEST_P(On_model, DistancesAreWithinAPercentInTheMean) {
  const std::string file = std::string(CGAL_BLEND_SHARED) + "/data/models/" + GetParam();
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
  const Blend_mesh mesh = read_mesh(file);
  const double radius = 0.12 * diagonal_of(mesh);
  std::mt19937 random(1);
  double sum = 0, worst = 0;
  std::size_t count = 0;
  for (int spot = 0; spot < 4; ++spot) {
    const Face_point source = random_place(mesh, random);
    const double safe = Geodesic_polar(mesh, source, radius).safe_radius();
    const Geodesic_polar polar(mesh, source, safe);
    ASSERT_TRUE(polar.diagnosis().ok()) << message(polar.diagnosis());
    Shortest_path exact(mesh);
    // CGAL counts the corners of a face from the source of its halfedge.
    exact.add_source_point(source.face, {source.weights[2], source.weights[0], source.weights[1]});
    for (const Vertex v : mesh.vertices()) {
      if (!polar.covers(v) || polar(v).distance > safe) continue;
      const double should = exact.shortest_distance_to_source_points(v).first;
      const double error = std::abs(polar(v).distance - should) / should;
      sum += error;
      worst = std::max(worst, error);
      ++count;
    }
  }
  RecordProperty("vertices", static_cast<int>(count));
  std::cout << GetParam() << ": " << count << " vertices, mean " << sum / static_cast<double>(count) << ", worst "
            << worst << "\n";
  EXPECT_GT(count, 50U);
  EXPECT_LT(sum / static_cast<double>(count), 0.01);
}

INSTANTIATE_TEST_SUITE_P(Geodesic_polar, On_model,
                         testing::Values("spot.off", "bob.off", "woman.off", "dino.off", "goathead.off",
                                         "anchor_dense.off", "gen_cross2cyl.off"),
                         [](const auto& info) { return info.param.substr(0, info.param.find('.')); });

}  // namespace
}  // namespace cgal_blend::test
