// CYCLE997 with one ball: every way round it finds centre and diameter, the work offset follows.

#include <cstddef>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/effort.h"
#include "tests/support/measuring_run.h"

namespace g31::testing::ball_cycle_test {
namespace {

/// Its centre lies (-0.2, 0.3, 0.15) from where it should be, and it is 25.012 mm wide.
std::string ball() {
  return part("sphere", 99.8, 50.3, -299.85, "diameter = 25.012");
}

std::vector<ExpectedValue> found(double diameter) {
  const double z = 0.15 + 0.5 * (25.012 - diameter);  // the pole is what it is
  return {{"_OVR[0]", 25.0},   {"_OVR[1]", 0.0},      {"_OVR[2]", 0.0},
          {"_OVR[3]", 0.0},    {"_OVR[4]", diameter}, {"_OVR[5]", -0.2},
          {"_OVR[6]", 0.3},    {"_OVR[7]", z},        {"_OVR[8]", diameter - 25.0},
          {"_OVR[9]", -0.2},   {"_OVR[10]", 0.3},     {"_OVR[11]", z},
          {"_OVR[28]", 5.0},   {"_OVI[0]", 0.0},      {"_OVI[2]", 997.0},
          {"_OVI[5]", 1.0},    {"_OVI[9]", 0.0},      {"_OVI[12]", 0.0},
          {"$AA_IW[X]", -0.2}, {"$AA_IW[Y]", 0.3},    {"$AA_IW[Z]", 20.0}};
}

/// The touches that gave a signal.
std::vector<nlohmann::json> signals_of(const MeasuringRun& run) {
  std::vector<nlohmann::json> signals;
  for (const auto& touch : run.output.document.at("touches")) {
    if (touch.value("triggered", false)) {
      signals.push_back(touch);
    }
  }
  return signals;
}

struct Way {
  const char* name;
  int variant;          ///< S_MVAR without its millions
  std::size_t equator;  ///< points on it
  const char* angles;   ///< S_STA1, S_INCA
};

const Way kWays[] = {
    {"along the axes", 9, 4, ","},
    {"round, three points", 1009, 3, "20,120"},
    {"round, three points backwards", 1009, 3, "-75,-80"},
    {"round, four points", 101009, 4, "10,90"},
    {"round, four points close together", 101009, 4, "200,35"},
    {"round, probe turned along", 102009, 4, "0,90"},
    {"over the pole, three points", 3009, 3, "15,"},
    {"over the pole, four points", 103009, 4, "15,"},
    {"over the pole, probe turned along", 104009, 4, "-30,"},
};

std::string call(const Way& way, int more, const char* diameter = "25") {
  return fmt::format("CYCLE997({},1,1,{},2,5,{},0,0,0)", way.variant + more, diameter, way.angles);
}

TEST(BallCycle, EveryWayRoundTheBallFindsItsCentre) {
  for (const Way& way : some_of(kWays)) {
    for (const int repeated : {0, 10}) {
      SCOPED_TRACE(fmt::format("{}, {}", way.name, repeated));
      const MeasuringRun run =
          expect_measured(call(way, repeated), {ball(), kCalibrated}, found(25.0));
      EXPECT_EQ(signals_of(run).size(), (way.equator + 1) * (repeated == 0 ? 1U : 2U));
    }
  }
}

TEST(BallCycle, TheDiameterIsTrueInTheFirstPassAndInTheSecond) {
  for (const Way& way : some_of(kWays)) {
    for (const int repeated : {0, 10}) {
      SCOPED_TRACE(fmt::format("{}, {}", way.name, repeated));
      const MeasuringRun run =
          expect_measured(call(way, 1000000 + repeated), {ball(), kCalibrated}, found(25.012));
      // One touch more in the first pass.
      EXPECT_EQ(signals_of(run).size(), (way.equator + 1) * (repeated == 0 ? 1U : 2U) + 1);
    }
  }
}

TEST(BallCycle, TheWorkOffsetTakesTheCentreOver) {
  struct Target {
    int number;
    std::vector<ExpectedValue> expected;
  };
  const Target kTargets[] = {
      {1,
       {{"$P_UIFR[1,X,FI]", -0.2},
        {"$P_UIFR[1,Y,FI]", 0.3},
        {"$P_UIFR[1,Z,FI]", 0.15},
        {"_OVI[0]", 1.0}}},
      {10001, {{"$P_UIFR[1,X,TR]", 99.8}, {"$P_UIFR[1,Y,TR]", 50.3}, {"$P_UIFR[1,Z,TR]", -299.85}}},
      {9000, {{"$P_UIFR[1,X,FI]", -0.2}, {"$P_UIFR[1,Z,FI]", 0.15}}},
      {1001, {{"$P_CHBFR[0,X,FI]", -0.2}, {"$P_CHBFR[0,Y,FI]", 0.3}, {"$P_CHBFR[0,Z,FI]", 0.15}}},
      {2000, {{"$P_SETFR[X,FI]", -0.2}, {"$P_SETFR[Z,FI]", 0.15}}},
      {3002, {{"$P_NCBFR[1,X,FI]", -0.2}, {"$P_NCBFR[1,Z,FI]", 0.15}}},
      {0, {{"$P_UIFR[1,X,FI]", 0.0}, {"$P_UIFR[1,Z,FI]", 0.0}, {"_OVR[9]", -0.2}}},
  };
  for (const Target& target : kTargets) {
    SCOPED_TRACE(target.number);
    expect_measured(fmt::format("CYCLE997(1000119,{},1,25,2,5,,,0,0,0)", target.number),
                    {ball(), kCalibrated}, target.expected);
  }
}

TEST(BallCycle, SetPlacesMayBeAnywhereAndInAnyPlane) {
  // The ball where G54 has (-0.2, 0.3, 0.15), asked for at another place of turned coordinates.
  expect_measured(
      "TRANS X10 Y-20 Z5\nAROT Z30\nX0 Y0 Z20\n"
      "R1=COS(30)*(-10.2)+SIN(30)*20.3 R2=-SIN(30)*(-10.2)+COS(30)*20.3\nG0 X=R1 Y=R2\n"
      "CYCLE997(1102119,1,1,25,2,5,40,85,R1+0.1,R2-0.2,-5,,,,,,,,,,1)\nTRANS",
      {ball(), kCalibrated},
      {{"_OVR[4]", 25.012}, {"_OVR[9]", -0.1}, {"_OVR[10]", 0.2}, {"_OVR[11]", 0.15}});
}

/// D-9 of the worked examples: the touches of the first pass, the ball's centre, and what comes.
TEST(BallCycle, TouchesWhereTheWorkedExampleSays) {
  const std::string sphere = part("sphere", 100.02, 49.97, -300.05, "diameter = 25.0");
  const std::string offset = "[work_offsets.G55]\nX = 0.0\nY = 0.0\nZ = -270.0\n";
  const MeasuringRun run = expect_measured(
      "G55\nX100 Y50 Z0\nCYCLE997(1001019,1,1,25,2,5,0,90,100,50,-30)",
      {sphere, offset, kCalibrated},
      {{"_OVR[4]", 25.0}, {"_OVR[5]", 100.02}, {"_OVR[6]", 49.97}, {"_OVR[7]", -30.05}});
  const double kPlaces[][2] = {{115.519890, 50.0}, {100.0, 65.469906}, {84.520110, 50.0}};
  const std::vector<nlohmann::json> touches = signals_of(run);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(touches[i].at("latched").at(0).get<double>(), kPlaces[i][0], 1e-6) << i;
    EXPECT_NEAR(touches[i].at("latched").at(1).get<double>(), kPlaces[i][1], 1e-6) << i;
  }
  // The pole; the tip, which the length counts to, is the ball's end: machine coordinates have
  // both.
  EXPECT_NEAR(touches[3].at("work").at(2).get<double>(), -14.55 - 3.0, 1e-6);
}

TEST(BallCycle, LeavesWhatItsTableDoesNotListAsItWas) {
  std::vector<ExpectedValue> untouched = {{"_OVI[1]", 99.0}, {"_OVI[3]", 99.0}, {"_OVI[4]", 99.0}};
  for (int i = 12; i <= 31; ++i) {
    if (i != 28) {
      untouched.push_back({fmt::format("_OVR[{}]", i), 99.5});
    }
  }
  expect_measured("_OVR[0]=REP(99.5)\n_OVI[0]=REP(99)\nCYCLE997(9,1,1,25,2,5,,,0,0,0)",
                  {ball(), kCalibrated}, untouched);
}

TEST(BallCycle, RunsAsTheManualPrintsIt) {
  expect_measured("Z10\nCYCLE997(109,1,1,10,1,5,0,45,0,0,0,5,5,5,10,10,10,0,1,,0,)",
                  {part("sphere", 100.25, 49.5, -299.75, "diameter = 10.0"), kCalibrated},
                  {{"_OVR[0]", 10.0},
                   {"_OVR[5]", 0.25},
                   {"_OVR[6]", -0.5},
                   {"_OVR[7]", 0.25},
                   {"$P_UIFR[1,X,FI]", 0.25},
                   {"$P_UIFR[1,Y,FI]", -0.5},
                   {"$P_UIFR[1,Z,FI]", 0.25}});
}

TEST(BallCycle, AProbeThatIsLateAndEccentricReadsTrueOnceItIsCalibrated) {
  const std::string ring = part("ring", 300.0, 50.0, -300.0, "bore = 40.0");
  const std::string calibrated =
      "TRANS X200\nX0 Y0\nZ-5\nCYCLE976(1,1,40,,,,5,5)\nZ20\nTRANS\nX0 Y0\n";
  for (const Way& way : some_of(kWays)) {
    SCOPED_TRACE(way.name);
    expect_measured(calibrated + call(way, 1000010), {ball() + ring, kBentProbe},
                    {{"_OVR[4]", 25.012}, {"_OVR[5]", -0.2}, {"_OVR[6]", 0.3}}, 1e-6);
  }
}

TEST(BallCycle, MeasuresWhereTheToolsLengthEndsInTheMiddleOfTheBall) {
  expect_measured(
      "$MNS_MEA_FUNCTION_MASK=1\n$SNS_MEA_WP_TRIG_MINUS_DIR_AX3[0]=-3\n$TC_DP3[1,1]=117\nD1\n"
      "CYCLE997(1101119,1,1,25,2,5,0,90,0,0,0)",
      {ball(), kCalibrated},
      {{"_OVR[4]", 25.012}, {"_OVR[5]", -0.2}, {"_OVR[6]", 0.3}, {"_OVR[7]", 0.15}});
}

TEST(BallCycle, GoesFirstToTheNegativeSideAndNeverThroughTheBall) {
  // Watched by the probe itself: a touch on the way would be alarm 61302.
  const MeasuringRun run =
      run_measuring("CYCLE997(9,1,1,25,2,5,,,0,0,0)", {ball(), kCalibrated}, {"_OVI[9]"});
  EXPECT_EQ(run.alarm(), 0);
  EXPECT_LT(signals_of(run)[0].at("work").at(0).get<double>(), -15.0);
}

struct Fault {
  const char* name;
  std::string program;
  int alarm;
};

void expect_refused(const Fault& fault, const std::vector<std::string>& sheets) {
  SCOPED_TRACE(fault.name);
  const std::vector<std::string> names = {"_OVI[9]",         "_OVI[12]",        "$P_UIFR[1,X,FI]",
                                          "$P_UIFR[1,Y,FI]", "$P_UIFR[1,Z,FI]", "$P_UIFR[1,Z,RT]",
                                          "$P_UIFR[1,X,TR]"};
  const MeasuringRun run = run_measuring(fault.program, sheets, names);
  EXPECT_EQ(run.alarm(), fault.alarm) << run.output.errors;
  EXPECT_EQ(run.at("_OVI[9]"), fault.alarm);
  EXPECT_EQ(run.at("$P_UIFR[1,X,TR]"), 100.0);
  for (const char* const written :
       {"$P_UIFR[1,X,FI]", "$P_UIFR[1,Y,FI]", "$P_UIFR[1,Z,FI]", "$P_UIFR[1,Z,RT]"}) {
    EXPECT_EQ(run.at(written), 0.0) << written;
  }
}

TEST(BallCycle, EachMistakeIsAnAlarmAndNothingIsCorrected) {
  const Fault kFaults[] = {
      {"not a ball", "CYCLE997(108,1,1,25,2,5,,,0,0,0)", 61307},
      {"repeated twice", "CYCLE997(129,1,1,25,2,5,,,0,0,0)", 61307},
      {"a tool as the target", "CYCLE997(209,1,1,25,2,5,,,0,0,0)", 61307},
      {"a way that is not there", "CYCLE997(5109,1,1,25,2,5,0,90,0,0,0)", 61307},
      {"two balls", "CYCLE997(20109,1,1,25,2,5,,,0,0,0)", 61307},
      {"five points", "CYCLE997(201109,1,1,25,2,5,0,90,0,0,0)", 61307},
      {"an unknown eighth digit", "CYCLE997(2000109,1,1,25,2,5,,,0,0,0)", 61307},
      {"no path", "CYCLE997(109,1,1,25,0,5,,,0,0,0)", 61308},
      {"a record too high", "CYCLE997(109,1,41,25,2,5,,,0,0,0)", 61313},
      {"no diameter", "CYCLE997(109,1,1,0,2,5,,,0,0,0)", 61316},
      {"no step", "CYCLE997(1109,1,1,25,2,5,0,0,0,0,0)", 61331},
      {"three points more than once round", "CYCLE997(1109,1,1,25,2,5,0,121,0,0,0)", 61331},
      {"four points more than once round", "CYCLE997(101109,1,1,25,2,5,0,-91,0,0,0)", 61331},
      {"a start beyond one turn", "CYCLE997(3109,1,1,25,2,5,361,,0,0,0)", 61331},
      {"the offset is not there", "CYCLE997(109,4001,1,25,2,5,,,0,0,0)", 61321},
      {"not calibrated", "CYCLE997(109,1,2,25,2,5,,,0,0,0)", 61341},
      {"no probe", "T2 M6\nCYCLE997(109,1,1,25,2,5,,,0,0,0)", 61309},
      {"no tool", "D0\nCYCLE997(109,1,1,25,2,5,,,0,0,0)", 61311},
      {"a scale", "SCALE X2\nCYCLE997(109,1,1,25,2,5,,,0,0,0)", 61310},
      {"out of the safe area, across", "CYCLE997(109,1,1,25,2,0.25,,,0,0,0)", 61303},
      {"out of the safe area, upwards", "CYCLE997(109,1,1,25,2,0.14,,,-0.2,0.3,0)", 61303},
      {"nothing within the path", "CYCLE997(109,1,1,25,2,5,,,-4,0,0)", 61301},
      {"begins too low", "Z5 X-40\nZ0\nCYCLE997(109,1,1,25,2,5,,,20,0,0)", 61302},
      {"deflected at the call", "X-40\nZ0\nMEAS=1 G1 X-10 F300\nCYCLE997(109,1,1,25,2,5,,,0,0,0)",
       61302},
      {"probe turned along, and no spindle to turn",
       "$MCS_AXIS_USAGE_ATTRIB[6]=512\nCYCLE997(2109,1,1,25,2,5,0,90,0,0,0)", 61372},
      {"one direction, and no spindle to turn",
       "$MCS_AXIS_USAGE_ATTRIB[6]=512\n$TC_DP1[1,1]=712\nCYCLE997(109,1,1,25,2,5,,,0,0,0)", 61373},
      {"one direction turned along", "$TC_DP1[1,1]=712\nCYCLE997(2109,1,1,25,2,5,0,90,0,0,0)",
       61309},
      {"an L probe", "$TC_DP1[1,1]=713\nCYCLE997(109,1,1,25,2,5,,,0,0,0)", 61309},
  };
  for (const Fault& fault : some_of(kFaults)) {
    expect_refused(fault, {ball(), kCalibrated});
  }
}

TEST(BallCycle, AMonoProbeIsTurnedToEachPoint) {
  expect_measured("$TC_DP1[1,1]=712\nCYCLE997(1101119,1,1,25,2,5,0,90,0,0,0)",
                  {ball(), kCalibrated, "[probe]\ntype = \"mono\"\n"},
                  {{"_OVR[4]", 25.012}, {"_OVR[5]", -0.2}, {"_OVR[6]", 0.3}, {"_OVR[7]", 0.15}});
}

}  // namespace
}  // namespace g31::testing::ball_cycle_test
