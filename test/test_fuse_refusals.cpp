// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks.h"
#include "fusions.h"
#include "shapes.h"

#include <cgal_blend/fuse.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;

// What cannot be fused has a name.

class Fuse_refuses : public testing::Test {
 protected:
  Status status(const Fusion_side& a, const Fusion_side& b, const Fuse_options& options = {}) {
    Blend_mesh out;
    const auto result = fuse(a, b, out, options);
    EXPECT_EQ(out.number_of_faces(), 0u);
    EXPECT_FALSE(message(result.diagnosis).empty());
    return result.diagnosis.status;
  }
  Blend_mesh low = frustum(1, 1, 24, -1, 0.5, 4), high = frustum(0.7, 0.7, 24, 1, 3, 3);
  Fusion_side a{{&low}, lower_plane}, b{{&high}, upper_plane(1.5)};
};

TEST_F(Fuse_refuses, bad_planes) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(status({{&low}, Cut_plane{{0, 0, 9}, {0, 0, 1}}}, b), Status::plane_misses_mesh);
  EXPECT_EQ(status({{&low}, Cut_plane{{0, 0, 0}, {0, 1, 0}}}, b), Status::plane_meets_vertex);
  EXPECT_EQ(status({{&low}, Cut_plane{{0, 0, 0.5}, {0, 0, 1}}}, b), Status::plane_meets_vertex) << "along a face";
  EXPECT_EQ(status({{&low}, Cut_plane{{0, 0, nan}, {0, 0, 1}}}, b), Status::invalid_parameter);
  EXPECT_EQ(status({{&low}, Cut_plane{{0, 0, 0}, {0, 0, 0}}}, b), Status::invalid_parameter);
  EXPECT_EQ(status({{&low}, std::nullopt}, b), Status::section_not_closed) << "no plane and no hole";
}

TEST_F(Fuse_refuses, bad_positions) {
  const Blend_mesh below = transformed(high, moved_by(0, 0, -2.2));
  EXPECT_EQ(status(a, {{&below}, upper_plane(-0.7)}), Status::sides_interpenetrate) << "upper below lower";
  Blend_mesh out;
  EXPECT_TRUE(fuse(b, a, out).ok()) << "only the names are exchanged";
  EXPECT_EQ(status(a, {{&high}, Cut_plane{{0, 0, 1.5}, {0, 0, 1}}}), Status::planes_too_steep) << "looks away";
  const Placement turn = placement({1, 0, 0}, 2.2);
  const Blend_mesh steep = transformed(high, turn);
  const Cut_plane up{turn.transform(Point_3(0, 0, 1.5)), turn.transform(Vector_3(0, 0, -1))};
  EXPECT_EQ(status(a, {{&steep}, up}), Status::planes_too_steep);
  // An elbow whose legs cross: the wedge is too narrow.
  const Placement across = moved_by(0.6, 0, -0.2) * placement({0, 1, 0}, pi / 2) * moved_by(0, 0, -1.5);
  const Blend_mesh crossing = transformed(high, across);
  const Cut_plane there{across.transform(Point_3(0, 0, 1.5)), across.transform(Vector_3(0, 0, -1))};
  const Status s = status(a, {{&crossing}, there});
  EXPECT_TRUE(s == Status::sides_interpenetrate || s == Status::blend_folds) << name(s);
}

TEST_F(Fuse_refuses, openings_in_each_others_way) {
  const Blend_mesh beside = transformed(low, moved_by(1.5, 0, 0)), inside = frustum(0.4, 0.4, 24, -1, 0.5, 4);
  EXPECT_EQ(status({{&low, &beside}, lower_plane}, b), Status::openings_overlap);
  EXPECT_EQ(status({{&low, &inside}, lower_plane}, b), Status::sides_interpenetrate) << "a solid in a solid";
  // Openings that are apart, of bodies that cross deeper down.
  const Blend_mesh left = transformed(frustum(1.5, 0.4, 24, -3, 0.5, 4), moved_by(-1, 0, 0)),
                   right = transformed(frustum(1.5, 0.4, 24, -3, 0.5, 4), placement({0, 0, 1}, 0.1, {1, 0, 0}));
  EXPECT_EQ(status({{&left, &right}, lower_plane}, b), Status::sides_interpenetrate);
}

/// Without the faces at heights of 0.49 and more.
Blend_mesh without_lid(Blend_mesh mesh) {
  for (const Face f : mesh.faces()) {
    double least = 9;
    for (const std::size_t v : corners_of(mesh, f)) least = std::min(least, mesh.point(Vertex(v)).z());
    if (least > 0.49) CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
  }
  mesh.collect_garbage();
  return mesh;
}

TEST_F(Fuse_refuses, kept_parts_in_the_way_of_the_transition) {
  // A mesh with a hole may have pieces above its own plane: nothing has been cut off.
  const Blend_mesh open = without_lid(low);
  Blend_mesh out;
  ASSERT_TRUE(fuse(Fusion_side{{&open}, std::nullopt}, b, out).ok());
  const Blend_mesh knife = side_by_side(open, box({0.6, -0.1, 0.9}, {2, 0.1, 1.1}));
  EXPECT_EQ(status({{&knife}, std::nullopt}, b), Status::blend_collides);
  const Blend_mesh beside = side_by_side(open, box({1.6, -0.1, 0.9}, {2, 0.1, 1.1}));
  EXPECT_TRUE(fuse(Fusion_side{{&beside}, std::nullopt}, b, out).ok()) << "elsewhere it may be";
  const Blend_mesh high_up = side_by_side(open, box({0.5, -0.1, 2}, {2, 0.1, 2.2}));
  EXPECT_EQ(status({{&high_up}, std::nullopt}, b), Status::sides_interpenetrate) << "into the upper side";
  // A rim from which the mesh goes up: it is its own lid that it would be joined to.
  const Blend_mesh bowl = transformed(open, placement({1, 0, 0}, pi, {0, 0, 1}));
  EXPECT_EQ(status({{&bowl}, std::nullopt}, b), Status::planes_too_steep);
}

/// A tube of square section with one corner cut off, its inner wall so close to the corner that no edge may vanish there.
Blend_mesh chamfered_tube(double z0, double z1) {
  const std::pair<double, double> section[] = {{0, 0},       {0.93, 0},    {1, 0.07},    {1, 1},      {0, 1},
                                               {0.05, 0.05}, {0.95, 0.05}, {0.95, 0.95}, {0.05, 0.95}};
  std::vector<Point_3> points;
  for (const double z : {z0, z1})
    for (const auto& [x, y] : section) points.emplace_back(x, y, z);
  std::vector<Corner_indices> triangles;
  const auto wall = [&](std::size_t a, std::size_t b) {
    triangles.push_back({a, b, b + 9});
    triangles.push_back({a, b + 9, a + 9});
  };
  for (std::size_t i = 0; i < 5; ++i) wall(i, (i + 1) % 5);
  for (std::size_t i = 0; i < 4; ++i) wall(5 + (i + 1) % 4, 5 + i);
  const Corner_indices lid[] = {{0, 1, 5}, {1, 6, 5}, {1, 2, 6}, {2, 3, 7}, {2, 7, 6},
                                {3, 4, 8}, {3, 8, 7}, {4, 0, 5}, {4, 5, 8}};
  for (const auto& t : lid) {
    triangles.push_back({t[0] + 9, t[1] + 9, t[2] + 9});
    triangles.push_back({t[0], t[2], t[1]});
  }
  return mesh_of(points, triangles);
}

TEST_F(Fuse_refuses, no_rings_that_cross_only_when_tidied) {
  const Blend_mesh below = chamfered_tube(-3, 2), above = chamfered_tube(-1, 4);
  Fuse_options options;
  options.edge = 0.04;  // as thick as the wall
  Blend_mesh out;
  const auto result = fuse(Fusion_side{{&below}, lower_plane}, Fusion_side{{&above}, upper_plane(0.5)}, out, options);
  EXPECT_TRUE(result.ok()) << message(result.diagnosis);
  EXPECT_EQ(result.rings, (std::array<std::size_t, 2>{2, 2}));
}

TEST_F(Fuse_refuses, with_a_move_that_helps) {
  Blend_mesh out;
  const auto missed = fuse(Fusion_side{{&low}, Cut_plane{{0, 0, 9}, {0, 0, 2}}}, b, out).diagnosis;
  EXPECT_EQ(missed.detail, "lower side: move it against its normal by between 8.5 and 10");
  EXPECT_TRUE(missed.point);
  EXPECT_TRUE(fuse(Fusion_side{{&low}, Cut_plane{{0, 0, 9 - 9.1}, {0, 0, 2}}}, b, out).ok());
  // Levels at -1, -0.625, -0.25, 0.125, 0.5.
  const auto met = fuse(Fusion_side{{&low}, Cut_plane{{0, 0, 0.125}, {0, 0, 1}}}, b, out).diagnosis;
  EXPECT_EQ(met.status, Status::plane_meets_vertex);
  EXPECT_NE(met.detail.find("by 0.1875 "), std::string::npos) << met.detail;
  EXPECT_TRUE(fuse(Fusion_side{{&low}, Cut_plane{{0, 0, 0.125 + 0.1875}, {0, 0, 1}}}, b, out).ok());
  const Blend_mesh beside = transformed(low, moved_by(5, 0, 9));
  const auto second = fuse(Fusion_side{{&low, &beside}, lower_plane}, b, out).diagnosis;
  EXPECT_EQ(second.detail, "lower side: mesh 2: move it along its normal by between 8 and 9.5");
  const Blend_mesh below = transformed(high, moved_by(0, 0, -2.2));
  const auto crossed = fuse(a, Fusion_side{{&below}, upper_plane(-0.7)}, out).diagnosis;
  EXPECT_NE(crossed.detail.find("by more than 0.7"), std::string::npos) << crossed.detail;
  const auto overlapping = fuse(a, Fusion_side{{&high, &high}, upper_plane(1.5)}, out).diagnosis;
  EXPECT_EQ(overlapping.detail, "upper side");
}

TEST_F(Fuse_refuses, edges_that_make_too_many_facets) {
  Fuse_options options;
  options.edge = 1e-7;
  EXPECT_EQ(status(a, b, options), Status::invalid_parameter);
}

TEST_F(Fuse_refuses, bad_options) {
  Fuse_options options;
  options.eta = {-0.1, 0.5};
  EXPECT_EQ(status(a, b, options), Status::invalid_parameter);
  options = {};
  options.step = 0;
  EXPECT_EQ(status(a, b, options), Status::invalid_parameter);
  options = {};
  options.edge = std::numeric_limits<double>::infinity();
  EXPECT_EQ(status(a, b, options), Status::invalid_parameter);
  options = {};
  options.grading = 0.5;
  EXPECT_EQ(status(a, b, options), Status::invalid_parameter);
  EXPECT_EQ(status({{}, lower_plane}, b), Status::invalid_parameter);
  options = {};
  options.progress = [](double) { return false; };
  EXPECT_EQ(status(a, b, options), Status::cancelled);
}

TEST_F(Fuse_refuses, bad_meshes) {
  Blend_mesh open = low;
  CGAL::Euler::remove_face(open.halfedge(*open.faces().begin()), open);
  open.collect_garbage();
  EXPECT_EQ(status({{&open}, lower_plane}, b), Status::input_not_closed);
  const Blend_mesh spiked = box_with_folded_spike();
  EXPECT_EQ(status({{&spiked}, lower_plane}, b), Status::input_self_intersecting);
  const Blend_mesh reversed = inside_out(low), none;
  EXPECT_EQ(status({{&reversed}, lower_plane}, b), Status::input_misoriented);
  EXPECT_EQ(status({{&none}, lower_plane}, b), Status::input_empty);
}

TEST_F(Fuse_refuses, open_meshes_with_edges_of_almost_no_length) {
  Blend_mesh open = without_lid(low);
  Halfedge level;  // between walls, half-way up
  for (const Halfedge h : open.halfedges())
    if (open.point(open.source(h)).z() == -0.25 && open.point(open.target(h)).z() == -0.25) level = h;
  const Point_3 from = open.point(open.source(level)), to = open.point(open.target(level));
  const Halfedge split = CGAL::Euler::split_edge(level, open);
  open.point(open.target(split)) = from + 1e-14 * (to - from);
  const Halfedge other = open.prev(open.opposite(split));
  CGAL::Euler::split_face(split, open.next(open.next(split)), open);
  CGAL::Euler::split_face(other, open.next(open.next(other)), open);
  ASSERT_TRUE(check_fusion_part(open, std::nullopt).ok());
  EXPECT_EQ(status({{&open}, std::nullopt}, b), Status::input_degenerate);
}

TEST_F(Fuse_refuses, holes_that_the_plane_leaves_or_meets) {
  Blend_mesh above = low, across = low;
  const auto open_at = [](Blend_mesh& mesh, double from, double to) {
    for (const Face f : mesh.faces()) {
      double least = 9, most = -9;
      for (const std::size_t v : corners_of(mesh, f)) {
        least = std::min(least, mesh.point(Vertex(v)).z());
        most = std::max(most, mesh.point(Vertex(v)).z());
      }
      if (least < from || most > to) continue;
      CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
      break;
    }
    mesh.collect_garbage();
  };
  open_at(above, 0.4, 0.6);
  Blend_mesh out;
  EXPECT_TRUE(fuse(Fusion_side{{&above}, lower_plane}, b, out).ok()) << "the hole is cut off";
  open_at(across, -0.26, 0.13);
  EXPECT_EQ(status({{&across}, lower_plane}, b), Status::section_not_closed);
}

}  // namespace
