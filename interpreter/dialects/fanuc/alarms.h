#pragma once

#include <string_view>

namespace g31::fanuc {

/// How a control numbers its alarms: the column of alarms.def.
enum class AlarmNumbers { Series16i, Series30i };

enum class AlarmId {
#define ALARM(name, number_16i, number_30i, text, remedy) name,
#include "interpreter/dialects/fanuc/alarms.def"
#undef ALARM
};

/// One row of alarms.def.
struct AlarmInfo {
  int number_16i;
  int number_30i;
  std::string_view text;
  std::string_view remedy;
};

const AlarmInfo& info(AlarmId id);

/// The number that a control of this numbering shows, without letters.
int number_of(AlarmId id, AlarmNumbers numbers);

}  // namespace g31::fanuc
