// Which blocks let feed moves pass on into each other, and which make the axes stop.  100 mm at
// 3000 mm/min and 2000 mm/s^2 take 2.025 s from rest to rest, 200 mm without a stop 4.025 s.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/run_program.h"

namespace g31::passing_on_test {
namespace {

using testing::RunOutput;
using testing::TemporaryFolder;

constexpr double kPassing = 4.025;
constexpr double kStopping = 4.05;

struct Case {
  const char* name;
  const char* between;  ///< two moves of 100 mm
  double seconds;
};

double seconds_of(const char* file, const std::string& program) {
  TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write(file, program)};
  const RunOutput output = testing::run_program(options);
  EXPECT_LE(output.exit_code, 1) << output.errors;
  return output.document.at("machine_time_s").get<double>();
}

TEST(PassingOn, OfFanucBlocks) {
  const Case kCases[] = {
      {"nothing between", "", kPassing},
      {"a statement", "#1=1\n", kPassing},
      {"a block end is known at once", "#1=#5001\n", kPassing},
      {"a place that changes while axes move", "#1=#5041\n", kStopping},
      {"the clock", "#1=#3001\n", kStopping},
      {"an M code", "M8\n", kStopping},
      {"data input is a fence", "G10L2P2X1.\n", kStopping},
      {"an exact stop ends the way that led to it", "G9X150.\n", kStopping},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    const std::string program = std::string("O1\nG90G1X100.F3000\n") + c.between + "G1X200.\nM30\n";
    EXPECT_NEAR(seconds_of("case.nc", program), c.seconds, 1e-9);
  }
}

TEST(PassingOn, OfSinumerikBlocks) {
  const Case kCases[] = {
      {"continuous path", "G64\n", kPassing},
      {"with rounding, taken as that", "G642\n", kPassing},
      {"exact stop", "G60\n", kStopping},
      {"a statement", "G64\nR1=1\n", kPassing},
      {"reading ahead stops", "STOPRE\n", kStopping},
      {"a place", "R1=$AA_IW[X]\n", kStopping},
      {"a clock", "R1=$AC_CUTTING_TIME\n", kStopping},
      {"an M code", "M8\n", kStopping},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    const bool is_mode = c.between[0] == 'G';
    const std::string program =
        is_mode ? std::string(c.between) + "G90 G1 X100 F3000\nX200\nM30\n"
                : std::string("G64\nG90 G1 X100 F3000\n") + c.between + "X200\nM30\n";
    EXPECT_NEAR(seconds_of("case.mpf", program), c.seconds, 1e-9);
  }
}

/// Accelerating, at the highest speed, braking; rates of the ideal machine.
double seconds_between(double from, double peak, double to, double length) {
  constexpr double kAcceleration = 2000.0;
  const double ramps = (2.0 * peak * peak - from * from - to * to) / (2.0 * kAcceleration);
  return (2.0 * peak - from - to) / kAcceleration + (length - ramps) / peak;
}

TEST(PassingOn, OfSinumerikRapids) {
  constexpr double kRapid = 20000.0 / 60.0;
  constexpr double kFeed = 50.0;
  const Case kCases[] = {
      {"exact stop", "G60\nG0 X100\nX200\n", 2.0 * seconds_between(0.0, kRapid, 0.0, 100.0)},
      {"rapids are one way", "G64\nG0 X100\nX200\n", seconds_between(0.0, kRapid, 0.0, 200.0)},
      {"into a feed", "G64\nG0 X100\nG1 X200 F3000\n",
       seconds_between(0.0, kRapid, kFeed, 100.0) + seconds_between(kFeed, kFeed, 0.0, 100.0)},
      {"out of a feed", "G64\nG1 X100 F3000\nG0 X200\n",
       seconds_between(0.0, kFeed, kFeed, 100.0) + seconds_between(kFeed, kRapid, 0.0, 100.0)},
      {"a dwell stands", "G64\nG0 X100\nG4 F1\nX200\n",
       1.0 + 2.0 * seconds_between(0.0, kRapid, 0.0, 100.0)},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    EXPECT_NEAR(seconds_of("case.mpf", std::string(c.between) + "M30\n"), c.seconds, 1e-9);
  }
  const double stops = 2.0 * seconds_between(0.0, kRapid, 0.0, 100.0);
  EXPECT_NEAR(seconds_of("case.nc", "O1\nG90G64G0X100.\nX200.\nM30\n"), stops, 1e-9)
      << "a Fanuc looks whether its axes have arrived";
}

// Two ways of 100 mm at 50 mm/s with an arc between them that takes `leg` off either: its radius is
// the same.  Arcs take the axes' 2,000 mm/s2 over the root of 2, as both axes share them there.
TEST(PassingOn, AroundTheArcOfARoundingAsFastAsTheAxesAllow) {
  constexpr double kFeed = 50.0;
  // 0.1 mm of either axis off a corner of 90 degrees.
  const double of_tolerance = 0.1 * std::sqrt(2.0) / std::tan(std::numbers::pi / 8.0);
  struct Rounding {
    const char* mode;
    double leg;
  };
  for (const auto& [mode, leg] : {Rounding{"G642", of_tolerance},
                                  {"G644 ADIS=2", of_tolerance},
                                  {"$MC_SMOOTHING_MODE=4000 G644 ADIS=2", of_tolerance},
                                  {"$MC_SMOOTHING_MODE=1000 G644 ADIS=2", 2.0},
                                  {"$MC_SMOOTHING_MODE=5000 G644 ADIS=0.5", 0.5},
                                  {"G641 ADIS=0.5", 0.5}}) {
    SCOPED_TRACE(mode);
    const double around = std::min(kFeed, std::sqrt(2000.0 / std::numbers::sqrt2 * leg));
    const double seconds = seconds_between(0.0, kFeed, around, 100.0 - leg) +
                           0.5 * std::numbers::pi * leg / around +
                           seconds_between(around, kFeed, 0.0, 100.0 - leg);
    EXPECT_NEAR(seconds_of("case.mpf", std::string(mode) + "\nG90 G1 X100 F3000\nY100\nM30\n"),
                seconds, 1e-9);
  }
}

}  // namespace
}  // namespace g31::passing_on_test
