// What a shop enters: tables of both controls, reckoned by hand from a curve.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>
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

// Targets that are not evenly spaced, as ISO 230-2 asks for: 0, 10 and 100 become eleven places.
TEST(CompensationFormats, SinumerikTablesAreEven) {
  const std::string uneven =
      "axis,target,direction,cycle,position\n"
      "Z,0,1,1,0\nZ,0,1,2,0\nZ,10,1,1,10.004\nZ,10,1,2,10.004\nZ,100,1,1,100.013\n"
      "Z,100,1,2,100.013\n";
  const std::string text = table("positioning", "sinumerik", uneven);
  EXPECT_THAT(text, HasSubstr("$AA_ENC_COMP_STEP[0,Z1]=10.000000\n"));
  EXPECT_THAT(text, HasSubstr("$AA_ENC_COMP[0,1,Z1]=0.004000\n"));
  EXPECT_THAT(text, HasSubstr("$AA_ENC_COMP[0,2,Z1]=0.005000\n"));
  EXPECT_THAT(text, HasSubstr("$AA_ENC_COMP[0,10,Z1]=0.013000\n"));
  EXPECT_THAT(text, Not(HasSubstr("$AA_ENC_COMP[0,11,")));
  EXPECT_THAT(text, Not(HasSubstr("It leaves")));
}

/// Targets some 60 mm apart, none as far from the next as another, of which every second is 10 um
/// further off than the one before.
class UnevenTargets : public ::testing::Test {
 protected:
  void take(int count, double between, double jitter) {
    for (int n = 0; n < count; ++n) {
      targets_.push_back(between * n + jitter * ((n * n * 7) % 23));
      deviations_um_.push_back(n % 2 == 0 ? 0.0 : 10.0);
      for (int cycle = 1; cycle <= 2; ++cycle) {
        record_ += fmt::format("X,{0},1,{1},{2:.6f}\n", targets_.back(), cycle,
                               targets_.back() + 0.001 * deviations_um_.back());
      }
    }
  }

  /// The most that corrections on lines between places leave at a target, um.
  [[nodiscard]] double left_by(const std::map<double, double>& corrections_um) const {
    double most = 0.0;
    for (std::size_t n = 0; n < targets_.size(); ++n) {
      const auto behind = corrections_um.lower_bound(targets_[n] - 1e-9);
      const auto before = behind == corrections_um.begin() ? behind : std::prev(behind);
      const double way = behind->first - before->first;
      const double share = way > 0.0 ? (targets_[n] - before->first) / way : 0.0;
      const double correction = before->second + share * (behind->second - before->second);
      most = std::max(most, std::abs(deviations_um_[n] + correction));
    }
    return most;
  }

  std::vector<double> targets_;
  std::vector<double> deviations_um_;
  std::string record_ = "axis,target,direction,cycle,position\n";
};

double number_behind(const std::string& text, const std::string& words) {
  const std::size_t at = text.find(words);
  EXPECT_NE(at, std::string::npos) << words << " in\n" << text;
  return at == std::string::npos ? 0.0 : std::stod(text.substr(at + words.size()));
}

std::map<double, double> entered_into_fanuc(const std::string& text) {
  const double reference = number_behind(text, "N3620 P1 R");
  const double unit = number_behind(text, "N3623 P1 R");
  const double interval = 0.001 * number_behind(text, "N3624 P1 R");
  std::map<double, double> corrections = {{0.0, 0.0}};
  double sum = 0.0;
  for (auto n = static_cast<int>(reference) + 1;; ++n) {
    const std::string point = fmt::format("\nN{} R", 10000 + n);
    if (text.find(point) == std::string::npos) {
      return corrections;
    }
    sum += unit * number_behind(text, point);
    corrections[(n - reference) * interval] = sum;
  }
}

std::map<double, double> entered_into_sinumerik(const std::string& text) {
  const double step = number_behind(text, "$AA_ENC_COMP_STEP[0,X1]=");
  std::map<double, double> corrections;
  for (int n = 0;; ++n) {
    const std::string point = fmt::format("$AA_ENC_COMP[0,{},X1]=", n);
    if (text.find(point) == std::string::npos) {
      return corrections;
    }
    corrections[n * step] = -1000.0 * number_behind(text, point);
  }
}

// Lines between points as far apart as the nearest targets would leave 7 of the 10 um.
TEST_F(UnevenTargets, FanucPointsAreNearEnough) {
  take(17, 60.0, 1.3);
  const std::string text = table("positioning", "fanuc", record_);
  const double left = left_by(entered_into_fanuc(text));
  EXPECT_LE(left, 0.5 * number_behind(text, "N3623 P1 R") + 1e-6);
  EXPECT_NEAR(left, number_behind(text, "MM APART LEAVE "), 0.05 + 1e-6);
  EXPECT_THAT(text, HasSubstr("(NEARER THAN THOSE: 3624 IS"));
}

// So many points as bring 121 targets near enough a Fanuc has not; it says what is left.
TEST_F(UnevenTargets, FanucSaysWhatItsPointsLeave) {
  take(121, 6.0, 0.1);
  const std::string text = table("positioning", "fanuc", record_);
  const double left = left_by(entered_into_fanuc(text));
  EXPECT_GT(left, 1.0);
  EXPECT_LT(left, 5.0);
  EXPECT_NEAR(left, number_behind(text, "MM APART LEAVE "), 0.05 + 1e-6);
}

TEST_F(UnevenTargets, SinumerikPointsAreNearEnough) {
  take(121, 8.0, 0.25);
  const std::string text = table("positioning", "sinumerik", record_);
  EXPECT_LE(left_by(entered_into_sinumerik(text)), 0.05);
  EXPECT_THAT(text, Not(HasSubstr("It leaves")));
}

TEST_F(UnevenTargets, SinumerikSaysWhatItsPointsLeave) {
  take(400, 4.0, 0.1037);
  const std::string text = table("positioning", "sinumerik", record_);
  const std::map<double, double> corrections = entered_into_sinumerik(text);
  EXPECT_LE(corrections.size(), 5000U);
  const double left = left_by(corrections);
  EXPECT_GT(left, 0.05);
  EXPECT_LT(left, 1.0);
  EXPECT_NEAR(left, number_behind(text, "; It leaves "), 0.05 + 1e-3);
}

// The corrections -8, 0 and 15 um gain 8 and 15; units of 3 um, so that none is above 7.
// The section before coordinate 0 has the number of 3620, the one behind it the next.
TEST(CompensationFormats, FanucPitchErrorsAreGainsFromPointToPoint) {
  EXPECT_THAT(table("positioning", "fanuc", kPositioning),
              HasSubstr("G10 L52\n(PITCH ERRORS OF X, UNITS OF 3 UM)\n(POINTS 100 MM APART LEAVE "
                        "1.0 UM AT THE PLACES MEASURED)\nN3620 P1 R2\nN3621 P1 R2\n"
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
