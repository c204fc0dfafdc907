#pragma once

#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

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
inline std::string part(const std::string& shape, double x, double y, double z,
                        const std::string& more = {}) {
  return fmt::format(
      "[[part]]\nname = \"{0}\"\nshape = \"{0}\"\nat = [{1:.6f}, {2:.6f}, {3:.6f}]\n{4}\n", shape,
      x, y, z, more);
}

/// The same, its middle 0.2 and -0.3 from the origin of G54.
inline std::string part_aside(const std::string& shape, const std::string& more = {}) {
  return part(shape, 100.2, 49.7, -300.0, more);
}
inline std::string ring_aside(double bore = 40.0) {
  return part_aside("ring", fmt::format("bore = {:.4f}", bore));
}

/// What a program left.
struct MeasuringRun {
  RunOutput output;

  /// NaN when it was not asked for.
  [[nodiscard]] double at(const std::string& name) const {
    const auto value = output.document.at("variables").value(name, nlohmann::json());
    return value.is_number() ? value.get<double>() : std::nan("");
  }
  /// 0: none
  [[nodiscard]] int alarm() const {
    const auto number = output.document.value("/alarm/number"_json_pointer, nlohmann::json());
    return number.is_number() ? number.get<int>() : 0;
  }
};

/// @param body    behind T1 M6, G54 and D1 at X0 Y0 Z20
/// @param sheets  texts of set-up sheets, behind kMeasuringSheet
inline MeasuringRun run_measuring(const std::string& body, const std::vector<std::string>& sheets,
                                  const std::vector<std::string>& names) {
  const TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("part.mpf", "T1 M6\nG54 D1\nG0 X0 Y0 Z20\n" + body + "\nM30\n")};
  options.setups = {folder.write("base.toml", kMeasuringSheet)};
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    options.setups.push_back(folder.write(fmt::format("sheet{}.toml", i), sheets[i]));
  }
  options.prints = names;
  options.touches = true;
  return {run_program(options)};
}

/// Runs to the end without an alarm and expects the values.
inline MeasuringRun expect_measured(const std::string& body, const std::vector<std::string>& sheets,
                                    const std::vector<ExpectedValue>& expected,
                                    double tolerance = 1e-6,
                                    const std::vector<std::string>& more_names = {}) {
  std::vector<std::string> names = more_names;
  for (const ExpectedValue& row : expected) {
    names.push_back(row.name);
  }
  MeasuringRun run = run_measuring(body, sheets, names);
  EXPECT_EQ(run.output.exit_code, 0) << run.output.errors;
  if (run.output.document.is_object()) {
    for (const ExpectedValue& row : expected) {
      EXPECT_NEAR(run.at(row.name), row.value, tolerance) << row.name;
    }
  }
  return run;
}

/// A row of a table: a program on parts, and what it must leave.
struct MeasuringCase {
  const char* name;
  std::string parts;
  std::string program;
  std::vector<ExpectedValue> expected;
};

/// Runs every row with a perfect, calibrated probe.
inline void expect_measured(std::span<const MeasuringCase> cases, double tolerance = 1e-6) {
  for (const MeasuringCase& row : cases) {
    SCOPED_TRACE(row.name);
    expect_measured(row.program, {row.parts, kCalibrated}, row.expected, tolerance);
  }
}

}  // namespace g31::testing
