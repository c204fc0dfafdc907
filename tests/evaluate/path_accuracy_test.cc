// The figures of a paper on path accuracy from one machine, contour control off and on.  Expected
// numbers were computed outside g31, by the midpoint rule and by a solver with variable steps.

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/run_evaluate.h"

namespace g31::path_accuracy_test {
namespace {

using evaluate::OptionId;
using testing::EvaluateOutput;
using testing::run_evaluate;
using testing::TemporaryFolder;

const std::string kLibrary = "parts/library/path_accuracy/";

struct Recorded {
  std::string program;
  std::string feed;
  bool contour_control = false;
};

std::string traced(const TemporaryFolder& folder, const Recorded& run,
                   const std::string& overlay = "") {
  const bool is_fanuc = run.program.ends_with(".nc");
  cli::RunOptions options;
  options.programs = {kLibrary + run.program};
  options.setups = {kLibrary + "machine.toml"};
  if (!overlay.empty()) {
    options.setups.push_back(kLibrary + overlay);
  }
  if (!run.feed.empty()) {
    options.assignments = {
        (is_fanuc ? "#500=" : "R1=") + run.feed,
        std::string(is_fanuc ? "#501=" : "R2=") + (run.contour_control ? "1" : "0")};
  }
  options.trace = folder.path("trace.csv");
  options.trace_period = "0.5ms";
  EXPECT_EQ(testing::run_program(options).exit_code, 0);
  return options.trace;
}

EvaluateOutput evaluated(const std::string& kind, const std::string& file) {
  cli::EvaluateOptions options;
  options.kind = kind;
  options.file = file;
  if (kind == "square") {
    options.given[OptionId::Side] = "100";
    options.given[OptionId::Centre] = "0,0";
  } else if (kind == "circle") {
    options.given[OptionId::Radius] = "50";
    options.given[OptionId::Centre] = "0,0";
  } else if (kind == "diagonal") {
    options.given[OptionId::Target] = "50,50";
  }
  return run_evaluate(options);
}

struct Corners {
  Recorded run;
  double missed_um;
  double within_um;  ///< a unit of the last digit that was computed, and what lies between samples
  double slowest_mm_min;
};

/// @returns how wide a dip of the speed is, s
double check_corners(const Corners& expected) {
  const TemporaryFolder folder;
  const std::string file = traced(folder, expected.run);
  const EvaluateOutput square = evaluated("square", file);
  for (int corner = 1; corner <= 4; ++corner) {
    EXPECT_NEAR(square.value("corner_error_" + std::to_string(corner)), -expected.missed_um,
                expected.within_um)
        << corner;
  }
  const EvaluateOutput speed = evaluated("speed", file);
  const auto& dips = speed.document.at("results").at("dips");
  EXPECT_EQ(dips.size(), 4U);
  for (const auto& dip : dips) {
    // Half a unit of the last digit that was computed; where the speed is lowest for no time, what
    // it is above that within half a millisecond comes on top.
    EXPECT_NEAR(dip.at("speed").get<double>(), expected.slowest_mm_min,
                expected.slowest_mm_min > 100.0 ? 0.5 : 0.15);
  }
  return dips.at(0).at("width");
}

TEST(PathAccuracy, CornersAreMissedWithoutContourControlAndSlowedDownWithIt) {
  const double at_3 = check_corners({{"square.nc", "3000", false}, 931.0, 0.1, 2101.0});
  const double at_1 = check_corners({{"square.nc", "1000", false}, 305.2, 0.1, 673.0});
  EXPECT_NEAR(at_3 / at_1, 1.0, 0.05) << "as long, so three times as wide in way";
  const double on_at_3 = check_corners({{"square.nc", "3000", true}, 15.20, 0.01, 10.6});
  const double on_at_1 = check_corners({{"square.nc", "1000", true}, 15.03, 0.01, 10.4});
  EXPECT_GT(on_at_3 / on_at_1, 2.9) << "wider in time as well";
  check_corners({{"square.mpf", "3000", true}, 15.20, 0.01, 10.6});
}

// Servo gain 1.8: T = 1/30 s, v T / e times the root of 2 are 867.1 um; stick motion and backlash
// of a few um come on top.
TEST(PathAccuracy, TheShippedMachineMissesACornerByItsLag) {
  const TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {kLibrary + "square.nc"};
  options.setups = {folder.write(
      "v55.toml", "[machine]\nfile = \"" +
                      std::filesystem::absolute("machine/library/v55.toml").string() +
                      "\"\n[work_offsets.G54]\nX = 450.0\nY = -250.0\nZ = -200.0\n[start]\n"
                      "X = 499.8\nY = -250.0\nZ = -200.0\n")};
  options.trace = folder.path("trace.csv");
  EXPECT_EQ(testing::run_program(options).exit_code, 0);
  cli::EvaluateOptions evaluation;
  evaluation.kind = "square";
  evaluation.file = options.trace;
  evaluation.given[OptionId::Side] = "100";
  evaluation.given[OptionId::Centre] = "450,-250";
  const EvaluateOutput square = run_evaluate(evaluation);
  for (int corner = 1; corner <= 4; ++corner) {
    EXPECT_NEAR(square.value("corner_error_" + std::to_string(corner)), -867.1, 6.0) << corner;
  }
}

// Linear filter of T1 = 64 ms and a lag of T2 = 1/30 s: the root of 2 times v (T2 / e) sinh(h) / h
// with h = T1 / (2 T2), as T1 <= 2 T2.
TEST(PathAccuracy, TheParametersOfAFilterMissCornersAsTheClosedFormHasIt) {
  constexpr double kSpeed = 50.0;
  constexpr double kLag = 1.0 / 30.0;
  const double half = 0.064 / (2.0 * kLag);
  const double linear = kSpeed * kLag * std::exp(-1.0) * std::sinh(half) / half;
  // Exponential, both decaying: at t = T1 + T2.
  const double at = 0.064 + kLag;
  const double exponential =
      kSpeed * (kLag * kLag * std::exp(-at / kLag) - 0.064 * 0.064 * std::exp(-at / 0.064)) /
      (kLag - 0.064);
  for (const auto& [parameters, miss] :
       {std::pair("", linear), {"[parameters]\n\"1610.0\" = 0\n", exponential}}) {
    const TemporaryFolder folder;
    cli::RunOptions options;
    options.programs = {kLibrary + "square.nc"};
    options.setups = {kLibrary + "filtered.toml", folder.write("more.toml", parameters)};
    options.trace = folder.path("trace.csv");
    options.trace_period = "0.5ms";
    EXPECT_EQ(testing::run_program(options).exit_code, 0);
    const EvaluateOutput square = evaluated("square", options.trace);
    for (int corner = 1; corner <= 4; ++corner) {
      // What the ways of 100 mm leave of the start dies away by exp(-2 s / 64 ms).
      EXPECT_NEAR(square.value("corner_error_" + std::to_string(corner)),
                  -1e3 * std::sqrt(2.0) * miss, 0.05)
          << corner << parameters;
    }
  }
}

TEST(PathAccuracy, AReversalOnACircleMakesASpikeOfTenMicrometres) {
  for (const Recorded& run :
       {Recorded{"circle.nc", "2000", false}, Recorded{"circle.nc", "2000", true},
        Recorded{"circle.mpf", "2000", true}}) {
    SCOPED_TRACE(run.program);
    const TemporaryFolder folder;
    const EvaluateOutput circle = evaluated("circle", traced(folder, run));
    EXPECT_NEAR(circle.value("spike_X"), 10.12, 0.02);
    EXPECT_NEAR(circle.value("spike_Y"), 10.12, 0.02);
    EXPECT_NEAR(1000.0 * (circle.value("radius") - 50.0), run.contour_control ? -2.8 : -14.8, 0.1);
    // The machine has neither play nor squareness; what friction leaves behind is in the
    // uncertainties.
    for (const char* const nothing :
         {"backlash_X", "backlash_Y", "squareness", "centre_x", "centre_y"}) {
      EXPECT_LE(std::abs(circle.value(nothing)), 3.0 * circle.u(nothing)) << nothing;
    }
    EXPECT_LE(std::abs(circle.value("scale_X") - circle.value("scale_Y")),
              3.0 * std::hypot(circle.u("scale_X"), circle.u("scale_Y")));
    EXPECT_LE(circle.u("squareness"), 1.0) << "um/m";
    EXPECT_LE(circle.value("minimum_zone"), circle.value("circular_error"));
  }
}

TEST(PathAccuracy, AStraightWayInBothAxesShowsTheirScales) {
  for (const char* program : {"diagonal.nc", "diagonal.mpf"}) {
    const TemporaryFolder folder;
    const EvaluateOutput diagonal =
        evaluated("diagonal", traced(folder, {program, "", false}, "short_axes.toml"));
    EXPECT_NEAR(diagonal.value("error_X"), -7.0, 0.001);
    EXPECT_NEAR(diagonal.value("error_Y"), -4.0, 0.001);
    EXPECT_NEAR(diagonal.value("error_X_on"), -42.0, 0.006);
    EXPECT_NEAR(diagonal.value("error_Y_on"), -24.0, 0.006);
  }
}

}  // namespace
}  // namespace g31::path_accuracy_test
