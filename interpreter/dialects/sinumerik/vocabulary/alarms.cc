#include "interpreter/dialects/sinumerik/vocabulary/alarms.h"

#include <array>

namespace g31::sinumerik {
namespace {

constexpr auto kRows = std::to_array<AlarmInfo>({
#define ALARM(name, number, text, remedy) {number, text, remedy},
#include "interpreter/dialects/sinumerik/vocabulary/alarms.def"
#undef ALARM
});

consteval bool is_rising() {
  for (std::size_t i = 1; i < kRows.size(); ++i) {
    if (kRows[i - 1].number >= kRows[i].number) {
      return false;
    }
  }
  return true;
}
static_assert(is_rising(), "alarms.def: numbers must rise");

}  // namespace

std::span<const AlarmInfo> alarms() {
  return kRows;
}

const AlarmInfo& info(AlarmId id) {
  return kRows.at(static_cast<std::size_t>(id));
}

}  // namespace g31::sinumerik
