// `g31 evaluate` of squares, speed and diagonals.

#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/run_evaluate.h"
#include "tools/evaluate/evaluation.h"

namespace g31::path_command_test {
namespace {

using evaluate::OptionId;
using testing::evaluate_text;
using testing::EvaluateOutput;

cli::EvaluateOptions of_kind(const std::string& kind) {
  cli::EvaluateOptions options;
  options.kind = kind;
  return options;
}

TEST(EvaluateDiagonal, IsTheExampleOfThePaper) {
  cli::EvaluateOptions options = of_kind("diagonal");
  options.given[OptionId::Target] = "50,50";
  const EvaluateOutput output = evaluate_text("X,Y\n0,0\n25,25\n49.993,49.996\n", options);
  ASSERT_EQ(output.exit_code, 0) << output.errors;
  EXPECT_NEAR(output.value("error_X"), -7.0, 1e-9);
  EXPECT_NEAR(output.value("error_Y"), -4.0, 1e-9);
  EXPECT_NEAR(output.value("error_X_on"), -42.0, 1e-9);
  EXPECT_NEAR(output.value("error_Y_on"), -24.0, 1e-9);
  EXPECT_EQ(output.document.at("samples"), 3);
}

TEST(EvaluateDiagonal, OfATargetOnAnAxisHasNothingToScale) {
  cli::EvaluateOptions options = of_kind("diagonal");
  options.given[OptionId::Target] = "50,0";
  const EvaluateOutput output = evaluate_text("X,Y\n50.001,0.002\n", options);
  EXPECT_TRUE(output.document.at("results").at("error_Y_on").at("value").is_null());
  options.given.clear();
  EXPECT_EQ(evaluate_text("X,Y\n50,0\n", options).errors,
            "g31: error: diagonal needs --target X,Y: where the move should have ended\n");
}

std::string square_file() {
  std::string text = "t,X,Y\n";
  for (int i = 0; i <= 400; ++i) {
    const int s = (i + 50) % 400;  // from the middle of a side
    const double x = s < 100 ? 50.0 : s < 200 ? 150.0 - s : s < 300 ? -50.0 : s - 350.0;
    const double y = s < 100 ? s - 50.0 : s < 200 ? 50.0 : s < 300 ? 250.0 - s : -50.0;
    text += fmt::format("{},{},{}\n", 0.02 * i, x, y);
  }
  return text;
}

TEST(EvaluateSquare, NamesItsCornersCounterClockwise) {
  cli::EvaluateOptions options = of_kind("square");
  options.given[OptionId::Side] = "100";
  options.given[OptionId::Centre] = "0,0";
  std::string text = square_file();
  // The corner at -X +Y is cut by 0.01 and 0.01, the one at +X -Y overshot.
  const auto move = [&](const std::string& from, const std::string& to) {
    ASSERT_NE(text.find(from), std::string::npos) << from;
    text.replace(text.find(from), from.size(), to);
  };
  move(",-50,50\n", ",-49.99,49.99\n");
  move(",50,-50\n", ",50.002,-50.002\n");
  const EvaluateOutput output = evaluate_text(text, options);
  ASSERT_EQ(output.exit_code, 0) << output.errors;
  EXPECT_NEAR(output.value("corner_error_1"), 0.0, 1e-9);
  EXPECT_NEAR(output.value("corner_error_2"), -10.0 * std::sqrt(2.0), 1e-6);
  EXPECT_NEAR(output.value("corner_error_3"), 0.0, 1e-9);
  EXPECT_NEAR(output.value("corner_error_4"), 2.0 * std::sqrt(2.0), 1e-6);
  EXPECT_NEAR(output.value("corner_error_max"), -10.0 * std::sqrt(2.0), 1e-6);
}

/// A way from inside that ends in the middle of the first side, and the square from `begin` mm
/// behind it, a row each `step` mm.
std::string walked_square(double lead, double begin, double step) {
  std::string text = "t,X,Y\n";
  int row = 0;
  const auto add = [&](double x, double y) {
    text += fmt::format("{:.3f},{:.9f},{:.9f}\n", 1e-3 * row++, x, y);
  };
  for (double place = lead; place > 0.5 * step; place -= step) {
    add(50.0 - place, 0.0);
  }
  for (int i = 0; i * step < 400.0 + 0.5 * step; ++i) {
    const double s = std::fmod(i * step + begin + 50.0, 400.0);
    const double q = std::fmod(s, 100.0) - 50.0;
    const double x = s < 100.0 ? 50.0 : s < 200.0 ? -q : s < 300.0 ? -50.0 : q;
    const double y = s < 100.0 ? q : s < 200.0 ? 50.0 : s < 300.0 ? -q : -50.0;
    add(x, y);
  }
  return text;
}

TEST(EvaluateSquare, SaysWhatDoesNotCount) {
  cli::EvaluateOptions options = of_kind("square");
  options.given[OptionId::Side] = "100";
  const EvaluateOutput output = evaluate_text(walked_square(50.0, 0.0, 0.02), options);
  ASSERT_EQ(output.exit_code, 0) << output.errors;
  EXPECT_NEAR(output.value("centre_x"), 0.0, 1e-6);
  EXPECT_NEAR(output.value("corner_error_max"), 0.0, 1e-3);
  const std::string note = output.document.at("notes")[0];
  EXPECT_EQ(note.substr(5), " of 22501 samples lie on the square, the others do not count");
  // Of rows 0.02 mm apart it begins and ends at those with the least error, within 0.2 mm.
  EXPECT_NEAR(std::stoi(note), 20001, 20);
}

TEST(EvaluateSquare, SaysWhereACornerIsTakenToBeSharp) {
  cli::EvaluateOptions options = of_kind("square");
  options.given[OptionId::Side] = "100";
  options.given[OptionId::Centre] = "0,0";
  EXPECT_TRUE(evaluate_text(square_file(), options).document.at("notes").empty())
      << "there are rows at the corners";
  const EvaluateOutput output = evaluate_text(walked_square(0.0, 0.25, 1.0), options);
  ASSERT_EQ(output.exit_code, 0) << output.errors;
  EXPECT_NEAR(output.value("corner_error_max"), 0.0, 1e-9);
  // The chord from 0.75 before to 0.25 behind crosses at 0.75 x 0.25 from both sides.
  EXPECT_EQ(output.document.at("notes"),
            std::vector<std::string>{
                "corner_error_1, corner_error_2, corner_error_3, corner_error_4: the path turns "
                "between two samples and is taken to be sharp there; were it rounded, by up to "
                "265.2 um further inside, no sample would show it"});
}

/// A centre a metre away is shown to the nanometre, as its uncertainty is worth something.
TEST(EvaluationTable, ShowsLengthsToTheNanometre) {
  evaluate::Evaluation evaluation;
  evaluation.kind = evaluate::Kind::Circle;
  evaluation.samples = 3;
  evaluation.results = {{"radius", 50.0, "mm"},
                        {"centre_x", 1234.5678912, "mm", 4e-6},
                        {"centre_y", -0.00012345678, "mm"},
                        {"backlash_X", 1234.5678912, "um"}};
  EXPECT_EQ(evaluate::evaluation_table(evaluation),
            "circle, 3 samples\n"
            "  radius                                     50 mm    \n"
            "  centre_x                          1234.567891 mm      u 4e-06\n"
            "  centre_y                         -0.000123457 mm    \n"
            "  backlash_X                            1234.57 um    \n");
}

TEST(EvaluateSpeed, ListsItsDips) {
  std::string text = "t,X,Y\n";
  double x = 0.0;
  for (int i = 0; i <= 300; ++i) {
    text += fmt::format("{},{:.9f},0\n", 0.01 * i, x);
    x += 0.01 * (i >= 100 && i < 120 ? 5.0 : 10.0);
  }
  cli::EvaluateOptions options = of_kind("speed");
  options.has_curves = true;
  const EvaluateOutput output = evaluate_text(text, options);
  ASSERT_EQ(output.exit_code, 0) << output.errors;
  EXPECT_NEAR(output.value("speed_max"), 600.0, 1e-3);
  EXPECT_NEAR(output.value("speed_min"), 300.0, 1e-3);
  const auto& dips = output.document.at("results").at("dips");
  ASSERT_EQ(dips.size(), 1U);
  EXPECT_NEAR(dips[0].at("speed"), 300.0, 1e-3);
  EXPECT_NEAR(dips[0].at("width"), 0.2, 0.01);
  EXPECT_NEAR(dips[0].at("time"), 1.1, 0.11);
  EXPECT_EQ(output.document.at("curves").at("speed").size(), 300U);
  options.given[OptionId::Side] = "3";
  EXPECT_EQ(evaluate_text(text, options).errors, "g31: error: --side is of square, not of speed\n");
  options.given.clear();
  options.magnify = "10";
  EXPECT_EQ(evaluate_text(text, options).errors,
            "g31: error: --magnify is of circle and square, not of speed\n");
}

}  // namespace
}  // namespace g31::path_command_test
