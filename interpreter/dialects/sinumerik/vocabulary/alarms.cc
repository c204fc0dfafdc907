#include "interpreter/dialects/sinumerik/vocabulary/alarms.h"

#include <array>

namespace g31::sinumerik {
namespace {

constexpr auto kAlarmRows = std::to_array<AlarmInfo>({
#define ALARM(name, number, of, text, remedy) {number, AlarmOf::of, text, remedy},
#include "interpreter/dialects/sinumerik/vocabulary/alarms.def"
#undef ALARM
});

consteval bool alarms_rise() {
  for (std::size_t i = 1; i < kAlarmRows.size(); ++i) {
    if (kAlarmRows[i - 1].number >= kAlarmRows[i].number) {
      return false;
    }
  }
  return true;
}
static_assert(alarms_rise(), "alarms.def: numbers must rise");

}  // namespace

std::span<const AlarmInfo> alarms() {
  return kAlarmRows;
}

const AlarmInfo& info(AlarmId id) {
  return kAlarmRows.at(static_cast<std::size_t>(id));
}

}  // namespace g31::sinumerik
