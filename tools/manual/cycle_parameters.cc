#include "tools/manual/cycle_parameters.h"

#include <algorithm>
#include <array>

namespace g31::manual {
namespace {

constexpr auto kCycleParameters = std::to_array<CycleParameter>({
#define CYCLE_PARAMETER(cycles, name, text) {cycles, name, text},
#include "tools/manual/cycle_parameters.def"
#undef CYCLE_PARAMETER
});

}  // namespace

std::span<const CycleParameter> cycle_parameters() {
  return kCycleParameters;
}

std::string_view text_of_parameter(std::string_view cycle, std::string_view name) {
  constexpr std::string_view kWord = "CYCLE";
  if (!cycle.starts_with(kWord)) {
    return {};
  }
  cycle.remove_prefix(kWord.size());
  // All numbers of measuring cycles have three digits, so none is part of another.
  const auto* const row = std::ranges::find_if(kCycleParameters, [&](const CycleParameter& each) {
    return each.name == name &&
           (each.cycles.empty() || each.cycles.find(cycle) != std::string_view::npos);
  });
  return row != kCycleParameters.end() ? row->text : std::string_view();
}

}  // namespace g31::manual
