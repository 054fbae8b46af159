// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_runner.h"

#include "bridge_spheres.h"
#include "checks.h"

#include <cgal_blend/mesh_io.h>
#include <cgal_blend/validate.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;

const std::string ends = " --at-a 0,0,1 --at-b 0,0,1.8 --radius-a 0.6 --radius-b 0.5 ";

class Cli_bridge : public Cli_runner {
 protected:
  void SetUp() override {
    Cli_runner::SetUp();
    write_mesh(path("a.off"), sphere(1, 3));
    write_mesh(path("b.off"), sphere(0.8, 3, {0, 0, 2.6}));
    write_mesh(path("small.off"), sphere(0.8, 3));
    write_mesh(path("ring.off"), torus(1, 0.35, 64, 32));
    write("points.txt", "# angle distance\n0 0.4\n120 0.5\n240 0.45\n");
  }

  /// Runs a command that must succeed, and returns the mesh it wrote, which must be valid.
  Blend_mesh result_of(const std::string& arguments) {
    const Run r = run("bridge " + arguments + " -o out.off --report report.json --quiet");
    EXPECT_EQ(r.exit, 0) << r.err;
    EXPECT_EQ(r.out + r.err, "");
    if (r.exit != 0) return {};
    const Blend_mesh mesh = read_mesh(path("out.off"));
    EXPECT_TRUE(validate(mesh).ok());
    return mesh;
  }
};

TEST_F(Cli_bridge, joins_two_bodies_with_a_report_and_labels) {
  const Blend_mesh mesh =
      result_of("a.off b.off" + ends + "--lambda-a 0.2 --mu 0.4 --order 3 --twist 20 --labels l.txt");
  EXPECT_EQ(euler(mesh), 2);
  const Json report = json("report.json");
  EXPECT_EQ(report["command"], "bridge");
  EXPECT_EQ(report["status"], "ok");
  EXPECT_EQ(report["output"]["closed"], true);
  EXPECT_EQ(report["output"]["faces"], mesh.number_of_faces());
  EXPECT_NEAR(report["output"]["volume"].get<double>(), volume_of(mesh), 1e-9);
  ASSERT_EQ(report["blends"].size(), 1u);
  const Json& bridge = report["blends"][0];
  EXPECT_EQ(bridge["lambda"][0], 0.2);
  EXPECT_EQ(bridge["lambda"][1], 0.5);
  EXPECT_EQ(bridge["mu"], 0.4);
  EXPECT_EQ(bridge["order"], 3);
  EXPECT_LT(bridge["tangency_deg"].get<double>(), 8);
  std::istringstream labels(bytes("l.txt"));
  std::vector<std::string> lines;
  for (std::string line; std::getline(labels, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), mesh.number_of_faces());
  EXPECT_EQ(std::count(lines.begin(), lines.end(), "bridge 1"), bridge["faces"].get<long>());
  EXPECT_EQ(report["output"]["blend_faces"], bridge["faces"]);
  EXPECT_EQ(lines.front(), "body A");
  EXPECT_GT(std::count(lines.begin(), lines.end(), "body B"), 100);
}

TEST_F(Cli_bridge, lets_scenes_say_all_about_their_bridges) {
  write("one.json", R"({"bodies": {"a": {"file": "a.off"}, "b": {"file": "b.off"}},
    "bridges": [{"ends": [{"at": [0, 0, 1], "radius": 0.6}, {"at": [0, 0, 1.8], "radius": 0.5}]}]})");
  EXPECT_EQ(run("bridge --scene one.json -o out.off").exit, 0);
  for (const char* ignored : {"--cross", "--at-a 0,0,1", "--radius-b 2", "--mu 0.2", "--twist 3", "--drag 0,0.5:0,0,1"})
    EXPECT_EQ(run(std::string("bridge --scene one.json -o out.off ") + ignored).exit, 2) << ignored;
}

TEST_F(Cli_bridge, takes_holes_away_on_demand) {
  Blend_mesh mesh = sphere(1, 3);
  for (const Vertex v : std::vector<Vertex>(mesh.vertices().begin(), mesh.vertices().end()))
    if (mesh.point(v).z() > 0.999) CGAL::Euler::remove_center_vertex(mesh.halfedge(v), mesh);
  for (const Face f : std::vector<Face>(mesh.faces().begin(), mesh.faces().end()))
    if (mesh.degree(f) > 3) CGAL::Euler::make_hole(mesh.halfedge(f), mesh);
  mesh.collect_garbage();
  ASSERT_FALSE(CGAL::is_closed(mesh));
  write_mesh(path("open.off"), mesh);
  const Run refused = run("bridge open.off b.off" + ends + "-o refused.off");
  EXPECT_EQ(refused.exit, 3);
  EXPECT_NE(refused.err.find("--fill-holes"), std::string::npos) << refused.err;
  EXPECT_EQ(euler(result_of("open.off b.off --fill-holes --labels l.txt" + ends)), 2);
  std::istringstream labels(bytes("l.txt"));
  for (std::string line; std::getline(labels, line);)
    EXPECT_TRUE(line == "body A" || line == "body B" || line == "bridge 1") << line;
  const Run missed =
      run("bridge open.off b.off --fill-holes --at-a 0,0,1 --at-b 0,0,1.8 --radius-a 0.05 --radius-b 0.3 -o m.off");
  EXPECT_EQ(missed.exit, 4);
  EXPECT_NE(missed.err.find("would take it away"), std::string::npos) << missed.err;
}

TEST_F(Cli_bridge, places_the_second_body) {
  const Blend_mesh there = result_of("a.off b.off" + ends);
  const Blend_mesh placed = result_of("a.off small.off" + ends + "--transform-b \"1 0 0 0 0 1 0 0 0 0 1 2.6\"");
  EXPECT_NEAR(volume_of(there), volume_of(placed), 1e-9);
}

TEST_F(Cli_bridge, makes_a_handle_on_one_body) {
  EXPECT_EQ(euler(result_of("ring.off --at-a 0.65,0,0 --at-b -0.65,0,0 --radius-a 0.2 --radius-b 0.2")), -2);
}

TEST_F(Cli_bridge, takes_every_curve) {
  for (const std::string curve : {"circle", "ellipse:0.5,0.3", "rect:0.4,0.3", "rect:0.4,0.3,0.2", "star:0.3,5",
                                  "cross:0.5,0.2", "cross:0.5,0.2,0.05", "points.txt"})
    EXPECT_EQ(euler(result_of("a.off b.off" + ends + "--curve-a " + curve + " --curve-b " + curve)), 2) << curve;
}

TEST_F(Cli_bridge, drags_the_surface) {
  (void)result_of("a.off b.off" + ends + "--zero-a 1,0,0 --zero-b 1,0,0");
  (void)result_of("a.off b.off" + ends + "--zero-a 1,0,0 --zero-b 1,0,0 --drag 0,0.5:0.36,0,1.4");
  const Json near = json("report.json")["blends"][0];
  EXPECT_LT(near["drag"]["residual"].get<double>(), 0.05);
  EXPECT_NE(near["lambda"][0], 0.5);
  (void)result_of("a.off b.off" + ends + "--zero-a 1,0,0 --zero-b 1,0,0 --drag 0,0.5:5,0,1.4");
  const Json far = json("report.json")["blends"][0];
  EXPECT_EQ(far["drag"]["reached"], false);
  EXPECT_GT(far["drag"]["residual"].get<double>(), 4);
}

TEST_F(Cli_bridge, makes_several_bridges_of_a_scene) {
  write("scene.json", R"({
    "bodies": {"left": {"sphere": {"radius": 1, "level": 3}},
               "right": {"file": "b.off"},
               "top": {"ellipsoid": {"axes": [0.5, 0.4, 0.3], "centre": [0, 0, 4.5], "level": 3}},
               "ring": {"torus": {"major": 3, "minor": 0.3}, "transform": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0]},
               "post": {"cylinder": {"radius": 0.4, "height": 2, "centre": [0, 0, 7]}}},
    "bridges": [{"ends": [{"at": [0, 0, 1], "radius": 0.3}, {"at": [0, 0, 1.8], "radius": 0.3, "lambda": 0.2}]},
                {"ends": [{"at": [0, 0, 3.4], "radius": 0.3}, {"at": [0, 0, 4.2], "curve": "ellipse:0.2,0.1"}]},
                {"ends": [{"at": [1, 0, 0], "radius": 0.3}, {"at": [2.7, 0, 0], "radius": 0.2}], "order": 1},
                {"ends": [{"at": [-1, 0, 0], "radius": 0.3}, {"at": [-2.7, 0, 0], "radius": 0.2}], "twist": 30},
                {"ends": [{"at": [0, 0, 4.8], "radius": 0.2}, {"at": [0, 0, 6], "radius": 0.3}]}]})");
  const Blend_mesh mesh = result_of("--scene scene.json --labels l.txt");
  EXPECT_EQ(validate(mesh).components, 1u);
  EXPECT_EQ(euler(mesh), -2);  // the ring has one hole, its two spokes make another
  EXPECT_EQ(json("report.json")["blends"].size(), 5u);
  const std::string labels = bytes("l.txt");
  for (const std::string label : {"body left\n", "body post\n", "bridge 1\n", "bridge 5\n"})
    EXPECT_NE(labels.find(label), std::string::npos) << label;
}

TEST_F(Cli_bridge, repeats_itself_byte_by_byte) {
  (void)result_of("a.off b.off" + ends);
  const std::string once = bytes("out.off");
  (void)result_of("a.off b.off" + ends);
  EXPECT_EQ(bytes("out.off"), once);
}

struct Bridge_refusal {
  std::string arguments;
  int exit;
  std::string word;    ///< in the line on standard error
  std::string status;  ///< in the report; empty: there is none
};

TEST_F(Cli_bridge, refuses_bad_input_with_one_line_and_nothing_written) {
  write("crossing.json", R"({"bodies": {"a": {"file": "a.off"}}, "bridges": [], "more": 1})");
  write("no_body.json", R"({"bodies": {}, "bridges": [{}]})");
  write("no_file.json", R"({"bodies": {"a": {"file": "none.off"}}, "bridges": [{}]})");
  write("flat.json", R"({"bodies": {"a": {"sphere": {"radius": 0}}}, "bridges": [{}]})");
  write("no_at.json", R"({"bodies": {"a": {"sphere": {"radius": 1}}}, "bridges": [{"ends": [{"radius": 1}, {}]}]})");
  write("falling.txt", "0 1\n90 1\n45 1\n");
  const std::string two = "a.off b.off", at = " --at-a 0,0,1 --at-b 0,0,1.8 ";
  const std::vector<Bridge_refusal> refusals{
      {two + " --at-a 0,0,1.2 --at-b 0,0,1.8 --radius-a 0.6 --radius-b 0.5", 4, "does not lie on the mesh",
       "spot_off_surface"},
      {two + at + "--radius-a 3.5 --radius-b 0.5", 4, "largest radius that works", "radius_exceeds_cut_locus"},
      {two + ends + "--lambda-a 1", 2, "lambda", "invalid_parameter"},
      {two + ends + "--lambda-b -0.5", 2, "lambda", "invalid_parameter"},
      {two + ends + "--mu 0", 2, "mu", "invalid_parameter"},
      {two + ends + "--mu 1.5", 2, "mu", "invalid_parameter"},
      {two + ends + "--order 4", 2, "order", "invalid_parameter"},
      {two + ends + "--order 1.5", 2, "whole", ""},
      {two + ends + "--twist much", 2, "not a number", ""},
      {two + at + "--radius-a -1 --radius-b 0.5", 2, "greater than 0", "invalid_parameter"},
      {two + at + "--radius-b 0.5", 2, "--radius-a", "invalid_parameter"},
      {two + " --at-a 0,0,1 --radius-a 0.6 --radius-b 0.5", 2, "--at-b", "invalid_parameter"},
      {two + " --at-a 0,0 --at-b 0,0,1.8 --radius-a 0.6 --radius-b 0.5", 2, "3 numbers", "invalid_parameter"},
      {two + ends + "--curve-a rect:1", 2, "two lengths", "invalid_parameter"},
      {two + ends + "--curve-a rect:0.2,0.1,0.5", 2, "corners", "invalid_parameter"},
      {two + ends + "--curve-a cross:0.1,0.2", 2, "longer than wide", "invalid_parameter"},
      {two + ends + "--curve-a star:2,5", 2, "depth", "invalid_parameter"},
      {two + ends + "--curve-a none.txt", 3, "cannot be opened", "input_unreadable"},
      {two + ends + "--curve-a falling.txt", 3, "ascend", "input_unreadable"},
      {two + ends + "--drag 0.5", 2, "S,T:X,Y,Z", "invalid_parameter"},
      {two + ends + "--drag 0.5,2:0,0,0", 2, "between 0 and 1", "invalid_parameter"},
      {two + ends + "--scene no_body.json", 2, "place of A and B", "invalid_parameter"},
      {"a.off" + ends + "--transform-b \"1 0 0 0 0 1 0 0 0 0 1 0\"", 2, "no second body", "invalid_parameter"},
      {"a.off --at-a 0,0,1 --at-b 0,0.3,0.95 --radius-a 0.3 --radius-b 0.3", 4, "", "regions_overlap"},
      {two + " --at-a 0,0,-1 --at-b 0,0,1.8 --radius-a 0.3 --radius-b 0.3", 4, "runs into", "blend_collides"},
      {"a.off none.off" + ends, 3, "none.off", "input_unreadable"},
      {"a.off --cross --radius-a 0.1 --radius-b 0.1", 2, "second body", "invalid_parameter"},
      {two + " --cross --radius-a 0.1 --radius-b 0.1", 4, "do not meet", "operands_disjoint"},
      {"--scene crossing.json", 3, "'more' is not known", "input_unreadable"},
      {"--scene no_body.json", 3, "there is no body", "input_unreadable"},
      {"--scene no_file.json", 3, "none.off", "input_unreadable"},
      {"--scene flat.json", 3, "greater than 0", "input_unreadable"},
      {"--scene no_at.json", 3, "no 'at'", "input_unreadable"},
      {"", 2, "A is needed", "invalid_parameter"}};
  for (const Bridge_refusal& refusal : refusals) {
    std::filesystem::remove(path("report.json"));
    const Files before = files();
    const Run r = run("bridge " + refusal.arguments + " -o out.off --report report.json");
    EXPECT_EQ(r.exit, refusal.exit) << refusal.arguments << "\n" << r.err;
    EXPECT_EQ(std::count(r.err.begin(), r.err.end(), '\n'), 1) << r.err;
    EXPECT_NE(r.err.find(refusal.word), std::string::npos) << refusal.arguments << "\n" << r.err;
    EXPECT_FALSE(std::filesystem::exists(path("out.off"))) << refusal.arguments;
    if (!refusal.status.empty()) {
      EXPECT_EQ(json("report.json")["status"], refusal.status) << refusal.arguments;
    }
    std::filesystem::remove(path("report.json"));
    EXPECT_EQ(changed_since(before), "") << refusal.arguments;
  }
}

}  // namespace
