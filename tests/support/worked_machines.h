#pragma once

// The six machines of the five-axis specification, and what is the same at all of them.

#include <numbers>
#include <string>

#include "machine/kinematics/axis_chain.h"

namespace g31::machine::worked {

inline constexpr double kS = std::numbers::sqrt2 / 2.0;
inline const Point kTool(0.0, 0.0, -120.0);

inline AxisPositions axes(double x, double y, double z, double a = 0, double b = 0, double c = 0) {
  return (AxisPositions() << x, y, z, a, b, c).finished();
}

inline AxisChainSetup chain(const std::string& table_side, const std::string& tool_side) {
  AxisChainSetup setup;
  setup.table_side = table_side;
  setup.tool_side = tool_side;
  return setup;
}

// The machines of the specification.
inline AxisChainSetup k1() {
  AxisChainSetup setup = chain("CA", "XYZ");
  setup.rotary[0].p_M_centre = {0, 20, -450};
  setup.rotary[2].p_M_centre = {5, -3, 0};
  return setup;
}

inline AxisChainSetup k2() {
  AxisChainSetup setup = chain("C", "XYZB");
  setup.rotary[1].p_M_centre = {10, 0, 180};
  setup.rotary[2].p_M_centre = {200, -150, -500};
  return setup;
}

inline AxisChainSetup k3() {
  AxisChainSetup setup = chain("C", "XYZB");
  setup.rotary[1] = {{0, 25, 160}, {0, kS, kS}};
  setup.rotary[2].p_M_centre = {0, 0, -400};
  return setup;
}

inline AxisChainSetup k4() {
  AxisChainSetup setup = chain("", "XYZCA");
  setup.rotary[2].p_M_centre = {0, 5, 0};
  setup.rotary[0].p_M_centre = {0, -8, 220};
  return setup;
}

inline AxisChainSetup k5() {
  AxisChainSetup setup = chain("", "XYZCB");
  setup.rotary[2].p_M_centre = {0, 5, 0};
  setup.rotary[1] = {{0, 40, 180}, {0, kS, kS}};
  return setup;
}

inline AxisChainSetup k6() {
  AxisChainSetup setup = chain("CB", "XYZ");
  setup.rotary[1] = {{30, -60, -420}, {0, kS, kS}};
  setup.rotary[2].p_M_centre = {-20, 15, 0};
  return setup;
}

}  // namespace g31::machine::worked
