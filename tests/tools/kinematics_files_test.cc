// Files that CYCLE9960 leaves: encoder compensation of the rotary axes, directions for VCS.

#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/kinematics_run.h"

namespace g31::testing::kinematics_files_test {
namespace {

const char* const kSettings = "$SCS_MEA_KIN_MODE[0]=4 $SCS_MEA_KIN_MODE[1]=6\n";

std::string call(int variant) {
  return fmt::format("CYCLE9960({},\"\",1,25,0,-60,60,4,0,0,0,270,4,0,1,3,5,1,1,0,0)\n", variant);
}

std::string file_of(const MeasuringRun& run, const std::string& name) {
  for (const auto& [path, text] : run.output.document.at("files").items()) {
    if (path.find(name) != std::string::npos) {
      return text.get<std::string>();
    }
  }
  return "missing";
}

/// The table believed, but C turns other than its encoder says: by its compensation.
std::string uneven_table() {
  std::string text =
      "$MA_ROT_IS_MODULO[C]=1\n$AA_ENC_COMP_MAX[0,C]=360 $AA_ENC_COMP_STEP[0,C]=90 "
      "$AA_ENC_COMP_IS_MODULO[0,C]=1\n";
  const double kOff[] = {0.0, 0.01, -0.02, 0.005, 0.0};
  for (int n = 0; n < 5; ++n) {
    text += fmt::format("$AA_ENC_COMP[0,{},C]={}\n", n, kOff[n]);
  }
  return text + "$MA_ENC_COMP_ENABLE[0,C]=1\n";
}

const std::string kAsked = "$SCS_MEA_FUNCTION_MASK=$SCS_MEA_FUNCTION_MASK B_OR 'H800000'\n";

/// A positive value moves an axis back: C turns by the negative of what its table has, and the file
/// is what would bring that back.
const char* const kCompensation = R"($AA_ENC_COMP_MIN[0,C]=0.000000
$AA_ENC_COMP_MAX[0,C]=360.000000
$AA_ENC_COMP_STEP[0,C]=90.000000
$AA_ENC_COMP_IS_MODULO[0,C]=1
$AA_ENC_COMP[0,0,C]=0.00000000
$AA_ENC_COMP[0,1,C]=-0.01000000
$AA_ENC_COMP[0,2,C]=0.02000000
$AA_ENC_COMP[0,3,C]=-0.00500000
$AA_ENC_COMP[0,4,C]=0.00000000
M17
)";

TEST(KinematicsFiles, EncoderCompensationIsWhatTheAxisTurnsBesideItsEncoder) {
  const MisbelievedMachine machine = misbelieved_machines().front();
  const MeasuringRun run =
      run_on_sheets(over_the_ball(uneven_table() + kSettings + kAsked + call(11400)),
                    kinematics_sheets(machine), {"$TC_CARR16[1]"});
  expect_values(run, {{"$TC_CARR16[1]", machine.vectors[2].y()}}, 1e-6);
  EXPECT_EQ(file_of(run, "ENC_COMP_C1"), kCompensation);
  // The series of A has its home in the middle of a gap: the points lie closer together.
  const std::string of_a = file_of(run, "ENC_COMP_A1");
  EXPECT_NE(of_a.find("$AA_ENC_COMP_MIN[0,A]=-60.000000\n$AA_ENC_COMP_MAX[0,A]=60.000000\n"
                      "$AA_ENC_COMP_STEP[0,A]=20.000000\n$AA_ENC_COMP_IS_MODULO[0,A]=0\n"
                      "$AA_ENC_COMP[0,0,A]=0.00000000\n"),
            std::string::npos)
      << of_a;
  EXPECT_NE(of_a.find("$AA_ENC_COMP[0,6,A]=0.00000000\n"), std::string::npos) << of_a;
}

/// The user calls it, with the compensation off.
TEST(KinematicsFiles, EncoderCompensationIsAProgram) {
  const MeasuringRun run = run_on_sheets(
      over_the_ball(uneven_table() + kSettings + kAsked + call(11400) +
                    "$MA_ENC_COMP_ENABLE[0,C]=0\nENC_COMP_C1\nR1=$AA_ENC_COMP[0,2,C]\n"),
      kinematics_sheets(misbelieved_machines().front()), {"R1"});
  expect_values(run, {{"R1", 0.02}}, 1e-9);
}

TEST(KinematicsFiles, EncoderCompensationIsLeftOutWhereItIsNotAskedFor) {
  const std::vector<std::string> sheets = kinematics_sheets(misbelieved_machines().front());
  EXPECT_EQ(file_of(run_on_sheets(over_the_ball(kSettings + call(11400)), sheets, {}), "ENC_COMP"),
            "missing");
  EXPECT_EQ(file_of(run_on_sheets(over_the_ball(kSettings + kAsked + call(10400)), sheets, {}),
                    "ENC_COMP"),
            "missing");
}

/// "[ROTV1]", three numbers, "[ROTV2]", three numbers.
void expect_directions(std::istringstream& file, const Point& first, const Point& second) {
  for (const auto& [head, direction] :
       {std::pair("[ROTV1]", first), std::pair("[ROTV2]", second)}) {
    std::string line;
    std::getline(file, line);
    EXPECT_EQ(line, head);
    std::getline(file, line);
    std::istringstream numbers(line);
    for (int k = 0; k < 3; ++k) {
      double value = 0.0;
      EXPECT_TRUE(numbers >> value) << line;
      EXPECT_NEAR(value, direction[k], 1e-8) << line;
    }
  }
}

/// What the tables are carried about, against the axes' directions; C is tilted by 20 arcsec.
const Point kFirst(-1, 0, 0);
const Point kSecond(0, 0, -1);
Point found_second() {
  return -misbelieved_machines().front().truth.rotary[2].axis_M.normalized();
}

TEST(KinematicsFiles, DirectionsAreThoseThatWereFound) {
  const MeasuringRun run = run_on_sheets(over_the_ball(kSettings + call(10400)),
                                         kinematics_sheets(misbelieved_machines().front()), {});
  EXPECT_EQ(run.output.exit_code, 0) << run.output.errors;
  std::istringstream file(file_of(run, "VCSROTVEC"));
  expect_directions(file, kFirst, found_second());
}

/// Where it stops at the first ball, the file has what is entered.
TEST(KinematicsFiles, DirectionsAreAtFirstThoseThatAreEntered) {
  const MeasuringRun run = run_on_sheets(
      over_the_ball("VCSROTVEC_VERIFICATION=0\n$SCS_MEA_FUNCTION_MASK=1\nX200\n" + call(10400)),
      kinematics_sheets(misbelieved_machines().front()), {});
  EXPECT_EQ(run.alarm(), 61301);
  std::istringstream file(file_of(run, "VCSROTVEC"));
  expect_directions(file, kFirst, kSecond);
}

TEST(KinematicsFiles, DirectionsAreVerifiedBesideThoseInForce) {
  const MeasuringRun run = run_on_sheets(
      over_the_ball(kSettings + call(10400) + "VCSROTVEC_VERIFICATION=1\n" + call(10400)),
      kinematics_sheets(misbelieved_machines().front()), {});
  EXPECT_EQ(run.output.exit_code, 0) << run.output.errors;
  std::istringstream file(file_of(run, "VCSROTVEC_VERIFI"));
  std::string line;
  std::getline(file, line);
  EXPECT_EQ(line, "// active correction for the rotary axis directions");
  expect_directions(file, kFirst, found_second());
  std::getline(file, line);
  EXPECT_EQ(line, "// rotary axis directions measured with the active correction");
  expect_directions(file, kFirst, found_second());
}

TEST(KinematicsFiles, DirectionsMayBeLeftOut) {
  const MeasuringRun run = run_on_sheets(
      over_the_ball("VCSROTVEC_VERIFICATION=2\n" + std::string(kSettings) + call(10400)),
      kinematics_sheets(misbelieved_machines().front()), {});
  EXPECT_EQ(file_of(run, "VCSROTVEC"), "missing");
}

}  // namespace
}  // namespace g31::testing::kinematics_files_test
