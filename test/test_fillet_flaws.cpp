// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/fillet.h>

#include "blends.h"

#include <algorithm>
#include <string>
#include <vector>

// Blends of a mesh with flaws: those that no blend meets make no difference, others are refused by their name.

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;

using Places = std::vector<Point_3>;

constexpr double r = 0.25;

/// The edges along a polyline of points that are vertices, in unit steps between the given ones.
std::vector<Edge> edges_along(const Blend_mesh& mesh, const Places& places) {
  const auto vertex_at = [&](const Point_3& p) {
    return *std::find_if(mesh.vertices().begin(), mesh.vertices().end(), [&](Vertex v) { return mesh.point(v) == p; });
  };
  std::vector<Edge> edges;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const Vector_3 way = places[i + 1] - places[i];
    const int steps = static_cast<int>(std::lround(std::sqrt(way.squared_length())));
    for (int k = 0; k < steps; ++k) {
      const Halfedge h = mesh.halfedge(vertex_at(places[i] + k / double(steps) * way),
                                       vertex_at(places[i] + (k + 1) / double(steps) * way));
      if (h != Blend_mesh::null_halfedge()) edges.push_back(mesh.edge(h));
    }
  }
  return edges;
}

Fillet_options accepting(double radius) {
  Fillet_options options = options_of(radius);
  options.accept_flaws = true;
  return options;
}

struct Trial {
  Blend_mesh mesh;
  Fillet_result<Blend_mesh> result;
  double change = 0;  // of the volume
};

Trial run(const Blend_mesh& mesh, const Places& places, const Fillet_options& options) {
  Trial run;
  run.result = fillet_edges(mesh, {{edges_along(mesh, places), 0}}, run.mesh, options);
  if (run.result.ok()) run.change = volume_of(run.mesh) - volume_of(mesh);
  return run;
}

const Blend_mesh clean = grid_box({0, 0, 0}, {4, 4, 4}, 4);
const Places bottom_rim{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0}}, upright{{4, 4, 0}, {4, 4, 4}},
    upper_far{{4, 4, 4}, {4, 0, 4}, {0, 0, 4}}, upper_near{{0, 0, 4}, {0, 4, 4}},
    foot{{1, 1, 4}, {2, 1, 4}, {2, 2, 4}, {1, 2, 4}, {1, 1, 4}};

TEST(Fillet_flaws, Far_away_they_make_no_difference) {
  const Blend_mesh flawed = box_with_folded_spike();
  const Validity_report before = validate(flawed);
  ASSERT_EQ(before.diagnosis.status, Status::input_self_intersecting);
  for (const Places& places : {bottom_rim, upright, upper_far}) {
    const Trial with = run(flawed, places, accepting(r)), without = run(clean, places, options_of(r));
    ASSERT_TRUE(with.result.ok()) << message(with.result.diagnosis);
    ASSERT_TRUE(without.result.ok()) << message(without.result.diagnosis);
    EXPECT_NEAR(with.change, without.change, 1e-12);
    EXPECT_EQ(with.result.accepted_flaws, before.self_intersections);
    EXPECT_EQ(without.result.accepted_flaws, 0u);
    EXPECT_TRUE(is_closed_by_counting(with.mesh) && has_single_fans(with.mesh));
    EXPECT_TRUE(validate_changes(with.mesh, with.result.changed_faces).ok());
    EXPECT_EQ(validate(with.mesh).self_intersections, before.self_intersections);
    std::vector<Face> kept(with.mesh.faces().begin(), with.mesh.faces().begin() + with.result.kept_faces);
    EXPECT_TRUE(faces_kept_in_order(with.mesh, flawed, kept));
  }
  const Trial beneath = run(flawed, upper_near, accepting(0.9));  // the tip hangs over the blend
  ASSERT_TRUE(beneath.result.ok()) << message(beneath.result.diagnosis);
  EXPECT_NEAR(beneath.change, run(clean, upper_near, options_of(0.9)).change, 1e-12);
  const double closed_form = -4 * (1 - pi / 4) * r * r;
  EXPECT_NEAR(run(flawed, upright, accepting(r)).change, closed_form, 0.01 * std::abs(closed_form));
}

TEST(Fillet_flaws, They_are_refused_unless_asked_for) {
  const Trial refused = run(box_with_folded_spike(), bottom_rim, options_of(r));
  EXPECT_EQ(refused.result.diagnosis.status, Status::input_self_intersecting);
  EXPECT_TRUE(refused.mesh.is_empty());
}

TEST(Fillet_flaws, Where_a_blend_meets_one_it_is_named_with_its_place) {
  const Blend_mesh flawed = box_with_folded_spike();
  const struct {
    Places places;
    double radius;
  } cases[] = {{foot, 0.1}, {upper_near, 1.2}, {{{0, 0, 4}, {0, 4, 4}, {4, 4, 4}, {4, 0, 4}, {0, 0, 4}}, 1.1}};
  for (const auto& c : cases) {
    const Trial refused = run(flawed, c.places, accepting(c.radius));
    const Diagnosis& diagnosis = refused.result.diagnosis;
    EXPECT_EQ(diagnosis.status, Status::input_self_intersecting) << c.radius << " " << message(diagnosis);
    EXPECT_NE(diagnosis.detail.find("in the way of the blend"), std::string::npos) << message(diagnosis);
    EXPECT_TRUE(refused.mesh.is_empty());
    ASSERT_TRUE(diagnosis.point);
    EXPECT_TRUE(CGAL::do_overlap(diagnosis.point->bbox(), CGAL::Bbox_3(0.5, 1, 4, 2, 2, 5)));
  }
}

TEST(Fillet_flaws, Keep_going_leaves_curves_at_a_flaw_sharp) {
  const Blend_mesh flawed = box_with_folded_spike();
  Fillet_options options = accepting(0.1);
  options.keep_going = true;
  Blend_mesh out, expected;
  std::vector<Edge> edges = edges_along(flawed, foot);
  const auto none = fillet_edges(flawed, {{edges, 0}}, out, options);
  EXPECT_EQ(none.diagnosis.status, Status::input_self_intersecting);
  ASSERT_EQ(none.blends.size(), 1u);
  EXPECT_EQ(none.blends[0].diagnosis.status, Status::input_self_intersecting);
  for (const Edge e : edges_along(flawed, bottom_rim)) edges.push_back(e);
  const auto some = fillet_edges(flawed, {{edges, 0}}, out, options);
  ASSERT_TRUE(some.ok()) << message(some.diagnosis);
  ASSERT_TRUE(fillet_edges(clean, {{edges_along(clean, bottom_rim), 0}}, expected, options).ok());
  EXPECT_NEAR(volume_of(out) - volume_of(flawed), volume_of(expected) - 64, 1e-12);
  const Blend_report& last = some.blends.back();
  EXPECT_EQ(last.diagnosis.status, Status::input_self_intersecting);
  EXPECT_EQ(last.edges, 4u);
  EXPECT_TRUE(last.closed);
  EXPECT_FALSE(last.convex);
  EXPECT_EQ(last.radius, 0.1);
}

TEST(Fillet_flaws, Degenerate_faces_likewise) {
  const Blend_mesh far = with_needle(clean, {1, 1, 4}, {2, 1, 4}), near = with_needle(clean, {1, 0, 0}, {1, 1, 0}),
                   across = with_needle(clean, {1, 0, 0}, {2, 0, 0});
  for (const Blend_mesh* mesh : {&far, &near, &across})
    EXPECT_EQ(run(*mesh, bottom_rim, options_of(r)).result.diagnosis.status, Status::input_degenerate);
  const Trial accepted = run(far, bottom_rim, accepting(r)), without = run(clean, bottom_rim, options_of(r));
  ASSERT_TRUE(accepted.result.ok()) << message(accepted.result.diagnosis);
  EXPECT_NEAR(accepted.change, without.change, 1e-12);
  EXPECT_EQ(accepted.result.accepted_flaws, validate(far).flaws.size());
  EXPECT_EQ(validate(accepted.mesh).degenerate_faces, 1u);
  for (const Blend_mesh* mesh : {&near, &across}) {
    const Trial refused = run(*mesh, bottom_rim, accepting(r));
    EXPECT_EQ(refused.result.diagnosis.status, Status::input_degenerate) << message(refused.result.diagnosis);
    ASSERT_TRUE(refused.result.diagnosis.point);
    EXPECT_EQ(refused.result.diagnosis.point->z(), 0);
  }
}

/// Needles beside the blend, under it and at its border: it is as without them, or they are named. The corner of a needle
/// lies on a side of its neighbour, which counts as cutting through.
TEST(Fillet_flaws, A_degenerate_face_that_the_ball_rolls_over_is_named) {
  int blended = 0, refused = 0;
  for (const double radius : {0.5, 0.9, 1.1, 1.6, 2.1})
    for (const Places& needle : {Places{{1, 1, 0}, {2, 1, 0}}, Places{{1, 1, 0}, {1, 2, 0}},
                                 Places{{1, 2, 0}, {2, 2, 0}}, Places{{4, 1, 1}, {4, 1, 2}}}) {
      const Trial got = run(with_needle(clean, needle[0], needle[1]), {{0, 0, 0}, {4, 0, 0}}, accepting(radius));
      if (got.result.ok()) {
        EXPECT_NEAR(got.change, run(clean, {{0, 0, 0}, {4, 0, 0}}, options_of(radius)).change, 1e-9) << radius;
        EXPECT_EQ(validate(got.mesh).degenerate_faces, 1u);
        ++blended;
      } else {
        const Status status = got.result.diagnosis.status;
        EXPECT_TRUE(status == Status::input_degenerate || status == Status::input_self_intersecting)
            << radius << message(got.result.diagnosis);
        EXPECT_NE(got.result.diagnosis.detail.find("in the way"), std::string::npos);
        ++refused;
      }
    }
  EXPECT_GT(blended, 0);
  EXPECT_GT(refused, 0);
}

TEST(Fillet_flaws, Map_mode_likewise) {
  const auto foot_of_boss = [](const Blend_mesh& mesh) {
    std::vector<Edge> edges = creases_at_height(mesh, 0);
    const auto on_outer_rim = [&](Edge e) {
      return (mesh.point(mesh.vertex(e, 0)) - Point_3(0, 0, 0)).squared_length() > 2;
    };
    edges.erase(std::remove_if(edges.begin(), edges.end(), on_outer_rim), edges.end());
    return edges;
  };
  const Blend_mesh body = boss_on_plate(1, 2, 0.5, 1, 0.1);
  const Blend_mesh crossing = side_by_side(box({8, 8, 8}, {10, 10, 10}), box({9, 9, 9}, {11, 11, 11}));
  const Blend_mesh flawed = side_by_side(body, crossing);
  Fillet_options options = accepting(0.3);
  options.mode = Blend_mode::map;
  Blend_mesh out, expected;
  const auto got = fillet_edges(flawed, {{foot_of_boss(flawed), 0}}, out, options);
  ASSERT_TRUE(got.ok()) << message(got.diagnosis);
  EXPECT_EQ(validate(out).self_intersections, got.accepted_flaws);
  ASSERT_TRUE(fillet_edges(body, {{foot_of_boss(body), 0}}, expected, options).ok());
  const Blend_mesh both = side_by_side(expected, crossing);
  ASSERT_TRUE(same_connectivity(out, both));
  const auto change = volume_of(expected) - volume_of(body);
  EXPECT_NEAR(volume_of(out) - volume_of(flawed), change, 0.01 * change)
      << "where the ring is cut is a matter of rounding";
  for (std::uint32_t v = body.number_of_vertices(); v < flawed.number_of_vertices(); ++v)
    EXPECT_EQ(out.point(Vertex(v)), flawed.point(Vertex(v)));
  options.coarse_faces = 500;
  EXPECT_EQ(fillet_edges(flawed, {{foot_of_boss(flawed), 0}}, out, options).diagnosis.status,
            Status::input_self_intersecting);
}

TEST(Fillet_flaws, Operands_of_booleans_may_have_none) {
  Blend_mesh out;
  for (const double radius : {0.0, 0.1}) {
    const auto result = corefine_and_fillet(box_with_folded_spike(), box({-1, -1, -1}, {1, 1, 1}),
                                            Boolean_operation::union_, out, accepting(radius));
    EXPECT_EQ(result.diagnosis.status, Status::input_self_intersecting);
  }
}

}  // namespace
