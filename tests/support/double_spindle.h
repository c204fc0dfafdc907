#pragma once

#include <string>
#include <vector>

#include <fmt/format.h>

#include "tests/support/measuring_run.h"

// Two spindles side by side, each with a probe and a part of its own.

namespace g31::testing {

/// The second spindle is 200 mm further in X; its part stands there as that of the first one.
inline constexpr double kBeside = 200.0;

inline constexpr const char* kSecond = R"([probe.second]
at = [200.0, 0.0, 0.0]
[machine_data]
"$MNS_MEA_FUNCTION_MASK" = 16395
[variables]
"$TC_DP1[1,2]" = 710.0
"$TC_DP3[1,2]" = 120.0
"$TC_DP6[1,2]" = 3.0
)";

inline constexpr const char* kSecondCalibrated = R"([variables]
"$SNS_MEA_WP_BALL_DIAM[1]" = 6.0
"$SNS_MEA_WP_TRIG_PLUS_DIR_AX1[1]" = 3.0
"$SNS_MEA_WP_TRIG_MINUS_DIR_AX1[1]" = -3.0
"$SNS_MEA_WP_TRIG_PLUS_DIR_AX2[1]" = 3.0
"$SNS_MEA_WP_TRIG_MINUS_DIR_AX2[1]" = -3.0
)";

inline std::vector<std::string> on_both(const std::string& parts, const std::string& more = {}) {
  return {kSecond, kCalibrated, kSecondCalibrated, parts, more};
}

/// A part from G54 of the first spindle, and from where that is for the second one.
inline std::string first_part(const char* shape, double x, double y, const std::string& sizes) {
  return part(shape, 100.0 + x, 50.0 + y, -300.0, sizes);
}
inline std::string second_part(const char* shape, double x, double y, const std::string& sizes) {
  return part(shape, 100.0 + kBeside + x, 50.0 + y, -300.0, sizes);
}

inline std::string bore(double diameter) {
  return fmt::format("bore = {:.3f}\nsagitta = 0.0000005", diameter);
}

}  // namespace g31::testing
