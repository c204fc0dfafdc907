// Our tool setting macros O9851 to O9859: tools that the sheet knows truly are measured as what
// they are, and what goes wrong writes nothing.

#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/run_program.h"

namespace g31::fanuc_tool_setting_test {
namespace {

using testing::RunOutput;

/// The control believes other sizes than the tools have.
constexpr const char* kTools = R"(
[tools.1]
length = 99.9
radius = 8.2
[tools.2]
length = 120.0
radius = 10.0
[tools.3]
length = 110.0
radius = 6.0
[tools.90]
length = 105.0
radius = 5.0
[[tool]]
number = 90
kind = "calibration"
length = 105.0
diameter = 10.0
[[tool]]
number = 1
length = 100.3
diameter = 16.0
[[tool]]
number = 2
length = 120.25
diameter = 20.5
teeth = [{ angle_deg = 0.0 }, { angle_deg = 120.0, radius = 10.24 }, { angle_deg = 240.0, length = 120.2 }]
[[tool]]
number = 3
kind = "drill"
length = 107.9
diameter = 12.0
)";

constexpr const char* kPlate = R"(
[[tool_probe]]
name = "setter"
at = [200.3, -100.4, -399.2]
size = [25.0, 26.0, 30.0]
)";

/// 0.75 mm thick, beside the middle.
constexpr const char* kChip = R"(
[[part]]
shape = "block"
at = [203.0, -100.4, -398.45]
length = 2.0
width = 3.0
height = 0.75
)";

/// What calibration finds of the plate.
constexpr const char* kCalibrated = "#540=200.3\n#541=-100.4\n#542=-399.2\n#543=25.\n#544=26.\n";

constexpr const char* kLaser = R"(
[[tool_probe]]
name = "laser"
shape = "laser"
at = [200.0, -100.4, -399.2]
size = [300.0, 0.5]
)";

constexpr const char* kCalibrate = "T90 M6\nG65 P9851 X200. Y-100. Z-400. K105. D10. S25.\n";

class Shop {
 public:
  explicit Shop(const std::string& probe, const std::string& blocks,
                const std::string& further = {}) {
    cli::RunOptions options;
    options.programs = {folder_.write("main.nc", "%\nO1\nG21 G90 G17 G54\n" + blocks + "M30\n%\n")};
    options.setups = {folder_.write("sheet.toml", further + kTools + probe)};
    options.libraries = {"macros/fanuc"};
    options.control = "fanuc-30i";
    options.json = folder_.path("document.json");
    for (const char* name : {"#540", "#541", "#542", "#543", "#544", "#548", "#550", "#552", "#553",
                             "#554", "#11001", "#10001", "#13001", "#12001", "#11002", "#13002"}) {
      options.prints.emplace_back(name);
    }
    run_ = testing::run_program(options);
  }

  [[nodiscard]] std::optional<double> value(const std::string& name) const {
    const auto& variables = run_.document["variables"];
    return variables.contains(name) && variables[name].is_number()
               ? std::optional(variables[name].get<double>())
               : std::nullopt;
  }
  [[nodiscard]] int alarm() const {
    const auto& alarm = run_.document["alarm"];
    return alarm.is_object() ? alarm["number"].get<int>() : 0;
  }
  [[nodiscard]] int exit_code() const { return run_.exit_code; }
  [[nodiscard]] const std::string& errors() const { return run_.errors; }

 private:
  testing::TemporaryFolder folder_;
  RunOutput run_;
};

void expect_value(const Shop& shop, const std::string& name, double wanted, double within = 1e-6) {
  const auto value = shop.value(name);
  ASSERT_TRUE(value) << name << '\n' << shop.errors();
  EXPECT_NEAR(*value, wanted, within) << name;
}

TEST(FanucToolSetting, CalibrationFindsThePlateAsItIs) {
  const Shop shop(kPlate, kCalibrate);
  EXPECT_EQ(shop.exit_code(), 0) << shop.errors();
  expect_value(shop, "#540", 200.3);
  expect_value(shop, "#541", -100.4);
  expect_value(shop, "#542", -399.2);
  expect_value(shop, "#543", 25.0);
  expect_value(shop, "#544", 26.0);
}

TEST(FanucToolSetting, PreTravelIsInTheCalibration) {
  const std::string plate = std::string(kPlate) + "pre_travel_mm = 0.02\n";
  const Shop shop(plate, std::string(kCalibrate) + "T1 M6\nG65 P9852 H1\nG65 P9853 H1 D1\n");
  expect_value(shop, "#542", -399.22);
  expect_value(shop, "#543", 24.96);
  expect_value(shop, "#11001", 100.3);
  expect_value(shop, "#13001", 8.0);
}

TEST(FanucToolSetting, LengthAndDiameterReplaceWhatWasBelieved) {
  const std::string measure = "T1 M6\nG65 P9852 H1 Q1.\nG65 P9853 H1 D1 Q1.\n";
  const Shop shop(kPlate, kCalibrate + measure,
                  "[variables]\n\"#10001\" = 0.05\n\"#12001\" = -0.1\n");
  EXPECT_EQ(shop.exit_code(), 0) << shop.errors();
  expect_value(shop, "#11001", 100.3);
  expect_value(shop, "#10001", 0.0);
  expect_value(shop, "#13001", 8.0);
  expect_value(shop, "#12001", 0.0);
  // Measured again it is what it was.
  const Shop again(kPlate, kCalibrate + measure + "G65 P9852 H1\n");
  expect_value(again, "#548", 0.0);
}

TEST(FanucToolSetting, ATurningCutterIsAsLongAndWideAsItsOutermostTeeth) {
  const Shop shop(kPlate, std::string(kCalibrate) + "T2 M6\nG65 P9854 H2 D2 S800 R10.\n");
  EXPECT_EQ(shop.exit_code(), 0) << shop.errors();
  // Feed per revolution is 0.005 mm: no tooth is felt later.
  expect_value(shop, "#11002", 120.25, 5e-3);
  expect_value(shop, "#13002", 10.25, 5e-3);
  EXPECT_LE(*shop.value("#11002"), 120.25 + 1e-9);
  EXPECT_LE(*shop.value("#13002"), 10.25 + 1e-9);
}

TEST(FanucToolSetting, ARadiusThatIsRefusedLeavesTheLengthAsItWas) {
  const std::string measure = std::string(kCalibrate) + "#11002=120.2\n#13002=9.9\nT2 M6\n";
  const Shop refused(kPlate, measure + "G65 P9854 H2 D2 S800 R10. Q.1\n");
  EXPECT_EQ(refused.alarm(), 3173) << "the radius is 0.35 off, the length 0.05";
  expect_value(refused, "#11002", 120.2, 0.0);
  expect_value(refused, "#13002", 9.9, 0.0);
  const Shop taken(kPlate, measure + "G65 P9854 H2 D2 S800 R10. Q.5\n");
  expect_value(taken, "#11002", 120.25, 5e-3);
  expect_value(taken, "#13002", 10.25, 5e-3);
}

TEST(FanucToolSetting, ABrokenToolIsAnAlarmOrAnAnswer) {
  const std::string drill = std::string(kCalibrate) + "T3 M6\nG65 P9855 H3";  // 2.1 mm are gone
  EXPECT_EQ(Shop(kPlate, drill + "\n").alarm(), 3176);
  const Shop asked(kPlate, drill + " E1.\n");
  EXPECT_EQ(asked.alarm(), 0);
  expect_value(asked, "#550", 1.0);
  expect_value(Shop(kPlate, drill + " E1. I3.\n"), "#550", 0.0);
  const std::string longer = std::string(kCalibrate) + "T1 M6\n#11001=98.\nG65 P9855 H1";
  EXPECT_EQ(Shop(kPlate, longer + "\n").alarm(), 3173);
  expect_value(Shop(kPlate, longer + " E1.\n"), "#550", 2.0);
}

TEST(FanucToolSetting, WhatGoesWrongWritesNothing) {
  struct Case {
    std::string name;
    std::string probe;
    std::string blocks;
    int alarm;
  };
  const std::string calibrate = kCalibrate;
  const Case cases[] = {
      {"another tool than believed", kPlate, calibrate + "T3 M6\nG65 P9852 H1 Q1.\n", 3173},
      {"a chip on the plate", kPlate + std::string(kChip),
       kCalibrated + std::string("T1 M6\nG65 P9852 H1 Q.5\n"), 3173},
      {"no calibration", kPlate, "T1 M6\nG65 P9852 H1\n", 3174},
      {"no calibration", kPlate, "T1 M6\nG65 P9853 H1 D1\n", 3174},
      {"no setter there", "", "#542=-399.2\n#540=0\n#541=0\nT1 M6\nG65 P9852 H1\n", 3171},
      {"no offset number", kPlate, calibrate + "T1 M6\nG65 P9852\n", 3160},
      {"setter elsewhere", kPlate, "T90 M6\nG65 P9851 X200. Y-100. Z-396. K105. D10. S25.\n", 3172},
      {"inches", kPlate, "G20\nT90 M6\nG65 P9851 X200. Y-100. Z-400. K105. D10. S25.\n", 3170},
      {"a radius too far off", kPlate, calibrate + "T1 M6\nG65 P9853 H1 D1 Q.1\n", 3173},
      {"length unknown", kPlate, calibrate + "T1 M6\n#11001=0\nG65 P9855 H1\n", 3175},
      {"length unknown", kPlate, calibrate + "T1 M6\n#11001=0\nG65 P9853 H1 D1\n", 3175},
      {"half an offset number", kPlate, calibrate + "T1 M6\nG65 P9852 H1.5\n", 3182},
      {"half an offset number", kPlate, calibrate + "T1 M6\nG65 P9853 H1 D1.5\n", 3182},
      {"an offset that there is not", kPlate, calibrate + "T1 M6\nG65 P9852 H1001.\n", 3182},
      {"offset 0", kPlate, calibrate + "T1 M6\nG65 P9852 H0\n", 3182},
      {"an offset that there is not", kPlate, calibrate + "T1 M6\nG65 P9853 H1 D1001.\n", 3182},
      {"an offset that there is not", kPlate, calibrate + "T1 M6\nG65 P9854 H-1 D1\n", 3182},
      {"an offset that there is not", kPlate, calibrate + "T1 M6\nG65 P9855 H1000\n", 3182},
      {"scaling", kPlate, calibrate + "T1 M6\nG51 X0 Y0 Z0 P4000\nG65 P9853 H1 D1\n", 3178},
      {"a mirror image of Z", kPlate, calibrate + "T1 M6\nG51.1 Z0\nG65 P9853 H1 D1\n", 3178},
      {"a rotation", kPlate, calibrate + "T1 M6\nG68 X0 Y0 R90.\nG65 P9854 H1 D1\n", 3178},
      {"a mirror image", kPlate, calibrate + "T1 M6\nG51.1 X0\nG65 P9853 H1 D1\n", 3178},
      {"scaling", kPlate, calibrate + "T1 M6\nG51 X0 Y0 Z0 P2000\nG65 P9852 H1\n", 3178},
      {"polar coordinates", kPlate, calibrate + "T1 M6\nG16\nG65 P9853 H1 D1\n", 3178},
  };
  for (const Case& one : cases) {
    SCOPED_TRACE(one.name);
    const Shop shop(one.probe, one.blocks);
    EXPECT_EQ(shop.alarm(), one.alarm) << shop.errors();
    const double unit = one.name == "inches" ? 25.4 : 1.0;
    if (one.alarm != 3175) {
      expect_value(shop, "#11001", 99.9 / unit);
    }
    expect_value(shop, "#13001", 8.2 / unit);
  }
}

/// Its side stands over the plate where rapid ends: 12.5 + 2 + 5 mm beside the middle are less than
/// 12.5 + 8; beside the beam 2.5 + 5 mm are less than 8.
TEST(FanucToolSetting, AToolThatIsWiderThanBelievedStopsBeforeItsTouch) {
  const Shop plate(kPlate, std::string(kCalibrate) + "T1 M6\n#13001=2.\nG65 P9853 H1 D1\n");
  EXPECT_EQ(plate.alarm(), 3177) << plate.errors();
  expect_value(plate, "#13001", 2.0, 0.0);
  const Shop beam(kLaser,
                  "T90 M6\nG65 P9856 X200. Y-100. Z-399. K105. D10.\n"
                  "T1 M6\n#13001=2.5\nG65 P9857 H1 D1\n");
  EXPECT_EQ(beam.alarm(), 3177) << beam.errors();
  expect_value(beam, "#13001", 2.5, 0.0);
  // One that is believed 3 mm too narrow is measured.
  expect_value(Shop(kPlate, std::string(kCalibrate) + "T1 M6\n#13001=5.\nG65 P9853 H1 D1\n"),
               "#13001", 8.0);
}

TEST(FanucToolSetting, FeedIsPerMinuteAndModalCodesAreTheCallersAgain) {
  const Shop shop(kPlate, std::string(kCalibrate) +
                              "T1 M6\nS500 M3\nG95 G01 F.3\nG65 P9852 H1\nG65 P9853 H1 D1\n"
                              "#548=#4001\n#550=#4005\n#552=#4109\n#553=#4003\n");
  EXPECT_EQ(shop.alarm(), 0) << shop.errors();
  expect_value(shop, "#11001", 100.3);
  expect_value(shop, "#13001", 8.0);
  expect_value(shop, "#548", 1.0, 0.0);
  expect_value(shop, "#550", 95.0, 0.0);
  expect_value(shop, "#552", 0.3, 0.0);
  expect_value(shop, "#553", 90.0, 0.0);
}

TEST(FanucToolSetting, ALaserMeasuresStandingAndTurningTools) {
  const std::string calibrate = "T90 M6\nG65 P9856 X200. Y-100. Z-399. K105. D10.\n";
  const Shop shop(kLaser, calibrate + "T1 M6\nG65 P9857 H1 D1 Q1.\n");
  EXPECT_EQ(shop.exit_code(), 0) << shop.errors();
  expect_value(shop, "#552", -100.4);
  expect_value(shop, "#553", -398.95);
  expect_value(shop, "#554", 0.5);
  expect_value(shop, "#11001", 100.3);
  expect_value(shop, "#13001", 8.0);
  EXPECT_EQ(Shop(kLaser, calibrate + "T3 M6\nG65 P9857 H1 D1 Q1.\n").alarm(), 3173);
  // Its longest teeth come by at most the way of one turn late: 0.005 mm at any speed.
  constexpr double kWayOfATurn = 0.005;
  for (const int speed : {300, 1200, 6000}) {
    SCOPED_TRACE(speed);
    const Shop turning(kLaser,
                       calibrate + fmt::format("T2 M6\nG65 P9857 H2 D2 S{} R6. Q1.\n", speed));
    EXPECT_EQ(turning.exit_code(), 0) << turning.errors();
    expect_value(turning, "#11002", 120.25, kWayOfATurn);
    expect_value(turning, "#13002", 10.25, kWayOfATurn);
  }
}

TEST(FanucToolSetting, TheBeamHasToMeetTheSideOfTheTool) {
  const std::string calibrate = "T90 M6\nG65 P9856 X200. Y-100. Z-399. K105. D10.\n";
  const Shop shallow(kLaser, calibrate + "T1 M6\nG65 P9857 H1 D1 Q1. Z3\n");
  EXPECT_EQ(shallow.alarm(), 3182) << shallow.errors();
  expect_value(shallow, "#13001", 8.2, 0.0);
  expect_value(Shop(kLaser, calibrate + "T1 M6\nG65 P9857 H1 Q1. Z.4\n"), "#11001", 100.3);
  for (const char* depth : {"Z4.1237", "Z2.5005", "Z3.33333"}) {
    const Shop shop(kLaser, calibrate + "T1 M6\nG65 P9857 H1 D1 Q1. " + depth + "\n");
    EXPECT_EQ(shop.exit_code(), 0) << depth << shop.errors();
    expect_value(shop, "#13001", 8.0);
  }
}

}  // namespace
}  // namespace g31::fanuc_tool_setting_test
