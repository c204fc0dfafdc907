#include "interpreter/dialects/fanuc/alarms.h"

#include <array>

namespace g31::fanuc {
namespace {

constexpr auto kRows = std::to_array<AlarmInfo>({
#define ALARM(name, number_16i, number_30i, text, remedy) {number_16i, number_30i, text, remedy},
#include "interpreter/dialects/fanuc/alarms.def"
#undef ALARM
});

}  // namespace

const AlarmInfo& info(AlarmId id) {
  return kRows.at(static_cast<std::size_t>(id));
}

int number_of(AlarmId id, AlarmNumbers numbers) {
  const AlarmInfo& row = info(id);
  return numbers == AlarmNumbers::Series16i ? row.number_16i : row.number_30i;
}

}  // namespace g31::fanuc
