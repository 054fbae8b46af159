// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks.h"
#include "fusions.h"
#include "shapes.h"

#include <cgal_blend/fuse.h>
#include <cgal_blend/mesh_io.h>
#include <cgal_blend/validate.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;

/// One model of a fusion: cut by a plane, scaled, turned so that the plane comes onto that of its side.
struct Piece {
  std::string model;
  Cut_plane plane;
  double scale = 1;
  double turn = 0;  // about the normal, degrees
  Vector_3 shift{0, 0, 0};
};

Blend_mesh placed(const Piece& piece, const Cut_plane& onto) {
  const auto unit = [](const Vector_3& v) { return v / std::sqrt(v.squared_length()); };
  const Vector_3 n = unit(piece.plane.normal), m = unit(onto.normal);
  Vector_3 axis = CGAL::cross_product(n, m);
  if (axis.squared_length() < 1e-20) axis = CGAL::cross_product(n, Vector_3(n.y(), n.z(), n.x() + 1));
  const double angle = std::atan2(std::sqrt(CGAL::cross_product(n, m).squared_length()), n * m);
  const Point_3 target = onto.point + piece.shift;
  const Placement to = moved_by(target.x(), target.y(), target.z()) * placement(m, piece.turn * pi / 180) *
                       placement(axis, angle) * Placement(CGAL::SCALING, piece.scale) *
                       moved_by(-piece.plane.point.x(), -piece.plane.point.y(), -piece.plane.point.z());
  return transformed(read_mesh(std::string(CGAL_BLEND_SHARED) + "/data/models/" + piece.model + ".off"), to);
}

struct Example {
  std::string name;
  std::vector<Piece> lower, upper;
  Cut_plane upper_plane;
};

std::ostream& operator<<(std::ostream& out, const Example& e) { return out << e.name; }

class Fuse_models : public testing::TestWithParam<Example> {};

TEST_P(Fuse_models, are_valid_and_tangent) {
  const Example& example = GetParam();
  std::vector<Blend_mesh> lows, highs;
  for (const auto* side : {&example.lower, &example.upper})
    for (const Piece& piece : *side)
      if (!std::filesystem::exists(std::string(CGAL_BLEND_SHARED) + "/data/models/" + piece.model + ".off"))
        GTEST_SKIP() << "no model " << piece.model;
  for (const Piece& piece : example.lower) lows.push_back(placed(piece, lower_plane));
  for (const Piece& piece : example.upper) highs.push_back(placed(piece, example.upper_plane));
  Blend_mesh out;
  const auto outcome =
      fuse(side_of_meshes(lows, lower_plane), side_of_meshes(highs, example.upper_plane), out, Fuse_options());
  ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
  const Validity_report report = validate(out);
  EXPECT_TRUE(report.ok()) << message(report.diagnosis);
  EXPECT_TRUE(is_closed_by_counting(out));
  EXPECT_EQ(report.components, 1u);
  EXPECT_EQ(outcome.euler_characteristic, 2);
  EXPECT_LT(outcome.tangency_mean, 5);
  EXPECT_LT(outcome.tangency_max, 15);
}

const Piece bear_head{"bear", {{-0.015, 0.381, -0.008}, {0, -1, 0}}};
const Piece woman_above{"woman", {{0, 0.88, 0.015}, {0, -1, 0}}};
const Piece stem{"gen_goblet", {{0, 0, 1.003}, {0, 0, 1}}};

Piece scaled(Piece piece, double scale, const Vector_3& shift = {0, 0, 0}) {
  piece.scale = scale;
  piece.shift = shift;
  return piece;
}

INSTANTIATE_TEST_SUITE_P(
    Figures, Fuse_models,
    testing::Values(
        Example{"goblet", {stem}, {scaled(bear_head, 1.4)}, upper_plane(0.5)},
        Example{"mermaid", {{"dolphin", {{180, 247, 1.07}, {-1, 0, 0}}, 0.0037}}, {woman_above}, upper_plane(0.12)},
        Example{"neck",
                {{"dino", {{-0.005, -0.2, 1.003}, {0, 0, 1}}}},
                {scaled(bear_head, 0.7)},
                {{0, -0.5, 0.6}, {0, 0.9, -0.3}}},
        Example{"tails",
                {{"dolphin", {{200, 237.7, 0.99}, {-1, 0, 0}}, 0.0027, 20, {0.14, 0, 0}},
                 {"dolphin", {{200, 237.7, 0.99}, {-1, 0, 0}}, 0.0027, -20, {-0.14, 0, 0}}},
                {woman_above},
                upper_plane(0.25)},
        Example{"hand",
                {{"woman", {{0, 0.651, 0.024}, {0, 1, 0}}}},
                {{"hand_palm", {{-0.025, 0.101, 0.029}, {0, -1, 0}}, 1.2}},
                upper_plane(0.2)}),
    [](const auto& info) { return info.param.name; });

}  // namespace
