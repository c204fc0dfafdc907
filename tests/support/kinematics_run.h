#pragma once

#include <array>
#include <string>
#include <vector>

#include "machine/kinematics/axis_chain.h"
#include "tests/support/measuring_run.h"

// Machines whose control believes what is nearly true, and a ball on their table, for the cycles
// that measure kinematics.

namespace g31::testing {

/// A machine of tests/support/worked_machines.h with wrong data: the line of the table's innermost
/// axis lies off by (30, -20, 15) um and is tilted by 20 arcsec, other axes of tables are off
/// alike, the head's pivot length is wrong by 0.05 mm.
struct MisbelievedMachine {
  std::string name;
  machine::AxisChainSetup believed;
  machine::AxisChainSetup truth;
  std::string settings;  ///< NC text: what is fixed along the axes of tables
  std::string series;    ///< of CYCLE9960: from S_SETV1 to S_POS_RA1
  /// I1, I2, I3, I4 as they must be found, mm.
  std::array<Point, 4> vectors;
};

/// Two heads, two tables, a table under a head; of each one with an axis at 45 degrees.
std::vector<MisbelievedMachine> misbelieved_machines();

/// Machine, what its control believes and the ball of 25 mm, its middle (0.1, -0.2, 0.05) from G54.
std::vector<std::string> kinematics_sheets(const MisbelievedMachine& machine);

/// The program that stands over the ball, S_FA = 3 above its pole, and then runs `body`.
std::string over_the_ball(const std::string& body);

/// Approaches the ball along the probe at a position of a head C A, runs CYCLE996 as `variant` and
/// goes away.
std::string head_step(int variant, double c, double a);

/// The 12 numbers of $TC_CARR of the offset vectors.
std::vector<std::string> carrier_names();

}  // namespace g31::testing
