// Digits of the manual's parameter tables that choose plane, target and place of a touch, each
// entry by itself: _DMODE of CYCLE971, 973, 974, 982 and 994, S_KNUM, S_KNUM1 and _AMODE of
// CYCLE994, _AMODE of CYCLE971.

#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/tool_measuring_run.h"
#include "tests/support/turning_run.h"

namespace g31::testing::measuring_digits_test {
namespace {

const std::string kAtShaft = "G54 DIAMON G0 X100\nZ-10\n";

std::string shaft(double x = 0.0) {
  return part("shaft", x, 0.0, 200.0, "diameter = 50.04\nheight = 100.0");
}

/// Lengths stay those of G18, whatever the plane; the third axis is calibrated, too.
constexpr const char* kInAnyPlane = R"([machine_data]
"$SC_TOOL_LENGTH_CONST" = 18
"$SC_TOOL_LENGTH_CONST_T" = 18
"$SNS_MEA_WP_TRIG_MINUS_DIR_AX3[0]" = -3.0
"$SNS_MEA_WP_TRIG_PLUS_DIR_AX3[0]" = 3.0
)";

struct PlaneCase {
  int digit;  ///< of _DMODE
  int x;      ///< which axis of that plane X is
  int z;
};

/// 0 is the plane in force, which comes back behind the cycle.
constexpr PlaneCase kPlanes[] = {{0, 2, 1}, {1, 1, 3}, {2, 2, 1}, {3, 3, 2}};

TEST(MeasuringDigits, ThePlaneOfTurningCycles) {
  for (const PlaneCase& row : kPlanes) {
    SCOPED_TRACE(row.digit);
    const auto outside = [&](const std::string& call, const char* probe,
                             const std::vector<ExpectedValue>& expected) {
      std::vector<ExpectedValue> all = expected;
      all.push_back({"$P_GG[6]", 2.0});
      expect_turned(kAtShaft + call, {probe, kCalibrated, shaft(), kInAnyPlane}, all);
    };
    outside(fmt::format("CYCLE974(2,,,1,50,{},3,5,,,,,,,,,,,,,{})", row.x, row.digit),
            kProbeToMinusX, {{"_OVR[4]", 50.04}, {fmt::format("_OVR[{}]", 4 + row.x), 50.04}});
    outside(
        fmt::format("CYCLE994({}002,,,1,50,{},20,30,3,5,,,,,,,,,,,,{})", row.z, row.x, row.digit),
        kProbeToMinusZ, {{"_OVR[4]", 50.04}, {fmt::format("_OVR[{}]", 4 + row.x), 50.04}});
    // The surface is said to be 25.025 away: the trigger of the ball at 28.02 is 2.995.
    outside(fmt::format("CYCLE973(1001,1,,50.05,{},1,3,5,,,,{})", row.x, row.digit), kProbeToMinusX,
            {{fmt::format("$SNS_MEA_WP_TRIG_MINUS_DIR_AX{}[0]", row.x), -2.995}});
    // Along the probe, whatever S_MA says.
    outside(fmt::format("CYCLE973(1,1,,50.05,{},0,3,5,,,,{})", row.z, row.digit), kProbeToMinusX,
            {{fmt::format("$SNS_MEA_WP_TRIG_MINUS_DIR_AX{}[0]", row.x), -2.995}});
  }
}

struct TargetCase {
  int number;  ///< S_KNUM or S_KNUM1
  const char* written;
  double value;
};

/// The middle of the two points is 0.03 from the centre.
constexpr TargetCase kOffsets[] = {
    {0, "$P_UIFR[1,X,FI]", 0.0},      {1, "$P_UIFR[1,X,FI]", 0.03},
    {10001, "$P_UIFR[1,X,TR]", 0.03}, {10003, "$P_UIFR[3,X,TR]", 0.03},
    {9000, "$P_UIFR[1,X,FI]", 0.03},  {11002, "$P_CHBFR[1,X,TR]", 0.03},
    {12000, "$P_SETFR[X,TR]", 0.03},  {13001, "$P_NCBFR[0,X,TR]", 0.03},
};

/// The tool's X is 0.02 too long where a diameter is 0.04 too large; the additive offset is 0.005.
constexpr TargetCase kTools[] = {
    {0, "$TC_DP12[2,1]", 0.0},           {1, "$TC_DP12[2,1]", -0.02},
    {100001, "$TC_DP12[2,1]", -0.02},    {200001, "$TC_DP13[2,1]", -0.02},
    {300001, "$TC_DP14[2,1]", -0.02},    {400001, "$TC_DP15[2,1]", -0.02},
    {1000001, "$TC_SCP13[2,1]", -0.015}, {2000001, "$TC_ECP13[2,1]", -0.015},
    {3000001, "$TC_ECP13[2,1]", -0.02},  {4000001, "$TC_DP3[2,1]", 89.98},
    {10000001, "$TC_DP12[2,1]", 0.02},
};

TEST(MeasuringDigits, TheTargetsOfTwoPoints) {
  for (const TargetCase& row : kOffsets) {
    SCOPED_TRACE(row.number);
    expect_turned(kAtShaft + fmt::format("CYCLE994(1102,{},,1,50,2,20,30,3,5)", row.number),
                  {kProbeToMinusZ, kCalibrated, shaft(0.03)}, {{row.written, row.value}});
  }
  for (const TargetCase& row : kTools) {
    SCOPED_TRACE(row.number);
    expect_turned(
        "$TC_SCP13[2,1]=0.005\n" + kAtShaft +
            fmt::format("CYCLE994(1202,,{},1,50,2,20,30,3,5,1,\"ROUGHER\",1)", row.number),
        {kProbeToMinusZ, kCalibrated, shaft()}, {{row.written, row.value}});
  }
}

/// S_TUL 0.03: 0.04 is an oversize with _AMODE 1, and the tool is corrected all the same.
TEST(MeasuringDigits, TheToleranceOfTwoPoints) {
  for (const int tolerance : {0, 1}) {
    expect_turned(kAtShaft + fmt::format("CYCLE994(1202,,1,1,50,2,20,30,3,5,1,\"ROUGHER\",,0.01,"
                                         "0.3,0.03,-0.03,0.06,1,0,,,{})",
                                         tolerance),
                  {kProbeToMinusZ, kCalibrated, shaft()},
                  {{"_OVI[9]", tolerance * 61304.0}, {"$TC_DP12[2,1]", -0.02}});
  }
}

struct PlaceCase {
  const char* name;
  std::string call;
  double x, z;  ///< axes at the touch
};

/// The tool has a radius of 8 and stands beside the plate at X150; the plate is 25 wide about X200,
/// its top at Z-200 of the axes; a side is touched 2 mm below it.
TEST(MeasuringDigits, WhereATouchOfCycle971IsMade) {
  const auto length = [](double less, int amode) {
    return fmt::format("CYCLE971(1,0,1,103,2,{},5,2,,,,,,,,,,,,,1,{})", less, amode);
  };
  const auto radius = [](int amode) {
    return fmt::format("CYCLE971(1,0,1,1,1,1,5,2,,,,,,,,,,,,,1,{})", amode);
  };
  const PlaceCase kRows[] = {
      {"length, automatic", length(0, 0), 200.0, -200.0},
      {"length, without offset", length(0, 100), 200.0, -200.0},
      {"length, without offset, a direction", length(0, 1100), 200.0, -200.0},
      {"length, offset to plus", length(0, 1200), 208.0, -200.0},
      {"length, offset to minus", length(0, 2200), 192.0, -200.0},
      {"length, offset less S_ID", length(3, 1200), 205.0, -200.0},
      {"radius, not said", radius(0), 179.5, -203.0},
      {"radius, without offset", radius(1), 179.5, -202.0},
      {"radius, offset", radius(2), 179.5, -203.0},
      {"radius, offset to plus", radius(12), 179.5, -201.0},
      {"radius, offset to minus", radius(22), 179.5, -203.0},
  };
  for (const PlaceCase& row : kRows) {
    SCOPED_TRACE(row.name);
    const MeasuringRun run =
        expect_tools(with_tool(5) + row.call, {kCube, kKnown}, {{"_OVI[9]", 0.0}}, 1e-9);
    int signals = 0;
    for (const auto& touch : run.output.document.at("touches")) {
      if (touch.at("triggered").get<bool>()) {
        ++signals;
        EXPECT_NEAR(touch.at("latched").at(0).get<double>(), row.x, 1e-6);
        EXPECT_NEAR(touch.at("latched").at(2).get<double>(), row.z, 1e-6);
      }
    }
    EXPECT_EQ(signals, 1);
  }
  // Wider than SD54631 says, the tool is offset to the side on which it stands.
  expect_tools(with_tool(5) + length(0, 0) + "\nR1=$AA_IM[X]\nG0 SUPA Z-280\nX250\n" + length(0, 0),
               {kCube, kKnown, "[machine_data]\n\"$SNS_MEA_TP_EDGE_DISK_SIZE[0]\" = 15.0\n"},
               {{"R1", 192.0}, {"$AA_IM[X]", 208.0}}, 1e-6);
}

/// The program is in G18; 1 is G17 inside of the cycle.
TEST(MeasuringDigits, ThePlaneOfCycle971) {
  expect_tools("$TC_DP3[5,1]=100.2\n" + with_tool(5) +
                   "G18\nCYCLE971(1,0,1,103,2,0,5,2,,0.0001,1,,,,,,,,,,1)",
               {kCube, kKnown}, {{"$TC_DP3[5,1]", 100.0}, {"$P_GG[6]", 2.0}}, 1e-6);
}

/// Hundreds and tens of _DMODE are for the display; the tool's type says what it is.
TEST(MeasuringDigits, TheDisplayOfCycle982) {
  const char* const tool = R"([machine]
tool_side = "ZX"
[tools.5]
length = 50.0
radius = 0.4
type = 500.0
[[tool]]
number = 5
kind = "turning"
lengths = [50.0, 80.0, 0.0]
tip_radius = 0.4
edge_position = 3
)";
  for (const int mode : {0, 2, 30, 100, 132, 200, 232}) {
    SCOPED_TRACE(mode);
    const std::string program =
        "$TC_DP2[5,1]=3 $TC_DP3[5,1]=50.3 $TC_DP4[5,1]=79.6\nT5 M6\nG18 D1 DIAMOF\n"
        "G0 SUPA X200 Z-50\n" +
        fmt::format("CYCLE982(2,0,1,0,0,0,5,2,,,,0.0001,1,,,,{})", mode);
    const std::vector<ExpectedValue> expected = {
        {"$TC_DP3[5,1]", 50.0}, {"$TC_DP4[5,1]", 80.0}, {"$P_GG[6]", 2.0}};
    expect_values(run_on_sheets(program, {kLatheProbe, tool}, names_of(expected)), expected, 1e-6);
  }
}

}  // namespace
}  // namespace g31::testing::measuring_digits_test
