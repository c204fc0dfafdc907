#include "interpreter/dialects/sinumerik/vocabulary/machine_data.h"

#include <array>

namespace g31::sinumerik {
namespace {

constexpr auto kMachineData = std::to_array<MachineDatum>({
#define ROW(number, name, type, count, preset, unit, text, effect) \
  {number, name, Type::type, count, preset, DatumUnit::unit, text, MachineDatum::Effect::effect},
#define MACHINE_DATA(...) ROW(__VA_ARGS__, Usual)
#define FIXED_DATA(...) ROW(__VA_ARGS__, Fixed)
#define WATCHED_DATA(...) ROW(__VA_ARGS__, Watched)
#include "interpreter/dialects/sinumerik/vocabulary/machine_data.def"
#undef WATCHED_DATA
#undef FIXED_DATA
#undef MACHINE_DATA
#undef ROW
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
