#pragma once

#include <string>
#include <vector>

#include "tests/support/measuring_run.h"

// Runs programs with CYCLE971 on a tool probe, and the probe of CYCLE982.

namespace g31::testing {

/// A cube of 25 mm with its top at X200 Y0 Z-300.  Tool 9 is known exactly; 5 is round, 6 has four
/// teeth that differ, 7 is a drill.
inline constexpr const char* kToolSheet = R"([control]
profile = "sinumerik-828d"
[tools.5]
length = 100.0
radius = 8.0
type = 120.0
name = "ROUND"
[tools.6]
length = 100.0
radius = 8.0
type = 120.0
name = "FOUR_TEETH"
[tools.7]
length = 120.0
radius = 3.0
type = 200.0
name = "DRILL"
[tools.9]
length = 100.0
radius = 5.0
type = 725.0
name = "CAL"
[[tool]]
number = 5
length = 100.0
diameter = 16.0
[[tool]]
number = 6
length = 100.0
diameter = 16.0
teeth = [{ angle_deg = 20.0, length = 99.99 }, { angle_deg = 110.0, radius = 7.98 }, { angle_deg = 200.0, radius = 7.99, length = 99.98 }, { angle_deg = 290.0, radius = 7.97, length = 99.97 }]
[[tool]]
number = 7
kind = "drill"
length = 120.0
diameter = 6.0
[[tool]]
number = 9
kind = "calibration"
length = 100.0
diameter = 10.0
[machine_data]
"$SNS_MEA_TP_TRIG_MINUS_DIR_AX1[0]" = 213.0
"$SNS_MEA_TP_TRIG_PLUS_DIR_AX1[0]" = 187.7
"$SNS_MEA_TP_TRIG_MINUS_DIR_AX2[0]" = 12.1
"$SNS_MEA_TP_TRIG_PLUS_DIR_AX2[0]" = -13.0
"$SNS_MEA_TP_TRIG_MINUS_DIR_AX3[0]" = -300.4
"$SNS_MEA_TP_EDGE_DISK_SIZE[0]" = 25.0
[work_offsets.G54]
X = 100.0
Y = 50.0
Z = -300.0
)";

inline constexpr const char* kCube =
    "[[tool_probe]]\nname = \"setter\"\nsize = 25.0\nat = [200.0, 0.0, -300.0]\n";

/// The triggers as a calibration finds them.
inline constexpr const char* kKnown = R"([machine_data]
"$SNS_MEA_TP_TRIG_MINUS_DIR_AX1[0]" = 212.5
"$SNS_MEA_TP_TRIG_PLUS_DIR_AX1[0]" = 187.5
"$SNS_MEA_TP_TRIG_MINUS_DIR_AX2[0]" = 12.5
"$SNS_MEA_TP_TRIG_PLUS_DIR_AX2[0]" = -12.5
"$SNS_MEA_TP_TRIG_MINUS_DIR_AX3[0]" = -300.0
"$SNS_MEA_TP_FEED[0]" = 300.0
)";

/// Of a lathe: a cube of 20 mm about X100 Z-210, its upper face across, with triggers as a
/// calibration finds them; its spindle 1 turns the tools.
inline constexpr const char* kLatheProbe = R"([control]
profile = "sinumerik-828d"
[machine]
tool_spindle = 1
[[tool_probe]]
size = 20.0
at = [100.0, 10.0, -210.0]
rotate_deg = [-90.0, 0.0, 0.0]
[machine_data]
"$SC_TOOL_LENGTH_TYPE" = 2
"$SNS_MEA_TP_TRIG_MINUS_DIR_AX1[0]" = -200.0
"$SNS_MEA_TP_TRIG_PLUS_DIR_AX1[0]" = -220.0
"$SNS_MEA_TP_TRIG_MINUS_DIR_AX2[0]" = 110.0
"$SNS_MEA_TP_TRIG_PLUS_DIR_AX2[0]" = 90.0
"$SNS_MEA_TP_FEED[0]" = 300.0
)";

/// Runs a program behind kToolSheet and further sheets.
MeasuringRun run_tools(const std::string& body, const std::vector<std::string>& sheets,
                       const std::vector<std::string>& names);

/// Runs to the end without an alarm and expects the values.
MeasuringRun expect_tools(const std::string& body, const std::vector<std::string>& sheets,
                          const std::vector<ExpectedValue>& expected, double tolerance,
                          const std::vector<std::string>& more = {});

/// The tool in the spindle with its data, 20 mm above a place of the machine.
std::string with_tool(int tool, double x = 150.0, double y = 0.0);

}  // namespace g31::testing
