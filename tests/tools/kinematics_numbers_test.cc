// The calculations of CYCLE9960 from numbers alone: positions of rotary axes, vectors from
// positions of the ball.

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/kinematics_run.h"

namespace g31::testing::kinematics_numbers_test {
namespace {

/// A printed example: begin, end, number of the points; the positions.
struct Series {
  const char* name;
  const char* asked;  ///< BEGIN, DONE, MANY
  bool is_modulo;
  bool is_made;        ///< at home, before
  bool has_reference;  ///< which counts
  bool is_grid;
  std::vector<double> positions;  ///< without the reference at 0
};

/// Measuring cycles 828D, 01/2023, 4.3.23.3, and its log of a measurement.
const Series kSeries[] = {
    {"1a", "-90,0,3", false, true, true, false, {-90, -45}},
    {"1b", "0,90,3", false, true, true, false, {45, 90}},
    {"2a", "270,0,4", true, true, true, false, {270, 300, 330}},
    {"2b", "0,270,4", true, true, true, false, {90, 180, 270}},
    {"3", "30,180,6", false, true, true, true, {30, 60, 90, 120, 150, 180}},
    {"4", "-180,180,6", false, true, true, false, {-180, -120, -60, 60, 120}},
    {"5 axis 1", "-120,120,6", false, true, false, false, {-120, -72, -24, 24, 72, 120}},
    {"5 axis 2", "-120,120,6", false, true, true, false, {-120, -60, 60, 120}},
    {"log C1", "120,240,3", true, false, false, false, {120, 180, 240}},
    {"log A1", "30,90,3", false, true, true, false, {30, 90}},
    // Home is an end of the range of axis 1, and is there already.
    {"axis 1 from home", "-90,0,4", false, true, false, false, {-90, -60, -30}},
};

const char* said(bool value) {
  return value ? "TRUE" : "FALSE";
}

TEST(KinematicsNumbers, RotaryAxesGoWhereTheManualPrints) {
  for (const Series& series : kSeries) {
    SCOPED_TRACE(series.name);
    std::vector<ExpectedValue> expected = {{"R0", static_cast<double>(series.positions.size())}};
    for (std::size_t i = 0; i < series.positions.size(); ++i) {
      expected.push_back({fmt::format("R{}", i + 1), series.positions[i]});
    }
    const MeasuringRun run = run_on_sheets(
        fmt::format("DEF REAL POS[13]\nDEF INT COUNT, NN\n"
                    "_MC_KPLACES({},0,{},{},{},{},POS,COUNT)\nR0=COUNT\nFOR NN=0 TO COUNT-1\n"
                    "R[NN+1]=POS[NN]\nENDFOR",
                    series.asked, said(series.is_modulo), said(series.is_made),
                    said(series.has_reference), said(series.is_grid)),
        {kMeasuringSheet}, names_of(expected));
    expect_values(run, expected, 1e-9);
  }
}

/// A carrier, stored positions of the ball, and the call that only corrects.
std::string corrected(const std::string& carrier, int first, int second, double probe,
                      const std::vector<std::vector<double>>& positions,
                      const std::string& settings = {}) {
  std::string text = "T1 M6\nG54 D1\n" + carrier;
  text += fmt::format("_OVR[120]={} _OVR[121]={} _OVR[50]={}\n", first, second, probe);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    for (std::size_t j = 0; j < 5; ++j) {
      text += fmt::format("_MEA_MKS[{},{}]={:.9f} ", i, j, positions[i][j]);
    }
    text += "\n";
  }
  return text + settings;
}

std::string rotary_sheet() {
  return std::string(kMeasuringSheet) + "[machine]\ntable_side = \"\"\ntool_side = \"XYZCA\"\n";
}

/// D-1: the axis parallel to Z through (0.1, -0.2), positions at 0, 45 and 90.
std::string one_table(const std::string& settings) {
  return corrected(
      "$TC_CARR23[1]=\"P\" $TC_CARR7[1]=0 $TC_CARR8[1]=0 $TC_CARR9[1]=1 $TC_CARR10[1]=0 "
      "$TC_CARR11[1]=0 $TC_CARR12[1]=0\n$TC_CARR4[1]=0 $TC_CARR5[1]=0 $TC_CARR6[1]=0 "
      "$TC_CARR15[1]=0 $TC_CARR16[1]=0 $TC_CARR17[1]=0\n",
      2, 0, 0,
      {{250, 40, 120, 0, 0}, {148.380292, 204.931677, 120, 45, 0}, {-40.1, 249.7, 120, 90, 0}},
      settings + "\nCYCLE9960(42400,\"\",1)");
}

TEST(KinematicsNumbers, TheTableOfTheWorkedExample) {
  const std::vector<ExpectedValue> expected = {
      {"_OVR[4]", 0.1}, {"_OVR[5]", -0.2},     {"_OVR[6]", 120.0},     {"_OVR[7]", 0.0},
      {"_OVR[9]", 1.0}, {"$TC_CARR4[1]", 0.1}, {"$TC_CARR18[1]", -0.1}};
  expect_values(run_on_sheets(one_table(""), {rotary_sheet()}, names_of(expected)), expected, 2e-6);
  // A fixed value in place of the height of the ball; one that is entered; an open chain.
  const std::vector<ExpectedValue> fixed = {
      {"_OVR[4]", 0.1}, {"_OVR[5]", -0.2}, {"_OVR[6]", -37.5}, {"_OVR[20]", 37.5}};
  expect_values(run_on_sheets(one_table("$SCS_MEA_KIN_MODE[0]=3 $SCS_MEA_KIN_VALUE[0]=-37.5"),
                              {rotary_sheet()}, names_of(fixed)),
                fixed, 2e-6);
  const std::vector<ExpectedValue> open = {{"_OVR[4]", 0.1}, {"_OVR[6]", 7.0}, {"_OVR[20]", 0.0}};
  expect_values(
      run_on_sheets(one_table("$TC_CARR6[1]=7\n$SCS_MEA_KIN_MODE[0]=6 $SCS_MEA_KIN_MODE[1]=10"),
                    {rotary_sheet()}, names_of(open)),
      open, 2e-6);
}

TEST(KinematicsNumbers, TheLeastAngleOfTheTriangleIsThatOfTheSetting) {
  const std::string fails = one_table("$SCS_MEA_KIN_MIN_ANG_TRIANGLE=25");
  EXPECT_EQ(run_on_sheets(fails, {rotary_sheet()}, {}).alarm(), 61430);
  EXPECT_EQ(
      run_on_sheets(one_table("$SCS_MEA_KIN_MIN_ANG_TRIANGLE=22.4"), {rotary_sheet()}, {}).alarm(),
      0);
}

/// D-2: a head C A; what cannot be seen stays as entered.
TEST(KinematicsNumbers, TheHeadOfTheWorkedExample) {
  const std::string carrier =
      "$TC_CARR1[1]=0 $TC_CARR2[1]=0 $TC_CARR3[1]=-80\n"
      "$TC_CARR4[1]=9.5 $TC_CARR5[1]=0 $TC_CARR6[1]=30.1564\n"
      "$TC_CARR15[1]=-0.0161 $TC_CARR16[1]=0 $TC_CARR17[1]=50\n";
  const std::vector<std::vector<double>> positions = {{300, -100, 200, 0, 0},
                                                      {372.264787, -41.837368, 173.238380, 120, 30},
                                                      {281.022800, -0.115274, 173.238380, 180, 30},
                                                      {199.269413, -58.272106, 173.238380, 240, 30},
                                                      {300, -199.873126, 173.238380, 0, 30},
                                                      {300, -299.745300, 0.252100, 0, 90}};
  const std::vector<ExpectedValue> expected = {
      {"_OVR[1]", -9.4886}, {"_OVR[2]", 0.0058},   {"_OVR[3]", -79.903},  {"_OVR[4]", 9.5047},
      {"_OVR[5]", -0.0045}, {"_OVR[6]", 30.1564},  {"_OVR[7]", 0.0},      {"_OVR[9]", 1.0},
      {"_OVR[10]", 1.0},    {"_OVR[15]", -0.0161}, {"_OVR[16]", -0.0013}, {"_OVR[17]", 49.7466}};
  for (const char* const mask :
       {"", "$SCS_MEA_FUNCTION_MASK=6373377", "$SCS_MEA_FUNCTION_MASK=4276225"}) {
    SCOPED_TRACE(mask);
    expect_values(run_on_sheets(corrected(carrier, 3, 2, 150, positions,
                                          fmt::format("$SCS_MEA_KIN_MIN_ANG_TRIANGLE=10\n{}\n"
                                                      "CYCLE9960(12400,\"\",1)",
                                                      mask)),
                                {rotary_sheet()}, names_of(expected)),
                  expected, 1e-5);
  }
}

/// Points that lie on no circle: both ways to find the middle, by reckoning.
TEST(KinematicsNumbers, MoreThanThreePointsGoByBisectorsOrByLeastSquares) {
  // On both axes at 10, but for one at 10.4.  Bisectors, least squares: the sum of x (x^2 + y^2)
  // over twice the sum of x^2, about the mean (0.1, 0).  Distances: the middle m has its mean
  // distance where the sum of (distance - mean) times the direction vanishes.
  const std::vector<std::vector<double>> positions = {
      {10.4, 0, 0, 0, 0}, {0, 10, 0, 90, 0}, {-10, 0, 0, 180, 0}, {0, -10, 0, 270, 0}};
  const std::string carrier =
      "$TC_CARR23[1]=\"P\" $TC_CARR7[1]=0 $TC_CARR8[1]=0 $TC_CARR9[1]=1 $TC_CARR10[1]=0 "
      "$TC_CARR11[1]=0 $TC_CARR12[1]=0\n";
  const double mean = 0.1;
  double above = 0.0;
  double below = 0.0;
  for (const auto& p : positions) {
    const double x = p[0] - mean;
    above += x * (x * x + p[1] * p[1]);
    below += 2.0 * x * x;
  }
  const std::vector<ExpectedValue> bisectors = {{"_OVR[4]", mean + above / below},
                                                {"_OVR[5]", 0.0}};
  expect_values(run_on_sheets(corrected(carrier, 3, 0, 0, positions, "CYCLE9960(42400,\"\",1)"),
                              {rotary_sheet()}, names_of(bisectors)),
                bisectors, 1e-9);
  // Along X: (10.4 - m - r) - (10 + m - r) - 2 (m / d) (d - r) = 0, d = sqrt(100 + m^2).
  double m = 0.2;
  for (int i = 0; i < 100; ++i) {
    const double d = std::sqrt(100.0 + m * m);
    const double r = (10.4 - m + 10.0 + m + 2.0 * d) / 4.0;
    m = (0.4 - 2.0 * (m / d) * (d - r)) / 2.0;
  }
  const std::vector<ExpectedValue> least = {{"_OVR[4]", m}, {"_OVR[5]", 0.0}};
  ASSERT_GT(std::abs(m - bisectors[0].value), 1e-5);
  expect_values(run_on_sheets(corrected(carrier, 3, 0, 0, positions,
                                        "$SCS_MEA_FUNCTION_MASK=2179073\nCYCLE9960(42400,\"\",1)"),
                              {rotary_sheet()}, names_of(least)),
                least, 1e-9);
}

}  // namespace
}  // namespace g31::testing::kinematics_numbers_test
