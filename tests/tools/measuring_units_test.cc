// Each measuring cycle under G70, G71, G700 and G710: the same touches on the machine, lengths in
// the program's unit, angles and data of the control as they are.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/effort.h"
#include "tests/support/measuring_run.h"

namespace g31::testing::measuring_units_test {
namespace {

constexpr double kInch = 25.4;

/// A call whose lengths stand in braces, mm: "{40.01}".
struct Call {
  const char* name;
  std::string part;
  const char* approach;
  const char* cycle;
  std::vector<std::string> lengths;  ///< results that count in the program's unit
  std::vector<std::string> others;   ///< angles, and what the control keeps in mm
};

/// The call as a program in that unit writes it.
std::string in_unit(std::string text, double unit) {
  for (std::size_t open = text.find('{'); open != text.npos; open = text.find('{')) {
    const std::size_t close = text.find('}', open);
    const double mm = std::stod(text.substr(open + 1, close - open - 1));
    text.replace(open, close - open + 1, fmt::format("{}", mm / unit));
  }
  return text;
}

/// The program's feed of 1270 mm/min behind the cycle, in mm/min.
constexpr const char* kFeed = "R99";

MeasuringRun run_in(const Call& call, const std::string& code, double unit) {
  std::vector<std::string> names = call.lengths;
  names.insert(names.end(), call.others.begin(), call.others.end());
  names.emplace_back(kFeed);
  const double per_minute = 1270.0 / (code == "G700" ? unit : 1.0);  // G70 leaves feeds in mm
  return run_measuring(fmt::format("{}\n{} F{}\n{}\nG710\n{}=$P_F", call.approach, code, per_minute,
                                   in_unit(call.cycle, unit), kFeed),
                       {call.part, kCalibrated}, names);
}

void expect_same_touches(const MeasuringRun& run, const MeasuringRun& wanted) {
  const auto& touches = run.output.document.at("touches");
  const auto& as_wanted = wanted.output.document.at("touches");
  ASSERT_EQ(touches.size(), as_wanted.size());
  for (std::size_t i = 0; i < touches.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(touches[i].at("latched").at(axis).get<double>(),
                  as_wanted[i].at("latched").at(axis).get<double>(), 1e-9)
          << "touch " << i;
    }
  }
}

std::vector<Call> calls() {
  const std::string ring = ring_aside();
  const std::string edge = part_aside("block", "rotate_deg = [0.0, 0.0, 3.0]");
  const std::vector<std::string> fine = {"$P_UIFR[1,X,FI]", "$P_UIFR[1,Y,FI]"};
  return {
      {"ring to calibrate on",
       ring,
       "X0.2 Y-0.3 Z-5",
       "CYCLE976(1,1,{40},,,,{5},{5})",
       {"_OVR[4]", "_OVR[6]", "_OVR[8]"},
       {"$SNS_MEA_WP_BALL_DIAM[0]", "$SNS_MEA_WP_TRIG_PLUS_DIR_AX1[0]"}},
      {"hole",
       ring,
       "Z-5",
       "CYCLE977(101,1,,1,{40.01},,,{2},{5})",
       {"_OVR[0]", "_OVR[4]", "_OVR[5]", "_OVR[6]", "_OVR[16]"},
       fine},
      {"surface",
       edge,
       "X-40\nZ-5",
       "CYCLE978(100,1,,1,{-30},{5},{1},1,1,1)",
       {"_OVR[0]", "_OVR[4]", "_OVR[16]"},
       fine},
      {"arc",
       ring,
       "Z-5",
       "CYCLE979(101,1,,1,{40},{2},{5},{0},{0},0,120,,,,,,,,,,,,,,{0.15},{0})",
       {"_OVR[0]", "_OVR[4]", "_OVR[5]", "_OVR[6]", "_OVR[17]"},
       fine},
      {"edge",
       edge,
       "X-20 Y-27\nZ-5",
       "CYCLE998(5,,,1,,2,,{5},3,102,1,{30})",
       {},
       {"_OVR[0]", "_OVR[4]", "_OVR[16]", "_OVR[28]"}},
      {"corner",
       part("block", 130.0, 70.0, -300.0),
       "X-12 Y-12\nZ-5",
       "CYCLE961(106,1,1,{20},{45},{15},,,,,,{5},{6},0,,,{10},{8})",
       {"_OVR[5]", "_OVR[6]", "_OVR[21]"},
       {"_OVR[4]", "$P_UIFR[1,X,FI]", "$P_UIFR[1,Z,RT]"}},
  };
}

/// Set places (0, 0, 0), (100, 0, 0) and (0, 80, 0), shifted and turned by 0.2 degrees.
std::string three_balls() {
  std::string balls;
  const double kPlaces[][2] = {{0.1, -0.2}, {100.0993908, 0.1490651}, {-0.1792521, 79.7995126}};
  for (const auto& place : kPlaces) {
    balls += part("sphere", 100.0 + place[0], 50.0 + place[1], -299.9, "diameter = 20.0");
  }
  for (int i = 1; i <= 3; ++i) {  // names of their own
    const std::size_t at = balls.find("name = \"sphere\"");
    balls.replace(at, 15, fmt::format("name = \"ball {}\"", i));
  }
  return balls;
}

std::vector<Call> ball_calls() {
  return {
      {"ball",
       part("sphere", 99.8, 50.3, -299.85, "diameter = 25.012"),
       "",
       "CYCLE997(1102119,1,1,{25},{2},{5},20,90,{0.1},{0},{-0.1})",
       {"_OVR[0]", "_OVR[1]", "_OVR[4]", "_OVR[5]", "_OVR[7]", "_OVR[8]", "_OVR[11]", "_OVR[28]"},
       {"_OVI[9]", "$P_UIFR[1,X,FI]", "$P_UIFR[1,Y,FI]", "$P_UIFR[1,Z,FI]"}},
      {"three balls",
       three_balls(),
       "",
       "CYCLE997(1010119,1,1,{20},{3},{5},,,{0},{0},{0},{100},{0},{0},{0},{80},{0},{0.5})",
       {"_OVR[4]", "_OVR[14]", "_OVR[18]", "_OVR[22]", "_OVR[26]"},
       {"_OVI[9]", "$P_UIFR[1,X,FI]", "$P_UIFR[1,Z,FI]", "$P_UIFR[1,Z,RT]"}},
      {"spindle",
       part("sphere", 99.8, 50.3, -299.85, "diameter = 25.0") +
           "[probe]\nstem_diameter = 1.0\nstem_length = 60.0\n"
           "[[probe.ball]]\nat = [0.05, -0.02, 40.0]\ndiameter = 6.0\n",
       "Z15",
       "CYCLE995(102015,0,1,{25},{3},{5},0,,{40},,,,0.01,,,,,1)",
       {"_OVR[4]", "_OVR[7]", "_OVR[8]", "_OVR[14]", "_OVR[15]", "_OVR[25]", "_OVR[28]"},
       {"_OVR[2]", "_OVR[3]", "_OVR[5]", "_OVR[6]", "_OVR[9]"}},
  };
}

TEST(MeasuringUnits, EachCycleMeasuresTheSameInAllFour) {
  std::vector<Call> all = calls();
  std::ranges::copy(ball_calls(), std::back_inserter(all));
  for (const Call& call : some_of(all)) {
    SCOPED_TRACE(call.name);
    const MeasuringRun metric = run_in(call, "G71", 1.0);
    ASSERT_EQ(metric.output.exit_code, 0) << metric.output.errors;
    ASSERT_FALSE(metric.output.document.at("touches").empty());
    for (const auto& [code, unit] :
         {std::pair{"G70", kInch}, std::pair{"G700", kInch}, std::pair{"G710", 1.0}}) {
      SCOPED_TRACE(code);
      const MeasuringRun run = run_in(call, code, unit);
      ASSERT_EQ(run.output.exit_code, 0) << run.output.errors;
      expect_same_touches(run, metric);
      EXPECT_NEAR(run.at(kFeed), 1270.0, 1e-9);
      for (const std::string& name : call.lengths) {
        EXPECT_NEAR(run.at(name) * unit, metric.at(name), 1e-9) << name;
      }
      for (const std::string& name : call.others) {
        EXPECT_NEAR(run.at(name), metric.at(name), 1e-9) << name;
      }
    }
  }
}

}  // namespace
}  // namespace g31::testing::measuring_units_test
