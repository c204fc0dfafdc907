#pragma once

#include <span>
#include <string>
#include <vector>

#include "tests/support/run_program.h"

// Runs programs with SINUMERIK measuring cycles on parametric parts.

namespace g31::testing {

/// A variable and what it must be.
struct ExpectedValue {
  std::string name;
  double value = 0.0;
};

/// A probe of 6 mm diameter as tool 1, its length to the ball's lower end, a mill as tool 2; G54 at
/// X100 Y50 Z-300.  Stem and body take part.
inline constexpr const char* kMeasuringSheet = R"([control]
profile = "sinumerik-828d"
[tools.1]
length = 120.0
radius = 3.0
type = 710.0
name = "PROBE"
[tools.2]
length = 80.0
radius = 5.0
type = 120.0
name = "MILL"
[probe]
ball_diameter = 6.0
length = 117.0
stem_diameter = 2.0
stem_length = 60.0
[[probe.body]]
name = "probe body"
length = 57.0
diameter = 40.0
[work_offsets.G54]
X = 100.0
Y = 50.0
Z = -300.0
)";

/// Calibration record 1 is that of a perfect probe.
inline constexpr const char* kCalibrated = R"([variables]
"$SNS_MEA_WP_BALL_DIAM[0]" = 6.0
"$SNS_MEA_WP_TRIG_PLUS_DIR_AX1[0]" = 3.0
"$SNS_MEA_WP_TRIG_MINUS_DIR_AX1[0]" = -3.0
"$SNS_MEA_WP_TRIG_PLUS_DIR_AX2[0]" = 3.0
"$SNS_MEA_WP_TRIG_MINUS_DIR_AX2[0]" = -3.0
)";

/// An eccentric ball and a late signal: 0.005 mm at 300 mm/min.
inline constexpr const char* kBentProbe = R"([probe]
eccentricity = [0.02, -0.03]
trigger_delay_s = 0.001
)";

/// A part of the shape library as a sheet; `more` are its sizes and rotate_deg.
std::string part(const std::string& shape, double x, double y, double z,
                 const std::string& more = {});

/// The same, its middle 0.2 and -0.3 from the origin of G54.
std::string part_aside(const std::string& shape, const std::string& more = {});
std::string ring_aside(double bore = 40.0);

/// What a program left.
struct MeasuringRun {
  RunOutput output;

  /// NaN when it was not asked for.
  [[nodiscard]] double at(const std::string& name) const;
  /// 0: none
  [[nodiscard]] int alarm() const;
};

/// Runs a program, without its M30, on set-up sheets.
/// @param names  variables of the document
MeasuringRun run_on_sheets(const std::string& program, const std::vector<std::string>& sheets,
                           const std::vector<std::string>& names);

// What the runs of milling, turning and tool cycles share.
std::vector<std::string> sheets_behind(const std::string& base,
                                       const std::vector<std::string>& sheets);
std::vector<std::string> names_of(const std::vector<ExpectedValue>& expected,
                                  const std::vector<std::string>& more = {});
/// The run went to its end without an alarm and left the values.
void expect_values(const MeasuringRun& run, const std::vector<ExpectedValue>& expected,
                   double tolerance);

/// @param body    behind T1 M6, G54 and D1 at X0 Y0 Z20
/// @param sheets  texts of set-up sheets, behind kMeasuringSheet
MeasuringRun run_measuring(const std::string& body, const std::vector<std::string>& sheets,
                           const std::vector<std::string>& names);

/// Runs to the end without an alarm and expects the values.
MeasuringRun expect_measured(const std::string& body, const std::vector<std::string>& sheets,
                             const std::vector<ExpectedValue>& expected, double tolerance = 1e-6,
                             const std::vector<std::string>& more_names = {});

/// A row of a table: a program on parts, and what it must leave.
struct MeasuringCase {
  const char* name;
  std::string parts;
  std::string program;
  std::vector<ExpectedValue> expected;
};

/// Runs every row with a perfect, calibrated probe.
void expect_measured(std::span<const MeasuringCase> cases, double tolerance = 1e-6);

}  // namespace g31::testing
