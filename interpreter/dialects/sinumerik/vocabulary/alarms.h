#pragma once

#include <span>
#include <string_view>

namespace g31::sinumerik {

/// Rows of alarms.def.
enum class AlarmId {
#define ALARM(name, number, of, text, remedy) name,
#include "interpreter/dialects/sinumerik/vocabulary/alarms.def"
#undef ALARM
};

/// What an alarm is of, where a block is compiled.
enum class AlarmOf {
  Text,  ///< of the text of the block alone: a syntax error
  Run,   ///< of names, files, values and motions
};

struct AlarmInfo {
  int number;
  AlarmOf of;
  std::string_view text;
  std::string_view remedy;
};

/// All rows, in the order of AlarmId.
std::span<const AlarmInfo> alarms();

const AlarmInfo& info(AlarmId id);

}  // namespace g31::sinumerik
