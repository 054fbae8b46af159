// SPDX-License-Identifier: GPL-3.0-or-later
// Booleans of bodies with faces in common planes, turned and moved in doubles so that the planes differ by rounding.
#include "blends.h"
#include "elimination_order.h"
#include "flush_pairs.h"
#include "near_faces.h"

#include <cgal_blend/fillet.h>
#include <cgal_blend/validate.h>

#include <gtest/gtest.h>

#include <array>
#include <cctype>
#include <string>
#include <vector>

namespace cgal_blend::test {
namespace {

using unchecked::corefine_and_fillet;

constexpr std::array<Boolean_operation, 3> operations{Boolean_operation::union_, Boolean_operation::intersection,
                                                      Boolean_operation::difference};

Flush_family family(const std::string& name) {
  for (const Flush_family& f : flush_families())
    if (f.name == name) return f;
  throw std::logic_error("no such family: " + name);
}

/// Runs a boolean that has to succeed, unless there is no such body.
void expect_right(const Flush_pair& pair, Boolean_operation operation) {
  Blend_mesh out;
  const Fillet_outcome outcome = corefine_and_fillet(pair.a, pair.b, operation, out, {});
  const double expected = volume_of(pair, operation), scale = pair.volume_a + pair.volume_b;
  if (expected < 1e-12 * scale) {
    EXPECT_EQ(outcome.diagnosis.status, Status::empty_result);
    return;
  }
  if (pair.difference_touches_itself && operation == Boolean_operation::difference) {
    EXPECT_FALSE(outcome.ok());
    return;
  }
  ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
  const Validity_report report = validate(out);
  EXPECT_TRUE(report.ok()) << message(report.diagnosis);
  EXPECT_TRUE(is_closed_by_counting(out));
  EXPECT_NEAR(volume_of(out), expected, 1e-9 * expected);
}

class Flush_booleans : public testing::TestWithParam<Flush_family> {};

TEST_P(Flush_booleans, AreValidWithTheRightVolume) {
  for (std::uint32_t seed = 1; seed <= 8; ++seed) {
    Dice dice(seed);
    const Flush_pair pair = moved_pair(GetParam().draw(dice), dice);
    for (const Boolean_operation operation : operations) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", operation " << static_cast<int>(operation));
      expect_right(pair, operation);
    }
  }
}

TEST_P(Flush_booleans, AreValidFarFromTheOrigin) {
  Dice dice(20);
  const Flush_pair pair = moved_pair(GetParam().draw(dice), dice, 1000);
  for (const Boolean_operation operation : operations) {
    SCOPED_TRACE(testing::Message() << "operation " << static_cast<int>(operation));
    Blend_mesh out;
    const Fillet_outcome outcome = corefine_and_fillet(pair.a, pair.b, operation, out, {});
    if (!outcome.ok()) continue;  // as it is near the origin
    EXPECT_TRUE(validate(out).ok());
    EXPECT_NEAR(volume_of(out), volume_of(pair, operation), 1e-8);
  }
}

TEST_P(Flush_booleans, WithBallAreValidOrRefused) {
  for (std::uint32_t seed = 1; seed <= 2; ++seed) {
    Dice dice(seed);
    const Flush_pair pair = moved_pair(GetParam().draw(dice), dice);
    for (const Boolean_operation operation : operations) {
      Blend_mesh out;
      const Fillet_outcome outcome = corefine_and_fillet(pair.a, pair.b, operation, out, options_of(0.05, 0.02));
      if (outcome.ok()) {
        EXPECT_TRUE(validate(out).ok());
      } else {
        EXPECT_NE(outcome.diagnosis.status, Status::result_invalid);
      }
    }
  }
}

std::string name_of(const testing::TestParamInfo<Flush_family>& info) {
  std::string name;
  for (const char c : std::string(info.param.name)) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(Families, Flush_booleans, testing::ValuesIn(flush_families()), name_of);

TEST(Flush_boolean, UnitesBodiesInContactToOnePiece) {
  // Rounding may leave a gap as well as an overlap.
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    Dice dice(seed);
    const Flush_pair pair = moved_pair(family("stacked boxes, in the middle").draw(dice), dice);
    Blend_mesh out;
    ASSERT_TRUE(corefine_and_fillet(pair.a, pair.b, Boolean_operation::union_, out, {}).ok());
    EXPECT_EQ(validate(out).components, 1u);
  }
}

TEST(Flush_boolean, LeavesAGapThatIsNoRounding) {
  const Placement motion = placement({1, 2, 3}, 0.7, {0.3, 0.2, 0.1});
  const Blend_mesh a = transformed(box({0, 0, 0}, {1, 1, 1}), motion);
  const Blend_mesh b = transformed(box({0.25, 0.25, 1 + 1e-11}, {0.75, 0.75, 2}), motion);
  Blend_mesh out;
  ASSERT_TRUE(corefine_and_fillet(a, b, Boolean_operation::union_, out, {}).ok());
  EXPECT_EQ(validate(out).components, 2u);
}

TEST(Flush_boolean, KeepsUntouchedFacesBitForBit) {
  const Placement motion = placement({1, 2, 3}, 0.7, {0.3, 0.2, 0.1});
  const Blend_mesh upright_block = grid_box({0, 0, 0}, {1, 1, 1}, 6), block = transformed(upright_block, motion);
  const Blend_mesh upright_boss = grid_box({0.3, 0.3, 1}, {0.7, 0.7, 2}, 4), boss = transformed(upright_boss, motion);
  Blend_mesh out;
  const std::size_t least =
      corefine_and_fillet(upright_block, upright_boss, Boolean_operation::union_, out, {}).kept_faces;
  const Fillet_outcome outcome = corefine_and_fillet(block, boss, Boolean_operation::union_, out, {});
  ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
  EXPECT_GE(outcome.kept_faces, least);
  std::vector<Face> kept;
  for (std::size_t f = 0; f < outcome.kept_faces; ++f) kept.push_back(Face(static_cast<std::uint32_t>(f)));
  EXPECT_TRUE(faces_kept_in_order(out, side_by_side(block, boss), kept));
}

TEST(Flush_boolean, IsBlendedLikeTheOneThatIsNotTurned) {
  const double R = 10, r = 2;
  const Blend_mesh base = plate(30, 10), boss = cylinder(R, 64, 0, 20);
  const Placement motion = placement({1, 2, 3}, 0.7, {30, 20, 10});
  const Blended upright = blend(base, boss, Boolean_operation::union_, options_of(r));
  const Blended turned =
      blend(transformed(base, motion), transformed(boss, motion), Boolean_operation::union_, options_of(r));
  EXPECT_NEAR(turned.change, upright.change, 1e-3 * foot_volume(R, r));  // the steps of the ball start elsewhere
}

TEST(Flush_boolean, GivesTheSameBytesAgain) {
  for (const Flush_family& f : flush_families()) {
    Dice dice(5);
    const Flush_pair pair = moved_pair(f.draw(dice), dice);
    Blend_mesh first, second;
    const Fillet_outcome once = corefine_and_fillet(pair.a, pair.b, Boolean_operation::union_, first, {});
    const std::vector<Blend_mesh> elsewhere(3, pair.a);  // other addresses
    const Fillet_outcome again = corefine_and_fillet(elsewhere[2], pair.b, Boolean_operation::union_, second, {});
    EXPECT_EQ(once.diagnosis.status, again.diagnosis.status);
    EXPECT_TRUE(identical(first, second)) << f.name;
  }
}

TEST(Flush_boolean, ChainOfTurnedBoxes) {
  const Placement motion = placement({3, -1, 2}, 1.1, {0.3, 0.2, 0.1});
  const auto part = [&](double x, double y, double z) {
    return transformed(box({x, y, z}, {x + 1, y + 1, z + 1}), motion);
  };
  Blend_mesh body = part(0, 0, 0);
  double volume = 1;
  for (const auto& [x, y, z] : std::vector<std::array<double, 3>>{{1, 0, 0}, {0.5, 1, 0}, {0.5, 0, 1}, {0, 0.5, 1}}) {
    Blend_mesh next;
    const Fillet_outcome outcome = corefine_and_fillet(body, part(x, y, z), Boolean_operation::union_, next, {});
    ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
    volume += x == 0 ? 0.75 : 1;
    EXPECT_TRUE(validate(next).ok());
    EXPECT_NEAR(volume_of(next), volume, 1e-9);
    body = std::move(next);
  }
}

TEST(Coplanar_but_for_rounding, TellsExactFromNearly) {
  const Blend_mesh a = box({0, 0, 0}, {1, 1, 1}), b = box({0.25, 0.25, 1}, {0.75, 0.75, 2});
  EXPECT_FALSE(coplanar_but_for_rounding(a, b));
  EXPECT_TRUE(coplanar_but_for_rounding(a, transformed(b, moved_by(0, 0, 1e-15))));
  EXPECT_FALSE(coplanar_but_for_rounding(a, transformed(b, moved_by(0, 0, 1e-11))));
  EXPECT_FALSE(coplanar_but_for_rounding(a, transformed(b, placement({1, 2, 3}, 0.5))));
}

TEST(Elimination_order, FindsCornersOfABoxFromItsSides) {
  std::vector<Vec> points, normals;
  std::vector<std::pair<std::size_t, std::size_t>> bonds;
  for (int axis = 0; axis < 3; ++axis) normals.insert(normals.end(), 2, Vec::Unit(axis));
  for (std::size_t i = 0; i < 8; ++i) {
    points.emplace_back(i & 1, i >> 1 & 1, i >> 2);
    for (std::size_t axis = 0; axis < 3; ++axis) bonds.emplace_back(i, 2 * axis + (i >> axis & 1));
  }
  const auto order = elimination_order(points, normals, bonds, normals.size(), 1e-6);
  ASSERT_EQ(order.size(), 14u);
  for (std::size_t i = 0; i < order.size(); ++i) {
    EXPECT_EQ(order[i].is_plane, i < 6);
    EXPECT_EQ(order[i].earlier.size(), i < 6 ? 0u : 3u);
  }
}

TEST(Elimination_order, FindsSidesOfAPyramidFromItsApex) {
  // Four planes meet in the apex: one of them at least must be found from points.
  std::vector<Vec> points{{0, 0, 1}}, normals{Vec::UnitZ()};
  std::vector<std::pair<std::size_t, std::size_t>> bonds;
  for (std::size_t i = 0; i < 4; ++i) {
    const double angle = pi / 2 * static_cast<double>(i);
    points.emplace_back(std::cos(angle), std::sin(angle), 0);
    normals.push_back(Vec(std::cos(angle + pi / 4), std::sin(angle + pi / 4), std::sqrt(0.5)).normalized());
    bonds.insert(bonds.end(), {{0, i + 1}, {i + 1, 0}, {i + 1, i + 1}, {i + 1, (i + 3) % 4 + 1}});
  }
  std::size_t met = 0;
  for (const Eliminated& step : elimination_order(points, normals, bonds, normals.size(), 1e-6)) {
    EXPECT_LE(step.earlier.size(), 3u);
    met += step.earlier.size();
  }
  EXPECT_EQ(met, bonds.size());  // none is given up
}

}  // namespace
}  // namespace cgal_blend::test
