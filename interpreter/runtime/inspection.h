#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/runtime/alarm.h"
#include "interpreter/runtime/shown_value.h"
#include "interpreter/source/location.h"

namespace g31::runtime {

/// How far a run has come.
enum class Advance : std::uint8_t { Ended, Paused };

/// One level of calls of a paused run.
struct CallLevel {
  std::string program;  ///< "O9010", "CYCLE977"
  source::Location
      where;             ///< of the innermost level: the block that comes next; of others the call
  bool is_shown = true;  ///< false: its program hides its blocks (DISPLOF)
  /// Which of the levels that a run has had, counted when each begins; no two have the same.
  std::uint64_t number = 0;
  /// Programs of the level that wait for a text which runs on it (EXECSTRING), the innermost first.
  std::vector<CallSite> waiting = {};
};

/// The calls behind the innermost of some levels.
/// @param levels  the innermost first, at least one
std::vector<CallSite> calls_behind(std::span<const CallLevel> levels);

/// Which variables.
enum class Scope : std::uint8_t {
  Local,   ///< of one level of calls
  Common,  ///< of all: #100 and above, R parameters, GUD
};

/// Variables by the names that programs write.
using NamedValues = std::vector<std::pair<std::string, ShownValue>>;

/// A number in a table of a control: an offset, a tool datum, a component of a frame.
struct TableValue {
  double value = 0.0;
  double fresh = 0.0;  ///< on a control that nobody has set up: 1 of a scale
};

}  // namespace g31::runtime
