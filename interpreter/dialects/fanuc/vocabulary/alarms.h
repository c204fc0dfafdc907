#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace g31::fanuc {

/// How a control numbers its alarms: the column of alarms.def.
enum class AlarmNumbers { Series16i, Series30i, Meldas };

enum class AlarmId {
#define ALARM(name, number_16i, number_30i, number_meldas, text, remedy) name,
#include "interpreter/dialects/fanuc/vocabulary/alarms.def"
#undef ALARM
};

/// One row of alarms.def.
struct AlarmInfo {
  int number_16i;
  int number_30i;
  int number_meldas;
  std::string_view text;
  std::string_view remedy;
};

/// All rows, in the order of AlarmId.
std::span<const AlarmInfo> alarms();

const AlarmInfo& info(AlarmId id);

/// The number that a control of this numbering shows, without letters.
int number_of(const AlarmInfo& row, AlarmNumbers numbers);
int number_of(AlarmId id, AlarmNumbers numbers);

}  // namespace g31::fanuc
