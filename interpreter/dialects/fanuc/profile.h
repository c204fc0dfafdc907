#pragma once

#include <span>
#include <string_view>

#include "interpreter/dialects/fanuc/alarms.h"
#include "interpreter/dialects/fanuc/output_format.h"

namespace g31::fanuc {

/// What a literal with more decimals than the least increment becomes (MB-024).
enum class ExcessDecimals { Truncate, Round };

/// A control of the family, as data: the interpreter asks for the property, never for the name.
struct Profile {
  std::string_view name;
  AlarmNumbers alarm_numbers;
  ExcessDecimals excess_decimals;
  int digit_limit;         ///< digits of a number (MB-027)
  double largest_result;   ///< magnitude beyond it is alarm 111 (MB-047)
  double smallest_result;  ///< magnitude below it, but not 0, is alarm 111
  int largest_sequence;    ///< N and GOTO (MB-003, MB-172)
  int macro_levels;        ///< G65 and its like (MB-201)
  int subprogram_levels;   ///< M98 (MB-224)
  int largest_alarm;       ///< n of #3000=n (MB-123)
  bool has_series_30i_functions;
  bool printing_needs_popen;  ///< DPRNT without POPEN is an alarm (MB-374)
  OutputStyle output;         ///< of DPRNT with 6001.1 = 0
};

/// All profiles, in the order of the documentation.
std::span<const Profile> profiles();

/// The profile of this name, or nullptr.
const Profile* find_profile(std::string_view name);

}  // namespace g31::fanuc
