// Each measuring cycle under G70, G71, G700 and G710: the same touches on the machine, lengths in
// the program's unit, angles and data of the control as they are.

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

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

MeasuringRun run_in(const Call& call, const std::string& code, double unit) {
  std::vector<std::string> names = call.lengths;
  names.insert(names.end(), call.others.begin(), call.others.end());
  return run_measuring(
      fmt::format("{}\n{}\n{}\nG710", call.approach, code, in_unit(call.cycle, unit)),
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

TEST(MeasuringUnits, EachCycleMeasuresTheSameInAllFour) {
  for (const Call& call : calls()) {
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
