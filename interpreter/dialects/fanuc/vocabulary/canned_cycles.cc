#include "interpreter/dialects/fanuc/vocabulary/canned_cycles.h"

#include <algorithm>
#include <array>

namespace g31::fanuc {
namespace {

constexpr auto kCannedCycleRows = std::to_array<CannedCycle>({
#define CANNED_CYCLE(code, feeding, dwell, shift, retract)                                    \
  {code, CannedCycle::Feeding::feeding, CannedCycle::Dwell::dwell, CannedCycle::Shift::shift, \
   CannedCycle::Retract::retract},
#include "interpreter/dialects/fanuc/vocabulary/canned_cycles.def"
#undef CANNED_CYCLE
});

}  // namespace

const CannedCycle* find_canned_cycle(int code) {
  const auto* const row = std::ranges::find(kCannedCycleRows, code, &CannedCycle::code);
  return row != kCannedCycleRows.end() ? row : nullptr;
}

}  // namespace g31::fanuc
