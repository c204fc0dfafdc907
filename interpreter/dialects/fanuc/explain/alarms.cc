#include "interpreter/dialects/fanuc/vocabulary/alarms.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/explain/entry.h"

namespace g31::fanuc::reference {
namespace {

/// Letters that some control writes before an alarm number, and whose numbers they are.
struct Letters {
  std::string_view text;
  std::optional<AlarmNumbers> numbers;  ///< none: those of the control in question
};

constexpr Letters kLetters[] = {{"ALARM ", {}},
                                {"PS", AlarmNumbers::Series30i},
                                {"MC", AlarmNumbers::Series30i},
                                {"P", AlarmNumbers::Meldas},
                                {"", {}}};

constexpr std::pair<AlarmNumbers, std::string_view> kFamilies[] = {
    {AlarmNumbers::Series16i, "Fanuc 16i"},
    {AlarmNumbers::Series30i, "Fanuc 30i"},
    {AlarmNumbers::Meldas, "MELDAS"}};

std::optional<int> whole_number(std::string_view text) {
  int number = 0;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = !text.empty() && end.ec == std::errc() && end.ptr == text.data() + text.size();
  return whole && number >= 0 ? std::optional(number) : std::nullopt;
}

Entry entry_of(const AlarmInfo& row, int number) {
  Entry entry{"alarm", fmt::format("{} {}", number, row.text), std::string(row.remedy), {}};
  for (const auto& [numbers, family] : kFamilies) {
    entry.facts.push_back({std::string(family), std::to_string(number_of(row, numbers))});
  }
  return entry;
}

Entries of_numbering(int number, AlarmNumbers numbers) {
  Entries found;
  for (const AlarmInfo& row : fanuc::alarms()) {
    if (number_of(row, numbers) == number) {
      found.push_back(entry_of(row, number));
    }
  }
  return found;
}

/// The alarm that `#3000=n` of this control makes.
void add_macro_alarm(Entries& found, int number, const Profile& profile) {
  const MacroAlarmRule& rule = profile.macro_alarm;
  const int n = number - rule.base;
  if (rule.number == MacroAlarmRule::Number::BasePlusValue && n > 0 && n <= rule.largest) {
    found.push_back({"alarm",
                     fmt::format("{} {}", number, info(AlarmId::MacroAlarm).text),
                     fmt::format("the program itself stopped with #3000={}(TEXT)", n),
                     {}});
  }
}

}  // namespace

Entries alarms(std::string_view topic, const Profile& profile) {
  for (const Letters& letters : kLetters) {
    if (!topic.starts_with(letters.text)) {
      continue;
    }
    const auto number = whole_number(topic.substr(letters.text.size()));
    if (!number) {
      continue;
    }
    Entries found = of_numbering(*number, letters.numbers.value_or(profile.alarm_numbers));
    add_macro_alarm(found, *number, profile);
    // The number may be another control's: an alarm seen on a screen is still worth an answer.
    for (const auto& [numbers, family] : kFamilies) {
      if (!found.empty()) {
        break;
      }
      found = of_numbering(*number, numbers);
    }
    return found;
  }
  return {};
}

Entries all_alarms(const Profile& profile) {
  std::set<int> numbers;
  for (const AlarmInfo& row : fanuc::alarms()) {
    numbers.insert(number_of(row, profile.alarm_numbers));
  }
  Entries all;
  for (const int number : numbers) {
    std::ranges::move(of_numbering(number, profile.alarm_numbers), std::back_inserter(all));
  }
  return all;
}

}  // namespace g31::fanuc::reference
