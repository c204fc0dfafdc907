#include "interpreter/dialects/sinumerik/vocabulary/machine_data.h"

#include <array>

namespace g31::sinumerik {
namespace {

constexpr auto kMachineData = std::to_array<MachineDatum>({
#define MACHINE_DATA(number, name, type, count, preset, unit, text) \
  {number, name, Type::type, count, preset, DatumUnit::unit, text, false},
#define FIXED_DATA(number, name, type, count, preset, unit, text) \
  {number, name, Type::type, count, preset, DatumUnit::unit, text, true},
#include "interpreter/dialects/sinumerik/vocabulary/machine_data.def"
#undef FIXED_DATA
#undef MACHINE_DATA
});

constexpr auto kMemory = std::to_array<MemoryRow>({
#define MEMORY(name, type, count, text) {name, Type::type, count, text},
#include "interpreter/dialects/sinumerik/vocabulary/memory.def"
#undef MEMORY
});

}  // namespace

std::span<const MachineDatum> machine_data() {
  return kMachineData;
}

std::span<const MemoryRow> memory_rows() {
  return kMemory;
}

}  // namespace g31::sinumerik
