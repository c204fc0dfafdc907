#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/explain/entry.h"
#include "interpreter/dialects/fanuc/vocabulary/variable_names.h"
#include "interpreter/dialects/fanuc/vocabulary/variable_ranges.h"
#include "machine/base/contract.h"
#include "machine/units/axis_positions.h"

namespace g31::fanuc::reference {
namespace {

struct Range {
  int first = 0;
  int last = 0;
};

/// A run of variables that are a program's own.
struct UserRange {
  Range range;
  std::string_view kind;
  std::string_view text;
};

constexpr UserRange kUserRanges[] = {
    {{0, 0}, "variable", "null: never a value; a variable set from it becomes null"},
    {{1, kLocalCount},
     "local variable",
     "local to a macro call; G65 passes its arguments in them, the rest is null; M98 shares them"},
    {{kFirstCommon, kLastVolatile},
     "common variable",
     "common to all programs; null after power on and after reset"},
    {{kFirstPermanent, kCommonEnd - 1},
     "common variable",
     "common to all programs, kept when the power is off; the set-up sheet's variables_file holds "
     "them"}};

std::optional<Range> range_of(std::string_view topic) {
  const std::size_t minus = std::min(topic.find('-'), topic.size());
  const std::string_view end = topic.substr(std::min(minus + 1, topic.size()));
  const auto first = variable_in_name(topic.substr(0, minus));
  const auto last =
      minus == topic.size()
          ? first
          : variable_in_name(end.starts_with('#') ? std::string(end) : fmt::format("#{}", end));
  return first && last && *first <= *last ? std::optional(Range{*first, *last}) : std::nullopt;
}

std::string name_of(const Range& range) {
  return range.first == range.last ? fmt::format("#{}", range.first)
                                   : fmt::format("#{} to #{}", range.first, range.last);
}

std::string_view text_of(Unit unit) {
  switch (unit) {
    case Unit::None:
      return "";
    case Unit::Bit:
      return "0 or 1";
    case Unit::Bits:
      return "an integer, by its bits";
    case Unit::Milliseconds:
      return "ms";
    case Unit::Hours:
      return "h";
    case Unit::Length:
      return "mm or inch, whichever is in force";
    case Unit::Axis:
      return "mm or inch, whichever is in force; degrees of A, B and C";
  }
  contract_violated("every Unit has a text", __FILE__, __LINE__);
}

std::string_view text_of(Access access) {
  switch (access) {
    case Access::Read:
      return "read only";
    case Access::Write:
      return "write only";
    case Access::ReadWrite:
      return "read and write";
    case Access::Input:
      return "read only; [variables] of the set-up sheet gives the value";
  }
  contract_violated("every Access has a text", __FILE__, __LINE__);
}

std::string axis_name(int axis) {
  return axis < static_cast<int>(kAxisCount) ? std::string(1, kAxisLetters[axis])
                                             : fmt::format("axis {}", axis + 1);
}

std::string system_name(int system, const Profile& profile) {
  return system == 0 ? std::string("external offset") : work_system_name(system, profile);
}

/// Which axis, offset or group one number of a row means; "" where the row says it.
std::string meaning_of(const SystemVariable& row, int number, const Profile& profile) {
  const int index = number - row.first;
  if (row.shows == Shows::WorkOffset || row.shows == Shows::AdditionalOffset) {
    const bool is_additional = row.shows == Shows::AdditionalOffset;
    const int place = is_additional ? index : number - kFirstWorkOffset;
    const int first_system = is_additional ? kWorkSystems + 1 : 0;
    return fmt::format("{}, {}", system_name(first_system + place / kNumbersPerSystem, profile),
                       axis_name(place % kNumbersPerSystem));
  }
  if (row.shows == Shows::LegacyOffset) {
    return system_name(index, profile);
  }
  if (row.unit == Unit::Axis) {
    return axis_name(index);
  }
  if (row.unit == Unit::Length) {
    return fmt::format("offset {}", index + 1);
  }
  return row.shows == Shows::ModalGroup ? fmt::format("group {}", index + 1) : "";
}

Entry entry_of(const SystemVariable& row, const Range& asked, const Profile& profile) {
  Entry entry{"system variable", name_of(asked), std::string(row.text), {}};
  if (asked.first == asked.last) {
    if (std::string meaning = meaning_of(row, asked.first, profile); !meaning.empty()) {
      entry.facts.push_back({"here", std::move(meaning)});
    }
    if (row.first != row.last) {
      entry.facts.push_back({"numbers", name_of({row.first, row.last})});
    }
  }
  if (const std::string_view unit = text_of(row.unit); !unit.empty()) {
    entry.facts.push_back({"unit", std::string(unit)});
  }
  entry.facts.push_back({"access", std::string(text_of(row.access))});
  if (row.while_moving == WhileMoving::Disabled) {
    entry.facts.push_back(
        {"while moving", "not to be read: look-ahead gets the value of some earlier moment"});
  }
  return entry;
}

/// A tool offset memory, other than C as it comes, and how it is set up (MB-122).
struct OtherMemory {
  VariableGroup group;
  std::string_view when;
};

constexpr OtherMemory kOtherMemories[] = {
    {VariableGroup::OffsetsA, "with offset_memory = \"A\""},
    {VariableGroup::OffsetsB, "with offset_memory = \"B\""},
    {VariableGroup::OffsetsCTurned, "with parameter 6000.3 = 1"}};

bool has_part(const SystemVariable& row, const Range& range) {
  return row.first <= range.last && range.first <= row.last;
}

/// What the numbers mean under the other memories, where that is not what `row` says.
std::vector<Fact> other_meanings(const SystemVariable* row, const Range& asked,
                                 const Profile& profile) {
  std::vector<Fact> facts;
  if (!profile.variables.meets({VariableGroup::OffsetsC})) {
    return facts;
  }
  for (const OtherMemory& memory : kOtherMemories) {
    for (const SystemVariable& other : system_variables()) {
      const bool is_other = row == nullptr || (&other != row && other.text != row->text);
      if (is_other && other.groups.meets({memory.group}) && has_part(other, asked)) {
        facts.push_back({std::string(memory.when), std::string(other.text)});
      }
    }
  }
  return facts;
}

}  // namespace

Entries variables(std::string_view topic, const Profile& profile) {
  Entries found;
  const auto asked = range_of(topic);
  if (!asked) {
    return found;
  }
  const auto common = [&](int first, int last) {
    return Range{std::max(first, asked->first), std::min(last, asked->last)};
  };
  for (const UserRange& row : kUserRanges) {
    const Range part = common(row.range.first, row.range.last);
    if (part.first <= part.last) {
      found.push_back({std::string(row.kind), name_of(part), std::string(row.text), {}});
    }
  }
  const SystemVariableIndex index(profile.variables);
  for (const SystemVariable* const row : index.rows()) {
    const Range part = common(row->first, row->last);
    if (part.first <= part.last) {
      Entry entry = entry_of(*row, part, profile);
      std::ranges::move(other_meanings(row, part, profile), std::back_inserter(entry.facts));
      found.push_back(std::move(entry));
    }
  }
  if (found.empty()) {
    if (auto facts = other_meanings(nullptr, *asked, profile); !facts.empty()) {
      found.push_back({"system variable", name_of(*asked), "nothing in offset memory C as it comes",
                       std::move(facts)});
    }
  }
  return found;
}

}  // namespace g31::fanuc::reference
