#include "tools/manual/cycle_parameters.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace g31::manual {
namespace {

constexpr auto kCycleParameters = std::to_array<CycleParameter>({
#define CYCLE_PARAMETER(cycles, name, text) {cycles, name, text},
#include "tools/manual/cycle_parameters.def"
#undef CYCLE_PARAMETER
});

/// Whether a list of numbers with blanks between them has a number; 9960 is not 996.
bool has_number(std::string_view list, std::string_view number) {
  for (auto at = list.find(number); at != std::string_view::npos; at = list.find(number, at + 1)) {
    const std::size_t behind = at + number.size();
    if ((at == 0 || list[at - 1] == ' ') && (behind == list.size() || list[behind] == ' ')) {
      return true;
    }
  }
  return false;
}

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
  const auto* const row = std::ranges::find_if(kCycleParameters, [&](const CycleParameter& each) {
    return each.name == name && (each.cycles.empty() || has_number(each.cycles, cycle));
  });
  return row != kCycleParameters.end() ? row->text : std::string_view();
}

}  // namespace g31::manual
