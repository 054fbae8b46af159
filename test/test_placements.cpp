// SPDX-License-Identifier: GPL-3.0-or-later
// Unions of real models, where they are at hand: blended and valid, or refused by name and place.
#include "checks.h"
#include "shapes.h"

#include <cgal_blend/fillet.h>
#include <cgal_blend/mesh_io.h>
#include <cgal_blend/validate.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

namespace cgal_blend::test {
namespace {

const std::string models = std::string(CGAL_BLEND_SHARED) + "/data/models/";

double diagonal(const Blend_mesh& mesh) {
  CGAL::Bbox_3 box;
  for (const Vertex v : mesh.vertices()) box += mesh.point(v).bbox();
  return std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
}

struct Placed {
  Blend_mesh a, b;
};

Placed read_pair(const nlohmann::json& pair) {
  Placed placed{read_mesh(models + pair["a"].get<std::string>()), read_mesh(models + pair["b"].get<std::string>())};
  const auto &axis = pair["axis"], &move = pair["translate"];
  placed.b = transformed(placed.b, placement({axis[0], axis[1], axis[2]}, pair["degrees"].get<double>() * pi / 180,
                                             {move[0], move[1], move[2]}, pair["scale"]));
  return placed;
}

/// Blends every pair with a radius that is a share of b's diagonal; returns how many came out blended.
int blended(double share, Blend_mode mode = Blend_mode::stitch) {
  int count = 0;
  for (const auto& pair : nlohmann::json::parse(std::ifstream(models + "pairs.json"))) {
    const std::string name = pair["a"].get<std::string>() + " + " + pair["b"].get<std::string>();
    const Placed placed = read_pair(pair);
    Fillet_options options;
    options.radius = share * diagonal(placed.b);
    options.mode = mode;
    Blend_mesh out;
    const Fillet_outcome outcome =
        unchecked::corefine_and_fillet(placed.a, placed.b, Boolean_operation::union_, out, options);
    if (!outcome.ok()) {
      EXPECT_EQ(status_class(outcome.diagnosis.status), Status_class::blend) << name << message(outcome.diagnosis);
      EXPECT_TRUE(outcome.diagnosis.point.has_value()) << name;
      EXPECT_NE(outcome.diagnosis.status, Status::parametrization_folds) << name;
      EXPECT_TRUE(out.is_empty()) << name;
      continue;
    }
    ++count;
    EXPECT_TRUE(validate(out).ok()) << name;
    EXPECT_TRUE(is_closed_by_counting(out)) << name;
    Blend_mesh sharp;
    options.radius = 0;
    if (unchecked::corefine_and_fillet(placed.a, placed.b, Boolean_operation::union_, sharp, options).ok()) {
      // Concave blends add material; vertices that are too few for a blend need not.
      const auto is_coarse = [](const Blend_report& blend) { return blend.coarseness > 0.4; };
      if (std::none_of(outcome.blends.begin(), outcome.blends.end(), is_coarse)) {
        EXPECT_GT(volume_of(out), volume_of(sharp)) << name;
      }
      if (mode == Blend_mode::map) {
        EXPECT_TRUE(same_connectivity(out, sharp)) << name;
      }
    }
  }
  return count;
}

TEST(Placements, OnePercentOfTheDiagonal) {
  if (!std::filesystem::exists(models)) GTEST_SKIP() << "models are not at hand";
  EXPECT_GE(blended(0.01), 13);
}

TEST(Placements, TwoPercentOfTheDiagonal) {
  if (!std::filesystem::exists(models)) GTEST_SKIP() << "models are not at hand";
  EXPECT_GE(blended(0.02), 11);
}

TEST(Placements, OnePercentOfTheDiagonalByMovingVertices) {
  if (!std::filesystem::exists(models)) GTEST_SKIP() << "models are not at hand";
  EXPECT_GE(blended(0.01, Blend_mode::map), 12);
}

}  // namespace
}  // namespace cgal_blend::test
