// `g31 evaluate` of readings: straightness, flatness, cylindricity, positioning.

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/run_evaluate.h"

namespace g31::readings_command_test {
namespace {

using evaluate::OptionId;
using testing::evaluate_text;
using testing::EvaluateOutput;
using testing::TemporaryFolder;

cli::EvaluateOptions of_readings(const std::string& kind) {
  cli::EvaluateOptions options;
  options.kind = kind;
  options.given[OptionId::Step] = "100";
  options.has_curves = true;
  return options;
}

/// um: a motion bowed by 10 and a work that rises by 30 and bows by 4, tips 2 and 3 off.
double motion(int k) {
  return 10.0 * (1.0 - (k / 10.0 - 1.0) * (k / 10.0 - 1.0));
}
double work(int k) {
  return 1.5 * k + 4.0 * std::sin(k * std::numbers::pi / 20.0);
}

std::string bed_file(bool is_gap, bool has_third) {
  std::string text = has_third ? "K,A,B,C\n" : "K,A,B\n";
  const double sign = is_gap ? -1.0 : 1.0;
  for (int k = 0; k <= 20; ++k) {
    text += fmt::format("{},{:.9f},{:.9f}", k, 600.0 + sign * (work(k) - motion(k)),
                        600.0 + sign * (work(k + 1) - motion(k) + 2.0));
    text +=
        has_third ? fmt::format(",{:.9f}\n", 600.0 + sign * (work(k + 2) - motion(k) + 5.0)) : "\n";
  }
  return text;
}

TEST(EvaluateStraightness, TellsMotionAndWorkApartInBothSenses) {
  for (const bool is_gap : {false, true}) {
    cli::EvaluateOptions options = of_readings("straightness");
    options.unit = "um";
    options.given[OptionId::Sense] = is_gap ? "gap" : "travel";
    const EvaluateOutput output = evaluate_text(bed_file(is_gap, true), options);
    ASSERT_EQ(output.exit_code, 0) << output.errors;
    EXPECT_NEAR(output.value("delta_1"), 2.0, 1e-7);
    EXPECT_NEAR(output.value("delta_2"), 3.0, 1e-7);
    EXPECT_NEAR(output.value("delta"), 5.0, 1e-7);
    EXPECT_NEAR(output.value("delta_closure"), 0.0, 1e-7);
    EXPECT_NEAR(output.value("motion_straightness"), 10.0, 1e-7);
    EXPECT_NEAR(output.value("motion_straightness_minimum_zone"), 10.0, 1e-7);
    EXPECT_NEAR(output.value("parallelism"), 30.0, 1e-7);
    EXPECT_NEAR(output.value("work_straightness"), 4.0, 1e-7);
    const auto& curve = output.document.at("curves").at("motion");
    ASSERT_EQ(curve.size(), 21U);
    EXPECT_NEAR(curve[10][0].get<double>(), 1000.0, 1e-12);
    EXPECT_NEAR(curve[10][1].get<double>(), 0.010, 1e-10);
  }
}

/// Of a file in um, written to bed.toml.
cli::EvaluateOptions compensated(const TemporaryFolder& folder, const std::string& from) {
  cli::EvaluateOptions options = of_readings("straightness");
  options.unit = "um";
  options.given[OptionId::Compensation] = folder.path("bed.toml");
  options.given[OptionId::From] = from;
  return options;
}

TEST(EvaluateStraightness, WritesTheCompensation) {
  TemporaryFolder folder;
  cli::EvaluateOptions options = compensated(folder, "2400");
  options.given[OptionId::Error] = "EZX";
  EXPECT_EQ(evaluate_text("A,B\n0,1\n0,-1\n0,0\n", options).exit_code, 0);
  // X* = 0, 1, 0: no slope; the motion goes to +1 um in the middle.
  EXPECT_EQ(testing::text_of(folder.path("bed.toml")),
            "# Corrections, mm, at machine coordinates of the moving axis.\n"
            "[machine.compensation]\nEZX = [\n  [2400.000000, 0.000000000],\n"
            "  [2500.000000, -0.001000000],\n  [2600.000000, 0.000000000],\n]\n");
}

// At row K the first sensor stands at place K: the file may begin anywhere.
TEST(EvaluateStraightness, PlacesAreThoseOfK) {
  TemporaryFolder folder;
  const cli::EvaluateOptions options = compensated(folder, "50");
  const EvaluateOutput output = evaluate_text("K,A,B\n5,0,1\n6,0,-1\n7,0,0\n", options);
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  const std::string sheet = testing::text_of(folder.path("bed.toml"));
  for (const char* const place : {"[550.0", "[650.0", "[750.0"}) {
    EXPECT_NE(sheet.find(place), std::string::npos) << sheet;
  }
  EXPECT_EQ(output.document.at("curves").at("work")[2][0].get<double>(), 750.0);
  const EvaluateOutput far = evaluate_text("K,A,B\n1e11,0,1\n100000000001,0,-1\n", options);
  EXPECT_EQ(far.exit_code, 2);
  EXPECT_NE(far.errors.find("further than 1000000000 mm"), std::string::npos) << far.errors;
}

TEST(EvaluateReadings, AreRefusedWithTheLine) {
  struct Case {
    const char* kind;
    const char* text;
    const char* says;
  };
  const Case kCases[] = {
      {"straightness", "K,A,B\n0,1,2\n2,1,2\n", "data.csv:3:1: error: K is 2, it should be 1"},
      {"straightness", "K,A,B\n0,1,2\n", "data.csv:2:1: error: a line needs at least two rows"},
      {"straightness", "K,A,C\n0,1,2\n", "there is no column B"},
      {"flatness", "y,K,A,B\n0,0,1,1\n0,1,1,1\n50,0,1,1\n50,1,1,1\n50,2,1,1\n",
       "data.csv:6:1: error: this line ends after 3 rows, the first has 2"},
      {"flatness", "y,K,A,B\n0,1,1,1\n0,2,1,1\n50,0,1,1\n50,1,1,1\n",
       "data.csv:4:1: error: K is 0, it should be 1"},
  };
  for (const Case& c : kCases) {
    const EvaluateOutput output = evaluate_text(c.text, of_readings(c.kind));
    EXPECT_EQ(output.exit_code, 2) << c.text;
    EXPECT_NE(output.errors.find(c.says), std::string::npos) << output.errors;
  }
  cli::EvaluateOptions options = of_readings("straightness");
  options.given.erase(OptionId::Step);
  EXPECT_NE(evaluate_text("A,B\n1,2\n", options).errors.find("straightness needs --step L"),
            std::string::npos);
}

TEST(EvaluateFlatness, OfPointsAndOfLinesOfReadings) {
  // The saddle z = 7 um u v over -1 .. 1, on a tilted plane: 14 um.
  std::string points = "x,y,z\n";
  std::string lines = "y,K,A,B\n";
  const auto height = [](int i, int j) { return 0.007 * (0.1 * i - 1.0) * (0.1 * j - 1.0); };
  for (int j = 0; j <= 20; ++j) {
    for (int i = 0; i <= 20; ++i) {
      points += fmt::format("{},{},{:.12f}\n", 100 * i, 50 * j, height(i, j) + 0.001 * i);
      const double bow = 1e-3 * motion(i);
      lines += fmt::format("{},{},{:.12f},{:.12f}\n", 50 * j, i, height(i, j) - bow,
                           height(i + 1, j) - bow + 0.002);
    }
  }
  cli::EvaluateOptions options = of_readings("flatness");
  EXPECT_NEAR(evaluate_text(lines, options).value("flatness_minimum_zone"), 14.0, 1e-6);
  options.given.erase(OptionId::Step);
  EXPECT_NEAR(evaluate_text(points, options).value("flatness_minimum_zone"), 14.0, 1e-6);
  // One row of touches spans no face, however crooked it is.
  for (const char* const row :
       {"x,y,z\n0,0,0\n1,1,0\n2,2,0\n", "x,y,z\n0,0,0\n30,0,0.02\n60,0,-0.01\n100,0,0\n"}) {
    EXPECT_NE(evaluate_text(row, options).errors.find("on one line"), std::string::npos) << row;
  }
}

/// A row of touches that is rougher than a thousandth of its length is no face either; a wall is,
/// whose points lie on one line in x and y: 60 mm high and bowed by 12 um.
TEST(EvaluateFlatness, OfARoughRowIsRefusedAndOfAWallIsNot) {
  cli::EvaluateOptions options = of_readings("flatness");
  options.given.erase(OptionId::Step);
  std::string row = "x,y,z\n";
  std::string oblique = row;
  for (int i = 0; i <= 10; ++i) {
    const double rough = 0.012 * (i * 7 % 5 - 2);
    row += fmt::format("{},0,{:.6f}\n", i, rough);
    oblique += fmt::format("{},{},{:.6f}\n", i, 2 * i, 0.1 * i + rough);
  }
  for (const std::string& text : {row, oblique}) {
    const EvaluateOutput output = evaluate_text(text, options);
    EXPECT_EQ(output.exit_code, 2);
    EXPECT_NE(output.errors.find(
                  "data.csv: error: the points lie on one line in x and y, and in z "
                  "within a twentieth of its length; a narrow upright face is taken from its "
                  "side with --columns y=z,z=y [DAT113]"),
              std::string::npos)
        << output.errors;
  }
  std::string wall = "x,y,z\n";
  for (int i = 0; i <= 10; ++i) {
    for (int k = 0; k <= 6; ++k) {
      const double bow = 0.012 * (1.0 - (i - 5) * (i - 5) / 25.0);
      wall += fmt::format("{},{:.6f},{}\n", 10 * i, 5.0 + bow, 10 * k);
    }
  }
  EXPECT_NEAR(evaluate_text(wall, options).value("flatness_minimum_zone"), 12.0, 1e-3);
  // A rail of 4 mm by 200 mm, from its side: bowed by 4 um.
  std::string rail = "x,y,z\n";
  for (int i = 0; i <= 10; ++i) {
    for (const double z : {-2.0, 2.0}) {
      rail += fmt::format("{},{:.6f},{}\n", 20 * i, 0.004 * (1.0 - (i - 5) * (i - 5) / 25.0), z);
    }
  }
  EXPECT_EQ(evaluate_text(rail, options).exit_code, 2);
  options.columns = {"y=z", "z=y"};
  EXPECT_NEAR(evaluate_text(rail, options).value("flatness_minimum_zone"), 4.0, 1e-3);
}

/// A barrel of radius 10, thicker by 8 um in the middle and off the axis, on a bowed slide.
std::string shaft_file() {
  std::string text = "K,theta,A,B\n";
  const auto radius = [](int k, double angle) {
    const double s = k / 7.0 - 1.0;
    return 10.0 + 0.008 * (1.0 - s * s) + 0.003 * std::cos(angle) + 0.002 * s * std::sin(angle);
  };
  for (int degrees = 0; degrees < 360; degrees += 30) {
    const double angle = degrees * std::numbers::pi / 180.0;
    for (int k = 0; k <= 14; ++k) {
      const double slide = 0.005 * std::sin(k * std::numbers::pi / 14.0);
      text += fmt::format("{},{},{:.12f},{:.12f}\n", k, degrees, radius(k, angle) - slide,
                          radius(k + 1, angle) - slide + 0.001);
    }
  }
  return text;
}

TEST(EvaluateCylindricity, FindsTheBarrelAndNotTheSlide) {
  TemporaryFolder folder;
  cli::EvaluateOptions options = of_readings("cylindricity");
  // Between 0 and 180 degrees the displacement of the axis cancels.
  options.given[OptionId::Diameters] = folder.write("ends.csv", "K,d\n0,20\n14,20\n");
  const EvaluateOutput output = evaluate_text(shaft_file(), options);
  ASSERT_EQ(output.exit_code, 0) << output.errors;
  EXPECT_NEAR(output.value("cylindricity_minimum_zone"), 8.0, 1e-3);  // e^2 / 2r is 0.4 nm
  EXPECT_NEAR(output.value("cylindricity_least_squares"), 8.0, 1e-3);
  EXPECT_EQ(output.document.at("curves").size(), 12U);
  EXPECT_NEAR(output.document.at("curves").at("theta_90").at(14)[0].get<double>(), 1400.0, 1e-9);
  // Every line is the barrel, 8 um less than in the middle at its ends; that the work stands and
  // leans beside the axis it turns about is not in it.  The mean of 1 - s^2 over 15 places is
  // 0.619.
  for (const auto& [name, curve] : output.document.at("curves").items()) {
    for (int k = 0; k <= 14; ++k) {
      const double s = k / 7.0 - 1.0;
      EXPECT_NEAR(curve.at(static_cast<std::size_t>(k))[1].get<double>(),
                  0.008 * (1.0 - s * s - 13.0 / 21.0), 2e-6)
          << name << " " << k;
    }
  }

  options.given[OptionId::Diameters] = folder.write("one.csv", "K,d\n0,20\n");
  EXPECT_NE(evaluate_text(shaft_file(), options).errors.find("diameters are needed at both ends"),
            std::string::npos);
  EXPECT_NE(evaluate_text("K,theta,A,B\n0,0,1,1\n1,0,1,1\n", options)
                .errors.find("readings at theta 0 and 180"),
            std::string::npos);
}

TEST(EvaluatePositioning, IsThatOfTheStandard) {
  std::string text = "axis,target,direction,cycle,position\n";
  const auto row = [&](double target, int direction, int cycle, double um) {
    text += fmt::format("X,{},{},{},{:.6f}\n", target, direction, cycle, target + 1e-3 * um);
  };
  for (int cycle = 1; cycle <= 3; ++cycle) {
    row(0.0, 1, cycle, cycle);             // mean 2, s 1
    row(0.0, -1, cycle, 2.0 + 2 * cycle);  // mean 6, s 2
    row(100.0, 1, cycle, 3.0);             // mean 3, s 0
    row(100.0, -1, cycle, cycle);          // mean 2, s 1
  }
  cli::EvaluateOptions options;
  options.kind = "positioning";
  const EvaluateOutput output = evaluate_text(text, options);
  ASSERT_EQ(output.exit_code, 0) << output.errors;
  const std::pair<const char*, double> kExpected[] = {{"A", 10.0}, {"A_up", 4.0}, {"A_down", 10.0},
                                                      {"R", 10.0}, {"R_up", 4.0}, {"R_down", 8.0},
                                                      {"B", 4.0},  {"E", 4.0},    {"M", 1.5}};
  for (const auto& [name, value] : kExpected) {
    EXPECT_NEAR(output.value(name), value, 1e-6) << name;
  }
  const std::string two_axes = text + "Y,0,1,1,0\n";
  EXPECT_NE(evaluate_text(two_axes, options)
                .errors.find("data.csv:14:1: error: axis is Y, it should be X"),
            std::string::npos);
  options.given[OptionId::Axis] = "X";
  EXPECT_NEAR(evaluate_text(two_axes, options).value("B"), 4.0, 1e-6);
  EXPECT_NE(evaluate_text(text + "X,0,2,1,0\n", options)
                .errors.find("data.csv:14:1: error: direction is 2, it should be +1 or -1"),
            std::string::npos);
  EXPECT_NE(
      evaluate_text(text + "X,300,1,1,300\n", options).errors.find("was approached only once"),
      std::string::npos);
}

TEST(EvaluatePositioning, IsOfLinearAxes) {
  cli::EvaluateOptions options;
  options.kind = "positioning";
  const auto evaluated = [&](const std::string& axis) {
    return evaluate_text(
        fmt::format("axis,target,direction,cycle,position\n{0},0,1,1,0\n{0},0,1,2,0.001\n"
                    "{0},90,1,1,90\n{0},90,1,2,90\n",
                    axis),
        options);
  };
  for (const char* const axis : {"A", "B", "C", "C4"}) {
    EXPECT_EQ(evaluated(axis).exit_code, 2) << axis;
    EXPECT_NE(evaluated(axis).errors.find(
                  fmt::format("data.csv:2:1: error: {} is a rotary axis, its places are degrees: "
                              "positioning is of linear axes, in mm [DAT116]",
                              axis)),
              std::string::npos)
        << evaluated(axis).errors;
  }
  for (const char* const axis : {"X", "W", "X1", "Base"}) {
    EXPECT_EQ(evaluated(axis).exit_code, 0) << axis;
  }
}

TEST(EvaluatePositioning, RefusesASecondReadingAndPartsOfCycles) {
  cli::EvaluateOptions options;
  options.kind = "positioning";
  options.given[OptionId::Axis] = "X";
  const std::string text =
      "axis,target,direction,cycle,position\nX,0,1,1,0.001\nX,0,1,2,0.002\nX,0,-1,1,0\nX,0,-1,2,"
      "0\n";
  const auto errors = [&](const std::string& row) {
    const EvaluateOutput output = evaluate_text(text + row, options);
    EXPECT_EQ(output.exit_code, output.errors.empty() ? 0 : 2);
    return output.errors;
  };
  EXPECT_NE(errors("X,0,1,1,0.003\n")
                .find("data.csv:6:1: error: cycle is 1, it should be another than in line 2, which "
                      "has the same target and direction [DAT112]"),
            std::string::npos);
  EXPECT_NE(errors("X,0,1,2.5,0.003\n")
                .find("data.csv:6:1: error: cycle is 2.5, it should be a whole number [DAT112]"),
            std::string::npos);
  EXPECT_EQ(errors("X,0,1,3,0.003\nY,0,1,1,0\n"), "") << "another cycle, another axis";
}

TEST(EvaluatePositioning, SaysWhyAResultHasNoValue) {
  cli::EvaluateOptions options;
  options.kind = "positioning";
  const std::string up =
      "axis,target,direction,cycle,position\nX,0,1,1,0.001\nX,0,1,2,0.002\nX,9,1,1,9\nX,9,1,2,9\n";
  const auto notes = [&](const std::string& text) {
    return evaluate_text(text, options).document.at("notes");
  };
  using Texts = std::vector<std::string>;
  EXPECT_EQ(notes(up), Texts{"2 of 2 targets were not approached in the negative direction, first "
                             "0 mm: A_down, R_down and E_down need every target from that side, A, "
                             "R, B, E and M from both"});
  EXPECT_EQ(
      notes(up + "X,0,-1,1,0\nX,0,-1,2,0\n"),
      Texts{"1 of 2 targets was not approached in the negative direction, first 9 mm: A_down, "
            "R_down and E_down need every target from that side, A, R, B, E and M from both"});
  const std::string even = up + "X,0,-1,1,0\nX,0,-1,2,0\nX,9,-1,1,9\nX,9,-1,2,9\n";
  EXPECT_EQ(notes(even), Texts());
  EXPECT_EQ(notes(even + "X,9,1,3,9\nX,9,-1,3,9\n"),
            Texts{"target 0 mm was approached 2 times in the positive direction, others 3 times: "
                  "the standard has the same number for all"});
}

}  // namespace
}  // namespace g31::readings_command_test
