// Where the macros of the G100 family have no answer they give an alarm and no number; next to that
// place the number is still right.

#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/tools/point_macros.h"

namespace g31::point_macro_limits_test {
namespace {

using Eigen::Vector3d;
using testing::Buffer;
using testing::point_of;
using testing::PointProgram;
using testing::RunOutput;
using testing::value_of;

void expect_alarm(const RunOutput& output, int number, const std::string& text) {
  EXPECT_EQ(output.exit_code, 3);
  const auto& alarm = output.document.at("alarm");
  ASSERT_FALSE(alarm.is_null());
  EXPECT_EQ(alarm.at("number"), number);
  EXPECT_EQ(alarm.at("text"), text);
  for (const int variable : {100, 105, 110, 145, 150, 155, 170}) {
    EXPECT_EQ(value_of(output, variable), std::nullopt) << "#" << variable;
  }
  EXPECT_EQ(output.document.at("output"), "");
}

/// Rows 1 to 4 of A a rectangle at z = 0, 5 on its first side, 6 above it; row 2 of B, row 3 of C.
PointProgram some_rows() {
  PointProgram program;
  program.put(Buffer::A, 1, {0.0, 0.0, 0.0});
  program.put(Buffer::A, 2, {10.0, 0.0, 0.0});
  program.put(Buffer::A, 3, {10.0, 5.0, 0.0});
  program.put(Buffer::A, 4, {0.0, 5.0, 0.0});
  program.put(Buffer::A, 5, {4.0, 0.0, 0.0});
  program.put(Buffer::A, 6, {0.0, 0.0, 8.0});
  program.put(Buffer::B, 2, {1.0, 2.0, 3.0});
  program.put(Buffer::C, 3, {4.0, 5.0, 6.0});
  return program;
}

struct Impossible {
  const char* name;
  const char* call;
  int alarm;
  const char* text;
};

const Impossible kImpossible[] = {
    {"lines: a row that was never filled", "G110 A12.37", 3160, "ROW EMPTY"},
    {"lines: nothing given, rows 1 to 4 are parallel sides", "G110", 3163, "LINES PARALLEL"},
    {"lines: the same line twice", "G110 A12.15", 3163, "LINES PARALLEL"},
    {"lines: one row twice", "G110 A11.23", 3162, "POINTS TOO CLOSE"},
    {"lines: a line that is a point as seen along Z", "G110 A16.23", 3162, "POINTS TOO CLOSE"},
    {"lines: three digits", "G110 A12.3", 3182, "DATA OVER"},
    {"lines: five digits", "G110 A12.345", 3182, "DATA OVER"},
    {"lines: row 0", "G110 A10.34", 3182, "DATA OVER"},
    {"lines: no decimal point", "G110 A1234", 3182, "DATA OVER"},
    {"lines: row 6 of B", "G110 A12.23 B6.", 3182, "DATA OVER"},
    {"lines: B without decimal point", "G110 A12.23 B1", 3182, "DATA OVER"},
    {"lines: no such plane", "G110 A12.23 H3", 3182, "DATA OVER"},
    {"lines: half a plane", "G110 A12.23 H.5", 3182, "DATA OVER"},
    {"planes: a row that was never filled", "G111", 3160, "ROW EMPTY"},
    {"planes: a row named twice", "G111 A123.145", 3182, "DATA OVER"},
    {"planes: five digits", "G111 A123.45", 3182, "DATA OVER"},
    {"planes: three rows on a line", "G111 A125.346", 3165, "POINTS ON ONE LINE"},
    {"planes: no such pair", "G111 H3", 3182, "DATA OVER"},
    {"circle: a row that was never filled", "G120 A129.", 3160, "ROW EMPTY"},
    {"circle: three rows on a line", "G120 A125.", 3165, "POINTS ON ONE LINE"},
    {"circle: one row twice", "G120 A112.", 3165, "POINTS ON ONE LINE"},
    {"circle: on a line as seen along X", "G120 A123. H1", 3165, "POINTS ON ONE LINE"},
    {"circle: two rows", "G120 A12.", 3182, "DATA OVER"},
    {"circle: row 6 of C", "G120 C6.", 3182, "DATA OVER"},
    {"distance: nothing given", "G130", 3160, "DATA EMPTY"},
    {"distance: one row", "G130 A1.", 3160, "DATA EMPTY"},
    {"distance: three rows", "G130 A12. B2.", 3182, "DATA OVER"},
    {"distance: three digits", "G130 A123.", 3182, "DATA OVER"},
    {"distance: row 6 of B", "G130 A1. B6.", 3182, "DATA OVER"},
    {"distance: row 0", "G130 A10.", 3182, "DATA OVER"},
    {"distance: a row that was never filled", "G130 A1. B1.", 3160, "ROW EMPTY"},
    {"distance: a digit behind the point", "G130 A12.3", 3182, "DATA OVER"},
    {"distance: the angle of no line", "G130 A11. T1", 3162, "POINTS TOO CLOSE"},
    {"distance: no such plane for S", "G130 A12. S4", 3182, "DATA OVER"},
    {"distance: no such plane for T", "G130 A12. T4", 3182, "DATA OVER"},
    {"distance: row 6 of D", "G130 A12. D6.", 3182, "DATA OVER"},
    {"distance: number of three digits", "G130 A12. I100.", 3182, "DATA OVER"},
    {"distance: number without decimal point", "G130 A12. I6", 3182, "DATA OVER"},
    {"line and point: nothing given", "G131", 3160, "DATA EMPTY"},
    {"line and point: a line only", "G131 A12.", 3160, "DATA EMPTY"},
    {"line and point: a point only", "G131 B2.", 3160, "DATA EMPTY"},
    {"line and point: two points", "G131 A1. B2.", 3182, "DATA OVER"},
    {"line and point: two lines", "G131 A12. B23.", 3182, "DATA OVER"},
    {"line and point: a line and two points", "G131 A12. B2. C3.", 3182, "DATA OVER"},
    {"line and point: a point too many", "G131 A12.3 B2.", 3182, "DATA OVER"},
    {"line and point: two digits behind the point", "G131 A12.34", 3182, "DATA OVER"},
    {"line and point: a mark that is none", "G131 A1.2 B2.1 C3.1", 3182, "DATA OVER"},
    {"line and point: one row twice", "G131 A11.3", 3162, "POINTS TOO CLOSE"},
    {"line and point: the line a point in the plane", "G131 A16.3 S1", 3162, "POINTS TOO CLOSE"},
    {"line and point: row 4 of C is vacant", "G131 A12. C4.", 3160, "ROW EMPTY"},
    {"touch: in inches", "G20\nG65 P9010 U8. R5. Z3. A1.", 3170, "METRIC INPUT ONLY"},
};

TEST(PointMacroLimits, WhatIsMissingOrImpossibleIsAnAlarm) {
  const PointProgram program = some_rows();
  for (const Impossible& c : kImpossible) {
    SCOPED_TRACE(c.name);
    expect_alarm(program.run(c.call), c.alarm, c.text);
  }
}

TEST(PointMacroLimits, LinesMayBeNearlyParallel) {
  for (const double angle : {0.1, 0.01, 0.001, 0.00015, 0.00009, 0.000001}) {
    SCOPED_TRACE(angle);
    // Both pass through (7, -3); row 4 lies on line 1 turned by the angle.
    PointProgram program;
    program.put(Buffer::A, 1, {-20.0, -3.0, 0.0});
    program.put(Buffer::A, 2, {30.0, -3.0, 0.0});
    program.put(Buffer::A, 3, {7.0 - 40.0 * std::cos(angle), -3.0 - 40.0 * std::sin(angle), 0.0});
    program.put(Buffer::A, 4, {7.0 + 25.0 * std::cos(angle), -3.0 + 25.0 * std::sin(angle), 0.0});
    const RunOutput output = program.run("G110 W1.");
    if (angle < 1e-4) {
      expect_alarm(output, 3163, "LINES PARALLEL");
      continue;
    }
    ASSERT_EQ(output.exit_code, 0) << output.errors;
    EXPECT_NEAR(value_of(output, 100).value(), 7.0, 1e-12 / angle);
    EXPECT_NEAR(value_of(output, 115).value(), -3.0, 1e-12);
    EXPECT_NEAR(value_of(output, 145).value(), angle * 180.0 / std::numbers::pi, 1e-9);
  }
}

TEST(PointMacroLimits, PlanesMayBeNearlyParallel) {
  for (const double slope : {0.1, 0.001, 0.00015, 0.00009, 0.0}) {
    SCOPED_TRACE(slope);
    // z = 1, z = 1 + slope (x - 2), y = 3: they meet at (2, 3, 1).
    PointProgram program;
    program.put(Buffer::A, 1, {0.0, 0.0, 1.0});
    program.put(Buffer::A, 2, {50.0, 10.0, 1.0});
    program.put(Buffer::A, 3, {20.0, 40.0, 1.0});
    program.put(Buffer::A, 4, {12.0, 0.0, 1.0 + 10.0 * slope});
    program.put(Buffer::A, 5, {52.0, 0.0, 1.0 + 50.0 * slope});
    program.put(Buffer::A, 6, {12.0, 30.0, 1.0 + 10.0 * slope});
    program.put(Buffer::A, 7, {0.0, 3.0, 0.0});
    program.put(Buffer::A, 8, {0.0, 3.0, 20.0});
    program.put(Buffer::A, 9, {30.0, 3.0, 0.0});
    const RunOutput output = program.run("G111 H0 W1.");
    if (slope < 1e-4) {
      expect_alarm(output, 3164, "PLANES PARALLEL");
      continue;
    }
    ASSERT_EQ(output.exit_code, 0) << output.errors;
    EXPECT_LT((point_of(output, 99, 1) - Vector3d(2.0, 3.0, 1.0)).norm(), 1e-11 / slope);
    EXPECT_NEAR(value_of(output, 145).value(), std::atan(slope) * 180.0 / std::numbers::pi, 1e-9);
  }
}

TEST(PointMacroLimits, TheArcOfACircleMayBeShort) {
  for (const double half_angle : {0.5, 0.01, 0.001, 0.0001}) {
    SCOPED_TRACE(half_angle);
    // Height over chord is a quarter of the half angle.
    PointProgram program;
    for (int row = 1; row <= 3; ++row) {
      const double angle = 1.0 + half_angle * (row - 2);
      program.put(Buffer::A, row,
                  {4.0 + 60.0 * std::cos(angle), -9.0 + 60.0 * std::sin(angle), 0.0});
    }
    const RunOutput output = program.run("G120 W1.");
    if (half_angle / 4.0 < 1e-4) {
      expect_alarm(output, 3165, "POINTS ON ONE LINE");
      continue;
    }
    ASSERT_EQ(output.exit_code, 0) << output.errors;
    const double tolerance = 1e-12 / (half_angle * half_angle);
    EXPECT_LT((point_of(output, 104, 1) - Vector3d(4.0, -9.0, 0.0)).norm(), tolerance);
    EXPECT_NEAR(value_of(output, 150).value(), 120.0, 2.0 * tolerance);
  }
}

/// Coordinates equal up to the last bit: the squares of such differences leave the 16i's numbers.
TEST(PointMacroLimits, RoundingNoiseIsNoAlarm) {
  const double noise = std::ldexp(1.0, -53);
  PointProgram program;
  program.put(Buffer::A, 1, {1.0, 0.5, 0.25});
  program.put(Buffer::A, 2, {1.0 + 2.0 * noise, 4.5, 0.25 + noise});
  program.put(Buffer::A, 3, {5.0, 0.5 + noise, 0.25});
  program.put(Buffer::A, 4, {1.0, 0.5, 3.25});
  program.put(Buffer::A, 5, {1.0, 0.5 + noise, 0.25 + noise});
  program.put(Buffer::A, 6, {5.0, 0.5, 3.25 + 4.0 * noise});
  program.put(Buffer::A, 7, {1.0 + 2.0 * noise, 0.5, 0.25});
  program.put(Buffer::A, 8, {1.0, 4.5, 3.25});
  program.put(Buffer::A, 9, {1.0, 4.5 + 4.0 * noise, 0.25 + noise});
  for (const char* call : {"G110 A12.13", "G110 A14.46 H2", "G111", "G120", "G120 A346. H2",
                           "G130 A15. S2", "G130 A12. T3", "G131 A13.7", "G131 A12.9 S1"}) {
    SCOPED_TRACE(call);
    const RunOutput output = program.run(call);
    EXPECT_EQ(output.exit_code, 0) << output.errors;
  }
  EXPECT_LT((point_of(program.run("G111"), 99, 1) - Vector3d(1.0, 0.5, 0.25)).norm(), 1e-12);
}

}  // namespace
}  // namespace g31::point_macro_limits_test
