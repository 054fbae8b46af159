// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_runner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace {

using namespace cgal_blend::test;

const std::string cylinder = "[1, 1, 0, 0, 0, 0, 0, 0, 0, -1]";
const std::string wide_cylinder = "[0, 1, 1, 0, 0, 0, 0, 0, 0, -4]";
const std::string saddle = "[0, 0, 0, 1, 0, 0, 0, 0, -1, 0]";

std::string pair(const std::string& a, const std::string& b,
                 const std::string& more = R"(, "samples": 50, "box": 100)") {
  return R"({"a": )" + a + R"(, "b": )" + b + more + "}";
}

class Cli_quadrics : public Cli_runner {
 protected:
  Json intersect(const std::string& input) {
    write("in.json", input);
    const Run r = run("intersect-quadrics in.json -o out.json --quiet");
    EXPECT_EQ(r.exit, 0) << r.err;
    EXPECT_EQ(r.out + r.err, "");
    return json("out.json");
  }
};

TEST_F(Cli_quadrics, write_curves_on_both_quadrics) {
  const Json result = intersect(pair(cylinder, wide_cylinder));
  EXPECT_EQ(result["status"], "ok");
  EXPECT_EQ(result["type"], "smooth quartic: two closed loops");
  EXPECT_EQ(result["segre"], "[1111]");
  EXPECT_TRUE(result["singular_points"].empty());
  ASSERT_EQ(result["components"].size(), 2u);
  for (const Json& component : result["components"]) {
    EXPECT_EQ(component["closed"], true);
    EXPECT_EQ(component["isolated"], false);
    EXPECT_EQ(component["degree"], 4);
    EXPECT_GE(component["points"].size(), 50u);
    for (const Json& p : component["points"]) {
      const double x = p[0], y = p[1], z = p[2];
      EXPECT_NEAR(x * x + y * y, 1, 1e-14);
      EXPECT_NEAR(y * y + z * z, 4, 1e-14);
    }
  }
}

TEST_F(Cli_quadrics, run_arcs_to_the_box) {
  const Json result = intersect(pair(saddle, cylinder, R"(, "samples": 5, "box": 0.5)"));
  EXPECT_EQ(result["components"].size(), 1u) << "a closed loop is kept whole";
  const Json hyperbola = intersect(pair(saddle, "[0, 0, 0, 0, 0, 0, 0, 0, 1, -1]", R"(, "samples": 5, "box": 7)"));
  ASSERT_EQ(hyperbola["components"].size(), 2u);
  for (const Json& component : hyperbola["components"]) {
    EXPECT_EQ(component["closed"], false);
    for (const Json& end : {component["points"].front(), component["points"].back()}) {
      const double x = std::abs(end[0].get<double>()), y = std::abs(end[1].get<double>());
      EXPECT_NEAR(std::max(x, y), 7, 1e-13);
      EXPECT_NEAR(std::min(x, y), 1.0 / 7, 1e-14);
    }
  }
}

TEST_F(Cli_quadrics, take_fractions_decimals_and_long_integers_exactly) {
  // Twice: radii that are equal, then not by one part in 10^30.
  const std::string equal = R"([0, "1/3", "+2/6", 0, 0, 0, 0, 0, 0, "-1/3"])";
  EXPECT_EQ(intersect(pair(cylinder, equal))["segre"], "[(11)11]");
  const std::string nearly =
      "[0, 1000000000000000000000000000000, 1000000000000000000000000000000, 0, 0, 0, 0, 0, 0, "
      "-1000000000000000000000000000001]";
  EXPECT_EQ(intersect(pair(cylinder, nearly))["segre"], "[1111]");
  // As doubles 0.1 + 0.2 and 0.3 differ.
  const std::string tenths = "[0.1, 0.1, 0, 0, 0, 0, 0, 0, 0, -0.3]",
                    shifted = "[0, 0.1, 0.1, 0, 0, 0, 0, 0, 0, -0.30000000000000004]";
  EXPECT_EQ(intersect(pair(tenths, shifted))["segre"], "[1111]");
}

TEST_F(Cli_quadrics, say_empty_and_surface) {
  const Json empty = intersect(pair(cylinder, "[1, 1, 0, 0, 0, 0, 0, 0, 0, -2]"));
  EXPECT_EQ(empty["status"], "empty");
  EXPECT_TRUE(empty["components"].empty());
  EXPECT_EQ(intersect(pair(cylinder, "[2, 2, 0, 0, 0, 0, 0, 0, 0, -2]"))["status"], "surface");
}

TEST_F(Cli_quadrics, write_an_isolated_point_as_one_point) {
  const Json result = intersect(pair("[1, 1, 1, 0, 0, 0, 0, 0, 0, -1]", "[1, 1, 1, 0, 0, 0, -4, 0, 0, 3]"));
  ASSERT_EQ(result["components"].size(), 1u);
  EXPECT_EQ(result["components"][0]["isolated"], true);
  EXPECT_EQ(result["components"][0]["closed"], false);
  EXPECT_EQ(result["components"][0]["points"], Json::parse("[[1.0, 0.0, 0.0]]"));
  EXPECT_EQ(result["singular_points"].size(), 1u);
}

TEST_F(Cli_quadrics, have_defaults_and_a_report_and_the_same_bytes_again) {
  write("in.json", pair(cylinder, wide_cylinder, ""));
  const Run r = run("intersect-quadrics in.json -o out.json --report report.json");
  EXPECT_EQ(r.exit, 0) << r.err;
  EXPECT_NE(r.out.find("smooth quartic: two closed loops"), std::string::npos);
  EXPECT_EQ(json("report.json")["status"], "ok");
  EXPECT_EQ(json("report.json")["output"]["components"], 2);
  const std::string first = bytes("out.json");
  EXPECT_EQ(run("intersect-quadrics in.json -o out.json --quiet").exit, 0);
  EXPECT_EQ(bytes("out.json"), first);
}

struct Refused {
  const char* name;
  std::string input;
  const char* word;  ///< part of the line on standard error
};

void PrintTo(const Refused& refused, std::ostream* out) { *out << refused.name; }

class Cli_quadrics_refusals : public Cli_quadrics, public testing::WithParamInterface<Refused> {};

TEST_P(Cli_quadrics_refusals, NamedInOneLineAndNothingWritten) {
  write("in.json", GetParam().input);
  write("out.json", "what was there before\n");
  const auto before = files();
  const Run r = run("intersect-quadrics in.json -o out.json");
  EXPECT_EQ(r.exit, 3) << r.err;
  EXPECT_EQ(r.out, "");
  EXPECT_EQ(r.err.rfind("cgal-blend: ", 0), 0u) << r.err;
  EXPECT_EQ(std::count(r.err.begin(), r.err.end(), '\n'), 1) << r.err;
  EXPECT_NE(r.err.find(GetParam().word), std::string::npos) << r.err;
  EXPECT_EQ(changed_since(before), "");
}

INSTANTIATE_TEST_SUITE_P(
    Input, Cli_quadrics_refusals,
    testing::ValuesIn(std::vector<Refused>{
        {"Nothing", "", "not JSON"},
        {"HalfAnObject", R"({"a": [1, 2)", "not JSON"},
        {"Two", pair(cylinder, cylinder) + "{}", "not JSON"},
        {"Nan", pair(cylinder, "[NaN, 1, 0, 0, 0, 0, 0, 0, 0, -1]"), "not JSON"},
        {"TooLarge", pair(cylinder, "[1e999, 1, 0, 0, 0, 0, 0, 0, 0, -1]"), "not JSON"},
        {"List", "[1, 2]", "object"},
        {"NoB", R"({"a": )" + cylinder + "}", "'b'"},
        {"NineCoefficients", pair(cylinder, "[1, 1, 0, 0, 0, 0, 0, 0, -1]"), "10 coefficients"},
        {"ElevenCoefficients", pair(cylinder, "[1, 1, 0, 0, 0, 0, 0, 0, 0, -1, 0]"), "10 coefficients"},
        {"NoList", pair(cylinder, "7"), "10 coefficients"},
        {"Zero", pair("[0, 0, 0, 0, 0, 0, 0, 0, 0, 0]", cylinder), "all coefficients are 0"},
        {"ZeroInManyWays", pair(R"([0, 0.0, -0.0, "0", "0/7", "-0", 0, 0, 0, 0])", cylinder), "all coefficients are 0"},
        {"Word", pair(R"(["one", 1, 0, 0, 0, 0, 0, 0, 0, -1])", cylinder), "one"},
        {"Infinity", pair(R"(["inf", 1, 0, 0, 0, 0, 0, 0, 0, -1])", cylinder), "inf"},
        {"NoDenominator", pair(R"(["1/", 1, 0, 0, 0, 0, 0, 0, 0, -1])", cylinder), "1/"},
        {"ZeroDenominator", pair(R"(["1/0", 1, 0, 0, 0, 0, 0, 0, 0, -1])", cylinder), "denominator 0"},
        {"Null", pair("[null, 1, 0, 0, 0, 0, 0, 0, 0, -1]", cylinder), "null"},
        {"True", pair("[true, 1, 0, 0, 0, 0, 0, 0, 0, -1]", cylinder), "true"},
        {"BoxZero", pair(cylinder, wide_cylinder, R"(, "box": 0)"), "'box'"},
        {"BoxNegative", pair(cylinder, wide_cylinder, R"(, "box": -3)"), "'box'"},
        {"BoxWord", pair(cylinder, wide_cylinder, R"(, "box": "large")"), "'box'"},
        {"SamplesZero", pair(cylinder, wide_cylinder, R"(, "samples": 0)"), "'samples'"},
        {"SamplesHalf", pair(cylinder, wide_cylinder, R"(, "samples": 2.5)"), "'samples'"},
        {"SamplesNegative", pair(cylinder, wide_cylinder, R"(, "samples": -1)"), "'samples'"},
    }),
    [](const auto& info) { return std::string(info.param.name); });

TEST_F(Cli_quadrics, refuse_wrong_usage) {
  write("in.json", pair(cylinder, wide_cylinder));
  const auto before = files();
  for (const char* arguments :
       {"", "in.json", "in.json -o no_folder/out.json", "in.json -o in.json", "in.json -o out.json --bogus",
        "in.json -o out.json --report in.json", "in.json -o out.json --report out.json"})
    EXPECT_EQ(run(std::string("intersect-quadrics ") + arguments).exit, 2) << arguments;
  EXPECT_EQ(run("intersect-quadrics absent.json -o out.json").exit, 3);
  EXPECT_EQ(changed_since(before), "");
}

}  // namespace
