#include "machine/sim/travel_limits.h"

#include <cmath>

#include <gtest/gtest.h>

namespace g31::machine::travel_limits_test {
namespace {

MachineSetup with_limits() {
  MachineSetup setup;
  setup.axes[0].travel_min = -50.0;
  setup.axes[0].travel_max = 600.0;
  setup.axes[2].travel_max = 0.0;
  setup.axes[3].present = true;
  setup.axes[3].travel_min = -90.0;
  setup.axes[3].travel_max = 90.0;
  setup.q_M_start << 0, 0, 0, 0, 0, 5;
  return setup;
}

TEST(TravelLimits, Cases) {
  struct Case {
    const char* name;
    double x, y, z, a, b, c;
    const char* violation;  // null: inside
  };
  const Case kCases[] = {
      {"inside", 1, 2, -3, 4, 0, 5, nullptr},
      {"the limits themselves are inside", 600, 0, 0, -90, 0, 5, nullptr},
      {"Y has no limits", 0, 1e9, 0, 0, 0, 5, nullptr},
      {"above", 600.001, 0, 0, 0, 0, 5, "axis X asked to go to 600.001 mm: upper limit is 600 mm"},
      {"below", -50.5, 0, 0, 0, 0, 5, "axis X asked to go to -50.5 mm: lower limit is -50 mm"},
      {"a rotary axis speaks of degrees", 0, 0, 0, 91, 0, 5,
       "axis A asked to go to 91 deg: upper limit is 90 deg"},
      {"of two the first is named", 0, 0, 1, 91, 0, 5,
       "axis Z asked to go to 1 mm: upper limit is 0 mm"},
      {"an absent axis", 0, 0, 0, 0, 30, 5,
       "axis B asked to go to 30 deg: the machine has no axis B"},
      {"an absent axis stays where it started", 0, 0, 0, 0, 0, 0,
       "axis C asked to go to 0 deg: the machine has no axis C"},
  };
  const TravelLimits limits(with_limits());
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    const AxisPositions q_M = (AxisPositions() << c.x, c.y, c.z, c.a, c.b, c.c).finished();
    EXPECT_EQ(limits.contain(q_M), c.violation == nullptr);
    if (c.violation != nullptr) {
      EXPECT_EQ(limits.violation(q_M), c.violation);
      EXPECT_EQ(limits.is_without_axis(q_M),
                std::string(c.violation).find("has no axis") != std::string::npos);
    }
  }
}

TEST(TravelLimits, OneSpacingOfDoublesBeyondIsBeyond) {
  const TravelLimits limits(with_limits());
  AxisPositions q_M = with_limits().q_M_start;
  q_M[0] = std::nextafter(600.0, 601.0);
  EXPECT_FALSE(limits.contain(q_M));
  EXPECT_NE(limits.violation(q_M).find("600.0000000000001"), std::string::npos);
}

}  // namespace
}  // namespace g31::machine::travel_limits_test
