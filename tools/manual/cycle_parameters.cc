#include "tools/manual/cycle_parameters.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "machine/base/letters.h"
#include "tools/manual/entries.h"

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

runtime::Entries all_parameter_entries() {
  runtime::Entries all;
  for (const CycleParameter& row : kCycleParameters) {
    const bool is_of_some = std::ranges::any_of(kCycleParameters, [&](const CycleParameter& other) {
      return other.name == row.name && !other.cycles.empty();
    });
    std::string cycles(row.cycles);
    if (cycles.empty()) {
      cycles = is_of_some ? "all others that have it" : "all that have it";
    }
    all.push_back({"parameter of measuring cycles",
                   std::string(row.name),
                   std::string(row.text),
                   {{"of CYCLE", cycles}}});
  }
  return all;
}

runtime::Entries parameter_entries(std::string_view topic) {
  constexpr std::size_t kShortest = 3;  // K and MA are addresses and axes, too
  const std::string name = in_capitals(topic);
  runtime::Entries found = all_parameter_entries();
  std::erase_if(found, [&](const runtime::Entry& entry) {
    return entry.name != name && (name.size() < kShortest || entry.name != "S_" + name);
  });
  return found;
}

}  // namespace g31::manual
