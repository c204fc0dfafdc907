#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "machine/base/result.h"
#include "probe/planning/inspection_plan.h"

namespace g31::plan {

/// No length of a plan and no printed one is larger, mm.
inline constexpr double kLongestMm = 1e6;

using probe::Tolerance;

/// What a plan says of one measure, as far as a printed value is judged by it.
struct Measure {
  std::string id;                      ///< "F1.X"
  std::string printed;                 ///< what the program prints before its value: "F1-X"
  double nominal = 0.0;                ///< mm
  std::optional<Tolerance> tolerance;  ///< nothing: every value is good
};

/// What a program prints for an id where the plan does not say it: capitals and digits, everything
/// else as `-`, since DPRNT prints no other characters in all controls.
std::string printed_name(std::string_view id);

/// The measures of a document g31.plan/1, in its order; ids and printed names differ.
/// @param name  of the file, for messages
///
/// Error: one line with the place: no JSON (line and column), another document, no measure, a field
/// that is missing or out of range (which of which measure).
Result<std::vector<Measure>, std::string> read_measures(const std::string& name,
                                                        std::string_view text);

}  // namespace g31::plan
