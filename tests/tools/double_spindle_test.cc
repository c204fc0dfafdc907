// Two spindles side by side, each with a probe and a part of its own: both measure at once.

#include "tests/support/double_spindle.h"

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/effort.h"

namespace g31::testing::double_spindle_test {
namespace {

/// The second pair of touches goes through the middle of the first hole, 0.05 beside that of the
/// second one, where the ball's way is a chord.
TEST(DoubleSpindle, BothHolesAreMeasuredAtOnce) {
  const double chord = 2.0 * (3.0 + std::sqrt(17.01 * 17.01 - 0.05 * 0.05));
  const MeasuringRun run =
      expect_measured("Z-5\nCYCLE977(1,,,1,40.01,,,2,5)",
                      on_both(first_part("ring", 0.2, -0.3, bore(40.0)) +
                              second_part("ring", 0.25, -0.2, bore(40.02))),
                      {{"_OVR[0]", 40.01},   {"_OVR[4]", 40.0},
                       {"_OVR[5]", 0.2},     {"_OVR[6]", -0.3},
                       {"_OVR[16]", -0.01},  {"_OVR[100]", 40.01},
                       {"_OVR[104]", chord}, {"_OVR[105]", 0.25},
                       {"_OVR[106]", -0.2},  {"_OVR[116]", chord - 40.01},
                       {"_OVR[117]", 0.25},  {"_OVR[118]", -0.2},
                       {"_OVR[900]", 40.01}, {"_OVR[904]", 0.5 * (40.0 + chord)},
                       {"_OVR[905]", 0.225}, {"_OVR[906]", -0.25},
                       {"_OVR[120]", 0.0},   {"_OVR[920]", 0.0},
                       {"$AA_IW[X]", 0.2},   {"$AA_IW[Y]", -0.3}},
                      2e-6);
  // Four moves, eight touches, each where its probe is.
  const auto& touches = run.output.document.at("touches");
  int on_first = 0;
  int on_second = 0;
  for (const auto& touch : touches) {
    if (touch.at("triggered").get<bool>()) {
      ++(touch.at("contact").at(0).get<double>() < 200.0 ? on_first : on_second);
    }
  }
  EXPECT_EQ(on_first, 4);
  EXPECT_EQ(on_second, 4);
}

/// The manual's program, with the moves that it leaves out; the groove of the first spindle is
/// 50.02 wide and 0.2 beside its place, that of the second 49.98 and 0.1.
TEST(DoubleSpindle, TheWorkedExampleOfTheManual) {
  const char* const program = R"(T="3D_TASTER"
M6
G54
G0 X0 Y0 Z20
Z-5
F2000
CYCLE150(31,1,"MEAS_PROTOCOL.TXT")
CYCLE977(103,1,,1,50,,,5,5,0,1,1,,1,1,"",,0,1.01,1.01,-1.01,0.34,1,0,,1,1)
S_PROTTXT[0]=REP("")
S_PROTTXT[0]="2nd probe:"
S_PROTTXT[1]=SPRINT("X %10.3F          %10.3F          %10.3F mm",_OVR[101],_OVR[105],_OVR[117])
S_PROTTXT[2]=SPRINT("Y %10.3F          %10.3F          %10.3F mm",_OVR[102],_OVR[106],_OVR[118])
S_PROTTXT[3]=SPRINT("Diameter %10.3F          %10.3F          %10.3F mm",_OVR[100],_OVR[104],_OVR[116])
CYCLE160; write and show log
M2)";
  const std::vector<ExpectedValue> expected = {
      {"_OVR[0]", 50.0},   {"_OVR[4]", 50.02},   {"_OVR[5]", 0.2},    {"_OVR[17]", 0.2},
      {"_OVR[100]", 50.0}, {"_OVR[104]", 49.98}, {"_OVR[105]", 0.1},  {"_OVR[116]", -0.02},
      {"_OVR[117]", 0.1},  {"_OVR[904]", 50.0},  {"_OVR[905]", 0.15}, {"$P_UIFR[1,X,FI]", 0.2}};
  const MeasuringRun run = run_on_sheets(
      program,
      sheets_behind(kMeasuringSheet, on_both(first_part("groove", 0.2, 0.0, "width = 50.02") +
                                                 second_part("groove", 0.1, 0.0, "width = 49.98"),
                                             "[tools.1]\nname = \"3D_TASTER\"\n")),
      names_of(expected));
  expect_values(run, expected, 1e-6);
  const std::string log = run.output.document.at("files").at("MEAS_PROTOCOL.TXT");
  for (const char* const line :
       {"2nd probe:", "X      0.000               0.100               0.100 mm",
        "Y      0.000               0.000               0.000 mm",
        "Diameter     50.000              49.980              -0.020 mm"}) {
    EXPECT_NE(log.find(line), std::string::npos) << line << "\n" << log;
  }
}

struct VariantCase {
  const char* name;
  const char* shape;
  double x, y;  ///< of the part from G54
  const char* sizes;
  const char* program;
};

constexpr VariantCase kVariants[] = {
    {"edge", "block", 0.0, 0.0, "", "X-45 Z-5\nCYCLE978(0,,,1,-30,5,5,1,1,1)"},
    {"edge, with reversal", "block", 0.0, 0.0, "", "X-45 Z-5\nCYCLE978(10000,,,1,-30,5,5,1,1,1)"},
    {"rib", "rib", 0.0, 0.0, "width = 20.0", "Z5\nCYCLE977(4,,,1,19.9,,,2,5,,-15,,,1)"},
    {"groove", "groove", 0.0, 0.0, "width = 20.0", "Z-5\nCYCLE977(3,,,1,20.1,,,2,5,,,,,1)"},
    {"hole", "ring", 0.0, 0.0, "bore = 40.0\nsagitta = 0.0000005",
     "Z-5\nCYCLE977(1,,,1,40.01,,,2,5)"},
    {"hole, with reversal", "ring", 0.0, 0.0, "bore = 40.0\nsagitta = 0.0000005",
     "Z-5\nCYCLE977(10001,,,1,40.01,,,2,5)"},
    {"spigot", "cylinder", 0.0, 0.0, "diameter = 30.0\nsagitta = 0.0000005",
     "Z5\nCYCLE977(2,,,1,30,,,2,5,0,-15)"},
    {"rectangular pocket", "pocket", 0.0, 0.0, "length = 60.0\nwidth = 40.0",
     "Z-5\nCYCLE977(5,,,1,,60.1,39.9,2,5)"},
    {"rectangular spigot", "block", 0.0, 0.0, "", "Z5\nCYCLE977(6,,,1,,60,40,2,5,0,-15)"},
    {"align edge", "block", 0.0, 0.0, "rotate_deg = [0.0, 0.0, 2.0]",
     "X-10 Y-32\nZ-5\nCYCLE998(5,,0,1,5,0,,10,5,102,1,20)"},
    {"plane", "block", 0.0, 0.0, "rotate_deg = [1.0, 0.0, 0.0]",
     "Z8\nCYCLE998(6,,0,1,,0,0,5,5,,,,20,0,0,12)"},
    {"right-angled corner", "block", 30.7, 19.6, "",
     "X-12 Y-12\nZ-5\nCYCLE961(6,,1,20,45,15,,,,,,,,0,,,10,5)"},
    {"any corner", "block", 30.7, 19.6, "",
     "X-12 Y-12\nZ-5\nCYCLE961(8,,1,20,45,12,26,,,,,,,0,90,,10,5)"},
    {"arc", "ring", 0.0, 0.0, "bore = 40.0\nsagitta = 0.0000005",
     "Z-5\nCYCLE979(1001,,,1,40,2,5,0,0,0,90)"},
};

/// What the second probe gives beside the first is what a single spindle gives that measures the
/// second part alone.
TEST(DoubleSpindle, EachVariantGivesWhatTwoRunsGive) {
  std::vector<std::string> names;
  for (int i = 0; i <= 40; ++i) {
    names.push_back(fmt::format("_OVR[{}]", i));
    names.push_back(fmt::format("_OVR[{}]", 100 + i));
    names.push_back(fmt::format("_OVR[{}]", 900 + i));
  }
  for (const VariantCase& row : some_of(kVariants)) {
    SCOPED_TRACE(row.name);
    const std::string near = first_part(row.shape, row.x, row.y, row.sizes);
    // As far off as the ways of both probes may share: the second part in X or Y alone.
    const std::string far = second_part(row.shape, row.x + 0.0001, row.y - 0.0002, row.sizes);
    const MeasuringRun both = run_measuring(row.program, on_both(near + far), names);
    ASSERT_EQ(both.output.exit_code, 0) << both.output.errors;
    const std::vector<std::string> single = {kCalibrated};
    const MeasuringRun one = run_measuring(row.program, {kCalibrated, near}, names);
    const MeasuringRun other = run_measuring(
        row.program,
        {kCalibrated, first_part(row.shape, row.x + 0.0001, row.y - 0.0002, row.sizes)}, names);
    ASSERT_EQ(other.output.exit_code, 0) << other.output.errors;
    for (int i = 0; i <= 40; ++i) {
      const std::string name = fmt::format("_OVR[{}]", i);
      EXPECT_NEAR(both.at(name), one.at(name), 1e-9) << i;
      const bool is_limit = (i >= 8 && i <= 13 && one.at(name) == 0.0) || (i >= 20 && i <= 26);
      if (!is_limit) {
        EXPECT_NEAR(both.at(fmt::format("_OVR[{}]", 100 + i)), other.at(name), 1e-6) << i;
        EXPECT_NEAR(both.at(fmt::format("_OVR[{}]", 900 + i)),
                    0.5 * (one.at(name) + other.at(name)), 1e-6)
            << i;
      }
    }
  }
}

/// Signals 1 and 2 ms late at 300 mm/min; the second ball is 5 mm wide, lies 0.01 and -0.02 off its
/// axis, and its probe is 3 mm longer.
TEST(DoubleSpindle, BothAreCalibratedOneAfterTheOtherAndMeasureTruly) {
  const std::string late = R"([probe]
trigger_delay_s = 0.001
[probe.second]
ball_diameter = 5.0
length = 120.5
eccentricity = [0.01, -0.02]
trigger_delay_s = 0.002
[variables]
"$TC_DP3[1,2]" = 123.0
"$TC_DP6[1,2]" = 2.5
)";
  const std::string rings =
      first_part("ring", 0.0, 0.0, bore(40.0)) + second_part("ring", 0.0, 0.0, bore(40.0));
  expect_measured(
      "Z-5\nCYCLE976(1,1,40,,,,2,5)\nD2 G0 Z-5\nCYCLE976(1,2,40,,,,2,5)\n"
      "D1 G0 X0 Y0 Z-5\nCYCLE977(1,,,1,40,,,2,5)",
      {kSecond, rings, late},
      {{"$SNS_MEA_WP_TRIG_PLUS_DIR_AX1[0]", 2.995},
       {"$SNS_MEA_WP_TRIG_PLUS_DIR_AX1[1]", 2.49},
       {"$SNS_MEA_WP_POS_DEV_AX1[1]", 0.01},
       {"$SNS_MEA_WP_POS_DEV_AX2[1]", -0.02},
       {"$TC_DP6[1,1]", 3.0},
       {"$TC_DP6[1,2]", 2.5},
       {"_OVR[4]", 40.0},
       {"_OVR[104]", 40.0},
       {"_OVR[105]", 0.0},
       {"_OVR[106]", 0.0}},
      1e-5);
  // Along the tool's axis the second probe reaches 3 mm lower, and so is its block, all but 0.03.
  const std::string blocks =
      first_part("block", 0.0, 0.0, "") + part("block", 300.0, 50.0, -302.97, "");
  expect_measured("CYCLE978(0,,,1,0,5,5,3,2,1)",
                  {kSecond, kCalibrated, kSecondCalibrated, blocks,
                   "[probe.second]\nball_diameter = 5.0\nlength = 120.5\n[variables]\n"
                   "\"$TC_DP3[1,2]\" = 123.0\n\"$TC_DP6[1,2]\" = 2.5\n"},
                  {{"_OVR[4]", 0.0}, {"_OVR[104]", -2.97}, {"_OVR[904]", -1.485}});
}

}  // namespace
}  // namespace g31::testing::double_spindle_test
