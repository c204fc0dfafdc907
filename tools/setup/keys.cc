#include "tools/setup/keys.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "machine/base/contract.h"
#include "machine/units/axis_positions.h"
#include "tools/setup/variable_name.h"

namespace g31::setup {
namespace {

constexpr auto kSections = std::to_array<SectionRow>({
#define SETUP_SECTION(id, path, form, name_form, example, text) \
  {SectionId::id, path, SectionForm::form, NameForm::name_form, example, text},
#define SETUP_KEY(id, section, name_form, name, type, limit, unit, default_text, example, text)
#include "tools/setup/keys.def"
#undef SETUP_SECTION
#undef SETUP_KEY
});

constexpr auto kKeys = std::to_array<KeyRow>({
#define SETUP_SECTION(id, path, form, name_form, example, text)
#define SETUP_KEY(id, section, name_form, name, type, limit, unit, default_text, example, text) \
  {KeyId::id, SectionId::section, NameForm::name_form,                                          \
   name,      ValueType::type,    Limit::limit,                                                 \
   unit,      default_text,       example,                                                      \
   text},
#include "tools/setup/keys.def"
#undef SETUP_SECTION
#undef SETUP_KEY
});

constexpr int kLargestNumber = 99999999;

consteval bool no_key_stands_twice() {
  for (std::size_t i = 0; i < kKeys.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (kKeys[i].section == kKeys[j].section && kKeys[i].name == kKeys[j].name) {
        return false;
      }
    }
  }
  return true;
}
static_assert(no_key_stands_twice(), "keys.def: a key of a section has one row");

/// A whole number 0..kLargestNumber written in digits only.
std::optional<int> whole_number_from(std::string_view digits) {
  int number = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, number);
  const bool plain = !digits.empty() && digits.front() != '-' && error == std::errc{};
  return plain && stop == end && number <= kLargestNumber ? std::optional(number) : std::nullopt;
}

std::optional<std::string> normal_axis(std::string_view name) {
  const bool known = name.size() == 1 && axis_index(name.front()) >= 0;
  return known ? std::optional(std::string(name)) : std::nullopt;
}

std::optional<std::string> normal_parameter(std::string_view name) {
  const std::size_t dot = std::min(name.find('.'), name.size());
  const std::optional<int> number = whole_number_from(name.substr(0, dot));
  if (!number || dot == name.size()) {
    return number ? std::optional(std::to_string(*number)) : std::nullopt;
  }
  if (const auto axis = normal_axis(name.substr(dot + 1))) {
    return std::to_string(*number) + "." + *axis;
  }
  const std::optional<int> bit = whole_number_from(name.substr(dot + 1));
  if (!bit || *bit > 7) {
    return std::nullopt;
  }
  return std::to_string(*number) + "." + std::to_string(*bit);
}

std::optional<std::string> normal_macro_call(std::string_view name) {
  if (!name.starts_with('G') && !name.starts_with('M')) {
    return std::nullopt;
  }
  const std::optional<int> number = whole_number_from(name.substr(1));
  return number ? std::optional(name.front() + std::to_string(*number)) : std::nullopt;
}

std::optional<std::string> normal_work_offset(std::string_view name) {
  if (name == "EXT") {
    return "EXT";
  }
  for (const std::string_view prefix : {"G54.1 P", "G154 P"}) {
    if (name.starts_with(prefix)) {
      const std::optional<int> number = whole_number_from(name.substr(prefix.size()));
      return number && *number >= 1 ? std::optional(std::string(prefix) + std::to_string(*number))
                                    : std::nullopt;
    }
  }
  const std::optional<int> code =
      name.starts_with('G') ? whole_number_from(name.substr(1)) : std::optional<int>();
  const bool known = code && ((*code >= 54 && *code <= 59) || (*code >= 505 && *code <= 599));
  return known ? std::optional("G" + std::to_string(*code)) : std::nullopt;
}

bool is_error_name(std::string_view name) {
  return name.size() == 3 && name[0] == 'E' && axis_index(name[1]) >= 0 &&
         axis_index(name[2]) >= 0 && axis_index(name[2]) < 3;
}

bool is_compensation_name(std::string_view name) {
  return is_error_name(name) && axis_index(name[1]) < 3;
}

}  // namespace

std::span<const SectionRow> section_rows() {
  return kSections;
}

std::span<const KeyRow> key_rows() {
  return kKeys;
}

const SectionRow& row_of(SectionId id) {
  return kSections.at(static_cast<std::size_t>(id));
}

const SectionRow* find_section(std::string_view path) {
  const auto row = std::ranges::find(kSections, path, &SectionRow::path);
  return row != kSections.end() ? &*row : nullptr;
}

std::optional<FoundKey> find_key(SectionId section, std::string_view key) {
  std::optional<FoundKey> free;
  for (const KeyRow& row : kKeys) {
    if (row.section != section) {
      continue;
    }
    if (row.name_form != NameForm::Exact) {
      const std::optional<std::string> name = normal_name(row.name_form, key);
      free = name ? std::optional(FoundKey{&row, *name}) : free;
    } else if (row.name == key) {
      return FoundKey{&row, std::string(key)};
    }
  }
  return free;
}

std::optional<std::string> normal_name(NameForm form, std::string_view name) {
  switch (form) {
    case NameForm::Exact:
      return std::nullopt;
    case NameForm::AxisLetter:
      return normal_axis(name);
    case NameForm::AnyAxisLetter:
      return is_further_axis(name) ? std::optional(std::string(name)) : normal_axis(name);
    case NameForm::ParameterNumber:
      return normal_parameter(name);
    case NameForm::MacroCallCode:
      return normal_macro_call(name);
    case NameForm::VariableName:
      return normal_variable_name(name);
    case NameForm::WorkOffset:
      return normal_work_offset(name);
    case NameForm::ToolNumber: {
      const std::optional<int> number = whole_number_from(name);
      return number ? std::optional(std::to_string(*number)) : std::nullopt;
    }
    case NameForm::SizeName:
      return std::string(name);
    case NameForm::RotaryLetter: {
      const std::optional<std::string> axis = normal_axis(name);
      return axis && is_rotary_axis(axis_index(axis->front())) ? axis : std::nullopt;
    }
    case NameForm::ErrorName:
      return is_error_name(name) ? std::optional(std::string(name)) : std::nullopt;
    case NameForm::CompensationName:
      return is_compensation_name(name) ? std::optional(std::string(name)) : std::nullopt;
  }
  contract_violated("every NameForm has a rule", __FILE__, __LINE__);
}

std::vector<std::string_view> inner_sections(SectionId section) {
  const std::string prefix = std::string(row_of(section).path) + ".";
  std::vector<std::string_view> names;
  for (const SectionRow& row : kSections) {
    if (row.path.starts_with(prefix)) {
      names.push_back(row.path.substr(prefix.size()));
    }
  }
  return names;
}

std::vector<std::string_view> known_keys(SectionId section) {
  std::vector<std::string_view> names = inner_sections(section);
  for (const KeyRow& row : kKeys) {
    if (row.section != section) {
      continue;
    }
    if (row.name_form == NameForm::Exact) {
      names.push_back(row.name);
    } else {
      const std::vector<std::string_view> more = known_names(row.name_form);
      names.insert(names.end(), more.begin(), more.end());
    }
  }
  return names;
}

std::vector<std::string_view> known_names(NameForm form) {
  switch (form) {
    case NameForm::AxisLetter:
      return {"X", "Y", "Z", "A", "B", "C"};
    case NameForm::AnyAxisLetter:
      return {"X", "Y", "Z", "A", "B", "C", "U", "V", "W"};
    case NameForm::RotaryLetter:
      return {"A", "B", "C"};
    case NameForm::WorkOffset:
      return {"G54", "G55", "G56", "G57", "G58", "G59", "EXT", "G54.1 P1"};
    case NameForm::Exact:
    case NameForm::ParameterNumber:
    case NameForm::MacroCallCode:
    case NameForm::VariableName:
    case NameForm::ToolNumber:
    case NameForm::SizeName:
      return {};
    case NameForm::ErrorName:
      return {"EXX", "EYX", "EZX", "EAX", "EBX", "ECX", "EXY", "EYY", "EZY",
              "EAY", "EBY", "ECY", "EXZ", "EYZ", "EZZ", "EAZ", "EBZ", "ECZ"};
    case NameForm::CompensationName:
      return {"EXX", "EYX", "EZX", "EXY", "EYY", "EZY", "EXZ", "EYZ", "EZZ"};
  }
  contract_violated("every NameForm is listed", __FILE__, __LINE__);
}

std::string_view rule_of(NameForm form) {
  switch (form) {
    case NameForm::AxisLetter:
      return "X, Y, Z, A, B and C";
    case NameForm::AnyAxisLetter:
      return "X, Y, Z, A, B, C, U, V and W";
    case NameForm::RotaryLetter:
      return "A, B and C";
    case NameForm::WorkOffset:
      return "G54 to G59, EXT, \"G54.1 Pn\", \"G154 Pn\" and G505 to G599";
    case NameForm::ToolNumber:
      return "whole numbers 0 to 99999999";
    case NameForm::Exact:
    case NameForm::ParameterNumber:
    case NameForm::MacroCallCode:
    case NameForm::VariableName:
    case NameForm::SizeName:
    case NameForm::ErrorName:
    case NameForm::CompensationName:
      return "";
  }
  contract_violated("every NameForm is listed", __FILE__, __LINE__);
}

}  // namespace g31::setup
