// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_runner.h"

#include "checks.h"
#include "shapes.h"

#include <cgal_blend/mesh_io.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;

/// The good paths: what comes out is what was asked for, and the report says the same as the file.
class Cli : public Cli_runner {
 protected:
  void SetUp() override {
    Cli_runner::SetUp();
    write_mesh(path("a.off"), box({0, 0, 0}, {2, 2, 2}));
    write_mesh(path("b.off"), box({1, 1, 1}, {3, 3, 3}));
    write_mesh(path("plate.off"), plate(50, 10));
    write_mesh(path("boss.off"), cylinder(15, 64, -5, 40));
    write_mesh(path("cylinder.off"), cylinder(10, 64, 0, 20));
  }

  double volume(const std::string& file) { return volume_of(read_mesh(path(file))); }

  /// Vertex indices of the top rim of the cylinder, once around.
  static std::string rim_of_cylinder() {
    std::string indices;
    for (int i = 0; i <= 64; ++i) indices += (i > 0 ? ", " : "") + std::to_string(64 + i % 64);
    return indices;
  }

  void expect_valid(const std::string& file) {
    EXPECT_EQ(run("check " + file + " --quiet").exit, 0) << file;
    const Blend_mesh mesh = read_mesh(path(file));
    EXPECT_TRUE(is_closed_by_counting(mesh) && has_single_fans(mesh)) << file;
  }
};

TEST_F(Cli, SharpBooleansOfTwoBoxes) {
  const std::pair<const char*, double> expected[] = {{"union", 15}, {"intersection", 1}, {"difference", 7}};
  for (const auto& [word, value] : expected) {
    const Run r = run(std::string(word) + " a.off b.off -o out.off");
    EXPECT_EQ(r.exit, 0) << r.err;
    EXPECT_EQ(r.err, "");
    EXPECT_NE(r.out, "") << "a summary";
    expect_valid("out.off");
    EXPECT_NEAR(volume("out.off"), value, 1e-12) << word;
  }
}

TEST_F(Cli, EveryFormatInAndOut) {
  for (const char* in : {"off", "obj", "ply", "stl"}) {
    write_mesh(path(std::string("in.") + in), box({1, 1, 1}, {3, 3, 3}));
    for (const char* out : {"off", "obj", "ply", "stl"}) {
      const Run r = run("union a.off in." + std::string(in) + " -o out." + out);
      EXPECT_EQ(r.exit, 0) << in << " " << out << r.err;
      EXPECT_NEAR(volume(std::string("out.") + out), 15, 1e-5);
    }
  }
}

TEST_F(Cli, ReportAgreesWithTheFile) {
  const Run r = run("union plate.off boss.off --radius 5 -o out.off --report report.json");
  ASSERT_EQ(r.exit, 0) << r.err;
  expect_valid("out.off");
  const Json report = json("report.json");
  EXPECT_EQ(report["command"], "union");
  EXPECT_EQ(report["status"], "ok");
  EXPECT_TRUE(report["message"].is_string());
  EXPECT_EQ(report["input"]["vertices"], 8);
  EXPECT_EQ(report["input"]["faces"], 12);
  EXPECT_EQ(report["input_b"]["faces"], 256);
  const Blend_mesh mesh = read_mesh(path("out.off"));
  const Json& output = report["output"];
  EXPECT_EQ(output["vertices"], mesh.number_of_vertices());
  EXPECT_EQ(output["faces"], mesh.number_of_faces());
  EXPECT_TRUE(output["closed"].get<bool>() && output["manifold"].get<bool>());
  EXPECT_EQ(output["self_intersections"], 0);
  EXPECT_NEAR(output["volume"].get<double>(), volume_of(mesh), 1e-9 * volume_of(mesh));
  EXPECT_NEAR(output["area"].get<double>(), area_of(mesh), 1e-9 * area_of(mesh));
  const double share = output["untouched_share"];
  EXPECT_GT(share, 0);
  EXPECT_LT(share, 1);
  ASSERT_EQ(report["blends"].size(), 1u);
  const Json& blend = report["blends"][0];
  EXPECT_EQ(blend["status"], "ok");
  EXPECT_GE(blend["edges"].get<int>(), 64);
  EXPECT_TRUE(blend["closed"].get<bool>());
  EXPECT_FALSE(blend["convex"].get<bool>());
  EXPECT_EQ(blend["radius"], 5.0);
  EXPECT_LT(blend["radius_error"].get<double>(), 0.01);
  EXPECT_TRUE(blend["tangency_deg"].is_number());
  for (const char* key : {"message", "point", "max_radius"}) EXPECT_TRUE(blend.contains(key)) << key;
  for (const char* key : {"read", "check_input", "boolean", "blend", "validate", "write"})
    EXPECT_GE(report["timings_ms"][key].get<double>(), 0) << key;
}

TEST_F(Cli, FlawsAreCountedAndStay) {
  write_mesh(path("flawed.off"), with_needle(box_with_folded_spike(), {1, 1, 4}, {0, 1, 4}));
  write_mesh(path("clean.off"), grid_box({0, 0, 0}, {4, 4, 4}, 4));
  write("upright.json", R"({"blends": [{"polyline": [[4, 4, 0], [4, 4, 1], [4, 4, 2], [4, 4, 3], [4, 4, 4]]}]})");
  EXPECT_EQ(run("fillet flawed.off --blends upright.json --radius 0.5 -o out.off").exit, 3);
  ASSERT_EQ(run("fillet clean.off --blends upright.json --radius 0.5 -o clean_out.off").exit, 0);
  const Run r = run("fillet flawed.off --blends upright.json --radius 0.5 --accept-flaws -o out.off --report report.json");
  ASSERT_EQ(r.exit, 0) << r.err;
  EXPECT_NEAR(volume("out.off") - volume("flawed.off"), volume("clean_out.off") - 64, 1e-12);
  const Json report = json("report.json");
  EXPECT_GT(report["input"]["self_intersections"], 0);
  EXPECT_EQ(report["input"]["degenerate_faces"], 1);
  EXPECT_EQ(report["output"]["self_intersections"], report["input"]["self_intersections"]);
  EXPECT_EQ(report["output"]["degenerate_faces"], 1);
  EXPECT_EQ(run("check out.off --report check.json").exit, 3);
  EXPECT_EQ(json("check.json")["output"]["self_intersections"], report["input"]["self_intersections"]);
  const Run summary = run("fillet flawed.off --blends upright.json --radius 0.5 --accept-flaws -o out.off");
  EXPECT_NE(summary.out.find("flaws of the input left as they were"), std::string::npos) << summary.out;
  ASSERT_EQ(run("fillet clean.off --blends upright.json --radius 0.5 --accept-flaws -o out.off --report report.json").exit, 0);
  EXPECT_EQ(bytes("out.off"), bytes("clean_out.off"));
  EXPECT_EQ(json("report.json")["input"]["self_intersections"], 0);
}

TEST_F(Cli, OneEdgeStandsForTheRimIfItIsPropagated) {
  write("rim.json", R"({"blends": [{"polyline": [)" + rim_of_cylinder() + "]}]}");
  write("edge.json", R"({"blends": [{"polyline": [64, 65]}]})");
  ASSERT_EQ(run("fillet cylinder.off --blends rim.json --radius 2 -o rim.off").exit, 0);
  const Run r = run("fillet cylinder.off --blends edge.json --radius 2 --propagate on -o out.off");
  ASSERT_EQ(r.exit, 0) << r.err;
  EXPECT_EQ(bytes("out.off"), bytes("rim.off"));
  const Run off = run("fillet cylinder.off --blends edge.json --radius 2 --propagate off -o other.off");
  EXPECT_EQ(off.err, run("fillet cylinder.off --blends edge.json --radius 2 -o other.off").err);
  expect_valid("out.off");
}

TEST_F(Cli, ReportOnStandardOutputIsAlone) {
  const Run r = run("difference a.off b.off -o out.off --report -");
  ASSERT_EQ(r.exit, 0) << r.err;
  EXPECT_EQ(Json::parse(r.out)["command"], "difference");
  EXPECT_EQ(run("difference a.off b.off -o out.off --quiet").out, "");
}

TEST_F(Cli, PlacesTheSecondBody) {
  const auto union_volume = [&](const std::string& matrix) {
    const Run r = run("union a.off a.off -o out.off --transform-b \"" + matrix + "\"");
    EXPECT_EQ(r.exit, 0) << r.err;
    expect_valid("out.off");
    return volume("out.off");
  };
  EXPECT_NEAR(union_volume("1 0 0 1  0 1 0 1  0 0 1 1"), 15, 1e-12);
  EXPECT_NEAR(union_volume("0.5 0 0 -.5  0 0.5 0 0.25  0 0 0.5 0.25"), 8.5, 1e-12);
  EXPECT_NEAR(union_volume("-1 0 0 3  0 1 0 1  0 0 1 1"), 15, 1e-12) << "a mirrored solid is a solid";
}

TEST_F(Cli, ProfilesByName) {
  // Volume between the chord and the corner, the fuller the profile the less: only conics are ordered by weight.
  std::map<std::string, double> added;
  const double sharp = [&] {
    EXPECT_EQ(run("union plate.off boss.off -o out.off").exit, 0);
    return volume("out.off");
  }();
  for (const std::string profile : {"chamfer", "conic:0.3", "arc", "g2", "hermite", "hermite:1,2", "conic:2", "conic:inf",
                                    "sharp", "bspline:0,0;0.8,0;1,0.2;1,1"}) {
    const Run r = run("union plate.off boss.off --radius 5 --profile '" + profile + "' -o out.off");
    ASSERT_EQ(r.exit, 0) << profile << r.err;
    expect_valid("out.off");
    added[profile] = volume("out.off") - sharp;
  }
  EXPECT_GT(added["chamfer"], added["conic:0.3"]);
  EXPECT_GT(added["conic:0.3"], added["arc"]);
  EXPECT_GT(added["arc"], added["conic:2"]);
  EXPECT_GT(added["conic:2"], added["sharp"]);
  EXPECT_EQ(added["conic:inf"], added["sharp"]);
  EXPECT_NEAR(added["sharp"], 0, 0.01 * added["arc"]);
  write("two.json", R"({"blends": [{"polyline": [)" + rim_of_cylinder() + R"(], "radius": 2, "profile": "chamfer"}]})");
  ASSERT_EQ(run("fillet cylinder.off --blends two.json -o out.off").exit, 0);
  // A chamfer of the contacts of a ball of radius 2 takes off a ring with a right-angled triangle as its section.
  const double ring = 2 * pi * (10 - 2.0 / 3) * 2;
  EXPECT_NEAR(volume("cylinder.off") - volume("out.off"), ring, 0.01 * ring);
}

/// The radius at the direction of a vertex of the rim, by the contact of the ball on the top of the cylinder.
double radius_towards(const Blend_mesh& mesh, const Point_3& rim) {
  double nearest = 10;
  for (const Vertex v : mesh.vertices()) {
    const Point_3& p = mesh.point(v);
    const double across = (p.x() * rim.y() - p.y() * rim.x()) / 10, along = (p.x() * rim.x() + p.y() * rim.y()) / 10;
    if (p.z() == rim.z() && along > 1 && std::abs(across) < 0.3) nearest = std::min(nearest, along);
  }
  return 10 - nearest;
}

TEST_F(Cli, RadiusRunsAlongThePolylineFromItsFirstVertex) {
  const Blend_mesh sharp = read_mesh(path("cylinder.off"));
  const std::string law = "[[0, 1], [0.25, 1.5], [0.5, 3]]", typed = "0:1,0.25:1.5,0.5:3";
  for (const int sense : {1, -1})
    for (const int start : {0, 21}) {
      std::string indices;
      const auto place = [&](int i) { return 64 + (start + sense * i + 128) % 64; };
      for (int i = 0; i <= 64; ++i) indices += (i > 0 ? ", " : "") + std::to_string(place(i));
      write("own.json", R"({"blends": [{"polyline": [)" + indices + R"(], "radius": )" + law + "}]}");
      write("typed.json", R"({"blends": [{"polyline": [)" + indices + "]}]}");
      const Run r = run("fillet cylinder.off --blends own.json -o own.off");
      ASSERT_EQ(r.exit, 0) << r.err;
      expect_valid("own.off");
      const Blend_mesh mesh = read_mesh(path("own.off"));
      for (const auto& [quarter, radius] : {std::pair(0, 1.0), {1, 1.5}, {2, 3.0}, {3, 2.0}})
        EXPECT_NEAR(radius_towards(mesh, sharp.point(Vertex(place(16 * quarter)))), radius, 0.15)
            << quarter << ' ' << start << ' ' << sense;
      ASSERT_EQ(run("fillet cylinder.off --blends typed.json --radius " + typed + " -o typed.off").exit, 0);
      EXPECT_EQ(bytes("typed.off"), bytes("own.off"));
    }
}

TEST_F(Cli, PartsOfCurves) {
  const double section = (1 - pi / 4) * 0.2 * 0.2;
  write("part.json", R"({"blends": [{"polyline": [0, 1], "radius": 0.2, "from": 0.25, "to": 0.75},
                                    {"polyline": [6, 7], "radius": [[0, 0.1], [1, 0.3]], "from": 0.5},
                                    {"polyline": [2, 6], "radius": 0.2}]})");
  const Run r = run("fillet a.off --blends part.json -o out.off --chord-tolerance 4e-4 --report r.json");
  ASSERT_EQ(r.exit, 0) << r.err;
  expect_valid("out.off");
  const Json blends = json("r.json")["blends"];
  ASSERT_EQ(blends.size(), 3u);
  EXPECT_EQ(blends[0]["flat_ends"], 2);
  EXPECT_NE(r.out.find("2 flat ends"), std::string::npos) << r.out;
  Blend_mesh mesh = read_mesh(path("out.off"));
  const auto is_there = [&](const Point_3& p) {
    return std::any_of(mesh.vertices().begin(), mesh.vertices().end(), [&](Vertex v) { return mesh.point(v) == p; });
  };
  EXPECT_TRUE(is_there({0.5, 0, 0}) && is_there({1.5, 0, 0}) && is_there({1, 2, 2}));

  // Both options hold for every curve; the file has the last word.
  ASSERT_EQ(
      run("fillet a.off --sharp-angle 40 --from 0.25 --to 0.75 --radius 0.2 --chord-tolerance 4e-4 -o out.off").exit,
      0);
  expect_valid("out.off");
  EXPECT_NEAR(8 - volume("out.off"), 12 * section, 0.005 * 12 * section);
  write("own.json", R"({"blends": [{"polyline": [0, 1], "to": 0.5}, {"polyline": [4, 5]}]})");
  ASSERT_EQ(
      run("fillet a.off --blends own.json --from 0.25 --to 1 --radius 0.2 --chord-tolerance 4e-4 -o out.off").exit, 0);
  EXPECT_NEAR(8 - volume("out.off"), section * (0.5 + 1.5), 0.005 * section * 2);
}

/// Fractions run along a closed polyline, whichever way it runs round the rim.
TEST_F(Cli, PartOfAClosedPolyline) {
  std::string backward;
  for (int i = 64; i >= 0; --i) backward += (i < 64 ? ", " : "") + std::to_string(64 + i % 64);
  for (const bool turned : {false, true}) {
    const std::string polyline = turned ? backward : rim_of_cylinder();
    write("rim.json", R"({"blends": [{"polyline": [)" + polyline + R"(], "radius": 2, "from": 0.1, "to": 0.35}]})");
    const Run r = run("fillet cylinder.off --blends rim.json -o out.off");
    ASSERT_EQ(r.exit, 0) << r.err;
    expect_valid("out.off");
    const Blend_mesh mesh = read_mesh(path("out.off"));
    for (const Vertex v : mesh.vertices()) {  // within the part the rim is gone
      const Point_3& p = mesh.point(v);
      const double angle = std::atan2(turned ? -p.y() : p.y(), p.x()) / (2 * pi);
      const bool on_rim = p.z() == 20 && std::hypot(p.x(), p.y()) > 9;
      EXPECT_FALSE(on_rim && angle > 0.102 && angle < 0.348) << angle;
    }
  }
}

TEST_F(Cli, MapModeKeepsTheFacesOfTheSharpResult) {
  write_mesh(path("ground.off"), grid_box({-30, -30, -20}, {30, 30, 0}, 40));
  write_mesh(path("post.off"), cylinder(10, 96, -5.3, 20, 30));
  ASSERT_EQ(run("union ground.off post.off -o sharp.off").exit, 0);
  const Run r = run("union ground.off post.off --radius 4 --mode map -o out.off --report r.json");
  ASSERT_EQ(r.exit, 0) << r.err;
  expect_valid("out.off");
  const Blend_mesh sharp = read_mesh(path("sharp.off")), out = read_mesh(path("out.off"));
  ASSERT_EQ(sharp.number_of_faces(), out.number_of_faces());
  auto g = sharp.faces().begin();
  for (const Face f : out.faces()) ASSERT_EQ(corners_of(out, f), corners_of(sharp, *g++));
  EXPECT_GT(volume("out.off"), volume("sharp.off"));
  const Json blend = json("r.json")["blends"][0];
  EXPECT_GT(blend["coarseness"].get<double>(), 0);
  EXPECT_LT(blend["coarseness"].get<double>(), 0.2);
  EXPECT_EQ(blend["loops"], 0);
}

TEST_F(Cli, CoarseLevel) {
  write_mesh(path("large.off"), sphere(30, 5));
  write_mesh(path("small.off"), sphere(22, 5, {28, 0.3, 0.2}));
  const Run r = run("union large.off small.off --radius 6 --coarse 3000 -o out.off --report r.json");
  ASSERT_EQ(r.exit, 0) << r.err;
  expect_valid("out.off");
  EXPECT_GT(json("r.json")["timings_ms"]["coarsen"].get<double>(), 0);
  EXPECT_EQ(json("r.json")["blends"].size(), 1u);
  EXPECT_GT(json("r.json")["blends"][0]["edges"].get<int>(), 300) << "of the fine curve";
}

TEST_F(Cli, CoarseLevelKeepsGoing) {
  // A seam, and the edges of a box beside it, which meet in corners: reports for all of them.
  write_mesh(path("large.off"), sphere(30, 4));
  write_mesh(path("small.off"), sphere(22, 4, {28, 0.3, 0.2}));
  ASSERT_EQ(run("union large.off small.off -o pair.off").exit, 0);
  write_mesh(path("both.off"), side_by_side(read_mesh(path("pair.off")), box({-80, -10, -10}, {-60, 10, 10})));
  const std::string command = "fillet both.off --sharp-angle 50 --radius 5 --coarse 3000 -o out.off --report r.json";
  EXPECT_EQ(run(command).exit, 4);
  const Run r = run(command + " --keep-going");
  ASSERT_EQ(r.exit, 0) << r.err;
  expect_valid("out.off");
  int blended = 0, sharp = 0;
  const Json blends = json("r.json")["blends"];
  for (const Json& blend : blends) ++(blend["status"] == "ok" ? blended : sharp);
  EXPECT_EQ(blended, 1);
  EXPECT_EQ(sharp, 12);
}

TEST_F(Cli, SamplesAlongTheCurve) {
  const auto faces = [&](const std::string& sampling) {
    const Run r = run("union plate.off boss.off --radius 5 -o out.off --report r.json " + sampling);
    EXPECT_EQ(r.exit, 0) << r.err;
    return json("r.json")["output"]["blend_faces"].get<int>();
  };
  EXPECT_GT(faces("--samples 120"), 1.5 * faces("--samples 40"));
  EXPECT_GT(faces("--samples 40 --chord-ratio 0.005"), faces("--samples 40"));
}

TEST_F(Cli, SeveralBodiesEachWithItsRadius) {
  write_mesh(path("peg.off"), cylinder(6, 64, -5, 20));
  const std::string command =
      "union plate.off boss.off peg.off peg.off --transform-c '1 0 0 35 0 1 0 0 0 0 1 0' "
      "--transform-d '1 0 0 -35 0 1 0 5 0 0 1 0' -o out.off --report r.json --radius ";
  const Run r = run(command + "5,2,1");
  ASSERT_EQ(r.exit, 0) << r.err;
  expect_valid("out.off");
  const Json report = json("r.json");
  EXPECT_EQ(report["input"]["file"], "plate.off");
  EXPECT_EQ(report["input_b"]["file"], "boss.off");
  EXPECT_EQ(report["input_c"]["file"], "peg.off");
  EXPECT_EQ(report["input_d"]["file"], "peg.off");
  ASSERT_EQ(report["blends"].size(), 3u);
  for (const auto& [k, radius] : {std::pair(0, 5.0), {1, 2.0}, {2, 1.0}}) {
    EXPECT_EQ(report["blends"][k]["radius"], radius);
    EXPECT_EQ(report["blends"][k]["status"], "ok");
  }
  EXPECT_GT(report["output"]["untouched_share"].get<double>(), 0);
  ASSERT_EQ(run(command + "1.5").exit, 0);
  const Json again = json("r.json")["blends"];
  ASSERT_EQ(again.size(), 3u);
  for (const Json& blend : again) EXPECT_EQ(blend["radius"], 1.5);

  ASSERT_EQ(run("difference a.off b.off a.off -o out.off --transform-c '1 0 0 -1.5 0 1 0 -1.5 0 0 1 -1.5'").exit, 0);
  EXPECT_NEAR(volume("out.off"), 6.875, 1e-12);
  ASSERT_EQ(run("intersection a.off b.off a.off -o out.off --transform-c '1 0 0 .5 0 1 0 .5 0 0 1 -.5'").exit, 0);
  EXPECT_NEAR(volume("out.off"), 0.5, 1e-12);
}

TEST_F(Cli, ThreeWaysToChooseEdges) {
  const Blend_mesh mesh = read_mesh(path("cylinder.off"));
  std::string selection = "\n\n", indices, points;
  for (int i = 64; i <= 128; ++i) {  // the upper rim
    const int v = 64 + i % 64;
    const Point_3& p = mesh.point(Vertex(v));
    if (i < 128) selection += std::to_string(v) + " " + std::to_string(64 + (i + 1) % 64) + " ";
    indices += (i > 64 ? "," : "") + std::to_string(v);
    points += (i > 64 ? "," : "") + Json{p.x(), p.y(), p.z()}.dump();
  }
  write("rim.selection.txt", selection + "\n");
  write("indices.json", R"({"blends": [{"polyline": [)" + indices + R"(], "radius": 2, "profile": "arc"}]})");
  write("points.json", R"({"blends": [{"polyline": [)" + points + "]}]}");
  write_mesh(path("cylinder.stl"), mesh);

  EXPECT_EQ(run("fillet cylinder.off --sharp-angle 40 --radius 2 -o both.off").exit, 0);
  EXPECT_EQ(run("fillet cylinder.off --edges rim.selection.txt --radius 2 -o one.off").exit, 0);
  EXPECT_EQ(run("fillet cylinder.off --blends indices.json -o two.off").exit, 0);
  EXPECT_EQ(run("fillet cylinder.stl --blends points.json --radius 2 -o three.off").exit, 0);
  for (const char* file : {"both.off", "one.off", "two.off", "three.off"}) expect_valid(file);
  EXPECT_EQ(bytes("one.off"), bytes("two.off"));
  const double full = volume("cylinder.off");
  EXPECT_NEAR(full - volume("both.off"), 2 * (full - volume("one.off")), 1e-3 * (full - volume("both.off")));
  EXPECT_NEAR(volume("three.off"), volume("one.off"), 1e-4 * full);
}

TEST_F(Cli, SameInputSameBytes) {
  ASSERT_EQ(run("union plate.off boss.off --radius 3 -o first.off").exit, 0);
  ASSERT_EQ(run("union plate.off boss.off --radius 3 -o second.off").exit, 0);
  EXPECT_EQ(bytes("first.off"), bytes("second.off"));
}

TEST_F(Cli, OutputMayReplaceTheInput) {
  ASSERT_EQ(run("union a.off b.off -o a.off").exit, 0);
  EXPECT_NEAR(volume("a.off"), 15, 1e-12);
}

TEST_F(Cli, CheckPrintsAndReports) {
  const Run text = run("check a.off");
  EXPECT_EQ(text.exit, 0);
  EXPECT_NE(text.out.find("valid"), std::string::npos);
  for (const char* flag : {"--json", "--report -"}) {
    const Json report = Json::parse(run(std::string("check a.off ") + flag).out);
    EXPECT_EQ(report["status"], "ok");
    EXPECT_EQ(report["output"]["faces"], 12);
    EXPECT_TRUE(report["output"]["closed"].get<bool>() && report["output"]["outward"].get<bool>());
    EXPECT_NEAR(report["output"]["volume"].get<double>(), 8, 1e-12);
  }
}

TEST_F(Cli, CurvatureOfATorus) {
  write_mesh(path("torus.off"), torus(3, 1, 96, 32));
  const Run r = run("curvature torus.off -o torus.ply --report report.json");
  ASSERT_EQ(r.exit, 0) << r.err;
  EXPECT_NE(r.out, "");
  EXPECT_TRUE(identical(read_mesh(path("torus.ply")), read_mesh(path("torus.off"))));
  EXPECT_NE(bytes("torus.ply").find("property double mean_curvature"), std::string::npos);
  const Json report = json("report.json");
  const Json& curvature = report["curvature"];
  EXPECT_NEAR(curvature["max"].get<double>(), (1 + 1 / 4.0) / 2, 0.01);
  EXPECT_NEAR(curvature["min"].get<double>(), (1 - 1 / 2.0) / 2, 0.01);
  EXPECT_NEAR(curvature["mean"].get<double>(), 0.47, 0.01);  // of a function of the latitude alone: an integral over it
  EXPECT_LE(curvature["limit"], curvature["max"]);
  EXPECT_EQ(report["output"]["faces"], 2 * 96 * 32);
  ASSERT_EQ(run("curvature torus.off -o wide.ply --limit 100 --quiet --report wide.json").exit, 0);
  EXPECT_EQ(json("wide.json")["curvature"]["limit"], 100);
  EXPECT_NE(bytes("wide.ply"), bytes("torus.ply"));
}

TEST_F(Cli, CurvatureOfABlendIsThatOfItsTorus) {
  ASSERT_EQ(run("union plate.off boss.off -o out.off --radius 5 --curvature out.ply --report r.json").exit, 0);
  EXPECT_TRUE(identical(read_mesh(path("out.ply")), read_mesh(path("out.off"))));
  const Json curvature = json("r.json")["curvature"];
  EXPECT_LT(curvature["min"].get<double>(), (-1 / 5.0 + 1 / 15.0) / 2 * 0.9) << "the fillet is concave";
  EXPECT_GT(curvature["max"].get<double>(), 1 / 15.0) << "the plate's edges are convex";
  ASSERT_EQ(run("fillet cylinder.off --sharp-angle 40 --radius 2 -o out.off --curvature out.ply").exit, 0);
  EXPECT_TRUE(identical(read_mesh(path("out.ply")), read_mesh(path("out.off"))));
}

TEST_F(Cli, HelpAndVersion) {
  EXPECT_EQ(run("--version").exit, 0);
  for (const char* word : {"", "union", "fillet", "check"}) {
    const Run r = run(std::string(word) + " --help");
    EXPECT_EQ(r.exit, 0);
    EXPECT_NE(r.out, "");
    EXPECT_EQ(r.err, "");
  }
}

}  // namespace
