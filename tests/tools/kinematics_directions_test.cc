// Directions of rotary axes that CYCLE9960 finds and does not write: a program that takes them over
// has the whole kinematics right, and nothing deviates any more.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/effort.h"
#include "tests/support/kinematics_run.h"

namespace g31::testing::kinematics_directions_test {
namespace {

constexpr int kMostPlaces = 12;
constexpr int kFirstDeviation = 130;  // of the home position; 5 results for each place

std::string measure(const MisbelievedMachine& machine, int variant) {
  return fmt::format("CYCLE9960({},\"\",1,25,{},1,3,5,1,1,0,0)\n", variant, machine.series);
}

std::vector<std::string> results() {
  std::vector<std::string> names = carrier_names();
  names.insert(names.end(), {"_OVR[120]", "_OVR[121]"});
  for (int n = 1; n <= 20; ++n) {
    names.push_back(fmt::format("_OVR[{}]", n));
    names.push_back(fmt::format("$TC_CARR{}[1]", n));
  }
  for (int n = 0; n < 5 * (1 + 2 * kMostPlaces); ++n) {
    names.push_back(fmt::format("_OVR[{}]", kFirstDeviation + n));
  }
  return names;
}

/// The greatest component of a deviation, mm.
double deviation(const MeasuringRun& run) {
  const int places = static_cast<int>(run.at("_OVR[120]") + run.at("_OVR[121]"));
  double most = 0.0;
  for (int place = 0; place <= places; ++place) {
    for (int axis = 0; axis < 3; ++axis) {
      const int number = kFirstDeviation + 5 * place + axis;
      most = std::max(most, std::abs(run.at(fmt::format("_OVR[{}]", number))));
    }
  }
  return most;
}

const std::string kTakeOver =
    "$TC_CARR7[1]=_OVR[7] $TC_CARR8[1]=_OVR[8] $TC_CARR9[1]=_OVR[9]\n"
    "$TC_CARR10[1]=_OVR[10] $TC_CARR11[1]=_OVR[11] $TC_CARR12[1]=_OVR[12]\n";

TEST(KinematicsDirections, TakenOverTheyLeaveNoDeviationAtAll) {
  double without = 0.0;
  for (const MisbelievedMachine& machine : some_of(misbelieved_machines())) {
    SCOPED_TRACE(machine.name);
    const std::vector<std::string> sheets = kinematics_sheets(machine);
    const std::string write = measure(machine, 11400);
    const std::string again = measure(machine, 10400);
    const auto run = [&](const std::string& calls) {
      MeasuringRun one =
          run_on_sheets(over_the_ball(machine.settings + "\n" + calls), sheets, results());
      EXPECT_EQ(one.output.exit_code, 0) << one.output.errors;
      return one;
    };
    without = std::max(without, deviation(run(write + again)));
    // The vectors depend on the directions: they are measured once more.
    const MeasuringRun right = run(write + kTakeOver + write + again);
    EXPECT_LT(deviation(right), 1e-6);
    for (int n = 1; n <= 20; ++n) {
      if (n == 13 || n == 14) {
        continue;  // angles
      }
      EXPECT_NEAR(right.at(fmt::format("_OVR[{}]", n)), right.at(fmt::format("$TC_CARR{}[1]", n)),
                  1e-6)
          << n;
    }
  }
  EXPECT_GT(without, 0.01) << "else the directions would make no difference";
}

}  // namespace
}  // namespace g31::testing::kinematics_directions_test
