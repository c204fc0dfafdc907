#include "interpreter/dialects/sinumerik/explain/explain.h"

#include <algorithm>
#include <array>
#include <string>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/vocabulary/alarms.h"
#include "interpreter/dialects/sinumerik/vocabulary/constants.h"
#include "interpreter/dialects/sinumerik/vocabulary/functions.h"
#include "interpreter/dialects/sinumerik/vocabulary/g_codes.h"
#include "interpreter/dialects/sinumerik/vocabulary/machine_data.h"
#include "interpreter/dialects/sinumerik/vocabulary/names.h"
#include "interpreter/dialects/sinumerik/vocabulary/operators.h"
#include "interpreter/dialects/sinumerik/vocabulary/system_variables.h"
#include "interpreter/dialects/sinumerik/vocabulary/words.h"
#include "machine/base/nearest_name.h"

namespace g31::sinumerik {
namespace {

using runtime::Entries;
using runtime::Entry;

std::string text(std::string_view view) {
  return std::string(view);
}

runtime::Fact refused_here() {
  return {"here", "not yet: alarm 12140"};
}

void add_language(Topics& all) {
  for (const KeywordInfo& row : keywords()) {
    Entry entry{"statement", text(row.name), text(row.text), {{"form", text(row.form)}}};
    if (row.is_refused) {
      entry.facts.push_back(refused_here());
    }
    all.push_back({text(row.name), "", std::move(entry)});
  }
  for (const CycleInfo& row : unsimulated_cycles()) {
    all.push_back(
        {text(row.name),
         "",
         {"cycle",
          text(row.name),
          text(row.text) +
              "; not simulated: a call is reported and skipped if there is no program of this name",
          {}}});
  }
  for (const OperatorInfo& row : operators()) {
    all.push_back({text(row.name),
                   "",
                   {"operator",
                    text(row.name),
                    text(row.text),
                    {{"binds", fmt::format("level {} of 0 (least) to 9", row.level)}}}});
  }
  for (const ConstantInfo& row : constants()) {
    all.push_back(
        {text(row.name),
         "",
         {"constant", text(row.name), text(row.text), {{"type", text(name_of(row.type))}}}});
  }
  for (const FunctionInfo& row : functions()) {
    all.push_back({text(row.name),
                   "",
                   {"function",
                    text(row.name),
                    text(row.text),
                    {{"form", text(row.form)}, {"gives", text(name_of(row.result))}}}});
  }
  for (const ProcedureInfo& row : procedures()) {
    all.push_back({text(row.name),
                   "",
                   {"procedure", text(row.name), text(row.text), {{"form", text(row.form)}}}});
  }
}

void add_words(Topics& all) {
  for (const GCode& row : g_codes()) {
    Entry entry{"G code",
                text(row.name),
                text(row.text),
                {{"group", std::to_string(static_cast<int>(row.group))}}};
    if (row.action == GAction::Refused) {
      entry.facts.push_back(refused_here());
    }
    all.push_back({text(row.name), "", std::move(entry)});
  }
  for (const AxisWordInfo& row : axis_words()) {
    Entry entry{"address of an axis",
                text(row.name),
                text(row.text),
                {{"form", fmt::format("{}[axis]{}", row.name, is_switch(row.role) ? "" : "=...")}}};
    if (row.role == AxisRole::Refused) {
      entry.facts.push_back(refused_here());
    } else if (is_switch(row.role)) {
      entry.facts.push_back({"values", "none"});
    } else if (row.most > 0.0) {
      entry.facts.push_back({"values", fmt::format("{:g} to {:g}", row.least, row.most)});
    }
    all.push_back({text(row.name), "", std::move(entry)});
  }
  for (const ModificationInfo& row : modifications()) {
    all.push_back({text(row.name),
                   "",
                   {"form of a value",
                    text(row.name),
                    text(row.text),
                    {{"form", fmt::format("X={}(value)", row.name)}}}});
  }
  for (const AddressInfo& row : addresses()) {
    all.push_back({text(row.name), "", {"address", text(row.name), text(row.text), {}}});
  }
}

void add_variables(Topics& all) {
  for (const SystemVariable& row : system_variables()) {
    Entry entry{
        "system variable", text(row.name), text(row.text), {{"type", text(name_of(row.type))}}};
    if (row.access == Access::Refused) {
      entry.facts.push_back(refused_here());
    } else {
      entry.facts.push_back({"access", row.access == Access::Read ? "read" : "read and write"});
    }
    all.push_back({text(row.name), "", std::move(entry)});
  }
  for (const MachineDatum& row : machine_data()) {
    Entry entry{"machine or setting datum",
                fmt::format("{} {}", row.number, row.name),
                text(row.text),
                {{"type", text(name_of(row.type))},
                 {"before the start",
                  is_number(row.type) ? fmt::format("{}", row.preset) : std::string("empty")}}};
    if (row.count > 0) {
      entry.facts.push_back({"elements", std::to_string(row.count)});
    }
    if (row.effect == MachineDatum::Effect::Fixed) {
      entry.facts.push_back({"here", "g31 goes on as with the value before the start (PRB331)"});
    }
    all.push_back({text(row.name), std::to_string(row.number), std::move(entry)});
  }
}

void add_memory(Topics& all) {
  all.push_back({"R",
                 "",
                 {"variable",
                  "R0 to R999",
                  "R parameters: R5 or R[index]",
                  {{"type", "REAL"}, {"access", "read and write"}}}});
  for (const MemoryRow& row : memory_rows()) {
    Entry entry{"system variable",
                text(row.name),
                text(row.text),
                {{"type", text(name_of(row.type))}, {"access", "read and write"}}};
    all.push_back({text(row.name), "", std::move(entry)});
  }
}

void add_alarms(Topics& all) {
  for (const AlarmInfo& row : alarms()) {
    Entry entry{"alarm", fmt::format("{} {}", row.number, row.text), text(row.remedy), {}};
    all.push_back(
        {fmt::format("ALARM {}", row.number), std::to_string(row.number), std::move(entry)});
  }
}

const Topics& topics() {
  static const Topics kTopics = [] {
    Topics all;
    add_language(all);
    add_words(all);
    add_variables(all);
    add_memory(all);
    add_alarms(all);
    return all;
  }();
  return kTopics;
}

/// The row that stands for a whole family: R for R12, G505 for G520.
std::string family_of(const std::string& name) {
  const bool numbered =
      name.size() > 1 && name.size() < 5 && std::all_of(name.begin() + 1, name.end(), is_digit);
  const int number = numbered ? std::stoi(name.substr(1)) : -1;
  if (numbered && name.front() == 'R') {
    return "R";
  }
  return number > 505 && name.front() == 'G' && number <= 599 ? "G505" : name;
}

/// "54607" of "SD54607" and "MD51740", as manuals and messages write a datum; else nothing.
std::string datum_number_in(const std::string& name) {
  const bool is_written_so = (name.starts_with("SD") || name.starts_with("MD")) &&
                             name.size() > 2 && std::all_of(name.begin() + 2, name.end(), is_digit);
  return is_written_so ? name.substr(2) : std::string();
}

/// "[4]" behind a name, or nothing.
std::string index_in(std::string_view name) {
  const std::size_t bracket = name.find('[');
  return bracket == std::string_view::npos ? std::string() : std::string(name.substr(bracket));
}

/// Of the facts about single elements only that of the element asked for.
Entry about_element(Entry entry, const std::string& index) {
  if (!index.empty()) {
    std::erase_if(entry.facts, [&](const runtime::Fact& fact) {
      return fact.name.starts_with('[') && fact.name != index;
    });
  }
  return entry;
}

}  // namespace

Entries explain(std::string_view topic, const Topics& shipped) {
  std::string name = upper(topic);
  name.erase(0, std::min(name.find_first_not_of(' '), name.size()));
  name.erase(name.find_last_not_of(' ') + 1);
  // An index or a number behind a name seldom says more: $AA_MW[X], $TC_DP6, but _OVR[4].
  const std::string stem = family_of(name.substr(0, name.find_first_of("[(")));
  const std::string datum = datum_number_in(stem);
  const auto system = find_system_variable(stem);
  Entries found;
  for (const Topics* const list : {&topics(), &shipped}) {
    for (const Topic& known : *list) {
      const bool is_system = system && known.name == system->row->name;
      const bool is_datum = !datum.empty() && known.other == datum && known.name.starts_with('$');
      if (known.name == stem || known.other == stem || is_system || is_datum) {
        found.push_back(about_element(known.entry, index_in(name)));
      }
    }
  }
  return found;
}

std::optional<std::string> nearest_topic(std::string_view topic, const Topics& shipped) {
  std::vector<std::string_view> known;
  for (const Topics* const list : {&topics(), &shipped}) {
    for (const Topic& row : *list) {
      known.push_back(row.name);
    }
  }
  const std::string name = upper(topic);
  const auto nearest = nearest_name(name, known);
  return nearest ? std::optional(std::string(*nearest)) : std::nullopt;
}

Entries everything(const Topics& shipped) {
  Entries all;
  for (const Topics* const list : {&topics(), &shipped}) {
    for (const Topic& row : *list) {
      all.push_back(row.entry);
    }
  }
  return all;
}

}  // namespace g31::sinumerik
