#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/explain/entry.h"
#include "interpreter/dialects/fanuc/vocabulary/functions.h"
#include "interpreter/dialects/fanuc/vocabulary/g_codes.h"
#include "interpreter/dialects/fanuc/vocabulary/parameters.h"
#include "interpreter/dialects/fanuc/vocabulary/statements.h"
#include "interpreter/dialects/fanuc/vocabulary/variable_names.h"

namespace g31::fanuc::reference {
namespace {

struct LanguageWord {
  std::string_view name;
  std::string_view form;
  std::string_view text;
};

constexpr auto kWords = std::to_array<LanguageWord>({
#define LANGUAGE_WORD(name, form, text) {name, form, text},
#define PROGRAM_M_CODE(number, form, text)
#include "interpreter/dialects/fanuc/vocabulary/words.def"
#undef PROGRAM_M_CODE
#undef LANGUAGE_WORD
});

struct ProgramMCode {
  int number;
  std::string_view form;
  std::string_view text;
};

constexpr auto kMCodes = std::to_array<ProgramMCode>({
#define LANGUAGE_WORD(name, form, text)
#define PROGRAM_M_CODE(number, form, text) {number, form, text},
#include "interpreter/dialects/fanuc/vocabulary/words.def"
#undef PROGRAM_M_CODE
#undef LANGUAGE_WORD
});

constexpr std::string_view kFunctionForms[] = {"{}[a]", "{0}[a], {0}[y]/[x]", "{}[a,b]",
                                               "{0}[n], {0}[n,bit], {0}[n]/[axis]"};

std::optional<double> number_in(std::string_view text) {
  double number = 0.0;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = !text.empty() && end.ec == std::errc() && end.ptr == text.data() + text.size();
  return whole ? std::optional(number) : std::nullopt;
}

Entry entry_of(const GCode& code, const Profile& profile) {
  Entry entry{"G code", to_text(code.number), std::string(code.text), {}};
  if (code.group == Group::OneShot) {
    entry.facts.push_back({"in force", "in its own block only"});
  } else {
    const auto shown = std::ranges::find(profile.modal_layout, static_cast<int>(code.group));
    entry.facts.push_back({"in force", "until another code of its group"});
    if (shown != profile.modal_layout.end()) {
      entry.facts.push_back(
          {"shown by", fmt::format("#{}", 4000 + (shown - profile.modal_layout.begin()))});
    }
  }
  return entry;
}

/// Whether the control knows a word by this spelling: its first two letters are enough.
bool is_spelling_of(std::string_view topic, std::string_view name) {
  return topic == name || (topic.size() >= 2 && name.starts_with(topic));
}

std::string parameter_name(const ParameterInfo& row) {
  if (row.bit) {
    return fmt::format("{}.{}", row.first, *row.bit);
  }
  return row.first == row.last ? std::to_string(row.first)
                               : fmt::format("{} to {}", row.first, row.last);
}

Entry entry_of(const ParameterInfo& row) {
  Entry entry{"parameter", parameter_name(row), std::string(row.text), {}};
  if (!row.bit) {
    entry.facts.push_back({"unit", std::string(row.unit)});
  }
  if (row.initial >= 0.0) {
    entry.facts.push_back({"without a set-up", fmt::format("{}", row.initial)});
  }
  return entry;
}

/// "6001.1" -> 6001 and 1; "3410" -> 3410 alone.
struct ParameterTopic {
  int number = 0;
  std::optional<int> bit;
};

std::optional<ParameterTopic> parameter_topic(std::string_view topic) {
  for (const std::string_view head : {"PARAMETER ", "NO."}) {
    if (topic.starts_with(head)) {
      topic.remove_prefix(head.size());
    }
  }
  const std::size_t point = std::min(topic.find('.'), topic.size());
  const auto number = number_in(topic.substr(0, point));
  if (!number || *number != std::floor(*number) || *number > 99999.0 || *number < 0.0) {
    return std::nullopt;
  }
  ParameterTopic found{static_cast<int>(*number), std::nullopt};
  if (point == topic.size()) {
    return found;
  }
  const auto bit = number_in(topic.substr(point + 1));
  if (!bit || *bit != std::floor(*bit) || *bit < 0.0 || *bit > 7.0) {
    return std::nullopt;
  }
  found.bit = static_cast<int>(*bit);
  return found;
}

}  // namespace

Entries codes(std::string_view topic, const Profile& profile) {
  if (topic.size() < 2) {
    return {};
  }
  const auto number = number_in(topic.substr(1));
  if (!number) {
    return {};
  }
  if (topic.front() == 'G') {
    const GCode* const code = find_g_code(*number, profile);
    return code != nullptr ? Entries{entry_of(*code, profile)} : Entries{};
  }
  const auto row =
      std::ranges::find_if(kMCodes, [&](const ProgramMCode& m) { return m.number == *number; });
  return topic.front() == 'M' && row != kMCodes.end()
             ? Entries{{"M code", std::string(row->form), std::string(row->text), {}}}
             : Entries{};
}

Entries parameters(std::string_view topic) {
  Entries found;
  const auto asked = parameter_topic(topic);
  if (!asked) {
    return found;
  }
  for (const ParameterInfo& row : parameter_rows()) {
    const bool is_asked = asked->number >= row.first && asked->number <= row.last;
    if (is_asked && (!asked->bit || asked->bit == row.bit)) {
      found.push_back(entry_of(row));
    }
  }
  return found;
}

Entries words(std::string_view topic, const Profile& profile) {
  Entries found;
  if (const auto function = find_function(topic)) {
    const FunctionInfo& row = info(*function);
    const auto form = kFunctionForms[static_cast<std::size_t>(row.arguments)];
    Entry entry{"function", fmt::format(fmt::runtime(form), row.name), std::string(row.text), {}};
    if (!row.also.empty()) {
      entry.facts.push_back({"also", fmt::format("{}[a]", row.also)});
    }
    if (row.level != FunctionLevel::Basic) {
      entry.facts.push_back({"on this control", row.level <= profile.functions ? "yes"
                                                : row.level == FunctionLevel::Series30i
                                                    ? "no: only on the 30i family"
                                                    : "no"});
    }
    found.push_back(std::move(entry));
  }
  if (const auto output = find_output_statement(topic)) {
    const OutputStatementInfo& row = info(*output);
    found.push_back({"statement", std::string(row.name), std::string(row.text), {}});
  }
  for (const LanguageWord& row : kWords) {
    if (is_spelling_of(topic, row.name)) {
      found.push_back({"statement", std::string(row.form), std::string(row.text), {}});
    }
  }
  return found;
}

Entries variable_names(std::string_view topic) {
  for (const SystemName& row : system_names()) {
    if (topic == row.name || topic == fmt::format("#{}", row.name)) {
      const int count = row.highest - row.lowest;
      Entry entry{"variable name (30i family)", std::string(row.name), std::string(row.text), {}};
      entry.facts.push_back(
          {"stands for", count == 0 ? fmt::format("#{}", row.first)
                                    : fmt::format("#{} to #{}", row.first, row.first + count)});
      entry.facts.push_back({"written", count == 0 ? fmt::format("[#{}]", row.name)
                                                   : fmt::format("[#{}[n]], n = {} to {}", row.name,
                                                                 row.lowest, row.highest)});
      return {entry};
    }
  }
  return {};
}

std::vector<std::string> topic_names() {
  std::vector<std::string> names;
  for (const SystemName& row : system_names()) {
    names.emplace_back(row.name);
  }
  for (const GCode& code : g_codes()) {
    std::string name = to_text(code.number);
    if (names.back() != name) {  // of several sets
      names.push_back(std::move(name));
    }
  }
  for (const ProgramMCode& code : kMCodes) {
    names.push_back(fmt::format("M{:02}", code.number));
  }
  for (const FunctionInfo& row : functions()) {
    names.emplace_back(row.name);
  }
  for (const OutputStatementInfo& row : output_statements()) {
    names.emplace_back(row.name);
  }
  for (const LanguageWord& row : kWords) {
    names.emplace_back(row.name);
  }
  for (const ParameterInfo& row : parameter_rows()) {
    names.push_back(row.bit ? parameter_name(row) : std::to_string(row.first));
  }
  for (const Profile& profile : profiles()) {
    names.emplace_back(profile.name);
  }
  return names;
}

}  // namespace g31::fanuc::reference
