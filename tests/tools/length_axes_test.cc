// The lengths of a tool as SD42940, SD42950 and MD20360 have them, in the measuring cycles that
// measure tools or correct them.

#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/tool_measuring_run.h"
#include "tests/support/turning_run.h"

namespace g31::testing::length_axes_test {
namespace {

constexpr double kExactly = 1e-6;  // mm

/// A turning tool of 50 and 80 mm; of the lengths that the test writes the cycle knows.
constexpr const char* kTurret = R"([machine]
tool_side = "ZX"
[tools.5]
radius = 0.4
type = 500.0
[[tool]]
number = 5
kind = "turning"
lengths = [50.0, 80.0, 0.0]
tip_radius = 0.4
edge_position = 3
[machine_data]
"$SNS_MEA_TPW_TRIG_MINUS_DIR_AX1[0]" = -200.0
"$SNS_MEA_TPW_TRIG_PLUS_DIR_AX1[0]" = -220.0
"$SNS_MEA_TPW_TRIG_MINUS_DIR_AX2[0]" = 110.0
"$SNS_MEA_TPW_TRIG_PLUS_DIR_AX2[0]" = 90.0
"$SNS_MEA_TPW_FEED[0]" = 300.0
)";

std::string machine_datum(const std::string& name, int value) {
  return fmt::format("[machine_data]\n\"{}\" = {}\n", name, value);
}

std::string parameter_mask(int bits) {
  return machine_datum("$MC_TOOL_PARAMETER_DEF_MASK", bits);
}

/// Data of the turning tool, and the tool beside the tool probe.
std::string at_plate(double length, double wear, const std::string& more = "") {
  return fmt::format(
      "$TC_DP3[5,1]={:.3f} $TC_DP12[5,1]={:.3f} $TC_DP4[5,1]=79.6 $TC_DP2[5,1]=3\n"
      "T5 M6\nG18 G500 D1 DIAMOF {}\nG0 SUPA X300 Z-150\n",
      length, wear, more);
}

void expect_lengths(const std::string& body, const std::vector<std::string>& sheets,
                    const std::vector<ExpectedValue>& expected) {
  std::vector<std::string> all = {kLatheProbe, kTurret};
  all.insert(all.end(), sheets.begin(), sheets.end());
  expect_values(run_on_sheets(body, all, names_of(expected, {})), expected, kExactly);
}

struct MaskedCase {
  int mask = 0;
  double length = 0.0;      ///< $TC_DP3 before
  double wear = 0.0;        ///< $TC_DP12 before: with the length 50.35 mm
  double new_wear = 0.0;    ///< measured again, $TC_DP12
  double new_length = 0.0;  ///< measured first, $TC_DP3
};

/// The tool is 50 mm long, whatever its data count in; machine and work coordinates are the same.
TEST(LengthAxes, MeasuredToolsHaveDiametersWhereTheirDataHave) {
  constexpr MaskedCase kCases[] = {
      {0, 50.3, 0.05, -0.3, 50.0},
      {1, 50.3, 0.1, -0.6, 50.0},
      {2, 100.6, 0.05, -0.3, 100.0},
      {3, 100.6, 0.1, -0.6, 100.0},
  };
  for (const MaskedCase& row : kCases) {
    for (const int system : {2, 12}) {
      SCOPED_TRACE(fmt::format("MD20360 {}, S_MVAR {}", row.mask, system));
      const std::string begin = at_plate(row.length, row.wear);
      expect_lengths(
          begin + fmt::format("CYCLE982({},1,1,0,0,0,5,2,,,,0.0001,1)\nR1=$P_TOOLL[1]", system),
          {parameter_mask(row.mask)},
          {{"$TC_DP12[5,1]", row.new_wear},
           {"$TC_DP3[5,1]", row.length},
           {"R1", 50.0},
           {"_OVR[8]", 50.0},
           {"_OVR[9]", -0.35},
           {"$TC_DP13[5,1]", 0.4}});
      expect_lengths(
          begin + fmt::format("CYCLE982({},0,1,2,0,0,5,2,,,,0.0001,1)\nR1=$P_TOOLL[1]", system - 1),
          {parameter_mask(row.mask)},
          {{"$TC_DP3[5,1]", row.new_length},
           {"$TC_DP12[5,1]", 0.0},
           {"R1", 50.0},
           {"_OVR[8]", 50.0},
           {"_OVR[20]", row.mask >= 2 ? -0.7 : -0.35}});
    }
  }
}

/// What DL adds acts with the edge: afterwards the lengths that act are the true ones.
TEST(LengthAxes, MeasuredToolsActAsTheyAreWithAnAdditiveOffset) {
  for (const int system : {2, 12}) {
    SCOPED_TRACE(system);
    expect_lengths(
        "$TC_SCP13[5,1]=0.05 $TC_SCP14[5,1]=0.04\n" + at_plate(50.3, 0.0, "DL=1") +
            fmt::format("CYCLE982({},1,1,0,0,0,5,2,,,,0.0001,1)\nR1=$P_TOOLL[1] R2=$P_TOOLL[2] "
                        "R3=$P_DLNO",
                        system),
        {},
        {{"$TC_DP12[5,1]", -0.35},
         {"$TC_DP13[5,1]", 0.36},
         {"R1", 50.0},
         {"R2", 80.0},
         {"R3", 1.0},
         {"_OVR[9]", -0.35},
         {"_OVR[8]", 49.95}});
  }
}

/// With a negative SD42940 the lengths of turning tools change places.
TEST(LengthAxes, MeasuredLengthsGoWhereTheyCount) {
  const std::string begin =
      "$TC_DP3[5,1]=79.6 $TC_DP4[5,1]=50.3 $TC_DP2[5,1]=3\nT5 M6\nG18 G500 D1 DIAMOF\n"
      "G0 SUPA X300 Z-150\n";
  for (const int system : {2, 12}) {
    expect_lengths(
        begin + fmt::format("CYCLE982({},0,1,0,0,0,5,2,,,,0.0001,1)", system),
        {machine_datum("$SC_TOOL_LENGTH_CONST_T", -18)},
        {{"$TC_DP3[5,1]", 80.0}, {"$TC_DP4[5,1]", 50.0}, {"_OVR[9]", 0.4}, {"_OVR[11]", -0.3}});
  }
}

/// A shaft of 50.04 mm: 0.02 more on the radius than the tool was to leave.
TEST(LengthAxes, TurnedPartsCorrectTheLengthThatCounts) {
  const std::string shaft = part("shaft", 0.0, 0.0, 200.0, "diameter = 50.04\nheight = 100.0");
  const std::string outside = "G54 DIAMON G0 X100\nZ-10\nCYCLE974(202,,{},1,50,2,3,5,,1,\"{}\")";
  const std::string face =
      "G54 DIAMON G0 X100\nZ20\nX20\nCYCLE974(200,,1,1,0.2,1,3,5,,1,\"DRILL\")";
  const auto expect = [&](const std::string& body, const std::string& data,
                          const std::vector<ExpectedValue>& expected) {
    expect_turned(body, {kProbeToMinusX, kCalibrated, shaft, data}, expected);
  };
  const std::string as_turning = machine_datum("$SC_TOOL_LENGTH_TYPE", 2);
  const auto outside_by = [&](int number, const char* tool) {
    return fmt::format(fmt::runtime(outside), number, tool);
  };
  expect(outside_by(1, "DRILL"), as_turning,
         {{"$TC_DP12[3,1]", -0.02}, {"$TC_DP13[3,1]", 0.0}, {"$TC_DP14[3,1]", 0.0}});
  expect(face, as_turning,
         {{"$TC_DP13[3,1]", 0.2}, {"$TC_DP12[3,1]", 0.0}, {"$TC_DP14[3,1]", 0.0}});
  // The lengths of the probe change places, too: as those of mills, and with a sign.
  constexpr const char* kProbeAsMill =
      "[tools.1]\nlength = 0.0\n[variables]\n\"$TC_DP4[1,1]\" = 100.0\n\"$TC_DP5[1,1]\" = 30.0\n";
  constexpr const char* kProbeSwapped =
      "[tools.1]\nlength = 30.0\n[variables]\n\"$TC_DP4[1,1]\" = 100.0\n";
  expect(outside_by(1, "ROUGHER"), kProbeAsMill + machine_datum("$SC_TOOL_LENGTH_TYPE", 1),
         {{"$TC_DP13[2,1]", -0.02}, {"$TC_DP12[2,1]", 0.0}});
  expect(outside_by(1, "ROUGHER"), kProbeSwapped + machine_datum("$SC_TOOL_LENGTH_CONST_T", -18),
         {{"$TC_DP13[2,1]", -0.02}, {"$TC_DP12[2,1]", 0.0}});
  // SD42940 = 17: X is the 1st axis, of which a drill has length 3; turning tools by SD42942.
  expect(outside_by(1, "DRILL"),
         machine_datum("$SC_TOOL_LENGTH_CONST", 17) + "\"$SC_TOOL_LENGTH_CONST_T\" = 18\n",
         {{"$TC_DP14[3,1]", -0.02}, {"$TC_DP13[3,1]", 0.0}});
  // Only a length across the spindle is a diameter.
  expect(outside_by(200001, "ROUGHER"), parameter_mask(1), {{"$TC_DP13[2,1]", -0.02}});
}

/// The face of a block lies 0.03 too low, on a machine that turns and mills.
TEST(LengthAxes, AFaceCorrectsTheLengthAlongItsAxis) {
  constexpr const char* kProbe = "[tools.1]\nlength = 0.0\n[variables]\n\"$TC_DP4[1,1]\" = 120.0\n";
  const std::string face = "G17 G0 X0 Y0 Z5\nCYCLE978(200,,{},1,0,3,5,3,2,1,\"MILL\",1)";
  const std::string block = part("block", 100.0, 50.0, -300.03);
  const std::string turn_mill =
      machine_datum("$SC_TOOL_LENGTH_CONST", 18) + "\"$SC_TOOL_LENGTH_TYPE\" = 2\n";
  const auto face_by = [&](int number) { return fmt::format(fmt::runtime(face), number); };
  expect_measured(face_by(1), {block, kCalibrated, kProbe, turn_mill},
                  {{"$TC_DP13[2,1]", 0.03}, {"$TC_DP12[2,1]", 0.0}, {"_OVR[4]", -0.03}}, kExactly);
  expect_measured("$TC_SCP14[2,1]=0\n" + face_by(1000001), {block, kCalibrated, kProbe, turn_mill},
                  {{"$TC_SCP14[2,1]", 0.03}, {"$TC_DP13[2,1]", 0.0}}, kExactly);
  expect_measured(face_by(1), {block, kCalibrated},
                  {{"$TC_DP12[2,1]", 0.03}, {"$TC_DP13[2,1]", 0.0}}, kExactly);
}

/// A mill of 100 mm whose length 2 is along it.
TEST(LengthAxes, AMillIsMeasuredInTheLengthAlongIt) {
  const std::string turn_mill =
      machine_datum("$SC_TOOL_LENGTH_CONST", 18) + "\"$SC_TOOL_LENGTH_TYPE\" = 2\n";
  expect_tools(
      "$TC_DP3[5,1]=0 $TC_DP4[5,1]=100.3\nT5 M6\nG17 D1\nG0 SUPA X200 Y0 Z-100\n"
      "CYCLE971(1,0,1,3,2,0,5,2,,0.0001,1,1)",
      {kCube, kKnown, turn_mill},
      {{"$TC_DP4[5,1]", 100.0}, {"$TC_DP3[5,1]", 0.0}, {"_OVR[8]", 100.0}, {"_OVR[9]", -0.3}},
      kExactly);
}

/// CYCLE976 finds the length of the probe where it counts.
TEST(LengthAxes, TheProbeIsCalibratedInTheLengthAlongIt) {
  const std::string turn_mill =
      machine_datum("$SC_TOOL_LENGTH_CONST", 18) + "\"$SC_TOOL_LENGTH_TYPE\" = 2\n";
  constexpr const char* kProbe =
      "[tools.1]\nlength = 0.0\n[variables]\n\"$TC_DP4[1,1]\" = 120.02\n";
  expect_measured("G17 G0 X0 Y0 Z5\nCYCLE976(1000000,1,0,,,,5,5)",
                  {part("block", 100.0, 50.0, -300.0), kProbe, turn_mill},
                  {{"$TC_DP4[1,1]", 120.0}, {"$TC_DP3[1,1]", 0.0}, {"_OVR[22]", 120.0}}, kExactly);
}

}  // namespace
}  // namespace g31::testing::length_axes_test
