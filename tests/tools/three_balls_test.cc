// CYCLE997 with three balls: a fixture that is shifted and turned brings its work offset back, with
// the rotation, whatever offset holds it and whichever plane is in force.

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/effort.h"
#include "tests/support/measuring_run.h"

namespace g31::testing::three_balls_test {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using Triangle = std::array<Vector3d, 3>;

constexpr double kRadians = std::numbers::pi / 180.0;

/// A frame of the control: shift, then turned about X, the Y and the Z that do not turn.
Isometry3d frame(const Vector3d& shift, const Vector3d& turned_deg) {
  Isometry3d made = Isometry3d::Identity();
  made.translate(shift);
  made.rotate(AngleAxisd(turned_deg.z() * kRadians, Vector3d::UnitZ()));
  made.rotate(AngleAxisd(turned_deg.y() * kRadians, Vector3d::UnitY()));
  made.rotate(AngleAxisd(turned_deg.x() * kRadians, Vector3d::UnitX()));
  return made;
}

/// The ball off the spindle's axis, and known to be.
constexpr const char* kOffAxis = R"([probe]
eccentricity = [0.05, -0.08]
[variables]
"$SNS_MEA_WP_POS_DEV_AX1[0]" = 0.05
"$SNS_MEA_WP_POS_DEV_AX2[0]" = -0.08
)";

const Vector3d kG54(100.0, 50.0, -300.0);

std::string balls(const Isometry3d& where, const Triangle& set) {
  std::string sheet;
  for (std::size_t i = 0; i < set.size(); ++i) {
    const Vector3d at = where * set[i];
    sheet += fmt::format(
        "[[part]]\nname = \"ball {}\"\nshape = \"sphere\"\ndiameter = 20.0\nat = [{:.17g}, "
        "{:.17g}, {:.17g}]\n",
        i + 1, at.x(), at.y(), at.z());
  }
  return sheet;
}

std::string places(const Triangle& set) {
  std::string text;
  for (const Vector3d& p : set) {
    text += fmt::format(",{:.17g},{:.17g},{:.17g}", p.x(), p.y(), p.z());
  }
  return text.substr(1);
}

const std::vector<std::string> kFrameOf54 = {
    "$P_UIFR[1,X,TR]", "$P_UIFR[1,Y,TR]", "$P_UIFR[1,Z,TR]", "$P_UIFR[1,X,FI]", "$P_UIFR[1,Y,FI]",
    "$P_UIFR[1,Z,FI]", "$P_UIFR[1,X,RT]", "$P_UIFR[1,Y,RT]", "$P_UIFR[1,Z,RT]"};

Isometry3d frame_left_by(const MeasuringRun& run, const std::vector<std::string>& names) {
  const auto vector_at = [&](std::size_t first) {
    return Vector3d(run.at(names[first]), run.at(names[first + 1]), run.at(names[first + 2]));
  };
  return frame(vector_at(0) + vector_at(3), vector_at(6));
}

/// The largest distance between what two frames make of a cube of 100 mm.
double apart(const Isometry3d& a, const Isometry3d& b) {
  double most = 0.0;
  for (const double x : {0.0, 100.0}) {
    for (const double y : {0.0, 100.0}) {
      for (const double z : {0.0, 100.0}) {
        most = std::max(most, (a * Vector3d(x, y, z) - b * Vector3d(x, y, z)).norm());
      }
    }
  }
  return most;
}

const Triangle kSet = {Vector3d(0, 0, 0), Vector3d(100, 0, 0), Vector3d(0, 80, 0)};

/// D-7 of the worked examples.
TEST(ThreeBalls, ReadAsTheWorkedExampleSays) {
  const Isometry3d fixture = frame({0.3, -0.2, 0.1}, {0, 0, 0.5});
  const MeasuringRun run =
      expect_measured("CYCLE997(1010119,1,1,20,3,5,,," + places(kSet) + ")",
                      {balls(Eigen::Translation3d(kG54) * fixture, kSet), kCalibrated},
                      {{"_OVR[0]", 20.0},
                       {"_OVR[1]", 0.0},
                       {"_OVR[4]", 20.0},
                       {"_OVR[5]", 0.3},
                       {"_OVR[6]", -0.2},
                       {"_OVR[7]", 0.1},
                       {"_OVR[8]", 0.0},
                       {"_OVR[9]", 0.3},
                       {"_OVR[12]", 20.0},
                       {"_OVR[13]", 100.296192},
                       {"_OVR[14]", 0.672654},
                       {"_OVR[15]", 0.1},
                       {"_OVR[16]", 0.0},
                       {"_OVR[17]", 0.296192},
                       {"_OVR[18]", 0.672654},
                       {"_OVR[19]", 0.1},
                       {"_OVR[20]", 20.0},
                       {"_OVR[21]", -0.398123},
                       {"_OVR[22]", 79.796954},
                       {"_OVR[23]", 0.1},
                       {"_OVR[24]", 0.0},
                       {"_OVR[25]", -0.398123},
                       {"_OVR[26]", -0.203046},
                       {"_OVR[27]", 0.1},
                       {"_OVR[28]", 5.0},
                       {"_OVI[0]", 1.0},
                       {"_OVI[12]", 0.0},
                       {"$P_UIFR[1,X,FI]", 0.3},
                       {"$P_UIFR[1,Y,FI]", -0.2},
                       {"$P_UIFR[1,Z,FI]", 0.1},
                       {"$P_UIFR[1,X,RT]", 0.0},
                       {"$P_UIFR[1,Y,RT]", 0.0},
                       {"$P_UIFR[1,Z,RT]", 0.5},
                       // Over the third ball, in the coordinates as they are now.
                       {"$AA_IW[X]", 0.0},
                       {"$AA_IW[Y]", 80.0}},
                      1e-6);
  EXPECT_EQ(run.alarm(), 0);
}

/// The fixture is where G54 believes it within a little; after the cycle G54 has it.
TEST(ThreeBalls, BringAFixtureThatIsShiftedAndTurnedBack) {
  std::mt19937 random(997);
  const auto within = [&](double most) {
    return std::uniform_real_distribution<>(-most, most)(random);
  };
  constexpr int kVariants[] = {1010119, 1111119, 1112119, 1013119, 1114119};
  const int rounds = of_many(20);
  for (int round = 0; round < rounds; ++round) {
    const Vector3d shift = kG54 + Vector3d(within(40), within(40), within(20));
    const Vector3d turned(within(4), within(4), within(180));
    const Vector3d shift_off(within(0.4), within(0.4), within(0.4));
    const Vector3d turn_off(within(0.2), within(0.2), within(0.2));
    const Isometry3d believed = frame(shift, turned);
    const Isometry3d is = frame(shift + shift_off, turned + turn_off);
    Triangle set = {Vector3d(within(5), within(5), within(5)),
                    Vector3d(70 + within(10), within(20), within(5)),
                    Vector3d(within(20), 60 + within(10), within(5))};
    const int variant = kVariants[round % 5];
    const bool coarse = round % 2 == 1;
    const std::string program =
        fmt::format("CYCLE997({},{},1,20,3,8,{:.3f},{},{})", variant, coarse ? 10001 : 1,
                    within(90), round % 3 == 0 ? 80 : -90, places(set));
    const std::string offset = fmt::format(
        "[work_offsets.G54]\nX = {:.17g}\nY = {:.17g}\nZ = {:.17g}\n[variables]\n"
        "\"$P_UIFR[1,X,RT]\" = {:.17g}\n\"$P_UIFR[1,Y,RT]\" = {:.17g}\n"
        "\"$P_UIFR[1,Z,RT]\" = {:.17g}\n",
        shift.x(), shift.y(), shift.z(), turned.x(), turned.y(), turned.z());
    SCOPED_TRACE(fmt::format("round {}\n{}\n{}", round, offset, program));
    const MeasuringRun run = run_on_sheets(
        fmt::format("T1 M6\nG0 Z200\nG54 D1\nG0 X={:.6f} Y={:.6f}\nZ30\n{}", set[0].x(), set[0].y(),
                    program),
        {kMeasuringSheet, balls(is, set), kCalibrated, round % 4 == 2 ? kOffAxis : "", offset},
        kFrameOf54);
    ASSERT_EQ(run.output.exit_code, 0) << run.output.errors;
    EXPECT_GT(apart(believed, is), 0.05);
    EXPECT_LT(apart(frame_left_by(run, kFrameOf54), is), 1e-6);
  }
}

TEST(ThreeBalls, TurnBasicFramesAndTheReferenceToo) {
  const Isometry3d fixture = frame({0.3, -0.2, 0.1}, {0.1, -0.15, 0.5});
  struct Target {
    int number;
    const char* frame;  ///< of which one component is missing
  };
  const Target kTargets[] = {
      {1001, "$P_CHBFR[0,{},{}]"}, {1003, "$P_CHBFR[2,{},{}]"}, {2000, "$P_SETFR[{},{}]"}};
  for (const Target& target : kTargets) {
    SCOPED_TRACE(target.number);
    std::vector<std::string> names;
    for (const char* const component : {"TR", "FI", "RT"}) {
      for (const char axis : {'X', 'Y', 'Z'}) {
        names.push_back(fmt::format(fmt::runtime(target.frame), axis, component));
      }
    }
    const MeasuringRun run = run_measuring(
        fmt::format("CYCLE997(1010119,{},1,20,3,5,,,{})", target.number, places(kSet)),
        {balls(Eigen::Translation3d(kG54) * fixture, kSet), kCalibrated}, names);
    ASSERT_EQ(run.output.exit_code, 0) << run.output.errors;
    // Outside of G54: what the whole chain makes of the fixture's places.
    const Isometry3d chain = frame_left_by(run, names) * Eigen::Translation3d(kG54);
    EXPECT_LT(apart(chain, Eigen::Translation3d(kG54) * fixture), 1e-6);
  }
}

/// What CYCLE997 does with what it found, in each plane: coordinates come in the order of its axes.
TEST(ThreeBalls, FitTheirTriangleInEveryPlane) {
  const Isometry3d fixture = frame({0.3, -0.2, 0.1}, {0.1, -0.15, 0.5});
  const Triangle set = {Vector3d(2, -3, 1), Vector3d(100, 4, -6), Vector3d(-5, 80, 7)};
  const struct {
    const char* code;
    std::array<Eigen::Index, 3> axes;
  } kPlanes[] = {{"G17", {0, 1, 2}}, {"G18", {2, 0, 1}}, {"G19", {1, 2, 0}}};
  for (const auto& plane : kPlanes) {
    SCOPED_TRACE(plane.code);
    std::string program = fmt::format(
        "DEF REAL WANTED[3,3], THERE[3,3]\nT1 M6\nG54 D1\n{}\n_MV_MM=1 _MV_TARGET=1\n", plane.code);
    for (std::size_t ball = 0; ball < 3; ++ball) {
      for (std::size_t i = 0; i < 3; ++i) {
        program += fmt::format("WANTED[{0},{1}]={2:.15f} THERE[{0},{1}]={3:.15f}\n", ball, i,
                               set[ball][plane.axes[i]], (fixture * set[ball])[plane.axes[i]]);
      }
    }
    const MeasuringRun run =
        run_on_sheets(program + "_MC_DATUM(1,TRUE)\n_MC_FIT(1,WANTED,THERE,0.001)",
                      {kMeasuringSheet, kCalibrated}, kFrameOf54);
    ASSERT_EQ(run.output.exit_code, 0) << run.output.errors;
    EXPECT_LT(apart(frame_left_by(run, kFrameOf54), Eigen::Translation3d(kG54) * fixture), 1e-9);
  }
}

TEST(ThreeBalls, MayBeMeasuredOnly) {
  const Isometry3d fixture = frame({0.3, -0.2, 0.1}, {0, 0, 0.5});
  expect_measured("CYCLE997(1010019,1,1,20,3,5,,," + places(kSet) + ")",
                  {balls(Eigen::Translation3d(kG54) * fixture, kSet), kCalibrated},
                  {{"_OVR[22]", 79.796954},
                   {"$P_UIFR[1,X,FI]", 0.0},
                   {"$P_UIFR[1,Z,RT]", 0.0},
                   {"_OVI[0]", 0.0}});
}

/// The balls stand 0.1 mm farther apart than they should: 0.05, 0.05 and something at the third are
/// missed.
TEST(ThreeBalls, ThatDoNotFitTheirTriangleCorrectNothing) {
  Triangle stretched = kSet;
  stretched[1].x() += 0.6;
  const std::string sheet = balls(Isometry3d(Eigen::Translation3d(kG54)), stretched);
  const std::vector<std::string> names = {"_OVI[9]", "$P_UIFR[1,X,FI]", "$P_UIFR[1,Z,RT]",
                                          "_OVR[13]"};
  const auto run_with = [&](const char* limit) {
    return run_measuring("CYCLE997(1010119,1,1,20,3,5,,," + places(kSet) + limit + ")",
                         {sheet, kCalibrated}, names);
  };
  const MeasuringRun refused = run_with(",0.5");
  EXPECT_EQ(refused.alarm(), 61403);
  EXPECT_EQ(refused.at("_OVI[9]"), 61403);
  EXPECT_EQ(refused.at("$P_UIFR[1,X,FI]"), 0.0);
  EXPECT_EQ(refused.at("$P_UIFR[1,Z,RT]"), 0.0);
  EXPECT_NEAR(refused.at("_OVR[13]"), 100.6, 1e-6);
  // 1.2 where nothing is said: the sum of what three points miss is below it.
  const MeasuringRun done = run_with("");
  EXPECT_EQ(done.alarm(), 0) << done.output.errors;
  EXPECT_NE(done.at("$P_UIFR[1,X,FI]"), 0.0);
  // 1.2 mm in a program that counts in inches, too.
  stretched[1].x() += 3.4;
  const MeasuringRun inches =
      run_measuring("G700\nCYCLE997(1010119,1,1,20/25.4,8/25.4,1,,,0,0,0,100/25.4,0,0,0,80/25.4,0)",
                    {balls(Isometry3d(Eigen::Translation3d(kG54)), stretched), kCalibrated}, names);
  EXPECT_EQ(inches.alarm(), 61403) << inches.output.errors;
  EXPECT_EQ(inches.at("$P_UIFR[1,X,FI]"), 0.0);
}

TEST(ThreeBalls, RefuseBeforeAnythingMoves) {
  const std::string sheet = balls(Isometry3d(Eigen::Translation3d(kG54)), kSet);
  const struct {
    const char* name;
    std::string call;
    int alarm;
  } kFaults[] = {
      {"global basic frame", "CYCLE997(1010119,3001,1,20,3,5,,," + places(kSet) + ")", 61321},
      {"on a line", "CYCLE997(1010119,1,1,20,3,5,,,0,0,0,50,0,0,100,0,0)", 61316},
      {"in one place", "CYCLE997(1010119,1,1,20,3,5)", 61316},
  };
  for (const auto& fault : some_of(kFaults)) {
    SCOPED_TRACE(fault.name);
    const MeasuringRun run =
        run_measuring(fault.call, {sheet, kCalibrated}, {"$P_UIFR[1,X,FI]", "$P_UIFR[1,Z,RT]"});
    EXPECT_EQ(run.alarm(), fault.alarm) << run.output.errors;
    EXPECT_TRUE(run.output.document.at("touches").empty());
    EXPECT_EQ(run.at("$P_UIFR[1,X,FI]"), 0.0);
    EXPECT_EQ(run.at("$P_UIFR[1,Z,RT]"), 0.0);
  }
}

TEST(ThreeBalls, SayWhichOfThemAnAlarmIsOf) {
  Triangle aside = kSet;
  aside[2].x() += 0.7;
  const MeasuringRun run = run_measuring(
      "CYCLE997(10109,1,1,20,3,0.5,,," + places(kSet) + ")",
      {balls(Isometry3d(Eigen::Translation3d(kG54)), aside), kCalibrated}, {"_OVI[12]", "_OVI[9]"});
  EXPECT_EQ(run.alarm(), 61303) << run.output.errors;
  EXPECT_EQ(run.at("_OVI[12]"), 3.0);
}

}  // namespace
}  // namespace g31::testing::three_balls_test
