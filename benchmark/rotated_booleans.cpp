// SPDX-License-Identifier: GPL-3.0-or-later
// Booleans of bodies whose faces are coplanar but for rounding: how many are valid, refused, invalid.
// Usage: cgal_blend_rotated_booleans [PAIRS_PER_FAMILY [FIRST_SEED [RADIUS [DISTANCE [FAMILY]]]]]; exit status 1 if any result is invalid.
#include "flush_pairs.h"

#include <cgal_blend/validate.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

namespace cgal_blend::test {
namespace {

struct Tally {
  int trials = 0, valid = 0, refused = 0, invalid = 0;
  int no_body = 0;  // rightly refused: the result is empty or touches itself along edges
  double milliseconds = 0;
};

constexpr const char* operation_name(Boolean_operation operation) {
  return operation == Boolean_operation::union_         ? "union"
         : operation == Boolean_operation::intersection ? "intersection"
                                                        : "difference";
}

/// Runs one boolean; prints a line unless it is valid.
void run(const Flush_family& family, std::uint32_t seed, Boolean_operation operation, double radius, double distance,
         Tally& tally) {
  Dice dice(seed);
  const Flush_pair pair = moved_pair(family.draw(dice), dice, distance);
  Fillet_options options;
  options.radius = radius;
  Blend_mesh out;
  const auto start = std::chrono::steady_clock::now();
  const Fillet_outcome outcome = unchecked::corefine_and_fillet(pair.a, pair.b, operation, out, options);
  tally.milliseconds += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  ++tally.trials;
  const double expected = volume_of(pair, operation), scale = pair.volume_a + pair.volume_b;
  const bool empty = expected < 1e-12 * scale;
  std::string problem;
  if (outcome.ok()) {
    const Validity_report report = validate(out);
    const double error = std::abs(report.volume - expected) / scale;
    const std::size_t kept = outcome.kept_faces;
    if (!report.ok())
      problem = "INVALID " + message(report.diagnosis);
    else if (radius == 0 && (empty || error > 1e-9))
      problem = "INVALID volume " + std::to_string(report.volume) + " for " + std::to_string(expected);
    else if (kept > report.faces)
      problem = "INVALID kept";
    problem.empty() ? ++tally.valid : ++tally.invalid;
  } else if ((empty && outcome.diagnosis.status == Status::empty_result) ||
             (pair.difference_touches_itself && operation == Boolean_operation::difference)) {
    ++tally.no_body;
  } else {
    ++tally.refused;
    problem = std::string("refused ") + name(outcome.diagnosis.status) + " " + outcome.diagnosis.detail;
  }
  if (!problem.empty())
    std::printf("  seed %u %s: %s\n", static_cast<unsigned>(seed), operation_name(operation), problem.c_str());
}

void print(const char* name, const Tally& tally) {
  std::printf("%-40s %5d trials  valid %5d  no body %5d  refused %5d  invalid %5d  %7.1f ms each\n", name, tally.trials,
              tally.valid, tally.no_body, tally.refused, tally.invalid, tally.milliseconds / tally.trials);
}

}  // namespace
}  // namespace cgal_blend::test

int main(int argc, char** argv) {
  using namespace cgal_blend;
  const int pairs = argc > 1 ? std::atoi(argv[1]) : 10;
  const auto first = static_cast<std::uint32_t>(argc > 2 ? std::atoi(argv[2]) : 1);
  const double radius = argc > 3 ? std::atof(argv[3]) : 0;
  const double distance = argc > 4 ? std::atof(argv[4]) : 3;
  test::Tally total;
  for (const test::Flush_family& family : test::flush_families()) {
    if (argc > 5 && std::string(family.name).find(argv[5]) == std::string::npos) continue;
    test::Tally tally;
    for (int i = 0; i < pairs; ++i)
      for (const auto operation :
           {Boolean_operation::union_, Boolean_operation::intersection, Boolean_operation::difference})
        test::run(family, first + static_cast<std::uint32_t>(i), operation, radius, distance, tally);
    test::print(family.name, tally);
    total.trials += tally.trials;
    total.valid += tally.valid;
    total.no_body += tally.no_body;
    total.refused += tally.refused;
    total.invalid += tally.invalid;
    total.milliseconds += tally.milliseconds;
  }
  test::print("all", total);
  return total.invalid > 0 ? 1 : 0;
}
