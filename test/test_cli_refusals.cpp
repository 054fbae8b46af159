// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_runner.h"

#include "shapes.h"

#include <cgal_blend/mesh_io.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;

const std::string eight_corners = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n";
const std::string ten_faces = "3 0 2 3\n3 0 3 1\n3 4 5 7\n3 4 7 6\n3 0 1 5\n3 0 5 4\n3 2 6 7\n3 2 7 3\n3 0 4 6\n3 0 6 2\n";
const std::string last_two = "3 1 3 7\n3 1 7 5\n";

/// A command that must end with an exit status, one line with a word in it, and nothing written.
struct Refusal {
  const char* name;
  std::string arguments;  ///< "OUT" stands for the output
  int exit;
  std::string word;    ///< part of the line on standard error
  std::string status;  ///< in the report; empty: no report is written (usage found while parsing)
};

void PrintTo(const Refusal& refusal, std::ostream* out) { *out << refusal.name; }

class Cli_refusals : public Cli_runner, public testing::WithParamInterface<Refusal> {
 protected:
  void SetUp() override {
    Cli_runner::SetUp();
    write_bad_files();
    write_mesh(path("box.off"), box({0, 0, 0}, {1, 1, 1}));
    write_mesh(path("box.ply"), box({0, 0, 0}, {1, 1, 1}));
    write_mesh(path("far.off"), box({5, 5, 5}, {6, 6, 6}));
    write_mesh(path("corner.off"), box({1, 1, 1}, {2, 2, 2}));
    write_mesh(path("flush.off"), box({0.5, 0, 0.25}, {2, 0.5, 0.75}));  // lies in the same plane y = 0
    write_mesh(path("spike.off"), cone(1, 2, 16));
    write_mesh(path("above_spike.off"), box({-1, -2, 2}, {1.5, 1, 4}));
    write_mesh(path("overlap.off"), box({0.5, 0.5, 0.5}, {2, 2, 2}));
    write_mesh(path("plate.off"), plate(50, 10));
    write_mesh(path("boss.off"), cylinder(15, 32, -5, 40));
    write_mesh(path("cylinder.off"), cylinder(10, 32, 0, 20));
    write("malformed.json", "{");
    write("no_list.json", "{}");
    write("none.json", R"({"blends": []})");
    write("no_edge.json", R"({"blends": [{"polyline": [0, 1, 6], "radius": 0.1}]})");
    write("no_vertex.json", R"({"blends": [{"polyline": [0, 99], "radius": 0.1}]})");
    write("no_point.json", R"({"blends": [{"polyline": [[0, 0, 0], [7, 7, 7]], "radius": 0.1}]})");
    write("bad_radius.json", R"({"blends": [{"polyline": [0, 1], "radius": -1}]})");
    write("text_radius.json", R"({"blends": [{"polyline": [0, 1], "radius": "wide"}]})");
    write("no_radius.json", R"({"blends": [{"polyline": [0, 1]}]})");
    write("list_radius.json", R"({"blends": [{"polyline": [0, 1], "radius": [[0, 1], [1, 2]]}]})");
    write("closed_radius.json", R"({"blends": [{"polyline": [0, 1, 3, 2, 0], "radius": [[0, 1], [1, 2]]}]})");
    write("falling_radius.json", R"({"blends": [{"polyline": [0, 1], "radius": [[0.5, 1], [0.5, 2]]}]})");
    write("far_radius.json", R"({"blends": [{"polyline": [0, 1], "radius": [[0, 1], [50, 2]]}]})");
    write("zero_radius.json", R"({"blends": [{"polyline": [0, 1], "radius": [[0, 1], [1, 0]]}]})");
    write("from_text.json", R"({"blends": [{"polyline": [0, 1], "radius": 0.1, "from": "start"}]})");
    write("to_null.json", R"({"blends": [{"polyline": [0, 1], "radius": 0.1, "to": null}]})");
    write("to_far.json", R"({"blends": [{"polyline": [0, 1], "radius": 0.1, "to": 1.5}]})");
    write("from_behind.json", R"({"blends": [{"polyline": [0, 1], "radius": 0.1, "from": 0.7, "to": 0.2}]})");
    write("one_radius.json", R"({"blends": [{"polyline": [0, 1], "radius": [[0, 1]]}]})");
    write("empty_radius.json", R"({"blends": [{"polyline": [0, 1], "radius": []}]})");
    write("bare_radius.json", R"({"blends": [{"polyline": [0, 1], "radius": [1, 2]}]})");
    write("text_in_radius.json", R"({"blends": [{"polyline": [0, 1], "radius": [[0, 1], [1, "wide"]]}]})");
    write("open.json", R"({"blends": [{"polyline": [0, 1], "radius": 0.1}]})");
    write_mesh(path("spiked.off"), box_with_folded_spike());
    write("spike_foot.json", R"({"blends": [{"polyline": [[1, 1, 4], [2, 1, 4]]}]})");
    write("bad.selection.txt", "\n\n0 1 2\n");
    write("no_edge.selection.txt", "\n\n0 1 0 7\n");
    write("protected.off", "a file of the user\n");
    std::filesystem::permissions(path("protected.off"), std::filesystem::perms::owner_read);
    std::filesystem::create_directory(path("folder.off"));
  }

 private:
  void write_bad_files() {
    write("truncated.off", "OFF\n8 12 0\n" + eight_corners + ten_faces);
    write("zero_bytes.off", "");
    write("no_faces.off", "OFF\n0 0 0\n");
    write("nan.off", "OFF\n8 12 0\nnan" + eight_corners.substr(1) + ten_faces + last_two);
    write("text.off", "OFF\n8 12 0\nhello" + eight_corners.substr(1) + ten_faces + last_two);
    write("index.off", "OFF\n8 12 0\n" + eight_corners + ten_faces + "3 1 3 7\n3 1 7 8\n");
    write("open.off", "OFF\n8 10 0\n" + eight_corners + ten_faces);
    write("flipped_face.off", "OFF\n8 12 0\n" + eight_corners + ten_faces + "3 1 3 7\n3 1 5 7\n");
    write("fin.off", "OFF\n9 13 0\n" + eight_corners + "2 0 0.5\n" + ten_faces + last_two + "3 1 5 8\n");
    write("needle.off", "OFF\n9 14 0\n" + eight_corners + "0.5 0.5 0\n" + "3 0 2 8\n3 2 3 8\n" + ten_faces.substr(8) + last_two +
                            "3 0 8 3\n");  // (0.5, 0.5, 0) lies on the diagonal from 0 to 3
    write_mesh(path("inside_out.off"), inside_out(box({0, 0, 0}, {1, 1, 1})));
    write_mesh(path("crossing.off"), side_by_side(box({0, 0, 0}, {1, 1, 1}), box({0.5, 0.5, 0.5}, {2, 2, 2})));
  }
};

TEST_P(Cli_refusals, NamedInOneLineAndNothingWritten) {
  const Refusal& refusal = GetParam();
  std::string arguments = refusal.arguments;
  const std::string existing = "what was there before\n";
  write("existing.off", existing);
  if (const auto at = arguments.find("OUT"); at != std::string::npos) arguments.replace(at, 3, "existing.off");
  const auto before = files();
  const Run r = run(arguments + (refusal.status.empty() ? "" : " --report ../report.json"));
  EXPECT_EQ(r.exit, refusal.exit) << r.err;
  EXPECT_EQ(r.out, "");
  EXPECT_EQ(r.err.rfind("cgal-blend: ", 0), 0u) << r.err;
  EXPECT_EQ(std::count(r.err.begin(), r.err.end(), '\n'), 1) << r.err;
  EXPECT_NE(r.err.find(refusal.word), std::string::npos) << r.err;
  EXPECT_EQ(changed_since(before), "") << "nothing written, existing files untouched";
  if (refusal.status.empty()) return;
  const Json report = json("../report.json");
  if (refusal.status != "*") {
    EXPECT_EQ(report["status"], refusal.status);
  }
  EXPECT_TRUE(report["output"].is_null());
  EXPECT_EQ("cgal-blend: " + report["message"].get<std::string>() + "\n", r.err);
}

std::string name_of(const testing::TestParamInfo<Refusal>& info) { return info.param.name; }

const std::string box_fillet = "fillet box.off --sharp-angle 40 -o OUT ";

INSTANTIATE_TEST_SUITE_P(Usage, Cli_refusals, testing::ValuesIn(std::vector<Refusal>{
  {"Nothing", "", 2, "subcommand", ""},
  {"UnknownSubcommand", "merge box.off -o OUT", 2, "'merge'", ""},
  {"UnknownOption", box_fillet + "--radius 1 --bogus", 2, "--bogus", ""},
  {"NoOutput", "union box.off overlap.off", 2, "output", ""},
  {"NoSecondBody", "union box.off -o OUT", 2, "B", ""},
  {"NoRadius", box_fillet, 2, "--radius", "invalid_parameter"},
  {"RadiusWithoutValue", box_fillet + "--radius", 2, "--radius needs a value", ""},
  {"RadiusZero", box_fillet + "--radius 0", 2, "greater than 0", "invalid_parameter"},
  {"RadiusNegative", box_fillet + "--radius -1", 2, "greater than 0", "invalid_parameter"},
  {"RadiusNan", box_fillet + "--radius nan", 2, "'nan' is not a number", "invalid_parameter"},
  {"RadiusInfinite", box_fillet + "--radius inf", 2, "'inf' is not a number", "invalid_parameter"},
  {"RadiusText", box_fillet + "--radius wide", 2, "'wide' is not a number", "invalid_parameter"},
  {"RadiusWithUnit", box_fillet + "--radius 1mm", 2, "'1mm' is not a number", "invalid_parameter"},
  {"RadiusEmpty", box_fillet + "--radius ''", 2, "'' is not a number", "invalid_parameter"},
  {"RadiusOfABoolean", "union box.off overlap.off -o OUT --radius 0", 2, "greater than 0", "invalid_parameter"},
  {"UnknownProfile", box_fillet + "--radius 1 --profile round", 2, "'round'", "invalid_parameter"},
  {"ConicWithoutWeight", box_fillet + "--radius 1 --profile conic:-1", 2, "conic:W0", "invalid_parameter"},
  {"SplineThatEndsElsewhere", box_fillet + "--radius 1 --profile 'bspline:0,0;1,0'", 2, "from 0,0 to 1,1", "invalid_parameter"},
  {"CoarseStitching", "union plate.off boss.off -o OUT --radius 1 --mode stitch --coarse 100", 2, "--coarse", "invalid_parameter"},
  {"ChordRatio", box_fillet + "--radius 1 --chord-ratio 2", 2, "--chord-ratio", ""},
  {"CoarseOfUnknownMode", box_fillet + "--radius 1 --mode stitsch --coarse 100", 2, "'stitsch'", "invalid_parameter"},
  {"HalfAFace", box_fillet + "--radius 1 --coarse 0.5", 2, "whole number", ""},
  {"EndlessProfile", "union plate.off boss.off -o OUT --radius 1 --profile hermite:1e308,1e308", 2, "profile", "invalid_parameter"},
  {"PropagateMaybe", box_fillet + "--radius 0.1 --propagate maybe", 2, "'maybe' is neither on nor off", ""},
  {"PropagateABoolean", "union box.off overlap.off -o OUT --radius 0.1 --propagate on", 2, "--propagate", ""},
  {"FlawsOfABoolean", "union crossing.off box.off -o OUT --accept-flaws", 2, "--accept-flaws", ""},
  {"UnknownMode", box_fillet + "--radius 1 --mode weave", 2, "'weave'", "invalid_parameter"},
  {"NoEdgesNamed", "fillet box.off -o OUT --radius 1", 2, "exactly one", "invalid_parameter"},
  {"EdgesNamedTwice", box_fillet + "--radius 1 --edges x.txt", 2, "exactly one", "invalid_parameter"},
  {"SharpAngleTooLarge", "fillet box.off -o OUT --radius 1 --sharp-angle 180", 2, "between", ""},
  {"SharpAngleText", "fillet box.off -o OUT --radius 1 --sharp-angle x", 2, "not a number", ""},
  {"ChordToleranceZero", box_fillet + "--radius 1 --chord-tolerance 0", 2, "--chord-tolerance", ""},
  {"TransformTooShort", "union box.off overlap.off -o OUT --transform-b '1 0 0'", 2, "12 numbers", "invalid_parameter"},
  {"TransformNan", "union box.off box.off -o OUT --transform-b '1 0 0 nan 0 1 0 0 0 0 1 0'", 2, "'nan'", "invalid_parameter"},
  {"TransformFlat", "union box.off box.off -o OUT --transform-b '1 0 0 0 0 1 0 0 1 1 0 0'", 2, "flat", "invalid_parameter"},
  {"LimitZero", "curvature box.off -o c.ply --limit 0", 2, "--limit", "invalid_parameter"},
  {"LimitText", "curvature box.off -o c.ply --limit wide", 2, "'wide'", "invalid_parameter"},
  {"TransformOfNoBody", "union box.off overlap.off -o OUT --transform-c '1 0 0 0 0 1 0 0 0 0 1 0'", 2, "--transform-c", "invalid_parameter"},
  {"TransformCTooShort", "union box.off overlap.off far.off -o OUT --transform-c '1 0'", 2, "--transform-c: 12", "invalid_parameter"},
  {"RadiiTooMany", "union box.off overlap.off -o OUT --radius 0.1,0.1", 2, "2 radii for 1 boolean", "invalid_parameter"},
  {"RadiiTooFew", "union box.off overlap.off far.off far.off -o OUT --radius 1,1", 2, "2 radii for 3 booleans", "invalid_parameter"},
  {"RadiiWithAZero", "union box.off overlap.off far.off -o OUT --radius 1,0", 2, "greater than 0", "invalid_parameter"},
  {"RadiiWithAGap", "union box.off overlap.off far.off -o OUT --radius 1,", 2, "'' is not a number", "invalid_parameter"},
  {"RadiiOfAFillet", box_fillet + "--radius 1,2", 2, "'1,2' is not a number", "invalid_parameter"},
  {"LawOfOnePair", box_fillet + "--radius 0:1", 2, "two pairs", "invalid_parameter"},
  {"LawThatDoesNotAscend", box_fillet + "--radius 0:1,0.6:2,0.5:1", 2, "must ascend", "invalid_parameter"},
  {"LawWithAFractionTwice", box_fillet + "--radius 0:1,0.5:2,0.5:1", 2, "must ascend", "invalid_parameter"},
  {"LawInPercent", box_fillet + "--radius 0:1,50:2,100:1", 2, "between 0 and 1", "invalid_parameter"},
  {"LawBeforeTheStart", box_fillet + "--radius -0.1:1,1:2", 2, "between 0 and 1", "invalid_parameter"},
  {"LawWithAZero", box_fillet + "--radius 0:1,1:0", 2, "greater than 0", "invalid_parameter"},
  {"LawWithText", box_fillet + "--radius 0:1,1:wide", 2, "'wide' is not a number", "invalid_parameter"},
  {"LawWithNan", box_fillet + "--radius nan:1,1:2", 2, "'nan' is not a number", "invalid_parameter"},
  {"LawWithANumber", box_fillet + "--radius 0:1,2", 2, "'2' is no pair", "invalid_parameter"},
  {"LawOfTriples", box_fillet + "--radius 0:1:2,1:1:2", 2, "'0:1:2' is no pair", "invalid_parameter"},
  {"LawWithAGap", box_fillet + "--radius 0:1,1:2,", 2, "'' is no pair", "invalid_parameter"},
  {"LawOfABoolean", "union box.off overlap.off far.off -o OUT --radius 1:2,0:3", 2, "must ascend", "invalid_parameter"},
  {"LawThatDoesNotClose", "union plate.off boss.off -o OUT --radius 0:2,1:3", 2, "end as it begins", "invalid_parameter"},
  {"BlendsLawThatDoesNotClose", "fillet box.off -o OUT --blends closed_radius.json", 2, "end as it begins", "invalid_parameter"},
  {"BlendsLawThatDoesNotAscend", "fillet box.off -o OUT --blends falling_radius.json", 2, "blend 1: the fractions", "invalid_parameter"},
  {"BlendsLawInPercent", "fillet box.off -o OUT --blends far_radius.json", 2, "between 0 and 1", "invalid_parameter"},
  {"BlendsLawWithAZero", "fillet box.off -o OUT --blends zero_radius.json", 2, "greater than 0", "invalid_parameter"},
  {"BlendsLawOfOnePair", "fillet box.off -o OUT --blends one_radius.json", 2, "two pairs", "invalid_parameter"},
  {"BlendsLawOfNoPair", "fillet box.off -o OUT --blends empty_radius.json", 2, "two pairs", "invalid_parameter"},
  {"BlendsLawOfNumbers", "fillet box.off -o OUT --blends bare_radius.json", 2, "1 in 'radius' is no pair", "invalid_parameter"},
  {"BlendsLawWithText", "fillet box.off -o OUT --blends text_in_radius.json", 2, "is no pair", "invalid_parameter"},
  {"TooManyBodies", "union box.off box.off box.off box.off box.off box.off box.off box.off ninth.off -o OUT", 2, "at most 8 bodies", "invalid_parameter"},
  {"BlendsRadius", "fillet box.off -o OUT --blends bad_radius.json", 2, "greater than 0", "invalid_parameter"},
  {"BlendsRadiusText", "fillet box.off -o OUT --blends text_radius.json", 2, "not a number", "invalid_parameter"},
  {"BlendsWithoutRadius", "fillet box.off -o OUT --blends no_radius.json", 2, "--radius", "invalid_parameter"}}), name_of);

INSTANTIATE_TEST_SUITE_P(Output, Cli_refusals, testing::ValuesIn(std::vector<Refusal>{
  {"FromNan", box_fillet + "--radius 0.1 --from nan", 2, "--from", ""},
  {"FromText", box_fillet + "--radius 0.1 --from half", 2, "--from", ""},
  {"ToTooFar", box_fillet + "--radius 0.1 --to 1.01", 2, "--to", ""},
  {"FromIsTo", box_fillet + "--radius 0.1 --from 0.5 --to 0.5", 2, "between 0 and 1", "invalid_parameter"},
  {"FromBehindTo", box_fillet + "--radius 0.1 --from 0.6 --to 0.5", 2, "begin before it ends", "invalid_parameter"},
  {"FromTextInFile", "fillet box.off -o OUT --blends from_text.json", 2, "'from'", "invalid_parameter"},
  {"ToNullInFile", "fillet box.off -o OUT --blends to_null.json", 2, "'to'", "invalid_parameter"},
  {"ToTooFarInFile", "fillet box.off -o OUT --blends to_far.json", 2, "'to'", "invalid_parameter"},
  {"FromBehindToInFile", "fillet box.off -o OUT --blends from_behind.json", 2, "begin before it ends", "invalid_parameter"},
  {"UnknownFormat", "union box.off overlap.off -o out.step", 2, "out.step", "invalid_parameter"},
  {"NoFolder", "union box.off overlap.off -o nowhere/out.off", 2, "does not exist", "invalid_parameter"},
  {"IsAFolder", "union box.off overlap.off -o folder.off", 2, "folder", "invalid_parameter"},
  {"Protected", "union box.off overlap.off -o protected.off", 2, "protected", "invalid_parameter"},
  {"KernelFolder", "union box.off overlap.off -o /proc/out.off", 2, "/proc/out.off", "*"},
  {"CurvatureFormat", "curvature box.off -o OUT", 2, ".ply", "invalid_parameter"},
  {"CurvatureFormatOfABlend", "union box.off overlap.off -o OUT --curvature c.off", 2, "c.off", "invalid_parameter"},
  {"CurvatureNoFolder", "union box.off overlap.off -o OUT --curvature nowhere/c.ply", 2, "does not exist", "invalid_parameter"},
  {"CurvatureOverOutput", "union box.off overlap.off -o c.ply --curvature ./c.ply", 2, "replace", "invalid_parameter"},
  {"CurvatureOverInput", "union box.ply overlap.off -o OUT --curvature box.ply", 2, "replace", "invalid_parameter"},
  {"ReportOverCurvature", "union box.off overlap.off -o OUT --curvature c.ply --report c.ply", 2, "replace", ""},
  {"ReportNoFolder", "union box.off overlap.off -o OUT --report nowhere/r.json", 2, "does not exist", ""},
  {"ReportOverInput", "union box.off overlap.off -o OUT --report box.off", 2, "box.off", ""},
  {"ReportOverOutput", "union box.off overlap.off -o OUT --report existing.off", 2, "existing.off", ""}}), name_of);

INSTANTIATE_TEST_SUITE_P(Input, Cli_refusals, testing::ValuesIn(std::vector<Refusal>{
  {"Missing", "union missing.off box.off -o OUT", 3, "missing.off", "input_unreadable"},
  {"MissingB", "union box.off missing.off -o OUT", 3, "missing.off", "input_unreadable"},
  {"UnknownFormat", "union box.off box.step -o OUT", 3, "box.step", "input_unreadable"},
  {"Truncated", "union truncated.off box.off -o OUT", 3, "truncated.off", "input_unreadable"},
  {"Text", "union text.off box.off -o OUT", 3, "text.off", "input_unreadable"},
  {"Index", "union index.off box.off -o OUT", 3, "index.off", "input_unreadable"},
  {"ZeroBytes", "union zero_bytes.off box.off -o OUT", 3, "zero_bytes.off", "input_empty"},
  {"NoFaces", "union no_faces.off box.off -o OUT", 3, "no_faces.off", "input_empty"},
  {"Nan", "union nan.off box.off -o OUT", 3, "vertex 0", "input_not_finite"},
  {"NotClosed", "union open.off box.off -o OUT", 3, "open.off", "input_not_closed"},
  {"NotClosedB", "union box.off open.off -o OUT", 3, "open.off", "input_not_closed"},
  {"NotClosedC", "union box.off overlap.off open.off -o OUT", 3, "open.off", "input_not_closed"},
  {"ReportOverThirdBody", "union box.off overlap.off far.off -o OUT --report far.off", 2, "far.off", ""},
  {"NotManifold", "union fin.off box.off -o OUT", 3, "vertices 1 and 5", "input_not_manifold"},
  {"FlippedFace", "union flipped_face.off box.off -o OUT", 3, "flipped_face.off", "input_misoriented"},
  {"InsideOut", "union inside_out.off box.off -o OUT", 3, "inside_out.off", "input_misoriented"},
  {"Needle", "union needle.off box.off -o OUT", 3, "needle.off", "input_degenerate"},
  {"SelfIntersecting", "union crossing.off box.off -o OUT", 3, "faces", "input_self_intersecting"},
  {"FilletToo", "fillet crossing.off --sharp-angle 40 --radius 0.1 -o OUT", 3, "faces", "input_self_intersecting"},
  {"FlawInTheWay", "fillet spiked.off --blends spike_foot.json --radius 0.1 --accept-flaws -o OUT", 3, "in the way of the blend",
   "input_self_intersecting"},
  {"NeedleInTheWay", "fillet needle.off --blends open.json --accept-flaws -o OUT", 3, "face 13, in the way", "input_degenerate"},
  {"NoFlawButOpen", "fillet open.off --sharp-angle 40 --radius 0.1 --accept-flaws -o OUT", 3, "open.off", "input_not_closed"},
  {"NoFlawButInsideOut", "fillet inside_out.off --sharp-angle 40 --radius 0.1 --accept-flaws -o OUT", 3, "inside_out.off",
   "input_misoriented"},
  {"NoFlawButNan", "fillet nan.off --sharp-angle 40 --radius 0.1 --accept-flaws -o OUT", 3, "vertex 0", "input_not_finite"},
  {"FlawsUnderACoarseLevel", "fillet crossing.off --blends open.json --coarse 8 --accept-flaws -o OUT", 3, "coarse level",
   "input_self_intersecting"},
  {"Overflow", "union box.off box.off -o OUT --transform-b '1e308 0 0 1e308 0 1e308 0 1e308 0 0 1e308 1e308'", 3, "finite",
   "input_not_finite"},
  {"CurvatureMissing", "curvature missing.off -o c.ply", 3, "missing.off", "input_unreadable"},
  {"CheckMissing", "check missing.off", 3, "missing.off", "input_unreadable"},
  {"CheckNotManifold", "check fin.off", 3, "fin.off", "input_not_manifold"},
  {"BlendsMissing", "fillet box.off -o OUT --blends missing.json", 3, "missing.json", "input_unreadable"},
  {"BlendsMalformed", "fillet box.off -o OUT --blends malformed.json", 3, "malformed.json", "input_unreadable"},
  {"BlendsNoList", "fillet box.off -o OUT --blends no_list.json", 3, "no_list.json", "input_unreadable"},
  {"SelectionMissing", "fillet box.off -o OUT --radius 1 --edges missing.txt", 3, "missing.txt", "input_unreadable"},
  {"SelectionMalformed", "fillet box.off -o OUT --radius 1 --edges bad.selection.txt", 3, "line 3", "input_unreadable"}}), name_of);

INSTANTIATE_TEST_SUITE_P(Blend, Cli_refusals, testing::ValuesIn(std::vector<Refusal>{
  {"RadiusListOfACoarseLevel", "union plate.off boss.off -o OUT --coarse 500 --radius 0:2,0.5:3", 4, "coarse level", "not_supported"},
  {"NoSharpEdge", "fillet box.off -o OUT --radius 1 --sharp-angle 91", 4, "No edge", "no_edges_selected"},
  {"NoBlends", "fillet box.off -o OUT --blends none.json", 4, "none.json", "no_edges_selected"},
  {"NoEdge", "fillet box.off -o OUT --blends no_edge.json", 4, "between places 1 and 2", "no_such_edge"},
  {"NoVertex", "fillet box.off -o OUT --blends no_vertex.json", 4, "vertex 99", "no_such_edge"},
  {"NoPoint", "fillet box.off -o OUT --blends no_point.json", 4, "(7, 7, 7)", "no_such_edge"},
  {"SelectionNoEdge", "fillet box.off -o OUT --radius 0.1 --edges no_edge.selection.txt", 4, "edge 0 7", "no_such_edge"},
  {"OpenBranchInMapMode", "fillet box.off -o OUT --blends open.json --mode map", 4, "map mode", "open_branch"},
  {"RadiusTooLargeForBox", box_fillet + "--radius 0.6", 4, "at (", "*"},
  {"RadiusTooLarge", "union plate.off boss.off -o OUT --radius 80", 4, "at (", "*"},
  {"RadiusTooLargeOnRim", "fillet cylinder.off --sharp-angle 40 -o OUT --radius 10.5", 4, "at (", "*"},
  {"LargestRadiusIsTold", "union plate.off boss.off -o OUT --radius 80", 4, "largest radius that works there", "*"},
  {"Disjoint", "union box.off far.off -o OUT --radius 0.1", 4, "do not meet", "operands_disjoint"},
  {"DisjointThirdBody", "union plate.off boss.off far.off -o OUT --radius 1 --transform-c '1 0 0 100 0 1 0 0 0 0 1 0'", 4, "part 2",
   "operands_disjoint"},
  {"TouchInAPoint", "union box.off corner.off -o OUT --radius 0.1", 4, "touch", "operands_touch"},
  {"TouchInAVertexSharp", "union box.off corner.off -o OUT", 4, "touch", "operands_touch"},
  {"TouchWithAnApex", "union spike.off above_spike.off -o OUT --radius 0.1", 4, "touch", "operands_touch"},
  {"Identical", "union box.off box.off -o OUT --radius 0.1", 4, "same", "operands_identical"}}), name_of);

/// `check` prints its report also for a bad mesh.
TEST_F(Cli_refusals, CheckNamesWhatIsBroken) {
  const Run r = run("check crossing.off --json");
  EXPECT_EQ(r.exit, 3);
  EXPECT_EQ(std::count(r.err.begin(), r.err.end(), '\n'), 1) << r.err;
  const Json report = Json::parse(r.out);
  EXPECT_EQ(report["status"], "input_self_intersecting");
  EXPECT_GT(report["output"]["self_intersections"].get<int>(), 0);
  const Run text = run("check open.off");
  EXPECT_EQ(text.exit, 3);
  EXPECT_NE(text.out.find("not valid"), std::string::npos);
}

}  // namespace
