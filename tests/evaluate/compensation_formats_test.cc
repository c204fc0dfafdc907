// What a shop enters: tables of both controls, reckoned by hand from a curve.

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/run_evaluate.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace g31::compensation_formats_test {
namespace {

using evaluate::OptionId;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::TemporaryFolder;

/// Deviations of X at -100, 0 and 100: 8, 0 and -15 um in the mean, half of the play apart.
constexpr const char* kPositioning =
    "axis,target,direction,cycle,position\n"
    "X,-100,1,1,-99.990\nX,-100,1,2,-99.992\nX,-100,-1,1,-99.994\nX,-100,-1,2,-99.992\n"
    "X,0,1,1,0.001\nX,0,1,2,0.001\nX,0,-1,1,-0.001\nX,0,-1,2,-0.001\n"
    "X,100,1,1,99.987\nX,100,1,2,99.985\nX,100,-1,1,99.983\nX,100,-1,2,99.985\n";

/// A work that is straight, and a slide that rises by 10, 16 and 10 um between its ends: sensors
/// that ride on it read that much less, and Y is positive towards them.
constexpr const char* kStraightness =
    "K,A,B\n0,0,0\n1,-0.010,-0.010\n2,-0.016,-0.016\n3,-0.010,-0.010\n4,0,0\n";

testing::EvaluateOutput written(TemporaryFolder& folder, const std::string& kind,
                                const std::string& format, const std::string& record) {
  cli::EvaluateOptions options;
  options.kind = kind;
  if (kind == "straightness") {
    options.given[OptionId::Step] = "100";
    options.given[OptionId::From] = "-100";
  }
  options.given[OptionId::Compensation] = folder.path("table");
  options.given[OptionId::CompensationFormat] = format;
  return testing::evaluate_text(record, options);
}

std::string table(const std::string& kind, const std::string& format, const std::string& record) {
  TemporaryFolder folder;
  const auto output = written(folder, kind, format, record);
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  return testing::text_of(folder.path("table"));
}

TEST(CompensationFormats, SheetOfPositioningReversesTheMeanOfBothDirections) {
  EXPECT_THAT(table("positioning", "sheet", kPositioning),
              HasSubstr("EXX = [\n  [-100.000000, -0.008000000],\n  [0.000000, 0.000000000],\n  "
                        "[100.000000, 0.015000000],\n]\n"));
}

// A positive value moves the axis in the negative direction: the deviations as they are.
TEST(CompensationFormats, SinumerikAlongTheAxis) {
  EXPECT_THAT(
      table("positioning", "sinumerik", kPositioning),
      HasSubstr("CHANDATA(1)\n$AA_ENC_COMP[0,0,X1]=0.008000\n"
                "$AA_ENC_COMP[0,1,X1]=0.000000\n$AA_ENC_COMP[0,2,X1]=-0.015000\n"
                "$AA_ENC_COMP_STEP[0,X1]=100.000000\n$AA_ENC_COMP_MIN[0,X1]=-100.000000\n"
                "$AA_ENC_COMP_MAX[0,X1]=100.000000\n$AA_ENC_COMP_IS_MODULO[0,X1]=0\nM17\n"));
}

TEST(CompensationFormats, SinumerikAcrossTheAxis) {
  EXPECT_THAT(table("straightness", "sinumerik", kStraightness),
              HasSubstr("$AN_CEC[0,0]=0.000000\n$AN_CEC[0,1]=0.010000\n$AN_CEC[0,2]=0.016000\n"
                        "$AN_CEC[0,3]=0.010000\n$AN_CEC[0,4]=0.000000\n$AN_CEC_INPUT_AXIS[0]=(X1)\n"
                        "$AN_CEC_OUTPUT_AXIS[0]=(Y1)\n$AN_CEC_STEP[0]=100.000000\n"
                        "$AN_CEC_MIN[0]=-100.000000\n$AN_CEC_MAX[0]=300.000000\n"));
}

/// A table acts only once its setting data and the machine data of the axis say so: the head names
/// both, so that nobody loads a table and wonders why nothing moves.
TEST(CompensationFormats, SinumerikHeadNamesWhatMakesItAct) {
  EXPECT_THAT(table("straightness", "sinumerik", kStraightness),
              HasSubstr("\n; It acts with SD41300 $SN_CEC_TABLE_ENABLE[0]=1 and MD32710[Y1]=1 "
                        "afterwards.\n"));
  EXPECT_THAT(table("positioning", "sinumerik", kPositioning),
              HasSubstr("\n; It acts with MD32700[0,X1]=1 afterwards.\n"));
}

// Targets that are not evenly spaced, as ISO 230-2 asks for: 0, 10 and 100 become nine places.
TEST(CompensationFormats, SinumerikTablesAreEven) {
  const std::string uneven =
      "axis,target,direction,cycle,position\n"
      "Z,0,1,1,0\nZ,0,1,2,0\nZ,10,1,1,10.004\nZ,10,1,2,10.004\nZ,100,1,1,100.013\n"
      "Z,100,1,2,100.013\n";
  const std::string text = table("positioning", "sinumerik", uneven);
  EXPECT_THAT(text, HasSubstr("$AA_ENC_COMP_STEP[0,Z1]=12.500000\n"));
  EXPECT_THAT(text, HasSubstr("$AA_ENC_COMP[0,1,Z1]=0.004250\n"));  // 0.004 + 2.5 / 90 x 0.009
  EXPECT_THAT(text, HasSubstr("$AA_ENC_COMP[0,8,Z1]=0.013000\n"));
  EXPECT_THAT(text, Not(HasSubstr("$AA_ENC_COMP[0,9,")));
}

// The corrections -8, 0 and 15 um gain 8 and 15; units of 3 um, so that none is above 7.
// The section before coordinate 0 has the number of 3620, the one behind it the next.
TEST(CompensationFormats, FanucPitchErrorsAreGainsFromPointToPoint) {
  EXPECT_THAT(table("positioning", "fanuc", kPositioning),
              HasSubstr("G10 L52\n(PITCH ERRORS OF X, UNITS OF 3 UM)\nN3620 P1 R2\nN3621 P1 R2\n"
                        "N3622 P1 R3\nN3623 P1 R3\nN3624 P1 R100000\nN10002 R3\nN10003 R5\nG11\n"));
}

// The manual's axis: -400 to 800 in steps of 50 with the reference at 40 has the points 33 to 56,
// so with the reference at 9 those from 2 to 25.
TEST(CompensationFormats, FanucNumbersOfPointsAreThoseOfTheManual) {
  std::string record = "axis,target,direction,cycle,position\n";
  for (int place = -400; place <= 800; place += 50) {
    for (int cycle = 1; cycle <= 2; ++cycle) {
      const std::string target = std::to_string(place);
      record += "Y," + target + ",1," + std::to_string(cycle) + "," + target + ".001\n";
    }
  }
  const std::string text = table("positioning", "fanuc", record);
  EXPECT_THAT(text, HasSubstr("N3620 P2 R9\nN3621 P2 R2\nN3622 P2 R25\nN3623 P2 R1\n"));
  EXPECT_THAT(text, HasSubstr("\nN10002 R"));
  EXPECT_THAT(text, HasSubstr("\nN10025 R"));
  EXPECT_THAT(text, Not(HasSubstr("\nN10026 R")));
}

// Of 0, 10, 16, 10, 0 um four places keep both ends, 16 and one of the 10: at the other one the
// line from 16 to 0 has 8.  Coordinate -100 is where the section before the first one would end.
TEST(CompensationFormats, FanucStraightnessHasFourPlaces) {
  EXPECT_THAT(table("straightness", "fanuc", kStraightness),
              HasSubstr("(FOUR PLACES LEAVE 2.0 UM OF THE CURVE)\n"));
  EXPECT_THAT(table("straightness", "fanuc", kStraightness),
              HasSubstr("N3620 P1 R2\nN3621 P1 R1\nN3622 P1 R5\nN3624 P1 R100000\nN5711 R1\n"
                        "N5721 R2\nN5731 R1\nN5732 R2\nN5733 R3\nN5734 R5\nN5761 R0\nN5762 R-10\n"
                        "N5763 R-16\nN5764 R0\nG11\n"));
}

// Four places have a number of their own each; of 1.4 um a whole one leaves 0.4.
TEST(CompensationFormats, FanucStraightnessLeavesWhatWholeNumbersDo) {
  const std::string rows = "K,A,B\n0,0,0\n1,-0.0014,-0.0014\n2,0,0\n3,0,0\n";
  EXPECT_THAT(table("straightness", "fanuc", rows),
              HasSubstr("(FOUR PLACES LEAVE 0.4 UM OF THE CURVE)\n"));
}

TEST(CompensationFormats, WhatDoesNotFitIsRefused) {
  TemporaryFolder folder;
  EXPECT_THAT(written(folder, "positioning", "heidenhain", kPositioning).errors,
              HasSubstr("--compensation-format heidenhain: a format is sheet, sinumerik, fanuc"));
  const std::string other =
      "axis,target,direction,cycle,position\nW,0,1,1,0\nW,0,1,2,0\nW,90,1,1,90\nW,90,1,2,90\n";
  const auto output = written(folder, "positioning", "sheet", other);
  EXPECT_EQ(output.exit_code, 2);
  EXPECT_THAT(output.errors, HasSubstr("EWW is compensated on no machine of g31"));
  const std::string one = "axis,target,direction,cycle,position\nX,0,1,1,0\nX,0,1,2,0\n";
  EXPECT_THAT(written(folder, "positioning", "fanuc", one).errors, HasSubstr("the record has one"));
  const std::string far =
      "axis,target,direction,cycle,position\nX,0,1,1,0\nX,0,1,2,0\nX,0.1,1,1,0.1\nX,0.1,1,2,0.1\n"
      "X,900,1,1,900\nX,900,1,2,900\n";
  EXPECT_THAT(written(folder, "positioning", "fanuc", far).errors,
              HasSubstr("points 0 to 1023, and places 0.1 mm apart would need more"));
}

}  // namespace
}  // namespace g31::compensation_formats_test
