#include "interpreter/dialects/sinumerik/vocabulary/words.h"

#include <algorithm>
#include <array>
#include <vector>

#include "interpreter/dialects/sinumerik/vocabulary/names.h"

namespace g31::sinumerik {
namespace {

constexpr auto kAddresses = std::to_array<AddressInfo>({
#define ADDRESS(id, name, least, most, text) {name, least, most, text},
#include "interpreter/dialects/sinumerik/vocabulary/addresses.def"
#undef ADDRESS
});

constexpr auto kProcedures = std::to_array<ProcedureInfo>({
#define PROCEDURE(name, parameters, work, form, text) {#name, parameters, form, text},
#include "interpreter/dialects/sinumerik/vocabulary/procedures.def"
#undef PROCEDURE
});

constexpr std::string_view kRefusing = "refuse";

constexpr auto kKeywords = std::to_array<KeywordInfo>({
#define KEYWORD(name, part, statement, form, text) {#name, form, text, #statement == kRefusing},
#include "interpreter/dialects/sinumerik/vocabulary/keywords.def"
#undef KEYWORD
});

constexpr auto kUnsimulatedCycles = std::to_array<CycleInfo>({
#define UNSIMULATED_CYCLE(name, text) {name, text},
#include "interpreter/dialects/sinumerik/vocabulary/unsimulated_cycles.def"
#undef UNSIMULATED_CYCLE
});

constexpr auto kAxisWords = std::to_array<AxisWordInfo>({
#define Path() AxisRole::Path
#define Positioning() AxisRole::Positioning
#define Measuring() AxisRole::Measuring
#define Setting(f) AxisRole::Setting
#define AxisSetting(f) AxisRole::AxisSetting
#define Switch(f) AxisRole::Switch
#define AxisSwitch(f) AxisRole::AxisSwitch
#define Refused() AxisRole::Refused
#define AXIS_WORD(id, name, role, least, most, text) \
  {AxisWordId::id, name, role, least, most, text},
#include "interpreter/dialects/sinumerik/vocabulary/axis_words.def"
#undef AXIS_WORD
#undef Refused
#undef AxisSwitch
#undef Switch
#undef AxisSetting
#undef Setting
#undef Measuring
#undef Positioning
#undef Path
});

constexpr auto kModifications = std::to_array<ModificationInfo>({
#define MODIFICATION(id, name, text) {Modification::id, name, text},
#include "interpreter/dialects/sinumerik/vocabulary/modifications.def"
#undef MODIFICATION
});

/// Most addresses are one letter: A to Z.
std::vector<std::optional<Address>> addresses_by_letter() {
  std::vector<std::optional<Address>> all(26);
  for (std::size_t i = 0; i < kAddresses.size(); ++i) {
    if (kAddresses[i].name.size() == 1) {
      all[static_cast<std::size_t>(kAddresses[i].name.front() - 'A')] =
          static_cast<Address>(i + kAxisCount);
    }
  }
  return all;
}

}  // namespace

std::span<const AddressInfo> addresses() {
  return kAddresses;
}

std::optional<Address> find_address(std::string_view name) {
  static const std::vector<std::optional<Address>> kByLetter = addresses_by_letter();
  if (name.size() == 1 && name.front() >= 'A' && name.front() <= 'Z') {
    return kByLetter[static_cast<std::size_t>(name.front() - 'A')];
  }
  for (std::size_t i = 0; i < kAddresses.size(); ++i) {
    if (kAddresses[i].name == name) {
      return static_cast<Address>(i + kAxisCount);
    }
  }
  return std::nullopt;
}

std::string_view name_of(Address address) {
  const std::size_t index = index_of(address);
  return index < kAxisCount ? std::string_view(kAxisLetters).substr(index, 1)
                            : kAddresses[index - kAxisCount].name;
}

ValueRange range_of(Address address) {
  const std::size_t index = index_of(address);
  return index < kAxisCount ? ValueRange()
                            : ValueRange{kAddresses[index - kAxisCount].least,
                                         kAddresses[index - kAxisCount].most};
}

std::span<const ModificationInfo> modifications() {
  return kModifications;
}

std::optional<Modification> find_modification(std::string_view name) {
  const auto found = std::ranges::find(kModifications, name, &ModificationInfo::name);
  return found != kModifications.end() ? std::optional(found->modification) : std::nullopt;
}

std::span<const AxisWordInfo> axis_words() {
  return kAxisWords;
}

const AxisWordInfo& info(AxisWordId id) {
  return kAxisWords.at(static_cast<std::size_t>(id));
}

int axis_named(std::string_view name) {
  const auto by_letter = [](char letter) {
    const std::size_t further = kFurtherAxes.find(letter);
    return further == std::string_view::npos ? axis_index(letter)
                                             : kFirstFurtherAxis + static_cast<int>(further);
  };
  if (name.size() == 3 && name.starts_with("AX") && name[2] >= '1' &&
      name[2] < '1' + static_cast<int>(kAxisCount)) {
    return name[2] - '1';
  }
  if (name.size() == 3 && name.front() == 'M') {
    name.remove_prefix(1);
    return name[1] == '1' ? by_letter(name.front()) : -1;
  }
  const bool is_machine_name = name.size() == 2 && name[1] == '1';
  return name.size() == 1 || is_machine_name ? by_letter(name.front()) : -1;
}

const AxisWordInfo* find_axis_word(std::string_view name) {
  const auto found = std::ranges::find(kAxisWords, name, &AxisWordInfo::name);
  return found != kAxisWords.end() ? &*found : nullptr;
}

std::span<const KeywordInfo> keywords() {
  return kKeywords;
}

std::span<const CycleInfo> unsimulated_cycles() {
  return kUnsimulatedCycles;
}

const CycleInfo* find_unsimulated_cycle(std::string_view name) {
  const auto found = std::ranges::find(kUnsimulatedCycles, upper(name), &CycleInfo::name);
  return found != kUnsimulatedCycles.end() ? &*found : nullptr;
}

std::span<const ProcedureInfo> procedures() {
  return kProcedures;
}

std::optional<ProcedureId> find_procedure(std::string_view name) {
  static const NameMap<ProcedureId> kByName = [] {
    NameMap<ProcedureId> map;
    for (std::size_t i = 0; i < kProcedures.size(); ++i) {
      map.emplace(std::string(kProcedures[i].name), static_cast<ProcedureId>(i));
    }
    return map;
  }();
  const auto found = kByName.find(name);
  return found != kByName.end() ? std::optional(found->second) : std::nullopt;
}

}  // namespace g31::sinumerik
