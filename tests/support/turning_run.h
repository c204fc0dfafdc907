#pragma once

#include "tests/support/measuring_run.h"

// Runs programs with SINUMERIK measuring cycles on a lathe.

namespace g31::testing {

/// A lathe with X, Z and the spindle as C; a probe of 6 mm diameter in the turret as tool 1,
/// lengths to the ball's centre; a roughing tool as tool 2.  G54: zero in the face of a part at Z
/// 200 that looks to +Z; G55: at Z 600, mirrored, of a part on the counter spindle that looks to
/// -Z.
inline constexpr const char* kLatheSheet = R"([control]
profile = "sinumerik-828d"
[machine]
table_side = "C"
tool_side = "ZX"
[machine.axes.X]
travel = [-200.0, 500.0]
[machine.axes.Z]
travel = [-100.0, 900.0]
[tools.1]
name = "PROBE"
radius = 3.0
type = 580.0
[tools.2]
name = "ROUGHER"
length = 90.0
radius = 0.4
type = 500.0
[tools.3]
name = "DRILL"
length = 150.0
radius = 5.0
type = 200.0
[variables]
"$TC_DP4[2,1]" = 20.0
[probe]
ball_diameter = 6.0
stem_diameter = 2.0
[work_offsets.G54]
Z = 200.0
[work_offsets.G55]
Z = 600.0
mirror = "Z"
[start]
X = 300.0
Z = 400.0
)";

/// Where the probe points, as $TC_DP2 counts, and where it is.
inline constexpr const char* kProbeToMinusX = R"([tools.1]
length = 100.0
[variables]
"$TC_DP2[1,1]" = 8
"$TC_DP4[1,1]" = 30.0
[probe]
at = [-100.0, 0.0, -30.0]
)";
inline constexpr const char* kProbeToMinusZ = R"([tools.1]
length = 20.0
[variables]
"$TC_DP2[1,1]" = 7
"$TC_DP4[1,1]" = 150.0
[probe]
at = [-20.0, 0.0, -150.0]
)";
inline constexpr const char* kProbeToPlusZ = R"([tools.1]
length = 20.0
[variables]
"$TC_DP2[1,1]" = 5
"$TC_DP4[1,1]" = -150.0
[probe]
at = [-20.0, 0.0, 150.0]
)";

/// @param body    behind T1 D1 M6, with the axes far from all parts
/// @param sheets  texts of set-up sheets, behind kLatheSheet
MeasuringRun run_turning(const std::string& body, const std::vector<std::string>& sheets,
                         const std::vector<std::string>& names);

/// Runs to the end without an alarm and expects the values.
MeasuringRun expect_turned(const std::string& body, const std::vector<std::string>& sheets,
                           const std::vector<ExpectedValue>& expected, double tolerance = 1e-6);

}  // namespace g31::testing
