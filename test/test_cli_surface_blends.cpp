// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/bspline_surface.h>
#include <cgal_blend/mesh_io.h>
#include <cgal_blend/validate.h>

#include "checks.h"
#include "cli_runner.h"

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace cgal_blend::test;
using cgal_blend::Blend_mesh;

constexpr double pi = 3.14159265358979323846;

class Cli_surface_blends : public Cli_runner {
 protected:
  void expect_refused(const std::string& scene, int exit, const std::string& words) {
    write("scene.json", scene);
    write("out.off", "untouched");
    const Files before = files();
    const Run r = run("quadrics scene.json -o out.off");
    EXPECT_EQ(r.exit, exit) << r.err;
    EXPECT_NE(r.err.find(words), std::string::npos) << r.err;
    EXPECT_EQ(std::count(r.err.begin(), r.err.end(), '\n'), 1) << r.err;
    EXPECT_EQ(changed_since(before), "");
  }
};

/// Two coaxial cylinders of different radii, `a` and `b`, joined; with parts of the text replaced.
std::string scene_with(const std::string& from = "", const std::string& to = "") {
  std::string text = R"({"surfaces": {
    "a": {"quadric": [1, 1, 0, 0, 0, 0, 0, 0, 0, -1], "far": [[0, 0, -1, -2]]},
    "b": {"quadric": [1, 1, 0, 0, 0, 0, 0, 0, 0, -4], "far": [[0, 0, 1, -6]]}},
    "blends": [{"first": {"surface": "a", "plane": [0, 0, 1, 0]},
                "second": {"surface": "b", "plane": [0, 0, 1, -4]}, "distance": 1}]})";
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos);
  return text.replace(at, from.size(), to);
}

TEST_F(Cli_surface_blends, Blends_all_example_scenes) {
  std::vector<std::string> scenes;
  for (const auto& entry : std::filesystem::directory_iterator(CGAL_BLEND_EXAMPLES "/surface_blends"))
    if (entry.path().extension() == ".json") scenes.push_back(entry.path().string());
  ASSERT_GE(scenes.size(), 11u);
  for (const std::string& scene : scenes) {
    SCOPED_TRACE(scene);
    const Run r = run("quadrics '" + scene + "' -o out.off --report report.json --labels labels.txt");
    ASSERT_EQ(r.exit, 0) << r.err;
    const Blend_mesh mesh = cgal_blend::read_mesh(path("out.off"));
    EXPECT_TRUE(cgal_blend::validate(mesh).ok());
    EXPECT_TRUE(is_closed_by_counting(mesh));
    EXPECT_TRUE(has_single_fans(mesh));
    EXPECT_GT(volume_of(mesh), 0);
    const Json report = json("report.json");
    EXPECT_NEAR(report["output"]["volume"].get<double>(), volume_of(mesh), 1e-9 * volume_of(mesh));
    std::size_t faces = report["output"]["cap_faces"];
    for (const auto& blend : report["blends"]) {
      EXPECT_LT(blend["tangency_deg"].get<double>(), 1e-6);
      faces += blend["faces"].get<std::size_t>();
    }
    for (const auto& count : report["output"]["surface_faces"]) faces += count.get<std::size_t>();
    EXPECT_EQ(faces, mesh.number_of_faces());
    const std::string labels = bytes("labels.txt");
    EXPECT_EQ(static_cast<std::size_t>(std::count(labels.begin(), labels.end(), '\n')), mesh.number_of_faces());
  }
}

// Of a body of revolution the volume of the blend is that of its profile, here by quadrature.
TEST_F(Cli_surface_blends, Has_the_volume_of_its_profile) {
  write("scene.json", scene_with("\"blends\"", "\"chord_tolerance\": 1e-4, \"blends\""));
  ASSERT_EQ(run("quadrics scene.json -o out.off").exit, 0);
  double blend = 0;
  const int n = 2000;
  for (int i = 0; i < n; ++i) {
    const double t = (i + 0.5) / n, u = 1 - t;
    const double r = 1 * (u * u * u + 3 * u * u * t) + 2 * (3 * u * t * t + t * t * t);  // radius, T along the axis
    const double dz = 3 * (u * u * 1 + 2 * u * t * 2 + t * t * 1);                       // control heights 0, 1, 3, 4
    blend += pi * r * r * dz / n;
  }
  const double expected = 2 * pi + blend + 2 * 4 * pi;
  EXPECT_NEAR(volume_of(cgal_blend::read_mesh(path("out.off"))), expected, 1e-3 * expected);
}

TEST_F(Cli_surface_blends, Joins_a_mesh_file_and_leaves_bodies_open_if_asked) {
  write("scene.json", scene_with("\"blends\"", "\"capped\": false, \"blends\""));
  ASSERT_EQ(run("quadrics scene.json -o tube.off --report report.json").exit, 0);
  EXPECT_FALSE(json("report.json")["output"]["closed"].get<bool>());
  const Blend_mesh tube = cgal_blend::read_mesh(path("tube.off"));
  std::size_t on_border = 0;
  for (const auto v : tube.vertices())
    if (tube.is_border(v) && tube.point(v).z() > 5.9) on_border = v;
  write("mesh.json", R"({"surfaces": {"tube": {"mesh": "tube.off", "border": )" + std::to_string(on_border) + R"(},
    "ball": {"quadric": [1, 1, 1, 0, 0, 0, 0, 0, -20, 91]}},
    "blends": [{"first": {"surface": "tube"}, "second": {"surface": "ball", "plane": [0, 0, 1, -9]}}]})");
  const Run r = run("quadrics mesh.json -o out.off");
  ASSERT_EQ(r.exit, 0) << r.err;
  EXPECT_TRUE(is_closed_by_counting(cgal_blend::read_mesh(path("out.off"))));
}

TEST_F(Cli_surface_blends, Writes_step_or_says_that_it_cannot) {
  write("scene.json", scene_with());
  const Run r = run("quadrics scene.json -o out.off --step out.step --report report.json");
  if (!cgal_blend::has_step()) {
    EXPECT_EQ(r.exit, 2);
    EXPECT_NE(r.err.find("Open CASCADE"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(path("out.off")));
    return;
  }
  ASSERT_EQ(r.exit, 0) << r.err;
  EXPECT_NE(bytes("out.step").find("B_SPLINE_SURFACE_WITH_KNOTS"), std::string::npos);
  EXPECT_LT(json("report.json")["blends"][0]["step_error"].get<double>(), 1e-4 * 4 * pi);
}

TEST_F(Cli_surface_blends, Refuses_what_is_no_scene) {
  expect_refused("nonsense", 3, "is not JSON");
  expect_refused(scene_with("\"a\": {\"quadric\"", "\"a\": {\"quadrick\""), 3, "'quadric'");
  expect_refused(scene_with("0, 0, -1]", "0, 0, \"x\"]"), 3, "no fraction");
  expect_refused(scene_with("[1, 1, 0, 0, 0, 0, 0, 0, 0, -1]", "[0, 0, 0, 0, 0, 0, 0, 0, 0, 0]"), 3,
                 "all coefficients are 0");
  expect_refused(scene_with("0, 0, -4]", "0, 0, 1e999]"), 3, "JSON");
  expect_refused(scene_with("\"distance\": 1", "\"distanse\": 1"), 3, "'distanse' is not known");
  expect_refused(scene_with("\"distance\": 1", "\"distance\": \"sin(\""), 3, "no formula");
  expect_refused(scene_with("\"distance\": 1", "\"distance\": \"system(s)\""), 3, "'system' is not known");
  expect_refused(scene_with("\"surface\": \"a\"", "\"surface\": \"c\""), 3, "no surface 'c'");
}

TEST_F(Cli_surface_blends, Refuses_impossible_blends_by_name) {
  expect_refused(scene_with("[0, 0, 1, 0]", "[1, 0, 0, -3]"), 4, "do not meet");
  expect_refused(scene_with("\"plane\": [0, 0, 1, 0]", "\"cutter\": [1, 1, 0, 0, 0, 0, 0, 0, 0, -1]"), 4,
                 "share a surface");
  expect_refused(scene_with("[0, 0, 1, 0]", "[1, 0, 0, 0]"), 4, "2 curves");
  expect_refused(scene_with("\"plane\": [0, 0, 1, 0]", "\"plane\": [1, 0, 0, 0], \"component\": 0"), 4, "closed");
  expect_refused(scene_with("\"distance\": 1", "\"distance\": 30"), 4, "folds");
  expect_refused(scene_with("\"distance\": 1", "\"direction\": 1"), 2, "between -1 and 1");
  expect_refused(scene_with(", \"far\": [[0, 0, -1, -2]]", ""), 4, "no far plane");
  // A plane that meets a cone in the apex alone.
  expect_refused(scene_with("[1, 1, 0, 0, 0, 0, 0, 0, 0, -1]", "[1, 1, -1, 0, 0, 0, 0, 0, 0, 0]"), 4,
                 "do not meet in a curve");
}

TEST_F(Cli_surface_blends, Refuses_singular_and_infinite_surfaces) {
  const auto scene = [](const std::string& a, const std::string& side) {
    return "{\"surfaces\": {\"a\": " + a +
           R"(, "b": {"quadric": [1, 1, 0, 0, 0, 0, 0, 0, 0, -4], "far": [[0, 0, 1, -6]]}},
      "blends": [{"first": {"surface": "a", )" +
           side + R"(}, "second": {"surface": "b", "plane": [0, 0, 1, -4]}}]})";
  };
  // A sphere through the apex of a cone: the curve has a node there.
  expect_refused(scene(R"({"quadric": [1, 1, -1, 0, 0, 0, 0, 0, 0, 0], "far": [[0, 0, -1, -2]]})",
                       R"("cutter": [1, 1, 1, 0, 0, 0, -2, 0, 0, 0], "component": 0)"),
                 4, "singular point");
  expect_refused(
      scene(
          R"json({"patch": ["cos(u)", "sin(u)", "log(v)"], "domain": [0, 6.283185307179586, -1, 1], "closed": true})json",
          R"("end": "end")"),
      3, "finite");
  expect_refused(scene_with("\"distance\": 1", "\"middle\": [\"x\", \"y\", \"log(s - 1)\"]"), 2, "not finite");
}

}  // namespace
