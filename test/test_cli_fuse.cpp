// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_runner.h"

#include "checks.h"
#include "fusions.h"
#include "shapes.h"

#include <cgal_blend/mesh_io.h>
#include <cgal_blend/validate.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;

class Cli_fuse : public Cli_runner {
 protected:
  void SetUp() override {
    Cli_runner::SetUp();
    write_mesh(path("low.off"), frustum(1, 1, 24, -1, 0.5, 4));
    write_mesh(path("high.off"), frustum(0.7, 0.7, 24, 1, 3, 3));
    write_mesh(path("out.off"), frustum(1, 1, 3, 0, 1, 1));  // an earlier output
  }

  /// Refused with this status: one line, and nothing written or changed.
  void refused(const std::string& arguments, int exit, const std::string& part_of_message) {
    const Files before = files();
    const Run r = run("fuse " + arguments + " -o out.off");
    EXPECT_EQ(r.exit, exit) << arguments << "\n" << r.err;
    EXPECT_NE(r.err.find(part_of_message), std::string::npos) << r.err;
    EXPECT_EQ(std::count(r.err.begin(), r.err.end(), '\n'), 1) << r.err;
    EXPECT_EQ(r.out, "");
    EXPECT_EQ(changed_since(before), "");
  }

  const std::string low = "--lower low.off --lower-plane 0,0,0,0,0,1 ";
  const std::string high = "--upper high.off --upper-plane 0,0,1.5,0,0,-1 ";
};

TEST_F(Cli_fuse, writes_a_valid_solid_with_report_and_labels) {
  const Run r = run("fuse " + low + high + "-o out.off --report r.json --labels l.txt");
  ASSERT_EQ(r.exit, 0) << r.err;
  EXPECT_NE(r.out.find("from 1 to 1 rings"), std::string::npos) << r.out;
  const Blend_mesh mesh = read_mesh(path("out.off"));
  EXPECT_TRUE(validate(mesh).ok());
  const Json report = json("r.json");
  EXPECT_EQ(report["command"], "fuse");
  EXPECT_EQ(report["status"], "ok");
  EXPECT_NEAR(report["output"]["volume"].get<double>(), volume_of(mesh), 1e-9);
  EXPECT_EQ(report["output"]["euler_characteristic"], 2);
  EXPECT_EQ(report["output"]["closed"], true);
  ASSERT_EQ(report["blends"].size(), 1u);
  const Json& fusion = report["blends"][0];
  EXPECT_EQ(fusion["rings"], Json({1, 1}));
  EXPECT_EQ(fusion["height"], 1.5);
  EXPECT_EQ(fusion["angle_deg"], 0.0);
  std::istringstream labels(bytes("l.txt"));
  std::string word;
  std::size_t transition = 0, lines = 0;
  for (; labels >> word; ++lines) transition += word == "transition";
  EXPECT_EQ(lines, mesh.number_of_faces());
  EXPECT_EQ(transition, fusion["faces"].get<std::size_t>());
  EXPECT_EQ(bytes("r.json").find("nan"), std::string::npos);
}

TEST_F(Cli_fuse, places_the_upper_meshes_with_their_plane) {
  const Blend_mesh high_mesh = read_mesh(path("high.off"));
  write_mesh(path("placed.off"), transformed(high_mesh, moved_by(0.25, 0, 1)));
  ASSERT_EQ(run("fuse " + low + high + "--place-upper '1 0 0 0.25 0 1 0 0 0 0 1 1' -o a.off --quiet").exit, 0);
  ASSERT_EQ(run("fuse " + low + "--upper placed.off --upper-plane 0.25,0,2.5,0,0,-1 -o b.off --quiet").exit, 0);
  EXPECT_EQ(bytes("a.off"), bytes("b.off"));
  // A stretch turns the plane's normal by its inverse transpose: this plane stays level.
  EXPECT_EQ(run("fuse " + low + high + "--place-upper '1 0 0 0 0 1 0 0 0 0 3 0' -o c.off --report c.json --quiet").exit,
            0);
  EXPECT_EQ(json("c.json")["blends"][0]["height"], 4.5);
  EXPECT_EQ(json("c.json")["blends"][0]["angle_deg"], 0.0);
}

TEST_F(Cli_fuse, takes_several_meshes_a_side_and_all_forms) {
  const Blend_mesh leg = frustum(0.5, 0.5, 24, -1, 0.5, 4);
  write_mesh(path("left.off"), transformed(leg, moved_by(-0.6, 0, 0)));
  write_mesh(path("right.off"), transformed(leg, moved_by(0.6, 0, 0)));
  const std::string legs = "--lower left.off,right.off --lower-plane 0,0,0,0,0,1 ";
  for (const std::string form : {"--implicit sdf", "--implicit grid", "--implicit rbf", "--rho 0.1", "--eta 0.2,0.8",
                                 "--weight 2,1", "--edge 0.08", "--grading 2", "--least-angle 25", "--step 0.5"}) {
    const Run r = run("fuse " + legs + high + form + " -o out.off --report r.json --quiet");
    ASSERT_EQ(r.exit, 0) << form << ": " << r.err;
    EXPECT_EQ(r.out + r.err, "");
    EXPECT_EQ(json("r.json")["blends"][0]["rings"], Json({2, 1}));
    EXPECT_EQ(json("r.json")["output"]["euler_characteristic"], 2);
    EXPECT_EQ(run("check out.off --quiet").exit, 0) << form;
  }
  EXPECT_EQ(json("r.json")["more_inputs"].is_null(), true) << "inputs are listed as for other commands";
}

TEST_F(Cli_fuse, refuses_what_cannot_be_fused) {
  refused("--lower low.off --lower-plane 0,0,9,0,0,1 " + high, 4, "by between 8.5 and 10, at (");
  refused("--lower low.off --lower-plane 0,0,0,0,1,0 " + high, 4, "through a vertex");
  refused("--lower low.off --lower-plane 0,0,0.125,0,0,1 " + high, 4, "by 0.1875 ");
  refused("--lower low.off --lower-plane 0,0,0.5,0,0,1 " + high, 4, "along a face");
  refused(low + "--upper low.off --upper-plane 0,0,-0.2,0,0,-1 ", 4, "by more than 0.2, at (");
  refused(low + "--upper high.off --upper-plane 0,0,1.5,0,0,1 ", 4, "at most 120");
  refused("--lower low.off " + high, 4, "no holes");
  refused("--lower low.off,low.off --lower-plane 0,0,0,0,0,1 " + high, 4, "cross or touch");
  refused(low + high + "--place-upper '1 0 0 5 0 1 0 0 0 0 1 0' ", 4, "does not lead from");
}

TEST_F(Cli_fuse, refuses_a_section_that_is_not_closed) {
  // All faces at a vertex just below the plane: a hole that is not flat.
  Blend_mesh mesh = read_mesh(path("low.off"));
  const Vertex centre = *std::find_if(mesh.vertices().begin(), mesh.vertices().end(),
                                      [&](Vertex v) { return mesh.point(v).z() == -0.25; });
  CGAL::Euler::remove_face(CGAL::Euler::remove_center_vertex(mesh.halfedge(centre), mesh), mesh);
  mesh.collect_garbage();
  write_mesh(path("torn.off"), mesh);
  refused("--lower torn.off --lower-plane 0,0,0,0,0,1 " + high, 4, "where it is open");
  refused("--lower torn.off --lower-plane 0,0,0.3,0,0,1 " + high, 3, "has a hole");
  refused("--lower torn.off " + high, 4, "do not lie in one plane");
}

TEST_F(Cli_fuse, refuses_bad_options) {
  for (const std::string bad : {"--rho 0", "--rho -1", "--rho nan", "--rho x", "--rho 1 --implicit sdf",
                                "--implicit cubes", "--eta 0.4", "--eta 0.4,1.2", "--eta nan,0.5", "--weight 0,1",
                                "--weight 1", "--step 0", "--edge 0", "--edge inf", "--grading 0.5", "--least-angle 31",
                                "--least-angle -1", "--place-upper '1 2 3'", "--place-upper '1 0 0 0 1 0 0 0 0 0 1 0'"})
    refused(low + high + bad, 2, "");
  refused("--lower low.off --lower-plane 0,0,0,0,0 " + high, 2, "6 numbers");
  refused("--lower low.off --lower-plane 0,0,nan,0,0,1 " + high, 2, "not a number");
  refused("--lower low.off --lower-plane 0,0,0,0,0,0 " + high, 2, "length");
  refused("--lower low.off --lower-plane 0,0,0,0,0,1 ", 2, "--upper");
  refused("--lower none.off " + high, 3, "none.off");
  refused(low + high + "--labels out.off", 2, "would replace");
  EXPECT_EQ(run("fuse " + low + high + "--labels r.json --report r.json -o out.off").exit, 2);
  EXPECT_EQ(json("r.json")["status"], "invalid_parameter") << "the report is there, and no labels over it";
  refused(low + high + "--edge 1e-7", 2, "at least");
}

}  // namespace
