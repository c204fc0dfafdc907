#include "tools/setup/fill_inputs.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "machine/base/contract.h"
#include "tools/setup/program_switch.h"
#include "tools/setup/table_keys.h"

namespace g31::setup {
namespace {

using From = runtime::InputStep::From;

constexpr std::pair<KeyId, From> kBeginnings[] = {{KeyId::InputFromTime, From::Time},
                                                  {KeyId::InputFromBlock, From::Block},
                                                  {KeyId::InputFromReads, From::Reads},
                                                  {KeyId::InputFromCode, From::Code}};

std::string_view name_of(KeyId id) {
  return std::ranges::find(key_rows(), id, &KeyRow::id)->name;
}

double at_of(From from, const Entry& entry) {
  if (from != From::Code) {
    return number_of(entry);
  }
  const auto code = program_switch(std::get<std::string>(entry.value));
  G31_EXPECTS(code);  // the check let no other text through
  return code->number;
}

/// @pre it has its number
runtime::InputStep step_from(const SheetTable& table, ErrorList& errors) {
  const TableKeys keys(table);
  runtime::InputStep step;
  step.number = static_cast<int>(number_of(*keys.find(KeyId::InputWhich)));
  step.value = keys.get(KeyId::InputValue, 1.0) != 0.0;
  std::string_view given;
  for (const auto& [id, from] : kBeginnings) {
    const Entry* const entry = keys.find(id);
    if (entry == nullptr) {
      continue;
    }
    if (!given.empty()) {
      errors.add(SetupErrorId::InputFromTwo, entry->where,
                 {std::string(given), std::string(name_of(id))},
                 "write two [[input]], each with one of them");
    }
    given = name_of(id);
    step.from = from;
    step.at = at_of(from, *entry);
  }
  return step;
}

/// The inputs that the probe sets, with the key that says so; an input shows one thing.
std::map<int, std::string> inputs_of_probe(const SheetTable& probe, ErrorList& errors) {
  const TableKeys keys(probe);
  std::map<int, std::string> taken;
  for (const KeyId id :
       {KeyId::ProbeReadyInput, KeyId::ProbeSignalInput, KeyId::ProbeBatteryInput}) {
    const Entry* const input = keys.find(id);
    if (input == nullptr) {
      continue;
    }
    const auto number = static_cast<int>(number_of(*input));
    const std::string path = fmt::format("probe.{}", name_of(id));
    const auto [first, is_free] = taken.try_emplace(number, path);
    if (!is_free) {
      errors.add(SetupErrorId::InputTaken, input->where,
                 {path, std::to_string(number), first->second}, "each takes an input of its own");
    }
  }
  return taken;
}

}  // namespace

std::vector<runtime::InputStep> inputs_from(const Sheet& sheet, ErrorList& errors) {
  std::vector<runtime::InputStep> steps;
  std::map<int, std::string> taken;
  if (const auto probe = sheet.tables.find({SectionId::Probe, ""}); probe != sheet.tables.end()) {
    taken = inputs_of_probe(probe->second, errors);
    const TableKeys keys(probe->second);
    if (const Entry* const battery = keys.find(KeyId::ProbeBatteryInput)) {
      const bool is_low = keys.get(KeyId::ProbeStateKind, std::string()) == "low_battery";
      steps.push_back({static_cast<int>(number_of(*battery)), is_low, From::Start, 0.0});
    }
  }
  for (const SheetTable& table : list_of(sheet, SectionId::Input)) {
    const Entry* const which = TableKeys(table).find(KeyId::InputWhich);
    if (which == nullptr) {
      errors.add(SetupErrorId::KeyMissing, table.where, {"an input", "number"},
                 "for example: number = 1003");
      continue;
    }
    steps.push_back(step_from(table, errors));
    if (const auto first = taken.find(steps.back().number); first != taken.end()) {
      errors.add(SetupErrorId::InputTaken, which->where,
                 {"input.number", std::to_string(steps.back().number), first->second},
                 "each takes an input of its own");
    }
  }
  return steps;
}

}  // namespace g31::setup
