// CYCLE800, tool carriers and TRAORI on the machines of the five-axis specification, and holes that
// are measured in tilted planes of machines by chance.

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Dense>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "machine/base/random.h"
#include "machine/kinematics/orientation.h"
#include "machine/kinematics/plane_rotation.h"
#include "tests/support/effort.h"
#include "tests/support/five_axis_run.h"
#include "tests/support/worked_machines.h"

namespace g31::testing::swivel_test {
namespace {

using namespace machine::worked;  // NOLINT(google-build-using-namespace)

/// A row of table 5.1: axes 1 and 2, XYZ at (0, 0, 0) and at (15, -10, 2) of the plane, of either
/// direction.
struct Swivelled {
  const char* id;
  std::string sheet;
  std::string axes;  ///< letters of rotary axes 1 and 2
  std::string call;  ///< between "CYCLE800(0,\"\"," and the direction
  std::vector<double> minus;
  std::vector<double> plus;
};

const Point kG54K1(40, -25, -380);
const Point kG54Head(300, 100, -500);

std::string k1_sheet() {
  return five_axis_sheet(k1(), kG54K1, {{'A', {-120, 120}}});
}
std::string k2_sheet() {
  return five_axis_sheet(k2(), {230, -120, -420}, {{'B', {-95, 110}}});
}
std::string k3_sheet() {
  return five_axis_sheet(k3(), {30, 40, -350}, {{'B', {-180, 180}}});
}
std::string k4_sheet() {
  return five_axis_sheet(k4(), kG54Head, {{'A', {-110, 110}}});
}
std::string k5_sheet() {
  return five_axis_sheet(k5(), kG54Head);
}
std::string k6_sheet() {
  return five_axis_sheet(k6(), {20, -30, -380}, {{'B', {0, 180}}});
}

std::vector<Swivelled> on_tables() {
  return {
      {"1",
       k1_sheet(),
       "AC",
       "0,57,10,20,5,30,0,0,0,0,0",
       {-30, 180, -40, -35.686533, -275.548095, -55, -25.686533, -273.548095},
       {30, 0, 50, 35.849365, -252.548095, 65, 25.849365, -250.548095}},
      {"2",
       k1_sheet(),
       "AC",
       "0,27,60,-40,-3,35,0,-25,0,0,0",
       {-25, 35, 47.257705, -124.574038, -323.489661, 62.257705, -134.574038, -321.489661},
       {25, -145, -37.257705, 122.883880, -304.049221, -52.257705, 132.883880, -302.049221}},
      {"3",
       k1_sheet(),
       "AC",
       "0,57,10,20,5,20,-15,40,3,4,-1",
       {-24.814217, 141.923749, -28.541239, -60.023455, -283.563200, -41.995893, -72.022301,
        -281.563200},
       {24.814217, -38.076251, 38.541239, 58.270480, -264.258044, 51.995893, 70.269326,
        -262.258044}},
      {"4",
       k1_sheet(),
       "AC",
       "0,64,0,0,0,50,35,0,0,0,0",
       {-35, -40, 45.952883, -34.367071, -282.614012, 55.952883, -19.367071, -280.614012},
       {35, 140, -35.952883, 36.686077, -256.229496, -45.952883, 21.686077, -254.229496}},
      {"5",
       k1_sheet(),
       "AC",
       "0,185,0,0,0,20,-15,10,0,0,0",
       {-24.321237, 143.640081, -36.228630, -32.552382, -276.934264, -53.622069, -37.292455,
        -274.934264},
       {24.321237, -36.359919, 46.228630, 30.634851, -257.989065, 63.622069, 35.374924,
        -255.989065}},
      {"6",
       k1_sheet(),
       "AC",
       "0,192,0,0,0,-40,25,0,0,0,0",
       {-40, 25, 27.423171, -69.219193, -313.485282, 42.423171, -79.219193, -311.485282},
       {-40, 25, 27.423171, -69.219193, -313.485282, 42.423171, -79.219193, -311.485282}},
      {"12",
       k6_sheet(),
       "BC",
       "0,27,12,-7,4,35,0,-25,0,0,0",
       {35.647727, 112.191412, -64.689870, 34.799734, -304.307445, -77.766452, 22.389939,
        -302.307445},
       {35.647727, 112.191412, -64.689870, 34.799734, -304.307445, -77.766452, 22.389939,
        -302.307445}},
      {"13",
       k1_sheet(),
       "AC",
       "0,57,0,0,0,0,0,30,0,0,0",
       {0, 0, 40, -25, -260, 57.990381, -26.160254, -258},
       {0, 0, 40, -25, -260, 57.990381, -26.160254, -258}},
  };
}

std::vector<Swivelled> under_heads() {
  return {
      {"7",
       k2_sheet(),
       "BC",
       "0,57,0,0,0,10,0,0,0,0,0",
       {-10, 90, 177.753624, -180, -302.821192, 167.558250, -195, -302.588059},
       {10, -90, 221.942531, -120, -306.294156, 232.137905, -105, -306.061022}},
      {"direct",
       k2_sheet(),
       "BC",
       "0,192,0,0,0,30,25,0,0,0,0",
       {30, 25, 388.528036, -135.489314, -345.192379, 402.518417, -145.489314, -350.960328},
       {30, 25, 388.528036, -135.489314, -345.192379, 402.518417, -145.489314, -350.960328}},
      {"8",
       k2_sheet(),
       "BC",
       "0,27,12,-7,4,35,0,-25,0,0,0",
       {-25, -55, 77.527313, -102.403356, -319.881481, 85.745154, -87.403356, -313.842683},
       {25, 125, 320.598843, -197.596644, -328.333847, 312.381002, -212.596644, -322.295048}},
      {"9",
       k3_sheet(),
       "BC",
       "0,27,12,-7,4,35,0,-25,0,0,0",
       {-35.647727, -42.191412, -96.131074, 76.548989, -249.891514, -84.792305, 89.353880,
        -243.852716},
       {35.647727, 112.191412, 119.778095, -27.461595, -249.891514, 115.090165, -43.910188,
        -243.852716}},
      {"10",
       k4_sheet(),
       "CA",
       "0,27,12,-7,4,35,0,-25,0,0,0",
       {-145, 25, 232.880481, 200.994383, -411.236299, 249.881322, 202.866368, -405.197500},
       {35, -25, 226.284883, 210.413874, -404.474406, 243.285723, 212.285859, -398.435608}},
      {"11",
       k5_sheet(),
       "CB",
       "0,27,12,-7,4,35,0,-25,0,0,0",
       {-42.191412, -35.647727, 252.333040, 181.713566, -400.359975, 269.333881, 183.585551,
        -394.321177},
       {112.191412, 35.647727, 244.345356, 176.120529, -400.359975, 261.346197, 177.992514,
        -394.321177}},
  };
}

const std::vector<std::string> kReadings = {"R1",  "R2",  "R11", "R12", "R13", "R21",
                                            "R22", "R23", "R31", "R32", "R33"};

std::string standing(const std::string& axes, const std::string& call, int direction) {
  return fmt::format(
      "T1 M6\nG54 D1\nCYCLE800(0,\"\",{},{})\nR1=$AA_IM[{}] R2=$AA_IM[{}]\nG0 X0 Y0 Z0\n"
      "R11=$AA_IM[X] R12=$AA_IM[Y] R13=$AA_IM[Z]\nX15 Y-10 Z2\n"
      "R21=$AA_IM[X] R22=$AA_IM[Y] R23=$AA_IM[Z]\n"
      "R31=$AA_IW[X] R32=$AA_IW[Y] R33=$AA_IW[Z]",
      call, direction, axes[0], axes[1]);
}

void expect_stand(const Swivelled& plane, int direction, const std::vector<double>& expected) {
  SCOPED_TRACE(fmt::format("{} {}", plane.id, direction));
  const MeasuringRun run =
      run_on_sheets(standing(plane.axes, plane.call, direction), {plane.sheet}, kReadings);
  ASSERT_EQ(run.alarm(), 0) << run.output.errors;
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(machine::within_half_turn(run.at(kReadings[i])), expected[i], 6e-7);
  }
  for (std::size_t i = 2; i < expected.size(); ++i) {
    EXPECT_NEAR(run.at(kReadings[i]), expected[i], 6e-7) << kReadings[i];
  }
  EXPECT_NEAR(run.at("R31"), 15.0, 1e-9);
  EXPECT_NEAR(run.at("R32"), -10.0, 1e-9);
  EXPECT_NEAR(run.at("R33"), 2.0, 1e-9);
}

TEST(Swivel, StandsWhereTheSpecificationHasIt) {
  for (const auto& planes : {on_tables(), under_heads()}) {
    for (const Swivelled& plane : planes) {
      expect_stand(plane, -1, plane.minus);
      expect_stand(plane, 1, plane.plus);
    }
  }
}

// Rotary values of a work offset turn no part: the tool is square to the plane at the same places.
TEST(Swivel, StandsThereWhateverAWorkOffsetSaysOfRotaryAxes) {
  for (const std::string mode : {"57,0,0,0,30,20,0", "192,0,0,0,25,-40,0"}) {
    for (const std::string on : {"", "TRAORI\n"}) {
      SCOPED_TRACE(on + mode);
      const auto stand = [&](const std::string& offset) {
        return run_on_sheets("T1 M6\n" + offset + "G54 D1\n" + on + "CYCLE800(0,\"\",0," + mode +
                                 ",0,0,0,1)\nR1=$AA_IM[A] R2=$AA_IM[C]",
                             {k1_sheet()}, {"R1", "R2"});
      };
      const MeasuringRun plain = stand("");
      ASSERT_EQ(plain.alarm(), 0) << plain.output.errors;
      const MeasuringRun shifted = stand("$P_UIFR[1,A,TR]=7 $P_UIFR[1,C,TR]=-11\n");
      ASSERT_EQ(shifted.alarm(), 0) << shifted.output.errors;
      expect_values(shifted, {{"R1", plain.at("R1")}, {"R2", plain.at("R2")}}, 1e-9);
      EXPECT_GT(std::abs(plain.at("R1")) + std::abs(plain.at("R2")), 10.0);
    }
  }
}

// In both systems of inches the lengths of the call are those of the program.
TEST(Swivel, TakesItsLengthsInInches) {
  for (const auto& [code, unit] :
       {std::pair("G71", 1.0), std::pair("G70", 25.4), std::pair("G700", 25.4)}) {
    SCOPED_TRACE(code);
    const MeasuringRun run =
        run_on_sheets("T1 M6\nG54 D1\n" + std::string(code) +
                          "\nCYCLE800(0,\"\",0,57,1,0,0,0,0,90,2,0,0,1)\nG71\nG0 X0 Y0 Z0\n"
                          "R1=$AA_IW[X] R2=$P_WPFRAME[X,TR] R3=$P_WPFRAME[Y,TR]",
                      {k1_sheet()}, {"R1", "R2", "R3"});
    ASSERT_EQ(run.alarm(), 0) << run.output.errors;
    expect_values(run, {{"R1", 0.0}, {"R2", unit}, {"R3", 2.0 * unit}}, 1e-9);
  }
}

/// A call that raises an alarm: nothing has moved and no frame is written.
void expect_refused(const std::string& sheet, const std::string& call, int alarm,
                    const std::string& before = {}) {
  SCOPED_TRACE(call);
  const MeasuringRun run =
      run_on_sheets("T1 M6\nG54 D1\nG0 X1 Y2 Z3\n" + before + "\n" + call, {sheet},
                    {"$P_WPFRAME[X,TR]", "$AA_IW[X]", "$AA_IM[A]", "$AA_IM[B]", "$AA_IM[C]"});
  EXPECT_EQ(run.alarm(), alarm) << run.output.errors;
  EXPECT_EQ(run.at("$P_WPFRAME[X,TR]"), 0.0);
  EXPECT_EQ(run.at("$AA_IW[X]"), 1.0);
  for (const char* const axis : {"$AA_IM[A]", "$AA_IM[B]", "$AA_IM[C]"}) {
    EXPECT_FALSE(run.at(axis) > 0.0 || run.at(axis) < 0.0) << "an axis that is there stands at 0";
  }
}

TEST(Swivel, WhatCannotBeReachedIsAnAlarm) {
  const std::string two = "$TC_CARR1[2]=0 $TC_CARR7[2]=1 $TC_CARR12[2]=1\n$TC_CARR34[1]=\"T1\"";
  expect_refused(k1_sheet(), "CYCLE800(0,\"\",0,57,1,0,0,170,0,0,0,0,0,-1)", 61184);
  expect_refused(k2_sheet(), "CYCLE800(0,\"\",0,57,1,0,0,120,0,0,0,0,0,1)", 61184);
  expect_refused(k3_sheet(), "CYCLE800(0,\"\",0,57,1,0,0,100,0,0,0,0,0,-1)", 61184);
  expect_refused(k1_sheet(), "CYCLE800(0,\"\",0,192,1,0,0,130,0,0,0,0,0,-1)", 61189);
  expect_refused(k1_sheet(), "CYCLE800(0,\"X\",0,57,1,0,0,10,0,0,0,0,0,-1)", 61182);
  expect_refused(k1_sheet(), "CYCLE800(3,\"\",0,57,1,0,0,10,0,0,0,0,0,-1)", 61183);
  expect_refused(k1_sheet(), "CYCLE800(0,\"\",0,57,1,0,0,10,0,0,0,0,0,-1)", 61180, two);
  expect_refused(k1_sheet(), "CYCLE800(0,\"\",0,57,1,0,0,10,0,0,0,0,0,-1)", 61185,
                 "$TC_CARR30[1]=5 $TC_CARR32[1]=-5");
  expect_refused(k1_sheet(), "CYCLE800(0,\"\",0,57,1,0,0,10,0,0,0,0,0,-1)", 61188,
                 "$TC_CARR35[1]=\"\"");
  expect_refused(
      std::string("[control]\nprofile = \"sinumerik-828d\"\n[tools.1]\nlength = 120.0\n"),
      "CYCLE800(0,\"\",0,57,1,0,0,10,0,0,0,0,0,-1)", 61181);
  const std::string far = "$TC_CARR38[1]=90000 $TC_CARR39[1]=-90000 $TC_CARR40[1]=90000";
  for (const char* const mode : {"1", "2", "6", "7", "8"}) {
    expect_refused(k1_sheet(), "CYCLE800(" + std::string(mode) + ",\"\",0,57,1,0,0,10,0,0,0,0,0,1)",
                   61190, far);
  }
  expect_refused(k1_sheet(), "CYCLE800(5,\"\",0,57,1,0,0,10,0,0,0,0,0,1,90000)", 61153);
  for (const char* const before : {"", "TRAORI"}) {
    expect_refused(k1_sheet(), "CYCLE800(5,\"\",0,57,1,0,0,10,0,0,0,0,0,1,90000)", 61153, before);
  }
  expect_refused(k1_sheet(), "CYCLE800(0,\"\",300,57,1,0,0,10,0,0,0,0,0,1)", 61002);
  expect_refused(k1_sheet(), "CYCLE800(0,\"\",100,57,1,0,0,10,0,0,0,0,0,1)", 61197);
  expect_refused(k1_sheet(), "CYCLE800(0,\"\",10,57,1,0,0,10,0,0,0,0,0,1)", 61191,
                 "$MC_TRAFO_TYPE_1=0");
  expect_refused(k1_sheet(), "CYCLE800(0,\"\",10,57,1,0,0,10,0,0,0,0,0,1)", 61192,
                 "$MC_TRAFO5_TCARR_NO_1=2");
  expect_refused(k1_sheet(), "CYCLE800(0,\"\",0,57,1,0,0,10,0,0,0,0,0,1)", 61198,
                 "$TC_CARR_KIN_ROTAX_NAME[2,0]=\"A\" $TC_CARR_KIN_ROTAX_NAME[2,1]=\"B\" "
                 "$TC_CARR_KIN_ROTAX_NAME[2,2]=\"C\"");
}

/// The tool is turned, the coordinates stay: the axes stand where the turned length has them.
TEST(Swivel, AnAlignedToolLeavesTheCoordinates) {
  struct Aligned {
    std::string sheet;
    std::string call;  ///< from _MODE on
    Point lengths;     ///< of the turned tool, by the specification
    Point origin;
  };
  const Aligned rows[] = {
      {k2_sheet(), "57,0,0,0,0,30,0,0,0,0,1", {148.660254, 0, 74.807621}, {230, -120, -420}},
      {k2_sheet(), "192,0,0,0,90,0,0,0,0,0,1", {290, 0, -190}, {230, -120, -420}},
      {k4_sheet(), "192,0,0,0,30,-40,0,0,0,0,1", {-112.709716, 190.218954, 45.597412}, kG54Head},
      {k5_sheet(), "192,0,0,0,60,90,0,0,0,0,1", {-24.989548, 221.716833, -10}, kG54Head}};
  for (const Aligned& row : rows) {
    for (const char* const kind : {"100", "200"}) {
      SCOPED_TRACE(row.call + " " + kind);
      const MeasuringRun run = run_on_sheets(
          "T1 M6\nG54 D1\n$TC_CARR37[1]=10000\nCYCLE800(0,\"\"," + std::string(kind) + "," +
              row.call + ")\nG0 X0 Y0 Z0\nR1=$AA_IM[X] R2=$AA_IM[Y] R3=$AA_IM[Z]\n" +
              "R4=ABS($P_ACTFRAME[X,RT])+ABS($P_ACTFRAME[Y,RT])+ABS($P_ACTFRAME[Z,RT])",
          {row.sheet}, {"R1", "R2", "R3", "R4"});
      ASSERT_EQ(run.alarm(), 0) << run.output.errors;
      const Point q = row.origin + row.lengths;
      expect_values(run, {{"R1", q.x()}, {"R2", q.y()}, {"R3", q.z()}, {"R4", 0.0}}, 6e-7);
    }
  }
  // On top of a swivelled plane that one stays.
  const MeasuringRun run = run_on_sheets(
      "T1 M6\nG54 D1\n$TC_CARR37[1]=10000\nCYCLE800(0,\"\",0,57,0,0,0,0,20,0,0,0,0,1)\n"
      "CYCLE800(0,\"\",101,57,0,0,0,0,10,0,0,0,0,1)\nR1=$AA_IM[B] R2=$P_WPFRAME[Y,RT]",
      {k2_sheet()}, {"R1", "R2"});
  expect_values(run, {{"R1", 30.0}, {"R2", 20.0}}, 1e-9);
}

/// Under TRAORI the retraction goes along the tool as the head holds it, and the transformation
/// that was active comes back.
TEST(Swivel, ARetractionUnderTraoriGoesAlongTheTool) {
  for (const char* const before : {"TRAORI\nB30\n", "TRAORI\nB30 C70\n"}) {
    SCOPED_TRACE(before);
    const MeasuringRun run = run_on_sheets(
        "T1 M6\nG54 D1\nG0 X0 Y0 Z50\n" + std::string(before) +
            "R1=$AA_IM[X] R2=$AA_IM[Y] R3=$AA_IM[Z]\n_SC_RETRACT(1,5,40)\n"
            "R1=$AA_IM[X]-R1 R2=$AA_IM[Y]-R2 R3=$AA_IM[Z]-R3 R4=$P_TRAFO_PARSET R5=$P_TC",
        {k2_sheet()}, {"R1", "R2", "R3", "R4", "R5"});
    ASSERT_EQ(run.alarm(), 0) << run.output.errors;
    expect_values(run, {{"R1", 20.0}, {"R2", 0.0}, {"R3", 34.641016151}, {"R4", 1.0}, {"R5", 0.0}},
                  1e-8);
  }
}

/// The plane lies on the first record's axes; another one is not put on top of it.
TEST(Swivel, AnAdditivePlaneKeepsItsDataRecord) {
  const std::string two =
      "$TC_CARR34[1]=\"ONE\" $TC_CARR34[2]=\"TWO\" $TC_CARR7[2]=1 $TC_CARR12[2]=1\n"
      "$TC_CARR35[2]=\"A\" $TC_CARR36[2]=\"C\"\nCYCLE800(0,\"ONE\",0,57,0,0,0,0,0,0,0,0,0,1)";
  expect_refused(k1_sheet(), "CYCLE800(0,\"TWO\",1,57,1,0,0,10,0,0,0,0,0,1)", 61199, two);
  const MeasuringRun run = run_on_sheets(
      "T1 M6\nG54 D1\n" + two + "\nCYCLE800(0,\"ONE\",1,57,0,0,0,10,0,0,0,0,0,1)\nR1=$P_TC",
      {k1_sheet()}, {"R1"});
  expect_values(run, {{"R1", 1.0}}, 0.0);
}

struct Held {
  std::string sheet;
  std::string axes;
  std::string turned;  ///< words of the rotary axes
  Point xyz;
};

TEST(Swivel, TraoriHoldsTheTipAsTheSpecificationWorksItOut) {
  const std::vector<Held> rows = {
      {k1_sheet(), "AC", "A35 C-70", {66.698399, 85.312448, -278.070302}},
      {k1_sheet(), "AC", "A-60 C110", {-56.698399, -84.139619, -350.375112}},
      {k1_sheet(), "AC", "A90 C45", {21.263456, 100, -231.339574}},
      {k2_sheet(), "BC", "B35 C-70", {381.388734, -90.198241, -349.990151}},
      {k2_sheet(), "BC", "B-90 C110", {-121.124282, -209.801759, -580}},
      {k3_sheet(), "BC", "B90 C30", {242.273753, 114.820508, -347.5}},
      {k3_sheet(), "BC", "B180 C-45", {28.284271, 311.568542, -475}},
      {k4_sheet(), "CA", "C30 A-40", {217.290284, 270.218954, -444.402588}},
      {k4_sheet(), "CA", "C-120 A75", {55.049636, 233.742667, -629.728931}},
      {k5_sheet(), "CB", "C60 B90", {305.010452, 301.716833, -500}},
      {k5_sheet(), "CB", "C-135 B180", {517.383297, -112.383297, -630}},
      {k6_sheet(), "BC", "B60 C25", {-15.895858, -49.029210, -274.464075}},
      {k6_sheet(), "BC", "B180 C90", {145, -10, -295}},
  };
  for (const Held& row : rows) {
    SCOPED_TRACE(row.turned);
    const MeasuringRun run = run_on_sheets(
        "T1 M6\nG54 D1\nTRAORI\nG0 X30 Y-20 Z10\n" + row.turned +
            "\nR1=$AA_IM[X] R2=$AA_IM[Y] R3=$AA_IM[Z]\nR4=$AA_IW[X] R5=$AA_IW[Y] R6=$AA_IW[Z]",
        {row.sheet}, {"R1", "R2", "R3", "R4", "R5", "R6"});
    ASSERT_EQ(run.alarm(), 0) << run.output.errors;
    EXPECT_NEAR(run.at("R1"), row.xyz.x(), 6e-7);
    EXPECT_NEAR(run.at("R2"), row.xyz.y(), 6e-7);
    EXPECT_NEAR(run.at("R3"), row.xyz.z(), 6e-7);
    EXPECT_NEAR(run.at("R4"), 30.0, 1e-10);
    EXPECT_NEAR(run.at("R5"), -20.0, 1e-10);
    EXPECT_NEAR(run.at("R6"), 10.0, 1e-10);
  }
}

/// Of two ways to stand for a direction STAT takes the nearer or the other one, TU the side of 0.
/// The direction is that of the specification's tilted plane I35 J-25.
TEST(Swivel, PointToPointStatAndTuSayHowTheAxesStand) {
  const std::string to = "A3=-0.242403876506104 B3=0.346188613058634 C3=0.906307787036650";
  struct Row {
    std::string words;
    double a;
    double c;
  };
  const Row rows[] = {{"CP " + to, -25, 35},
                      {"PTP " + to, -25, 35},
                      {"PTP STAT=0 " + to, -25, 35},
                      {"PTP STAT=1 " + to, 25, -145},
                      {"CP STAT=1 " + to, -25, 35},
                      {"PTP STAT='B1' TU='B000000' " + to, 25, 215},
                      {"PTP STAT=1 TU=32 " + to, 25, -145},
                      {"PTP TU=32 " + to, -25, -325},
                      {"PTP TU='B1000' " + to, -25, 35},
                      // STAT stays, TU does not.
                      {"PTP STAT=1 TU=0 " + to + "\nA0 C0\n" + to, 25, -145},
                      // The axes go no further than 110 degrees: TU finds no other turn of A.
                      {"PTP TU=0 " + to, -25, 35}};
  for (const Row& row : rows) {
    SCOPED_TRACE(row.words);
    const MeasuringRun run =
        run_on_sheets("T1 M6\nG54 D1\nTRAORI\nG0 X10 Y20 Z30\n" + row.words +
                          "\nR1=$AA_IM[A] R2=$AA_IM[C] R3=$AA_IW[X] R4=$AA_IW[Y] R5=$AA_IW[Z]",
                      {five_axis_sheet(k1(), kG54K1, {{'A', {-120, 120}}, {'C', {-360, 360}}})},
                      {"R1", "R2", "R3", "R4", "R5"});
    EXPECT_EQ(run.alarm(), 0) << run.output.errors;
    expect_values(run, {{"R1", row.a}, {"R2", row.c}, {"R3", 10.0}, {"R4", 20.0}, {"R5", 30.0}},
                  1e-9);
  }
  // An axis that goes round and round takes the shorter way, whatever TU says.
  const MeasuringRun endless = run_on_sheets(
      "T1 M6\nG54 D1\nTRAORI\nG0 X10 Y20 Z30\nPTP STAT=1 TU=0 " + to + "\nR2=$AA_IM[C]",
      {k1_sheet()}, {"R2"});
  expect_values(endless, {{"R2", -145.0}}, 1e-9);
  for (const char* const wrong : {"STAT=2 X5", "TU=64 X5", "TU=0.5 X5"}) {
    const MeasuringRun run = run_on_sheets(
        "T1 M6\nG54 D1\nTRAORI\nG0 X1\nPTP " + std::string(wrong), {k1_sheet()}, {"$AA_IW[X]"});
    EXPECT_EQ(run.alarm(), 12560) << run.output.errors;
    EXPECT_NEAR(run.at("$AA_IW[X]"), 1.0, 1e-9);
  }
}

/// A machine by chance: one of the six, its lines moved and tilted.
machine::AxisChainSetup by_chance(std::uint64_t& n, std::size_t which) {
  const auto random = [&n](double most) { return most * (2.0 * uniform({22, 6}, n++) - 1.0); };
  machine::AxisChainSetup chain = std::vector{k1(), k2(), k3(), k4(), k5(), k6()}.at(which % 6);
  for (machine::RotaryLine& line : chain.rotary) {
    line.p_M_centre += Point(random(20), random(20), random(20));
    line.axis_M += Point(random(0.02), random(0.02), random(0.02));
  }
  return chain;
}

TEST(Swivel, AHoleInATiltedPlaneReadsItsTrueSizeAndPlace) {
  std::uint64_t n = 0;
  const auto random = [&n](double most) { return most * (2.0 * uniform({22, 6}, n++) - 1.0); };
  double worst = 0.0;
  int measured = 0;
  const int runs = of_many(200);
  for (int i = 0; i < runs; ++i) {
    const machine::AxisChainSetup chain = by_chance(n, static_cast<std::size_t>(i));
    const Point offset(random(100), random(100), -400 + random(30));
    const Point before(random(40), random(40), random(20));
    const Point angles(random(35), random(35), random(60));
    const Point after(random(5), random(5), random(3));
    const Point aside(random(0.3), random(0.3), 0.0);
    const double bore = 30.0 + random(5.0);
    const Eigen::Matrix3d tilt = machine::about_turned_axes(
        {machine::AxisTurn{0, angles[0]}, {1, angles[1]}, {2, angles[2]}});
    const Point at = before + tilt * (after + aside);
    // The ring is turned about X, then Y, then Z.
    const Point turned(std::atan2(tilt(2, 1), tilt(2, 2)), std::asin(-tilt(2, 0)),
                       std::atan2(tilt(1, 0), tilt(0, 0)));
    const Point rotate = turned * 180.0 / std::numbers::pi;
    const std::string ring = fmt::format(
        "[[part]]\nname = \"ring\"\nshape = \"ring\"\non = \"G54\"\nat = [{:.17g}, {:.17g}, "
        "{:.17g}]\nrotate_deg = [{:.17g}, {:.17g}, {:.17g}]\nbore = {:.17g}\n",
        at.x(), at.y(), at.z(), rotate.x(), rotate.y(), rotate.z(), bore);
    const std::string program = fmt::format(
        "T1 M6\nG54 D1\n{}CYCLE800(0,\"\",{},57,{:.12f},{:.12f},{:.12f},{:.12f},{:.12f},{:.12f},"
        "{:.12f},{:.12f},{:.12f},{})\nG0 X0 Y0 Z50\nZ-5\nCYCLE977(1,,,1,{:.3f},,,2,5)\n",
        i % 4 == 1 ? "TRAORI\n" : "", i % 3 == 0 ? 10 : 0, before.x(), before.y(), before.z(),
        angles.x(), angles.y(), angles.z(), after.x(), after.y(), after.z(), i % 2 == 0 ? 1 : -1,
        bore + 0.05);
    const MeasuringRun run = run_on_sheets(program, {five_axis_sheet(chain, offset), ring},
                                           {"_OVR[4]", "_OVR[5]", "_OVR[6]"});
    SCOPED_TRACE(fmt::format("set-up {}\n{}", i, program));
    ASSERT_EQ(run.alarm(), 0) << run.output.errors;
    worst = std::max({worst, std::abs(run.at("_OVR[4]") - bore),
                      std::abs(run.at("_OVR[5]") - aside.x()),
                      std::abs(run.at("_OVR[6]") - aside.y())});
    ++measured;
  }
  EXPECT_EQ(measured, runs);
  EXPECT_LT(worst, 1e-6);
  std::printf("worst of %d holes %.3g mm\n", measured, worst);
}

TEST(Swivel, AHoleReadsOffByWhatTheControlBelievesWrongly) {
  // The centre of C is believed off by e: the tip is R e - e from where the control has it.
  const Point e(0.03, -0.02, 0.0);
  machine::AxisChainSetup believed = k1();
  believed.rotary[2].p_M_centre += e;
  const Eigen::Matrix3d tilt =
      machine::about_turned_axes({machine::AxisTurn{2, 35.0}, {1, 0.0}, {0, -25.0}});
  const Point off = tilt.transpose() * (machine::turn_about(machine::AxisTurn{2, 35.0}) * e - e);
  const std::string ring =
      "[[part]]\nname = \"ring\"\nshape = \"ring\"\non = \"G54\"\nat = [60.0, -40.0, -3.0]\n"
      "rotate_deg = [-25.0, 0.0, 35.0]\nbore = 30.0\n";
  const std::string program =
      "T1 M6\nG54 D1\nCYCLE800(0,\"\",0,27,60,-40,-3,35,0,-25,0,0,0,-1)\nG0 X0 Y0 Z50\nZ-5\n"
      "CYCLE977(1,,,1,30,,,2,5)\n";
  const std::vector<std::string> names = {"_OVR[4]", "_OVR[5]", "_OVR[6]"};
  const MeasuringRun right = run_on_sheets(program, {k1_sheet(), ring}, names);
  const MeasuringRun wrong =
      run_on_sheets(program, {k1_sheet(), ring, believed_sheet(believed)}, names);
  ASSERT_EQ(wrong.alarm(), 0) << wrong.output.errors;
  EXPECT_NEAR(right.at("_OVR[5]"), 0.0, 1e-9);
  EXPECT_NEAR(wrong.at("_OVR[4]"), 30.0, 1e-9);
  EXPECT_NEAR(wrong.at("_OVR[5]"), -off.x(), 1e-9);
  EXPECT_NEAR(wrong.at("_OVR[6]"), -off.y(), 1e-9);
  EXPECT_GT(off.norm(), 0.02);
}

}  // namespace
}  // namespace g31::testing::swivel_test
