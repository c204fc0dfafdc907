#include "interpreter/dialects/fanuc/vocabulary/alarms.h"

#include <array>

#include "machine/base/contract.h"

namespace g31::fanuc {
namespace {

constexpr auto kAlarmRows = std::to_array<AlarmInfo>({
#define ALARM(name, number_16i, number_30i, number_meldas, text, remedy) \
  {number_16i, number_30i, number_meldas, text, remedy},
#include "interpreter/dialects/fanuc/vocabulary/alarms.def"
#undef ALARM
});

}  // namespace

std::span<const AlarmInfo> alarms() {
  return kAlarmRows;
}

const AlarmInfo& info(AlarmId id) {
  return kAlarmRows.at(static_cast<std::size_t>(id));
}

int number_of(const AlarmInfo& row, AlarmNumbers numbers) {
  switch (numbers) {
    case AlarmNumbers::Series16i:
      return row.number_16i;
    case AlarmNumbers::Series30i:
      return row.number_30i;
    case AlarmNumbers::Meldas:
      return row.number_meldas;
  }
  contract_violated("every numbering has a column", __FILE__, __LINE__);
}

int number_of(AlarmId id, AlarmNumbers numbers) {
  return number_of(info(id), numbers);
}

}  // namespace g31::fanuc
