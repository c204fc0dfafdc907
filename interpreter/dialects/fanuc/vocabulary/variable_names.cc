#include "interpreter/dialects/fanuc/vocabulary/variable_names.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "interpreter/dialects/fanuc/vocabulary/variable_ranges.h"
#include "machine/base/letters.h"

namespace g31::fanuc {
namespace {

constexpr auto kSystemNameRows = std::to_array<SystemName>({
#define SYSTEM_NAME(name, first, lowest, highest, text) {name, first, lowest, highest, text},
#include "interpreter/dialects/fanuc/vocabulary/system_names.def"
#undef SYSTEM_NAME
});

/// _WZP1 to _WZP48: work offsets G54.1 P1 to P48, 20 variables each from #7001 on.
std::optional<SystemName> additional_offset(std::string_view name) {
  constexpr std::string_view kPrefix = "_WZP";
  if (!name.starts_with(kPrefix)) {
    return std::nullopt;
  }
  const std::string_view digits = name.substr(kPrefix.size());
  int p = 0;
  const auto end = std::from_chars(digits.data(), digits.data() + digits.size(), p);
  if (end.ec != std::errc() || end.ptr != digits.data() + digits.size() || p < 1 || p > 48) {
    return std::nullopt;
  }
  return SystemName{name, 7001 + 20 * (p - 1), 1, 20, "work offset G54.1 P"};
}

std::optional<SystemName> find_system_name(std::string_view name) {
  const auto row = std::ranges::find(kSystemNameRows, name, &SystemName::name);
  return row != kSystemNameRows.end() ? std::optional(*row) : additional_offset(name);
}

bool is_name_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

}  // namespace

std::span<const SystemName> system_names() {
  return kSystemNameRows;
}

std::string upper_case(std::string_view text) {
  return in_capitals(text);
}

std::optional<std::int32_t> variable_in_name(std::string_view name) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  if (name.size() < 2 || name[0] != '#' || !is_digit(name[1]) || name.back() == '.') {
    return std::nullopt;
  }
  double number = 0.0;
  const auto end =
      std::from_chars(name.data() + 1, name.data() + name.size(), number, std::chars_format::fixed);
  const bool is_read = end.ec == std::errc() && end.ptr == name.data() + name.size();
  const bool is_whole = name.find('.') == std::string_view::npos;
  const std::int32_t variable = written_variable(number);
  constexpr std::int32_t kFirstWithPart = 30'000'000;
  return is_read && (is_whole || variable >= kFirstWithPart) ? std::optional(variable)
                                                             : std::nullopt;
}

bool is_variable_name(std::string_view name) {
  const auto counts = [](char c) {
    return is_name_letter(c) || (c >= '0' && c <= '9') || c == '_';
  };
  return !name.empty() && is_name_letter(name.front()) && std::ranges::all_of(name, counts);
}

Result<std::int32_t, AlarmId> VariableNames::number(const std::string& name,
                                                    runtime::Cell index) const {
  if (const auto row = find_system_name(name)) {
    const bool takes_index = row->highest > 0;
    const double place = std::round(index.or_zero());
    if (takes_index == index.is_vacant() ||
        (takes_index && (place < row->lowest || place > row->highest))) {
      return AlarmId::IllegalNameIndex;
    }
    return takes_index ? row->first + static_cast<std::int32_t>(place) - row->lowest : row->first;
  }
  const auto found = given_.find(name);
  if (found == given_.end()) {
    return AlarmId::UnknownVariableName;
  }
  return index.is_vacant() ? Result<std::int32_t, AlarmId>(found->second)
                           : Result<std::int32_t, AlarmId>(AlarmId::IllegalNameIndex);
}

}  // namespace g31::fanuc
