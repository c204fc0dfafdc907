#pragma once

#include <span>
#include <string_view>

namespace g31::sinumerik {

/// Rows of alarms.def.
enum class AlarmId {
#define ALARM(name, number, text, remedy) name,
#include "interpreter/dialects/sinumerik/vocabulary/alarms.def"
#undef ALARM
};

struct AlarmInfo {
  int number;
  std::string_view text;
  std::string_view remedy;
};

/// All rows, in the order of AlarmId.
std::span<const AlarmInfo> alarms();

const AlarmInfo& info(AlarmId id);

}  // namespace g31::sinumerik
